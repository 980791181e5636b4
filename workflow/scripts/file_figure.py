"""Draw one figure from the file of one dataset."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from pathlib import Path

    from planar_pushing.figures.render import render_file

    name = Path(snakemake.output.svg).stem
    log.info("drawing %s", name)
    render_file(name, snakemake.input.data, list(snakemake.output))
