"""Count how often each effect of the study is evaluated, in Python: compiled code cannot be counted."""

import os

from planar_pushing.study.running.jobs import job_log

os.environ["NUMBA_DISABLE_JIT"] = "1"

with job_log(snakemake.log[0]):
    from planar_pushing.evidence.costs.effects import evaluations
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.store import write_dataset
    from planar_pushing.study.study_file import load_study

    counted = evaluations(load_study(snakemake.input.study))
    found = of_study(counted, "evaluations", snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
