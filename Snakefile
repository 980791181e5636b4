# Replication of Lynch & Mason, Pulling by Pushing, Slip with Infinite Friction, and Perfectly Rough
# Surfaces. `snakemake` builds everything, and fails at the end if the golden check has not passed, as does
# `snakemake golden`; `snakemake data`, `figures`, `claims`, `accuracy` and `paper` build parts;
# `snakemake pushes --config data=FOLDER` evaluates published pushes; `snakemake manual` builds the manual.
# To build only another study, use snakemake --config study=workflow/config/smoke.yaml or `planar-pushing run`,
# which runs the workflow included in the package in the current folder.
#
# The rules are in the order of the paper's sections. A dataset is computed by one job, over a grid of the study;
# `dataset.smk` says how, also in chunks. A figure is a view of datasets.


report: "workflow/report/workflow.rst"


include: "workflow/rules/common.smk"
include: "workflow/rules/dataset.smk"


# --- Secs. 2 and 3: quasi-static pushing and pulling ----------------------------------------------------------


# Eqs. (2)-(7), Fig. 5, and the ellipses of Fig. 10: each force through the contact, and the motion that it causes.
use rule dataset as limit_curves with:
    output:
        path="{results}/data/{dataset,limit_curves}.nc",


# Figs. 5, 6 and 10: the same at each degree, for the drawn rods.
use rule dataset as curves with:
    output:
        path="{results}/data/{dataset,curves}.nc",


# Secs. 3.1, 3.2 and 4, Figs. 6, 7, 9 and 10: friction cones, and the cones to which they map: velocity cones under
# support friction, acceleration cones under inertia.
use rule dataset as motion_cones with:
    output:
        path="{results}/data/{dataset,motion_cones}.nc",


# Secs. 2, 3.2, 4 and 5: the consistent contact modes of each push: none, one or several.
use rule dataset as contact_modes with:
    output:
        path="{results}/data/{dataset,contact_modes}.nc",


# Fig. 13: the same over friction and the direction of the push, with the furthest pull.
use rule dataset as mode_maps with:
    output:
        path="{results}/data/{dataset,mode_maps}.nc",


# --- Sec. 4: dynamic pushing and pulling ----------------------------------------------------------------------


# Fig. 12: acceleration centers and cones under friction and inertia, the paper's bound and the exact set.
use rule dataset as acceleration_centers with:
    output:
        path="{results}/data/{dataset,acceleration_centers}.nc",


# Fig. 12: regions of possible acceleration centers, the paper's bound and the exact set.
use rule dataset as center_regions with:
    output:
        path="{results}/data/{dataset,center_regions}.nc",


# Figs. 2 to 4, 8, 9, 11 and 12: the scenes that the figures draw.
use rule dataset as scenes with:
    output:
        path="{results}/data/{dataset,scenes}.nc",


# Motion over time: what leaving out inertia or friction changes in pushes of a box, at slow and fast speeds.
use rule dataset as model_errors with:
    output:
        path="{results}/data/{dataset,model_errors}.nc",


# Estimates of what leaving out an effect changes, and what it does, in random pushes.
use rule dataset as model_estimates with:
    output:
        path="{results}/data/{dataset,model_estimates}.nc",


# Motion over time. One job simulates all scene files of a study. The marks include the content
# of the files. The files are no inputs, since their layout does not matter.
for folder, study in STUDIES.items():

    rule:
        name:
            f"simulations_{study_name(FILES[folder])}"
        output:
            paths=[f"{folder}/data/simulations/{name}.nc" for name in study.simulations],
        log:
            f"{folder}/logs/data/simulations.log",
        benchmark:
            f"{folder}/benchmarks/data/simulations.tsv"
        params:
            **runs("study.running.simulations:simulations"),
            scenes=study.simulations,
            marks=[MARKS[folder](f"simulations/{name}") for name in study.simulations],
        message:
            f"Simulating the scenes of {FILES[folder]}"
        script:
            RUN


# --- Secs. 3.1 and 3.2 for any slider -------------------------------------------------------------------------


# Wrenches of each support over centers of rotation, and its ellipsoid.
use rule dataset as supports with:
    output:
        path="{results}/data/{dataset,supports}.nc",


# Limit curves of each support and of the ring.
use rule dataset as support_curves with:
    output:
        path="{results}/data/{dataset,support_curves}.nc",


# Motion cones of each support.
use rule dataset as support_cones with:
    output:
        path="{results}/data/{dataset,support_cones}.nc",


# Motion cones over rod lengths and rod angles, and the friction that pulling needs.
use rule dataset as support_rods with:
    output:
        path="{results}/data/{dataset,support_rods}.nc",


# The consistent contact modes of each support.
use rule dataset as support_modes with:
    output:
        path="{results}/data/{dataset,support_modes}.nc",


rule data:
    input:
        over("{results}/data/{name}.nc", computed_datasets),
        over(
            "{results}/data/simulations/{name}.nc",
            lambda study: study.simulations,
        ),


# --- Figures --------------------------------------------------------------------------------------------------


