"""The pushes of one object as arrays, with derived quantities."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import (
    BEFORE,
    BETA0,
    BETA1,
    LENGTH,
    NEXT,
    RHO,
    wrap,
)
from planar_pushing.mechanics.outline.grown import Seats, places_of
from planar_pushing.mechanics.outline.places import Places, nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.schema import NOISE, outline_of
from planar_pushing.terms.errors import InvalidValue

#: Arrays of flags over pushes, and of indices of pushes.
Mask = npt.NDArray[np.bool_]
Index = npt.NDArray[np.intp]
#: Default standard deviations of motion capture, a force sensor and friction if a dataset gives none:
#: fractions of the outline's size, of the median force and of friction, and an angle in degrees.
POSITION, ANGLE, FORCE, REPEATABILITY = 0.003, 0.3, 0.02, 0.05
#: Distance from an inner corner, in tolerances of the outline, at which a finger is beside it.
BESIDE = 4.0
#: Number of straight parts that represent the measured path of a finger.
PARTS = 8


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Measured:
    """Pushes of one object: arrays over n pushes, in the object's frame before the push.

    Attributes
    ----------
    outline : Outline
    contact, normal : ndarray, shape (n, 2)
        Point of first touch, and the unit normal there, into the object.
    finger, displacement : ndarray, shape (n, 2)
        Displacements of the finger's center since the first touch, and of the object's frame.
    rotation : ndarray, shape (n,)
        Rotation of the object in radians.
    radius : ndarray, shape (n,)
        Radius of the finger.
    force : ndarray, shape (n, 2)
        Mean force on the object along the object's axes; NaN if it was not measured.
    path : ndarray, shape (n, parts, 2)
        Displacements of the finger's center over equal parts of its path.
    noise : tuple of float
        Standard deviations of the displacement, the rotation in radians, and the force.
    repeatability : float
        Relative variation of friction from one push to the next.
    """

    outline: Outline
    contact: Array
    normal: Array
    finger: Array
    displacement: Array
    rotation: Array
    radius: Array
    force: Array
    path: Array
    noise: tuple[float, float, float]
    repeatability: float = REPEATABILITY

    def __len__(self) -> int:
        return len(self.contact)

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def part(self, rows: Any) -> Measured:
        """A selection of the pushes."""
        kept = {entry.name for entry in fields(self)} - {"outline", "noise", "repeatability"}
        return replace(self, **{name: getattr(self, name)[rows] for name in kept})

    @property
    def length(self) -> float:
        """Length that converts angles to distances: half the extent of the outline."""
        return self.size / 2.0

    @property
    def center(self) -> Array:
        """Centroid of the outline."""
        return np.array(self.outline.centroid)

    @property
    def size(self) -> float:
        """Largest extent of the outline along x or y."""
        return self.outline.size

    @property
    def observed(self) -> Array:
        """Displacement and rotation, shape (n, 3)."""
        return np.column_stack([self.displacement, self.rotation])

    @property
    def twists(self) -> Array:
        """Mean twist of the object's frame over each push, in the object's axes, shape (n, 3).

        It is the constant twist that produces the measured displacement in one unit of time.
        """
        half = self.rotation / 2.0
        factor = half / np.tan(np.where(half == 0.0, 1.0, half))
        factor = np.where(half == 0.0, 1.0, factor)
        x, y = self.displacement.T
        return np.column_stack([factor * x + half * y, factor * y - half * x, self.rotation])

    @property
    def first_places(self) -> Places:
        """Place of the outline that the finger touches first, with the given normal at a corner.

        A finger at an inner corner is beside it, on the piece with the normal that is closer to the given
        one.
        """
        outline, places = self.outline, nearest_place(self.outline, self.contact)
        rows = outline.pieces[places.piece]
        is_corner, is_inner = rows[:, RHO] == 0.0, rows[:, BETA1] < rows[:, BETA0]
        ends = np.sort(rows[:, [BETA0, BETA1]], axis=1)
        middle = ends.mean(axis=1)
        beta = middle + wrap(np.arctan2(-self.normal[:, 0], self.normal[:, 1]) - middle)
        places = places._replace(beta=np.where(is_corner, np.clip(beta, *ends.T), places.beta))
        if not (is_corner & is_inner).any():
            return places
        is_before = np.abs(beta - rows[:, BETA0]) < np.abs(beta - rows[:, BETA1])
        piece = np.where(is_before, rows[:, BEFORE], rows[:, NEXT]).astype(int)
        off = BESIDE * outline.tolerance
        along = np.where(is_before, outline.pieces[piece, LENGTH] - off, off)
        beside = places_of(Seats(piece, along), outline, np.zeros(len(self)))
        return Places(*(
            np.where((is_corner & is_inner).reshape(-1, *(1,) * (old.ndim - 1)), new, old)
            for old, new in zip(places, beside, strict=True)
        ))  # fmt: skip

    @property
    def last_places(self) -> Places:
        """Place of the outline nearest the finger after each push, in the object's frame at that time."""
        center = self.contact - self.radius[:, None] * self.normal + self.finger
        x, y = (center - self.displacement).T
        c, s = np.cos(self.rotation), np.sin(self.rotation)
        return nearest_place(self.outline, np.column_stack([c * x + s * y, c * y - s * x]))

    @property
    def points(self) -> Array:
        """Point at which the finger pushes midway, in the object's frame, shape (n, 2)."""
        return (self.contact + self.last_places.point) / 2.0

    @property
    def has_force(self) -> Mask:
        """Whether the force of each push was measured."""
        return np.asarray(
            np.isfinite(self.force).all(axis=1) & (np.abs(self.force).max(axis=1) > 0.0)
        )

    @property
    def has_directions(self) -> Mask:
        """Whether each push has a measured force and moved the object."""
        return np.asarray(self.has_force & self.observed.any(axis=1))

    @property
    def wrenches(self) -> Array:
        """Wrench of each push about the origin of the object's frame, shape (n, 3)."""
        (x, y), (f_x, f_y) = self.points.T, self.force.T
        return np.column_stack([f_x, f_y, x * f_y - y * f_x])

    @property
    def centered_twists(self) -> Array:
        """Mean twists of the outline's centroid, shape (n, 3)."""
        return twists_at(self.twists, self.center)

    @property
    def centered_wrenches(self) -> Array:
        """Wrenches about the outline's centroid, shape (n, 3)."""
        return wrenches_about(self.wrenches, self.center)

    @property
    def at_corner(self) -> Mask:
        """Whether each push touches a convex corner first."""
        rows = self.outline.pieces
        offset = self.contact[:, None] - rows[rows[:, RHO] == 0.0, :2]
        if not offset.size:
            return np.zeros(len(self), dtype=bool)
        return np.asarray(np.hypot(offset[..., 0], offset[..., 1]).min(axis=1) <= 1e-9 * self.size)


