"""Responses of motions to each parameter of their scenes, in the user's units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.core.instant.sensitivity import FIRST, FORCE_CASE, ResponseRow
from planar_pushing.mechanics.kernels.arrays import Output, map_kernel
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import EffectColumns, Rows, in_units, strengths_of
from planar_pushing.mechanics.scene import Scene

#: A motion of this size or less counts as about to change, because derivatives of its force overflow.
SMALLEST = 1e-290


class Motions(NamedTuple):
    """A list of motions, in the fence frame.

    Attributes
    ----------
    twist, force : ndarray, shapes (n, 3) and (n, 2)
    edge : float or ndarray
        Angle of the force.
    condition, pivot, changes : ndarray of int, shape (n,)
        As in `responses` of the core.
    place : float or ndarray
        Position of the contact along the fence, from the end of the rod.
    held : bool or ndarray
        Whether a side stays on the fence.
    """

    twist: Array
    force: Array
    edge: Any
    condition: Any
    pivot: Any
    changes: Any
    place: Any = 0.0
    held: Any = False


class Response(NamedTuple):
    """Status, and derivatives of twists and forces with respect to the parameters of `responses`."""

    status: npt.NDArray[Any]
    twist: Array
    force: Array


def at_places(places: npt.NDArray[np.bool_], column: Any) -> Any:
    """The numbers of a column of problems at the places of their solutions; a scalar is left unchanged."""
    if isinstance(column, (float, int)) or not np.ndim(column):
        return column
    return np.broadcast_to(np.asarray(column)[..., None], places.shape)[places]


def from_places(places: npt.NDArray[np.bool_], values: Array) -> Array:
    """Values of solutions at their places; elsewhere NaN, or 0 for integers."""
    empty = np.nan if values.dtype.kind == "f" else 0
    spread = np.full(places.shape + values.shape[1:], empty, values.dtype)
    spread[places] = values
    return spread


def responses(rows: Rows, columns: Sequence[Any], motions: Motions) -> Response:
    """Responses of motions to each parameter.

    Parameters
    ----------
    rows : Rows
    columns : sequence of float or ndarray, shape (n,)
        Columns of the effects; length of the rod in radii, its angle, and the radius.
    motions : Motions
    """
    *numbers, length, angle, radius = columns
    v_x, v_y, omega = motions.twist.T
    size = np.maximum(np.hypot(v_x, v_y), np.abs(radius * omega))
    changes = np.asarray(motions.changes) | ((size > 0.0) & (size <= SMALLEST))
    size = np.where(size > SMALLEST, size, 1.0)
    strengths = strengths_of(rows.entries, numbers)
    unit, scaled = in_units(rows.entries, numbers, strengths, size)
    unit = np.broadcast_to(unit, size.shape)
    motion, force = np.column_stack([size, size, size / radius]), np.column_stack([unit, unit])
    scaled += row_of(
        ResponseRow, length=length, angle=angle,
        twist=[*(motions.twist / motion).T], force=[*(motions.force / force).T],
        edge=motions.edge, condition=motions.condition, pivot=motions.pivot, changes=changes,
        place=motions.place / radius, held=motions.held,
    )  # fmt: skip
    count = (("parameter", FIRST + len(rows.entries) + _count_feet(rows.entries)),)
    outputs = (
        Output("status", (), "i1"),
        Output("twist", (("twist_component", 3), *count)),
        Output("force", (("xy", 2), *count)),
    )
    status, by_twist, by_force = map_kernel("responses", rows.data, scaled, outputs)
    of = np.ones((len(size), by_twist.shape[2]))  # units of the parameters in the kernel
    of[:, 0] = np.where(motions.condition == FORCE_CASE, unit, size)
    of[:, 1], of[:, 2], of[:, 3] = size, radius, radius
    for i, (entry, strength) in enumerate(zip(rows.entries, strengths, strict=True)):
        of[:, FIRST + i] = strength if entry.resists else 1.0
    of[:, FIRST + len(rows.entries) :] = unit[:, None]
    by = of[:, None, :]
    return Response(status, by_twist * motion[..., None] / by, by_force * force[..., None] / by)


def _count_feet(entries: Sequence[EffectColumns]) -> int:
    """Number of support points; for an array of supports, the maximum."""
    return sum(entry.table.most_atoms for entry in entries if entry.table is not None)


def by_effect(scene: Scene, responses: Array) -> Array:
    """Derivatives with respect to the strength of each effect; 0 for one that does not act from rest."""
    derivatives = np.zeros((*responses.shape[:-1], len(scene.effects)))
    derivatives[np.isnan(responses[..., 0])] = np.nan
    for i, entry in enumerate(scene.rows.entries):
        derivatives[..., entry.number] = responses[..., FIRST + i]
    return derivatives


def common_fields(scene: Scene, response: Response) -> dict[str, Array]:
    """The fields that `Derivatives` and `ForceDerivatives` have in common."""
    feet = FIRST + len(scene.rows.entries)
    return {
        "status": response.status,
        "twist_by_point": response.twist[..., 2:4],
        "twist_by_strength": by_effect(scene, response.twist),
        "twist_by_foot": response.twist[..., feet:],
        "force_by_point": response.force[..., 2:4],
        "force_by_strength": by_effect(scene, response.force),
        "force_by_foot": response.force[..., feet:],
    }
