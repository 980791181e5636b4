# The datasets, one job each, or a job for each chunk of a large one: a grid is vectorized inside its job.
# Logs of motion over time: one for each scene file that a study simulates.
rule data:
    input:
        over("{results}/data/{name}.nc", computed),
        over(
            "{results}/data/simulations/{name}.nc",
            lambda folder: STUDIES[folder].simulations,
        ),


def chunked(wildcards):
    """The chunks of a dataset by name, none of one that is built in one piece."""
    study = study_of(wildcards)
    return (
        chunks.chunk_parts(study, wildcards.dataset)
        if wildcards.dataset in study.chunks
        else {}
    )


def job_slice(wildcards):
    """The values of the study from which a dataset or a chunk is computed."""
    study, name = study_of(wildcards), wildcards.dataset
    part = chunked(wildcards).get(wildcards.get("chunk"), {})
    return chunks.chunk_slice(study, name, part)


def job_points(wildcards):
    if wildcards.dataset == "scenes":
        return 0
    return points(wildcards.dataset, job_slice(wildcards))


def job_threads(wildcards):
    return chunks.threads(job_points(wildcards))


def job_minutes(wildcards):
    return chunks.minutes(job_points(wildcards))


def chunk_files(wildcards):
    """Chunks from which a dataset is gathered."""
    folder = f"{wildcards.results}/chunks/{wildcards.dataset}"
    files = [f"{folder}/{chunk}.nc" for chunk in chunked(wildcards)]
    return {"chunks": files} if files else {}


def job_call(wildcards):
    """The function that builds a dataset, gathers its chunks, or lists them."""
    if not chunked(wildcards):
        return "study.build:dataset"
    gathers = study_of(wildcards).gather.get(wildcards.dataset, True)
    return f"study.build:{'gather' if gathers else 'index'}"


def job_values(wildcards, threads):
    """The keywords of that function."""
    study, name = study_of(wildcards), wildcards.dataset
    if not chunked(wildcards):
        return {"study": study_slice(study, name), "threads": threads}
    lengths, steps = (
        sizes(name, study_slice(study, name)),
        chunks.chunk_steps(study, name),
    )
    return {"whole": {"lengths": lengths, "steps": steps}}


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
        code=lambda wildcards: code_of("dataset", builder(wildcards.dataset)),
        name="{dataset}",
        values=job_values,
        marks=marks_of,
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/run.py"


# A chunk does not know its study, so that it stays when the study changes elsewhere.
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
        call="study.build:dataset",
        code=lambda wildcards: code_of("dataset", builder(wildcards.dataset)),
        name="{dataset}",
        study=job_slice,
        threads=lambda wildcards, threads: threads,
    message:
        "Computing {wildcards.chunk} of {wildcards.dataset}"
    script:
        "../scripts/run.py"


# The content of the scene file is among the marks; its layout reruns nothing, so it is no input.
rule simulation:
    output:
        path="{results}/data/simulations/{simulation}.nc",
    log:
        "{results}/logs/data/simulation_{simulation}.log",
    benchmark:
        "{results}/benchmarks/data/simulation_{simulation}.tsv"
    params:
        call="study.build:simulation",
        code=code_of("simulation"),
        name="{simulation}",
        scene=lambda wildcards: study_of(wildcards).simulations[wildcards.simulation],
        marks=marks_of,
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/run.py"
