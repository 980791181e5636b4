# What accuracy costs: measured on this machine, so outside of `all` and of the golden check.
ACCURACY = ["accuracy_wrench", "accuracy_cone", "accuracy_study"]


rule accuracy:
    input:
        "results/data/accuracy.nc",
        expand(
            "results/figures/{figure}.{kind}",
            figure=ACCURACY,
            kind=["svg", "pdf", "png"],
        ),


rule accuracy_data:
    input:
        modules=modules("accuracy.tables", "study.store"),
    output:
        "results/data/accuracy.nc",
    log:
        "results/logs/accuracy/accuracy.log",
    # Nothing else may run beside a measurement.
    threads: workflow.cores
    message:
        "Measuring what accuracy costs"
    script:
        "../scripts/accuracy.py"


rule accuracy_figure:
    input:
        data="results/data/accuracy.nc",
        modules=lambda wildcards: modules(
            f"figures.{wildcards.figure}", "figures.accuracy"
        ),
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg="results/figures/{figure}.svg",
        pdf="results/figures/{figure}.pdf",
        png="results/figures/{figure}.png",
    log:
        "results/logs/figures/{figure}.log",
    wildcard_constraints:
        figure="|".join(ACCURACY),
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/accuracy_figure.py"
