"""Numbers of the ledger against the mechanics, which share no code with the checks."""

import numpy as np
import pytest

import planar_pushing as pp
from evidence.claims.ledgers import entries, found
from mechanics.builders import BOTH, PSI, make_scene
from planar_pushing.mechanics.plane import direction

TRIPOD = pp.Points([(1.0, 0.0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1, 1, 1])
L_SHAPE = pp.Polygon([(-5, -5), (7, -5), (7, 1), (1, 1), (1, 7), (-5, 7)])


def value(claim, name):
    return float(found(claim, name).value)


def scene(support, length, psi=np.pi / 2, contact=None):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=contact or pp.InfiniteFriction(), effects=effects)


@pytest.mark.parametrize(
    ("name", "length"), [("half-rod", 0.5), ("short-rod", 2), ("long-rod", 10)]
)
def test_distance_from_the_ellipse(name, length):
    curve = pp.limit_curve(make_scene(length), np.linspace(PSI, PSI + np.pi / 2, 20001))
    x, y = (curve.force @ direction(PSI + turn) for turn in (0.0, np.pi / 2))
    shortfall = 1 - np.hypot(x / np.abs(x).max(), y / np.abs(y).max())
    expected = value("distance-from-the-ellipse", name)
    assert shortfall.max() == pytest.approx(expected, rel=1e-6)
    assert shortfall.min() > -1e-15


@pytest.mark.parametrize(("name", "length"), [("long-rod", 3.0), ("short-rod", 2.0)])
def test_the_contact_moves_away_beyond_the_offset(name, length):
    offset = value("pulling-offset", name)
    angles = PSI - np.arcsin(offset * np.array([0.999999, 1.000001]) / length)
    into, away = pp.motion_angle(make_scene(length), angles)
    assert into > 0 > away


def test_pulling_threshold_of_friction():
    threshold = value("speed-decides-pulling", "threshold")
    assert not pp.can_pull(make_scene(2.0, threshold - 1e-12))
    assert pp.can_pull(make_scene(2.0, threshold + 1e-12))


def test_the_dip_of_the_normal_motion():
    least = value("normal-motion-dips", "least")
    pushed = make_scene(2.0, 1.4, BOTH)
    for part, slips in ((0.9999, 2), (1.0001, 0)):
        pusher = np.array([10.0, part * least])
        solutions = pp.solve(pushed, np.arctan2(*pusher[::-1]), np.hypot(*pusher))
        assert sum(s.mode is pp.ContactMode.SLIP_LEFT for s in solutions) == slips


def test_directions_without_solution():
    law = pp.InfiniteFriction(at_zero_normal="none")
    edge = value("cones-of-figure-7", "left-2")
    for degrees, solutions in ((edge - 0.01, 1), (edge + 0.01, 0), (179.9, 0)):
        assert len(pp.solve(make_scene(2.0, law), np.deg2rad(degrees))) == solutions


def aside(rod_length, psi, center, gyration_radius):
    slider = pp.Slider(rod_length=rod_length, rod_angle=psi, radius=1.0)
    inertia = pp.Inertia(gyration_radius=gyration_radius, center=center)
    effects = (pp.RingFriction(), inertia)
    law = pp.InfiniteFriction()
    return [
        pp.Scene(slider=slider, contact=law, effects=each)
        for each in ((effects[0],), (inertia,), effects)
    ]


def test_a_cone_beyond_the_pure_ones():
    """The library's exact cone holds the enclosed motion, and the pure cones do not."""
    angle = value("cones-beyond-the-pure-ones", "both")
    friction, inertia, both = aside(1.0, np.pi / 2, (-1.0, -1.0), 1.0)
    assert not pp.can_pull(friction)
    assert not pp.can_pull(inertia)
    assert pp.motion_cone(both).degrees[0] <= angle
    stick = [each for each in pp.solve(both, np.deg2rad(angle), 1 / np.cos(np.deg2rad(angle)))
             if each.mode is pp.ContactMode.STICK]  # fmt: skip
    assert stick[0].force[1] == pytest.approx(0.0, abs=1e-10)
    left = value("cones-beyond-the-pure-ones", "both-left")
    cones = [pp.motion_cone(each).degrees[1] for each in aside(2.0, PSI, (-1.0, 0.0), 0.5)]
    assert max(cones[:2]) < left <= cones[2]


