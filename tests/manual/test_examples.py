"""The example programs of the manual run as they are, and print what their page shows."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.slow

EXAMPLES = Path("paper/manual/examples")
#: What rounding on another machine may move of the numbers that each prints: a unit of the last digit where
#: least squares converge, more where a plan starts from the end of another and where contact is soft.
PROGRAMS = {
    "estimate_support": 1.1e-4,
    "mujoco_pull": 5e-3,
    "mujoco_push": 2e-4,
    "push_planner": 5e-3,
}
#: What a program imports that is no part of the project's own environment.
IMPORTED = {"mujoco_pull": "mujoco", "mujoco_push": "mujoco"}
NUMBER = re.compile(r"-?\d+\.\d+")


def numbers(lines):
    """The numbers of each line that has any."""
    found = [NUMBER.findall(line) for line in lines]
    return np.array([row for row in found if row], float)


@pytest.fixture(scope="module", params=PROGRAMS)
def name(request):
    return request.param


@pytest.fixture(scope="module")
def printed(name):
    """What an example prints, line by line."""
    if name in IMPORTED:
        pytest.importorskip(IMPORTED[name])
    command = [sys.executable, str(EXAMPLES / f"{name}.py")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=True)
    return done.stdout.splitlines()


def test_page_shows_what_is_printed(name, printed):
    shown = (EXAMPLES / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    assert [NUMBER.sub("", line).split() for line in printed] == [
        NUMBER.sub("", line).split() for line in shown
    ]
    np.testing.assert_allclose(numbers(printed), numbers(shown), atol=PROGRAMS[name], rtol=0)


@pytest.mark.parametrize("name", ["estimate_support"], indirect=True)
def test_estimates_are_within_three_standard_errors(printed):
    true, found, error = numbers(printed).T
    assert len(true) == 4
    assert np.all(error < 0.01)
    assert np.all(np.abs(found - true) < 3 * error)


@pytest.mark.parametrize("name", ["push_planner"], indirect=True)
def test_the_exact_plan_reaches_the_goal_and_the_ellipsoid_plans_again(printed):
    exact, ellipsoid = (
        numbers(line for line in printed if line.startswith(model))
        for model in ("exact", "ellipsoid")
    )
    assert len(exact) == 1
    assert exact[0, 1] < 1e-3
    assert exact[0, 2] < 1e-2
    # The first plan of the ellipsoid misses by more than a tenth of the box's length, and costs a detour.
    assert ellipsoid[0, 1] > 0.4
    assert len(ellipsoid) > 1
    assert ellipsoid[:, 0].sum() > 1.2 * exact[0, 0]
    assert np.all(ellipsoid[-1, 1:] < [0.0142, 0.573])
