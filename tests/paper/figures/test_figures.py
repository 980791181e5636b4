"""Properties of every figure: what it plots, and that its pictures are legible."""

from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from figures.conftest import FIGURES, NUMBERED, PICTURES
from matplotlib.text import Text

from planar_pushing.drawing.canvas.colors import FORCE, GUIDE, MOTION, tint
from planar_pushing.drawing.canvas.marks import Arrow
from planar_pushing.drawing.canvas.style import COLUMN, PAGE, paper_style
from pulling_by_pushing.figures import render
from pulling_by_pushing.figures.figure import drawing, entry
from pulling_by_pushing.figures.studies import OURS
from pulling_by_pushing.study import store

#: Drawn by marks alone, to one scale along both axes.
SCHEMATIC = [
    f"figure_{number}"
    for number in ("01", "02", "03", "04", "05", "06", "07", "08", "09", "10", "11", "12")
]
#: Text may leave the figure by this much, points: boxes of letters are larger than the letters.
CUT = 2.0


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_is_one_module(name):
    found, figure = drawing(name), entry(name)
    assert callable(found.draw)
    assert hasattr(found, "select") == (name in NUMBERED or len(figure.reads) > 1)
    assert callable(found.caption)
    assert set(FIGURES) == {*NUMBERED, *OURS}
    assert figure.title
    assert bool(figure.section) == (name in NUMBERED)
    assert bool(figure.promise) == (name <= "figure_12" and name in NUMBERED)
    assert figure.size[0] in (COLUMN, PAGE)
    assert name not in NUMBERED or (figure.column is not None) == (figure.size[0] == PAGE)
    assert figure.column is None or figure.column[0] == COLUMN


@pytest.mark.parametrize("name", NUMBERED)
def test_plotted_numbers_have_units_names_and_a_source(plotted, name):
    data = plotted[name]
    for key, variable in data.variables.items():
        assert variable.attrs["long_name"], key
        if "units" in variable.attrs:
            assert variable.attrs["units"], key
        else:  # each component has its own
            assert all(data[variable.attrs["component_units"]].values), key
        assert variable.dtype.kind in "bfiU", key
    assert data.attrs["title"]
    assert "Lynch and Mason" in data.attrs["source"] or name == "figure_19"


@pytest.mark.parametrize("name", NUMBERED)
def test_plotted_numbers_have_no_gaps(plotted, name):
    for key, variable in plotted[name].variables.items():
        if variable.dtype.kind == "f":
            gaps = np.isnan(variable.values)
            if (name, key) == ("figure_13", "friction_angle"):  # perfect roughness has none
                gaps = gaps != (plotted[name].contact.values == "perfectly_rough")
            assert not gaps.any() or key == "path_center", key
            scene = "mode" in plotted[name]
            infinite = scene or key == "friction_coefficient"
            assert infinite or not np.isinf(variable.values).any(), key


@pytest.mark.parametrize("name", NUMBERED)
def test_plotted_numbers_survive_the_file(plotted, name, tmp_path):
    store.write_dataset(plotted[name], tmp_path / "data.nc")
    xr.testing.assert_identical(store.read_dataset(tmp_path / "data.nc"), plotted[name])


def texts(figure):
    """The texts that are drawn, and their boxes in points."""
    hidden = set()
    for ax in figure.axes:
        for axis in (ax.xaxis, ax.yaxis):
            low, high = sorted(axis.get_view_interval()) if ax.axison else (1, 0)
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if not low - 1e-9 * (high - low) <= tick.get_loc() <= high + 1e-9 * (high - low):
                    hidden |= {tick.label1, tick.label2}
    found = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text()]
    inches = figure.dpi_scale_trans.inverted()
    with paper_style():
        boxes = [text.get_window_extent().transformed(inches) for text in found]
    return [(t, 72 * b.get_points()) for t, b in zip(found, boxes, strict=True) if t not in hidden]


@pytest.mark.parametrize("name", PICTURES)
def test_no_text_is_cut_small_or_on_another(pictures, name):
    figure = pictures[name]
    size, found = 72 * figure.get_size_inches(), texts(figure)
    assert np.isfinite(size).all()
    assert found
    cut = [
        text.get_text()
        for text, (low, high) in found
        if (low < -CUT).any() or (high > size + CUT).any()
    ]
    assert not cut
    assert min(text.get_fontsize() for text, _ in found) >= 6.5
    for (one, first), (other, second) in combinations(found, 2):
        covered = ((first[0] + 1 < second[1] - 1) & (second[0] + 1 < first[1] - 1)).all()
        assert not covered, (one.get_text(), other.get_text())


@pytest.mark.parametrize(
    "name", [name for name in PICTURES if name.removesuffix("_column") in SCHEMATIC]
)
def test_pictures_keep_right_angles_and_circles(pictures, name):
    for ax in pictures[name].axes:
        (x, y), origin = ax.transData.transform([(1, 1), (0, 0)])
        assert x - origin[0] == pytest.approx(y - origin[1])


@pytest.mark.parametrize(
    "name", sorted({*SCHEMATIC, "figure_14", "figure_15", "figure_19"} - {"figure_07"})
)
def test_forces_have_filled_heads_and_motions_open_ones(pictures, name):
    arrows = [mark for _, mark, _ in pictures[name].drawn if isinstance(mark, Arrow)]
    forces = {FORCE, *(tint(FORCE, strength) for strength in np.linspace(0.3, 1.0, 701))}
    assert arrows
    for arrow in arrows:
        is_force = arrow.color in forces
        measures = name == "figure_04" and arrow.color == GUIDE
        assert arrow.filled == (is_force or measures), arrow
        assert not (arrow.color == MOTION and arrow.filled)


@pytest.mark.slow
@pytest.mark.parametrize("name", PICTURES)
def test_pictures_have_the_same_bytes_twice(plotted, name, tmp_path):
    stem = name.removesuffix("_column")
    found = []
    for run in "ab":
        paths = [tmp_path / run / f"picture.{kind}" for kind in ("svg", "pdf", "png")]
        render.save_drawn(
            lambda figure: drawing(stem).draw(figure, plotted[stem]),
            entry(stem).variants[name.removeprefix(stem)], paths,
        )  # fmt: skip
        found.append([path.read_bytes() for path in paths])
    assert found[0] == found[1]
