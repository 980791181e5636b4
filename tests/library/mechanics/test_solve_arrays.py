"""Contact modes over arrays of scenes, in the units that the scene has."""

from __future__ import annotations

import dask
import numpy as np
import pytest
import xarray as xr
from mechanics.builders import BOTH, EFFECT_SETS, EVERY_EFFECT, FRICTION, INERTIA, make_scene
from mechanics.test_public_arrays import BASE, VALUES, call

import planar_pushing as pp
from planar_pushing.mechanics.solve import SOLUTIONS
from planar_pushing.terms.quantities import unit_of

FIELDS = ("force", "force_end", "twist", "contact_motion", "spin_ratio", "center")
#: Every parameter of a push with every set of effects that has it.
PARAMETERS = [
    pytest.param(effects, name, id=f"{key}-{name}")
    for key, effects in EFFECT_SETS.items()
    for name in BASE
    if name not in ("force_angle", "inertia_share")
    and (name != "weight" or effects != INERTIA)
    and (name not in ("mass", "gyration_radius") or effects != FRICTION)
]


def same(found, place, single):
    """Whether a place of an array of problems holds bit for bit the solutions of one problem."""
    count = len(single)
    assert found.solutions[place] == count
    assert tuple(found.mode[place][:count]) == single.modes
    assert np.all(found.mode[place][count:] == -1)
    assert found.outcome[place] == single.outcome
    assert np.array_equal(found.consistent[place], np.arange(found.mode.shape[-1]) < count)
    for name in FIELDS:
        values = getattr(found, name)[place]
        assert np.all(np.isnan(values[count:]))
        for value, solution in zip(values, single, strict=False):
            assert np.array_equal(value, getattr(solution, name), equal_nan=True)


@pytest.mark.parametrize(("effects", "parameter"), PARAMETERS)
def test_every_parameter_may_be_an_array(effects, parameter):
    values = VALUES[parameter]
    found = call("solve", {**BASE, parameter: values}, effects)
    for i, value in enumerate(values.tolist()):
        single = call("solve", {**BASE, parameter: value}, effects)
        same(found, (i,), single)


@EVERY_EFFECT
def test_arrays_of_different_scenes_and_laws(effects):
    random = np.random.default_rng(11)
    length, psi = 10 ** random.uniform(-1, 1, (4, 1)), random.uniform(0.2, 2.9, (4, 1))
    laws = [
        pp.Coulomb(1.4),
        pp.InfiniteFriction(),
        pp.InfiniteFriction("none"),
        pp.PerfectlyRough(),
    ]
    contact = np.array(laws, dtype=object)[:, None]
    angle, magnitude = random.uniform(-3.1, 3.1, 25), 10 ** random.uniform(-2, 2, 25)
    found = pp.solve(make_scene_of(length, contact, effects, psi), angle, magnitude)
    assert found.solutions.shape == (4, 25)
    for i, j in np.ndindex(4, 25):
        scene = make_scene_of(length[i, 0], laws[i], effects, psi[i, 0])
        same(found, (i, j), pp.solve(scene, angle[j], magnitude[j]))


def make_scene_of(length, contact, effects, psi):
    slider = pp.Slider(rod_length=length, rod_angle=psi)
    return pp.Scene(slider=slider, contact=contact, effects=effects)


def test_places_for_solutions():
    one = pp.solve(make_scene(2.0, 1.0), np.array([1.0]))
    both = pp.solve(make_scene(2.0, 1.0, BOTH), np.array([1.0]))
    assert one.mode.shape == (1, SOLUTIONS[True]) == (1, 4)
    assert both.mode.shape == (1, SOLUTIONS[False]) == (1, 8)
    assert both.twist.shape == (1, 8, 3)
    assert both.force.shape == both.center.shape == both.contact_motion.shape == (1, 8, 2)
    assert both.mode.dtype == both.solutions.dtype == np.int8


def test_empty_arrays():
    found = pp.solve(make_scene(2.0, 1.0), np.empty((0, 3)))
    assert found.solutions.shape == (0, 3)
    assert found.force.shape == (0, 3, 4, 2)


