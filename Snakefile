# Replication of Lynch & Mason, Pulling by Pushing, Slip with Infinite Friction, and Perfectly Rough
# Surfaces. `snakemake` builds everything; `snakemake data`, `figures`, `golden` and `sliders` build parts,
# `snakemake accuracy` measures what accuracy costs, `make manual` builds the manual.
# Another study, alone: snakemake --config study=workflow/config/smoke.yaml


report: "workflow/report/workflow.rst"


include: "workflow/rules/common.smk"


pathvars:
    results=RESULTS,
    sliders=folder_of(GALLERY_FILE),


if STUDY:

    include: "workflow/rules/data.smk"
    include: "workflow/rules/simulations.smk"
    include: "workflow/rules/figures.smk"
    include: "workflow/rules/golden.smk"
    include: "workflow/rules/claims.smk"
    include: "workflow/rules/paper.smk"
    include: "workflow/rules/evidence.smk"

    localrules:
        accuracy,
        data,
        figures,
        simulations,
        golden,
        claims,
        paper,
        hard_cases,


if GALLERY:

    include: "workflow/rules/sliders.smk"

    localrules:
        sliders,
        sliders_golden,


if STUDY:

    include: "workflow/rules/manual.smk"

    localrules:
        manual,


localrules:
    all,


rule all:
    default_target: True
    input:
        (
            [
                rules.data.input,
                rules.simulations.input,
                rules.figures.input,
                rules.golden.input,
                rules.claims.input,
                rules.paper.input,
                rules.hard_cases.input,
            ]
            if STUDY
            else []
        ),
        [rules.sliders.input, rules.sliders_golden.input] if GALLERY else [],


onerror:
    for job in workflow.scheduler.failed:
        print(
            failure_text(job.rule.name, job.message, list(job.log)), file=sys.stderr
        )
