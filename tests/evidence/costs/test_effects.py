"""A scene pays for the effects that it lists, and for no other."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from planar_pushing.evidence.costs import effects
from planar_pushing.evidence.costs.counted import counting
from planar_pushing.study.store import read_dataset
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import PlanarPushingError

STUDY = "workflow/config/smoke.yaml"
EFFECTS = ("support_friction", "inertia")


@pytest.fixture(scope="module")
def process(tmp_path_factory):
    """Tallies of scenes, and the counts of a small study, from a process without compiler."""
    path = tmp_path_factory.mktemp("counted") / "evaluations.nc"
    script = str(Path(__file__).with_name("counted.py"))
    given = {"env": os.environ | {"NUMBA_DISABLE_JIT": "1"}, "capture_output": True, "text": True}
    ran = subprocess.run([sys.executable, script, STUDY, str(path)], check=False, **given)
    assert ran.returncode == 0, ran.stderr
    return json.loads(ran.stdout), read_dataset(path)


def test_what_is_listed_is_counted_and_nothing_else(process):
    tallies, _ = process
    assert len(tallies) == 3 * 4 * (1 + len(effects.OPERATIONS))
    for listed, computed, tally, _ in tallies:
        for effect in EFFECTS:
            assert (tally.get(effect, 0) > 0) == (effect in listed.split("+")), (listed, computed)


def test_the_closed_inverse_of_a_ring_counts_once(process):
    """A motion cone has two edges."""
    tallies = {name: tally for listed, name, tally, _ in process[0] if listed == "support_friction"}
    assert sum(tallies["motion_cone"].values()) == 2


def test_counting_changes_no_result(process):
    assert all(same for *_, same in process[0])


def test_only_listed_effects_are_evaluated_anywhere(process):
    _, counted = process
    for effect in EFFECTS:
        listed = [effect in each.split("+") for each in counted.effects.values]
        assert ((counted.evaluations.sel(effect=effect) > 0).values == listed).all()


def test_compiled_code_is_not_counted():
    with pytest.raises(PlanarPushingError, match="set NUMBA_DISABLE_JIT=1 before"), counting():
        pass


def test_times_are_measured_for_every_case(process, monkeypatch):
    study, counted = load_study(STUDY), process[1]
    monkeypatch.setattr(effects, "REPEATS", 1)
    grid = study.grid.model_copy(update={"rod_length": (0.0, 2.0), "pusher_angle": (-10.0, 165.0)})
    measured = effects.measure(study.model_copy(update={"grid": grid}), counted)
    assert measured.time.dims == ("case", "repeat")
    assert (measured.time > 0).all()
    assert measured.evaluations.equals(counted.evaluations)
