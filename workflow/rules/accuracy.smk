# What accuracy and each effect cost. Errors and counts are a part of `all`; times are measured on this
# machine, by `snakemake accuracy`, outside of `all` and of the golden check.
ACCURACY = [name for name, figure in SUPPLEMENT.items() if figure.groups("accuracy")]


#: Like the report, built with the study that the golden data certify.
COUNTS = (
    [
        *expand("<results>/data/{name}.nc", name=["accuracy_errors", "evaluations"]),
        *expand(
            "<results>/figures/accuracy_evaluations.{kind}", kind=["svg", "pdf", "png"]
        ),
    ]
    if STUDY.golden
    else []
)


rule counts:
    input:
        COUNTS,


rule accuracy_errors:
    output:
        "<results>/data/accuracy_errors.nc",
    log:
        "<results>/logs/accuracy/accuracy_errors.log",
    benchmark:
        "<results>/benchmarks/accuracy/accuracy_errors.tsv"
    params:
        code=code_of("evidence.costs.tables", "study.storage.store", "study.describe"),
        provenance=PROVENANCE,
    message:
        "Computing the errors of every method"
    script:
        "../scripts/accuracy_errors.py"


rule evaluations:
    input:
        study=STUDY_FILE,
        scenes=[push.file for push in STUDY.scenes.values()],
    output:
        "<results>/data/evaluations.nc",
    log:
        "<results>/logs/accuracy/evaluations.log",
    benchmark:
        "<results>/benchmarks/accuracy/evaluations.tsv"
    params:
        code=code_of("evidence.costs.effects", "study.storage.store", "study.describe"),
        provenance=PROVENANCE,
    message:
        "Counting the evaluations of each effect"
    script:
        "../scripts/evaluations.py"


rule evaluations_figure:
    input:
        data="<results>/data/accuracy_errors.nc",
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg=report(
            "<results>/figures/{figure}.svg",
            category="What accuracy costs",
            caption="../report/accuracy_evaluations.rst",
            labels={"figure": "error against evaluations"},
        ),
        pdf="<results>/figures/{figure}.pdf",
        png="<results>/figures/{figure}.png",
    log:
        "<results>/logs/figures/{figure}.log",
    benchmark:
        "<results>/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure="accuracy_evaluations",
    params:
        code=code_of(*OURS["accuracy_evaluations"].modules),
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/file_figure.py"


rule accuracy_data:
    input:
        scenes=["workflow/scenes/figure_15.yaml", "workflow/scenes/figure_14a.yaml"],
    output:
        "<results>/data/accuracy.nc",
    log:
        "<results>/logs/accuracy/accuracy.log",
    # Nothing else may run beside a measurement.
    threads: workflow.cores
    params:
        code=code_of(
            "evidence.costs.measurements", "study.storage.store", "study.describe"
        ),
        provenance=PROVENANCE,
    message:
        "Measuring what accuracy costs"
    script:
        "../scripts/accuracy.py"


rule effects_data:
    input:
        study=STUDY_FILE,
        counted="<results>/data/evaluations.nc",
        scenes=[push.file for push in STUDY.scenes.values()],
    output:
        "<results>/data/effects.nc",
    log:
        "<results>/logs/accuracy/effects.log",
    threads: workflow.cores
    params:
        code=code_of("evidence.costs.effects", "study.storage.store", "study.describe"),
        provenance=PROVENANCE,
    message:
        "Measuring what each effect costs"
    script:
        "../scripts/effects.py"


rule effects_figure:
    input:
        data="<results>/data/effects.nc",
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg=report(
            "<results>/figures/effects.svg",
            category="Effects",
            caption="../report/effects.rst",
            labels={"figure": "times"},
        ),
        pdf="<results>/figures/effects.pdf",
        png="<results>/figures/effects.png",
    log:
        "<results>/logs/figures/effects.log",
    params:
        code=code_of(*SUPPLEMENT["effects"].modules),
    message:
        "Drawing effects"
    script:
        "../scripts/file_figure.py"


rule accuracy_figure:
    input:
        data="<results>/data/accuracy.nc",
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg=report(
            "<results>/figures/{figure}.svg",
            category="What accuracy costs",
            caption="../report/times.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="<results>/figures/{figure}.pdf",
        png="<results>/figures/{figure}.png",
    log:
        "<results>/logs/figures/{figure}.log",
    wildcard_constraints:
        figure="|".join(ACCURACY),
    params:
        code=lambda wildcards: code_of(*SUPPLEMENT[wildcards.figure].modules),
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/file_figure.py"


rule supplement_tables:
    input:
        data=expand("<results>/data/{name}.nc", name=["accuracy", "effects"]),
    output:
        expand(
            "<results>/tables/{name}",
            name=[
                "accuracy_numbers.json",
                "times_effects.csv",
                "times_scenes.csv",
                "times_machine.csv",
            ],
        ),
    log:
        "<results>/logs/accuracy/supplement_tables.log",
    params:
        code=code_of("report.supplement"),
        golden=lambda wildcards: STUDY.golden,
        results=lambda wildcards: RESULTS,
    message:
        "Reading the numbers of the supplement"
    script:
        "../scripts/supplement_tables.py"


rule supplement_pdf:
    input:
        rules.supplement_tables.output,
        figures=expand("<results>/figures/{figure}.svg", figure=list(SUPPLEMENT)),
        source="paper/supplement.typ",
        parts=SOURCES,
    output:
        report(
            "<results>/accuracy.pdf",
            category="Report",
            labels={"document": "supplement on time"},
            caption="../report/supplement.rst",
        ),
    log:
        "<results>/logs/accuracy/supplement_pdf.log",
    params:
        code=code_of("report.typeset"),
        results=lambda wildcards: RESULTS,
    message:
        "Setting the supplement"
    script:
        "../scripts/paper.py"


rule accuracy:
    input:
        "<results>/data/accuracy.nc",
        "<results>/data/effects.nc",
        expand(
            "<results>/figures/{figure}.{kind}",
            figure=list(SUPPLEMENT),
            kind=["svg", "pdf", "png"],
        ),
        (
            [rules.supplement_tables.output, "<results>/accuracy.pdf"]
            if STUDY.golden
            else []
        ),
