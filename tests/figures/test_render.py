"""Selecting, drawing and saving by name."""

import pytest
from matplotlib.figure import Figure

from planar_pushing.figures import render, style
from planar_pushing.figures.parts import arrows, drawing
from planar_pushing.study.figures import ALL, FIGURES, GALLERY
from planar_pushing.study.files.study_model import FigureEntry
from planar_pushing.terms.errors import InvalidValue


def test_an_unknown_figure_is_named():
    with pytest.raises(InvalidValue, match="figure: 'figure_99' given; allowed: figure_01, "):
        render.select("figure_99", "results", FigureEntry())


@pytest.mark.parametrize("name", ALL)
def test_every_entry_names_a_drawing(name):
    found = render.drawing(name)
    assert callable(found.draw)
    assert (name in FIGURES | GALLERY) == hasattr(found, "select")


def test_an_unknown_kind_of_file_is_named(tmp_path):
    with pytest.raises(
        InvalidValue, match=r"a name ending in \.svg, \.pdf, \.png; rename the file"
    ):
        render.save(Figure(), tmp_path / "picture.jpg")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_a_picture_is_saved_with_the_same_bytes_and_without_a_date(tmp_path, kind):
    for name in ("one", "two"):
        with style.paper_style():
            figure = Figure(figsize=(2, 2))
            arrows.force_arrow(drawing.schematic(figure, (0, 1, 0, 1)), (0, 0), (1, 1), "$f$")
            render.save(figure, tmp_path / f"{name}.{kind}")
    first, second = ((tmp_path / f"{name}.{kind}").read_bytes() for name in ("one", "two"))
    assert first == second
    assert b"Date" not in first
    assert b"dc:date" not in first


def test_a_picture_that_cannot_be_drawn_leaves_the_old_one(tmp_path):
    path = tmp_path / "picture.svg"
    path.write_text("old")
    figure = Figure()
    figure.add_axes((0, 0, 1, 1)).text(0, 0, "$\\nosuchcommand$")
    with pytest.raises(ValueError, match="nosuchcommand"):
        render.save(figure, path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
