# The figures: first the numbers that each plots, then the picture in three formats, from them alone.
rule figures:
    input:
        over("{results}/figures/data/{name}.nc", drawn),
        over("{results}/figures/{name}.{kind}", drawn),
        over(
            "{results}/figures/simulation_{name}.{kind}",
            lambda folder: (
                STUDIES[folder].simulations if STUDIES[folder].scenes else []
            ),
        ),


rule figure:
    input:
        figure_files,
    output:
        data="{results}/figures/data/{figure}.nc",
        svg=report(
            "{results}/figures/{figure}.svg",
            category=lambda wildcards: DRAWN[wildcards.figure].section,
            caption="../report/figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="{results}/figures/{figure}.pdf",
        png="{results}/figures/{figure}.png",
    log:
        "{results}/logs/figures/{figure}.log",
    benchmark:
        "{results}/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure=one_of(DRAWN),
    params:
        call="figures.jobs:figure",
        code=figure_code,
        name="{figure}",
        settings=figure_settings,
        results="{results}",
        marks=marks_of,
        caption=lambda wildcards: DRAWN[wildcards.figure].caption,
        promise=lambda wildcards: DRAWN[wildcards.figure].promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


# Figures of one dataset on how this work computes.
rule file_figure:
    input:
        source=lambda wildcards: figure_files(wildcards)[0],
    output:
        svg=report(
            "{results}/figures/{figure}.svg",
            category="Accuracy, hard cases and effects",
            caption="../report/file_figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="{results}/figures/{figure}.pdf",
        png="{results}/figures/{figure}.png",
    log:
        "{results}/logs/figures/{figure}.log",
    benchmark:
        "{results}/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure=one_of(EVIDENCE_FIGURES),
    params:
        call="figures.jobs:file_figure",
        code=figure_code,
        name="{figure}",
        caption=lambda wildcards: ALL[wildcards.figure].caption,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


rule simulation_figure:
    input:
        source="{results}/data/simulations/{simulation}.nc",
    output:
        svg=report(
            "{results}/figures/simulation_{simulation}.svg",
            category="Motion over time",
            caption="../report/simulation.rst",
            labels={"figure": "{simulation}"},
        ),
        pdf="{results}/figures/simulation_{simulation}.pdf",
        png="{results}/figures/simulation_{simulation}.png",
    log:
        "{results}/logs/figures/simulation_{simulation}.log",
    benchmark:
        "{results}/benchmarks/figures/simulation_{simulation}.tsv"
    params:
        call="figures.jobs:simulation_figure",
        code=code_of("figure"),
    message:
        "Drawing the simulation {wildcards.simulation}"
    script:
        "../scripts/run.py"
