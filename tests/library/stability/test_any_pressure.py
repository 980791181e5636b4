"""Bounds over all pressures with a known center, against pressures that are sampled, and exact cases."""

import math
from itertools import combinations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.stability.base_region import base_at
from planar_pushing.stability.certificates import Bound, proved_maximum
from planar_pushing.stability.linear_program import Candidates, largest, velocities

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
SHAPE_L = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
TURNS = np.linspace(0.0, 2.0 * np.pi, 61)[:-1]
CIRCLE = np.column_stack([np.cos(TURNS), np.sin(TURNS)])


def load_of(points, shares, rotation, point, velocity):
    """Force and torque about the contact of a pressure, or of several of one number of points."""
    away = np.asarray(points) - point
    x, y = away[..., 0], away[..., 1]
    rotation = np.asarray(rotation)[..., None]
    v_x, v_y = velocity[0] - rotation * y, velocity[1] + rotation * x
    # A point at the center of rotation adds nothing.
    share = shares / np.maximum(np.hypot(v_x, v_y), 1e-300)
    f_x, f_y = share * v_x, share * v_y
    return np.stack([f_x.sum(-1), f_y.sum(-1)], axis=-1), (x * f_y - y * f_x).sum(-1)


def balance(points, shares, point, velocity):
    """The rotation at which the torque vanishes, by bisection of the angle of its tangent."""
    away = np.asarray(points) - point
    rate = np.hypot(*velocity) / np.hypot(away[..., 0], away[..., 1]).max(axis=-1)
    low, high = np.full(rate.shape, -math.pi / 2), np.full(rate.shape, math.pi / 2)
    for _ in range(70):
        middle = (low + high) / 2
        below = load_of(points, shares, rate * np.tan(middle), point, velocity)[1] < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return rate * np.tan(low)


def with_center(points, center, random):
    """A random pressure on three of the points, or None."""
    for _ in range(200):
        corners = random.choice(len(points), 3, replace=False)
        matrix = np.vstack([np.ones(3), points[corners].T])
        if abs(np.linalg.det(matrix)) < 1e-3 * np.abs(points).max() ** 2:
            continue
        shares = np.linalg.solve(matrix, [1.0, *center])
        if shares.min() > 1e-9:
            return points[corners], shares
    return None


def samples_with_center(points, center, random, count):
    """Places and shares of at most so many random pressures."""
    found = [with_center(points, center, random) for _ in range(count)]
    found = [each for each in found if each is not None]
    return np.array([each for each, _ in found]), np.array([each for _, each in found])


def edges_of(outline, count=40):
    outline = np.asarray(outline, dtype=float)
    part = np.linspace(0.0, 1.0, count, endpoint=False)[:, None]
    ends = zip(outline, np.roll(outline, -1, axis=0), strict=True)
    return np.concatenate([a + part * (b - a) for a, b in ends])


FEET = np.array([(0, 0), (2, 0.3), (1, 2), (-1, 1)])
THIN = [(-1, -1e-6), (1, -1e-6), (1, 1e-6), (-1, 1e-6)]
#: Regions, with points of them.
REGIONS = {
    "square": (SQUARE, edges_of(SQUARE)),
    "clockwise, far away": (np.array(SQUARE)[::-1] + 50.0, edges_of(SQUARE) + 50.0),
    "L": (SHAPE_L, edges_of(SHAPE_L)),
    "frame": (
        pp.Polygon(SQUARE, holes=[0.9 * np.array(SQUARE)]),
        np.concatenate([edges_of(SQUARE), 0.9 * edges_of(SQUARE)]),
    ),
    "disc": (pp.Disc(1.0), np.concatenate([CIRCLE, 0.5 * CIRCLE, [(0.0, 0.0)]])),
    "annulus": (pp.Annulus(0.5, 1.0), np.concatenate([CIRCLE, 0.5 * CIRCLE])),
    "ring": (pp.Ring(1.0), CIRCLE),
    "feet": (pp.Points(FEET), FEET),
    "segment and disc": (
        pp.Composite([(1, pp.Segment((-1, -1), (-1, 1))), (3, pp.Disc(0.3, (1, 0)))]),
        np.concatenate([0.3 * CIRCLE + (1, 0), edges_of([(-1, -1), (-1, 1)])]),
    ),
    "map": (
        pp.PressureMap(x=[-1, 0, 1], y=[-1, 0, 1], pressure=[[1, 0], [2, 3]], axis=(1, 0)),
        edges_of([(-1, -1), (0, -1), (0, 0), (1, 0), (1, 1), (-1, 1)]),
    ),
    "small": (1e-3 * np.array(SQUARE), 1e-3 * edges_of(SQUARE)),
    "thin": (THIN, edges_of(THIN)),
}