def twists_at(twists: Array, point: Array) -> Array:
    """Twists of a point of the object, from the twists of its frame's origin."""
    v_x, v_y, turn = twists.T
    return np.column_stack([v_x - turn * point[1], v_y + turn * point[0], turn])


def wrenches_about(wrenches: Array, point: Array) -> Array:
    """Wrenches about a point, from wrenches about the origin."""
    f_x, f_y, torque = wrenches.T
    return np.column_stack([f_x, f_y, torque - point[0] * f_y + point[1] * f_x])


def measurements_of(pushes: xr.Dataset) -> Measured:
    """Arrays of the pushes in a checked dataset of one object.

    Raises
    ------
    InvalidValue
        If the dataset has several objects.
    """
    names = [str(label) for label in pushes["object"].values]
    if len(names) > 1:
        raise InvalidValue(
            "pushes", f"pushes of {', '.join(names)}", "pushes of one object",
            "choose one with of_object(pushes, name)",
        )  # fmt: skip
    outline = outline_of(pushes, names[0])
    finger = pushes["finger_displacement"].values
    force = pushes["force"].values if "force" in pushes else np.full(finger.shape, np.nan)
    usual = POSITION * outline.size, ANGLE, FORCE * _median(np.hypot(*force.T)), REPEATABILITY
    position, angle, newton, friction = (
        float(pushes.attrs.get(name, default)) for name, default in zip(NOISE, usual, strict=True)
    )
    return Measured(
        outline=outline, contact=pushes["contact"].values, normal=pushes["normal"].values,
        finger=finger, displacement=pushes["displacement"].values,
        rotation=np.deg2rad(pushes["rotation"].values), radius=pushes["finger_radius"].values,
        force=force, path=_paths(pushes, finger), noise=(position, float(np.deg2rad(angle)), newton),
        repeatability=friction,
    )  # fmt: skip


def _median(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) else 0.0


def _paths(pushes: xr.Dataset, finger: Array) -> Array:
    """Displacements over equal parts of the fingers' paths; paths that were not measured are straight."""
    if "finger_path" not in pushes:
        return finger[:, None]
    return np.stack(
        [_parts(path, end) for path, end in zip(pushes["finger_path"].values, finger, strict=True)]
    )


def _parts(path: Array, end: Array) -> Array:
    """Displacements over equal parts of one path; an unknown path is straight."""
    known = path[np.isfinite(path).all(axis=1)]
    ways = (
        np.append(0.0, np.hypot(*np.diff(known, axis=0).T).cumsum()) if len(known) else np.zeros(1)
    )
    marks = np.linspace(0.0, 1.0, PARTS + 1)
    if ways[-1] == 0.0:
        return np.tile(end / PARTS, (PARTS, 1))
    x, y = (np.interp(marks * ways[-1], ways, column) for column in known.T)
    return np.diff(np.column_stack([x, y]), axis=0)
