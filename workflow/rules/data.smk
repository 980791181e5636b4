# Datasets: one job each, or a job for each chunk of a large dataset; a grid is vectorized within its job.
# Simulation logs: one for each scene file that a study simulates.
rule data:
    input:
        over("{results}/data/{name}.nc", computed),
        over(
            "{results}/data/simulations/{name}.nc",
            lambda folder: STUDIES[folder].simulations,
        ),


rule dataset:
    input:
        unpack(chunk_files),
    output:
        path="{results}/data/{dataset}.nc",
    log:
        "{results}/logs/data/{dataset}.log",
    benchmark:
        "{results}/benchmarks/data/{dataset}.tsv"
    wildcard_constraints:
        dataset=one_of(DATASETS),
    threads: job_threads
    resources:
        mem_mb=chunks.MEMORY,
        runtime=job_minutes,
    params:
        call=job_call,
        code=dataset_code,
        name="{dataset}",
        values=job_values,
        marks=marks_of,
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/run.py"


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
        "../scripts/run.py"


# The marks include the content of the scene file. The file is not an input, since its layout does not matter.
rule simulation:
    output:
        path="{results}/data/simulations/{simulation}.nc",
    log:
        "{results}/logs/data/simulation_{simulation}.log",
    benchmark:
        "{results}/benchmarks/data/simulation_{simulation}.tsv"
    params:
        call="study.running.simulations:simulation",
        code=code_of("study.running.simulations"),
        name="{simulation}",
        scene=lambda wildcards: study_of(wildcards).simulations[wildcards.simulation],
        marks=marks_of,
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/run.py"
