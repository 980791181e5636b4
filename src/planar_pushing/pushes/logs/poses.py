"""Pushes from poses of an object and positions of a finger in the world."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.outline import Outline, require_outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.arguments import (
    noise_attributes,
    not_negative,
    numbers,
    object_parts,
    require_units,
    rows_of,
)
from planar_pushing.pushes.logs.checks import JUMP, ON_OUTLINE, middle_displacement
from planar_pushing.pushes.logs.path import Path, require_path
from planar_pushing.pushes.logs.possible import push_numbers
from planar_pushing.pushes.logs.schema import VARIABLES, XY, outline_arrays, pad, require_pushes
from planar_pushing.pushes.logs.touching import touching_pushes
from planar_pushing.terms.domain import RADIANS, TO_RADIANS, TURNS
from planar_pushing.terms.errors import InvalidValue, number_of, require_flag

#: Rounding error of wrapped angles, in radians: that of pi in single precision.
ROUNDING = 1e-6
#: Range of distances of the finger from the object, in sizes of the outline, outside which units differ.
FAR, NEAR = 100.0, 0.01


class Frames(NamedTuple):
    """Frames of an object before each push, and their motions, as arrays over pushes; angles in radians."""

    origin: Array
    angle: Array
    displacement: Array
    rotation: Array

    def places(self, points: Array) -> Array:
        """Positions in the world, shape (n, m, 2), converted to the object's frame before the push."""
        return rotate(points - self.origin[:, None], -self.angle[:, None])


def pushes_from_poses(
    *,
    outline: Any,
    poses_before: npt.ArrayLike,
    poses_after: npt.ArrayLike,
    finger_start: npt.ArrayLike | None = None,
    finger_end: npt.ArrayLike | None = None,
    finger_radius: float = 0.0,
    force: npt.ArrayLike | None = None,
    feet: npt.ArrayLike | None = None,
    foot_weights: npt.ArrayLike | None = None,
    center_of_mass: npt.ArrayLike | None = None,
    mass: float | None = None,
    finger_path: npt.ArrayLike | None = None,
    path_time: npt.ArrayLike | None = None,
    units: tuple[str, str] = ("mm", "N"),
    name: str = "object",
    source: str = "",
    noise: tuple[float, float, float] | None = None,
    tolerance: float | None = None,
    skip_missed: bool = False,
) -> xr.Dataset:
    """Dataset of pushes of one object from its poses and the finger's positions in the world frame.

    Parameters
    ----------
    outline : array_like, shape (corners, 2), Polygon, Disc, Outline, or a polygon of shapely
        Corners of the object in order, or its outline with arcs and holes, in its own frame.
    poses_before, poses_after : array_like, shape (n, 3)
        (x, y, angle) of the object's frame in the world before and after each push, angles in radians, at
        most 4 pi. A push rotates the object by less than pi. If all angles lie in [-pi, pi] or all
        in [0, 2 pi], they are taken as wrapped, so that 3.1 and -3.1 differ by 0.083; other angles are
        taken as unwrapped.
    finger_start, finger_end : array_like, shape (n, 2)
        Center of the finger before and after each push; it moves straight from one to the other.
    finger_radius : float
        Radius of the finger; 0 for a point.
    force : array_like, shape (n, 2), optional
        Mean force of the finger on the object during each push, along the world's axes; NaN if it was not
        measured.
    feet : array_like, shape (feet, 2), optional
        Positions of the feet in the object's frame.
    foot_weights : array_like, shape (feet,), optional
        Loads of the feet, in any unit.
    center_of_mass : (x, y), optional
        Center of mass in the object's frame.
    mass : float, optional
        Mass in kg.
    finger_path : array_like, shape (n, samples, 2), instead of finger_start and finger_end
        Centers of the finger over time; NaN after the end of a shorter path.
    path_time : array_like, shape (n, samples)
        Times of the samples of `finger_path`, in seconds.
    units : (str, str)
        Names of the units of lengths and forces.
    name : str
        Name of the object.
    source : str
        Source of the measurements.
    noise : (float, float, float), optional
        Standard deviations of positions, of angles in degrees, and of forces.
    tolerance : float, optional
        Largest overlap of finger and object at the start of a push that is attributed to noise; the finger
        then touches immediately. By default 2 % of the size of the outline.
    skip_missed : bool
        Whether to omit pushes that do not touch the object or begin deeper in it than the tolerance; their
        number is then the attribute `left_out`.

    Returns
    -------
    xarray.Dataset
        Dataset like that of `load_pushes`: contact, normal and finger displacement since the first touch,
        and displacement and rotation of the object, in the object's frame before the push.

    Raises
    ------
    InvalidValue
        If shapes differ, a value is missing, lengths are in different units, angles are in degrees, a push
        does not touch the object or begins deeper in it than the tolerance and is not omitted, a pose
        jumps, or no push can cause a final pose: the finger ends in the object or never reaches it, or the
        object moves farther than the finger's work permits, as after a confusion of symmetric poses. The
        message counts pushes from 0.
    """
    whole, names = require_outline(outline), require_units(units)
    frames = _frames(
        rows_of("poses_before", poses_before, 3), rows_of("poses_after", poses_after, 3)
    )
    count = len(frames.angle)
    world = require_path(finger_start, finger_end, finger_path, path_time, count)
    path = world._replace(points=frames.places(world.points))
    _require_one_unit(whole, path.points[:, 0])
    _refuse_jumps(whole, frames)
    slack = ON_OUTLINE * whole.size
    if tolerance is not None:
        slack = not_negative("tolerance", tolerance, "give a length, or leave it out")
    radius = not_negative("finger_radius", finger_radius, "give 0 for a point")
    skip_missed = require_flag("skip_missed", skip_missed)
    rows, touch, after = touching_pushes(whole, path, radius, slack, skip_missed)
    forces = None if force is None else _forces(force, frames)
    arrays: dict[str, Any] = {
        **outline_arrays([whole]),
        **object_parts(feet, foot_weights, center_of_mass, mass),
        "contact": touch.contact[rows],
        "normal": touch.normal[rows],
        "finger_displacement": np.array([path.points[-1] for path in after]),
        **({} if path.times is None else _path(after)),
        "finger_radius": np.full(len(rows), radius),
        "displacement": frames.displacement[rows],
        "rotation": np.rad2deg(frames.rotation[rows]),
        **({} if forces is None else {"force": forces[rows]}),
    }
    variables: dict[str, Any] = {}
    for key, array in arrays.items():
        unit = names.get(VARIABLES[key].quantity)
        variables[key] = VARIABLES[key].dims, array, {} if unit is None else {"units": unit}
    pushed = {"pushed": ("push", np.full(len(rows), name, dtype=object))}
    attributes = {"source": source, **noise_attributes(noise)} | (
        {"left_out": count - len(rows)} if skip_missed else {}
    )
    dataset = xr.Dataset(pushed | variables, {"object": [name], "xy": XY}, attributes)
    return require_pushes(dataset, rows)


