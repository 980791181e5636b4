"""Build the manual as HTML."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.report.manual import build_manual

    build_manual("paper/manual", snakemake.output[0])
