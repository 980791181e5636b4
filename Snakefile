# Replication of Lynch & Mason, Pulling by Pushing, Slip with Infinite Friction, and Perfectly Rough
# Surfaces. `snakemake` builds everything, and fails at the end if the golden check has not passed, as does
# `snakemake golden`; `snakemake data`, `figures`, `claims`, `accuracy` and `paper` build parts;
# `snakemake pushes --config data=FOLDER` evaluates published pushes; `snakemake manual` builds the manual.
# To build only another study, use snakemake --config study=workflow/config/smoke.yaml or `planar-pushing run`,
# which runs the workflow included in the package in the current folder.


report: "workflow/report/workflow.rst"


include: "workflow/rules/common.smk"
include: "workflow/rules/data.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/evidence.smk"
include: "workflow/rules/pushes.smk"
include: "workflow/rules/report.smk"


localrules:
    all,
    data,
    figures,
    golden,
    claims,
    pushes_figures,
    pushes,
    accuracy,
    paper,
    manual,


#: All results; the golden check has failed or passed, and the report says so.
BUILT = [
    *rules.data.input,
    *rules.figures.input,
    *verdicts("verdict.txt", "verdict.json"),
    *rules.claims.input,
    *rules.accuracy.input,
    *rules.pushes_figures.input,
    *rules.paper.input,
]


# A failed golden check fails the run, but only after everything else is built.
rule golden_passed:
    input:
        BUILT,
        verdict="{results}/tables/golden_verdict.txt",
    output:
        passed="{results}/tables/golden_passed.txt",
    log:
        "{results}/logs/golden/golden_passed.log",
    params:
        call="evidence.jobs:require_golden",
        code=code_of("evidence.golden.verdict"),
    message:
        "Requiring that every value of {wildcards.results} agrees with golden data"
    script:
        "workflow/scripts/run.py"


rule golden:
    input:
        verdicts("passed.txt"),


rule all:
    default_target: True
    input:
        BUILT,
        verdicts("passed.txt"),


onerror:
    for job in workflow.scheduler.failed:
        print(
            failure_text(job.rule.name, job.message, list(job.log)), file=sys.stderr
        )
