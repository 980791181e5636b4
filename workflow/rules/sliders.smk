# The study of sliders: its datasets, logs of motion over time and figures, in a folder of its own.
rule sliders:
    input:
        expand("<sliders>/data/{dataset}.nc", dataset=SLIDERS),
        expand(
            "<sliders>/data/simulations/{simulation}.nc",
            simulation=GALLERY.simulations,
        ),
        expand("<sliders>/figures/data/{figure}.nc", figure=SHOWN),
        expand(
            "<sliders>/figures/{figure}.{kind}",
            figure=SHOWN,
            kind=["svg", "pdf", "png"],
        ),


rule sliders_dataset:
    output:
        "<sliders>/data/{dataset}.nc",
    log:
        "<sliders>/logs/data/{dataset}.log",
    benchmark:
        "<sliders>/benchmarks/data/{dataset}.tsv"
    wildcard_constraints:
        dataset="|".join(SLIDERS),
    priority: FIRST
    params:
        code=lambda wildcards: code_of(
            f"study.datasets.sliders.{wildcards.dataset}",
            "study.slices",
            "study.storage.store",
        ),
        study=lambda wildcards: study_slice(GALLERY, wildcards.dataset),
        provenance=MARKS[GALLERY_FILE],
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/dataset.py"


rule sliders_simulation:
    input:
        scene=lambda wildcards: GALLERY.simulations[wildcards.simulation],
    output:
        "<sliders>/data/simulations/{simulation}.nc",
    log:
        "<sliders>/logs/data/simulation_{simulation}.log",
    benchmark:
        "<sliders>/benchmarks/data/simulation_{simulation}.tsv"
    priority: FIRST
    params:
        code=code_of("study.simulations", "study.storage.store", "study.describe"),
        provenance=MARKS[GALLERY_FILE],
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/simulation.py"


rule sliders_figure:
    input:
        data=gallery_files,
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        data="<sliders>/figures/data/{figure}.nc",
        svg=report(
            "<sliders>/figures/{figure}.svg",
            category=lambda wildcards: GALLERY_FIGURES[wildcards.figure].section,
            caption="../report/figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="<sliders>/figures/{figure}.pdf",
        png="<sliders>/figures/{figure}.png",
    log:
        "<sliders>/logs/figures/{figure}.log",
    benchmark:
        "<sliders>/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure="|".join(SHOWN),
    params:
        code=lambda wildcards: code_of(*GALLERY_FIGURES[wildcards.figure].modules),
        settings=GALLERY.slider.model_dump(),
        results=lambda wildcards: folder_of(GALLERY_FILE),
        provenance=MARKS[GALLERY_FILE],
        caption=lambda wildcards: GALLERY_FIGURES[wildcards.figure].caption,
        promise=lambda wildcards: GALLERY_FIGURES[wildcards.figure].promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/figure.py"
