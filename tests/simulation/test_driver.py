"""The driver: runs that are interrupted and resumed, runs without the compiler, and fast friction."""

import os
import subprocess
import sys

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import BOTH, FRICTION, make_scene
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.runs import Run
from simulation.runs import final, heading, run

FENCE = [(0, heading(60)), (0.5, heading(100))]


def rows_of(problem, room):
    """Rows of a run that is interrupted whenever so many rows are written."""
    return np.concatenate(list(Run(problem, np.linspace(0, 1, 50), room=room)))


@pytest.mark.parametrize("effects", [FRICTION, BOTH], ids=["friction", "both"])
def test_a_run_goes_on_where_it_was_interrupted(effects):
    scene = make_scene(2, 0.5, effects)
    problem = Problem(scene=scene, pusher=pp.Pusher(velocity=FENCE), duration=1)
    whole, parts = rows_of(problem, 500), rows_of(problem, 1)
    assert len(whole) > 50
    assert whole.tobytes() == parts.tobytes()


def test_an_interrupt_between_two_batches_leaves_a_run_that_can_be_finished():
    problem = Problem(scene=make_scene(2, 0.5), pusher=pp.Pusher(velocity=FENCE), duration=1)
    whole = np.concatenate(list(Run(problem, np.linspace(0, 1, 1000))))
    run = Run(problem, np.linspace(0, 1, 1000))
    found = []
    for rows in run:  # an interrupt leaves this loop
        found.append(rows)
        if len(found) == 2:
            break
    found += list(run)
    assert np.concatenate(found).tobytes() == whole.tobytes()


def endings():
    """Last values of simulations of each set of effects, by each method."""
    found = []
    for effects in (pp.RingFriction(),), (pp.Inertia(),), (pp.RingFriction(), pp.Inertia()):
        slider = pp.Slider(rod_length=2, rod_angle=0.8)
        scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
        for options in {}, {"method": "time-stepping", "step": 0.01}:
            log = run(scene, (0.3, 1.0), 0.1, rtol=1e-6, samples=3, **options)
            found += [final(log, name).hex() for name in ("rod_angle", "slip", "work")]
    return found


def test_the_same_numbers_without_the_compiler():
    code = "from simulation.test_driver import endings; print(*endings())"
    paths = os.pathsep.join(sys.path)
    said = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True,
        env=os.environ | {"PLANAR_PUSHING_PLAIN": "1", "PYTHONPATH": paths},
    ).stdout  # fmt: skip
    assert [float.fromhex(each) for each in said.split()] == [
        float.fromhex(each) for each in endings()
    ]
    assert len(said.split()) == 18


def test_friction_that_settles_fast_is_followed():
    """Slow pushing with inertia: the twist settles a thousand times faster than the slider moves."""
    scene = make_scene(2, 2.0, BOTH)
    log = run(scene, heading(60, 0.02), 0.5 / 0.02)
    slow = run(make_scene(2, 2.0), heading(60), 0.5)
    assert final(log, "evaluations")[0] < 40_000
    assert final(log, "rod_angle") == pytest.approx(final(slow, "rod_angle"), abs=0.02)
    finer = run(scene, heading(60, 0.02), 0.5 / 0.02, rtol=1e-12)
    assert final(log, "rod_angle") == pytest.approx(final(finer, "rod_angle"), abs=1e-8)


def test_steps_are_graded_towards_a_kink_and_away_from_it():
    """The motion center crosses the ring, where the rates are no smoother than x / log x."""
    scene = make_scene(1.5, np.inf, psi=np.deg2rad(80))
    log = run(scene, heading(10), 3, samples=2)
    k = np.abs(log.spin_ratio.values)
    assert k.min() < 0.999 < 1.001 < k.max()
    finer = run(scene, heading(10), 3, samples=2, rtol=1e-13)
    assert final(log, "rod_angle") == pytest.approx(final(finer, "rod_angle"), abs=1e-8)
    assert final(log, "evaluations")[0] < 550
