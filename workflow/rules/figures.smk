# Figures: first the numbers that each plots, then the picture in three formats, drawn only from them.
rule figures:
    input:
        over("{results}/figures/data/{name}.nc", drawn),
        over("{results}/figures/{name}.{kind}", drawn),
        over("{results}/figures/{name}_column.{kind}", columns),
        over("{results}/figures/simulation_{name}.{kind}", undrawn),


rule figure:
    input:
        figure_files,
    output:
        data="{results}/figures/data/{figure}.nc",
        svg=report(
            "{results}/figures/{figure}.svg",
            category=lambda wildcards: entry(wildcards.figure).section,
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
        call="figures.render:figure",
        code=figure_code,
        name="{figure}",
        settings=figure_settings,
        results="{results}",
        marks=marks_of,
        title=lambda wildcards: entry(wildcards.figure).title,
        promise=lambda wildcards: entry(wildcards.figure).promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


# Single-column variant of a full-width figure.
rule column_figure:
    input:
        source="{results}/figures/data/{figure}.nc",
    output:
        svg="{results}/figures/{figure}_column.svg",
        pdf="{results}/figures/{figure}_column.pdf",
        png="{results}/figures/{figure}_column.png",
    log:
        "{results}/logs/figures/{figure}_column.log",
    wildcard_constraints:
        figure=one_of(DRAWN),
    params:
        call="figures.render:file_figure",
        code=figure_code,
        name="{figure}",
        variant="_column",
    message:
        "Drawing {wildcards.figure} for one column"
    script:
        "../scripts/run.py"


# Figures about the computation itself.
rule evidence_figure:
    input:
        figure_files,
    output:
        svg=report(
            "{results}/figures/{figure}.svg",
            category="What accuracy costs",
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
        call="figures.render:evidence_figure",
        code=figure_code,
        name="{figure}",
        results="{results}",
        title=lambda wildcards: entry(wildcards.figure).title,
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
        call="figures.render:simulation_figure",
        code=code_of("figures.render"),
    message:
        "Drawing the simulation {wildcards.simulation}"
    script:
        "../scripts/run.py"
