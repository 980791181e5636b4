# Where the numbers get hard: results against references of 40 digits, their figure, and a sweep of
# random and adversarial inputs, which `snakemake sweep` runs (some minutes).
# They do not depend on the study, and are built with the one that the golden data certify.
HARD_CASES = [
    "<results>/data/hard_cases.nc",
    *expand("<results>/figures/hard_cases.{kind}", kind=["svg", "pdf", "png"]),
]


rule hard_cases:
    input:
        HARD_CASES if STUDY.golden else [],


rule hard_cases_data:
    output:
        "<results>/data/hard_cases.nc",
    log:
        "<results>/logs/data/hard_cases.log",
    benchmark:
        "<results>/benchmarks/data/hard_cases.tsv"
    params:
        code=code_of(
            "evidence.hard_cases.dataset", "study.storage.store", "study.describe"
        ),
        provenance=PROVENANCE,
    message:
        "Measuring the hard cases"
    script:
        "../scripts/hard_cases.py"


rule hard_cases_figure:
    input:
        data="<results>/data/hard_cases.nc",
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg=report(
            "<results>/figures/hard_cases.svg",
            category="Hard cases",
            caption="../report/hard_cases.rst",
            labels={"figure": "hard_cases"},
        ),
        pdf="<results>/figures/hard_cases.pdf",
        png="<results>/figures/hard_cases.png",
    log:
        "<results>/logs/figures/hard_cases.log",
    benchmark:
        "<results>/benchmarks/figures/hard_cases.tsv"
    params:
        code=code_of(*OURS["hard_cases"].modules),
    message:
        "Drawing the hard cases"
    script:
        "../scripts/file_figure.py"


rule sweep:
    output:
        "<results>/tables/sweep.json",
    log:
        "<results>/logs/tables/sweep.log",
    benchmark:
        "<results>/benchmarks/tables/sweep.tsv"
    params:
        code=code_of("evidence.hard_cases.sweep.counts", "evidence.writing"),
    message:
        "Sweeping a million random and adversarial inputs"
    script:
        "../scripts/sweep.py"
