# The datasets, one job each, or a job for each chunk of a large one: a grid is vectorised inside its job.
rule data:
    input:
        expand("<results>/data/{dataset}.nc", dataset=COMPUTED),


rule dataset:
    output:
        path="<results>/data/{dataset}.nc",
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
        call="study.running.builds:dataset",
        code=dataset_code,
        name="{dataset}",
        study=job_slice,
        marks=marks_of(STUDY_FILE),
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/run.py"


# A chunk does not know its study, so that it stays when the study changes elsewhere.
rule chunk:
    output:
        path="<results>/chunks/{dataset}/{chunk}.nc",
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
        call="study.running.builds:chunk",
        code=dataset_code,
        name="{dataset}",
        study=job_slice,
    message:
        "Computing {wildcards.chunk} of {wildcards.dataset}"
    script:
        "../scripts/run.py"


rule gather:
    input:
        chunks=chunk_files,
    output:
        path="<results>/data/{dataset}.nc",
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
        call="study.running.builds:gather",
        code=dataset_code,
        name="{dataset}",
        whole=gathering,
        marks=marks_of(STUDY_FILE),
    message:
        "Gathering the chunks of {wildcards.dataset}"
    script:
        "../scripts/run.py"


# The index of a dataset that stays in its chunks.
rule index:
    input:
        chunks=chunk_files,
    output:
        path="<results>/data/{dataset}.nc",
    log:
        "<results>/logs/data/{dataset}.log",
    wildcard_constraints:
        dataset=one_of([name for name in CHUNKED if name not in GATHERED]),
    priority: FIRST
    params:
        call="study.running.builds:index",
        code=dataset_code,
        name="{dataset}",
        whole=gathering,
        marks=marks_of(STUDY_FILE),
    message:
        "Listing the chunks of {wildcards.dataset}"
    script:
        "../scripts/run.py"
