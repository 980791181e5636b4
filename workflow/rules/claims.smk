# The ledger of the paper's claims: a verdict on each; the job fails where one is not as expected.
rule claims_table:
    input:
        ledger="paper/claims.yaml",
    output:
        json="<results>/tables/claims.json",
        csv=report(
            "<results>/tables/claims.csv",
            category="Claims",
            caption="../report/claims.rst",
        ),
    log:
        "<results>/logs/claims/claims_table.log",
    benchmark:
        "<results>/benchmarks/claims/claims_table.tsv"
    params:
        call="evidence.jobs:claims",
        code=code_of("claims"),
    message:
        "Checking the claims of the paper"
    script:
        "../scripts/run.py"


rule claims:
    input:
        rules.claims_table.output,
