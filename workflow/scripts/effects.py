"""Time what each effect of the study costs, in this one process, beside its counts."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.evidence.costs.effects import measure
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.storage.store import read_dataset, write_dataset
    from planar_pushing.study.study_file import load_study

    study, counted = load_study(snakemake.input.study), read_dataset(snakemake.input.counted)
    found = of_study(measure(study, counted), "effects", snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
