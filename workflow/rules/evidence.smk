# Where the numbers get hard, and what accuracy and each effect cost. They are built with the study that the
# golden data certify. Only the times of `accuracy_time` are measured by default, on this machine and outside
# the golden check; `snakemake accuracy` measures the others.
rule hard_cases:
    input:
        expand("<results>/data/{name}.nc", name=COUNTS + TIMES),
        expand(
            "<results>/figures/{figure}.{kind}",
            figure=OURS if STUDY.golden else [],
            kind=KINDS,
        ),


rule hard_cases_data:
    output:
        path="<results>/data/hard_cases.nc",
    log:
        "<results>/logs/data/hard_cases.log",
    benchmark:
        "<results>/benchmarks/data/hard_cases.tsv"
    params:
        call="evidence.jobs:hard_cases",
        code=code_of("hard_cases"),
        marks=MARKS[STUDY_FILE]("hard_cases"),
    message:
        "Measuring the hard cases"
    script:
        "../scripts/run.py"


rule accuracy_errors:
    output:
        path="<results>/data/accuracy_errors.nc",
    log:
        "<results>/logs/accuracy/accuracy_errors.log",
    benchmark:
        "<results>/benchmarks/accuracy/accuracy_errors.tsv"
    params:
        call="evidence.jobs:accuracy_errors",
        code=code_of("costs"),
        marks=MARKS[STUDY_FILE]("accuracy_errors"),
    message:
        "Computing the errors of every method"
    script:
        "../scripts/run.py"


rule evaluations:
    output:
        path="<results>/data/evaluations.nc",
    log:
        "<results>/logs/accuracy/evaluations.log",
    benchmark:
        "<results>/benchmarks/accuracy/evaluations.tsv"
    params:
        call="evidence.jobs:evaluations",
        code=code_of("costs", *map(builder, GRIDS)),
        study=STUDY_FILE,
        marks=MARKS[STUDY_FILE]("evaluations"),
    message:
        "Counting the functions and evaluations of each effect"
    script:
        "../scripts/run.py"


rule accuracy_time:
    output:
        path="<results>/data/accuracy_time.nc",
    log:
        "<results>/logs/accuracy/accuracy_time.log",
    benchmark:
        "<results>/benchmarks/accuracy/accuracy_time.tsv"
    # Nothing else may run beside a measurement.
    threads: workflow.cores
    params:
        call="evidence.jobs:accuracy_time",
        code=code_of("costs"),
        marks=MARKS[STUDY_FILE]("accuracy_time"),
    message:
        "Measuring the time that accuracy costs"
    script:
        "../scripts/run.py"


rule accuracy_data:
    output:
        path="<results>/data/accuracy.nc",
    log:
        "<results>/logs/accuracy/accuracy.log",
    threads: workflow.cores
    params:
        call="evidence.jobs:accuracy",
        code=code_of("costs"),
        marks=MARKS[STUDY_FILE]("accuracy"),
    message:
        "Measuring what accuracy costs"
    script:
        "../scripts/run.py"


rule effects_data:
    output:
        path="<results>/data/effects.nc",
    log:
        "<results>/logs/accuracy/effects.log",
    threads: workflow.cores
    params:
        call="evidence.jobs:effects",
        code=code_of("costs", *map(builder, GRIDS)),
        study=STUDY_FILE,
        marks=MARKS[STUDY_FILE]("effects"),
    message:
        "Measuring what each set of effects costs"
    script:
        "../scripts/run.py"


rule supplement_tables:
    input:
        expand("<results>/data/{name}.nc", name=["accuracy", "effects"]),
    output:
        numbers="<results>/tables/accuracy_numbers.json",
        effects="<results>/tables/times_effects.csv",
        scenes="<results>/tables/times_scenes.csv",
        machine="<results>/tables/times_machine.csv",
    log:
        "<results>/logs/accuracy/supplement_tables.log",
    params:
        call="report.jobs:supplement_tables",
        code=code_of("report"),
        golden=STUDY.golden,
        results=lambda wildcards: RESULTS,
    message:
        "Reading the numbers of the supplement"
    script:
        "../scripts/run.py"


rule supplement_pdf:
    input:
        rules.supplement_tables.output,
        expand("<results>/figures/{figure}.svg", figure=SUPPLEMENT),
        SOURCES,
        source="paper/supplement.typ",
    output:
        output=report(
            "<results>/accuracy.pdf",
            category="Report",
            labels={"document": "supplement on time"},
            caption="../report/supplement.rst",
        ),
    log:
        "<results>/logs/accuracy/supplement_pdf.log",
    params:
        call="report.typeset:typeset",
        code=code_of("report"),
        root=".",
        results=lambda wildcards: RESULTS,
    message:
        "Setting the supplement"
    script:
        "../scripts/run.py"


rule accuracy:
    input:
        expand("<results>/data/{name}.nc", name=["accuracy", "effects"]),
        expand("<results>/figures/{figure}.{kind}", figure=SUPPLEMENT, kind=KINDS),
        (
            [rules.supplement_tables.output, "<results>/accuracy.pdf"]
            if STUDY.golden
            else []
        ),
