"""The example programs of the manual run as they are, and find what their pages say."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path("paper/manual/examples")
PROGRAMS = ("estimate_support", "push_planner")


def rows(name):
    """The lines that an example prints, as words."""
    command = [sys.executable, str(EXAMPLES / f"{name}.py")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=True)
    return [line.split() for line in done.stdout.splitlines()]


@pytest.mark.parametrize("name", PROGRAMS)
def test_examples_are_short(name):
    assert len((EXAMPLES / f"{name}.py").read_text(encoding="utf-8").splitlines()) < 80


def test_estimates_are_within_three_standard_errors():
    printed = rows("estimate_support")[1:]
    true, found, error = np.array([row[-3:] for row in printed], float).T
    assert len(printed) == 4
    assert np.all(error < 0.01)
    assert np.all(np.abs(found - true) < 3 * error)


def test_the_exact_plan_reaches_the_goal_and_the_ellipsoid_plans_again():
    printed = rows("push_planner")
    plans = {
        name: np.array(
            [[row[2], row[5].rstrip(","), row[6]] for row in printed if row[0] == name], float
        )
        for name in ("exact", "ellipsoid")
    }
    exact, ellipsoid = plans["exact"], plans["ellipsoid"]
    assert len(exact) == 1
    assert exact[0, 1] < 1e-3
    assert exact[0, 2] < 1e-2
    # The ellipsoid misses by a tenth of the box's length, and then takes a longer way to the goal.
    assert ellipsoid[0, 1] > 0.4
    assert len(ellipsoid) > 1
    assert ellipsoid[:, 0].sum() > 1.1 * exact[0, 0]
    assert np.all(ellipsoid[-1, 1:] < [0.0142, np.rad2deg(0.01)])
