"""Errors and evaluation counts of every method: no times, so the same on every run."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.evidence.costs.tables import cone_errors, wrench_errors
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.store import write_dataset

    found = {"wrench": wrench_errors(), "cone": cone_errors()}
    found = of_study(found, "accuracy_errors", snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
