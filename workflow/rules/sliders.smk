# The study of sliders: its datasets, logs of motion over time and figures, in a folder of its own, and the
# check of every value in its equation or computed anew, and of the golden sample.
rule sliders:
    input:
        expand("<sliders>/data/{dataset}.nc", dataset=SLIDERS),
        expand(
            "<sliders>/data/simulations/{simulation}.nc",
            simulation=GALLERY.simulations,
        ),
        expand("<sliders>/figures/data/{figure}.nc", figure=SHOWN),
        expand("<sliders>/figures/{figure}.{kind}", figure=SHOWN, kind=KINDS),


rule sliders_dataset:
    output:
        path="<sliders>/data/{dataset}.nc",
    log:
        "<sliders>/logs/data/{dataset}.log",
    benchmark:
        "<sliders>/benchmarks/data/{dataset}.tsv"
    wildcard_constraints:
        dataset=one_of(SLIDERS),
    priority: FIRST
    params:
        call="study.running.builds:dataset",
        code=dataset_code,
        name="{dataset}",
        study=lambda wildcards: study_slice(GALLERY, wildcards.dataset),
        marks=marks_of(GALLERY_FILE),
    message:
        "Computing {wildcards.dataset}"
    script:
        "../scripts/run.py"


rule sliders_simulation:
    output:
        path="<sliders>/data/simulations/{simulation}.nc",
    log:
        "<sliders>/logs/data/simulation_{simulation}.log",
    benchmark:
        "<sliders>/benchmarks/data/simulation_{simulation}.tsv"
    priority: FIRST
    params:
        call="study.running.builds:simulation",
        code=code_of("simulation"),
        name="{simulation}",
        scene=lambda wildcards: GALLERY.simulations[wildcards.simulation],
        marks=marks_of(GALLERY_FILE),
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/run.py"


rule sliders_figure:
    input:
        gallery_files,
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
        figure=one_of(SHOWN),
    priority: FIRST
    params:
        call="figures.jobs:figure",
        code=figure_code(GALLERY_FIGURES),
        name="{figure}",
        settings=GALLERY.slider.model_dump(),
        results=lambda wildcards: folder_of(GALLERY_FILE),
        marks=marks_of(GALLERY_FILE),
        caption=lambda wildcards: GALLERY_FIGURES[wildcards.figure].caption,
        promise=lambda wildcards: GALLERY_FIGURES[wildcards.figure].promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


rule sliders_golden:
    input:
        (
            expand("<sliders>/tables/golden_verdict.{kind}", kind=["txt", "json"])
            if GALLERY.golden
            else []
        ),


rule sliders_verdict:
    input:
        expand("<sliders>/data/{dataset}.nc", dataset=SLIDERS),
        expand(
            "<sliders>/data/simulations/{simulation}.nc",
            simulation=GALLERY.simulations,
        ),
        expand("<sliders>/figures/data/{figure}.nc", figure=SHOWN),
        golden_files(GALLERY),
    output:
        data="<sliders>/tables/golden_verdict.json",
        text=report(
            "<sliders>/tables/golden_verdict.txt",
            category="Golden check",
            caption="../report/golden.rst",
        ),
    log:
        "<sliders>/logs/golden/golden_verdict.log",
    benchmark:
        "<sliders>/benchmarks/golden/golden_verdict.tsv"
    priority: FIRST
    params:
        call="evidence.jobs:golden",
        code=[golden_code(SLIDERS, GALLERY_FIGURES, SHOWN), whole_digest(GALLERY)],
        study=GALLERY_FILE,
        results=lambda wildcards: folder_of(GALLERY_FILE),
    message:
        "Checking every value of the sliders' results"
    script:
        "../scripts/run.py"
