# The check: every value of every dataset and of what figures plot, by residual, exactly, or by computing it
# anew, and the golden sample by enclosures.
VERDICT = (
    expand("<results>/tables/golden_verdict.{kind}", kind=["txt", "json"])
    if STUDY.golden
    else []
)


rule golden:
    input:
        VERDICT,


rule golden_verdict:
    input:
        [
            expand("<results>/data/{dataset}.nc", dataset=COMPUTED),
            expand(
                "<results>/data/simulations/{simulation}.nc",
                simulation=STUDY.simulations,
            ),
            expand("<results>/data/{name}.nc", name=COUNTS),
            expand("<results>/figures/data/{figure}.nc", figure=DRAWN),
        ],
        golden_files(STUDY),
    output:
        data="<results>/tables/golden_verdict.json",
        text=report(
            "<results>/tables/golden_verdict.txt",
            category="Golden check",
            caption="../report/golden.rst",
        ),
    log:
        "<results>/logs/golden/golden_verdict.log",
    benchmark:
        "<results>/benchmarks/golden/golden_verdict.tsv"
    priority: FIRST
    params:
        call="evidence.jobs:golden",
        code=[golden_code(COMPUTED, FIGURES, DRAWN), whole_digest(STUDY)],
        study=STUDY_FILE,
        results=lambda wildcards: RESULTS,
    message:
        "Checking every value of the results"
    script:
        "../scripts/run.py"
