import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import ArrowStyle, FancyArrowPatch

from planar_pushing.figures import render, style
from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.labels import declutter
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.study.models import FigureEntry


@pytest.fixture
def ax():
    return drawing.schematic(Figure(figsize=(3, 3)), (-2, 2, -1, 3))


def heads(ax):
    return [type(p.get_arrowstyle()) for p in ax.patches if isinstance(p, FancyArrowPatch)]


def line_ends(ax, number=-1):
    return np.asarray(ax.lines[number].get_xydata())[[0, -1]]


def test_a_force_has_a_filled_head(ax):
    patch = arrows.force_arrow(ax, (0, 0), (1, 1), "f")
    assert isinstance(patch.get_arrowstyle(), ArrowStyle.get_styles()["-|>"])
    assert matplotlib.colors.same_color(patch.get_facecolor(), style.FORCE)


def test_motions_have_open_heads(ax):
    arrows.motion_arrow(ax, (0, 0), (1, 1), "v")
    arrows.turning(ax, (0, 0), 1, 0.5)
    arrows.coordinate_axes(ax, (0, 0), 0, 1, ("x", "y"))
    assert heads(ax) == 4 * [ArrowStyle.get_styles()["->"]]


@pytest.mark.parametrize("angle", [-170.0, -90.0, 0.0, 33.0, 180.0])
@pytest.mark.parametrize("arrow", [arrows.force_arrow, arrows.motion_arrow])
def test_an_arrow_keeps_its_direction_exactly(ax, arrow, angle):
    patch = arrow(ax, (0.3, 0.2), 1.5 * arrows.unit(angle))
    ends = patch.get_path().vertices[:2]
    along = ends[1] - ends[0]
    assert ends[0] == pytest.approx([0.3, 0.2])
    assert np.hypot(*along) * arrows.unit(angle) == pytest.approx(along)


@pytest.mark.parametrize(("sense", "side"), [(1.0, -1.0), (-1.0, 1.0)])
def test_a_turn_to_the_left_ends_on_the_left(ax, sense, side):
    shaft = arrows.turning(ax, (0, 0), sense, 0.5).get_path().vertices
    assert np.sign(shaft[0, 0]) == -side


@pytest.mark.parametrize("size", [(3.4, 2.0), (2.0, 5.0), (7.0, 7.0)])
def test_a_schematic_has_equal_aspect_and_shows_its_box(size):
    figure = Figure(figsize=size)
    ax = drawing.schematic(figure, (-2, 4, 0, 1), pad=10)
    (x0, y0), (x1, y1) = ax.transData.transform([(-2, 0), (4, 1)])
    assert (x1 - x0) / 6 == pytest.approx(y1 - y0)
    margin = 10 / 72 * figure.dpi - 1e-6
    width, height = size[0] * figure.dpi, size[1] * figure.dpi
    assert margin <= x0 < x1 <= width - margin
    assert margin <= y0 < y1 <= height - margin


def test_a_cone_spans_from_its_right_to_its_left_edge(ax):
    wedge = drawing.cone(ax, (0, 0), -20, 140, 0.5, style.MOTION)
    assert (wedge.theta1, wedge.theta2, wedge.r) == (-20, 140, 0.5)
    assert line_ends(ax)[1] == pytest.approx(0.5 * arrows.unit(140))


def test_a_cone_of_one_direction_is_a_line(ax):
    wedge = drawing.cone(ax, (0, 0), 90, 90, 0.5, style.FORCE)
    assert np.ptp(wedge.get_path().vertices[:, 0]) == pytest.approx(0, abs=1e-12)
    assert len(ax.lines) == 2


@pytest.mark.parametrize("left", [270, 300])
def test_a_cone_of_every_direction_has_no_edges(ax, left):
    wedge = drawing.cone(ax, (0, 0), -90, left, 0.5, style.FORCE)
    assert (wedge.theta1, wedge.theta2) == (0, 360)
    assert not ax.lines


@pytest.mark.parametrize(("start", "stop"), [(0, 45), (10, -30), (0, 0)])
def test_an_arc_joins_its_two_angles(ax, start, stop):
    drawing.angle_arc(ax, (1, 1), start, stop, 0.5, "a")
    assert line_ends(ax) == pytest.approx(
        np.array([1 + 0.5 * arrows.unit(start), 1 + 0.5 * arrows.unit(stop)])
    )


def test_the_fence_is_hatched_below_its_edge(ax):
    drawing.fence(ax, -1, 2, depth=0.1)
    strokes = np.array(ax.collections[0].get_segments())
    assert strokes[:, 0, 1] == pytest.approx(0)
    assert strokes[:, 1, 1] == pytest.approx(-0.1)
    assert strokes[..., 0].min() >= -1 - 1e-12
    assert line_ends(ax).tolist() == [[-1, 0], [2, 0]]


def test_the_slider_has_ring_rod_and_contact(ax):
    drawing.slider(ax, (1, 1), 0.8)
    assert ax.patches[0].radius == 0.8
    assert ax.patches[0].center == (1, 1)
    assert line_ends(ax, 0).tolist() == [[0, 0], [1, 1]]


def boxes(ax):
    return [text.get_window_extent() for text in ax.texts]


def test_decluttering_parts_labels_that_cover_each_other(ax):
    for _ in range(4):
        labels.label(ax, (0, 0), "label", offset=(9, 0))
    declutter(ax)
    found = boxes(ax)
    assert not any(a.overlaps(b) for i, a in enumerate(found) for b in found[:i])


def test_decluttering_moves_a_label_off_an_arrow_and_into_the_frame(ax):
    arrows.force_arrow(ax, (0, 0), (0, 2))
    text = labels.label(ax, (0, 1), "on the shaft", offset=(0, 9))
    edge = labels.label(ax, (ax.get_xlim()[1], 1), "edge", offset=(9, 0))
    declutter(ax)
    low, high = (
        ax.transData.inverted().transform(p) for p in text.get_window_extent().get_points()
    )
    assert low[0] > 0 or high[0] < 0
    assert edge.get_window_extent().x1 <= ax.get_window_extent().x1


def test_decluttering_leaves_labels_without_an_offset_and_free_ones(ax):
    fixed = labels.label(ax, (0, 0), "a")
    free = labels.label(ax, (1, 1), "b", offset=(0, 9))
    declutter(ax)
    assert fixed.xyann == (0, 0)
    assert free.xyann == pytest.approx((0, 9))


def test_the_style_does_not_depend_on_the_user_and_leaves_nothing_behind():
    with matplotlib.rc_context({"lines.linewidth": 9.0, "svg.hashsalt": None}):
        with style.paper_style():
            assert matplotlib.rcParams["lines.linewidth"] == 1.2
            assert matplotlib.rcParams["svg.hashsalt"] == "planar-pushing"
        assert matplotlib.rcParams["lines.linewidth"] == 9.0


def test_all_text_is_readable_at_column_width():
    with style.paper_style():
        sizes = [v for k, v in matplotlib.rcParams.items() if k in ("font.size", "xtick.labelsize")]
    assert min([*sizes, style.SYMBOL_SIZE, style.NOTE_SIZE]) >= 7


def test_an_unknown_figure_is_named():
    with pytest.raises(InvalidValue, match="figure: 'figure_99' given; allowed: figure_01, "):
        render.select("figure_99", "results", FigureEntry())


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
