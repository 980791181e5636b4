"""Set the report as a PDF."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.report.typeset import typeset

    typeset(snakemake.input.source, ".", snakemake.output[0], snakemake.params.results)
