"""Draw one figure from the datasets."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from types import SimpleNamespace

    from planar_pushing.figures.render import render

    log.info("drawing %s", snakemake.wildcards.figure)
    settings = SimpleNamespace(**snakemake.params.settings)
    files = dict(snakemake.output.items())
    marks = snakemake.params.provenance
    render(snakemake.wildcards.figure, snakemake.params.results, settings, marks=marks, **files)
