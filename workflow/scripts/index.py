"""Write what stands for a dataset that stays in its chunks."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from pathlib import Path

    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.chunk_files import index_of, open_chunks
    from planar_pushing.study.storage.store import write_dataset

    name, whole = snakemake.wildcards.dataset, snakemake.params.whole
    log.info("listing %d chunks of %s", len(snakemake.input), name)
    chunks = open_chunks(Path(snakemake.input[0]).parent, whole["lengths"], whole["steps"])
    index = of_study(index_of(chunks, whole["steps"]), name, snakemake.params.provenance)
    write_dataset(index, snakemake.output[0])
