"""Random runs over time: both integrators agree, the energy balances, and no run takes many steps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from simulation.random_runs import random_run
from simulation.runs import check

import planar_pushing as pp

pytestmark = pytest.mark.filterwarnings("ignore:radius:planar_pushing.SceneWarning")

#: Degrees of rod angle by which the integrators may differ, of which one is of first order.
AGREE = 0.2
#: By what factor steps are finer where they differ by more.
FINER = 16
#: A run takes at most ten thousand steps of twelve stages.
EVALUATIONS = 10_000 * 12


def common_end(*logs):
    """The last time that every log reaches, before a mode is chosen of several."""
    ends = [float(log.time[-1]) for log in logs]
    for log in logs:
        chosen = log.time.values[log.outcome.values == pp.Outcome.AMBIGUOUS]
        ends.append(float(chosen.min()) if len(chosen) else np.inf)
    return min(ends)


def angle_at(log, times):
    return np.interp(times, log.time.values, log.rod_angle.values)


def check_run(run):
    """Energy and steps of both integrators, and their agreement while the motion is unique."""
    exact, stepped = (check(run.log(each), 1e-7) for each in ("event-driven", "time-stepping"))
    assert exact.evaluations.values[-1].max() <= EVALUATIONS
    coarse = apart(exact, stepped)
    if coarse > AGREE:  # an impact: the error of the step decides where it hits; it has to fall
        finer = apart(exact, check(run.log("time-stepping", FINER), 1e-7))
        assert finer <= min(AGREE, coarse / 2), run
    return exact


def apart(exact, stepped):
    """Largest difference of the rod angle while the motion is unique."""
    times = np.linspace(0.0, common_end(exact, stepped), 41)
    return np.abs(angle_at(exact, times) - angle_at(stepped, times)).max()


@pytest.mark.parametrize("shape", ["fence", "finger"])
@pytest.mark.parametrize("kind", ["points", "symmetric", "polygon"])
@pytest.mark.parametrize("inertia", [False, True], ids=["friction", "both"])
def test_runs(kind, shape, inertia):
    for seed in range(3):
        check_run(random_run(seed, inertia, kind, shape))


@pytest.mark.parametrize("kind", ["points", "symmetric", "polygon"])
def test_runs_under_a_finger_of_finite_radius(kind):
    for seed, radius in enumerate((0.05, 0.5, 5.0)):
        check_run(replace(random_run(seed, False, kind, "finger"), radius=radius))


@pytest.mark.slow
@pytest.mark.parametrize("block", range(10))
def test_runs_with_inertia_under_a_finger_of_finite_radius(block):
    for seed in range(10 * block, 10 * (block + 1)):
        radius = (0.05, 0.5, 2.0)[seed % 3]
        check_run(replace(random_run(seed, True, None, "finger"), radius=radius))


@pytest.mark.slow
@pytest.mark.parametrize("inertia", [False, True], ids=["friction", "both"])
@pytest.mark.parametrize("block", range(10))
def test_hundreds_of_runs(block, inertia):
    """Five hundred in all; with inertia the center of rotation may arrive at a foot and stay."""
    for seed in range(25 * block, 25 * (block + 1)):
        check_run(random_run(seed, inertia))
