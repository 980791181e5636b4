# The report: the tables that it is set from, then the PDF. It is about a whole study that golden data
# certify, with that of sliders, and built for such a one.
WHOLE = COMPUTED == list(DATASETS) and DRAWN == list(FIGURES)
REPORTED = STUDY.golden and WHOLE and GALLERY is not None


rule report_tables:
    input:
        expand("<results>/data/{dataset}.nc", dataset=DATASETS),
        expand("<results>/figures/data/{figure}.nc", figure=FIGURES),
        expand("<results>/data/{name}.nc", name=COUNTS + TIMES),
        expand("<results>/figures/{figure}.png", figure=[*FIGURES, *OURS]),
        "<sliders>/data/supports.nc",
        expand("<sliders>/figures/{figure}.png", figure=GALLERY_FIGURES),
        "<results>/tables/golden_verdict.json",
        "<results>/tables/claims.json",
        golden_files(STUDY),
    output:
        numbers="<results>/tables/numbers.json",
        figures="<results>/tables/figures.json",
        cones=report(
            "<results>/tables/infinite_friction_cones.csv",
            category="Tables",
            labels={"table": "motion cones of infinite friction"},
            caption="../report/cones.rst",
        ),
        ellipsoids=report(
            "<results>/tables/ellipsoids.csv",
            category="Tables",
            labels={"table": "ellipsoids in the supports' place"},
            caption="../report/ellipsoids.rst",
        ),
        verdict=report(
            "<results>/tables/golden_summary.csv",
            category="Golden check",
            labels={"table": "by dataset"},
            caption="../report/golden_summary.rst",
        ),
        provenance=report(
            "<results>/tables/provenance.csv",
            category="Provenance",
            labels={"table": "versions"},
            caption="../report/provenance.rst",
        ),
        accuracy_wrench=report(
            "<results>/tables/accuracy_wrench.csv",
            category="What accuracy costs",
            labels={"table": "methods for the wrench"},
            caption="../report/accuracy_wrench.rst",
        ),
        accuracy_cone=report(
            "<results>/tables/accuracy_cone.csv",
            category="What accuracy costs",
            labels={"table": "methods for motion cones"},
            caption="../report/accuracy_cone.rst",
        ),
        hard_places=report(
            "<results>/tables/hard_places.csv",
            category="Hard cases",
            labels={"table": "by place"},
            caption="../report/hard_places.rst",
        ),
        hard_ill=report(
            "<results>/tables/hard_ill.csv",
            category="Hard cases",
            labels={"table": "ill-conditioned"},
            caption="../report/hard_ill.rst",
        ),
        evaluations=report(
            "<results>/tables/evaluations.csv",
            category="Effects",
            labels={"table": "evaluations"},
            caption="../report/evaluations.rst",
        ),
    log:
        "<results>/logs/paper/report_tables.log",
    benchmark:
        "<results>/benchmarks/paper/report_tables.tsv"
    priority: FIRST
    params:
        call="report.jobs:report_tables",
        code=[code_of("report"), whole_digest(STUDY), REGISTRY],
        study=STUDY_FILE,
        golden=STUDY.golden,
        results=lambda wildcards: RESULTS,
    message:
        "Reading the numbers of the report"
    script:
        "../scripts/run.py"


rule paper_pdf:
    input:
        rules.report_tables.output,
        "<results>/tables/claims.json",
        expand("<results>/figures/{figure}.svg", figure=[*FIGURES, *OURS]),
        expand("<sliders>/figures/{figure}.svg", figure=GALLERY_FIGURES),
        SOURCES,
        source="paper/report.typ",
    output:
        output=report(
            "<results>/paper.pdf",
            category="Report",
            labels={"document": "the report"},
            caption="../report/paper.rst",
        ),
    log:
        "<results>/logs/paper/paper_pdf.log",
    benchmark:
        "<results>/benchmarks/paper/paper_pdf.tsv"
    priority: FIRST
    params:
        call="report.typeset:typeset",
        code=code_of("report"),
        root=".",
        results=lambda wildcards: RESULTS,
    message:
        "Setting the report"
    script:
        "../scripts/run.py"


rule paper:
    input:
        [rules.report_tables.output, rules.paper_pdf.output] if REPORTED else [],
