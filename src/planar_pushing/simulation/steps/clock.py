"""The current state of a run of the time-stepping integrator."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.record import MOST
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.shapes import base as shapes


@cache
def clock_type(entries: int) -> np.dtype[Any]:
    """Data type of a run with the given number of state entries; those for inertia are not used.

    The fields include the time and the end of the step, the position of the pusher and its displacement in
    the step, the twist, the mean force and pivot of the last step, the work of the loads, and the energy
    dissipated at the contact. `mark` counts the intervals between recorded times, which begin at `start`,
    and `step` counts the steps in an interval. Displacement, twist and force are along the axes of the
    world. Trials, each with a twist, a force and a pivot, are along the axes of the contact frame.
    """
    return np.dtype(
        [
            ("time", "f8"), ("until", "f8"), ("start", "f8"), ("fence", "f8", (2,)), ("way", "f8", (2,)),
            ("state", "f8", (entries,)), ("twist", "f8", (3,)), ("force", "f8", (2,)), ("pulled", "f8"),
            ("lost", "f8"),
            ("kind", "i8"), ("solutions", "i8"), ("mark", "i8"), ("step", "i8"), ("stopped", "i8"),
            ("pivot", "i8"), ("kinds", "i8", (MOST,)), ("trials", "f8", (MOST, 6)),
        ],
        align=True,
    )  # fmt: skip


@compiled
def seen(system, run, vector):
    """Transform a vector from the world to the contact frame."""
    return shapes.seen(system.shape, run.state[base.ANGLE], vector[0], vector[1])
