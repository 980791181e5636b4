"""Properties of every figure, each from the smallest study that shows it."""

from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from matplotlib.collections import LineCollection
from matplotlib.colors import same_color
from matplotlib.patches import ArrowStyle, Circle, FancyArrowPatch, Rectangle
from matplotlib.text import Text

from figures.paper.conftest import GRID, MOTION, SCENES
from planar_pushing.figures import render, style
from planar_pushing.figures.style import paper_style
from planar_pushing.study import store

ALL = [*GRID, *SCENES, *MOTION]
FILLED, OPEN = (ArrowStyle.get_styles()[each] for each in ("-|>", "->"))


@pytest.mark.parametrize("name", ALL)
def test_plotted_numbers_have_units_and_names(plotted, name):
    for key, variable in plotted[name].variables.items():
        assert variable.attrs["units"], key
        assert variable.attrs["long_name"], key
        assert variable.dtype.kind in "bfiU", key
    assert plotted[name].attrs["title"]


@pytest.mark.parametrize("name", [*GRID, *MOTION])
def test_plotted_numbers_name_their_source(plotted, name):
    assert "Lynch and Mason" in plotted[name].attrs["source"]


@pytest.mark.parametrize("name", [*GRID, *SCENES])
def test_plotted_numbers_have_no_gaps(plotted, name):
    for key, variable in plotted[name].variables.items():
        if variable.dtype.kind == "f":
            gaps = np.isnan(variable.values)
            if (name, key) == ("figure_13", "friction_angle"):  # perfect roughness has none
                gaps = gaps != (plotted[name].contact.values == "perfectly_rough")
            assert not gaps.any(), key
            infinite = key == "friction_coefficient" or name in SCENES
            assert infinite or not np.isinf(variable.values).any(), key


@pytest.mark.parametrize("name", ALL)
def test_plotted_numbers_survive_the_file(plotted, name, tmp_path):
    store.write_dataset(plotted[name], tmp_path / "data.nc")
    xr.testing.assert_identical(store.read_dataset(tmp_path / "data.nc"), plotted[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_rendering_twice_gives_the_same_bytes(sources, tmp_path, name):
    for folder in (tmp_path / "a", tmp_path / "b"):
        paths = {kind: folder / f"{name}.{kind}" for kind in ("svg", "pdf", "png")}
        render.render(name, *sources[name], data=folder / f"{name}.nc", **paths)
    for path in sorted((tmp_path / "a").iterdir()):
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes(), path.name
    assert len(list((tmp_path / "a").iterdir())) == 4


def is_clipped(figure, box):
    frame = figure.bbox
    return not (frame.x0 <= box.x0 < box.x1 <= frame.x1 and frame.y0 <= box.y0 < box.y1 <= frame.y1)


@pytest.mark.parametrize("name", GRID)
def test_no_text_is_clipped_or_covered_by_another(pictures, name):
    with paper_style():
        texts = [each for each in pictures[name].findobj(Text) if each.get_visible()]
        boxes = [(each.get_text(), each.get_window_extent()) for each in texts if each.get_text()]
    assert not [text for text, box in boxes if is_clipped(pictures[name], box)]
    for (one, first), (other, second) in combinations(boxes, 2):
        assert not first.padded(-1).overlaps(second.padded(-1)), (one, other)


@pytest.mark.parametrize("name", SCENES)
def test_no_label_covers_another_or_is_clipped(pictures, name):
    with paper_style():
        boxes = [text.get_window_extent() for ax in pictures[name].axes for text in ax.texts]
    assert boxes
    assert not any(is_clipped(pictures[name], box) for box in boxes)
    assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))


@pytest.mark.parametrize("name", [*GRID[:-1], *SCENES])
def test_pictures_keep_right_angles_and_circles(pictures, name):
    for ax in pictures[name].axes:
        (x, y), origin = ax.transData.transform([(1, 1), (0, 0)])
        assert x - origin[0] == pytest.approx(y - origin[1])
        assert ax.get_aspect() == 1.0


@pytest.mark.parametrize("name", SCENES)
def test_forces_have_filled_heads_and_motions_open_ones(pictures, name):
    patches = [patch for ax in pictures[name].axes for patch in ax.patches]
    drawn = [patch for patch in patches if isinstance(patch, FancyArrowPatch)]
    assert drawn
    for patch in drawn:
        is_force = same_color(patch.get_edgecolor(), style.FORCE)
        assert type(patch.get_arrowstyle()) is (FILLED if is_force else OPEN)


@pytest.mark.parametrize("name", MOTION)
def test_picture_of_motion(pictures, name):
    figure = pictures[name]
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
        [False, True, False, True, False] if name == "figure_14" else [False]
    )
