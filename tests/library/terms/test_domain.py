"""Every refusal of the mechanics: name, given, allowed, remedy."""

from __future__ import annotations

import dataclasses
from decimal import Decimal

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from mechanics.builders import BOTH, FRICTION, INERTIA, PSI, make_scene

import planar_pushing as pp

NOT_NUMBERS = [
    "2", b"2", None, True, np.True_, float("nan"), 1j, Decimal(1), ["1.0"], [[1.0], [2.0, 3.0]],
]  # fmt: skip


def check(call, name, given, allowed, remedy):
    with pytest.raises(pp.InvalidValue) as caught:
        call()
    error = caught.value
    assert (error.name, error.allowed, error.remedy) == (name, allowed, remedy)
    assert error.given is given or error.given == given
    assert str(error) == f"{name}: {given!r} given; allowed: {allowed}; {remedy}"


@pytest.mark.parametrize(
    "given", [each for each in [*NOT_NUMBERS, -1.0, np.inf, -np.inf] if each is not None], ids=repr
)
def test_pusher_magnitude(given):
    check(
        lambda: pp.solve(make_scene(1.0), 1.0, given), "pusher_magnitude", given,
        "a finite number >= 0", "reverse the pusher by its angle, not by a sign",
    )  # fmt: skip


def test_a_slider_without_a_radius_knows_no_ratio():
    check(
        lambda: pp.Slider(rod_length=1.0, rod_angle=PSI).length_ratio, "radius", None,
        "a number, given or filled in by a scene", "ask the slider of a scene",
    )  # fmt: skip


ANGLE = "radians in [-4 pi, 4 pi]"
DEGREES = (
    "convert degrees with np.deg2rad, and wrap unwrapped radians with np.mod(angle, 2 * np.pi)"
)
NO_ANGLES = [
    *(given for given in NOT_NUMBERS if given is not None and given == given),
    *(np.inf, -np.inf, 90, -90, 12.6, 10**400, (0.1, 1.0), (1.0,)),
    *(
        np.float64(90.0),
        np.float32(-90.0),
        np.float16(90.0),
        np.int64(90),
        np.uint8(90),
        np.array(90),
    ),
    *(np.array([0.0, 90.0]), np.arange(0, 181, 45), [0.0, 90.0], [[0.0], [-12.6]]),
    *(xr.DataArray(90.0), xr.DataArray([0, 90], dims="case"), pd.Series([0.0, 90.0], index=[1, 0])),
]


def test_an_angle_of_nan_is_not_taken_for_degrees():
    for given in (np.nan, np.array([1.0, np.nan]), [np.nan, 1.0]):
        with pytest.raises(pp.InvalidValue, match=r"nan given; .*; give finite numbers: NaN"):
            pp.solve(make_scene(1.0), given)
    with pytest.raises(pp.InvalidValue, match="give finite numbers: NaN"):
        pp.Slider(rod_length=1.0, rod_angle=np.nan)
    with pytest.raises(pp.InvalidValue, match="give finite numbers: NaN"):
        pp.Until(rotation=np.nan)


@pytest.mark.parametrize("given", NO_ANGLES, ids=lambda given: repr(given)[:20])
class TestAngles:
    def test_pusher_angle(self, given):
        with pytest.raises(pp.InvalidValue) as caught:
            pp.solve(make_scene(1.0), given)
        error = caught.value
        assert (error.name, error.allowed) == ("pusher_angle", ANGLE)
        assert error.remedy == f"{DEGREES}; the angle of a velocity is np.arctan2(v_y, v_x)"
        assert "\n" not in str(error)

    @pytest.mark.parametrize("function", [pp.motion_angle, pp.limit_curve, pp.motion_centers])
    def test_force_angle(self, given, function):
        with pytest.raises(pp.InvalidValue) as caught:
            function(make_scene(1.0), given)
        error = caught.value
        assert (error.name, error.allowed, error.remedy) == ("force_angle", ANGLE, DEGREES)

    def test_angle_of_an_interval(self, given):
        cone = pp.motion_cone(make_scene(1.0))
        for call in (cone.contains, cone.__contains__):
            with pytest.raises(pp.InvalidValue, match=r"degrees with np\.deg2rad"):
                call(given)

    def test_push_of_a_scene(self, given):
        with pytest.raises(pp.InvalidValue) as caught:
            dataclasses.replace(make_scene(1.0), push=(given, 1.0))
        assert (caught.value.name, caught.value.allowed) == ("pusher_angle", ANGLE)


