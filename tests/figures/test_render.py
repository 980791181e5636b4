"""Selecting, drawing and saving by name."""

import subprocess
import sys

import pytest
from matplotlib.figure import Figure

from planar_pushing.figures import render, style
from planar_pushing.figures.parts import arrows, drawing
from planar_pushing.study.figures import ALL, FIGURES, GALLERY
from planar_pushing.study.files.models import FigureEntry
from planar_pushing.study.running.dependencies import modules
from planar_pushing.terms.errors import InvalidValue


def test_an_unknown_figure_is_named():
    with pytest.raises(InvalidValue, match="figure: 'figure_99' given; allowed: figure_01, "):
        render.select("figure_99", "results", FigureEntry())


@pytest.mark.parametrize("name", ALL)
def test_every_entry_names_a_drawing(name):
    found = render.drawing(name)
    assert callable(found.draw)
    assert (name in FIGURES | GALLERY) == hasattr(found, "select")


#: Prints, for each figure, our modules that its drawing imports, in a copy of a process that has none yet.
IMPORTED = """
import os, sys
import matplotlib.figure, numba, scipy.special, xarray
for name in sys.argv[1:]:
    sys.stdout.flush()
    if os.fork() == 0:
        from planar_pushing.figures import render
        render.drawing(name)
        found = [key for key, module in sys.modules.items() if not hasattr(module, "__path__")]
        print(name, *(key for key in found if key.startswith("planar_pushing.")), flush=True)
        os._exit(0)
    os.wait()
"""


def test_a_drawing_imports_nothing_that_the_digest_of_its_job_does_not_see():
    names = ["figure_06", "figure_11", "figure_15", "figure_19", "accuracy_motion"]
    command = [sys.executable, "-c", IMPORTED, *names]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    loaded = {name: set(found) for name, *found in map(str.split, said.splitlines())}
    assert list(loaded) == names
    for name, found in loaded.items():
        assert f"planar_pushing.{ALL[name].modules[1]}" in found
        assert found <= set(modules(*ALL[name].modules)), name


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
