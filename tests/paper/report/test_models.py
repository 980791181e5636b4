"""Numbers of the report about what leaving out an effect changes, from datasets with known answers."""

import numpy as np
import pytest
import xarray as xr

from pulling_by_pushing.report.costs import models


@pytest.fixture
def errors():
    """Errors without inertia of 100 v^2 and 4 v^2 mm, and of 1/v mm without friction; three pushes."""
    speed = np.array([0.01, 0.04, 0.25, 2.0])
    inertia = 1e-3 * np.array([100 * speed**2, 4 * speed**2])
    friction = 1e-3 * np.array([1 / speed, 1 / speed])
    push = np.array([0.5, 1.0, 4.0])
    values = np.stack([inertia, friction], axis=-1)[:, None] * push[:, None, None]
    counts = 100.0 * np.ones((2, 3, 2)), 100.0 * np.array([50, 5, 1, 1]) * np.ones((2, 3, 4))
    return xr.Dataset(
        {
            "pose_error": (("support", "push", "speed", "left_out"), values),
            "evaluations": (("support", "push", "speed"), counts[1]),
            "evaluations_alone": (("support", "push", "left_out"), counts[0]),
        },
        {"support": ["disc", "feet"], "speed": speed, "left_out": ["inertia", "friction"]},
    )


@pytest.fixture
def estimates():
    """Two pushes and two effects: 8 times the estimate is below a millimeter in two of four cases."""
    return xr.Dataset(
        {
            "pose_error": (("push", "effect"), [[1e-4, 2e-3], [5e-4, 1e-2]]),
            "estimate": (("push", "effect"), [[1e-4, 1e-3], [1.2e-4, 1e-2]]),
        }
    )


def test_an_error_of_a_millimeter_is_found_between_the_speeds(errors):
    assert models.crossing(errors, "disc", "inertia") == pytest.approx(0.1)
    assert models.crossing(errors, "feet", "inertia") == pytest.approx(0.5)
    assert models.crossing(errors, "disc", "friction") == pytest.approx(1.0)


def test_the_first_push_is_told_in_millimeters(errors):
    assert models.first_error(errors, "disc", 0.25) == pytest.approx(0.5 * 100 * 0.25**2)


def test_evaluations_at_the_slowest_speed(errors):
    assert models.slowest(errors) == pytest.approx(10.0)
    assert models.evaluations_ratio(errors) == 50.0


def test_cases_that_an_estimate_settles(estimates):
    assert models.random_pushes(estimates) == 2
    assert models.largest_ratio(estimates) == pytest.approx(5e-4 / 1.2e-4)
    assert models.percentage_settled(estimates) == 50.0
    assert models.count_missed(estimates) == 0
    estimates.pose_error[0, 0] = 2e-3
    assert models.count_missed(estimates) == 1
