# The report: first its tables, then the PDF. It describes the paper's study, which golden data certify as a
# whole, and the study of sliders.
#: Sources in addition to the results.
SOURCES = [
    "CITATION.cff",
    *sorted(
        str(part)
        for part in Path("paper").rglob("*")
        if part.suffix in (".typ", ".md", ".bib", ".json")
        and "manual" not in part.parts
    ),
]
#: The tables of the report with their titles in Snakemake's report.
TABLES = {
    "infinite_friction_cones": ("Tables", "motion cones of infinite friction", "cones"),
    "ellipsoids": ("Tables", "ellipsoids that approximate supports", "ellipsoids"),
    "golden_summary": ("Golden check", "by dataset", "golden_summary"),
    "accuracy": ("What accuracy costs", "by method", "accuracy"),
    "hard_places": ("What accuracy costs", "hard cases", "hard_places"),
    "hard_ill": ("What accuracy costs", "ill-conditioned", "hard_ill"),
    "effects": ("What accuracy costs", "by effect", "effects"),
}


rule report_tables:
    input:
        rules.data.input,
        expand("{results}/data/{name}.nc", results=CERTIFIED, name=COUNTS + TIMES),
        verdicts("verdict.txt", "verdict.json"),
        PUSHES_FILE,
        f"{WHOLE}/tables/claims.json",
        all_golden_files(),
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
        **runs("report.tables:write_tables", *FIGURE_MODULES, also=contents),
        golden=STUDIES[WHOLE].golden if WHOLE else "",
        results=WHOLE,
    message:
        "Reading the numbers of the report"
    script:
        RUN


# The commit is a parameter, so that a new commit rebuilds only this table and the report.
rule report_provenance:
    input:
        all_golden_files(),
    output:
        output=f"{WHOLE}/tables/provenance.csv",
    log:
        f"{WHOLE}/logs/paper/report_provenance.log",
    params:
        **runs("report.provenance:write_provenance", also=contents),
        study=FILES.get(WHOLE),
        golden=STUDIES[WHOLE].golden if WHOLE else "",
        results=WHOLE,
        state=lambda wildcards: commit(),
    message:
        "Identifying the code"
    script:
        RUN


rule paper_pdf:
    input:
        rules.report_tables.output,
        rules.report_provenance.output,
        f"{WHOLE}/tables/claims.json",
        over("{results}/figures/{name}.svg", lambda study: study.figures),
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
        **runs("report.typeset:typeset"),
        root=".",
        results=WHOLE,
    message:
        "Typesetting the report"
    script:
        RUN


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


# Sphinx converts pages, docstrings and results to HTML. `make manual` builds the manual; `all` does not.
rule manual_pages:
    input:
        rules.report_tables.input,
        rules.report_tables.output,
        rules.paper_pdf.output,
        SOURCES,
        "results/README.md",
        sorted(map(str, Path("workflow/scenes").glob("*.yaml"))),  # pictures of the gallery
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
        **runs("report.manual:build_manual", "report.typeset", "study.dictionary"),
        source=lambda wildcards: "paper/manual",
    message:
        "Building the manual"
    script:
        RUN


rule manual:
    input:
        rules.manual_pages.output if REPORTED else [],
