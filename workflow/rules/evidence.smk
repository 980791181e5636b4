# Evidence: golden data, claims, hard cases and costs. All except the golden check are built only with the
# paper's study.
CERTIFIED = [WHOLE] if WHOLE else []


# The verdict is written whether the check passes or fails; `golden_passed` fails at the end of the run.
rule golden_verdict:
    input:
        golden_results,
    output:
        data="{results}/tables/golden_verdict.json",
        text=report(
            "{results}/tables/golden_verdict.txt",
            category="Golden check",
            caption="../report/golden.rst",
        ),
    log:
        "{results}/logs/golden/golden_verdict.log",
    benchmark:
        "{results}/benchmarks/golden/golden_verdict.tsv"
    params:
        call="evidence.jobs:golden",
        code=lambda wildcards: [
            code_of("evidence.golden.check", "evidence.golden.verdict"),
            whole_digest(study_of(wildcards)),
        ],
        study=lambda wildcards: FILES[wildcards.results],
        results="{results}",
    message:
        "Comparing every value of {wildcards.results} with golden data"
    script:
        "../scripts/run.py"


#: The ledger of the paper's claims, in the project's folder; without it, no claim is checked.
LEDGER = "paper/claims.yaml"


# A verdict on each claim; the job fails if a verdict differs from the expected one.
rule claims:
    input:
        over(
            "{results}/tables/claims.{name}",
            lambda folder: (
                ["json", "csv"]
                if STUDIES[folder].scenes and Path(LEDGER).is_file()
                else []
            ),
        ),


rule claims_table:
    input:
        ledger=LEDGER,
    output:
        json="{results}/tables/claims.json",
        csv=report(
            "{results}/tables/claims.csv",
            category="Claims",
            caption="../report/claims.rst",
        ),
    log:
        "{results}/logs/claims/claims_table.log",
    benchmark:
        "{results}/benchmarks/claims/claims_table.tsv"
    params:
        call="evidence.jobs:claims",
        code=code_of("evidence.claims.table"),
    message:
        "Checking the claims of the paper"
    script:
        "../scripts/run.py"


# What accuracy and effects cost, and the hard cases.
rule accuracy:
    input:
        expand("{results}/data/{name}.nc", results=CERTIFIED, name=COUNTS + TIMES),
        expand(
            "{results}/figures/{name}.{kind}",
            results=CERTIFIED,
            name=EVIDENCE_FIGURES,
            kind=KINDS,
        ),


# Datasets about the computation itself. The motions of `accuracy` are those of two scene files.
rule counts:
    input:
        lambda wildcards: MOTIONS if wildcards.counts == "accuracy" else [],
    output:
        path="{results}/data/{counts}.nc",
    log:
        "{results}/logs/data/{counts}.log",
    benchmark:
        "{results}/benchmarks/data/{counts}.tsv"
    wildcard_constraints:
        counts=one_of(COUNTS),
    params:
        call="evidence.jobs:{counts}",
        code=lambda wildcards: code_of(
            "evidence.hard_cases.dataset"
            if wildcards.counts == "hard_cases"
            else "evidence.costs.measure"
        ),
        marks=lambda wildcards: MARKS[wildcards.results](wildcards.counts),
    message:
        "Computing {wildcards.counts}"
    script:
        "../scripts/run.py"


# Times of this machine; nothing else must run during a measurement, which takes a few seconds.
rule times:
    input:
        lambda wildcards: MOTIONS if wildcards.times == "accuracy_time" else [],
    output:
        path="{results}/data/{times}.nc",
    log:
        "{results}/logs/data/{times}.log",
    wildcard_constraints:
        times=one_of(TIMES),
    threads: workflow.cores
    params:
        call="evidence.jobs:{times}",
        code=code_of("evidence.costs.measure", "evidence.costs.effects"),
        values=timed_study,
        marks=lambda wildcards: MARKS[wildcards.results](wildcards.times),
    message:
        "Measuring {wildcards.times}"
    script:
        "../scripts/run.py"
