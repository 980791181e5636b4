"""Pictures of simulations."""

from matplotlib.figure import Figure

from planar_pushing.figures.motion import simulation
from planar_pushing.figures.motion.timeline import plotted
from planar_pushing.figures.style import paper_style


def test_a_simulation_shows_what_varies(logs):
    labels = {}
    with paper_style():
        for name in ("figure_14b", "figure_15"):
            figure = Figure(figsize=(7.0, 2.9))
            simulation.draw(figure, plotted(logs[name]))
            labels[name] = [ax.get_ylabel() for ax in figure.axes if ax.get_ylabel()]
    assert labels["figure_14b"][1:] == ["gap"]
    assert labels["figure_15"][1:] == ["slip"]
