"""Many scenes as rows of numbers: arrays of parameters, checked and broadcast before any work."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.contact.laws import friction_coefficient as coefficient_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.policies import marked, starts_of
from planar_pushing.simulation.problem import Problem, as_numbers
from planar_pushing.simulation.pusher import Pusher, constant_fences
from planar_pushing.simulation.systems.setup import LEFT, RIGHT, columns
from planar_pushing.terms.domain import required
from planar_pushing.terms.errors import InvalidValue

#: Of a slice of many scenes: their fences, shape (scenes, pieces), and how many pieces of each count.
Fences = Callable[[slice], tuple[Any, Array]]


class Scenes(NamedTuple):
    """Many scenes in radii, and their radii: rows as `systems.setup` has them, durations and fences."""

    rows: Array
    ends: Array
    radius: Array
    fences: Fences


def _required_numbers(name: str, given: Any) -> Array:
    """Numbers as floats, or `InvalidValue`."""
    numbers = as_numbers(given)
    if numbers is None:
        raise InvalidValue(name, given, "numbers", "give one for each scene")
    return np.asarray(numbers)


def coefficients(given: Any, contact: Any) -> Array:
    """Coefficients of friction, infinite where there is none, from one of the two arguments."""
    if (given is None) == (contact is None):
        raise InvalidValue(
            "friction_coefficient", given, "a coefficient, or a law as contact",
            "give one of the two",
        )  # fmt: skip
    if contact is not None:
        laws = np.asarray(contact, dtype=object)
        return np.array([coefficient_of(law) for law in laws.ravel()]).reshape(laws.shape)
    mu = _required_numbers("friction_coefficient", given)
    required("friction_coefficient", np.atleast_1d(np.where(mu == np.inf, 0.0, mu)))
    return mu


def velocities(given: Any) -> Array:
    """Velocities of many fences, shape (2,) or (scenes, 2), or `InvalidValue`."""
    moves = _required_numbers("velocity", given)
    if moves.ndim not in (1, 2) or moves.shape[-1] != 2:
        raise InvalidValue(
            "velocity", moves.shape, "shape (2,) or (scenes, 2), or a Pusher",
            "give (v_x, v_y) of each scene",
        )  # fmt: skip
    wrong = moves[~np.isfinite(moves)]
    if wrong.size:
        raise InvalidValue("velocity", float(wrong[0]), "finite numbers", "give length per time")
    required("velocity", np.hypot(moves[..., 0], moves[..., 1]))
    return moves


def scenes_of(problem: Problem, mu: Array) -> Scenes:
    """The scenes of a problem whose numbers are arrays, with these coefficients of friction."""
    scene, pusher = problem.scene, problem.pusher
    numbers = columns(scene, problem.twist, problem.gap)
    if isinstance(scene.contact, Coulomb):
        numbers[RIGHT] = np.where(np.isinf(mu), 0.0, numbers[RIGHT])
        numbers[LEFT] = np.where(np.isinf(mu), math.pi, numbers[LEFT])
    moves = np.zeros(2) if isinstance(pusher, Pusher) else pusher
    given = [*numbers, scene.slider.radius, problem.duration, mu, moves[..., 0]]
    shape = _shape({np.shape(each) for each in given})
    *rows, radius, ends, _, _ = (np.broadcast_to(np.asarray(x, float), shape) for x in given)
    return Scenes(np.stack(rows, axis=-1), ends, radius, _fences(problem, ends, radius))


def _shape(shapes: set[tuple[int, ...]]) -> tuple[int, ...]:
    """The one dimension over which the numbers of many scenes are broadcast."""
    try:
        shape = np.broadcast_shapes((1,), *shapes)
    except ValueError:
        shape = ()
    if len(shape) != 1 or not shape[0]:
        raise InvalidValue(
            "shapes", sorted(shapes), "() or (scenes,)", "give one number for each scene"
        )
    return shape


def _fences(problem: Problem, ends: Array, radius: Array) -> Fences:
    """The fences of scenes; those that are functions of time are made for one scene at a time."""
    pusher, policies = problem.pusher, problem.on_ambiguity
    if problem.follows_function:

        def function(part: slice) -> tuple[Any, Array]:
            fence = problem.fence(float(ends[part.start]), float(radius[part.start]))
            return fence[None], np.array([len(fence)])

        return function
    if isinstance(pusher, Pusher):
        starts, moves = pusher.steps
    else:
        starts, moves = np.zeros(1), np.reshape(pusher, (-1, 1, 2))
    every = np.broadcast_to(moves, (len(ends), len(starts), 2)) / radius[:, None, None]

    def constant(part: slice) -> tuple[Any, Array]:
        fences, counts = constant_fences(starts, every[part], ends[part], starts_of(policies))
        return marked(fences, policies), counts

    return constant
