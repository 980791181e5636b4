"""Measure what accuracy costs, in this one process."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.evidence.costs.measurements import measured
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.store import write_dataset

    found = of_study(measured(), "accuracy", snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
