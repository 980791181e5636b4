"""Consistency of measured pushes: contacts on the outline, one unit, motions into the object."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.places import nearest_place, normals_within
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.possible import require_possible
from planar_pushing.terms.errors import InvalidValue

#: Largest distance of a contact from the outline, relative to the outline's size.
ON_OUTLINE = 0.02
#: Largest error in the length of a normal.
UNIT = 1e-6
#: Largest displacement of an object, in sizes of its outline: no recorded push goes farther.
JUMP = 3.0
#: Largest relative error of load fractions and of the end of a finger's path.
ROUNDING = 1e-6
#: Range of ratios of lengths that indicates meters mixed with millimeters.
THOUSAND = (300.0, 30000.0)


def require_consistent(pushes: xr.Dataset, outlines: dict[str, Outline], rows: Any = None) -> None:
    """Refuse impossible pushes; the error names the first of them.

    Parameters
    ----------
    pushes : xarray.Dataset
    outlines : dict
        The outlines of the objects by their names.
    rows : array_like of int, shape (n,), optional
        Numbers of the pushes in messages; by default counted from 0.

    Raises
    ------
    InvalidValue
        If lengths are in different units, a contact is not on the outline, a normal is not a unit vector or
        points out of the object, a pose jumps, a finger moves away from the object, a path does not match
        its displacement, load fractions do not add up to 1, or no push can cause a final pose
        (`planar_pushing.pushes.logs.possible`).
    """
    labels = np.arange(pushes.sizes["push"]) if rows is None else np.asarray(rows)
    objects: dict[str, tuple[Any, Outline]] = {}
    for name in dict.fromkeys(pushes["pushed"].values):
        numbers = np.flatnonzero(pushes["pushed"].values == name)
        objects[str(name)] = numbers, outlines[str(name)]
        part = pushes.isel(push=numbers)
        _require_object(part, labels[numbers], outlines[str(name)], str(name))
    radii = pushes["finger_radius"].values
    _refuse("finger_radius", radii < 0.0, radii, "numbers >= 0", "give 0 for a point", labels)
    if "finger_path" in pushes:
        _require_paths(pushes, labels)
    if "foot_weight" in pushes:
        _require_shares(pushes)
    if "force" in pushes:
        force = pushes["force"].values
        half = np.isnan(force).sum(axis=1) == 1
        limit = "both components, or NaN for both"
        _refuse("force", half, force, limit, "give both or neither", labels)
    for numbers, outline in objects.values():
        require_possible(pushes.isel(push=numbers), outline, labels[numbers])


def _require_object(pushes: xr.Dataset, numbers: Any, outline: Outline, name: str) -> None:
    """Check the pushes of one object."""
    contact, normal = pushes["contact"].values, pushes["normal"].values
    finger, scale = pushes["finger_displacement"].values, outline.size
    _require_one_unit(pushes, outline, name)
    beside = np.abs(nearest_place(outline, contact).gap)
    limit = f"a point of the outline of {name}, within 2 % of its size {scale:.6g}"
    _refuse(
        "contact", beside > ON_OUTLINE * scale, contact, limit, "check frame and units", numbers
    )
    length = np.hypot(*normal.T)
    wrong = np.abs(length - 1.0) > UNIT
    _refuse("normal", wrong, normal, "a vector of length 1", "divide it by its length", numbers)
    wrong = ~normals_within(outline, contact, normal, ON_OUTLINE * scale)
    _refuse("normal", wrong, normal, "a vector into the object", "reverse it", numbers)
    moved = np.hypot(
        *middle_displacement(
            pushes["displacement"].values, np.deg2rad(pushes["rotation"].values), outline.vertices()
        ).T
    )
    limit = f"at most {JUMP:g} times the size {scale:.6g} of {name}"
    _refuse(
        "displacement",
        moved > JUMP * scale,
        moved,
        limit,
        "the pose jumps: leave the push out",
        numbers,
    )
    away = (finger * normal).sum(axis=1) <= 0.0
    limit = "a motion into the object, along the normal"
    _refuse("finger_displacement", away, finger, limit, "check the sign and the frame", numbers)


def middle_displacement(displacement: Array, rotation: Array, corners: Array) -> Array:
    """Displacement of the mean of an object's corners, shape (n, 2), for rotations in radians."""
    x, y = corners.mean(axis=0)
    c, s = np.cos(rotation) - 1.0, np.sin(rotation)
    return np.asarray(displacement + np.stack([c * x - s * y, s * x + c * y], axis=-1))


