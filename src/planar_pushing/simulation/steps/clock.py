"""A run of the time-stepping integrator: where it is."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.modes import MOST
from planar_pushing.simulation.systems import base
from planar_pushing.simulation.systems.shapes import base as shapes


@cache
def clock_type(entries: int) -> np.dtype[Any]:
    """A run whose state has so many entries, of which those of inertia are not used.

    Its time and the end of the step; `mark` and `step` count the intervals between the times that are
    recorded, from `start` on, and the steps in one; position of the pusher, and its displacement in the
    step; twist, and mean force and pivot of the last step; work of the loads, and energy lost at the
    contact. Displacement, twist and force are along the axes of the world; trials, each a twist, a force
    and a pivot, along those of the contact's frame.
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
    """A vector of the world in the contact's frame."""
    return shapes.seen(system.shape, run.state[base.ANGLE], vector[0], vector[1])
