"""One mechanism for floats, numpy arrays and DataArrays, in every parameter of every function."""

from __future__ import annotations

import dask
import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, EVERY_EFFECT, FRICTION, INERTIA, make_scene

import planar_pushing as pp
from planar_pushing.terms.quantities import unit_of

BASE = {
    "rod_length": 2.0,
    "rod_angle": 0.8,
    "radius": 1.5,
    "weight": 1.2,
    "mass": 0.7,
    "gyration_radius": 0.9,
    "friction_coefficient": 1.4,
    "pusher_angle": 0.3,
    "pusher_magnitude": 1.1,
    "force_angle": 1.2,
    "inertia_share": 0.4,
}
#: Values of each parameter; those of the pusher meet separation, sticking and both slips.
VALUES = {name: value * np.array([0.4, 1.0, 1.7]) for name, value in BASE.items()}
VALUES["pusher_angle"] = np.array([-0.2, 1.0, 2.9])
ANGLES = ("spin_ratio", "motion_angle", "motion_centers", "limit_curve")
CONES = ("motion_cone", "conservative_motion_cone", "friction_cone")
FLAGS = ("can_pull", "slips_while_pushing")
UNITS = {
    "spin_ratio": "1", "motion_angle": "radian", "motion_cone": "radian",
    "conservative_motion_cone": "radian", "motion_centers": "length",
}  # fmt: skip


def scene_of(given, effects=BOTH):
    kinds = {
        FRICTION: (pp.RingFriction(weight=given["weight"]),),
        INERTIA: (pp.Inertia(mass=given["mass"], gyration_radius=given["gyration_radius"]),),
    }
    slider = pp.Slider(**{name: given[name] for name in ("rod_length", "rod_angle", "radius")})
    law = given.get("contact") or pp.Coulomb(given["friction_coefficient"])
    found = kinds[FRICTION] + kinds[INERTIA] if effects == BOTH else kinds[effects]
    return pp.Scene(slider=slider, contact=law, effects=found)


def call(name, given, effects=BOTH):
    """A public function at the parameters that it takes."""
    if name == "conservative_motion_cone":
        given = {**given, "gyration_radius": given["radius"]}
    if name == "limit_curve" and effects == BOTH:  # both effects have no single curve
        effects = FRICTION
    scene, function = scene_of(given, effects), getattr(pp, name)
    if name == "solve":
        return function(scene, given["pusher_angle"], given["pusher_magnitude"])
    if name == "limit_curve":
        return function(scene, given["force_angle"])
    if name in ANGLES:
        share = given["inertia_share"] if effects == BOTH else None
        return function(scene, given["force_angle"], share)
    return function(scene)


def numbers(found):
    """What a function gives, as arrays without names."""
    if isinstance(found, pp.AngleInterval):
        return [np.asarray(each) for each in (found.right, found.left, found.closed)]
    if isinstance(found, pp.LimitCurve):
        return [np.asarray(getattr(found, name)) for name in found.__slots__]
    return [np.asarray(found)]


FUNCTIONS = (*ANGLES, *CONES, *FLAGS)


@EVERY_EFFECT
@pytest.mark.parametrize("name", FUNCTIONS)
def test_floats_give_floats(name, effects):
    found = call(name, BASE, effects)
    if name == "motion_centers":
        assert found.shape == (2,)
    elif name in FLAGS:
        assert isinstance(found, bool | np.bool_)
    elif isinstance(found, pp.AngleInterval):
        assert isinstance(found.right, float)
        assert isinstance(found.left, float)
        assert isinstance(found.closed, bool)
    elif name == "limit_curve":
        assert type(found.status) is int
        curve = set(found.__slots__) - {"status"}
        assert all(isinstance(getattr(found, each), float) for each in curve)
    else:
        assert type(found) is float


@pytest.mark.parametrize("parameter", [name for name in BASE if not name.startswith("pusher")])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_parameter_may_be_an_array(name, parameter):
    """Bit for bit what the function gives of each number alone."""
    values = VALUES[parameter]
    found = numbers(call(name, {**BASE, parameter: values}))
    for i, value in enumerate(values.tolist()):
        single = numbers(call(name, {**BASE, parameter: value}))
        for array, number in zip(found, single, strict=True):
            assert np.array_equal(np.broadcast_to(array, (3, *number.shape))[i], number)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_arrays_are_broadcast(name):
    given = {
        **BASE, "rod_length": np.array([[[0.5]], [[2.0]]]), "weight": np.array([[1.0], [2.0]]),
        "force_angle": np.array([0.1, 1.0, 2.0]), "rod_angle": np.array([0.5, 1.0, 2.0]),
    }  # fmt: skip
    found = numbers(call(name, given))
    for place in np.ndindex(2, 2, 3):
        here = {
            **BASE, "rod_length": given["rod_length"][place[0], 0, 0].item(),
            "weight": given["weight"][place[1], 0].item(),
            "force_angle": given["force_angle"][place[2]].item(),
            "rod_angle": given["rod_angle"][place[2]].item(),
        }  # fmt: skip
        single = numbers(call(name, here))
        for array, number in zip(found, single, strict=True):
            whole = np.broadcast_to(array, (2, 2, 3, *number.shape))
            assert np.array_equal(whole[place], number)


THREE = np.array([pp.Coulomb(1.0), pp.Coulomb(2.0), pp.PerfectlyRough()], dtype=object)


