"""Build one dataset from its slice of the study, block by block."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.study.builders import build_dataset
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.grids.streaming import COMPUTED, stream_dataset
    from planar_pushing.study.storage.parts import cut, sizes

    name, values = snakemake.wildcards.dataset, snakemake.params.study
    log.info("building %s", name)

    def block(part):
        """The dataset in a part of its grid."""
        built = build_dataset(name, cut(values, part))
        return of_study(built, name, snakemake.params.provenance)

    stream_dataset(
        block, sizes(name, values), snakemake.output[0], most=COMPUTED, threads=snakemake.threads
    )
