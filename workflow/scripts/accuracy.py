"""Measure what accuracy costs, in this one process."""

from planar_pushing.accuracy.tables import measured
from planar_pushing.study.jobs import job_log
from planar_pushing.study.store import write_dataset

with job_log(snakemake.log[0]):
    write_dataset(measured(), snakemake.output[0])