@pytest.mark.parametrize("function", [pp.solve, pp.motion_angle, pp.limit_curve, pp.motion_centers])
def test_lazy_angles_in_degrees_are_refused_when_they_are_computed(function):
    angles = xr.DataArray([1.0, 90.0], dims="case").chunk(case=1)
    found = function(make_scene(1.0), angles)
    found.isel(case=0).compute()
    with pytest.raises(pp.InvalidValue, match=r"90\.0 given; allowed: radians in \[-4 pi, 4 pi\]"):
        found.isel(case=1).compute()


@pytest.mark.parametrize(
    "given",
    [
        *(
            4 * np.pi,
            -4 * np.pi,
            np.deg2rad(720.0),
            np.float32(-12.5),
            np.int8(12),
            np.array(-12.0),
        ),
        *(xr.DataArray(12.0), np.mod(90.0, 2 * np.pi)),
    ],
    ids=repr,
)
def test_angles_that_are_allowed(given):
    turn = np.array([float(given) % (2 * np.pi)])
    one, other = pp.solve(make_scene(1.0), given), pp.solve(make_scene(1.0), turn)
    assert int(np.asarray(one.outcome)) == other.outcome[0]


def test_without_an_angle_the_push_is_that_of_the_scene():
    scene = make_scene(1.0)
    check(
        lambda: pp.solve(scene), "pusher_angle", None, "radians, for a scene whose file holds no push",
        "give the angle of the push, np.deg2rad(90) for one into the slider",
    )  # fmt: skip
    pushed = dataclasses.replace(scene, push=(0.3, 2.0))
    assert pp.solve(pushed) == pp.solve(scene, 0.3, 2.0)
    assert pp.solve(pushed, pusher_magnitude=3.0) == pp.solve(scene, 0.3, 3.0)
    assert pp.solve(pushed, 0.5) == pp.solve(scene, 0.5, 1.0)


def scene_of_types(convert):
    """A scene of two scenes whose numbers are converted to a type."""
    length, mass, mu, radius = (convert([a, b]) for a, b in ((3, 2), (100, 120), (1, 2), (2, 4)))
    return pp.Scene(
        slider=pp.Slider(
            rod_length=length, rod_angle=1.0, radius=radius, side=(-1.0, convert([1, 2]))
        ),
        contact=pp.Coulomb(mu),
        effects=(
            pp.SupportFriction(support=pp.Disc(2.0), weight=mass),
            pp.Inertia(mass=mass, gyration_radius=radius, center=(convert([0, 1]), 0)),
            pp.Load(force=(convert([1, 2]), 0)),
        ),
    )


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "i4", "i8", "u8", "f2", "f4", object])
def test_parameters_of_any_type_are_doubles(dtype):
    expected = pp.solve(scene_of_types(np.array), 1.0)
    found = pp.solve(scene_of_types(lambda each: np.array(each, dtype)), 1.0)
    assert found == expected
    labeled = pp.solve(
        scene_of_types(lambda each: xr.DataArray(np.array(each, dtype), dims="case")), 1.0
    )
    for name in ("twist", "force", "mode"):
        assert np.array_equal(labeled[name].values, getattr(expected, name), equal_nan=True)


def test_the_index_of_a_table_does_not_count():
    """Columns of two tables are combined by position, in every formula."""
    expected = scene_of_types(np.array)
    order = iter(([0, 1], [1, 0], [0, 1], [1, 0], [0, 1], [1, 0], [0, 1]))
    scene = scene_of_types(lambda each: pd.Series(each, index=next(order)))
    angle = pd.Series([1.0, 1.5], index=[1, 0])
    assert pp.solve(scene, angle) == pp.solve(expected, angle.to_numpy())
    assert type(scene.slider.rod_length) is np.ndarray


MASKED = np.ma.masked_array([1.0, 2.0], [True, False])


@pytest.mark.parametrize("call", [
    lambda x: pp.Slider(rod_length=x, rod_angle=1.0), lambda x: pp.Slider(rod_length=1.0, rod_angle=x),
    lambda x: pp.Slider(rod_length=1.0, rod_angle=1.0, radius=x),
    lambda x: pp.Slider(rod_length=1.0, rod_angle=1.0, side=(-1.0, x)),
    pp.Coulomb, lambda x: pp.RingFriction(weight=x), lambda x: pp.Inertia(mass=x),
    lambda x: pp.Inertia(gyration_radius=x), lambda x: pp.Inertia(center=(x, 0.0)),
    lambda x: pp.Load(force=(x, 0.0)), lambda x: pp.Viscous(support=pp.Ring(1.0), coefficient=x),
    lambda x: pp.solve(make_scene(1.0), x), lambda x: pp.solve(make_scene(1.0), 1.0, x),
    lambda x: pp.motion_angle(make_scene(1.0), x), lambda x: pp.weight(x, 1.0),
    lambda x: pp.spin_ratio(make_scene(1.0, effects=BOTH), 1.0, x),
    lambda x: pp.motion_cone(make_scene(1.0)).contains(x),
    lambda x: pp.wrench(pp.Inertia(), np.ma.masked_array([1.0, 2.0, 3.0], [True, False, False])),
])  # fmt: skip
def test_masked_entries_are_refused(call):
    for given in (np.ma.masked, MASKED):
        with pytest.raises(
            pp.InvalidValue, match=r"masked.*; fill the masked entries, or leave them out$"
        ):
            call(given)


