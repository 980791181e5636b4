"""Draw the hard cases from their dataset."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.figures.evidence.hard_cases import render

    log.info("drawing the hard cases")
    render(snakemake.input.data, list(snakemake.output))
