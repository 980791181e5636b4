"""`simulate_batch`: the motion of many scenes at once, from arrays of parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.effects import Effect, RingFriction
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.blocks import run_scenes
from planar_pushing.simulation.log.variables import MODES
from planar_pushing.simulation.parameters import Scenes, parts_of, scenes_of
from planar_pushing.simulation.problem import policy, tolerance
from planar_pushing.simulation.rows import Stop, in_units
from planar_pushing.terms import quantities
from planar_pushing.terms.options import Policy

STOPS = {stop.name: int(stop) for stop in Stop}
FLAGS = {"mode": MODES, "stopped": STOPS}
#: Variables of the dataset that are those of a row.
SAMPLED = ("time", "position", "rod_angle", "slip", "gap", "mode", "solutions", "stopped")


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
    on_ambiguity: str = Policy.KEEP_CONTACT,
    samples: int | None = None,
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
        Initial twist at the ring centre, omega in radians per time, for scenes with inertia; numbers or
        arrays.
    rtol : float
        Relative tolerance of the motion.
    on_ambiguity : {"keep-contact", "separate", "stay-in-mode"}
        Which mode is taken where several are consistent, as in `simulate`.
    samples : int, optional
        Number of evenly spaced instants, the first and the last included; without it only the last.

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
    parts = parts_of(samples)
    given = scenes_of(
        rod_length, rod_angle, radius, friction_coefficient, contact, effects, velocity, duration,
        twist, gap,
    )  # fmt: skip
    times = given.ends[:, None]
    if samples is not None:
        times = np.linspace(0.0, given.ends, len(parts), axis=-1)
    rows, changes = run_scenes(
        given.kinds, given.rows, given.motions, np.ascontiguousarray(times), tolerance(rtol),
        list(Policy).index(policy(on_ambiguity)),
    )  # fmt: skip
    return _dataset(in_units(rows, given.radius), changes, given, parts if samples else None)


def _dataset(rows: Any, changes: Any, given: Scenes, parts: Array | None) -> xr.Dataset:
    over: tuple[str, ...] = ("scene",) if parts is None else ("scene", "part")
    variables: dict[str, Any] = {}
    for name in SAMPLED:
        values = rows[name].astype("i1") if rows[name].dtype.kind == "i" else rows[name]
        values = np.rad2deg(values) if name == "rod_angle" else values
        dims = (*over, "xy") if name == "position" else over
        variables[name] = dims, np.array(values[:, -1] if parts is None else values)
    evaluations = np.array(rows["evaluations"][:, -1])
    variables |= {"mode_changes": ("scene", changes), "evaluations": ("scene", evaluations)}
    coords: dict[str, Any] = {"xy": ("xy", ["x", "y"])}
    for name, each in given.coordinates.items():
        coords[name] = ("scene", "xy")[: each.ndim], np.array(each)
    if parts is not None:
        coords["part"] = ("part", parts)
    dataset = xr.Dataset(variables, coords)
    for label, variable in dataset.variables.items():
        variable.attrs = dict(quantities.attributes(quantities.BATCH, str(label)))
    for label, flags in FLAGS.items():
        numbers = np.array(list(flags.values()), np.int8)
        dataset[label].attrs |= {"flag_values": numbers, "flag_meanings": " ".join(flags)}
    return dataset
