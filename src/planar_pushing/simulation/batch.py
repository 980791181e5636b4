"""`simulate_batch`: the quasi-static motion of many scenes at once, from arrays of parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.errors import InvalidValue, require_number, require_positive
from planar_pushing.mechanics.options import TOLERANCE, Policy
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.quantities import BATCH, attributes
from planar_pushing.simulation.batch_parameters import (
    require_friction,
    sample_parts,
    scene_parameters,
)
from planar_pushing.simulation.course import NO_MODE, PREFERENCES, Course
from planar_pushing.simulation.lanes import Lanes
from planar_pushing.simulation.log import MODES

#: A rod this short, in radii, turns the slider by less than the smallest double.
VANISHING = 1e-100
#: Part of the tolerance that one step may use, since the errors of steps add up.
STEP_PART = 0.1
STOPS = {"NO": 0, "INCONSISTENT": 1, "LIES": 2}
FLAGS = {"mode": MODES, "stopped": STOPS}


def simulate_batch(
    *,
    rod_length: npt.ArrayLike,
    rod_angle: npt.ArrayLike,
    friction_coefficient: npt.ArrayLike,
    velocity: npt.ArrayLike,
    duration: npt.ArrayLike,
    radius: float = 1.0,
    effects: Sequence[IsotropicEffect] = (RingFriction(),),
    rtol: float = 1e-10,
    on_ambiguity: str = Policy.KEEP_CONTACT,
    samples: int | None = None,
) -> xr.Dataset:
    """Simulate many quasi-static scenes under a constant fence velocity each.

    Parameters
    ----------
    rod_length, rod_angle, friction_coefficient, duration : array_like, shape (scenes,) or ()
        Length >= 0; radians in (0, pi); mu >= 0, infinite for infinite friction by the paper's
        definition 1; time > 0. They are broadcast against one another.
    velocity : array_like, shape (scenes, 2) or (2,)
        Velocity of the fence, length per time.
    radius : float
        R > 0 of every ring.
    effects : sequence of RingFriction
        A batch takes scenes of friction alone, whose motion the weight does not change.
    rtol : float
        Relative tolerance of the motion.
    on_ambiguity : {"keep-contact", "separate", "stay-in-mode"}
        Which mode is taken where several are consistent, as in `simulate`.
    samples : int, optional
        Number of evenly spaced instants, the first and the last included; without it only the last.

    Returns
    -------
    xarray.Dataset
        Over `scene`, and `part` of the duration where samples are asked for. Angles are degrees. The
        scenes move in step as arrays, which pays from some hundreds of scenes.

    Raises
    ------
    InvalidValue
        Where a value is not allowed, shapes do not match, or an effect is not ring friction.
    """
    require_friction(effects)
    size = require_positive("radius", radius, "give the radius of the rings")
    tolerance = require_number(
        "rtol", rtol, TOLERANCE.holds, TOLERANCE.allowed,
        "choose a tolerance that double precision can hold",
    )  # fmt: skip
    if on_ambiguity not in PREFERENCES:
        raise InvalidValue(
            "on_ambiguity", on_ambiguity, ", ".join(PREFERENCES), "name one of these policies"
        )
    given = scene_parameters(rod_length, rod_angle, friction_coefficient, velocity, duration)
    parts = sample_parts(samples)
    lanes, preference = _lanes(given, size), PREFERENCES[on_ambiguity]
    course = Course(lanes, preference, STEP_PART * tolerance, given["rod_angle"].copy())
    taken = []
    for part in parts:
        course.run(part * given["duration"])
        taken.append(_instant(course, given, size))
    return _dataset(course, given, taken, parts if samples is not None else None)


def _lanes(given: dict[str, Array], radius: float) -> Lanes:
    mu, velocity = given["friction_coefficient"], given["velocity"]
    right = np.where(np.isinf(mu), 0.0, np.arctan2(1.0, mu))
    return Lanes(
        length=np.maximum(given["rod_length"] / radius, VANISHING),
        heading=np.arctan2(velocity[:, 1], velocity[:, 0]),
        pusher=velocity / radius,
        right=right,
        left=np.pi - right,
    )


def _instant(course: Course, given: dict[str, Array], radius: float) -> dict[str, Any]:
    """Where every scene is."""
    length, velocity, lasted = given["rod_length"], given["velocity"], course.contact_time
    slip = radius * course.slip
    x = velocity[:, 0] * lasted + slip + length * np.cos(course.angle)
    y = velocity[:, 1] * lasted + length * np.sin(course.angle)
    return {
        "time": course.time.copy(),
        "position": np.stack([x, y], axis=-1),
        "rod_angle": np.rad2deg(course.angle),
        "slip": slip,
        "gap": np.maximum(velocity[:, 1] * (lasted - course.time), 0.0),
        "mode": course.mode.astype(np.int8),
        "solutions": course.choices.astype(np.int8),
        "stopped": np.where(course.lies, STOPS["LIES"], course.mode == NO_MODE).astype(np.int8),
    }


def _dataset(
    course: Course, given: dict[str, Array], taken: list[dict[str, Any]], parts: Array | None
) -> xr.Dataset:
    dims: tuple[str, ...] = ("scene",) if parts is None else ("scene", "part")
    variables: dict[str, Any] = {}
    for key, values in taken[0].items():
        along = values if parts is None else np.stack([each[key] for each in taken], axis=1)
        variables[key] = ((*dims, "xy") if key == "position" else dims, along)
    variables |= {
        "mode_changes": ("scene", course.changes),
        "evaluations": ("scene", course.evaluations),
    }
    coords: dict[str, Any] = {
        "xy": ("xy", ["x", "y"]),
        "rod_length": ("scene", given["rod_length"]),
        "initial_rod_angle": ("scene", np.rad2deg(given["rod_angle"])),
        "friction_coefficient": ("scene", given["friction_coefficient"]),
        "velocity": (("scene", "xy"), given["velocity"]),
        "duration": ("scene", given["duration"]),
    }
    if parts is not None:
        coords["part"] = ("part", parts)
    dataset = xr.Dataset(variables, coords)
    for name, variable in dataset.variables.items():
        variable.attrs = dict(attributes(BATCH, str(name)))
    for label, flags in FLAGS.items():
        values = np.array(list(flags.values()), np.int8)
        dataset[label].attrs |= {"flag_values": values, "flag_meanings": " ".join(flags)}
    return dataset
