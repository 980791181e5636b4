"""Check the results against their study; fail, with the verdict in the log, where they differ."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from pathlib import Path

    from planar_pushing.evidence.golden.check import check_results
    from planar_pushing.evidence.golden.verdict import verdict, verdict_text
    from planar_pushing.evidence.writing import json_text, write_text
    from planar_pushing.terms.errors import InvalidResult

    results = Path(snakemake.params.results)
    found = verdict(check_results(results, snakemake.input.study))
    text = verdict_text(found)
    if not found["passed"]:
        raise InvalidResult(text)
    log.info("%s", text)
    write_text(text, snakemake.output.text)
    write_text(json_text(found), snakemake.output.data)
