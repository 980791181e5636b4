"""Draw one simulation from its log."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.figures.motion.simulation import render

    log.info("drawing %s", snakemake.wildcards.simulation)
    render(snakemake.input.data, list(snakemake.output))
