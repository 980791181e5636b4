"""Slips of a step with inertia and friction."""

import math

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import BOTH, make_scene
from planar_pushing.simulation.fields import arrays, logged_fields
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.runs import Run
from planar_pushing.terms.options import Method


@pytest.mark.parametrize(
    "twist", [(-0.4955911336775569, -0.46708788228066356, 0.49), (0.5, -0.5, 0.1)]
)
def test_the_impulse_of_a_slip_in_the_middle_of_its_range_is_found(twist):
    """Without a rod friction on the support shifts the bounds of the impulse by the same amount."""
    scene = make_scene(0, 0.4, BOTH, psi=math.radians(60))
    problem = Problem(
        scene=scene, pusher=pp.Pusher(velocity=(1.0, 0.0)), duration=0.01, twist=twist
    )  # fmt: skip
    rows = np.concatenate(list(Run(problem, [0, 0.01], Method.TIME_STEPPING, 0.01)))
    log = arrays(rows, problem, logged_fields(problem))
    assert log["mode"][0] == pp.ContactMode.SLIP_LEFT
    assert log["twist"][-1, 1] == pytest.approx(0, abs=1e-15)
    assert log["force"][-1, 0] == pytest.approx(0.4 * log["force"][-1, 1], rel=1e-12, abs=0)
