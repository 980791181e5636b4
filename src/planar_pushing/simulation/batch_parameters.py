"""What `simulate_batch` is given: arrays of parameters, checked and broadcast before any work."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.errors import InvalidValue, require_number
from planar_pushing.mechanics.plane import Array


def require_friction(effects: object) -> None:
    """Refuse effects that a batch does not take."""
    listed = tuple(effects) if isinstance(effects, (tuple, list)) else ()
    if not listed or not all(isinstance(effect, RingFriction) for effect in listed):
        raise InvalidValue(
            "effects", effects, "RingFriction alone",
            "simulate a scene with other effects by itself",
        )  # fmt: skip


def sample_parts(samples: int | None) -> Array:
    """Parts of the duration at which the scenes are looked at."""
    if samples is None:
        return np.ones(1)
    count = require_number(
        "samples", samples, lambda n: 2 <= n < math.inf and n == int(n), "a whole number >= 2",
        "ask at least for the first and the last instant, or leave it out",
    )  # fmt: skip
    return np.linspace(0.0, 1.0, int(count))


def numbers(
    name: str, given: npt.ArrayLike, allows: Callable[[Array], Any], allowed: str, remedy: str
) -> Array:
    """An array of floats, or `InvalidValue` with the first number that is not allowed."""
    try:
        values = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidValue(name, given, allowed, remedy) from None
    wrong = values[~np.asarray(allows(values), dtype=bool)]
    if wrong.size:
        raise InvalidValue(name, float(wrong.flat[0]), allowed, remedy)
    return values


def scene_parameters(
    length: npt.ArrayLike,
    angle: npt.ArrayLike,
    mu: npt.ArrayLike,
    velocity: npt.ArrayLike,
    duration: npt.ArrayLike,
) -> dict[str, Array]:
    """The parameters, checked and broadcast to shape (scenes,); `velocity` to (scenes, 2)."""
    pair = "finite numbers, (v_x, v_y) for each scene"
    moves = numbers("velocity", velocity, np.isfinite, pair, "give the fence's velocity")
    if moves.ndim not in (1, 2) or moves.shape[-1:] != (2,):
        raise InvalidValue("velocity", moves.shape, "shape (2,) or (scenes, 2)", f"give {pair}")
    given = {
        "rod_length": numbers(
            "rod_length", length, lambda x: (x >= 0) & (x < np.inf), "finite numbers >= 0",
            "give the distance from the contact to the ring centre",
        ),
        "rod_angle": numbers(
            "rod_angle", angle, lambda x: (x > 0) & (x < np.pi),
            "radians in the open interval (0, pi)", "keep the slider above the fence",
        ),
        "friction_coefficient": numbers(
            "friction_coefficient", mu, lambda x: x >= 0, "numbers >= 0, or inf",
            "use inf where no coefficient is large enough",
        ),
        "duration": numbers(
            "duration", duration, lambda x: (x > 0) & (x < np.inf), "finite numbers > 0",
            "give the time to simulate",
        ),
    }  # fmt: skip
    shapes = [array.shape for array in given.values()] + [moves.shape[:-1]]
    try:
        shape = np.broadcast_shapes((1,), *shapes)
    except ValueError:
        shape = ()
    if len(shape) != 1 or not shape[0]:
        raise InvalidValue("shapes", shapes, "() or (scenes,)", "give one number for each scene")
    return {
        **{name: np.broadcast_to(array, shape).copy() for name, array in given.items()},
        "velocity": np.broadcast_to(moves, (*shape, 2)).copy(),
    }
