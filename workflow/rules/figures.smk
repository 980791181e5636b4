# The figures: first the numbers that each plots, then the picture in three formats, from them alone.
rule figures:
    input:
        expand("<results>/figures/data/{figure}.nc", figure=DRAWN),
        expand(
            "<results>/figures/{figure}.{kind}",
            figure=DRAWN,
            kind=["svg", "pdf", "png"],
        ),


rule figure:
    input:
        data=dataset_files,
        style="src/planar_pushing/figures/paper.mplstyle",
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
        figure="|".join(DRAWN),
    priority: FIRST
    params:
        code=lambda wildcards: code_of(*FIGURES[wildcards.figure].modules),
        settings=figure_settings,
        results=lambda wildcards: RESULTS,
        provenance=PROVENANCE,
        caption=lambda wildcards: FIGURES[wildcards.figure].caption,
        promise=lambda wildcards: FIGURES[wildcards.figure].promise,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/figure.py"
