"""Build one dataset from its slice of the study."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.study.builders import build_dataset
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.store import write_dataset

    name = snakemake.wildcards.dataset
    log.info("building %s", name)
    built = build_dataset(name, snakemake.params.study)
    write_dataset(of_study(built, name, snakemake.params.provenance), snakemake.output[0])
