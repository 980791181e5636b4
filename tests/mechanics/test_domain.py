"""Every refusal of the mechanics: name, given, allowed, remedy."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene

NOT_NUMBERS = ["2", None, True, float("nan"), 1j, ["1.0"], [[1.0], [2.0, 3.0]]]
FINITE_POSITIVE = "a finite number > 0"
FINITE = "a finite number >= 0"
NO_FRICTION = "leave the effect out of the scene if the support is frictionless"
NO_INERTIA = "leave the effect out of the scene if the slider has no inertia"


def check(call, name, given, allowed, remedy):
    with pytest.raises(pp.InvalidValue) as caught:
        call()
    error = caught.value
    assert (error.name, error.allowed, error.remedy) == (name, allowed, remedy)
    assert error.given is given or error.given == given
    assert str(error) == f"{name}: {given!r} given; allowed: {allowed}; {remedy}"


@pytest.mark.parametrize("given", [*NOT_NUMBERS, -1.0, np.inf, -np.inf], ids=repr)
class TestNumbers:
    def test_rod_length(self, given):
        check(
            lambda: pp.Slider(rod_length=given, rod_angle=PSI), "rod_length", given, FINITE,
            "give the distance from the contact to the ring centre",
        )  # fmt: skip

    def test_rod_angle(self, given):
        check(
            lambda: pp.Slider(rod_length=1.0, rod_angle=given), "rod_angle", given,
            "radians in the open interval (0, pi)", "keep the slider above the fence",
        )  # fmt: skip

    def test_radius(self, given):
        check(
            lambda: pp.Slider(rod_length=1.0, rod_angle=PSI, radius=given), "radius", given,
            FINITE_POSITIVE, "give the ring's radius in the unit of the rod length",
        )  # fmt: skip

    def test_weight(self, given):
        check(lambda: pp.RingFriction(weight=given), "weight", given, FINITE_POSITIVE, NO_FRICTION)

    def test_mass(self, given):
        check(lambda: pp.Inertia(mass=given), "mass", given, FINITE_POSITIVE, NO_INERTIA)

    def test_gyration_radius(self, given):
        check(
            lambda: pp.Inertia(gyration_radius=given),
            "gyration_radius", given, FINITE_POSITIVE, NO_INERTIA,
        )  # fmt: skip

    def test_friction_coefficient(self, given):
        check(
            lambda: pp.Coulomb(given), "friction_coefficient", given, "a number in [0, 1e+09]",
            "use the law of infinite friction where no coefficient is large enough",
        )  # fmt: skip

    def test_pusher_magnitude(self, given):
        check(
            lambda: pp.solve(make_scene(1.0), 1.0, given), "pusher_magnitude", given, FINITE,
            "turn the pusher around by its angle, not by a sign",
        )  # fmt: skip


@pytest.mark.parametrize("given", [*NOT_NUMBERS, np.inf, -np.inf], ids=repr)
def test_pusher_angle(given):
    check(
        lambda: pp.solve(make_scene(1.0), given), "pusher_angle", given,
        "a finite number of radians", "give one angle",
    )  # fmt: skip


def test_an_integer_beyond_the_floats_is_not_a_finite_number():
    with pytest.raises(pp.InvalidValue, match="allowed: a finite number >= 0"):
        pp.Slider(rod_length=10**400, rod_angle=PSI)


@pytest.mark.parametrize("given", [0.0, np.pi, 4.0])
def test_rod_angle_is_strictly_above_the_fence(given):
    with pytest.raises(pp.InvalidValue, match=r"open interval \(0, pi\)"):
        pp.Slider(rod_length=1.0, rod_angle=given)


@pytest.mark.parametrize("call", [
    lambda: pp.RingFriction(weight=0.0),
    lambda: pp.Inertia(mass=0.0),
    lambda: pp.Inertia(gyration_radius=0.0),
    lambda: pp.Slider(rod_length=1.0, rod_angle=PSI, radius=0.0),
])  # fmt: skip
def test_zero_is_not_positive(call):
    with pytest.raises(pp.InvalidValue, match=r"0\.0 given; allowed: a finite number > 0"):
        call()


@pytest.mark.parametrize("given", ["both", "", None, 1], ids=repr)
def test_at_zero_normal(given):
    check(
        lambda: pp.InfiniteFriction(at_zero_normal=given), "at_zero_normal", given,
        '"free" or "none"', 'choose "free" for definition 1 and "none" for definition 2',
    )  # fmt: skip


@pytest.mark.parametrize(
    "given", [(), [], None, pp.RingFriction(), (1.0,), (None,), "ab"], ids=repr
)
def test_effects(given):
    slider = pp.Slider(rod_length=1.0, rod_angle=PSI)
    check(
        lambda: pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=given), "effects", given,
        "a tuple of at least one of RingFriction and Inertia",
        "list what resists the motion, for instance (RingFriction(),)",
    )  # fmt: skip


@pytest.mark.parametrize("given", [None, 2.0, "infinite"], ids=repr)
def test_contact(given):
    slider = pp.Slider(rod_length=1.0, rod_angle=PSI)
    check(
        lambda: pp.Scene(slider=slider, contact=given, effects=FRICTION), "contact", given,
        "Coulomb, InfiniteFriction or PerfectlyRough", "construct one of these laws",
    )  # fmt: skip


def test_classes_are_not_instances():
    slider = pp.Slider(rod_length=1.0, rod_angle=PSI)
    with pytest.raises(pp.InvalidValue, match="construct one of these laws"):
        pp.Scene(slider=slider, contact=pp.InfiniteFriction, effects=FRICTION)
    with pytest.raises(pp.InvalidValue, match="list what resists the motion"):
        pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=(pp.RingFriction,))


@pytest.mark.parametrize("function", [pp.spin_ratio, pp.motion_angle, pp.motion_centers])
class TestInertiaShare:
    @pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
    def test_superfluous(self, function, effects):
        check(
            lambda: function(make_scene(1.0, effects=effects), 0.3, 0.5), "inertia_share", 0.5,
            "None for a scene whose effects are of one kind", "leave the argument out",
        )  # fmt: skip

    def test_missing(self, function):
        check(
            lambda: function(make_scene(1.0, effects=BOTH), 0.3), "inertia_share", None,
            "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W; motion_cone and solve need none",
        )  # fmt: skip

    @pytest.mark.parametrize("given", [-1e-9, 1.1, float("nan"), "half"], ids=repr)
    def test_out_of_range(self, function, given):
        check(
            lambda: function(make_scene(1.0, effects=BOTH), 0.3, given), "inertia_share", given,
            "numbers in [0, 1]", "give s / (1 + s) with s = m a / W",
        )  # fmt: skip


def test_whole_numbers_are_numbers():
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2, rod_angle=1, radius=np.float64(1)),
        contact=pp.Coulomb(2),
        effects=(pp.RingFriction(weight=1), pp.Inertia(mass=1, gyration_radius=1)),
    )
    assert pp.solve(scene, 1, 1).outcome is pp.Outcome.UNIQUE


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
    "friction_coefficient": (
        pp.Coulomb, 1e9, 1.001e9, 1.001e9, "a number in [0, 1e+09]",
        "use the law of infinite friction where no coefficient is large enough",
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
        "leave the effect out that has no part in the motion",
    ),
    "small pusher_magnitude": (
        lambda x: push(magnitude=x, weight=0.5, mass=4.0), 1.25e-13, 1.2e-13, 9.6e-13,
        "m a / W in [1e-12, 1e+12] for a scene with friction and inertia",
        "leave the effect out that has no part in the motion",
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
    assert error.given == pytest.approx(shown, rel=1e-12)


@pytest.mark.parametrize("magnitude", [1e-300, 1e-13, 1e13, 1e300])
@pytest.mark.parametrize("effects", [FRICTION, INERTIA], ids=["friction", "inertia"])
def test_one_effect_takes_a_push_of_any_magnitude(effects, magnitude):
    assert len(pp.solve(make_scene(2.0, 1.0, effects), 1.0, magnitude)) == 1


def test_a_resting_pusher_has_no_share_to_be_refused():
    assert len(push(magnitude=0.0)) == 1


#: Of each parameter a call with an array and what it refuses in it.
FIRST_WRONG = {
    "rod_length": (lambda x: slider(x), [1.0, -2.0, -3.0]),
    "rod_angle": (lambda x: slider(psi=x), [1.0, 4.0, 0.0]),
    "radius": (lambda x: slider(radius=x), [1.0, 0.0, -1.0]),
    "friction_coefficient": (pp.Coulomb, [0.0, 2e9, -1.0]),
    "weight": (lambda x: pp.RingFriction(weight=x), [1.0, -1.0, 0.0]),
    "mass": (lambda x: pp.Inertia(mass=x), [1.0, np.inf, 0.0]),
    "gyration_radius": (lambda x: pp.Inertia(gyration_radius=x), [1.0, -1.0, 0.0]),
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
@pytest.mark.parametrize("dtype", [bool, complex, object, str])
def test_an_array_of_no_numbers_is_refused(name, dtype):
    with pytest.raises(pp.InvalidValue, match=name):
        FIRST_WRONG[name][0](np.ones(2, dtype=dtype))


@pytest.mark.parametrize("call", [
    lambda x: pp.limit_curve(make_scene(2.0), x),
    lambda x: pp.motion_angle(make_scene(2.0), x),
    lambda x: pp.spin_ratio(make_scene(2.0), x),
    lambda x: pp.motion_centers(make_scene(2.0), x),
])  # fmt: skip
def test_force_angle(call):
    check(
        lambda: call(np.inf), "force_angle", np.inf, "a finite number of radians",
        "give the angle of a force",
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
