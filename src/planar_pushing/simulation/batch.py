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
from planar_pushing.simulation.blocks import run_scenes
from planar_pushing.simulation.log.variables import FINGER, described, variables
from planar_pushing.simulation.parameters import coefficients, scenes_of, velocities
from planar_pushing.simulation.problem import Problem, sample_count
from planar_pushing.simulation.pusher import Pusher, required_shape
from planar_pushing.simulation.rows import in_units
from planar_pushing.terms import quantities
from planar_pushing.terms.options import Policy, Shape

#: Variables of the dataset that are those of a row.
SAMPLED = ("time", "position", "rod_angle", "slip", "gap", "mode", "solutions", "stopped")
#: Types of those that are no variables of a log.
TYPES = {"time": "f8", "stopped": "i1"}


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
    progress: bool = False,
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
    progress : bool
        Whether to show a progress bar.

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
    rows, changes = run_scenes(problem, scenes, np.ascontiguousarray(times), progress)
    found = _variables(problem, in_units(rows, scenes.radius), samples is None)
    found["mode_changes"] = "scene", changes
    found["evaluations"] = "scene", np.array(rows["evaluations"][:, -1])
    coordinates = _coordinates(problem, mu, scenes.ends) | (
        {"part": ("part", parts)} if samples else {}
    )
    dataset = xr.Dataset(found, coordinates)
    for label, variable in dataset.variables.items():
        variable.attrs = described(quantities.BATCH, str(label))
    return dataset


def _variables(problem: Problem, rows: Any, only_last: bool) -> dict[str, Any]:
    """The variables of rows, with dimensions and types as in a log."""
    over, rows = (("scene",), rows[:, -1]) if only_last else (("scene", "part"), rows)
    logged = {name: ((), dtype) for name, dtype in TYPES.items()} | variables(problem)
    found: dict[str, Any] = {}
    for name in (*SAMPLED, *(FINGER if problem.shape == Shape.FINGER else ())):
        dims, dtype = logged[name]
        found[name] = (*over, *dims), rows[name].astype(dtype)
    found["rod_angle"] = over, np.rad2deg(rows["rod_angle"])
    return found


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
