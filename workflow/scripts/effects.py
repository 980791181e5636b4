"""Count and time what each effect of the study costs, in this one process."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]):
    import json

    from planar_pushing.evidence.costs.effects import measure
    from planar_pushing.evidence.costs.timing import machine
    from planar_pushing.study.store import write_dataset
    from planar_pushing.study.study_file import load_study

    measured = measure(load_study(snakemake.input.study))
    write_dataset(measured.assign_attrs(machine=json.dumps(machine())), snakemake.output[0])
