# The figures: first the numbers that each plots, then the picture in three formats, from them alone.
rule figures:
    input:
        expand("<results>/figures/data/{figure}.nc", figure=DRAWN),
        expand("<results>/figures/{figure}.{kind}", figure=DRAWN, kind=KINDS),


rule figure:
    input:
        dataset_files,
    output:
        data="<results>/figures/data/{figure}.nc",
        svg=report(
            "<results>/figures/{figure}.svg",
            category=lambda wildcards: FIGURES[wildcards.figure].section,
            caption="../report/figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="<results>/figures/{figure}.pdf",
        png="<results>/figures/{figure}.png",
    log:
        "<results>/logs/figures/{figure}.log",
    benchmark:
        "<results>/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure=one_of(DRAWN),
    priority: FIRST
    params:
        call="figures.jobs:figure",
        code=figure_code(FIGURES),
        name="{figure}",
        settings=figure_settings,
        results=lambda wildcards: RESULTS,
        marks=marks_of(STUDY_FILE),
        caption=lambda wildcards: FIGURES[wildcards.figure].caption,
        promise=lambda wildcards: FIGURES[wildcards.figure].promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


# Figures of one dataset on how this work computes.
rule file_figure:
    input:
        source=lambda wildcards: f"<results>/data/{EVIDENCE_FIGURES[wildcards.figure].datasets[0].partition('/')[0]}.nc",
    output:
        svg=report(
            "<results>/figures/{figure}.svg",
            category="Accuracy, hard cases and effects",
            caption="../report/file_figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="<results>/figures/{figure}.pdf",
        png="<results>/figures/{figure}.png",
    log:
        "<results>/logs/figures/{figure}.log",
    benchmark:
        "<results>/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure=one_of(EVIDENCE_FIGURES),
    params:
        call="figures.jobs:file_figure",
        code=figure_code(EVIDENCE_FIGURES),
        name="{figure}",
        caption=lambda wildcards: EVIDENCE_FIGURES[wildcards.figure].caption,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"
