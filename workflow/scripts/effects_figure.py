"""Draw what each effect costs."""

from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]):
    from matplotlib.figure import Figure

    from planar_pushing.figures.evidence import effects
    from planar_pushing.figures.render import save
    from planar_pushing.figures.style import paper_style
    from planar_pushing.study.store import read_dataset

    with paper_style():
        figure = Figure(figsize=effects.SIZE)
        effects.draw(figure, read_dataset(snakemake.input.data))
        for path in snakemake.output:
            save(figure, path)
