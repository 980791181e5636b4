"""Quantities that follow from measured pushes: mean twists, last contacts, wrenches."""

from dataclasses import replace

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet, small, turn
from scipy.integrate import solve_ivp

import planar_pushing as pp
from planar_pushing.pushes.logs.measured import PARTS, measurements_of, twists_at, wrenches_about
from planar_pushing.pushes.logs.schema import require_pushes


def moved(displacements, rotations):
    """Pushes of the square with these final poses, whether possible or not; degrees."""
    some = measurements_of(require_pushes(small())).part([0] * len(rotations))
    return replace(
        some, displacement=np.array(displacements), rotation=np.deg2rad(np.array(rotations))
    )


@pytest.mark.parametrize("rotation", [0.0, -1e-5, 10.0, 179.9, -180.0])
def test_the_mean_twist_displaces_the_object_so(rotation):
    displacement = (0.3, -0.2)
    pushes = moved([displacement], [rotation])
    (twist,) = pushes.twists

    def rates(_, pose):
        return [*(turn(pose[2]) @ twist[:2]), twist[2]]

    end = solve_ivp(rates, (0.0, 1.0), [0.0, 0.0, 0.0], rtol=1e-11, atol=1e-12).y[:, -1]
    assert end == pytest.approx([*displacement, np.deg2rad(rotation)], abs=1e-9)


def test_twists_and_wrenches_of_another_point_have_the_same_power():
    random = np.random.default_rng(0)
    twists, wrenches = random.normal(size=(2, 20, 3))
    point = np.array([0.7, -1.3])
    there, about = twists_at(twists, point), wrenches_about(wrenches, point)
    assert (there * about).sum(axis=1) == pytest.approx((twists * wrenches).sum(axis=1))
    # A force at the point has no torque about it.
    force = np.array([[0.2, 0.4, 0.7 * 0.4 + 1.3 * 0.2]])
    assert wrenches_about(force, point)[0] == pytest.approx([0.2, 0.4, 0.0])


@pytest.mark.parametrize("radius", [0.0, 6.0])
def test_contacts_and_wrenches_of_simulated_pushes(radius):
    """The finger ends at its radius from the last contact; the wrench is that of a force midway."""
    given = pp.simulate_pushes(feet(), TRIANGLE, 12, seed=3, finger_radius=radius)
    pushes = measurements_of(given)
    for k in range(12):
        center = pushes.contact[k] - radius * pushes.normal[k] + pushes.finger[k]
        after = turn(-pushes.rotation[k]) @ (center - pushes.displacement[k])
        last = pushes.last_places.point[k]
        assert np.linalg.norm(after - last) == pytest.approx(radius, abs=1e-5)
        assert min(*abs(last), abs(last.sum() - 150.0)) < 1e-9
        # On the side that was touched: the normal is still that of first touch.
        assert (last - pushes.contact[k]) @ pushes.normal[k] == pytest.approx(0.0, abs=1e-9)
        force, middle = pushes.force[k], (pushes.contact[k] + last) / 2.0
        torque = np.linalg.det(np.stack([middle, force]))
        assert pushes.wrenches[k] == pytest.approx([*force, torque], abs=1e-9)
        torque -= np.linalg.det(np.stack([pushes.center, force]))
        assert pushes.centered_wrenches[k] == pytest.approx([*force, torque], abs=1e-9)
    assert pushes.has_force.all()
    assert not pushes.at_corner.any()
    assert (pushes.length, pushes.size) == (75.0, 150.0)
    assert pushes.center == pytest.approx([50.0, 50.0], abs=1e-12)


def test_short_pushes_load_the_support_as_their_wrench():
    plate = pp.SupportFriction(support=pp.Polygon(TRIANGLE), weight=5.0)
    pushes = measurements_of(pp.simulate_pushes((plate,), TRIANGLE, 8, seed=1, distance=0.1))
    loads = pp.wrench(plate, pushes.twists)
    assert pushes.wrenches / [1, 1, 75] == pytest.approx(loads / [1, 1, 75], abs=0.02)


def test_a_path_is_divided_into_equal_parts():
    """Of its way, not of its samples; one that is not known is straight."""
    nan = np.nan
    path = [[(0, 0), (0, 0.1), (0.1, 0.1)], [(0, 0), (0.1, 0.2), (nan, nan)], [(nan, nan)] * 3]
    pushes = small(
        finger_displacement=(("push", "xy"), [(0.1, 0.1), (0.1, 0.2), (-0.2, 0)], {"units": "mm"}),
        finger_path=(("push", "sample", "xy"), path),
        path_time=(("push", "sample"), [[0, 1, 9], [0, 1, nan], [nan] * 3]),
    )
    found = measurements_of(require_pushes(pushes)).path
    assert found.shape == (3, PARTS, 2)
    assert np.linalg.norm(found[0], axis=1) == pytest.approx(np.full(PARTS, 0.2 / PARTS))
    assert found[0, 0] == pytest.approx([0.0, 0.2 / PARTS])
    assert found[0, -1] == pytest.approx([0.2 / PARTS, 0.0])
    assert found.sum(axis=1) == pytest.approx(np.array([(0.1, 0.1), (0.1, 0.2), (-0.2, 0.0)]))
    assert found[2] == pytest.approx(np.tile([-0.2 / PARTS, 0.0], (PARTS, 1)))


def test_a_path_that_goes_back_ends_where_the_finger_does():
    path = [[(0, 0), (0, 0.3), (0, 0.2)]] * 3
    pushes = small(
        finger_displacement=(("push", "xy"), [(0, 0.2)] * 3, {"units": "mm"}),
        normal=(("push", "xy"), [(0, 1)] * 3),
        contact=(("push", "xy"), [(0, -1)] * 3, {"units": "mm"}),
        displacement=(("push", "xy"), [(0, 0.3)] * 3, {"units": "mm"}),
        finger_path=(("push", "sample", "xy"), path),
        path_time=(("push", "sample"), [[0, 1, 2]] * 3),
    )
    found = measurements_of(require_pushes(pushes)).path
    assert found.sum(axis=1) == pytest.approx(np.array([(0.0, 0.2)] * 3))
    assert found[0, -1] == pytest.approx([0.0, -0.4 / PARTS])


def test_noise_is_named_or_usual():
    pushes = require_pushes(small())
    assert measurements_of(pushes).noise == pytest.approx((0.006, np.deg2rad(0.3), 0.0))
    named = pushes.assign_attrs(position_noise=0.1, angle_noise=2.0, force_noise=0.3)
    assert measurements_of(named).noise == pytest.approx((0.1, np.deg2rad(2.0), 0.3))
    forced = pushes.assign(force=(("push", "xy"), [(3, 4), (0, 5), (np.nan, np.nan)]))
    assert measurements_of(forced).noise[2] == pytest.approx(0.1)
    assert measurements_of(forced).has_force.tolist() == [True, True, False]


def test_some_of_the_pushes():
    pushes = measurements_of(require_pushes(small()))
    part = pushes.part([2, 0])
    assert len(part) == 2
    assert part.contact.tolist() == [[1.0, 0.5], [-0.5, -1.0]]
    assert part.noise == pushes.noise
    assert pushes.part(slice(None)) == pushes


def test_pushes_of_several_objects_are_refused():
    other = small(pushed=("push", ["other"] * 3)).assign_coords(object=["other"])
    with pytest.raises(
        pp.InvalidValue, match=r"^pushes: 'pushes of square, other' given; allowed:"
    ):
        measurements_of(pp.concat_pushes([small(), other]))
