"""Runs by the compiled kernels and by their plain source have the same numbers, to the last bit."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from mechanics.degenerate import RANDOM
from simulation.random_runs import random_run
from simulation.scenes import METHODS, SCENES
from simulation.test_stiff import SUPPORTS, push

import planar_pushing as pp

pytestmark = pytest.mark.filterwarnings("ignore:radius:planar_pushing.SceneWarning")

#: A few of every group of scenes; the slow tests run all.
NAMES = [
    "ring through its center", "feet with a pivot", "tilted bar on its own line end", "zero friction",
    "infinite friction", "heavy and rough", "uneven feet", "load that friction holds", "impact",
    "start of a mass", "feet that pivot and rest", "everything", "disc", "parted", "corner comes down",
]  # fmt: skip
STEPPED = [
    "pivot on the other side",
    "impact with friction",
    "everything",
    "disc and inertia",
    "gap",
]


KERNELS = dict(zip(METHODS, ("run_events", "run_steps"), strict=True))
EVENTS, TIME_STEPS = METHODS


def compare(both, name, method):
    """Run a scene by both forms; the steps are few, since no error of theirs matters."""
    case = SCENES[name]
    steps = {"step": case.duration / 24} if method == TIME_STEPS else {}
    case.log(method, samples=5, **steps)
    assert KERNELS[method] in both.results


@pytest.mark.parametrize("name", NAMES)
def test_runs_between_events(both, name):
    compare(both, name, EVENTS)


@pytest.mark.parametrize("name", STEPPED)
def test_runs_by_steps(both, name):
    compare(both, name, TIME_STEPS)


@pytest.mark.parametrize("support", SUPPORTS)
def test_a_slow_push_in_implicit_steps(both, support):
    push(SUPPORTS[support], 0.062, 120.0, 0.003, 0.3, rtol=1e-8)
    assert "run_events" in both.results


def test_a_batch(both):
    case = SCENES["sticks, then slips"]
    pp.simulate_batch(case.scene, case.pusher, duration=np.array([1.0, 0.5, 0.7]), samples=3)
    assert "run_events" in both.results


def test_many_rows_and_many_calls(both):
    """A call of a kernel writes a limited number of rows, and the next one continues the run."""
    for method in METHODS:
        SCENES["gap"].log(method, samples=600, **({"step": 0.05} if method == TIME_STEPS else {}))
        assert len(both.results[KERNELS[method]]) > 1


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", SCENES)
def test_runs_of_every_scene(both, name, method):
    compare(both, name, method)


@pytest.mark.slow
@pytest.mark.parametrize("inertia", [False, True], ids=["friction", "both"])
@pytest.mark.parametrize("kind", [*RANDOM, "symmetric"])
def test_random_runs(both, kind, inertia):
    for seed in range(3):
        run = random_run(seed, inertia, kind)
        twist = {"twist": run.twist} if inertia else {}
        pusher = pp.Pusher(velocity=run.velocity, shape=run.shape)
        for steps in ({}, {"method": TIME_STEPS, "step": run.duration / 24}):
            pp.simulate(
                run.scene,
                pusher=pusher,
                duration=run.duration,
                samples=5,
                rtol=1e-8,
                **twist,
                **steps,
            )
    assert {"run_events", "run_steps"} <= {*both.results}


def ends():
    """Last values of some runs, bit for bit."""
    found = {}
    for name in ("uneven feet", "impact with friction", "disc and inertia"):
        for method in METHODS:
            log = SCENES[name].log(method, samples=3)
            found[f"{name}, {method}"] = [
                log[each].values[-1].item().hex() for each in ("rod_angle", "slip", "work")
            ]
    return found


def test_a_process_without_compiled_kernels_gives_the_same_numbers():
    code = "import json; from simulation.test_plain import ends; print(json.dumps(ends()))"
    said = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True,
        env=os.environ | {"PLANAR_PUSHING_PLAIN": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
    ).stdout  # fmt: skip
    assert json.loads(said) == ends()
