"""Measure the hard cases against their references."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.evidence.hard_cases.dataset import build
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.store import write_dataset

    log.info("measuring the hard cases")
    found = of_study(build(), "hard_cases", snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
