"""Marks: the same geometry from both renderers."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.spines import Spine

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.labels import settle
from planar_pushing.drawing.canvas.marks import (
    DASHES,
    SHAPES,
    Area,
    Arrow,
    Hatch,
    Label,
    Line,
    Picture,
    Sheet,
    corners,
    unit,
)
from planar_pushing.drawing.canvas.panels import EDGE, GAP, TITLE, Panel, Texts, crop, panels
from planar_pushing.drawing.canvas.svg import text, to_svg

SIZE, BOX = (210.0, 150.0), np.array([(-2.0, -1.0), (3.0, 2.5)])
SHEET = Sheet.around(BOX, SIZE)
RED, BLUE = "#aa0000", "#0000aa"
SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])


def picture(add, *args, **options):
    found = Picture()
    getattr(found, add)(*args, **options)
    return found


def axes(drawn, size=SIZE, pad=12.0):
    """Axes of a figure that has a pixel a point, with the marks."""
    ax = schematic(Figure(figsize=np.array(size) / 72, dpi=72))
    to_axes(drawn, ax, BOX, pad)
    return ax


def svg(drawn, **options):
    """Elements of the SVG."""
    root = ElementTree.fromstring(to_svg(drawn, BOX, SIZE, **options))
    return [each for each in root.iter() if each is not root]


def tag(element):
    return element.tag.partition("}")[2]


def opened(points):
    """Points on the sheet, without the first again at the end."""
    points = np.asarray(points, dtype=float)
    return points[:-1] if len(points) > 1 and np.allclose(points[0], points[-1]) else points


def of_matplotlib(ax):
    """Points on the sheet of every artist, whether it is an area, its color, and the width of its line."""
    for each in ax.get_children():
        if isinstance(each, Spine):
            return
        if isinstance(each, Patch):
            path, color = each.get_transform().transform_path(each.get_path()), each.get_facecolor()
            path.should_simplify = False
            rings, width = path.to_polygons(closed_only=False), 0.0
        elif isinstance(each, Line2D):
            rings, color = [ax.transData.transform(each.get_xydata())], each.get_color()
            width = each.get_linewidth()
        elif isinstance(each, LineCollection):
            rings, color = map(ax.transData.transform, each.get_segments()), each.get_color()[0]
            width = each.get_linewidth()[0]
        else:
            continue
        yield [opened(ring) * [1, -1] + [0, SIZE[1]] for ring in rings], color, width


def of_svg(drawn):
    for each in svg(drawn):
        width = float(each.get("stroke-width", 0)) if each.get("fill") == "none" else 0.0
        color = each.get("stroke") if width else each.get("fill")
        if tag(each) == "circle":
            x, y, radius = (float(each.get(key)) for key in ("cx", "cy", "r"))
            yield [SHAPES["o"][0][0] * radius + [x, y]], color, width
        elif tag(each) == "path":
            rings = re.findall("M([^M]+)", each.get("d"))
            numbers = [re.findall(r"-?[\d.]+", ring) for ring in rings]
            yield (
                [opened(np.reshape(ring, (-1, 2)).astype(float)) for ring in numbers],
                color,
                width,
            )


def apart(one, other):
    """Largest distance of a point of either set from the other set."""
    gaps = np.hypot(*np.moveaxis(one[:, None] - other[None], -1, 0))
    return max(gaps.min(axis=0).max(), gaps.min(axis=1).max())


MARKS = {
    "area": picture("area", SQUARE, color=RED),
    "area with holes": picture("area", SQUARE, 0.5 + SQUARE / 4, 1.2 + SQUARE / 4, color=RED),
    "line": picture("line", SQUARE, RED, width=2.0),
    "dashed line": picture("line", SQUARE, RED, width=2.0, dash="--"),
    "guide": picture("guide", (0, 0), (1, 2)),
    "hatch": picture("add", Hatch(np.stack([SQUARE, SQUARE - 0.2], axis=1), RED)),
    "force": picture("force", (-1, 0.5), (2.0, 1.5)),
    "short force": picture("force", (0, 0), (0.1, -0.05)),
    "motion": picture("motion", (-1, 0.5), (2.0, -1.0), dash="--"),
    "turn": picture("turn_arrow", (1, 1), 1.0, 0.8, RED),
    "disc": picture("dot", (1.5, 1.0), 20.0, RED),
    "mass": picture("dot", (1.5, 1.0), 20.0, RED, edge=BLUE, shape="mass"),
    "pressure": picture("dot", (1.5, 1.0), 20.0, RED, shape="pressure"),
    "burst": picture("dot", (1.5, 1.0), 20.0, RED, shape="burst"),
    "cone": picture("cone", -0.3, 2.0, 1.0, RED, apex=(0.5, 0.5)),
    "every direction": picture("cone", 0.0, 2 * np.pi, 1.0, RED),
    "angle": picture("angle", 0.2, 1.2, 0.7, r"$\phi$"),
    "axis": picture("axis", (0, 0), 0.5, 1.0, "$x$"),
    "scale": picture("scale_bar", (0, 0), 1.0, "1"),
}


@pytest.mark.parametrize("name", MARKS)
def test_both_renderers_draw_the_same(name):
    found, expected = list(of_matplotlib(axes(MARKS[name]))), list(of_svg(MARKS[name]))
    assert len(found) == len(expected) > 0
    for (rings, color, width), (others, other, wide) in zip(found, expected, strict=True):
        assert same_color(color, other)
        assert width == pytest.approx(wide, abs=0.005)
        assert len(rings) == len(others)
        for one, ring in zip(rings, others, strict=True):
            assert apart(one, ring) < 0.1


@pytest.mark.parametrize("align", ["left", "center", "right"])
@pytest.mark.parametrize("words", ["one", "two\nrows"])
def test_labels_stand_in_the_same_place(align, words):
    drawn = picture("label", (0.5, 1.0), words, align=align, offset=(12.0, 7.0), color=RED)
    drawn.line([(0.0, 1.3), (3.0, 1.3)])  # which it may move off
    ax = axes(drawn)
    (annotation,) = ax.texts
    x, y = ax.transData.transform(annotation.xy) + annotation.xyann
    found, *rows = (each for each in svg(drawn) if tag(each) in ("text", "tspan"))
    assert [float(found.get(key)) for key in "xy"] == pytest.approx([x, SIZE[1] - y], abs=0.1)
    assert found.get("text-anchor") == {"left": "start", "center": "middle", "right": "end"}[align]
    assert annotation.get_horizontalalignment() == align
    assert [row.text for row in rows] == words.split("\n")
    box = annotation.get_window_extent()
    assert (box.y0 + box.y1) / 2 == pytest.approx(y, abs=1.0)
    edges = {"left": box.x0, "center": (box.x0 + box.x1) / 2, "right": box.x1}
    assert edges[align] == pytest.approx(x, abs=1.0)


@pytest.mark.parametrize(("dash", "is_dashed"), [("", False), ("--", True), (":", True)])
def test_a_dash_is_drawn_by_both(dash, is_dashed):
    drawn = picture("line", SQUARE, RED, width=2.0, dash=dash)
    (line,), (path,) = axes(drawn).lines, svg(drawn, point=1.5)
    assert line.is_dashed() == is_dashed
    parts = path.get("stroke-dasharray", "").split()
    assert [float(part) for part in parts] == pytest.approx([3.0 * each for each in DASHES[dash]])


def test_a_hatched_area_has_a_pattern_of_its_ink():
    drawn = picture("area", SQUARE, color=RED, hatch="///", ink=BLUE)
    (patch,) = axes(drawn).patches
    assert patch.get_hatch() == "///"
    assert same_color(patch.get_edgecolor(), BLUE)
    _, pattern, strokes, fill, hatch = svg(drawn)
    assert strokes.get("stroke") == BLUE
    assert (fill.get("fill"), hatch.get("fill")) == (RED, f"url(#{pattern.get('id')})")


def test_marks_of_a_higher_order_cover_the_others():
    drawn = Picture()
    for order in (5.0, 1.0, 3.0):
        drawn.area(SQUARE, color=f"#00000{order:.0f}", order=order)
    drawn.force((0, 0), (1, 1), order=2.0, color="#000002")
    drawn.label((0, 0), "a", order=4.0, color="#000004")
    fills = [each.get("fill") for each in svg(drawn) if each.get("fill", "none") != "none"]
    assert fills == [f"#00000{order}" for order in range(1, 6)]
    ax = axes(drawn)
    for each in (*ax.patches, *ax.texts):
        color = each.get_color() if each in ax.texts else each.get_facecolor()
        assert same_color(color, f"#00000{each.get_zorder():.0f}")


# -- sheets ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", [(244.8, 144.0), (144.0, 360.0), (504.0, 504.0)])
def test_axes_show_the_box_to_one_scale_with_points_around_it(size):
    ax = axes(Picture(), size, pad=10.0)
    (x0, y0), (x1, y1) = ax.transData.transform(BOX)
    assert (x1 - x0) / np.ptp(BOX[:, 0]) == pytest.approx((y1 - y0) / np.ptp(BOX[:, 1]))
    assert min(x0, y0, size[0] - x1, size[1] - y1) == pytest.approx(10.0)


def test_a_sheet_and_the_scene_map_to_each_other():
    sheet = Sheet.around(BOX, SIZE, pad=5.0, point=1.5)
    places = np.random.default_rng(1).uniform(-3, 3, (4, 5, 2))
    assert sheet.to_scene(sheet.to_sheet(places)) == pytest.approx(places)
    assert sheet.to_sheet(sheet.box) == pytest.approx(np.array([(0, SIZE[1]), (SIZE[0], 0)]))
    assert sheet.to_sheet(sheet.middle) == pytest.approx(np.array(SIZE) / 2)
    low, high = sheet.to_sheet(BOX)
    assert min(low[0], high[1]) == pytest.approx(7.5)
    assert np.diff(sheet.to_sheet([(0, 0), (sheet.unit, 0)]), axis=0) == pytest.approx(
        np.array([[1.5, 0]])
    )


def test_a_figure_is_as_high_as_its_panels():
    figure = Figure(figsize=(5.0, 1.0), dpi=72)
    square = picture("area", SQUARE, color=RED)
    panels(figure, [Panel(square, title) for title in ("one", "two", "three")], 2)
    side = (360 - 2 * EDGE - GAP) / 2
    assert 72 * figure.get_figheight() == pytest.approx(2 * (EDGE + TITLE + side) + GAP)
    assert [text.get_text() for text in figure.texts] == ["one", "two", "three"]


def tall(low, high, wide=1.0):
    """A picture of a rectangle."""
    return picture("area", [(0, low), (wide, low), (wide, high), (0, high)], color=RED)


def test_panels_of_a_row_show_the_line_of_the_fence_at_one_height():
    figure = Figure(figsize=(5.0, 1.0), dpi=72)
    drawn = panels(figure, [Panel(tall(-1, 2)), Panel(tall(0, 1)), Panel(tall(-3, -1))], 3)
    levels = [float(ax.transData.transform((0, 0))[1]) for ax in drawn]
    assert levels == pytest.approx([levels[0]] * 3)


def test_panels_with_one_name_of_a_scale_share_it():
    figure = Figure(figsize=(5.0, 1.0), dpi=72)
    rows = [Panel(tall(0, 1), scale="a"), Panel(tall(0, 1, 2.0)), Panel(tall(0, 1, 4.0), scale="a")]
    widths = [
        np.ptp(ax.transData.transform([(0, 0), (1, 0)])[:, 0]) for ax in panels(figure, rows, 3)
    ]
    assert widths[0] == pytest.approx(widths[2])
    assert widths[1] == pytest.approx(2 * widths[2])


@pytest.mark.parametrize("offset", [(0.0, 0.0), (30.0, -12.0), (-60.0, 8.0)])
def test_a_crop_holds_marks_and_labels_and_no_more(offset):
    figure = Figure(figsize=(5.0, 4.0), dpi=100)
    scene = picture("area", SQUARE, color=RED)
    scene.label((2.0, 1.0), r"a long label, $\theta_p$", offset=offset, held=True)
    cropped = crop(Texts(figure.dpi), scene, 200.0)
    assert cropped.size[0] == pytest.approx(200.0)
    ax = cropped.draw(figure, 10.0, 20.0)
    low, high = ax.transData.transform(SQUARE[[0, 2]]) * 72 / figure.dpi
    (text,) = ax.texts
    box = text.get_window_extent().get_points() * 72 / figure.dpi
    assert np.minimum(low, box[0]) == pytest.approx([10.0, 20.0])
    assert np.maximum(high, box[1]) == pytest.approx([210.0, 20.0 + cropped.size[1]])


# -- single marks ------------------------------------------------------------------------------------


@pytest.mark.parametrize("angle", [-170.0, -90.0, 0.0, 33.0, 180.0])
@pytest.mark.parametrize("add", ["force", "motion"])
def test_an_arrow_keeps_its_direction_and_ends_at_its_tip(add, angle):
    (arrow,) = picture(add, (0.3, 0.2), 1.5 * unit(angle)).marks
    shaft, head = arrow.shape(SHEET.unit)
    assert shaft[0] == pytest.approx([0.3, 0.2])
    assert head[1] == pytest.approx(shaft[0] + 1.5 * unit(angle))
    assert arrow.filled == (add == "force")
    along = shaft[-1] - shaft[0]
    assert np.hypot(*along) * unit(angle) == pytest.approx(along)
    assert np.hypot(*along) == pytest.approx(1.5) or arrow.filled
    assert (head[0] + head[2]) / 2 - head[1] == pytest.approx(
        -0.4 * 14 * SHEET.unit * unit(angle), rel=0.06
    )


@pytest.mark.parametrize("length", [0.0, 1e-9, 0.05, 0.2, 2.0])
def test_a_head_is_shorter_than_its_arrow(length):
    (arrow,) = picture("force", (1, 1), (length, 0)).marks
    shaft, head = arrow.shape(SHEET.unit)
    assert np.isfinite(shaft).all()
    assert 0 <= head[1, 0] - head[0, 0] <= min(0.9 * length + 1e-15, 0.42 * 14 * SHEET.unit)
    assert np.ptp(head[:, 1]) <= 0.8 * length + 1e-15


@pytest.mark.parametrize(("sense", "side"), [(1.0, -1.0), (-1.0, 1.0)])
def test_a_turn_to_the_left_ends_on_the_left(sense, side):
    (arrow,) = picture("turn_arrow", (0, 0), sense, 0.5, RED).marks
    assert np.hypot(*arrow.points.T) == pytest.approx(0.5)
    assert np.sign(arrow.points[-1, 0]) == side


def test_a_cone_spans_from_its_right_to_its_left_edge():
    area, right, left = picture("cone", -0.3, 2.0, 0.5, RED, apex=(1.0, 0.0)).marks
    for line, edge in ((right, -0.3), (left, 2.0)):
        assert line.points == pytest.approx(
            np.array([(1, 0), (1 + 0.5 * np.cos(edge), 0.5 * np.sin(edge))])
        )
    turns = np.arctan2(*(area.rings[0][1:] - [1.0, 0.0]).T[::-1])
    assert (np.diff(turns) > 0).all()
    assert (turns[0], turns[-1]) == pytest.approx((-0.3, 2.0))
    assert (area.ink, area.color) == (RED, "#f1d6d6")  # opaque, so that it covers what is below it


def test_a_cone_of_one_direction_is_a_line_and_one_of_every_direction_has_no_edges():
    area, *edges = picture("cone", 1.0, 1.0, 0.5, RED).marks
    assert len(edges) == 2
    assert np.ptp(np.arctan2(*area.rings[0][1:].T)) == pytest.approx(0)
    for left in (2 * np.pi, 7.0):
        (whole,) = picture("cone", 0.0, left, 0.5, RED).marks
        assert np.hypot(*whole.rings[0].T) == pytest.approx(0.5)


@pytest.mark.parametrize(("start", "stop"), [(0.0, 0.8), (0.2, -0.5), (0.0, 0.0)])
def test_an_arc_joins_its_two_angles(start, stop):
    line, label = picture("angle", start, stop, 0.5, "a", vertex=(1, 1)).marks
    ends = [[1 + 0.5 * np.cos(each), 1 + 0.5 * np.sin(each)] for each in (start, stop)]
    assert line.points[[0, -1]] == pytest.approx(np.array(ends))
    assert np.hypot(*(label.position - 1)) == pytest.approx(0.5)


def test_a_label_without_an_offset_interrupts_its_arc():
    arc, gap, label = picture("angle", 0.0, 1.0, 0.5, "a", offset=0.0).marks
    assert gap.face == "white"
    assert gap.order > arc.order
    assert label.position == pytest.approx(gap.position)
    assert np.hypot(*(arc.points - gap.position).T).min() == pytest.approx(0, abs=0.01)


def test_corners_hold_points_of_any_shape():
    found = corners([(0, 1), np.zeros((2, 2, 2)), [(3, -1)]], margin=0.5)
    assert found.tolist() == [[-0.5, -1.5], [3.5, 1.5]]


# -- labels ------------------------------------------------------------------------------------------


def taken(label):
    """Corners of the place of a label, points."""
    middle = SHEET.to_sheet(label.position) + np.array(label.offset) * [1, -1]
    return middle - np.array(label.extent) / 2, middle + np.array(label.extent) / 2


@pytest.mark.parametrize("symbol", [r"\theta", r"\mathbf{v}", r"\infty"])
def test_a_symbol_is_as_wide_as_a_letter(symbol):
    label = Label(np.zeros(2), rf"${symbol}_p = 1$")
    assert label.extent == Label(np.zeros(2), "xp = 1").extent


def test_labels_part_stay_in_the_frame_and_settle_alike_twice():
    drawn = Picture()
    for place in (*np.zeros((4, 2)), BOX[1]):
        drawn.label(place, "label", offset=(9.0, 0.0))
    boxes = [taken(each) for each in settle(drawn, SHEET)]
    for i, (low, high) in enumerate(boxes):
        assert (low >= 0).all()
        assert (high <= SIZE).all()
        assert all((low >= other[1]).any() or (high <= other[0]).any() for other in boxes[:i])
    assert settle(drawn, SHEET) == settle(drawn, SHEET)


@pytest.mark.parametrize(
    "mark",
    [
        Arrow(SQUARE[:2], RED, True),
        Line(SQUARE[:2], RED),
        Area((SQUARE,), RED, "/"),
        Hatch(np.array([[(x, 0.0), (x - 0.1, -0.1)] for x in np.linspace(0, 2, 20)]), RED),
    ],
)
def test_a_label_moves_off_lines_unless_it_is_held_or_has_no_offset(mark):
    def settle_label(**options):
        found = Picture([mark, Label(np.array([1.0, -0.12]), "on it", **options)])
        return settle(found, SHEET)[0]

    low, high = taken(settle_label(offset=(0.0, 6.0)))
    line = SHEET.to_sheet((1.0, 0.0))[1]
    assert high[1] < line or low[1] > line
    assert settle_label(offset=(0.0, 6.0), held=True).offset == (0.0, 6.0)
    assert settle_label().offset == (0.0, 0.0)


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("a < b & c", "a < b & c"),
        (r"$\mathbf{v}_s = \mathbf{v}_p$", "vs = vp"),
        (r"$\mathbf{f}$ (adhesive)", "f (adhesive)"),
        (r"$\mathbf{v}_\mathrm{slip}$", "vslip"),
        (r"$\theta_p = 165^\circ$", "θp = 165°"),
        (r"$-v/\omega$", "-v/ω"),
        (r"$10^{-8}$", "10-8"),
        (r"$\mu = \infty$, $l^2$", "μ = ∞, l2"),
        (r"$-m\,\mathbf{a}$", "-m\N{THIN SPACE}a"),
    ],
)
def test_mathematical_text_is_letters_in_svg(row, words):
    found = ElementTree.fromstring(f"<text>{text(row)}</text>")
    assert "".join(found.itertext()).replace("\N{ZERO WIDTH SPACE}", "") == words
    bold = [each.text for each in found.iter() if each.get("font-weight") == "bold"]
    assert bold == re.findall(r"\\mathbf{(\w)}", row)
    small = ["".join(each.itertext()) for each in found.iter() if each.get("font-size") == "70%"]
    assert len(small) == len(re.findall(r"[_^](?!\\circ)", row))
    shifts = [float(each.get("dy", "0em").removesuffix("em")) for each in found.iter()]
    back = [0.7 * shift if i % 2 == 0 else shift for i, shift in enumerate(filter(None, shifts))]
    assert sum(back) == pytest.approx(0)  # each script returns to the line
