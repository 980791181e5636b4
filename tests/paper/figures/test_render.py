"""Selecting, storing, drawing and saving by name."""

from types import SimpleNamespace

import matplotlib
import pytest
import xarray as xr
from figures.conftest import FIGURES
from matplotlib.figure import Figure

from planar_pushing.drawing.canvas import style
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.figures import render
from pulling_by_pushing.figures.figure import drawing
from pulling_by_pushing.figures.studies import settings
from pulling_by_pushing.study.store import read_dataset

KINDS = ("svg", "pdf", "png")


def paths(folder):
    return {kind: folder / f"picture.{kind}" for kind in KINDS}


def contents(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("call", [drawing, lambda name: render.select(name, "results", None)])
def test_an_unknown_figure_is_one_line_with_the_names_of_all(call):
    with pytest.raises(InvalidValue) as caught:
        call("figure_99")
    names = ", ".join(FIGURES)
    said = f"figure: 'figure_99' given; allowed: {names}; name one of these figures"
    assert str(caught.value) == said


@pytest.mark.parametrize("name", ["figure_08", "figure_15", "figure_16"])
def test_a_figure_stores_its_numbers_and_draws_from_them_alike_twice(
    results, studies, plotted, name
):
    folder = results(name)
    given = settings(studies[name], name)
    for run in ("one", "two"):
        (folder / run).mkdir()
        data = folder / run / f"{name}.nc"
        render.figure(name=name, results=folder, settings=given, marks={"study": "small"}, data=data,
                      **paths(folder / run))  # fmt: skip
    assert contents(folder / "one") == contents(folder / "two")
    assert len(contents(folder / "one")) == 4
    stored = read_dataset(folder / f"one/{name}.nc")
    assert stored.attrs["study"] == "small"
    xr.testing.assert_equal(stored, plotted[name])
    xr.testing.assert_equal(render.select(name, folder, SimpleNamespace(**given)), plotted[name])
    render.file_figure(folder / f"one/{name}.nc", name=name, **paths(folder))
    assert (folder / "picture.svg").read_bytes() == contents(folder / "one")["picture.svg"]


@pytest.mark.parametrize(
    ("name", "variant", "file"),
    [
        ("figure_09", "_column", "figure_09"),
        ("hard_cases", "_column", "data/hard_cases"),
    ],
)
def test_a_variant_is_drawn_from_its_numbers_or_its_one_dataset(
    results, plotted, name, variant, file
):
    folder = results(name)
    write_dataset(plotted[name], folder / f"{name}.nc")
    render.file_figure(folder / f"{file}.nc", name=name, variant=variant, **paths(folder))
    wide, _ = drawing(name).FIGURE.variants[variant]
    assert f'width="{72 * wide:g}pt"' in (folder / "picture.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "name", ["accuracy_wrench", "accuracy_cone_motion", "effects", "hard_cases"]
)
def test_a_figure_on_the_computation_is_drawn_from_its_datasets(results, plotted, name):
    folder = results(name)
    xr.testing.assert_equal(render.select(name, folder, None), plotted[name])
    render.evidence_figure(name=name, results=folder, **paths(folder))
    wide, _ = drawing(name).FIGURE.size
    assert f'width="{72 * wide:g}pt"' in (folder / "picture.svg").read_text(encoding="utf-8")


def test_a_simulation_is_drawn_from_its_log(logs, tmp_path):
    write_dataset(logs["figure_14b"], tmp_path / "log.nc")
    for run in ("one", "two"):
        (tmp_path / run).mkdir()
        render.simulation_figure(tmp_path / "log.nc", **paths(tmp_path / run))
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


def test_an_unknown_kind_of_file_is_named(tmp_path):
    with pytest.raises(InvalidValue) as caught:
        render.save(Figure(), tmp_path / "picture.jpg")
    allowed = "allowed: a name ending in .svg, .pdf, .png; rename the file"
    assert str(caught.value) == f"output: '{tmp_path}/picture.jpg' given; {allowed}"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", KINDS)
def test_a_picture_has_no_date(tmp_path, kind):
    path = tmp_path / f"picture.{kind}"
    render.save_drawn(lambda figure: figure.text(0.5, 0.5, "$f$"), (2.0, 2.0), [path])
    assert b"Date" not in path.read_bytes()
    assert b"dc:date" not in path.read_bytes()


def test_a_picture_that_cannot_be_drawn_leaves_the_old_one(tmp_path):
    path = tmp_path / "picture.svg"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(ValueError, match="nosuchcommand"):
        render.save_drawn(lambda figure: figure.text(0, 0, "$\\nosuchcommand$"), (2.0, 2.0), [path])
    assert path.read_text(encoding="utf-8") == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_the_style_does_not_depend_on_the_user_and_leaves_nothing_behind():
    with matplotlib.rc_context({"lines.linewidth": 9.0, "svg.hashsalt": None}):
        with style.paper_style():
            assert matplotlib.rcParams["lines.linewidth"] == 1.2
            assert matplotlib.rcParams["svg.hashsalt"] == "planar-pushing"
        assert matplotlib.rcParams["lines.linewidth"] == 9.0
