"""Logs that no equation of a ring holds, and results that are wrong even where they come out again."""

import os
import subprocess
import sys

import numpy as np
import pytest

from planar_pushing.evidence.golden import derived
from planar_pushing.evidence.golden.by_rule import check_dataset
from planar_pushing.evidence.golden.expected import derived_expectation
from planar_pushing.evidence.golden.rules import Rule
from planar_pushing.evidence.hard_cases import dataset

SCENE = """title: A short push
slider: {rod_length: 2, rod_angle: 60, radius: 1}
contact: {law: coulomb, friction_coefficient: 2}
effects: [EFFECT]
simulate: {pusher: [{time: 0, angle: 90}], duration: 0.01, samples: 3, METHOD}
"""
RING = "{type: ring_friction, weight: 1}"
DISC = "{type: support_friction, weight: 1, support: {shape: disc, radius: 1}}"
EVENTS, STEPS = "rtol: 1.0e-9", "method: time-stepping, step: 0.005"
#: Prints the rules of a simulation of a scene file.
RULES = """import sys
from planar_pushing.evidence.golden.expected import simulation_expectation
from planar_pushing.study.study_file import load_study
study = load_study("workflow/config/smoke.yaml")
study = study.model_copy(update={"simulations": {"one": sys.argv[1]}})
print(*set(simulation_expectation("one", study).rules.values()))
"""
#: Prints those of a picture's scene.
SCENE_RULES = """import sys
from planar_pushing.evidence.golden.expected import scene_expectations
from planar_pushing.study.files.models import PushEntry
from planar_pushing.study.study_file import load_study
study = load_study("workflow/config/smoke.yaml")
push = PushEntry(file=sys.argv[1], pusher_angle=100)
found = scene_expectations(study.model_copy(update={"scenes": {"one": push}}))
print(*set(found["one"].rules.values()))
"""


@pytest.mark.parametrize(
    ("effect", "method", "rules"),
    [
        (RING, EVENTS, {Rule.EXACT, Rule.RESIDUAL}),
        (RING, STEPS, {Rule.DERIVED}),
        (DISC, EVENTS, {Rule.DERIVED}),
    ],
)
def test_rules_of_a_simulation(tmp_path, effect, method, rules):
    text = SCENE.replace("EFFECT", effect).replace("METHOD", method)
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    assert _printed(RULES, tmp_path / "scene.yaml") == rules


def _printed(program, scene):
    """Words that a program prints of a scene file."""
    # Uncompiled: a disc would be compiled for this test alone, for a minute.
    run = [sys.executable, "-c", program, str(scene)]
    environment = os.environ | {"NUMBA_DISABLE_JIT": "1"}
    said = subprocess.run(run, env=environment, check=True, capture_output=True, text=True).stdout
    return set(said.split())


@pytest.mark.parametrize(
    ("effect", "rules"), [(RING, {Rule.EXACT, Rule.RESIDUAL}), (DISC, {Rule.DERIVED})]
)
def test_rules_of_a_scene(tmp_path, effect, rules):
    text = SCENE.replace("EFFECT", effect).replace("METHOD", EVENTS)
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    assert _printed(SCENE_RULES, tmp_path / "scene.yaml") == rules


def test_a_result_that_is_no_number_is_wrong(monkeypatch):
    broken = dataset.build()
    broken["result"][3] = np.nan
    monkeypatch.setattr(dataset, "build", broken.copy)
    found = derived_expectation(derived.hard_cases())
    (failed,) = (c for c in check_dataset("hard_cases", broken, found) if not c.passed)
    assert (failed.variable, failed.failed) == ("result", 1)
