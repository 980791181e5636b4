"""Draw one figure of what accuracy costs from the measurements."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]):
    from planar_pushing.figures.accuracy import draw_accuracy

    draw_accuracy(snakemake.wildcards.figure, snakemake.input.data, list(snakemake.output))
