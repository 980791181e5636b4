"""Viewing, drawing and saving by name."""

from pathlib import Path

import matplotlib
import pytest
import xarray as xr
from figures.conftest import FIGURES
from matplotlib.figure import Figure

from planar_pushing.drawing.canvas import style
from planar_pushing.terms.errors import InvalidFile, InvalidValue
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.figures import render
from pulling_by_pushing.figures.figure import drawing, files, view
from pulling_by_pushing.figures.studies import cuts

KINDS = ("svg", "pdf", "png")


def paths(folder):
    return {kind: folder / f"picture.{kind}" for kind in KINDS}


def draw(results, folder, **pictures):
    """Draw one picture into a folder, in each format."""
    files = {kind: [path] for kind, path in paths(folder).items()}
    render.draw_figures(results=results, **pictures, **files)


def contents(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("call", [drawing, lambda name: view(name, "results")])
def test_an_unknown_figure_is_one_line_with_the_names_of_all(call):
    with pytest.raises(InvalidValue) as caught:
        call("figure_99")
    names = ", ".join(FIGURES)
    said = f"figure: 'figure_99' given; allowed: {names}; did you mean figure_09?"
    assert str(caught.value) == said


@pytest.mark.parametrize("name", [
    "figure_07", "figure_08", "slip_over_time", "hard_cases",
    pytest.param("figure_10", marks=pytest.mark.slow),
])  # fmt: skip
def test_a_figure_is_drawn_from_its_datasets_alike_twice(results, studies, plotted, name):
    folder = results(name)
    given = cuts(studies[name], name) if name in studies else {}
    assert all(Path(file).is_file() for file in files(name, folder))
    for source, dataset in view(name, folder, given).items():
        xr.testing.assert_equal(dataset, plotted[name][source])
    for run in ("one", "two"):
        (folder / run).mkdir()
        draw(folder, folder / run, figures={name: given})
    assert contents(folder / "one") == contents(folder / "two")
    wide, _ = drawing(name).figure.size
    assert f'width="{72 * wide:g}pt"' in (folder / "one/picture.svg").read_text(encoding="utf-8")


def test_a_simulation_is_drawn_from_its_log(logs, tmp_path):
    (tmp_path / "data/simulations").mkdir(parents=True)
    write_dataset(logs["pulling_lost"], tmp_path / "data/simulations/pulling_lost.nc")
    for run in ("one", "two"):
        (tmp_path / run).mkdir()
        draw(tmp_path, tmp_path / run, figures={}, simulations=["pulling_lost"])
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


def test_the_log_of_a_job_names_the_figure_that_fails(tmp_path, caplog):
    caplog.set_level("INFO", logger="planar_pushing")
    with pytest.raises(InvalidFile):
        draw(tmp_path, tmp_path, figures={"figure_05": {}})
    assert caplog.messages == ["drawing figure_05"]


def test_an_unknown_kind_of_file_is_named(tmp_path):
    with pytest.raises(InvalidValue) as caught:
        style.save(Figure(), tmp_path / "picture.jpg")
    allowed = "allowed: a name ending in .svg, .pdf, .png; rename the file"
    assert str(caught.value) == f"output: '{tmp_path}/picture.jpg' given; {allowed}"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", KINDS)
def test_a_picture_has_no_date(tmp_path, kind):
    path = tmp_path / f"picture.{kind}"
    style.save_drawn(lambda figure: figure.text(0.5, 0.5, "$f$"), (2.0, 2.0), [path])
    assert b"Date" not in path.read_bytes()
    assert b"dc:date" not in path.read_bytes()


def test_a_picture_that_cannot_be_drawn_leaves_the_old_one(tmp_path):
    path = tmp_path / "picture.svg"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(ValueError, match="nosuchcommand"):
        style.save_drawn(lambda figure: figure.text(0, 0, "$\\nosuchcommand$"), (2.0, 2.0), [path])
    assert path.read_text(encoding="utf-8") == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_the_style_does_not_depend_on_the_user_and_leaves_nothing_behind():
    with matplotlib.rc_context({"lines.linewidth": 9.0, "svg.hashsalt": None}):
        with style.paper_style():
            assert matplotlib.rcParams["lines.linewidth"] == 1.2
            assert matplotlib.rcParams["svg.hashsalt"] == "planar-pushing"
        assert matplotlib.rcParams["lines.linewidth"] == 9.0