def test_the_force_of_a_translation_is_the_weight_and_the_mass():
    for effects, force in (
        ((pp.RingFriction(weight=3.0),), 3.0),
        ((pp.Inertia(mass=4.0),), 8.0),
        ((pp.RingFriction(weight=3.0), pp.Inertia(mass=4.0)), 11.0),
    ):
        (stick,) = pp.solve(make_scene(2.0, 1.0, effects, psi=np.pi / 2), np.pi / 2, 2.0)
        assert stick.force == pytest.approx([0.0, force], rel=1e-15, abs=0)
        assert stick.twist == pytest.approx([0.0, 2.0, 0.0], abs=1e-15)
        assert stick.spin_ratio == 0


def test_a_long_rod_turns_about_the_ring_center():
    """Pushed across itself: h = 2 k outside the ring, and k has the sense of the spin."""
    for angle, sign in ((0.0, 1.0), (np.pi, -1.0)):
        (_, stick) = pp.solve(make_scene(1e6, pp.PerfectlyRough(), psi=np.pi / 2), angle)
        assert np.sign(stick.spin_ratio) == sign
        assert abs(stick.spin_ratio) == pytest.approx(5e5, rel=1e-6)
        assert stick.center == pytest.approx([0.0, 1e6], abs=1e-3)


def test_labeled_solutions_are_a_dataset_with_units():
    length = xr.DataArray([0.5, 2.0], dims="length", coords={"length": ["short", "long"]})
    angle = xr.DataArray([-0.2, 1.0, 2.9], dims="push")
    found = pp.solve(make_scene(length, 2.0), angle)
    assert isinstance(found, xr.Dataset)
    assert dict(found.sizes) == {
        "length": 2, "push": 3, "solution": 4, "xy": 2, "twist_component": 3,
    }  # fmt: skip
    assert found.xy.values.tolist() == ["x", "y"]
    assert found.twist_component.values.tolist() == ["v_x", "v_y", "omega"]
    assert found.twist_unit.values.tolist() == ["motion", "motion", "radian motion/length"]
    assert "units" not in found.twist.attrs
    assert found.length.values.tolist() == ["short", "long"]
    units = {name: unit_of(variable.attrs) for name, variable in found.data_vars.items()}
    assert units == {
        "solutions": "1", "mode": "1", "force": "force", "twist": "twist_unit",
        "contact_motion": "motion", "spin_ratio": "1", "center": "length", "consistent": "1",
        "outcome": "1", "force_end": "force", "pivot": "1", "status": "1", "continuum": "1",
    }  # fmt: skip
    assert all(variable.attrs["long_name"] for variable in found.data_vars.values())
    plain = pp.solve(make_scene(np.array([[0.5], [2.0]]), 2.0), angle.values)
    for name in units:
        assert np.array_equal(found[name], getattr(plain, name), equal_nan=name in FIELDS)


@EVERY_EFFECT
def test_lazy_solutions_stay_lazy_and_equal_the_eager_ones(effects):
    eager = {
        **BASE, "rod_length": xr.DataArray(np.linspace(0.1, 4, 7), dims="length"),
        "pusher_angle": xr.DataArray(np.linspace(-3, 3, 11), dims="push"),
        "weight": xr.DataArray([1.0, 2.0], dims="w"),
    }  # fmt: skip
    lazy = {
        **eager, "rod_length": eager["rod_length"].chunk(length=3),
        "pusher_angle": eager["pusher_angle"].chunk(push=4),
    }  # fmt: skip
    found = call("solve", lazy, effects)
    for name in found.data_vars:
        assert dask.is_dask_collection(found[name])
    with dask.config.set(scheduler="threads", num_workers=3):
        xr.testing.assert_identical(found.compute(), call("solve", eager, effects))


def test_an_array_of_labeled_laws():
    laws = [pp.Coulomb(0.3), pp.InfiniteFriction()]
    contact = xr.DataArray(np.array(laws, dtype=object), dims="law", coords={"law": ["mu", "inf"]})
    slider = pp.Slider(rod_length=2.0, rod_angle=0.8)
    scene = pp.Scene(slider=slider, contact=contact, effects=FRICTION)
    found = pp.solve(scene, 2.9)
    for name, law in zip(("mu", "inf"), laws, strict=True):
        scene = pp.Scene(slider=slider, contact=law, effects=FRICTION)
        here = found.sel(law=name)
        assert here.solutions == len(pp.solve(scene, 2.9))
        assert np.array_equal(here.force[0], pp.solve(scene, 2.9).solutions[0].force)