@pytest.mark.parametrize("call", [
    lambda: pp.solve(make_scene(2.0, THREE), np.zeros(4)),
    lambda: pp.motion_cone(make_scene(np.ones(4), THREE)),
    lambda: pp.motion_angle(make_scene(np.ones(3)), np.zeros(4)),
    lambda: pp.limit_curve(make_scene(np.ones(3)), np.zeros(4)),
])  # fmt: skip
def test_arrays_that_do_not_broadcast_are_refused(call):
    with pytest.raises(pp.InvalidValue, match=r"\(3,\).*allowed: arrays that broadcast") as caught:
        call()
    assert caught.value.name == "shapes"
    assert "(4,)" in caught.value.given
    assert "xarray.DataArray" in caught.value.remedy


def labeled(parameter, dim, values=None):
    return xr.DataArray(VALUES[parameter] if values is None else values, dims=dim)


@pytest.mark.parametrize("name", UNITS)
def test_dataarrays_are_broadcast_by_name_and_have_units(name):
    given = {
        **BASE, "rod_length": labeled("rod_length", "length"),
        "friction_coefficient": labeled("friction_coefficient", "mu", VALUES["mass"][:2]),
        "force_angle": labeled("force_angle", "phi"),
    }  # fmt: skip
    found = call(name, given)
    plain = {
        **given, "rod_length": VALUES["rod_length"][:, None, None],
        "friction_coefficient": VALUES["mass"][:2, None],
        "force_angle": VALUES["force_angle"],
    }  # fmt: skip
    expected = numbers(call(name, plain))
    parts = [found.right, found.left] if isinstance(found, xr.Dataset) else [found]
    for part, array in zip(parts, expected, strict=False):
        assert set(part.dims) <= {"length", "mu", "phi", "xy"}
        assert unit_of(part.attrs) == UNITS[name]
        assert part.attrs["long_name"]
        order = [each for each in ("length", "mu", "phi", "xy") if each in part.dims]
        ordered = part.transpose(*order)
        shape = [3 if each in ("length", "phi") else 2 for each in order]
        assert list(ordered.shape) == shape
        assert np.array_equal(ordered.values.squeeze(), array.squeeze())


@pytest.mark.parametrize("name", CONES)
def test_a_labeled_cone_is_a_dataset(name):
    found = call(name, {**BASE, "friction_coefficient": labeled("friction_coefficient", "mu")})
    plain = call(name, {**BASE, "friction_coefficient": VALUES["friction_coefficient"]})
    status = {"status"} if name == "motion_cone" else set()
    assert set(found.data_vars) == {"right", "left", "closed"} | status
    units = {key: found[key].attrs["units"] for key in ("right", "left", "closed")}
    assert units == {"right": "radian", "left": "radian", "closed": "1"}
    for key in units:
        assert np.array_equal(found[key], np.broadcast_to(getattr(plain, key), found[key].shape))


@pytest.mark.parametrize("name", FLAGS)
def test_a_labeled_flag_has_a_name_and_a_unit(name):
    found = call(name, {**BASE, "rod_length": labeled("rod_length", "length")})
    assert found.dims == ("length",)
    assert found.attrs["units"] == "1"
    assert np.array_equal(found, call(name, {**BASE, "rod_length": VALUES["rod_length"]}))


def test_coordinates_are_kept():
    length = xr.DataArray([1.0, 2.0], dims="length", coords={"length": ("length", [10, 20])})
    found = pp.motion_angle(make_scene(length), 0.3)
    assert found.length.values.tolist() == [10, 20]
    assert found.name == "motion_angle"


def test_a_labeled_limit_curve_is_a_dataset():
    length = labeled("rod_length", "length")
    found = pp.limit_curve(make_scene(length), xr.DataArray([0.1, 0.2], dims="phi"))
    assert isinstance(found, xr.Dataset)
    units = {name: unit_of(found[name].attrs) for name in found.data_vars}
    assert units == {
        "magnitude": "force",
        "spin_ratio": "1",
        "motion_angle": "radian",
        "status": "1",
    }
    assert dict(found.sizes) == {"length": 3, "phi": 2}
    plain = pp.limit_curve(make_scene(VALUES["rod_length"][:, None]), np.array([0.1, 0.2]))
    assert np.array_equal(found.magnitude, plain.magnitude)
    assert np.array_equal(found.motion_angle, plain.motion_angle)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_lazy_arrays_stay_lazy_and_equal_the_eager_ones(name):
    eager = {
        **BASE, "rod_length": labeled("rod_length", "length"), "weight": labeled("weight", "w"),
        "force_angle": labeled("force_angle", "phi"),
        "friction_coefficient": labeled("friction_coefficient", "length"),
    }  # fmt: skip
    lazy = {
        key: each.chunk({each.dims[0]: 2}) if isinstance(each, xr.DataArray) else each
        for key, each in eager.items()
    }
    found, expected = call(name, lazy), call(name, eager)
    if isinstance(found, xr.Dataset):
        pairs = [(found[each], expected[each]) for each in found.data_vars]
    else:
        pairs = [(found, expected)]
    for one, other in pairs:
        assert dask.is_dask_collection(one)
        xr.testing.assert_identical(one.compute(), other)


def test_an_array_of_laws_of_any_kinds():
    laws = [
        pp.Coulomb(0.3),
        pp.InfiniteFriction(),
        pp.InfiniteFriction("none"),
        pp.PerfectlyRough(),
    ]
    every = np.array(laws, dtype=object)
    cone = pp.motion_cone(make_scene(2.0, every))
    flags = pp.slips_while_pushing(make_scene(2.0, every))
    for i, law in enumerate(laws):
        single = pp.motion_cone(make_scene(2.0, law))
        assert (cone.right[i], cone.left[i], cone.closed[i]) == (
            single.right, single.left, single.closed,
        )  # fmt: skip
        assert flags[i] == pp.slips_while_pushing(make_scene(2.0, law))
