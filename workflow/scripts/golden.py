"""Compare the results with the golden data; fail, with the verdict in the log, where they differ."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from pathlib import Path

    from planar_pushing.evidence.golden.check import check_results
    from planar_pushing.evidence.golden.compare import verdict
    from planar_pushing.mechanics.errors import InvalidResult
    from planar_pushing.study.models import Tolerance
    from planar_pushing.study.replacing import replacing

    given = snakemake.params.tolerances.items()
    tolerances = {name: Tolerance.model_validate(values) for name, values in given}
    checks = check_results(Path("results"), Path(snakemake.params.golden), tolerances)
    text = verdict(checks)
    if not all(check.passed for check in checks):
        raise InvalidResult(text)
    log.info("%s", text)
    with replacing(snakemake.output[0]) as temporary:
        temporary.write_text(text, encoding="utf-8")
