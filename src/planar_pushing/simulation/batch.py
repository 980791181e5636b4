"""`simulate_batch`: the motion of many scenes at once, from arrays of parameters."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, cast

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import Effect, RingFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.simulation.blocks import BLOCK, run_scenes
from planar_pushing.simulation.log.variables import MODES
from planar_pushing.simulation.parameters import coefficients, scenes_of, velocities
from planar_pushing.simulation.problem import Problem, sample_count
from planar_pushing.simulation.pusher import Pusher, required_shape
from planar_pushing.simulation.rows import Stop, in_units
from planar_pushing.terms import quantities
from planar_pushing.terms.options import Policy, Shape

STOPS = {stop.name: int(stop) for stop in Stop}
FLAGS = {"mode": MODES, "stopped": STOPS}
#: Variables of the dataset that are those of a row.
SAMPLED = ("time", "position", "rod_angle", "slip", "gap", "mode", "solutions", "stopped")
#: And under a finger.
FINGER = ("contact_position", "parted")
#: Types of those that a row has as whole numbers.
TYPES = {"mode": "i1", "solutions": "i1", "stopped": "i1", "parted": "?"}


def simulate_batch(
    *,
    rod_length: npt.ArrayLike,
    rod_angle: npt.ArrayLike,
    velocity: Any,
    duration: npt.ArrayLike,
    friction_coefficient: Any = None,
    contact: Any = None,
    radius: npt.ArrayLike = 1.0,
    effects: Sequence[Effect] = (RingFriction(),),
    twist: Sequence[npt.ArrayLike] = (0.0, 0.0, 0.0),
    gap: npt.ArrayLike = 0.0,
    rtol: float = 1e-10,
    on_ambiguity: str | Sequence[tuple[float, str]] = Policy.KEEP_CONTACT,
    samples: int | None = None,
    side: tuple[npt.ArrayLike, npt.ArrayLike] = (-math.inf, math.inf),
    shape: str = Shape.FENCE,
) -> xr.Dataset:
    """Simulate many scenes, each as `simulate` does.

    Parameters
    ----------
    rod_length, duration, radius, gap : array_like, shape (scenes,) or ()
        As in `Slider` and `simulate`. All arrays are broadcast against one another.
    rod_angle : array_like, shape (scenes,) or ()
        psi between the fence and the rod, radians, in (0, pi), at time 0.
    velocity : array_like, shape (scenes, 2) or (2,), or Pusher
        Velocity of the fence, length per time; or one motion of the fence for every scene. Scenes under a
        fence that is a function of time run one by one.
    friction_coefficient : array_like, shape (scenes,) or ()
        mu >= 0, infinite for infinite friction by the paper's definition 1.
    contact : ContactLaw, or array of laws
        Instead of a coefficient.
    effects : sequence of effects
        Their parameters may be arrays.
    twist : (v_x, v_y, omega)
        As in `simulate`, omega in radians per time; numbers or arrays.
    rtol, on_ambiguity
        As in `simulate`.
    samples : int, optional
        Number of evenly spaced instants, the first and the last included; without it only the last.
    side : (start, end), of array_like of shape (scenes,) or ()
        As in `Slider`, for fingers.
    shape : {"fence", "finger"}
        What pushes, where velocities are given; a `Pusher` has its own shape.

    Returns
    -------
    xarray.Dataset
        Over `scene`, and `part` of the duration where samples are asked for; angles are degrees. The
        numbers are those of `simulate`.

    Raises
    ------
    InvalidValue
        Where a value is not allowed, or shapes do not match.
    """
    mu = coefficients(friction_coefficient, contact)
    law = Coulomb(np.where(np.isinf(mu), 0.0, mu)) if contact is None else contact
    slider = Slider(rod_length=rod_length, rod_angle=rod_angle, radius=radius, side=cast(Any, side))
    problem = Problem(
        scene=Scene(slider=slider, contact=law, effects=cast(Any, effects)),
        pusher=velocity if isinstance(velocity, Pusher) else velocities(velocity),
        duration=np.atleast_1d(duration), twist=twist, gap=gap, rtol=rtol,
        on_ambiguity=on_ambiguity, shape=required_shape(shape),
    )  # fmt: skip
    parts = np.ones(1) if samples is None else np.linspace(0.0, 1.0, sample_count(samples))
    scenes = scenes_of(problem, mu)
    # As `simulate` has them, bit for bit.
    times = np.linspace(0.0, scenes.ends, len(parts), axis=-1) if samples else scenes.ends[:, None]
    block = 1 if callable(getattr(velocity, "velocity", None)) else BLOCK
    rows, changes = run_scenes(problem, scenes, np.ascontiguousarray(times), block)
    names = SAMPLED + (FINGER if problem.shape == Shape.FINGER else ())
    found = _variables(in_units(rows, scenes.radius), names, changes, samples is None)
    coordinates = _coordinates(problem, mu, scenes.ends) | (
        {"part": ("part", parts)} if samples else {}
    )
    return _described(xr.Dataset(found, coordinates))


def _variables(rows: Any, names: Sequence[str], changes: Array, only_last: bool) -> dict[str, Any]:
    over = ("scene",) if only_last else ("scene", "part")
    found: dict[str, Any] = {}
    for name in names:
        values = rows[name].astype(TYPES.get(name, rows[name].dtype))
        values = np.rad2deg(values) if name == "rod_angle" else values
        dims = (*over, "xy") if name == "position" else over
        found[name] = dims, np.array(values[:, -1] if only_last else values)
    evaluations = np.array(rows["evaluations"][:, -1])
    return found | {"mode_changes": ("scene", changes), "evaluations": ("scene", evaluations)}


def _coordinates(problem: Problem, mu: Array, ends: Array) -> dict[str, Any]:
    """What the dataset says of each scene."""
    slider, size = problem.scene.slider, len(ends)
    given = {
        "rod_length": slider.rod_length, "initial_rod_angle": np.rad2deg(slider.rod_angle),
        "friction_coefficient": mu, "duration": ends,
    }  # fmt: skip
    found: dict[str, Any] = {"xy": ("xy", ["x", "y"])}
    for name, each in given.items():
        found[name] = "scene", np.array(np.broadcast_to(np.asarray(each, float), (size,)))
    if not isinstance(problem.pusher, Pusher):
        found["velocity"] = ("scene", "xy"), np.array(np.broadcast_to(problem.pusher, (size, 2)))
    return found


def _described(dataset: xr.Dataset) -> xr.Dataset:
    """The dataset with units, names and flags."""
    for label, variable in dataset.variables.items():
        variable.attrs = dict(quantities.attributes(quantities.BATCH, str(label)))
    for label, flags in FLAGS.items():
        numbers = np.array(list(flags.values()), np.int8)
        dataset[label].attrs |= {"flag_values": numbers, "flag_meanings": " ".join(flags)}
    return dataset
