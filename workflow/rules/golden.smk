# The check: every value of every dataset and of what figures plot, by residual, exactly, or by computing it
# anew, and the golden sample by enclosures.
from pathlib import Path

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
        study=STUDY_FILE,
        scenes=[
            *(push.file for push in STUDY.scenes.values()),
            *STUDY.simulations.values(),
        ],
        results=[
            expand("<results>/data/{dataset}.nc", dataset=COMPUTED),
            expand(
                "<results>/data/simulations/{simulation}.nc",
                simulation=STUDY.simulations,
            ),
            expand(
                "<results>/data/{name}.nc",
                name=["hard_cases", "accuracy_errors", "evaluations"],
            ),
            expand("<results>/figures/data/{figure}.nc", figure=DRAWN),
        ],
        golden=sorted(map(str, Path(STUDY.golden or ".").glob("*.nc"))),
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
        code=code_of(
            "evidence.golden.check",
            "evidence.golden.recount",
            "evidence.golden.verdict",
            "evidence.writing",
            *(FIGURES[name].modules[1] for name in DRAWN),
        ),
        results=lambda wildcards: RESULTS,
    message:
        "Checking every value of the results"
    script:
        "../scripts/golden.py"
