"""What holds of every figure, each from the smallest study that shows it."""

from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from matplotlib.collections import LineCollection
from matplotlib.colors import same_color
from matplotlib.patches import ArrowStyle, Circle, FancyArrowPatch, Rectangle
from matplotlib.text import Text

from figures.paper.conftest import GRID, SCENES
from planar_pushing.figures import render, style
from planar_pushing.figures.style import paper_style
from planar_pushing.study import store
from planar_pushing.study.models import FigureEntry


@pytest.mark.parametrize("name", GRID)
def test_plotted_numbers_have_units_and_names_and_no_gaps(plotted, name):
    for key, variable in plotted[name].variables.items():
        assert variable.attrs["units"], key
        assert variable.attrs["long_name"], key
        if variable.dtype.kind == "f" and key != "friction_coefficient":
            assert np.isfinite(variable.values).all(), key
    assert plotted[name].attrs["title"]
    assert "Lynch and Mason" in plotted[name].attrs["source"]


@pytest.mark.parametrize("name", GRID)
def test_plotted_numbers_survive_the_file(plotted, name, tmp_path):
    store.write_dataset(plotted[name], tmp_path / "data.nc")
    xr.testing.assert_identical(store.read_dataset(tmp_path / "data.nc"), plotted[name])


@pytest.mark.parametrize("name", [*GRID, *SCENES])
def test_rendering_twice_gives_the_same_bytes(study, grid_results, scene_results, tmp_path, name):
    results = grid_results if name in GRID else scene_results
    settings = study.figures[name] if name in GRID else FigureEntry()
    for folder in (tmp_path / "a", tmp_path / "b"):
        paths = {kind: folder / f"{name}.{kind}" for kind in ("svg", "pdf", "png")}
        render.render(name, results, settings, data=folder / f"{name}.nc", **paths)
    for path in sorted((tmp_path / "a").iterdir()):
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes(), path.name
    assert len(list((tmp_path / "a").iterdir())) == 4


@pytest.mark.parametrize("name", GRID)
def test_no_text_is_clipped_or_covered_by_another(pictures, name):
    figure = pictures[name]
    with paper_style():
        figure.draw_without_rendering()
        texts = [each for each in figure.findobj(Text) if each.get_visible() and each.get_text()]
        boxes = [(each.get_text(), each.get_window_extent()) for each in texts]
    for text, box in boxes:
        assert figure.bbox.x0 <= box.x0, text
        assert box.x1 <= figure.bbox.x1, text
        assert figure.bbox.y0 <= box.y0, text
        assert box.y1 <= figure.bbox.y1, text
    for (one, first), (other, second) in combinations(boxes, 2):
        assert not first.padded(-1).overlaps(second.padded(-1)), (one, other)


@pytest.mark.parametrize("name", GRID[:-1])
def test_pictures_keep_right_angles_and_circles(pictures, name):
    assert all(ax.get_aspect() == 1.0 for ax in pictures[name].axes)


FILLED, OPEN = (ArrowStyle.get_styles()[each] for each in ("-|>", "->"))


def arrows(figure):
    return [p for ax in figure.axes for p in ax.patches if isinstance(p, FancyArrowPatch)]


@pytest.mark.parametrize("data", SCENES, indirect=True)
def test_the_data_are_numbers_with_units_and_names(data):
    for name, variable in data.variables.items():
        assert {"units", "long_name"} <= set(variable.attrs), name
        assert variable.dtype.kind in "fiU", name
        assert variable.dtype.kind != "f" or not np.isnan(variable.values).any(), name
    assert data.attrs["title"]


@pytest.mark.parametrize("picture", SCENES, indirect=True)
def test_forces_have_filled_heads_and_motions_open_ones(picture):
    drawn = arrows(picture)
    assert drawn
    for patch in drawn:
        is_force = same_color(patch.get_edgecolor(), style.FORCE)
        assert type(patch.get_arrowstyle()) is (FILLED if is_force else OPEN)


@pytest.mark.parametrize("picture", SCENES, indirect=True)
def test_the_axes_have_equal_aspect(picture):
    for ax in picture.axes:
        (x, y), origin = ax.transData.transform([(1, 1), (0, 0)])
        assert x - origin[0] == pytest.approx(y - origin[1])


@pytest.mark.parametrize("picture", SCENES, indirect=True)
def test_no_label_covers_another_or_is_clipped(picture):
    frame = picture.bbox
    boxes = [text.get_window_extent() for ax in picture.axes for text in ax.texts]
    assert boxes
    for number, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:number])
        assert frame.x0 <= box.x0 < box.x1 <= frame.x1
        assert frame.y0 <= box.y0 < box.y1 <= frame.y1


def test_plotted_motions_have_units_and_names(motions):
    for name, dataset in motions.items():
        for key, variable in dataset.variables.items():
            assert variable.attrs["units"], (name, key)
            assert variable.attrs["long_name"], (name, key)
        assert "Lynch and Mason" in dataset.attrs["source"]
        assert dataset.attrs["title"]


@pytest.mark.parametrize("name", ["figure_14", "figure_15"])
def test_picture_of_motion(motions, name):
    with paper_style():
        figure = render.picture(name, motions[name])
        figure.canvas.draw()
    sketches = [ax for ax in figure.axes if any(isinstance(p, Circle) for p in ax.patches)]
    assert len(sketches) == (2 if name == "figure_14" else 1)
    for ax in sketches:
        rings = [patch for patch in ax.patches if isinstance(patch, Circle)]
        assert len(rings) == (4 if name == "figure_14" else 5)
        assert len({ring.get_edgecolor() for ring in rings}) == len(rings)
        assert any(isinstance(each, LineCollection) for each in ax.collections)
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        for ring in rings:
            x, y = ring.center
            assert left <= x - 1 < x + 1 <= right
            assert bottom <= y - 1 < y + 1 <= top
    strips = [p for p in figure.axes[-1].patches if isinstance(p, Rectangle)]
    assert [bool(strip.get_hatch()) for strip in strips] == (
        [False, True, False, True] if name == "figure_14" else [False]
    )
