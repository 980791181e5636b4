# The check of the study of sliders: every value in its equation or computed anew, and the golden sample.
from pathlib import Path


rule sliders_golden:
    input:
        (
            expand("<sliders>/tables/golden_verdict.{kind}", kind=["txt", "json"])
            if GALLERY.golden
            else []
        ),


rule sliders_verdict:
    input:
        study=GALLERY_FILE,
        scenes=list(GALLERY.simulations.values()),
        results=[
            expand("<sliders>/data/{dataset}.nc", dataset=SLIDERS),
            expand(
                "<sliders>/data/simulations/{simulation}.nc",
                simulation=GALLERY.simulations,
            ),
            expand("<sliders>/figures/data/{figure}.nc", figure=SHOWN),
        ],
        golden=sorted(map(str, Path(GALLERY.golden or ".").glob("*.nc"))),
    output:
        data="<sliders>/tables/golden_verdict.json",
        text=report(
            "<sliders>/tables/golden_verdict.txt",
            category="Golden check",
            caption="../report/golden.rst",
        ),
    log:
        "<sliders>/logs/golden/golden_verdict.log",
    benchmark:
        "<sliders>/benchmarks/golden/golden_verdict.tsv"
    priority: FIRST
    params:
        code=code_of(
            "evidence.golden.check",
            "evidence.golden.verdict",
            "evidence.writing",
            *(GALLERY_FIGURES[name].modules[1] for name in SHOWN),
        ),
        results=lambda wildcards: folder_of(GALLERY_FILE),
    message:
        "Checking every value of the sliders' results"
    script:
        "../scripts/golden.py"
