"""A hard case: a number that is computed on two routes."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.oracle.balls import Number

#: The quantities that a case can compute, with their units.
QUANTITIES = {
    "force": "1", "torque": "1", "spin_ratio": "1", "motion_angle": "radian", "mean_distance": "1",
    "rod_angle": "degree", "position": "1", "time": "1",
}  # fmt: skip


class Function(NamedTuple):
    """A quantity on both routes: `compute` returns a double, `reference` the oracle's number."""

    quantity: str
    compute: Callable[..., float]
    reference: Callable[..., Number]


class Case(NamedTuple):
    """One number under test: its unique label, its line, and its inputs, doubles taken as exact."""

    label: str
    line: int
    function: Function
    inputs: tuple[float, ...]


PSI, QUARTER = np.pi / 4, np.pi / 2


def spin_of_stick(scene: Scene, pusher: float, magnitude: float = 1.0) -> float:
    """Spin ratio of the sticking motion under a push."""
    modes = solve(scene, pusher, magnitude)
    (stick,) = (solution for solution in modes if solution.mode is ContactMode.STICK)
    return float(stick.spin_ratio)
