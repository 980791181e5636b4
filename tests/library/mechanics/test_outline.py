"""Outlines as chains of sides, arcs and corners: how pieces join, and the areas that they enclose."""

import json
import math
import pickle

import numpy as np
import pytest

import planar_pushing as pp
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
        (lambda: pp.Outline.from_bulges([(0, 0, 0), (1, 1, 0.1), (1, 0, 0), (0, 1, 0)]), "cross"),
        (lambda: pp.Outline.ellipse(1, 2, 7), "even"),
        (lambda: pp.Outline(SQUARE, holes=[pp.Disc(1.2)]), "inside"),
    ],
)
def test_impossible_outlines_are_refused(make, said):
    with pytest.raises(pp.InvalidValue, match=said):
        make()