# Figures of a study, of what accuracy costs, and of measured pushes: each is drawn from the datasets that its module
# in `pulling_by_pushing.figures` names, cut at the values that the study gives. One job draws those of a section;
# that of motion also draws the simulations that no figure shows.
for folder, section, names, simulations in figure_jobs():
    drawings = [*names, *(f"simulation_{name}" for name in simulations)]

    rule:
        name:
            f"figures_{section}_{study_name(FILES[folder])}"
        input:
            sorted({file for name in names for file in figures.files(name, folder)}),
            [f"{folder}/data/simulations/{name}.nc" for name in simulations],
        output:
            svg=[
                report(
                    f"{folder}/figures/{name}.svg",
                    category=figure_category(name),
                    caption="workflow/report/figure.rst",
                    labels={"figure": name},
                )
                for name in drawings
            ],
            pdf=[f"{folder}/figures/{name}.pdf" for name in drawings],
            png=[f"{folder}/figures/{name}.png" for name in drawings],
        log:
            f"{folder}/logs/figures/{section}.log",
        benchmark:
            f"{folder}/benchmarks/figures/{section}.tsv"
        params:
            **runs(
                "figures.render:draw_figures",
                *(f"figures.{figures.module_name(name)}" for name in names),
            ),
            values={"results": folder},  # by itself, the lint takes it for a prefix of files
            figures={name: cuts(STUDIES[folder], name) for name in names},
            simulations=simulations,
            captions=figure_captions(names),
        message:
            f"Drawing {', '.join(drawings)}"
        script:
            RUN


rule figures:
    input:
        over("{results}/figures/{name}.{kind}", lambda study: study.figures),
        over("{results}/figures/simulation_{name}.{kind}", undrawn),


# --- Evidence -------------------------------------------------------------------------------------------------


# The golden check: every value of a study against values from ball arithmetic. The verdict is written whether
# it passes or fails.
rule golden_verdict:
    input:
        golden_results,
    output:
        data="{results}/tables/golden_verdict.json",
        text=report(
            "{results}/tables/golden_verdict.txt",
            category="Golden check",
            caption="workflow/report/golden.rst",
        ),
    log:
        "{results}/logs/golden/golden_verdict.log",
    benchmark:
        "{results}/benchmarks/golden/golden_verdict.tsv"
    priority: AWAITED
    params:
        **runs(
            "evidence.golden.verdict:write_verdict",
            also=lambda wildcards: [content(wildcards.results)],
        ),
        study=lambda wildcards: FILES[wildcards.results],
        results="{results}",
    message:
        "Comparing every value of {wildcards.results} with golden data"
    script:
        RUN


# The claims of the paper: a verdict on each; the job fails if a verdict differs from the expected one.
rule claims_table:
    input:
        ledger=LEDGER,
    output:
        json="{results}/tables/claims.json",
        csv=report(
            "{results}/tables/claims.csv",
            category="Claims",
            caption="workflow/report/claims.rst",
        ),
    log:
        "{results}/logs/claims/claims_table.log",
    benchmark:
        "{results}/benchmarks/claims/claims_table.tsv"
    priority: AWAITED
    params:
        **runs("evidence.claims.table:write_table"),
    message:
        "Checking the claims of the paper"
    script:
        RUN


rule claims:
    input:
        over(
            "{results}/tables/claims.{name}",
            lambda study: (
                ["json", "csv"] if study.scenes and Path(LEDGER).is_file() else []
            ),
        ),


# Numerically hard cases, against references of 40 digits.
rule hard_cases:
    output:
        path="{results}/data/hard_cases.nc",
    log:
        "{results}/logs/data/hard_cases.log",
    benchmark:
        "{results}/benchmarks/data/hard_cases.tsv"
    priority: LONG
    params:
        **runs("evidence.hard_cases.dataset:write"),
        marks=marks("hard_cases"),
    message:
        "Computing hard_cases"
    script:
        RUN


# What accuracy costs: errors and evaluations of every method.
rule accuracy_errors:
    input:
        MOTIONS,
    output:
        path="{results}/data/accuracy.nc",
    log:
        "{results}/logs/data/accuracy.log",
    benchmark:
        "{results}/benchmarks/data/accuracy.tsv"
    priority: LONG
    params:
        **runs("evidence.costs.measure:write_accuracy"),
        marks=marks("accuracy"),
    message:
        "Computing accuracy"
    script:
        RUN


# Evaluations of each effect, and of none that a scene does not list.
rule effects:
    output:
        path="{results}/data/effects.nc",
    log:
        "{results}/logs/data/effects.log",
    benchmark:
        "{results}/benchmarks/data/effects.tsv"
    params:
        **runs("evidence.costs.effects:write_effects"),
        study=lambda wildcards: FILES[wildcards.results],
        marks=marks("effects"),
    message:
        "Counting effects"
    script:
        RUN


# What accuracy costs in time on this machine. Nothing else must run during a measurement, which takes a few seconds.
rule times:
    input:
        MOTIONS,
    output:
        path="{results}/data/accuracy_time.nc",
    log:
        "{results}/logs/data/times.log",
    benchmark:
        "{results}/benchmarks/data/times.tsv"
    priority: TO_BEGIN
    threads: workflow.cores
    params:
        **runs("evidence.costs.measure:write_accuracy_time"),
        marks=marks("accuracy_time"),
    message:
        "Measuring accuracy_time"
    script:
        RUN


rule accuracy:
    input:
        expand("{results}/data/{name}.nc", results=CERTIFIED, name=COUNTS + TIMES),
        expand(
            "{results}/figures/{name}.{kind}",
            results=CERTIFIED,
            name=[name for name in OURS if name not in PUSHES],
            kind=KINDS,
        ),


# --- Report ---------------------------------------------------------------------------------------------------


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
        **runs("report.closing:require_golden"),
    message:
        "Requiring that every value of {wildcards.results} agrees with golden data"
    script:
        RUN


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
