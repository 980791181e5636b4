"""Logs that no equation of a ring holds, and results that are wrong even where they come out again."""

import os
import subprocess
import sys

import numpy as np

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
#: Prints, line by line, the rules of the simulations and of the pictures of scene files.
RULES = """import sys
from planar_pushing.evidence.golden.expected import scene_expectations, simulation_expectation
from planar_pushing.study.files.study_model import PushEntry
from planar_pushing.study.study_file import load_study
study = load_study("workflow/config/smoke.yaml")
files = sys.argv[1:]
study = study.model_copy(update={
    "simulations": {file: file for file in files},
    "scenes": {file: PushEntry(file=file, pusher_angle=100) for file in files},
})
pictures = scene_expectations(study)
for file in files:
    print(*set(simulation_expectation(file, study).rules.values()))
    print(*set(pictures[file].rules.values()))
"""


def test_rules_of_simulations_and_of_their_scenes(tmp_path):
    cases = {
        (RING, EVENTS): ({Rule.EXACT, Rule.RESIDUAL}, {Rule.EXACT, Rule.RESIDUAL}),
        (RING, STEPS): ({Rule.DERIVED}, {Rule.EXACT, Rule.RESIDUAL}),
        (DISC, EVENTS): ({Rule.DERIVED}, {Rule.DERIVED}),
    }
    files = [tmp_path / f"{number}.yaml" for number in range(len(cases))]
    for file, (effect, method) in zip(files, cases, strict=True):
        text = SCENE.replace("EFFECT", effect).replace("METHOD", method)
        file.write_text(text, encoding="utf-8")
    # Uncompiled: a disc would be compiled for this test alone, for a minute.
    run, environment = (
        [sys.executable, "-c", RULES, *files],
        os.environ | {"NUMBA_DISABLE_JIT": "1"},
    )
    said = subprocess.run(run, env=environment, check=True, capture_output=True, text=True).stdout
    found = [set(line.split()) for line in said.splitlines()]
    assert found == [rules for pair in cases.values() for rules in pair]


def test_a_result_that_is_no_number_is_wrong(monkeypatch):
    broken = dataset.build()
    broken["result"][3] = np.nan
    monkeypatch.setattr(dataset, "build", broken.copy)
    found = derived_expectation(derived.hard_cases())
    (failed,) = (c for c in check_dataset("hard_cases", broken, found) if not c.passed)
    assert (failed.variable, failed.failed) == ("result", 1)
