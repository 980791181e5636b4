"""Count and time what each effect of the study costs, in this one process."""

from planar_pushing.effort.measure import measure
from planar_pushing.study.jobs import job_log
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

with job_log(snakemake.log[0]):
    write_dataset(measure(load_study(snakemake.input.study)), snakemake.output[0])
