"""Count and time what each effect of the study costs, in this one process."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.evidence.costs.effects import measure
    from planar_pushing.study.store import write_dataset
    from planar_pushing.study.study_file import load_study

    write_dataset(measure(load_study(snakemake.input.study)), snakemake.output[0])
