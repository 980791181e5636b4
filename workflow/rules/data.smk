# The datasets, one job each, or a job for each chunk of a large one: a grid is vectorised inside its job.
rule data:
    input:
        expand("<results>/data/{dataset}.nc", dataset=COMPUTED),


rule dataset:
    input:
        scenes=scene_files,
    output:
        "<results>/data/{dataset}.nc",
    log:
        "<results>/logs/data/{dataset}.log",
    benchmark:
        "<results>/benchmarks/data/{dataset}.tsv"
    wildcard_constraints:
        dataset=one_of(WHOLE_DATASETS),
    priority: FIRST
    threads: job_threads
    resources:
        mem_mb=job_memory,
        runtime=job_minutes,
    params:
        # Not of study.builders, which imports the builders of the other datasets too.
        code=lambda wildcards: code_of(
            f"study.datasets.{wildcards.dataset}",
            "study.slices",
            "study.grids.streaming",
        ),
        study=job_slice,
        provenance=PROVENANCE,
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/dataset.py"


# A chunk does not know its study, so that it stays when the study changes elsewhere.
rule chunk:
    output:
        "<results>/chunks/{dataset}/{chunk}.nc",
    log:
        "<results>/logs/chunks/{dataset}/{chunk}.log",
    benchmark:
        "<results>/benchmarks/chunks/{dataset}/{chunk}.tsv"
    wildcard_constraints:
        dataset=one_of(CHUNKED),
    priority: FIRST
    threads: job_threads
    resources:
        mem_mb=job_memory,
        runtime=job_minutes,
    params:
        code=rules.dataset.params.code,
        study=job_slice,
    message:
        "Computing {wildcards.chunk} of {wildcards.dataset}"
    script:
        "../scripts/chunk.py"


rule gather:
    input:
        chunk_files,
    output:
        "<results>/data/{dataset}.nc",
    log:
        "<results>/logs/data/{dataset}.log",
    benchmark:
        "<results>/benchmarks/data/{dataset}.tsv"
    wildcard_constraints:
        dataset=one_of(GATHERED),
    priority: FIRST
    threads: job_threads
    resources:
        mem_mb=job_memory,
        runtime=job_minutes,
    params:
        code=code_of(
            "study.storage.chunk_files", "study.grids.streaming", "study.describe"
        ),
        whole=gathering,
        provenance=PROVENANCE,
    message:
        "Gathering the chunks of {wildcards.dataset}"
    script:
        "../scripts/gather.py"


# What stands for a dataset that stays in its chunks.
rule index:
    input:
        chunk_files,
    output:
        "<results>/data/{dataset}.nc",
    log:
        "<results>/logs/data/{dataset}.log",
    wildcard_constraints:
        dataset=one_of([name for name in CHUNKED if name not in GATHERED]),
    priority: FIRST
    params:
        code=code_of(
            "study.storage.chunk_files", "study.grids.streaming", "study.describe"
        ),
        whole=gathering,
        provenance=PROVENANCE,
    message:
        "Listing the chunks of {wildcards.dataset}"
    script:
        "../scripts/index.py"
