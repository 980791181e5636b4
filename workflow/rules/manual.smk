# The manual: pages, docstrings and results, set as HTML by Sphinx; `snakemake manual`, outside of `all`. Like
# the report, it is about a whole study that golden data certify.

#: Times that `snakemake accuracy` measured: shown where they are there, and never asked for.
MEASURED = sorted(Path(RESULTS, "tables").glob("times_*.csv"))


rule manual_pages:
    input:
        rules.report_tables.input,
        rules.report_tables.output,
        figures=rules.figures.input,
        gallery=rules.sliders.input if GALLERY else [],
        ours=[rules.hard_cases.input, rules.counts.input],
        simulations=rules.simulations.input,
        dictionary="results/README.md",
        pages=[
            str(path)
            for path in sorted(Path("paper/manual").rglob("*"))
            if path.is_file() and "__pycache__" not in path.parts
        ],
    output:
        directory("<results>/manual"),
    log:
        "<results>/logs/manual/manual_pages.log",
    benchmark:
        "<results>/benchmarks/manual/manual_pages.tsv"
    params:
        code=code_of("commands", "report.manual"),
        measured=lambda wildcards: [path.read_text() for path in MEASURED],
    message:
        "Setting the manual"
    script:
        "../scripts/manual.py"


rule manual:
    input:
        rules.manual_pages.output if REPORTED else [],
