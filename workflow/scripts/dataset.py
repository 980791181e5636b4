"""Build one dataset from its slice of the study."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.study.builders import build_dataset
    from planar_pushing.study.store import write_dataset

    log.info("building %s", snakemake.wildcards.dataset)
    built = build_dataset(snakemake.wildcards.dataset, snakemake.params.study)
    write_dataset(built, snakemake.output[0])