def rotate(vectors: Array, angle: Array) -> Array:
    """Vectors of shape S + (2,) rotated by angles of shape S in radians."""
    c, s = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)


def _frames(before: Array, after: Array) -> Frames:
    """Frames before the pushes, and the motions of the object in these frames."""
    if len(before) != len(after):
        raise InvalidValue(
            "poses_after", number_of(len(after), "pose"),
            f"{number_of(len(before), 'pose')}, as in poses_before",
            "give both poses of each push",
        )  # fmt: skip
    _refuse_degrees(before[:, 2], after[:, 2])
    rotation = (after[:, 2] - before[:, 2] + np.pi) % (2.0 * np.pi) - np.pi
    moved = rotate(after[:, :2] - before[:, :2], -before[:, 2])
    return Frames(before[:, :2], before[:, 2], moved, rotation)


def _refuse_degrees(before: Array, after: Array) -> None:
    """Refuse angles beyond two turns, and rotations by more than pi, which are in degrees.

    Angles of one of the two conventions of wrapping may differ by up to a turn across its cut.
    """
    for name, angles in (("poses_before", before), ("poses_after", after)):
        beyond = np.flatnonzero(np.abs(angles) > TURNS)
        if len(beyond):
            beyond_turns = f"the angle {angles[beyond[0]]:.6g}, in pushes {push_numbers(beyond)}"
            raise InvalidValue(name, beyond_turns, f"angles in {RADIANS}", TO_RADIANS)
    far = ambiguous_turns(before, after)
    if len(far):
        turn = after[far[0]] - before[far[0]]
        raise InvalidValue(
            "poses_after", f"a rotation by {turn:.6g} radians, in pushes {push_numbers(far)}",
            "pushes that rotate the object by less than pi", f"give radians: {TO_RADIANS}",
        )  # fmt: skip


def ambiguous_turns(before: Array, after: Array) -> npt.NDArray[np.intp]:
    """Numbers of pushes whose angles in radians differ by more than pi, unless all are wrapped alike."""
    every = np.concatenate([before, after])
    low, high = every.min(), every.max()
    half = np.pi + ROUNDING
    if (-half <= low and high <= half) or (low >= -ROUNDING and high <= half + np.pi):
        return np.zeros(0, dtype=np.intp)
    return np.flatnonzero(np.abs(after - before) > half)


def _require_one_unit(outline: Outline, starts: Array) -> None:
    """Refuse finger positions so far from the object, or so near its middle, that the units must differ."""
    places, scale = outline.vertices(), outline.size
    far = float(np.median(np.hypot(*(starts - places.mean(axis=0)).T))) if len(starts) else scale
    if not NEAR * scale <= far <= FAR * scale:
        raise InvalidValue(
            "finger_start", f"{far:.4g} from the middle of an outline of size {scale:.4g}",
            "lengths in one unit", "check the units of outline, poses and finger",
        )  # fmt: skip


def _refuse_jumps(outline: Outline, frames: Frames) -> None:
    """Refuse poses between which the object moves farther than any push can move it."""
    places, scale = outline.vertices(), outline.size
    moved = np.hypot(*middle_displacement(frames.displacement, frames.rotation, places).T)
    jumps = np.flatnonzero(moved > JUMP * scale)
    if len(jumps):
        raise InvalidValue(
            "poses_after",
            f"an object that moves by {moved[jumps[0]]:.4g}, in pushes {push_numbers(jumps)}",
            f"at most {JUMP:g} times its size {scale:.4g}", "the pose jumps: leave the push out",
        )  # fmt: skip


def _forces(value: Any, frames: Frames) -> Array:
    """Forces along the object's axes halfway through its rotation."""
    world = numbers("force", value)
    if world.shape != (len(frames.angle), 2):
        allowed = f"shape ({len(frames.angle)}, 2)"
        raise InvalidValue(
            "force", f"shape {world.shape}", allowed, "give NaN where it was not measured"
        )
    return rotate(world, -(frames.angle + frames.rotation / 2.0))


def _path(after: list[Path]) -> dict[str, Array]:
    """Paths of the finger over time, padded to equal length."""
    return {
        "finger_path": pad([path.points for path in after]),
        "path_time": pad([np.asarray(path.times) for path in after]),
    }
