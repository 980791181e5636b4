# The manual: Sphinx writes pages, docstrings and results as HTML. `make manual` builds it; `all` does not.
# Like the report, it needs the whole study that golden data certify.

#: Times that `snakemake accuracy` measured: the manual shows them where they exist, and does not request them.
MEASURED = sorted(Path(RESULTS, "tables").glob("times_*.csv"))


rule manual_pages:
    input:
        rules.report_tables.input,
        rules.report_tables.output,
        rules.figures.input,
        rules.sliders.input if GALLERY else [],
        rules.hard_cases.input,
        rules.simulations.input,
        "results/README.md",
        [
            str(path)
            for path in sorted(Path("paper/manual").rglob("*"))
            if path.is_file() and "__pycache__" not in path.parts
        ],
    output:
        output=directory("<results>/manual"),
    log:
        "<results>/logs/manual/manual_pages.log",
    benchmark:
        "<results>/benchmarks/manual/manual_pages.tsv"
    params:
        call="report.manual:build_manual",
        source=lambda wildcards: "paper/manual",
        code=code_of("manual"),
        measured=lambda wildcards: [path.read_text() for path in MEASURED],
    message:
        "Building the manual"
    script:
        "../scripts/run.py"


rule manual:
    input:
        rules.manual_pages.output if REPORTED else [],
