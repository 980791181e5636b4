"""A flat side on a fence for every pressure, against pressures that are sampled, and exact thresholds."""

import math

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
SHAPE_L = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
THRESHOLD = math.sqrt(5.0) - 2.0


def about(center, sense):
    """Twist of a rotation about a center."""
    return np.array([sense * center[1], -sense * center[0], sense])


@pytest.mark.parametrize(
    ("center", "mu", "expected"),
    [
        ((2 - 1e-6, 0), 1.0, False),
        ((2 + 1e-6, 0), 1.0, True),
        ((2 + 1e-6, 0), THRESHOLD + 1e-6, True),
        ((2 + 1e-6, 0), THRESHOLD - 1e-6, False),
        ((2.5, 0), 0.2, True),
        ((2.1, 0), 0.2, False),
    ],
)
def test_check_values_of_the_square(center, mu, expected):
    def stable(*given, side=0):
        return pp.stable_for_any_pressure(*given, side=side, contact=pp.Coulomb(mu))

    assert stable(SQUARE, (0, 0), about(center, -1)) is expected
    assert stable(SQUARE, (0, 0), 5.0 * about((-center[0], 0), 1)) is expected  # the mirror image
    assert stable(SQUARE[::-1], (0, 0), about(center, -1), side=2) is expected
    assert (
        stable(pp.Polygon(SQUARE), (0, 0), about(center, -1), side=[(-1, -1), (1, -1)]) is expected
    )
    many = stable(SQUARE, (0, 0), [[about(center, -1)], [about((0, 3), -1)]])
    assert many.shape == (2, 1)
    assert many[0, 0] == expected


@pytest.mark.parametrize(
    ("velocity", "law", "expected"),
    [
        ((0, 1), pp.Coulomb(0.0), True),
        ((0.5, 1), pp.Coulomb(0.5), True),
        ((0.5, 1), pp.Coulomb(0.499999), False),
        ((1, 1), pp.Coulomb(1.0), True),  # the line of action passes through the end
        ((1.001, 1), pp.Coulomb(2.0), False),
        ((0, -1), pp.Coulomb(1.0), False),
        ((0, -1), pp.PerfectlyRough(), True),
        ((1, 0), pp.InfiniteFriction(), False),  # the force along the side passes above it
        ((0, 1), pp.InfiniteFriction("none"), True),
    ],
)
def test_a_translation_has_one_load_for_every_pressure(velocity, law, expected):
    twist = (*velocity, 0.0)
    assert pp.stable_for_any_pressure(SQUARE, (0, 0), twist, side=0, contact=law) is expected
    block = (pp.SupportFriction(support=pp.Polygon(SQUARE)),)
    scene = pp.scene_at(side=0, effects=block, contact=law, outline=SQUARE)
    assert pp.stable(scene, twist) is expected


@pytest.mark.parametrize("seed", range(12))
def test_stable_for_any_pressure_is_stable_for_sampled_ones(seed):
    """And where it is not, some pressure on three points is unstable."""
    random = np.random.default_rng(seed)
    outline = np.array([SQUARE, SHAPE_L][seed % 2], dtype=float)
    part = np.linspace(0.0, 1.0, 12, endpoint=False)[:, None]
    edges = zip(outline, np.roll(outline, -1, axis=0), strict=True)
    points = np.concatenate([a + part * (b - a) for a, b in edges])
    center = random.dirichlet(np.full(len(points), 0.5)) @ points
    law = [pp.Coulomb(0.4), pp.InfiniteFriction(), pp.Coulomb(2.0)][seed % 3]
    pivot = (outline[0] + outline[1]) / 2 + random.normal(size=2) * random.choice([0.2, 4.0])
    twist = about(pivot, random.choice([-1.0, 1.0]))
    answer = pp.stable_for_any_pressure(outline, center, twist, side=0, contact=law)
    stable = []
    while len(stable) < 60:
        corners = points[random.choice(len(points), 3, replace=False)]
        matrix = np.vstack([np.ones(3), corners.T])
        if abs(np.linalg.det(matrix)) < 1e-3:
            continue
        shares = np.linalg.solve(matrix, [1.0, *center])
        if shares.min() > 1e-6:
            feet = (pp.SupportFriction(support=pp.Points(corners, shares)),)
            scene = pp.scene_at(side=0, effects=feet, contact=law, outline=outline)
            stable.append(pp.stable(scene, twist))
    assert all(stable) if answer else not all(stable)


def test_where_the_center_of_rotation_is_in_the_base_nothing_holds():
    for pivot in [(0, 0), (-1, -1), (0.3, -1), (1, 0)]:
        twist = about(pivot, -1)
        assert not pp.stable_for_any_pressure(SQUARE, (0, 0), twist, side=0, contact=pp.Coulomb(9))


WRONG = [
    ({"side": 4}, "side: 4 given; allowed: a whole number from 0 to 3"),
    ({"side": 0.5}, "side: 0.5 given; allowed: a whole number from 0 to 3"),
    ({"side": (1, 2, 3)}, "side: (1, 2, 3) given; allowed: a whole number, or two points"),
    ({"side": [(0, 0), (0, 0)]}, "allowed: two different points"),
    ({"region": pp.Disc(1.0)}, "side: 0 given; allowed: the two ends of the side for a region that is not"),
    ({"region": SHAPE_L, "side": 2, "center_of_pressure": (1, 1)}, "side: 2 given; allowed: a side with"),
    ({"twist": (0, 0, 0)}, "twist: (0, 0, 0) given; allowed: twists that are not zero"),
    ({"twist": (0, 1)}, "twist: (0, 1) given; allowed: finite numbers of shape S + (3,)"),
    ({"contact": 0.5}, "contact: 0.5 given; allowed: a contact law"),
    ({"center_of_pressure": (0, 2)}, "center_of_pressure: (0.0, 2.0) given; allowed: a position in"),
]  # fmt: skip


@pytest.mark.parametrize(("wrong", "message"), WRONG)
def test_wrong_input_is_refused_in_one_line(wrong, message):
    given = {
        "region": SQUARE, "center_of_pressure": (0, 0), "twist": (0, 1, 0), "side": 0,
        "contact": pp.Coulomb(1.0),
    } | wrong  # fmt: skip
    with pytest.raises(pp.InvalidValue) as refused:
        pp.stable_for_any_pressure(
            given.pop("region"), given.pop("center_of_pressure"), given.pop("twist"), **given
        )
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)
