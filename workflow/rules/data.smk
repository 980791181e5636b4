# The datasets, one job each: a grid is vectorised inside its job.
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
        dataset="|".join(COMPUTED),
    priority: FIRST
    params:
        # Not of study.builders, which imports the builders of the other datasets too.
        code=lambda wildcards: code_of(
            f"study.datasets.{wildcards.dataset}", "study.slices", "study.store"
        ),
        study=lambda wildcards: study_slice(STUDY, wildcards.dataset),
        provenance=PROVENANCE,
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/dataset.py"
