"""Solving a scene of the nets, which checks every solution, and a few scenes of theirs."""

from __future__ import annotations

import math

import numpy as np
from mechanics.problems import problem_of
from mechanics.slip_scan import slips_by_scan
from mechanics.transcription import SLIP_LEFT, SLIP_RIGHT, faults

import planar_pushing as pp

INFINITE, UPRIGHT = pp.InfiniteFriction(), math.pi / 2
TABLE = pp.Points([(1, 1), (-1, 1), (-1, -1), (1, -1)], [1, 1, 1, 1])


def scene_of(support, length, psi, law, *masses, weight=1.0):
    """A scene with friction on a support and any inertia."""
    slider = pp.Slider(rod_length=length, rod_angle=psi)
    friction = pp.SupportFriction(support=support, weight=weight)
    return pp.Scene(slider=slider, contact=law, effects=(friction, *masses))


def solved(scene, angle, magnitude=1.0):
    """The solutions, each of which meets the conditions of its mode, with none missing."""
    found = pp.solve(scene, angle, magnitude)
    assert faults(scene, angle, magnitude, found) == []
    return found


def assert_scanned(scene, angle, magnitude):
    """A slip that the scan steps over has a partner within the same step."""
    found, problem = solved(scene, angle, magnitude), problem_of(scene, angle, magnitude)
    for mode, sense in ((SLIP_RIGHT, 1), (SLIP_LEFT, -1)):
        more = np.sum(found.mode == mode, axis=-1) - slips_by_scan(problem, sense)
        assert np.all((more >= 0) & (more % 2 == 0)), np.flatnonzero(more)
