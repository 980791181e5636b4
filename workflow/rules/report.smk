# The report and its supplement on time: first their tables, then the PDFs. They describe the paper's study,
# which golden data certify as a whole, and the study of sliders.
#: Sources of both, in addition to the results.
SOURCES = sorted(
    str(part)
    for part in Path("paper").rglob("*")
    if part.suffix in (".typ", ".md", ".bib", ".json") and "manual" not in part.parts
)
#: The tables of the report with their titles in Snakemake's report.
TABLES = {
    "infinite_friction_cones": ("Tables", "motion cones of infinite friction", "cones"),
    "ellipsoids": ("Tables", "ellipsoids that approximate supports", "ellipsoids"),
    "golden_summary": ("Golden check", "by dataset", "golden_summary"),
    "accuracy_wrench": (
        "What accuracy costs",
        "methods for the wrench",
        "accuracy_wrench",
    ),
    "accuracy_cone": (
        "What accuracy costs",
        "methods for motion cones",
        "accuracy_cone",
    ),
    "hard_places": ("Hard cases", "by place", "hard_places"),
    "hard_ill": ("Hard cases", "ill-conditioned", "hard_ill"),
    "evaluations": ("Effects", "evaluations", "evaluations"),
}
#: Tables of the supplement.
SUPPLEMENT_TABLES = [
    "accuracy_numbers.json",
    *(f"times_{name}.csv" for name in ("effects", "scenes", "machine")),
]


rule report_tables:
    input:
        rules.data.input,
        rules.figures.input,
        verdicts("verdict.txt", "verdict.json"),
        rules.hard_cases.input,
        rules.pushes_figures.input,
        PUSHES_FILE,
        f"{WHOLE}/tables/claims.json",
        golden_files(),
    output:
        **{name: table(name) for name in TABLES},
        golden_failures=f"{WHOLE}/tables/golden_failures.csv",
        numbers=f"{WHOLE}/tables/numbers.json",
        figures=f"{WHOLE}/tables/figures.json",
    log:
        f"{WHOLE}/logs/paper/report_tables.log",
    benchmark:
        f"{WHOLE}/benchmarks/paper/report_tables.tsv"
    params:
        call="report.jobs:report_tables",
        code=[code_of("report"), *map(whole_digest, STUDIES.values())],
        golden=STUDIES[WHOLE].golden if WHOLE else "",
        results=WHOLE,
    message:
        "Reading the numbers of the report"
    script:
        "../scripts/run.py"


# The commit is a parameter, so that a new commit rebuilds only this table and the report.
rule report_provenance:
    input:
        golden_files(),
    output:
        output=f"{WHOLE}/tables/provenance.csv",
    log:
        f"{WHOLE}/logs/paper/report_provenance.log",
    params:
        call="report.jobs:report_provenance",
        code=[code_of("report"), *map(whole_digest, STUDIES.values())],
        study=FILES.get(WHOLE),
        golden=STUDIES[WHOLE].golden if WHOLE else "",
        results=WHOLE,
        state=commit(),
    message:
        "Identifying the code"
    script:
        "../scripts/run.py"


rule paper_pdf:
    input:
        rules.report_tables.output,
        rules.report_provenance.output,
        f"{WHOLE}/tables/claims.json",
        over("{results}/figures/{name}.svg", drawn),
        expand(f"{WHOLE}/figures/{{name}}.svg", name=OURS),
        SOURCES,
        source="paper/report.typ",
    output:
        output=report(
            f"{WHOLE}/paper.pdf",
            category="Report",
            labels={"document": "the report"},
            caption="../report/paper.rst",
        ),
    log:
        f"{WHOLE}/logs/paper/paper_pdf.log",
    benchmark:
        f"{WHOLE}/benchmarks/paper/paper_pdf.tsv"
    params:
        call="report.typeset:typeset",
        code=code_of("report"),
        root=".",
        results=WHOLE,
    message:
        "Typesetting the report"
    script:
        "../scripts/run.py"


rule paper:
    input:
        (
            [
                rules.report_tables.output,
                rules.report_provenance.output,
                rules.paper_pdf.output,
            ]
            if REPORTED
            else []
        ),


rule supplement_tables:
    input:
        expand(f"{WHOLE}/data/{{name}}.nc", name=["accuracy", "effects"]),
    output:
        numbers=f"{WHOLE}/tables/accuracy_numbers.json",
        effects=f"{WHOLE}/tables/times_effects.csv",
        scenes=f"{WHOLE}/tables/times_scenes.csv",
        machine=f"{WHOLE}/tables/times_machine.csv",
    log:
        f"{WHOLE}/logs/accuracy/supplement_tables.log",
    params:
        call="report.jobs:supplement_tables",
        code=code_of("report"),
        golden=STUDIES[WHOLE].golden if WHOLE else "",
        results=WHOLE,
    message:
        "Reading the numbers of the supplement"
    script:
        "../scripts/run.py"


rule supplement_pdf:
    input:
        rules.supplement_tables.output,
        expand(f"{WHOLE}/figures/{{figure}}.svg", figure=SUPPLEMENT),
        SOURCES,
        source="paper/supplement.typ",
    output:
        output=report(
            f"{WHOLE}/accuracy.pdf",
            category="Report",
            labels={"document": "supplement on time"},
            caption="../report/supplement.rst",
        ),
    log:
        f"{WHOLE}/logs/accuracy/supplement_pdf.log",
    params:
        call="report.typeset:typeset",
        code=code_of("report"),
        root=".",
        results=WHOLE,
    message:
        "Typesetting the supplement"
    script:
        "../scripts/run.py"


#: Times measured by `snakemake accuracy`; the manual shows them if they exist but does not request them.
MEASURED = sorted(Path("results/tables").glob("times_*.csv"))


# Sphinx converts pages, docstrings and results to HTML. `make manual` builds the manual; `all` does not.
rule manual_pages:
    input:
        rules.report_tables.input,
        rules.report_tables.output,
        rules.paper_pdf.output,
        "results/README.md",
        [
            str(path)
            for path in sorted(Path("paper/manual").rglob("*"))
            if path.is_file() and "__pycache__" not in path.parts
        ],
    output:
        output=directory(f"{WHOLE}/manual"),
    log:
        f"{WHOLE}/logs/manual/manual_pages.log",
    benchmark:
        f"{WHOLE}/benchmarks/manual/manual_pages.tsv"
    params:
        call="report.manual:build_manual",
        source=lambda wildcards: "paper/manual",
        code=code_of("manual"),
        measured=[path.read_text() for path in MEASURED],
    message:
        "Building the manual"
    script:
        "../scripts/run.py"


rule manual:
    input:
        rules.manual_pages.output if REPORTED else [],
