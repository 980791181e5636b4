"""Sweep random and adversarial inputs; store the counts."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.evidence.hard_cases.sweep.counts import FULL, sweep
    from planar_pushing.evidence.writing import json_text, write_text

    log.info("sweeping %d inputs of each kind", FULL.kernels)
    write_text(json_text(sweep(FULL)), snakemake.output[0])
