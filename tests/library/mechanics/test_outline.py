"""Outlines as chains of sides, arcs and corners: how pieces join, and the areas that they enclose."""

import json
import math
import pickle

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.outline.chains import polygon_chain
from planar_pushing.mechanics.outline.entries import entry_of_outline, outline_of_entry
from planar_pushing.mechanics.plane import Frame

SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
TEE = [(-60, 0), (-60, 30), (60, 30), (60, 0), (15, 0), (15, -90), (-15, -90), (-15, 0)]
OUTLINES = {
    "square": pp.Outline(SQUARE),
    "clockwise tee": pp.Outline(TEE),
    "disc": pp.Outline(pp.Disc(0.4, (1.0, -2.0))),
    "rounded": pp.rounded(SQUARE, 0.3),
    "fillets": pp.rounded(TEE, [0, 3, 4, 0, 5, 2, 2, 6]),
    "slot": pp.Outline.from_bulges([(0, 0, 0), (2, 0, 1), (2, 1, 0), (0, 1, 1)]),
    "bitten": pp.Outline.from_bulges([(0, 0, 0), (2, 0, 0), (2, 2, -0.5), (0, 2, 0)]),
    "ellipse": pp.Outline.ellipse(2.0, 1.0),
    "holes": pp.Outline(SQUARE, holes=[pp.Disc(0.3), [(0.5, 0.5), (0.9, 0.5), (0.9, 0.9)]]),
}
NAMED = pytest.mark.parametrize("outline", OUTLINES.values(), ids=OUTLINES)


def chains(outline):
    """Rows of each chain, found along the column of the next row."""
    rest, found = {*range(len(outline.pieces))}, []
    while rest:
        row, chain = min(rest), []
        while row in rest:
            rest.remove(row)
            chain.append(row)
            row = int(outline.pieces[row, 7])
        found.append(outline.pieces[chain])
    return found


def boundary(chain, count):
    """Midpoints of many steps along a chain, and the steps, from the definition of the columns."""
    points = []
    for x, y, rho, beta0, beta1, length, *_ in chain:
        part = np.linspace(0.0, 1.0, count, endpoint=False)
        if math.isinf(rho):
            s = part * length
            points.append(np.stack([x + s * math.cos(beta0), y + s * math.sin(beta0)], -1))
        elif rho:
            beta = beta0 + part * (beta1 - beta0)
            points.append(np.stack([x + rho * np.sin(beta), y - rho * np.cos(beta)], -1))
    points = np.concatenate(points)
    return points, np.roll(points, -1, 0)


@NAMED
def test_pieces_join_and_turn_once(outline):
    for number, chain in enumerate(chains(outline)):
        sign = 1.0 if number == 0 else -1.0
        beta0, beta1, following = chain[:, 3], chain[:, 4], np.roll(chain, -1, 0)
        assert (beta1[:-1] == beta0[1:]).all()
        assert beta1[-1] - beta0[0] == pytest.approx(sign * 2 * math.pi, abs=1e-12)
        assert (outline.pieces[following[:, 8].astype(int), :6] == chain[:, :6]).all()
        one, two = boundary(chain, 200)
        assert np.hypot(*(two - one).T).max() <= 1.01 * chain[:, 5].max() / 200
        assert chain[:, 6] == pytest.approx(np.append(0.0, np.cumsum(chain[:-1, 5])))


@NAMED
def test_areas_and_moments_are_those_of_many_small_steps(outline):
    total = np.zeros(6)
    for chain in chains(outline):
        (x, y), (a, b) = (points.T for points in boundary(chain, 4000))
        turn = x * b - a * y
        total += [
            turn.sum() / 2, (turn * (x + a)).sum() / 6, (turn * (y + b)).sum() / 6,
            (turn * (x * x + x * a + a * a)).sum() / 12,
            (turn * (2 * x * y + 2 * a * b + x * b + a * y)).sum() / 24,
            (turn * (y * y + y * b + b * b)).sum() / 12,
        ]  # fmt: skip
    area, c_x, c_y = total[0], *(total[1:3] / total[0])
    shift = area * np.array([c_x * c_x, c_x * c_y, c_y * c_y])
    assert outline.area == pytest.approx(area, rel=1e-6)
    assert outline.centroid == pytest.approx((c_x, c_y), abs=1e-6 * outline.size)
    assert outline.moments == pytest.approx(total[3:] - shift, abs=1e-5 * area * outline.size**2)


@NAMED
def test_other_frames_change_no_invariant(outline):
    frame = pp.Placement(point=(0.7, -0.3), normal=(0.6, 0.8)).fence
    moved = outline.in_frame(frame)
    assert moved.area == pytest.approx(outline.area, rel=1e-12)
    assert moved.gyration_radius == pytest.approx(outline.gyration_radius, rel=1e-12)
    assert moved.pieces[:, 5] == pytest.approx(outline.pieces[:, 5])
    assert frame.point_out(moved.centroid) == pytest.approx(outline.centroid)


