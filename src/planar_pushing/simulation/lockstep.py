"""Many scalar differential equations at once, each with its own step: DOP853 over an array of lanes.

The tableau and the error estimate are those of `scipy.integrate.DOP853` (Hairer, Norsett and Wanner,
Solving Ordinary Differential Equations I, Sec. II.10); only the loop over the lanes is ours.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853

from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.lanes import Motion

#: A margin this far below zero ends a mode; rounding stays above it.
SLACK = 1e-10
#: Nodes and weights on [0, 1] for the time that a lane takes to reach a given angle.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2
SAFETY, SHRINK, GROW = 0.9, 0.2, 6.0
#: Slip enters the error in radii, the angle in radians, each with this absolute floor.
FLOOR = 1e-2

Rates = Callable[[Array], Motion]


class Step(NamedTuple):
    """One trial step of every lane.

    Attributes
    ----------
    angle, slip : ndarray, shape (lanes,)
        At the end of the step; `slip` is what the step adds.
    error : ndarray, shape (lanes,)
        In units of the tolerance.
    angles, margins : ndarray, shape (stages, lanes)
        What the step visited.
    """

    angle: Array
    slip: Array
    error: Array
    angles: Array
    margins: Array


def trial(rates: Rates, angle: Array, size: Array, rtol: float) -> Step:
    """One step of DOP853 of each lane's own size."""
    stages = len(DOP853.C) + 1
    angles = np.empty((stages, len(angle)))
    slopes = np.empty((2, stages, len(angle)))
    margins = np.empty_like(angles)
    weights = [*DOP853.A, DOP853.B]
    for stage in range(stages):
        angles[stage] = angle + size * (weights[stage][:stage] @ slopes[0, :stage])
        slopes[0, stage], slopes[1, stage], margins[stage] = rates(angles[stage])[:3]
    change = size * (DOP853.B @ slopes[:, :-1])
    scale = rtol * np.maximum(FLOOR, np.stack([np.abs(angle), np.abs(change[1])]))
    return Step(angles[-1], change[1], _error(slopes, size / scale), angles, margins)


def _error(slopes: Array, size: Array) -> Array:
    fifth, third = (np.sum((size * (e @ slopes)) ** 2, axis=0) for e in (DOP853.E5, DOP853.E3))
    total = fifth + 0.01 * third
    error = np.divide(fifth, np.sqrt(2 * total), out=np.zeros_like(total), where=total > 0)
    return np.asarray(error)


def next_size(size: Array, error: Array) -> Array:
    """Step size that keeps the error at the tolerance."""
    with np.errstate(divide="ignore"):
        factor = SAFETY * error ** (-1 / 8)
    return size * np.clip(factor, SHRINK, GROW)


def passage(rates: Rates, start: Array, end: Array) -> tuple[Array, Array]:
    """Time and slip from one angle to another, where the lane does not turn back between them.

    The equation does not contain the time, so both are integrals over the angle: Gauss's rule, 16 nodes.
    """
    span = end - start
    time, slip = np.zeros_like(span), np.zeros_like(span)
    for node, weight in zip(NODES, WEIGHTS, strict=True):
        motion = rates(start + node * span)
        part = np.divide(weight * span, motion.spin, out=np.zeros_like(span), where=span != 0)
        time += part
        slip += part * motion.slip
    return time, slip


def bracket(step: Step) -> tuple[Array, Array]:
    """The last angle that a step visited before its mode ended, and the first one after.

    Stages are visited in another order than that of the angles; the first is the step's start.
    """
    angles, margins = step.angles, step.margins
    distance = np.abs(angles - angles[0])
    outside = margins < -SLACK
    outside[0] = False
    first = np.argmin(np.where(outside, distance, np.inf), axis=0)
    reach = np.take_along_axis(distance, first[None], axis=0)
    last = np.argmax(np.where((distance < reach) & (margins > 0), distance, -1.0), axis=0)
    inside, beyond = (np.take_along_axis(angles, i[None], axis=0)[0] for i in (last, first))
    return inside, beyond
