"""What is proved of supports against the mechanics, which share no code with the checks."""

import numpy as np
import pytest

import planar_pushing as pp
from evidence.claims.ledgers import claim, judged

VALUES = {each.claim.id: float(each.evidence.value) for each in judged() if each.evidence.value}
TRIPOD = pp.Points([(1.0, 0.0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1, 1, 1])


def scene(support, length, psi=np.pi / 2, contact=None):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=contact or pp.InfiniteFriction(), effects=effects)


@pytest.mark.parametrize(("part", "pivots"), [(0.9999, True), (1.0001, False)])
def test_one_motion_for_the_force_angles_of_a_pivot(part, pivots):
    half = np.deg2rad(VALUES["one-pivot-for-many-forces"] / 2)
    found = pp.motion_angle(scene(TRIPOD, 2.0), part * half * np.array([-1.0, 1.0]))
    assert np.all((np.abs(found) < 1e-12) == pivots)


@pytest.mark.parametrize("part", [0.9999999, 1.0000001])
def test_farthest_offset_of_a_pivot(part):
    center = pp.motion_centers(
        scene(TRIPOD, part * VALUES["tripod-pivots"]), 0.0, origin="ring-center"
    )
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
    expected = VALUES[f"integration-constant-of-{name}"]
    assert pp.fit_ellipsoid(support).integration_constant == pytest.approx(
        expected, rel=2e-15, abs=0
    )


def test_a_foot_ahead_keeps_the_cone_on_the_fence():
    given = claim("foot-ahead-holds").claimed
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
    edge = VALUES["corner-of-a-line"] / 2 - 90
    for angle, sticks in ((0.999, True), (-0.999, True), (-1.001, False)):
        found = pp.solve(scene(line, 1.0), np.deg2rad(angle * edge))
        forces = [each.force for each in found if each.mode is pp.ContactMode.STICK]
        assert bool(forces) == sticks
        assert all(np.allclose(force, (1.0, 0.0), atol=1e-12) for force in forces)


def test_the_centre_of_a_ring_beyond_the_bound():
    given = claim("center-beyond-bound").claimed
    offset = given["product"] * given["spin_ratio"]
    center = pp.motion_centers(scene(pp.Ring(1.0), offset), 0.0, origin="ring-center")
    assert np.hypot(*center) == pytest.approx(1 / given["spin_ratio"], rel=1e-8)
