# How a dataset is computed: by one job, or by a job for each chunk of a large grid and one that combines them.
# A grid is vectorized within its job.


# The rules of the datasets inherit all but the output, which here matches nothing.
rule dataset:
    input:
        unpack(chunk_files),
    output:
        path="{results}/data/{dataset,(?!)}.nc",
    log:
        "{results}/logs/data/{dataset}.log",
    benchmark:
        "{results}/benchmarks/data/{dataset}.tsv"
    priority: AWAITED
    threads: job_threads
    resources:
        mem_mb=chunks.MEMORY,
        runtime=job_minutes,
    params:
        call=dataset_call,
        code=dataset_code,
        name="{dataset}",
        values=dataset_values,
        marks=marks("{dataset}"),
    message:
        "Computing {wildcards.dataset}"
    script:
        RUN


# A chunk does not name its study, so that it stays valid when the study changes elsewhere.
rule chunk:
    output:
        path="{results}/chunks/{dataset}/{chunk}.nc",
    log:
        "{results}/logs/chunks/{dataset}/{chunk}.log",
    benchmark:
        "{results}/benchmarks/chunks/{dataset}/{chunk}.tsv"
    wildcard_constraints:
        dataset=one_of(DATASETS),
    threads: job_threads
    resources:
        mem_mb=chunks.MEMORY,
        runtime=job_minutes,
    params:
        call="study.running.build:dataset",
        code=dataset_code,
        name="{dataset}",
        study=job_slice,
        threads=lambda wildcards, threads: threads,
    message:
        "Computing {wildcards.chunk} of {wildcards.dataset}"
    script:
        RUN
