"""Small studies, logs, and the figures that are drawn from them, each when it is first asked for."""

from unittest.mock import patch

import pytest
from drawing.conftest import LOGS as LOGS
from drawing.conftest import OTHERS as OTHERS
from drawing.conftest import Made
from matplotlib.figure import Figure
from report.costs import accuracy, accuracy_time, hard_cases
from report.pushes import measured_pushes

import planar_pushing as pp
from planar_pushing.drawing.canvas import axes
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.figures.figure import cuts_of, drawing, entry, figure_names, select_values
from pulling_by_pushing.figures.measured import PUSHES_FILE
from pulling_by_pushing.figures.studies import cuts, study_figures
from pulling_by_pushing.study.running.simulations import study_log
from pulling_by_pushing.study.study_file import load_study
from smoke import smoke_results

FIGURES, NUMBERED = figure_names(), study_figures()


@pytest.fixture(scope="session")
def studies():
    """The study of each figure."""
    files = [f"workflow/config/{name}.yaml" for name in ("smoke", "sliders_smoke")]
    return {name: study for study in map(load_study, files) for name in study.figures}


@pytest.fixture(scope="session")
def logs():
    """Logs of scene files, with the parameters of their scenes."""
    return Made(lambda name: study_log(load_scene_file(f"workflow/scenes/{name}.yaml")))


@pytest.fixture(scope="session")
def sources(logs, tmp_path_factory):
    """Datasets by the names that figures read them by; times are made up."""
    folder = smoke_results(tmp_path_factory)

    def source(name):
        if name == PUSHES_FILE:
            return measured_pushes()
        stem, _, group = name.partition("/")
        if stem == "simulations":
            return logs[group]
        costs = {"accuracy": accuracy, "accuracy_time": accuracy_time, "hard_cases": hard_cases}
        if stem in costs:
            return costs[stem](group) if group else costs[stem]()
        return pp.open_dataset(
            name, folder, study="sliders" if name.startswith("support") else None
        )

    return Made(source)


@pytest.fixture(scope="session")
def plotted(studies, sources):
    """The datasets of each figure, cut at the values of its study."""

    def view(name):
        figure = entry(name)
        if figure.reads == (PUSHES_FILE,):
            return sources[PUSHES_FILE]
        values = cuts(studies[name], name) if name in NUMBERED else {}
        return {
            each: select_values(sources[each], cuts_of(figure, each, values))
            for each in figure.reads
        }

    return Made(view)


@pytest.fixture(scope="session")
def pictures(plotted):
    """The pictures of figures, with their axes, marks and sheets as `drawn`."""

    def draw(name):
        drawn, one = [], drawing(name)
        spies = {
            kind: lambda *given, add=add: (drawn.append(given), add(*given))
            for kind, add in axes.DRAWERS.items()
        }
        with paper_style(), patch.dict(axes.DRAWERS, spies):
            found = Figure(figsize=one.figure.size)
            one.draw(found, plotted[name])
            found.draw_without_rendering()
        found.drawn = drawn
        return found

    return Made(draw)


@pytest.fixture
def results(sources, tmp_path):
    """A folder of results with what a figure reads."""

    def write(name):
        files = {}
        for each in entry(name).reads:
            stem, _, group = each.partition("/")
            path = f"{stem}/{group}" if stem == "simulations" else stem
            if group and path == stem:
                files.setdefault(path, {})[group] = sources[each]
            else:
                files[path] = sources[each]
        for path, given in files.items():
            write_dataset(given, tmp_path / f"data/{path}.nc")
        return tmp_path

    return write
