"""Stream the chunks of a dataset into its file."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from pathlib import Path

    from planar_pushing.study.describe import of_study
    from planar_pushing.study.grids.streaming import COPIED, stream_dataset
    from planar_pushing.study.storage.chunk_files import open_chunks

    name, whole = snakemake.wildcards.dataset, snakemake.params.whole
    log.info("gathering %d chunks of %s", len(snakemake.input), name)
    chunks = open_chunks(Path(snakemake.input[0]).parent, whole["lengths"], whole["steps"])
    marked = of_study(chunks, name, snakemake.params.provenance)
    stream_dataset(
        lambda part: marked.isel(part).load(),
        whole["lengths"],
        snakemake.output[0],
        most=COPIED,
        threads=snakemake.threads,
    )
