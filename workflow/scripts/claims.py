"""Judge the claims of the ledger; fail, naming them, where a verdict is not the expected one."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.evidence.claims.ledger import load_ledger
    from planar_pushing.evidence.claims.table import complaint, csv_text, json_text, judge_all
    from planar_pushing.evidence.writing import write_text
    from planar_pushing.terms.errors import InvalidResult

    judged = judge_all(load_ledger(snakemake.input.ledger))
    if problem := complaint(judged):
        raise InvalidResult(problem)
    for path, text in (
        (snakemake.output.json, json_text(judged)),
        (snakemake.output.csv, csv_text(judged)),
    ):
        write_text(text, path)
    log.info("%d claims", len(judged))
