"""Two contacts against published values: every solution is listed, with twists and forces.

Each was found by a search that knows no contact modes, which found no other. R is feet at (+-1, +-1), U a
uniform square of side 2; both weigh 1.
"""

from __future__ import annotations

import numpy as np
import pytest
from objects.several.scenes import modes_of

import planar_pushing as pp

R = pp.SupportFriction(support=pp.Points.rectangle(2.0, 2.0))
U = pp.SupportFriction(support=pp.Polygon.rectangle(2.0, 2.0))
SIX = pp.SupportFriction(
    support=pp.Points(
        [(0, 0.1), (0, -0.4), (0.3, -0.3), (0.4, 0.1), (-0.2, -0.5), (0.3, -0.4)],
        [3, 4, 8, 6, 4, 7],
    )
)
INERTIA = pp.Inertia(mass=1.0, gyration_radius=1.0, center=(0.0, 0.0))
FINGER = ((-1, 0.3), (1, 0), (1, 0.2), 0.5)
WALL = ((1, -0.4), (-1, 0), (0, 0), 0.3)
LOW = ((-1, 0.5), (1, 0), (1, -0.5), 0.2), ((1, -1), (0, 1), (0, 0), 0.2)
#: Effects, contacts as point, normal, velocity and friction, outcome with reason, and the solutions: modes,
#: twist, forces, and forces at the other end of their range.
VALUES = {
    "finger away from a wall": ([R], [FINGER, ((0.2, 1), (0, -1), (0, 0), 0.3)], "UNIQUE", [
        ("KS", (0.9320806328, -0.02639789056, -0.2263978906),
         [(0.9664890567, -0.02691049202), (0, 0)]),
    ]),
    "finger against a wall": ([R], [FINGER, WALL], "UNIQUE", [
        ("KL", (4 / 7, -43 / 35, -10 / 7),
         [(15.78873627, -5.068939158), (-15.70984455, 4.712953364)]),
    ]),
    "along a floor": ([U], LOW, "UNIQUE", [
        ("LR", (0.938198785, 0.12360243, -0.12360243),
         [(1.056914134, -0.2113828269), (-0.06832242258, 0.3416121129)]),
    ]),
    "the same without friction": ([U], [(*one[:3], 0) for one in LOW], "UNIQUE", [
        ("LR", (0.8430930577, 0.3138138845, -0.3138138845),
         [(0.9180210745, 0), (0, 0.3404876469)]),
    ]),
    "two fingers that turn": (
        [R], [((-0.5, -1), (0, 1), (0, 1), 0.5), ((0.5, -1), (0, 1), (0, 0.8), 0.5)], "UNIQUE", [
            ("KK", (0.2, 0.9, -0.2),
             [(0.1898825005, 0.9128331418), (0.01958799982, 0.03917599964)],
             [(0.2290585002, 0.9128331418), (-0.01958799982, 0.03917599964)]),
    ]),
    "two fingers that slip": (
        [U], [((-0.5, -1), (0, 1), (0.4, 1), 0.2), ((0.5, -1), (0, 1), (0.4, 0.8), 0.2)], "UNIQUE", [
            ("LL", (0.1801225715, 0.9, -0.2),
             [(0.1508984251, 0.7544921256), (0.0436339004, 0.218169502)]),
    ]),
    "finger in a pocket": (
        [U], [((-0.1, 0), (-1, 0), (-0.6, -0.8), 0.3), ((0, -0.1), (0, -1), (-0.6, -0.8), 0.3)],
        "UNIQUE", [
            ("KK", (-0.6, -0.8, 0),
             [(-0.8571428571, 0.2571428571), (0.2571428571, -1.057142857)],
             [(-0.4615384615, -0.1384615385), (-0.1384615385, -0.6615384615)]),
    ]),
    "jaws that close": (
        [U], [((-1, 0.2), (1, 0), (1, 0), 0.5), ((1, 0.2), (-1, 0), (0.5, 0), 0.5)], "JAMMED", [],
    ),
    "jaws off one line": (
        [R], [((-1, 0.3), (1, 0), (1, 0), 1), ((1, -0.4), (-1, 0), (0, 0), 1)], "WEDGED", [],
    ),
    "with inertia": ([R, INERTIA], LOW, "UNIQUE", [
        ("LR", (0.9605910938, 0.07881781242, -0.07881781242),
         [(2.068669713, -0.4137339426), (-0.1148066255, 0.5740331275)]),
    ]),
    "flush": ([R], [((-0.5, -1), (0, 1), (0.2, 1), 0.5), ((0.5, -1), (0, 1), (0.2, 1), 0.5)], "UNIQUE", [
        ("KK", (0.2, 1, 0),
         [(0.04902903378, 0.686406473), (0.1470871014, 0.2941742027)],
         [(0.3432032365, 0.686406473), (-0.1470871014, 0.2941742027)]),
    ]),
    "three solutions": (
        [SIX], [((-0.1, -0.7), (0, 1), (0.6, 0.3), 3), ((0.6, -0.3), (-1, 1), (-1.1, -0.9), 1.5)],
        "AMBIGUOUS", [
            ("SK", (-0.5305869615, 0.238826077, -1.898043462),
             [(0, 0), (-0.8690576173, -0.1583569319)]),
            ("KS", (0.2439438326, 0.3508651668, 0.5086516677),
             [(0.6170332981, 0.7521516231), (0, 0)]),
            ("LR", (-0.4580007252, 0.1604998187, -1.395001813),
             [(0.1049841492, 0.0349947164), (-0.9980973581, -0.1996194716)]),
    ]),
}  # fmt: skip