@NAMED
def test_outlines_are_values(outline):
    named = {"Outline": pp.Outline, "Disc": pp.Disc}
    for other in (pickle.loads(pickle.dumps(outline)), eval(repr(outline), named)):
        assert other == outline
        assert hash(other) == hash(outline)
    with pytest.raises(ValueError, match="read-only"):
        outline.pieces[0, 0] = 1.0


@NAMED
def test_files_keep_outlines_exactly(outline):
    entry = entry_of_outline(outline)
    kept = outline_of_entry(json.loads(json.dumps(entry)))
    assert kept == outline
    assert hash(kept) == hash(outline)
    assert hash(entry) == hash(entry_of_outline(kept))


def test_a_disc_is_one_in_files():
    assert entry_of_outline(OUTLINES["disc"]) == {"disc": {"radius": 0.4, "center": [1.0, -2.0]}}
    turned = pp.Outline(pp.Disc(2.0)).in_frame(Frame((0.0, 0.0), (0.6, -0.8)))
    assert entry_of_outline(turned) == {"disc": {"radius": 2.0}}


def test_polygons_have_two_rows_a_corner_and_full_circles_one():
    assert len(OUTLINES["clockwise tee"].pieces) == 16
    assert len(OUTLINES["rounded"].pieces) == 8
    for sign in (1.0, -1.0):
        halves = pp.Outline.from_bulges([(-1, 0, sign), (1, 0, sign)])
        assert halves == pp.Outline(pp.Disc(1.0))


# --- Pieces that are none ------------------------------------------------------------------------

SLOT, BOX, CIRCLE = (
    pp.Outline.from_bulges([(0, 0, 0), (2, 0, 1), (2, 1, 0), (0, 1, 1)]).pieces[:, :6],
    OUTLINES["square"].pieces[:, :6], pp.Outline(pp.Disc(1.0)).pieces[:, :6],
)  # fmt: skip


def rows_of(*own):
    """Rows of a chain from its own columns, with the arc lengths and the numbers of the neighbors."""
    own, numbers = np.array(own), np.arange(len(own))
    start = np.append(0.0, np.cumsum(own[:-1, 5]))
    return np.column_stack([own, start, np.roll(numbers, -1), np.roll(numbers, 1)])


def halves(row):
    """Two pieces of a side or an arc, or of a corner's turn."""
    x, y, rho, beta0, beta1, length = row.tolist()
    middle, half = (beta0 + beta1) / 2, length / 2
    other = [x, y] if math.isfinite(rho) else [x + half * np.cos(beta0), y + half * np.sin(beta0)]
    return [x, y, rho, beta0, middle, half], [*other, rho, middle, beta1, half]


def corner(place, beta, turn=0.0):
    return [*place, 0.0, beta, beta + turn, 0.0]


FULL, LOW = 2 * math.pi, SLOT[3]
#: Rows of a chain with pieces that are none, and those of the same outline without them.
NEEDLESS = {
    "corner of no turn": ([*SLOT, corner((2, 0), FULL)], SLOT),
    "corner of a tiny turn": ([*SLOT, corner((2, 0), FULL, 1e-8)], SLOT),
    "side without length": ([*SLOT, [2, 0, math.inf, FULL, FULL, 0]], SLOT),
    "arc without length": ([*SLOT, [2, 0.5, 0.5, FULL, FULL, 0]], SLOT),
    "tiny arc": ([*SLOT, [2, 0.1, 0.1, FULL, FULL + 1e-7, 1e-8]], SLOT),
    "divided side": ([*SLOT[:3], *halves(LOW)], SLOT),
    "side with a corner within": ([*SLOT[:3], halves(LOW)[0], corner((1, 0), FULL), halves(LOW)[1]], SLOT),
    "divided arc": ([*SLOT[:2], *halves(SLOT[2]), LOW], SLOT),
    "divided side of a square": ([*halves(BOX[0]), *BOX[1:]], BOX),
    "corner on a side of a square": (
        [halves(BOX[0])[0], corner((0, -1), 0), halves(BOX[0])[1], *BOX[1:]], BOX),
    "divided corner": ([BOX[0], *halves(BOX[1]), *BOX[2:]], BOX),
    "corner beside a corner": ([*BOX[:2], corner(BOX[1, :2], BOX[1, 4]), *BOX[2:]], BOX),
    "circle of halves": ([*halves(CIRCLE[0])], CIRCLE),
    "circle with a corner": ([*CIRCLE, corner((0, -1), FULL)], CIRCLE),
}  # fmt: skip


@pytest.mark.parametrize(("rows", "fewer"), NEEDLESS.values(), ids=NEEDLESS)
def test_pieces_that_are_none_are_left_out(rows, fewer):
    """The first row can be another one; every piece of the outline has its place and direction."""
    found = pp.Outline.from_pieces(rows_of(*rows)).pieces
    assert len(found) == len(fewer)
    first = np.abs(found[:, :3].clip(-9, 9) - fewer[0, :3].clip(-9, 9)).sum(axis=1).argmin()
    found = np.roll(found, -int(first), axis=0)
    places = [0, 1, 2, 5]
    assert found[:, places] == pytest.approx(fewer[:, places], abs=1e-7)
    assert np.exp(1j * found[:, 3:5]) == pytest.approx(np.exp(1j * fewer[:, 3:5]), abs=1e-6)