@pytest.mark.parametrize(("part", "pivots"), [(0.9999, True), (1.0001, False)])
def test_one_motion_for_the_force_angles_of_a_pivot(part, pivots):
    half = np.deg2rad(value("pivots-of-a-tripod", "span") / 2)
    angles = pp.motion_angle(scene(TRIPOD, 2.0), part * half * np.array([-1.0, 1.0]))
    assert np.all((np.abs(angles) < 1e-12) == pivots)


@pytest.mark.parametrize("part", [0.9999999, 1.0000001])
def test_farthest_offset_of_a_pivot(part):
    farthest = value("pivots-of-a-tripod", "farthest")
    center = pp.motion_centers(scene(TRIPOD, part * farthest), 0.0, origin="slider-center")
    assert (np.abs(center - [0.0, 1.0]).max() < 1e-14) == (part < 1)


@pytest.mark.parametrize(
    ("name", "support"),
    [
        ("square", pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])),
        ("rectangle", pp.Polygon([(-2, -1), (2, -1), (2, 1), (-2, 1)])),
        ("strip", pp.Polygon([(-4, -1), (4, -1), (4, 1), (-4, 1)])),
        ("disc", pp.Disc(3.0)),
        ("ring", pp.Ring(2.0)),
    ],
)
def test_integration_constants(name, support):
    expected = value("integration-constants", name)
    assert pp.fit_ellipsoid(support).integration_constant == pytest.approx(
        expected, rel=2e-15, abs=0
    )


def test_a_foot_ahead_keeps_the_cone_on_the_fence():
    given = entries()["foot-ahead-holds", "margin"].at
    own, x, y = (given[name] for name in ("share", "aside", "beyond"))
    feet = [(0.0, 0.0), (y, -x), (-y, 2 * x)]  # body x is the normal, body y against the fence
    support = pp.Points(feet, [own, (1 - own) / 2, (1 - own) / 2])
    pushed = scene(support, given["distance"])
    assert pp.motion_cone(pushed).degrees == (0.0, 180.0)
    assert not pp.can_pull(pushed)
    assert not pp.slips_while_pushing(pushed)
    assert pp.can_pull(scene(support, 0.5))


def test_directions_that_one_force_along_the_fence_allows():
    """The line stands across the fence, level with the contact; body x is the normal."""
    line = pp.Segment((-2.0, -2.0), (0.0, -2.0))
    edge = value("corner-of-a-line", "span") / 2 - 90
    for angle, sticks in ((0.999, True), (-0.999, True), (-1.001, False)):
        solutions = pp.solve(scene(line, 1.0), np.deg2rad(angle * edge))
        forces = [each.force for each in solutions if each.mode is pp.ContactMode.STICK]
        assert bool(forces) == sticks
        assert all(np.allclose(force, (1.0, 0.0), atol=1e-12) for force in forces)


def test_the_center_of_a_ring_beyond_the_bound():
    ratio = entries()["center-beyond-bound", "product"].at["spin_ratio"]
    offset = value("center-beyond-bound", "product") * ratio
    center = pp.motion_centers(scene(pp.Ring(1.0), offset), 0.0, origin="slider-center")
    assert np.hypot(*center) == pytest.approx(1 / ratio, rel=1e-8)


def test_the_numbers_of_the_l():
    for name, psi in (("along-normal", 90.0), ("leaning", 95.0)):
        cone = pp.motion_cone(scene(L_SHAPE, 0.5 * L_SHAPE.extent, np.deg2rad(psi)))
        assert cone.degrees[0] == pytest.approx(value("shape-of-an-l", name), abs=1e-9)
    turns = np.deg2rad([-30.0, 30.0])
    right, left = pp.limit_curve(scene(L_SHAPE, L_SHAPE.extent), np.pi / 2 + turns).magnitude
    assert right - left == pytest.approx(value("shape-of-an-l", "difference"), abs=1e-12)


def test_the_least_force_of_the_l():
    off = value("shape-of-an-l", "least-force")
    turns = np.linspace(0.0, 180.0, 18001)
    curve = pp.limit_curve(scene(L_SHAPE, 0.5 * L_SHAPE.extent), np.pi / 2 + np.deg2rad(turns))
    assert abs(turns[np.argmin(curve.magnitude)] - 90.0) == pytest.approx(off, abs=0.02)
