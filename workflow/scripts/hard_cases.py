"""Measure the hard cases against their references."""

from planar_pushing.hard_cases.dataset import build
from planar_pushing.study.jobs import job_log
from planar_pushing.study.store import write_dataset

with job_log(snakemake.log[0]) as log:
    log.info("measuring the hard cases")
    write_dataset(build(), snakemake.output[0])