def scenes(name, seed):
    """Random centers of pressure, contacts and velocities."""
    region, points = REGIONS[name]
    random = np.random.default_rng(seed)
    center = random.dirichlet(np.full(len(points), 0.1)) @ points
    size = np.ptp(points, axis=0).max()
    point = points[random.integers(len(points))] + size * random.choice([0.0, 0.5]) * random.normal(
        size=2
    )
    velocity = random.normal(size=2) * random.choice([0.1, 10.0])
    return region, points, center, point, velocity, random


@pytest.mark.parametrize("seed", [0, 1, pytest.param(2, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", REGIONS)
def test_every_sampled_pressure_is_within_the_bounds_and_some_pressure_attains_them(name, seed):
    region, points, center, point, velocity, random = scenes(name, seed)
    size = np.hypot(*(points - point).T).max()
    rate = np.hypot(*velocity) / size
    result = pp.any_pressure(region, center, point=point, velocity=velocity)
    low, high = result.rotation
    inner = result.attained_rotation
    assert low <= inner[0] <= inner[1] <= high
    for bound, rotation, support in zip(result.rotation, inner, result.supports, strict=True):
        shares = np.array(support.weights)
        assert 1 <= len(shares) <= 3
        assert shares.sum() == pytest.approx(1.0, abs=1e-12)
        assert shares @ np.array(support.positions) == pytest.approx(
            center, rel=0, abs=1e-11 * size
        )
        found = balance(np.array(support.positions), shares, point, velocity)
        assert math.atan(found / rate) == pytest.approx(math.atan(rotation / rate), rel=0, abs=1e-6)
        assert abs(math.atan(bound / rate) - math.atan(rotation / rate)) < 2e-6
    samples = samples_with_center(points, center, random, 40)
    if len(samples[0]):
        rotation = balance(*samples, point, velocity)
        slack = 1e-9 * (rate + abs(rotation)) * (1.0 + abs(rotation) / rate)
        assert (low - slack <= rotation).all()
        assert (rotation <= high + slack).all()


@pytest.mark.parametrize(
    "name",
    ["L", "ring", "feet"]
    + [
        pytest.param(each, marks=pytest.mark.slow)
        for each in ("square", "segment and disc", "small")
    ],
)
def test_forces_of_sampled_pressures_are_within_the_bounds(name):
    region, points, center, point, velocity, random = scenes(name, 7)
    result = pp.any_pressure(region, center, point=point, velocity=velocity, weight=3.0)
    force, attained = result.force, result.attained_force
    assert (force[0] <= attained[0]).all()
    assert (attained[1] <= force[1]).all()
    assert np.abs(force - attained).max() <= 3.0 * 2e-3
    angle, inner = result.force_angle, result.attained_force_angle
    assert angle.right <= inner.right <= inner.left <= angle.left
    assert angle.span - inner.span < 5e-3
    middle = (angle.right + angle.left) / 2.0
    samples = samples_with_center(points, center, random, 60)
    units, torque = load_of(*samples, balance(*samples, point, velocity), point, velocity)
    seen = 3.0 * units[np.abs(torque) < 1e-9 * np.ptp(points)]
    assert len(seen) > 2
    assert (force[0] - 1e-6 <= seen.min(axis=0)).all()
    assert (seen.max(axis=0) <= force[1] + 1e-6).all()
    off = np.arctan2(seen[:, 1], seen[:, 0]) - middle
    assert np.abs(np.remainder(off + np.pi, 2 * np.pi) - np.pi).max() <= angle.span / 2 + 1e-6


def test_check_values_of_the_square():
    result = pp.any_pressure(SQUARE, (0, 0), point=(0.5, -1), velocity=(0, 1))
    assert result.rotation == pytest.approx((0.17468027352578, 0.44183288021840), abs=1e-9)
    assert result.attained_rotation == pytest.approx(result.rotation, abs=1e-9)
    block = (pp.SupportFriction(support=pp.Polygon(SQUARE)),)
    scene = pp.scene_at((0.5, -1), effects=block, contact=pp.Coulomb(1.0), outline=SQUARE)
    (uniform,) = pp.solve(scene, np.pi / 2)
    assert uniform.twist[2] == pytest.approx(0.313813885, abs=1e-9)
    assert result.rotation[0] < uniform.twist[2] < result.rotation[1]
    force = scene.to_object(uniform.force, "vector")
    assert math.atan2(force[1], force[0]) in result.force_angle
    assert (result.force[0] < force).all()
    assert (force < result.force[1]).all()
    # The extreme pressures are supports: a scene with them has the extreme motion.
    for support, rotation in zip(result.supports, result.attained_rotation, strict=True):
        feet = (pp.SupportFriction(support=support),)
        scene = pp.scene_at((0.5, -1), (0, 1), effects=feet, contact=pp.PerfectlyRough())
        (solution,) = [
            each for each in pp.solve(scene, np.pi / 2) if each.mode is pp.ContactMode.STICK
        ]
        assert solution.twist[2] == pytest.approx(rotation, abs=1e-6)


def test_the_load_of_feet_is_the_extreme_one_of_three_feet():
    """For feet the program is finite: its vertices are pressures on at most three feet."""
    random = np.random.default_rng(3)
    for _ in range(10):
        feet = random.normal(size=(6, 2))
        center = random.dirichlet(np.ones(6)) @ feet
        base = base_at(pp.Points(feet), center, random.normal(size=2), random.normal(size=2))
        eta, along, k = random.uniform(-1.4, 1.4), random.normal(size=2), random.normal()
        points = base.curves.start
        v = velocities(base, eta, points)
        e = v / np.hypot(v[:, 0], v[:, 1])[:, None]
        part = e @ along + k * (points[:, 0] * e[:, 1] - points[:, 1] * e[:, 0])
        values = []
        for three in map(list, combinations(range(6), 3)):
            shares = np.linalg.solve(np.vstack([np.ones(3), points[three].T]), [1.0, *base.center])
            if shares.min() >= 0.0:
                values.append(shares @ part[three])
        optimum = largest(Candidates.of(base), eta, along, k, 1e-12)
        assert optimum.value == pytest.approx(max(values), abs=1e-12)
        row = optimum.multiplier
        proved = proved_maximum(base, Bound(eta, eta, row, row, along), 1e-12)
        assert max(values) <= proved <= max(values) + 1e-11


@pytest.mark.parametrize("name", ["square", "L", "disc", "segment and disc", "map"])
def test_any_multipliers_give_a_valid_bound(name):
    """Also between two rotations, and with the center of rotation inside."""
    region, points, center, point, velocity, random = scenes(name, 11)
    base = base_at(region, center, point, velocity)
    seen = (points - point) / base.size
    for _ in range(6):
        ends = np.sort(random.uniform(-1.5, 1.5, 2))
        ends[1] = ends[0] + random.choice([0.0, 0.01, 1.0]) * (ends[1] - ends[0])
        rows, along = random.normal(size=(2, 4)), random.normal(size=2)
        rows[1] = rows[1] if ends[0] < ends[1] else rows[0]
        bound = Bound(*ends, *rows, along)
        proved = proved_maximum(base, bound, 1e-4)
        for _ in range(20):
            if (sample := with_center(seen, base.center, random)) is None:
                break
            part = random.random()
            eta, k = (
                ends[0] + part * (ends[1] - ends[0]),
                rows[0, 3] + part * (rows[1, 3] - rows[0, 3]),
            )
            v = velocities(base, eta, sample[0])
            e = v / np.hypot(v[:, 0], v[:, 1])[:, None]
            arm = sample[0][:, 0] * e[:, 1] - sample[0][:, 1] * e[:, 0]
            assert sample[1] @ (e @ along + k * arm) <= proved + 1e-12


#: Only one rotation, or known ones: region, center of pressure, contact, velocity, rotations.
EXACT = {
    "the center in a corner": (SQUARE, (1, 1), (0.5, -1), (0, 1), (-2 / 17, -2 / 17)),
    "the end of a segment": (pp.Segment((-1, 1), (1, 1)), (1, 1), (0.5, -1), (0, 1), (-2 / 17, -2 / 17)),
    "the rim of a disc": (pp.Disc(1.0), (0, 1), (0.5, -1), (0, 1), (2 / 17, 2 / 17)),
    "toward the center": (SQUARE, (0, 0), (0.5, -1), (-0.5, 1), (0, 0)),
    "at the center": (SQUARE, (0, 0), (0, 0), (0, 1), (-math.inf, math.inf)),
    "at the center, in a hole": (pp.Ring(1.0), (0, 0), (0, 0), (0, 1), (-1, 1)),
    "feet on a line ahead": (pp.Points([(1, 0), (2, 0), (3, 0)]), (2, 0), (0, 0), (0, 1), (-1 / 2, -1 / 3)),
    "feet on both sides": (pp.Points([(1, 0), (2, 0), (-3, 0)]), (0, 0), (0, 0), (0, 1), (-1, 1 / 3)),
    "two feet": (pp.Points([(0, 0), (2, 0)]), (1, 0), (1, -1), (0, 1), (0, 0)),
}  # fmt: skip


@pytest.mark.parametrize("name", EXACT)
def test_degenerate_scenes_with_known_rotations(name):
    region, center, point, velocity, rotations = EXACT[name]
    result = pp.any_pressure(region, center, point=point, velocity=velocity)
    assert result.rotation == pytest.approx(rotations, abs=1e-6)
    assert result.rotation[0] <= rotations[0] + 1e-15
    assert result.rotation[1] >= rotations[1] - 1e-15


def test_at_the_center_of_pressure_the_force_is_along_the_motion():
    result = pp.any_pressure(SQUARE, (0, 0), point=(0, 0), velocity=(3, 4), weight=5.0)
    assert result.force == pytest.approx(np.array([(3, 4), (3, 4)]), abs=1e-12)
    assert result.force_angle.degrees == pytest.approx((53.13010235, 53.13010235))
    assert result.sticks((3, 4), pp.Coulomb(0.0))
    assert result.sticks((4, -3), pp.InfiniteFriction())
    assert not result.sticks((4, -3), pp.InfiniteFriction("none"))
    assert repr(result) == "AnyPressure(rotation=(-inf, inf))"


def test_units_and_frames():
    """Turned, moved and in other units the same; numbers of numpy and lists are accepted."""
    plain = pp.any_pressure(SQUARE, (0.2, 0.1), point=(0.5, -1), velocity=(0.3, 1))
    turn = np.array([(0.6, -0.8), (0.8, 0.6)])

    def moved(points):
        return 1e3 * (np.asarray(points, dtype=float) @ turn.T) + (7e3, -3e3)

    other = pp.any_pressure(
        moved(SQUARE), moved((0.2, 0.1)), point=moved((0.5, -1)),
        velocity=np.float64(500.0) * (turn @ (0.3, 1)), weight=np.float32(2.0),
    )  # fmt: skip
    assert np.array(other.rotation) * 2.0 == pytest.approx(np.array(plain.rotation), abs=1e-8)
    turned = np.arctan2(0.8, 0.6)
    assert other.force_angle.left == pytest.approx(plain.force_angle.left + turned, abs=2e-3)
    mirror = pp.any_pressure(
        [[x, -y] for x, y in SQUARE], [0.2, -0.1], point=[0.5, np.int64(1)], velocity=[0.3, -1]
    )
    assert mirror.rotation == pytest.approx([-end for end in plain.rotation[::-1]], abs=1e-9)


@pytest.mark.parametrize(("mu", "sticks"), [(0.498, False), (0.502, True), (5.0, True)])
def test_the_contact_sticks_for_every_pressure_with_enough_friction(mu, sticks):
    """The pressure on the line through contact and center needs the most: mu = 0.5."""
    result = pp.any_pressure(SQUARE, (0, 0), point=(0.5, -1), velocity=(0, 1))
    assert result.sticks((0, 2), pp.Coulomb(mu)) is sticks


def test_sticking_follows_the_law_and_the_normal():
    result = pp.any_pressure(SQUARE, (0, 0), point=(0.5, -1), velocity=(0, 1))
    assert result.sticks((0, 1), pp.PerfectlyRough())
    assert result.sticks((0, 1), pp.InfiniteFriction())
    assert result.sticks((-1, 1), pp.InfiniteFriction("none"))
    assert not result.sticks((0, -1), pp.InfiniteFriction())
    assert not result.sticks((1, 0), pp.Coulomb(1.0))


WRONG = [
    ({"velocity": (0, 0)}, "velocity: (0, 0) given; allowed: a nonzero vector"),
    ({"velocity": (0, 1, 2)}, "velocity: (0, 1, 2) given; allowed: two finite numbers"),
    ({"point": (0, math.nan)}, "point: (0, nan) given; allowed: two finite numbers"),
    ({"center_of_pressure": (1.1, 0)},
     "center_of_pressure: (1.1, 0.0) given; allowed: a position in the convex hull of the region; no "
     "pressure has a center 0.1 outside"),
    ({"center_of_pressure": 3}, "center_of_pressure: 3 given; allowed: two finite numbers"),
    ({"region": [(0, 0), (1, 1)]}, "region: [(0, 0), (1, 1)] given; allowed: an outline"),
    ({"region": [(0, 0), (1, 1), (1, 0), (0, 1)]}, "allowed: an outline, which is a simple polygon"),
    ({"region": pp.Ring()}, "region: Ring(radius=None, center=None) given; allowed: a ring with a radius"),
    ({"region": pp.Points([(0, 0)])}, "allowed: a region of more than one point"),
    ({"weight": 0}, "weight: 0 given; allowed: a finite number > 0"),
]  # fmt: skip


@pytest.mark.parametrize(("wrong", "message"), WRONG)
def test_wrong_input_is_refused_in_one_line(wrong, message):
    given = {
        "region": SQUARE, "center_of_pressure": (0, 0), "point": (0.5, -1), "velocity": (0, 1)
    } | wrong  # fmt: skip
    with pytest.raises(pp.InvalidValue) as refused:
        pp.any_pressure(given.pop("region"), given.pop("center_of_pressure"), **given)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


def test_wrong_normals_and_laws_are_refused():
    result = pp.any_pressure(SQUARE, (0, 0), point=(0.5, -1), velocity=(0, 1))
    with pytest.raises(pp.InvalidValue, match=r"normal: .* allowed: a nonzero vector"):
        result.sticks((0, 0), pp.Coulomb(0.5))
    with pytest.raises(pp.InvalidValue, match=r"contact: 0\.5 given; allowed: a contact law"):
        result.sticks((0, 1), 0.5)