@pytest.mark.parametrize("radius", [0.0, 1e-3])
@pytest.mark.parametrize("massive", [False, True])
@pytest.mark.parametrize("name", [name for name in NEEDLESS if NEEDLESS[name][1] is SLOT])
def test_a_finger_passes_pieces_that_are_none(name, massive, radius):
    """It slips along the side and over the place; the run is that of the outline without them."""
    friction = pp.SupportFriction(support=pp.Disc(0.5, center=(1.0, 0.5)), weight=20.0)
    effects = (friction, pp.Inertia(gyration_radius=0.5)) if massive else (friction,)
    finger = pp.Pusher(velocity=(2.5, 0.5), shape="finger", radius=radius)

    def end(rows):
        outline = pp.Outline.from_pieces(rows_of(*rows))
        scene = pp.scene_at((1.05, 0), effects=effects, contact=pp.Coulomb(0.1), outline=outline)
        log = pp.simulate(scene, finger, duration=1.0)
        assert np.isinf(outline.pieces[log.contact_piece.values[0], 2])
        assert (log.event.values == pp.Event.END_OF_SIDE).sum() == 1
        return [*log.position.values[-1], np.deg2rad(log.rod_angle.values[-1])]

    rows, fewer = NEEDLESS[name]
    assert end(rows) == pytest.approx(end(fewer), abs=1e-6)


def test_holes_have_no_needless_pieces():
    hole = [[0, 0, -0.3, 0, -math.pi, 0.3 * math.pi], [0, 0, -0.3, -math.pi, -FULL, 0.3 * math.pi]]
    outer, inner = rows_of(*BOX), rows_of(*hole)
    inner[:, 7:] += len(outer)
    found = pp.Outline.from_pieces(np.concatenate([outer, inner]))
    assert found.pieces == pytest.approx(pp.Outline(SQUARE, holes=[pp.Disc(0.3)]).pieces, abs=1e-15)


def test_pieces_that_are_drawn_again_do_not_cross():
    bow = polygon_chain(np.array([(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (2.0, 1.0)]))
    with pytest.raises(pp.InvalidValue, match=r"pieces.*cross"):
        pp.Outline.from_pieces(rows_of(*halves(bow[0]), *bow[1:]))


@pytest.mark.parametrize("radius", [0, 1e-12, 1e-9, 1e-8, 1e-7, 6e-7])
@pytest.mark.parametrize("corners", [SQUARE, TEE], ids=["square", "tee"])
def test_corners_with_a_radius_within_the_tolerance_are_corners(corners, radius):
    """The sides go up to the corner, and a finger can begin anywhere on them."""
    sharp = pp.Outline(corners)
    size = radius * sharp.size
    for rounded in (pp.rounded(corners, size), pp.rounded(corners, [size] * len(corners))):
        assert rounded.pieces == pytest.approx(sharp.pieces, abs=1e-12 * sharp.size)


def test_a_polygon_is_made_of_an_outline_of_straight_sides():
    assert pp.Polygon(OUTLINES["square"]) == pp.Polygon(SQUARE)
    wide = [(-3, -3), (3, -3), (3, 3), (-3, 3)]
    assert pp.Polygon(wide, holes=[OUTLINES["square"]]) == pp.Polygon(wide, holes=[SQUARE])


def test_ellipses_are_of_second_order():
    errors = [
        abs(pp.Outline.ellipse(2, 1, arcs).moments[0] - 2 * math.pi) for arcs in (32, 64, 128)
    ]
    assert errors[0] > 3.5 * errors[1] > 12 * errors[2]


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: pp.rounded(SQUARE, 1.5), "choose smaller radii"),
        (lambda: pp.rounded(SQUARE, [0.1, 0.2]), "4 of them"),
        (lambda: pp.rounded(OUTLINES["rounded"], 0.1), "straight sides"),
        (lambda: pp.Outline(pp.Ring(1.0)), "a Disc"),
        (lambda: pp.Polygon(OUTLINES["rounded"]), "vertices.*straight sides without holes"),
        (lambda: pp.Polygon(OUTLINES["holes"]), "vertices.*straight sides without holes"),
        (lambda: pp.Outline.from_bulges([(0, 0, 0), (1, 1, 0.1), (1, 0, 0), (0, 1, 0)]), "cross"),
        (lambda: pp.Outline.ellipse(1, 2, 7), "even"),
        (lambda: pp.Outline(SQUARE, holes=[pp.Disc(1.2)]), "inside"),
    ],
)
def test_impossible_outlines_are_refused(make, said):
    with pytest.raises(pp.InvalidValue, match=said):
        make()
