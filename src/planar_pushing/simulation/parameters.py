"""What `simulate_batch` is given: arrays of parameters, checked and broadcast before any work."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.contact.laws import friction_coefficient as coefficient_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.simulation.problem import TWIST, no_twist
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.systems.setup import LEFT, RIGHT, columns
from planar_pushing.terms.domain import SPEEDS, required
from planar_pushing.terms.errors import InvalidValue, require_number
from planar_pushing.terms.options import SAMPLES


class Scenes(NamedTuple):
    """Many scenes and their fences.

    Attributes
    ----------
    kinds : tuple
        Of effects, as `Scene.kinds`.
    rows : ndarray, shape (scenes, columns)
    motions : ndarray, shape (scenes, pieces, 3), or function
        As `blocks.run_scenes` takes them.
    ends : ndarray, shape (scenes,)
        Durations.
    radius : ndarray, shape (scenes,)
    coordinates : dict
        What the dataset says of each scene.
    """

    kinds: Any
    rows: Array
    motions: Any
    ends: Array
    radius: Array
    coordinates: dict[str, Array]


def scenes_of(
    rod_length: Any, rod_angle: Any, radius: Any, friction_coefficient: Any, contact: Any,
    effects: Any, velocity: Any, duration: Any, twist: Sequence[Any], gap: Any,
) -> Scenes:  # fmt: skip
    """The scenes of the arguments of `simulate_batch`; errors as there."""
    mu = _coefficients(friction_coefficient, contact)
    law = Coulomb(np.where(np.isinf(mu), 0.0, mu)) if contact is None else contact
    slider = Slider(rod_length=_array(rod_length), rod_angle=_array(rod_angle), radius=radius)
    scene = Scene(slider=slider, contact=law, effects=effects)
    ends = np.atleast_1d(duration)
    required("duration", ends)
    required("gap", gap)
    spins = _twist(twist)
    if not scene.stores_energy:
        no_twist(twist)
    numbers = columns(scene, spins, np.asarray(gap))
    if contact is None:
        numbers[RIGHT] = np.where(np.isinf(mu), 0.0, numbers[RIGHT])
        numbers[LEFT] = np.where(np.isinf(mu), math.pi, numbers[LEFT])
    moves = velocity if isinstance(velocity, Pusher) else _velocities(velocity)
    given = [*numbers, mu, radius, ends, moves[..., 0] if isinstance(moves, np.ndarray) else 0.0]
    shape = _shape([np.shape(each) for each in given])
    over = [np.broadcast_to(np.asarray(each, float), shape) for each in given]
    rows = np.stack(over[: len(numbers)], axis=-1)
    coordinates = {
        "rod_length": np.broadcast_to(slider.rod_length, shape),
        "initial_rod_angle": np.rad2deg(np.broadcast_to(slider.rod_angle, shape)),
        "friction_coefficient": over[-4],
        "duration": over[-2],
    }
    if isinstance(moves, np.ndarray):
        coordinates["velocity"] = np.broadcast_to(moves, (*shape, 2))
    motions = _motions(moves, over[-2], over[-3])
    return Scenes(scene.kinds, rows, motions, over[-2], over[-3], coordinates)


def _array(given: Any) -> Any:
    """Numbers as an array, what is none as it is given."""
    try:
        return np.asarray(given) if np.ndim(given) else given
    except (TypeError, ValueError):  # lists of several lengths
        return None


def _numbers(name: str, given: Any) -> Array:
    """Numbers as an array of floats, or `InvalidValue`."""
    found = np.asarray(_array(given))
    if found.dtype.kind not in "iuf":
        raise InvalidValue(name, given, "numbers", "give one for each scene")
    return found.astype(float)


def _coefficients(given: Any, contact: Any) -> Array:
    """Coefficients of friction, infinite where there is none."""
    if (given is None) == (contact is None):
        raise InvalidValue(
            "friction_coefficient", given, "a coefficient, or a law as contact",
            "give one of the two",
        )  # fmt: skip
    if contact is not None:
        laws = np.asarray(contact, dtype=object)
        return np.array([coefficient_of(law) for law in laws.ravel()]).reshape(laws.shape)
    mu = _numbers("friction_coefficient", given)
    required("friction_coefficient", np.atleast_1d(np.where(mu == np.inf, 0.0, mu)))
    return mu


def _velocities(given: Any) -> Array:
    moves = _numbers("velocity", given)
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


def _twist(given: Any) -> list[Array]:
    twist = [_numbers("twist", each) for each in given] if hasattr(given, "__len__") else []
    if len(twist) != 3 or not all((np.abs(each) <= SPEEDS[1]).all() for each in twist):
        raise InvalidValue("twist", given, TWIST, "give (v_x, v_y, omega)")
    return twist


def _shape(shapes: list[tuple[int, ...]]) -> tuple[int]:
    try:
        shape = np.broadcast_shapes((1,), *shapes)
    except ValueError:
        shape = ()
    if len(shape) != 1 or not shape[0]:
        different = sorted(set(shapes))
        raise InvalidValue("shapes", different, "() or (scenes,)", "give one number for each scene")
    return shape


def _motions(moves: Any, ends: Array, radius: Array) -> Any:
    """Motions of the fences as `blocks.run_scenes` takes them."""
    if isinstance(moves, np.ndarray):
        motions = np.zeros((len(ends), 1, 3))
        motions[:, 0, 1:] = moves / radius[:, None]
        return motions
    if moves.pieces:
        motions = np.empty((len(ends), len(moves.pieces), 3))
        motions[..., 0] = [start for start, _ in moves.pieces]
        motions[..., 1:] = np.array([v for _, v in moves.pieces]) / radius[:, None, None]
        return motions
    return lambda scene: moves.fence(float(ends[scene]), float(radius[scene]))


def parts_of(samples: int | None) -> Array:
    """Parts of the duration at which the scenes are looked at."""
    if samples is None:
        return np.ones(1)
    count = require_number(
        "samples", samples, lambda n: SAMPLES.holds(n) and n == int(n), SAMPLES.allowed,
        "ask at least for the first and the last instant, or leave it out",
    )  # fmt: skip
    return np.linspace(0.0, 1.0, int(count))
