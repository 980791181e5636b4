"""A scene pays for the effects that it lists, and for no other."""

import sys
from collections import Counter
from functools import partial

import numpy as np
import pytest

from planar_pushing.core.supports import resistance, rows
from planar_pushing.core.supports.ring import ring_response
from planar_pushing.mechanics.kernels import calls as kernels
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.options import EffectSet, Method
from pulling_by_pushing.evidence.costs import effects
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/smoke.yaml")
EFFECTS = ("support_friction", "inertia")
#: Kinds of the effects in the core; in a step, the momentum is a load.
KINDS = {rows.RING: "support_friction", rows.MASS: "inertia", rows.LOAD: "inertia"}
#: Computations that evaluate the effects.
RUNS = {
    "solve": lambda scene: solve(scene, 0.4),
    **{str(method): partial(effects.run, method=method) for method in Method},
}


@pytest.fixture(scope="module")
def found():
    return effects.effects(STUDY)


def listed(found):
    return np.array([[e in names.split("+") for e in EFFECTS] for names in found.effects.values])


def test_logs_hold_what_is_listed_and_nothing_else(found):
    for names in STUDY.grid.effects:
        for method in Method:
            log = effects.run(effects.pushed_slider(STUDY, names), method)
            assert log.effect.values.tolist() == names.split("+")
            counts = found.evaluations.sel(integrator=str(method), effects=names, effect=log.effect)
            assert np.array_equal(counts, log.evaluations[-1])
    assert ((found.evaluations.values > 0) == listed(found)).all()


def test_a_step_evaluates_the_motion_once(found):
    steps = found.evaluations.sel(integrator="time-stepping").values
    assert np.array_equal(steps, effects.STEPS * listed(found))


@pytest.mark.parametrize("names", [*EffectSet])
@pytest.mark.parametrize("run", RUNS)
def test_the_core_evaluates_what_is_listed_and_nothing_else(monkeypatch, run, names):
    """As a profiler of Python sees the plain core."""
    monkeypatch.setattr(kernels, "COMPILED", None)
    scene, evaluated, integrals = effects.pushed_slider(STUDY, names), Counter(), Counter()

    def note(frame, event, _):
        if event == "call" and frame.f_code is resistance.effect_resistance.__code__:
            given = frame.f_locals
            evaluated[KINDS[rows.kind_of(given["effects"].data, given["effect"])]] += 1
        elif event == "call":
            integrals[frame.f_code is ring_response.__code__] += 1

    sys.setprofile(note)
    try:
        RUNS[run](scene)
    finally:
        sys.setprofile(None)
    assert evaluated.keys() <= set(names.split("+"))
    assert (integrals[True] > 0) == (evaluated["support_friction"] > 0) == ("friction" in names)


def test_variables_are_described(found):
    assert dict(found.sizes) == {"integrator": 2, "effects": 3, "effect": 2}
    assert list(found.data_vars) == ["evaluations"]
    assert all({"units", "long_name"} <= set(each.attrs) for each in found.variables.values())