def contacts_of(entries):
    return [
        pp.Contact(point, normal, law=pp.Coulomb(mu), velocity=velocity)
        for point, normal, velocity, mu in entries
    ]


@pytest.mark.parametrize("name", VALUES)
def test_published_values(name):
    effects, entries, outcome, expected = VALUES[name]
    answer = pp.solve_contacts(contacts_of(entries), effects=effects)
    assert (str(answer.outcome) if answer.reason is None else str(answer.reason)) == outcome
    assert [modes_of(one) for one in answer] == [one[0] for one in expected]
    for solution, (_, twist, *ends) in zip(answer, expected, strict=True):
        # Half a unit of the tenth digit, with a few units where a published number ends earlier.
        assert solution.twist == pytest.approx(np.array(twist), rel=1e-9, abs=1e-10)
        assert solution.forces == pytest.approx(np.array(ends[0]), rel=1e-9, abs=1e-10)
        assert solution.forces_end == pytest.approx(np.array(ends[-1]), rel=1e-9, abs=1e-10)
        assert not solution.continuum
        assert solution.pivot == -1


def test_the_condition_says_how_much_of_the_forces_cancels():
    (wall,) = pp.solve_contacts(contacts_of([FINGER, WALL]), effects=[R])
    assert wall.condition == pytest.approx(37.65862, rel=1e-6)
    (alone,) = pp.solve_contacts(contacts_of([FINGER]), effects=[R])
    assert alone.condition == 1.0


def test_forces_without_a_bound_have_a_direction():
    """Infinite friction at both ends of a side: one end can pull along it as much as the other."""
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    side = pp.Contact(side=0, law=pp.InfiniteFriction(), velocity=(0.2, 1.0))
    (flush,) = pp.solve_contacts([side], effects=[R], outline=square)
    assert flush.inner_force.tolist() == [-np.inf, np.inf]
    assert flush.forces.tolist() == [[-np.inf, 0.0], [np.inf, 0.0]]
    assert flush.forces_end.tolist() == [[np.inf, 0.0], [-np.inf, 0.0]]
    assert flush.directions[1] == pytest.approx(np.array([(1.0, 0.0), (-1.0, 0.0)]))


def test_a_wedge_that_can_move_has_forces_without_an_upper_bound():
    """Both contacts stick, and each sees the other within its cone."""
    pair = [((-1, 0.3), (1, 0), (0.2, 1), 1.0), ((1, 0.3), (-1, 0.1), (0.2, 1), 1.0)]
    answer = pp.solve_contacts(contacts_of(pair), effects=[R])
    (held,) = (one for one in answer if modes_of(one) == "KK")
    assert held.twist == pytest.approx([0.2, 1.0, 0.0], abs=1e-12)
    assert np.isfinite(held.forces).all()
    assert held.inner_force[1] == np.inf
    assert held.forces_end.tolist() == [[np.inf, 0.0], [-np.inf, 0.0]]
    grown = held.forces + 5.0 * held.directions[1]
    assert grown.sum(axis=0) == pytest.approx(held.forces.sum(axis=0), abs=1e-12)
