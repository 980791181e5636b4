"""A scene pays for the effects that it lists, and for no other."""

import os
import subprocess
import sys
import time

import numpy as np
import pytest

from planar_pushing.evidence.costs import effects
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.options import Method

STUDY = load_study("workflow/config/smoke.yaml")
EFFECTS = ("support_friction", "inertia")


@pytest.fixture(scope="module")
def found():
    return effects.evaluations(STUDY)


def listed(found):
    return np.array([[e in names.split("+") for e in EFFECTS] for names in found.effects.values])


def test_machine_code_holds_what_is_listed_and_nothing_else(found):
    assert found.functions.dims == ("operation", "effects", "effect")
    assert list(found.operation.values) == list(effects.COMPILED)
    assert ((found.functions.values > 0) == listed(found)).all()


def test_logs_hold_what_is_listed_and_nothing_else(found):
    for names in STUDY.grid.effects:
        for method in Method:
            log = effects.followed(effects.one_slider(STUDY, names), method)
            assert log.effect.values.tolist() == names.split("+")
            counts = found.evaluations.sel(integrator=str(method), effects=names, effect=log.effect)
            assert np.array_equal(counts, log.evaluations[-1])
    assert ((found.evaluations.values > 0) == listed(found)).all()


def test_a_step_evaluates_the_motion_once(found):
    steps = found.evaluations.sel(integrator="time-stepping").values
    assert np.array_equal(steps, effects.STEPS * listed(found))


def test_without_the_compiler_there_is_nothing_to_look_at():
    code = (
        "from planar_pushing.evidence.costs.effects import evaluations\n"
        "from planar_pushing.study.study_file import load_study\n"
        "evaluations(load_study('workflow/config/smoke.yaml'))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], env=os.environ | {"NUMBA_DISABLE_JIT": "1"}, check=False,
        capture_output=True, text=True,
    )  # fmt: skip
    assert "no machine code to inspect; unset NUMBA_DISABLE_JIT" in ran.stderr


def test_evaluations_repeat_exactly_and_have_units(found):
    assert found.identical(effects.evaluations(STUDY))
    assert all({"units", "long_name"} <= set(each.attrs) for each in found.variables.values())


def test_times_are_measured_for_every_case(monkeypatch):
    monkeypatch.setattr(effects, "REPEATS", 2)
    grid = STUDY.grid.model_copy(update={"rod_length": (0.0, 2.0), "pusher_angle": (-10.0, 165.0)})
    study = STUDY.model_copy(update={"grid": grid})
    start = time.perf_counter()
    measured = effects.effects(study)
    taken = time.perf_counter() - start
    assert measured.time.dims == ("case", "repeat")
    assert (measured.time > 0).all()
    assert float(measured.time.sum()) < taken
    assert set(measured.scene.values) == {"one slider", "grid", *study.scenes}
    assert set(measured.effects.values) == set(study.grid.effects)
    assert all({"units", "long_name"} <= set(each.attrs) for each in measured.variables.values())
