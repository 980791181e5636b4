"""The example programs of the manual run as they are, and print what their page shows."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from pushes.written import finger_places, turn, world_poses

import planar_pushing as pp

pytestmark = pytest.mark.slow

EXAMPLES = Path("paper/manual/examples")
#: What rounding on another machine may move of the numbers that each prints: a unit of the last digit of
#: weights, more where a plan starts from the end of another and where contact is soft.
PROGRAMS = {
    "mujoco_pull": 5e-3,
    "mujoco_push": 2e-4,
    "own_pushes": 1.1e-3,
    "push_planner": 5e-3,
    "stable_planner": 1.1e-4,
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
    found, expected = (
        [float(x) for x in NUMBER.findall(" ".join(each))] for each in (printed, shown)
    )
    np.testing.assert_allclose(found, expected, atol=PROGRAMS[name], rtol=0)


@pytest.mark.parametrize("name", ["own_pushes"], indirect=True)
def test_five_pushes_tell_the_loads_and_make_the_better_plan(printed):
    found = [numbers([line]).ravel() for line in printed]
    true = [4.0, 0.25, 1 / 6, 1 / 3, 1 / 2]
    for value, (estimate, low, high) in zip(true, found[:5], strict=True):
        assert low <= value <= high
        assert abs(estimate - value) < 0.05 * value
    (_, _, near, turned), (_, _, far, more) = found[5:]
    assert near < 1.0 < 10.0 < far
    assert turned < 1.0 < 20.0 < more


def test_the_measurements_of_the_example_are_those_that_its_table_says():
    table = np.loadtxt(EXAMPLES / "own_pushes.csv", delimiter=",", comments="#", skiprows=4)
    text = (EXAMPLES / "own_pushes.csv").read_text(encoding="utf-8")
    assert text.startswith("# Example numbers, not measurements")
    np.testing.assert_allclose(table, simulated_measurements(), atol=0.0101, rtol=0)


def simulated_measurements():
    """Rows of the example's table: poses in degrees, places of the finger, and forces, in the world."""
    feet = pp.Points([(-50, -30), (50, -30), (0, 30)], [1, 2, 3])
    pushes = pp.simulate_pushes(
        (pp.SupportFriction(support=feet, weight=4.0),), pp.Polygon.rectangle(120, 80), 5,
        noise=(0.3, 0.2, 0.03), seed=6, finger_radius=5.0, distance=20.0,
    )  # fmt: skip
    before, after = world_poses(pushes, np.random.default_rng(6))
    start, end = finger_places(pushes, before, lead=10.0)
    midway = (before[:, 2] + after[:, 2]) / 2
    force = [turn(a) @ f for a, f in zip(midway, pushes["force"].values, strict=True)]
    degrees = [1.0, 1.0, 180.0 / np.pi]
    return np.column_stack([before * degrees, after * degrees, start, end, force])


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
