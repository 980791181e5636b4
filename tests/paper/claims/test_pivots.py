"""The ends of pivots and corners by the library, at the numbers of the ledger."""

import numpy as np
import pytest
from evidence.claims.ledgers import found, ledger

import planar_pushing as pp


def value(claim, name):
    return float(found(claim, name).value)


def scene(support, length):
    slider = pp.Slider(rod_length=length, rod_angle=np.pi / 2, radius=1.0)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=effects)


def listed(name):
    return ledger().supports[name].build()


@pytest.mark.parametrize(("part", "pivots"), [(0.9999, True), (1.0001, False)])
def test_one_motion_for_the_force_angles_of_a_pivot(part, pivots):
    half = np.deg2rad(value("pivots-of-a-tripod", "span") / 2)
    pushed = scene(listed("tripod"), 2.0)
    angles = pp.motion_angle(pushed, part * half * np.array([-1.0, 1.0]))
    assert np.all((np.abs(angles) < 1e-12) == pivots)


@pytest.mark.parametrize("part", [0.9999999, 1.0000001])
def test_farthest_offset_of_a_pivot(part):
    farthest = value("pivots-of-a-tripod", "farthest")
    center = pp.motion_centers(
        scene(listed("tripod"), part * farthest), 0.0, origin="slider-center"
    )
    assert (np.abs(center - [0.0, 1.0]).max() < 1e-14) == (part < 1)


def test_a_foot_ahead_keeps_the_cone_on_the_fence():
    pushed = scene(listed("foot-ahead"), 3.0)
    assert pp.motion_cone(pushed).degrees == (0.0, 180.0)
    assert not pp.can_pull(pushed)
    assert not pp.slips_while_pushing(pushed)
    assert pp.can_pull(scene(listed("foot-ahead"), 0.5))


def test_directions_that_one_force_along_the_fence_allows():
    """The line stands across the fence, level with the contact; body x is the normal."""
    line = pp.Segment((-2.0, -2.0), (0.0, -2.0))
    edge = value("corner-of-a-line", "span") / 2 - 90
    for angle, sticks in ((0.999, True), (-0.999, True), (-1.001, False)):
        solutions = pp.solve(scene(line, 1.0), np.deg2rad(angle * edge))
        forces = [each.force for each in solutions if each.mode is pp.ContactMode.STICK]
        assert bool(forces) == sticks
        assert all(np.allclose(force, (1.0, 0.0), atol=1e-12) for force in forces)
