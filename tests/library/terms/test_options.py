"""Options are given as enums or as their values, in Python as in files."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.scenes.simulate_model import SimulateEntry
from planar_pushing.terms.options import (
    STUDIED,
    TOLERANCE,
    AtZeroNormal,
    EffectKind,
    EffectSet,
    Method,
    Policy,
)

PULLING = "workflow/scenes/pulling.yaml"


@pytest.mark.parametrize("method", Method)
def test_a_simulation_takes_an_option_or_its_value(tmp_path, method):
    scene, fence = pp.load_scene(PULLING), pp.Pusher(velocity=(0.0, 1.0))
    given = {"pusher": fence, "duration": 0.1, "samples": 2}
    step = {"step": 0.05} if method is Method.TIME_STEPPING else {}
    for policy in Policy:
        logs = [
            pp.simulate(scene, **given, **step, method=how, on_ambiguity=which)
            for how, which in ((method, policy), (str(method), str(policy)))
        ]
        xr.testing.assert_identical(*logs)
        assert (logs[0].attrs["method"], logs[0].attrs["on_ambiguity"]) == (method, policy)
    path = tmp_path / "log.nc"
    pp.simulate(scene, **given, **step, method=method, on_ambiguity=policy, path=path).close()
    attributes = xr.load_dataset(path, engine="h5netcdf").attrs
    assert {type(attributes[name]) for name in ("method", "on_ambiguity")} == {str}


@pytest.mark.parametrize("kind", AtZeroNormal)
def test_a_law_takes_an_option_or_its_value(tmp_path, kind):
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 4)
    law = pp.InfiniteFriction(kind)
    assert law == pp.InfiniteFriction(str(kind))
    scene = pp.Scene(slider=slider, contact=law, effects=(pp.RingFriction(),))
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert pp.load_scene(tmp_path / "scene.yaml") == scene


def test_a_section_takes_an_option_or_its_value():
    given = {"pusher_angle": 0, "duration": 1}
    for method, policy in zip(Method, Policy, strict=False):
        entry = SimulateEntry(method=method, on_ambiguity=policy, **given)
        assert entry == SimulateEntry(method=str(method), on_ambiguity=str(policy), **given)


def test_effects_have_one_name_each():
    assert list(EffectSet) == [*STUDIED, "+".join(STUDIED)]
    assert {effect.kind for effect in EFFECTS.values()} == set(EffectKind)


@pytest.mark.parametrize(
    ("rtol", "holds"), [(1e-13, True), (1e-2, True), (9e-14, False), (0.011, False)]
)
def test_tolerances(rtol, holds):
    assert TOLERANCE.holds(rtol) == holds