def _require_one_unit(pushes: xr.Dataset, outline: Outline, name: str) -> None:
    """Refuse lengths that are about a thousand times larger or smaller than those of the outline."""
    scale, reach = outline.size, float(np.abs(outline.vertices()).max())
    finger = _typical(pushes["finger_displacement"].values)
    object_ = _typical(pushes["displacement"].values)
    pairs = (
        ("contact", _typical(pushes["contact"].values), "the outline reaches to", reach),
        ("finger_displacement", 10.0 * finger, "the outline's size is", scale),
        ("displacement", object_, "the finger moves by", finger),
    )
    for variable, value, known, other in pairs:
        less, more = sorted((value, other))
        if THOUSAND[0] * less < more < THOUSAND[1] * less:
            size = value / 10.0 if variable == "finger_displacement" else value
            raise InvalidValue(
                variable, f"a typical length of {size:.4g}, where {known} {other:.4g}",
                f"lengths of {name} in one unit",
                "check the units: these look like meters and millimeters",
            )  # fmt: skip


def _typical(vectors: Array) -> float:
    return float(np.median(np.hypot(*vectors.T)))


def _require_paths(pushes: xr.Dataset, labels: Any) -> None:
    """Refuse paths that do not start at zero, end at the finger's displacement, and take time."""
    path, times = pushes["finger_path"].values, pushes["path_time"].values
    known = np.isfinite(path).all(axis=2) & np.isfinite(times)
    count = known.sum(axis=1)
    gaps = known != (np.arange(known.shape[1]) < count[:, None])
    limit = "at least two samples with NaN only after the last, or only NaN for a straight path"
    _refuse(
        "finger_path",
        gaps.any(axis=1) | (count == 1),
        path,
        limit,
        "leave out missing samples",
        labels,
    )
    last = path[np.arange(len(path)), count - 1]
    finger = pushes["finger_displacement"].values
    error = np.hypot(*path[:, 0].T) + np.hypot(*(last - finger).T)
    _refuse(
        "finger_path", error > ROUNDING * np.hypot(*finger.T), path,
        "displacements since the first touch, from 0 to finger_displacement", "subtract the first",
        labels,
    )  # fmt: skip
    falls = (np.diff(times, axis=1) <= 0.0).any(axis=1)
    _refuse("path_time", falls, times, "times that increase", "put the samples in order", labels)


def _require_shares(pushes: xr.Dataset) -> None:
    """Refuse known load fractions that are negative or do not add up to 1."""
    if "feet" not in pushes:
        raise InvalidValue(
            "foot_weight", "without feet", "weights of feet", "add the places of the feet"
        )
    shares = pushes["foot_weight"].values
    known = np.isfinite(shares).any(axis=1)
    wrong = known & (
        (np.abs(np.nansum(shares, axis=1) - 1.0) > ROUNDING) | (shares < 0.0).any(axis=1)
    )
    _refuse(
        "foot_weight",
        wrong,
        shares,
        "fractions >= 0 whose sum is 1",
        "divide by their sum",
        dim="object",
    )


def _refuse(
    name: str,
    wrong: Any,
    values: Any,
    allowed: str,
    remedy: str,
    numbers: Any = None,
    dim: str = "push",
) -> None:
    """Raise the error for the first wrong push, and give the number of other wrong pushes."""
    if not np.any(wrong):
        return
    rows = np.flatnonzero(wrong)
    first = rows[0] if numbers is None else numbers[rows[0]]
    more = f" and {len(rows) - 1} more" if len(rows) > 1 else ""
    value = np.array2string(np.asarray(values[rows[0]]), precision=6, separator=", ", threshold=8)
    value = " ".join(value.split())
    raise InvalidValue(name, f"{value} of {dim} {first}{more}", allowed, remedy)
