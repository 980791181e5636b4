# The golden check: every dataset and every figure's numbers against certified values.
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
        results=[
            expand("<results>/data/{dataset}.nc", dataset=COMPUTED),
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
            "evidence.golden.check", "evidence.golden.verdict", "evidence.writing"
        ),
        golden=STUDY.golden,
        results=RESULTS,
        tolerances={name: each.model_dump() for name, each in STUDY.tolerances.items()},
    message:
        "Comparing the results with the golden data"
    script:
        "../scripts/golden.py"
