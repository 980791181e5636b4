"""Final poses that a push can cause: bounds on where the finger ends and on its work.

An object on a quasi-static support moves only while the finger touches it, and no finger enters it. Two
conditions follow for any push:

- The finger ends outside the object.
- Its path since the first touch reaches the object in its final pose, unless the object did not move.

A third condition is on the work. The force of the finger is that of the support, of magnitude at most W,
and friction between finger and object only consumes work. A finger with a path of length L therefore does
at most W L of work. The support consumes W times the mean path of the points that carry the object, and no
path is shorter than the distance between its ends. Hence

    sum_j p_j |d_j| <= L

for the displacements d_j of the points and the fractions p_j of the load that they carry. If the loads are
unknown, at least one point moves by no more than L: one of the feet, or one within the outline. This bound
holds for every pressure.

Symmetric objects have poses that a tracker confuses, such as rotated by 180 degrees. A pressure at a single
point may permit them. A fourth condition, if no feet are known, is therefore not a theorem: if
the finger ends at a side that faces elsewhere than the side that it touched first, the mean displacement of
the points of the object exceeds L by no more than `CONCENTRATED` sizes. In 2079 published pushes of
polygons on their faces the excess is at most 0.03 sizes, except for one of 0.22 sizes, a turn by 131
degrees of a hexagon. In simulated pushes of a square, a rectangle of 5 by 2 and a triangle with all the
weight on one spot and a finger that stays on its side, it is up to 0.23 sizes for a spot 0.08 sizes from
the middle, and up to 0.37 for one 0.16 sizes from it. Give the feet of an object that rests on such a
spot.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.outline.plate import bounds
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidValue

#: Systematic error of poses, finger and outline, in sizes of the outline: the largest of all published
#: pushes, by the first three conditions, is 0.032.
ERROR = 0.05
#: Standard deviations of the given noise that are added to it.
SURE = 5.0
#: Largest excess of the mean displacement over the finger's path, in sizes, where no feet are known.
CONCENTRATED = 0.25
#: Cosine of the angle between the normals of two sides that face in different directions.
ELSEWHERE = float(np.cos(np.deg2rad(46.0)))
#: Number of equal parts of a finger's path at whose ends its distance is measured.
PARTS = 32
#: Number of cells along the size of an object over which a displacement is averaged.
CELLS = 24
#: Most push numbers listed in a message.
LISTED = 8
REMEDY = "check units, frame and order of the poses, or leave the push out"


class PushMotions(NamedTuple):
    """Motions of n pushes: the finger's center along its path, and the object's displacement.

    `center` has shape (n, PARTS + 1, 2), for equal parts of the path, and `length` is the path's length.
    """

    center: Array
    length: Array
    radius: Array
    displacement: Array
    rotation: Array

    def distances(self, points: Array) -> Array:
        """Distances by which points of shape (m, 2) of the object move, shape (n, m)."""
        c, s = np.cos(self.rotation)[:, None] - 1.0, np.sin(self.rotation)[:, None]
        (x, y), (d_x, d_y) = points.T, self.displacement.T[..., None]
        return np.asarray(np.hypot(d_x + c * x - s * y, d_y + s * x + c * y))

    def gaps(self, outline: Outline) -> tuple[Array, Array]:
        """Gaps of the finger and the object in its final pose, shape (n, PARTS + 1), and last normals."""
        offset = self.center - self.displacement[:, None]
        c, s = np.cos(self.rotation)[:, None], np.sin(self.rotation)[:, None]
        x, y = offset[..., 0], offset[..., 1]
        centers = np.column_stack([(c * x + s * y).ravel(), (c * y - s * x).ravel()])
        near = nearest_place(outline, centers)
        gaps = near.gap.reshape(x.shape) - self.radius[:, None]
        return gaps, near.normal.reshape(*x.shape, 2)[:, -1]


def require_possible(pushes: xr.Dataset, outline: Outline, numbers: Any) -> None:
    """Refuse pushes of one object that end in a pose that no push can cause.

    Raises
    ------
    InvalidValue
        If a finger ends in the object or never reaches its final pose, or an object moves farther than the
        work of the finger permits; see the conditions in the docstring of this module.
    """
    motion, size = _motion(pushes), outline.size
    slack = ERROR * size + SURE * _noise(pushes, size)
    gaps, last_normal = motion.gaps(outline)
    _refuse(
        -gaps[:, -1], slack, numbers, "a finger that ends {:.4g} deep in the object",
        "at most {:.4g}, for errors of measurement",
    )  # fmt: skip
    apart = gaps.min(axis=1) - motion.length / (2.0 * PARTS)
    still = motion.distances(outline.vertices()).max(axis=1) <= slack
    _refuse(
        np.where(still, 0.0, apart), slack, numbers,
        "an object that ends {:.4g} away from the finger's path",
        "at most {:.4g}: an object moves only while the finger touches it",
    )  # fmt: skip
    points, shares = _carriers(pushes)
    if points is None:
        least = _least_within(motion, outline.vertices())
    elif shares is None:
        least = motion.distances(points).min(axis=1)
    else:
        least = motion.distances(points) @ shares
    limit = "a finger moves an object on its support no farther than itself, {:.4g} with errors"
    _refuse(least, motion.length + slack, numbers, "an object that moves by {:.4g}", limit)
    if points is not None:
        return
    normal = pushes["normal"].values
    turned = (normal * last_normal).sum(axis=1) < ELSEWHERE
    mean = np.where(turned, motion.distances(_cells(outline)).mean(axis=1), 0.0)
    _refuse(
        mean, motion.length + CONCENTRATED * size + slack - ERROR * size, numbers,
        "points of the object that move by {:.4g} on average, and a finger that ends at another side",
        "at most {:.4g} for the finger's path",
        "the pose is turned by a symmetry of the object, as trackers do: leave the push out",
    )  # fmt: skip


def _motion(pushes: xr.Dataset) -> PushMotions:
    """Motions of the pushes of a dataset."""
    radius, end = pushes["finger_radius"].values, pushes["finger_displacement"].values
    start = pushes["contact"].values - radius[:, None] * pushes["normal"].values
    parts = np.linspace(0.0, 1.0, PARTS + 1)
    path, length = end[:, None] * parts[:, None], np.hypot(*end.T)
    if "finger_path" in pushes:
        for row, samples in enumerate(pushes["finger_path"].values):
            known = samples[np.isfinite(samples).all(axis=1)]
            if not len(known):
                continue
            along = np.append(0.0, np.hypot(*np.diff(known, axis=0).T).cumsum())
            length[row] = along[-1]
            path[row] = np.column_stack(
                [np.interp(parts * along[-1], along, column) for column in known.T]
            )
    return PushMotions(
        start[:, None] + path, length, radius, pushes["displacement"].values,
        np.deg2rad(pushes["rotation"].values),
    )  # fmt: skip


def _noise(pushes: xr.Dataset, size: float) -> float:
    """Standard deviation of a distance, from the noise that the dataset gives."""
    position, angle = (
        float(pushes.attrs.get(name, 0.0)) for name in ("position_noise", "angle_noise")
    )
    return position + float(np.deg2rad(angle)) * size / 2.0


def _carriers(pushes: xr.Dataset) -> tuple[Array | None, Array | None]:
    """Feet of the only object of some pushes and their fractions of the load; None if unknown."""
    name = str(pushes["pushed"].values[0])
    if "feet" not in pushes:
        return None, None
    feet = pushes["feet"].sel(object=name).values
    known = np.isfinite(feet).all(axis=1)
    if not known.any():
        return None, None
    shares = (
        pushes["foot_weight"].sel(object=name).values[known] if "foot_weight" in pushes else None
    )
    return feet[known], shares if shares is not None and np.isfinite(shares).all() else None


def _least_within(motion: PushMotions, corners: Array) -> Array:
    """Smallest distance by which a point within the outline moves, shape (n,).

    Displacements are a similar image of the outline. The smallest is its distance from the origin, or zero
    if it contains the origin, that is, if the center of the rotation is within the outline.
    """
    turn = motion.rotation[:, None]
    c, s = np.cos(turn) - 1.0, np.sin(turn)
    x, y = corners.T
    start = motion.displacement[:, None] + np.stack([c * x - s * y, s * x + c * y], axis=-1)
    edge = np.roll(start, -1, axis=1) - start
    square = (edge * edge).sum(axis=-1)
    along = np.clip(-(start * edge).sum(axis=-1) / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
    nearest_point = start + along[..., None] * edge
    distance = np.hypot(nearest_point[..., 0], nearest_point[..., 1]).min(axis=1)
    # A ray along +x from the origin crosses the image an odd number of times if it starts within it.
    below, after = start[..., 1] > 0.0, np.roll(start[..., 1], -1, axis=1) > 0.0
    height = start[..., 0] * edge[..., 1] - start[..., 1] * edge[..., 0]
    crosses = (below != after) & ((height > 0.0) == after)
    return np.where(crosses.sum(axis=1) % 2 == 1, 0.0, distance)


def _cells(outline: Outline) -> Array:
    """Centers of equal cells within an outline."""
    low, high = bounds(outline.pieces)
    width = high - low
    counts = np.maximum(np.ceil(CELLS * width / outline.size), 4).astype(int)
    x, y = (a + w * (np.arange(k) + 0.5) / k for a, w, k in zip(low, width, counts, strict=True))
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    within = points[nearest_place(outline, points).gap < 0.0]
    # A thin object may lie between the centers.
    return within if len(within) else outline.vertices()


def _refuse(
    values: Array, most: Any, numbers: Any, given: str, allowed: str, remedy: str = REMEDY
) -> None:
    """Raise the error for the first push with a larger value, and name the others."""
    limits = np.broadcast_to(most, values.shape)
    wrong = np.flatnonzero(values > limits)
    if len(wrong):
        first = wrong[0]
        raise InvalidValue(
            "pushes", f"{given.format(values[first])}, in pushes {push_numbers(numbers[wrong])}",
            allowed.format(limits[first]), remedy,
        )  # fmt: skip


def push_numbers(rows: npt.NDArray[np.intp]) -> str:
    """List of push numbers for a message, counted from 0."""
    first = ", ".join(str(int(row)) for row in rows[:LISTED])
    return first + (f" and {len(rows) - LISTED} more" if len(rows) > LISTED else "")