@pytest.mark.parametrize("side", [(-1.0, []), ([], 1.0), (-1.0, np.empty((2, 0)))], ids=repr)
def test_a_side_has_ends(side):
    with pytest.raises(pp.InvalidValue, match=r"^side: .* start <= 0 <= end"):
        pp.Slider(rod_length=1.0, rod_angle=PSI, side=side)


@pytest.mark.parametrize("given", [True, np.True_, 1, 0, False])
def test_derivatives_are_on_or_off(given):
    assert (pp.solve(make_scene(1.0), 1.0, derivatives=given)[0].derivatives is not None) is bool(
        given
    )


@pytest.mark.parametrize("given", [np.array([True, False]), "no", None, [1]], ids=repr)
def test_derivatives_are_nothing_else(given):
    for call in (pp.solve, pp.motion_of_force):
        with pytest.raises(
            pp.InvalidValue, match=r"^derivatives: .* given; allowed: True or False; "
        ):
            call(make_scene(1.0), 1.0, derivatives=given)


def test_a_whole_dataset_is_no_number():
    with pytest.raises(pp.InvalidValue, match=r"rod_length: <xarray\.Dataset> .* given"):
        pp.Slider(rod_length=xr.Dataset({"length": ("scene", [1.0, 2.0])}), rod_angle=PSI)


@pytest.mark.parametrize(
    "given", [(), [], None, pp.RingFriction(), (1.0,), (None,), "ab"], ids=repr
)
def test_effects(given):
    slider = pp.Slider(rod_length=1.0, rod_angle=PSI)
    check(
        lambda: pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=given), "effects", given,
        "a tuple of SupportFriction, RingFriction, Inertia, Viscous and Load",
        "list what resists the motion, for instance (RingFriction(),)",
    )  # fmt: skip


@pytest.mark.parametrize(
    "given", [None, 2.0, "infinite", [], [pp.Coulomb(1.0), [pp.Coulomb(1.0)] * 2]], ids=repr
)
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
            "give s / (1 + s) with s = m a / W, or force_ratio = |f| / W; motion_cone and solve need none",
        )  # fmt: skip

    def test_with_a_force_ratio(self, function):
        check(
            lambda: function(make_scene(1.0, effects=BOTH), 0.3, 0.5, force_ratio=1.0),
            "inertia_share", 0.5, "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W, or force_ratio = |f| / W; motion_cone and solve need none",
        )  # fmt: skip

    def test_where_it_does_not_determine_the_motion(self, function):
        effects = (pp.RingFriction(), pp.Inertia(center=(0.1, 0.0)))
        check(
            lambda: function(make_scene(1.0, effects=effects), 0.3, 0.5), "inertia_share", 0.5,
            "None if the effects are not isotropic about the slider's center",
            "give force_ratio = |f| / W: several motions can share one m a / W",
        )  # fmt: skip

    @pytest.mark.parametrize("given", [-1e-9, 1.1, float("nan"), "half"], ids=repr)
    def test_out_of_range(self, function, given):
        check(
            lambda: function(make_scene(1.0, effects=BOTH), 0.3, given), "inertia_share", given,
            "numbers in [0, 1]", "give s / (1 + s) with s = m a / W",
        )  # fmt: skip


@pytest.mark.parametrize("function", [pp.spin_ratio, pp.motion_angle, pp.motion_centers])
@pytest.mark.parametrize("given", [0.0, -1.0, float("inf"), "one"], ids=repr)
def test_force_ratio(function, given):
    check(
        lambda: function(make_scene(1.0, effects=BOTH), 0.3, force_ratio=given), "force_ratio", given,
        "a finite number > 0", "give |f| / W",
    )  # fmt: skip


def test_whole_numbers_are_numbers():
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2, rod_angle=1, radius=np.float64(1)),
        contact=pp.Coulomb(2),
        effects=(pp.RingFriction(weight=1), pp.Inertia(mass=1, gyration_radius=1)),
    )
    assert pp.solve(scene, 1, 1).outcome is pp.Outcome.UNIQUE
