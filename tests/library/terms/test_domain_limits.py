"""Where the domain ends: of numbers, of arrays, and of lazy arrays."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene
from terms.test_domain import check

import planar_pushing as pp


def slider(length=2.0, psi=PSI, radius=1.0):
    return pp.Slider(rod_length=length, rod_angle=psi, radius=radius)


def push(angle=1.0, magnitude=1.0, weight=1.0, mass=1.0):
    effects = pp.RingFriction(weight=weight), pp.Inertia(mass=mass)
    return pp.solve(make_scene(2.0, 1.0, effects), angle, magnitude)


#: Of each parameter a call, a number just inside its range, one just outside, and the refusal.
LIMITS = {
    "rod_length": (
        lambda x: slider(x, radius=2.0), 2e6, 2.001e6, 1.0005e6, "at most 1e+06 times the radius",
        "give the radius and the rod length in one unit",
    ),
    "gyration_radius": (
        lambda x: make_scene(2.0, 1.0, [pp.Inertia(gyration_radius=x)], radius=2.0),
        2e4, 2.002e4, 1.001e4, "0.0001 to 10000 times the slider's radius",
        "no slider is so far from its support: model a point mass or a longer rod",
    ),
    "small gyration_radius": (
        lambda x: make_scene(2.0, 1.0, [pp.Inertia(gyration_radius=x)], radius=0.5),
        0.5e-4, 0.4999e-4, 0.9998e-4, "0.0001 to 10000 times the slider's radius",
        "no slider is so far from its support: model a point mass or a longer rod",
    ),
    "pusher_magnitude": (
        lambda x: push(magnitude=x, weight=4.0, mass=2.0), 2e12, 2.002e12, 1.001e12,
        "m a / W in [1e-12, 1e+12] for a scene with friction and inertia",
        "leave out the effect that is negligible in the motion",
    ),
    "small pusher_magnitude": (
        lambda x: push(magnitude=x, weight=0.5, mass=4.0), 1.25e-13, 1.2e-13, 9.6e-13,
        "m a / W in [1e-12, 1e+12] for a scene with friction and inertia",
        "leave out the effect that is negligible in the motion",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", LIMITS)
def test_domain(name):
    call, inside, outside, shown, allowed, remedy = LIMITS[name]
    call(inside)
    with pytest.raises(pp.InvalidValue) as caught:
        call(outside)
    error = caught.value
    assert (error.name, error.allowed, error.remedy) == (name.split()[-1], allowed, remedy)
    assert error.given == pytest.approx(shown, rel=1e-12, abs=0)


@pytest.mark.parametrize("magnitude", [1e-300, 1e-13, 1e13, 1e300])
@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
def test_one_effect_takes_a_push_of_any_magnitude(effects, magnitude):
    assert len(pp.solve(make_scene(2.0, 1.0, effects), 1.0, magnitude)) == 1


def test_a_resting_pusher_has_no_share_to_be_refused():
    assert len(push(magnitude=0.0)) == 1


#: Of each parameter a call with an array and what it refuses in it.
FIRST_WRONG = {
    "rod_length": (lambda x: slider(x), [1.0, -2.0, -3.0]),
    "friction_coefficient": (pp.Coulomb, [0.0, 2e9, -1.0]),
    "pusher_angle": (lambda x: push(angle=x), [1.0, np.inf, -np.inf]),
    "pusher_magnitude": (lambda x: push(magnitude=x), [0.0, -1.0, -2.0]),
    "force_angle": (lambda x: pp.motion_angle(make_scene(2.0), x), [0.0, -np.inf, np.inf]),
    "inertia_share": (
        lambda x: pp.spin_ratio(make_scene(2.0, 1.0, BOTH), 1.0, x), [0.5, 1.5, -1.0],
    ),
}  # fmt: skip


@pytest.mark.parametrize("shape", [(3,), (3, 1)])
@pytest.mark.parametrize("name", FIRST_WRONG)
def test_an_array_is_refused_with_its_first_wrong_number(name, shape):
    call, values = FIRST_WRONG[name]
    call(np.full(shape, values[0]))
    for given in (np.reshape(values, shape), xr.DataArray(values, dims="case"), list(values)):
        with pytest.raises(pp.InvalidValue) as caught:
            call(given)
        assert (caught.value.name, caught.value.given) == (name, values[1])


@pytest.mark.parametrize("name", FIRST_WRONG)
@pytest.mark.parametrize("dtype", [bool, complex, str, "M8[s]", "m8[s]", "S1"])
def test_an_array_of_no_numbers_is_refused(name, dtype):
    for given in (np.ones(2, "i8").astype(dtype), np.ones(2, "i8").astype(dtype).astype(object)):
        with pytest.raises(pp.InvalidValue, match=name):
            FIRST_WRONG[name][0](given)


@pytest.mark.parametrize("call", [
    lambda x: pp.limit_curve(make_scene(2.0), x),
    lambda x: pp.motion_angle(make_scene(2.0), x),
    lambda x: pp.spin_ratio(make_scene(2.0), x),
    lambda x: pp.motion_centers(make_scene(2.0), x),
])  # fmt: skip
def test_force_angle(call):
    check(
        lambda: call(np.inf), "force_angle", np.inf,
        "radians in [-4 pi, 4 pi]",
        "convert degrees with np.deg2rad, and wrap unwrapped radians with np.mod(angle, 2 * np.pi)",
    )  # fmt: skip


def test_the_paper_s_bound_needs_the_mass_on_the_ring():
    for ratio in (0.9, 1.1):
        scene = make_scene(2.0, 1.0, [pp.RingFriction(), pp.Inertia(gyration_radius=ratio)])
        check(
            lambda scene=scene: pp.conservative_motion_cone(scene), "gyration_radius", ratio,
            "the radius of the ring", "use motion_cone, which is exact for every radius of gyration",
        )  # fmt: skip


def test_blocks_of_a_lazy_array_are_refused_when_they_are_computed():
    length = xr.DataArray([1.0, -2.0, 3e6], dims="case").chunk(case=1)
    parts = [
        pp.solve(make_scene(length[[i]], 1.0), 1.0).solutions for i in range(3)
    ]  # fmt: skip
    assert parts[0].compute() == 1
    for part, given in zip(parts[1:], (-2.0, 3e6), strict=True):
        with pytest.raises(pp.InvalidValue, match="rod_length") as caught:
            part.compute()
        assert caught.value.given == given
