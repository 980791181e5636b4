"""Simulated pushes: reproducible, on the sides, with the forces and the noise that were asked for."""

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet, turn

import planar_pushing as pp

#: Its corner (0, 0) is reflex.
ELL = [(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]
PLATE = (pp.SupportFriction(support=pp.Polygon(ELL), weight=2.0),)


def test_one_seed_makes_one_dataset(pushes):
    assert pp.simulate_pushes(feet(), TRIANGLE, 12, seed=4).identical(pushes)
    other = pp.simulate_pushes(feet(), TRIANGLE, 12, seed=5)
    assert not np.isin(other["contact"].values[:, 1], pushes["contact"].values[:, 1]).all()


def test_the_truth_is_in_the_dataset(pushes):
    assert pushes["feet"].values[0].tolist() == [[10, 10], [130, 10], [10, 130]]
    assert pushes["foot_weight"].values[0] == pytest.approx([1 / 3] * 3)
    assert pushes["contact"].attrs["units"] == "mm"
    assert pushes.attrs["source"] == "simulated"
    assert "feet" not in pp.simulate_pushes(PLATE, ELL, 1)


def test_places_and_directions(pushes):
    found = pp.simulate_pushes(PLATE, ELL, 60, seed=2)
    n, motion = found["normal"].values, found["finger_displacement"].values
    assert np.linalg.norm(motion, axis=1) == pytest.approx(np.full(60, 0.2), abs=1e-12)
    assert (np.einsum("ij,ij->i", n, motion) > 0.1 - 1e-12).all()
    assert len(np.unique(found["contact"].values.round(9), axis=0)) == 60
    assert len(np.unique(n, axis=0)) == 4
    assert np.linalg.norm(pushes["finger_displacement"], axis=1) == pytest.approx(np.full(12, 15.0))


def test_a_short_push_carries_the_load_of_its_motion():
    """Force and torque are those of the support friction at the twist, in the contact's cone."""
    found = pp.simulate_pushes(PLATE, ELL, 20, distance=1e-3, contact=pp.Coulomb(0.4))
    for k in range(20):
        push = found.isel(push=k)
        force, point = push["force"].values, push["contact"].values
        twist = [*push["displacement"].values, np.deg2rad(float(push["rotation"]))]
        load = pp.wrench(PLATE[0], twist)
        torque = point[0] * force[1] - point[1] * force[0]
        assert [*force, torque] == pytest.approx([*load], abs=0.01)
        n = push["normal"].values
        assert abs(n[0] * force[1] - n[1] * force[0]) <= 0.4 * (force @ n) + 2e-3


def test_the_finger_ends_on_the_outline(pushes):
    for k in range(pushes.sizes["push"]):
        push = pushes.isel(push=k)
        end = (
            push["contact"].values
            + push["finger_displacement"].values
            - push["displacement"].values
        )
        x, y = turn(-np.deg2rad(float(push["rotation"]))) @ end
        assert min(abs(x), abs(y), abs(x + y - 150.0)) < 1e-6


def test_noise_is_added_to_the_same_pushes():
    given = (feet(), TRIANGLE, 80)
    plain = pp.simulate_pushes(*given)
    noisy = pp.simulate_pushes(*given, noise=(0.5, 0.3, 0.05))
    for name in ("contact", "normal", "finger_displacement", "feet"):
        assert noisy[name].equals(plain[name]), name
    for name, size in (("displacement", 0.5), ("rotation", 0.3), ("force", 0.05)):
        error = (noisy[name] - plain[name]).values
        assert error.std() == pytest.approx(size, rel=0.2)
        assert abs(error.mean()) < 3 * size / np.sqrt(error.size)
    assert noisy.attrs == {
        "source": "simulated", "position_noise": 0.5, "angle_noise": 0.3, "force_noise": 0.05,
        "friction_noise": 0.0,
    }  # fmt: skip


@pytest.mark.parametrize(("changes", "said"), [
    ({"effects": [pp.Inertia()]}, "effects: [Inertia("),
    ({"effects": ()}, "effects: () given; allowed: a sequence of SupportFriction"),
    ({"n": 0}, "n: 0 given; allowed: a whole number >= 1"),
    ({"n": 2.5}, "n: 2.5 given; allowed: a whole number >= 1"),
    ({"n": 1e308}, "n: 1e+308 given; allowed: a whole number >= 1, at most 1e+07"),
    ({"seed": -1}, "seed: -1 given; allowed: a whole number >= 0"),
    ({"distance": 0.0}, "distance: 0.0 given; allowed: a finite number > 0"),
    ({"distance": 50.0, "n": 1},
     "distance: 50.0 given; allowed: one over which the finger reaches no corner; 0 of 1 pushes do"),
    ({"finger_radius": -1.0}, "finger_radius: -1.0 given; allowed: a number >= 0"),
    ({"noise": (1.0,)}, "noise: (1.0,) given; allowed: three numbers"),
    ({"outline": [(0, 0)]}, "outline: "),
])  # fmt: skip
def test_wrong_input(changes, said):
    given = {"effects": PLATE, "outline": ELL, "n": 2} | changes
    with pytest.raises(pp.InvalidValue) as error:
        pp.simulate_pushes(**given)
    assert str(error.value).startswith(said), str(error.value)


@pytest.mark.skipif(
    not hasattr(pp.Pusher, "radius"), reason="a finger of finite radius is not there yet"
)
@pytest.mark.parametrize("radius", [0.1, 0.3])
def test_a_round_finger_ends_at_its_radius_from_the_outline(radius):
    """Nor does it begin where another side of a reflex corner is nearer than the radius."""
    found = pp.simulate_pushes(PLATE, ELL, 30, finger_radius=radius)
    assert (found["finger_radius"] == radius).all()
    for k in range(30):
        push = found.isel(push=k)
        start = push["contact"].values - radius * push["normal"].values
        end = start + push["finger_displacement"].values - push["displacement"].values
        end = turn(-np.deg2rad(float(push["rotation"]))) @ end
        for center in (start, end):
            assert distance_from_ell(center) == pytest.approx(radius, abs=1e-6)


def distance_from_ell(point):
    """Distance of a point outside from the two rectangles of which the L consists."""
    middles, halves = np.array([(0, -0.5), (-0.5, 0)]), np.array([(1, 0.5), (0.5, 1)])
    return np.linalg.norm(np.maximum(abs(point - middles) - halves, 0.0), axis=1).min()
