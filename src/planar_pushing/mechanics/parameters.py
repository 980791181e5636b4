"""Responses of motions to each parameter of their scenes, in the user's units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.core import Entry
from planar_pushing.mechanics.effects.any_support import Supports
from planar_pushing.mechanics.numerics.arrays import Output, mapped
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.response import FIRST, FORCE, respond
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports.pressure.record import ATOMS, SEGMENTS


class Motions(NamedTuple):
    """A list of motions, in the fence frame.

    Attributes
    ----------
    twist, force : ndarray, shapes (n, 3) and (n, 2)
    edge : float or ndarray
        Angle of the force.
    condition, pivot, changes : ndarray of int, shape (n,)
        As in `respond`.
    """

    twist: Array
    force: Array
    edge: Any
    condition: Any
    pivot: Any
    changes: Any


class Response(NamedTuple):
    """Status, and derivatives of twists and forces with respect to the parameters of `respond`."""

    status: npt.NDArray[Any]
    twist: Array
    force: Array


def at_places(places: npt.NDArray[np.bool_], column: Any) -> Any:
    """The numbers of a column of problems at the places of their solutions; a scalar is left unchanged."""
    if not np.ndim(column):
        return column
    return np.broadcast_to(np.asarray(column)[..., None], places.shape)[places]


def from_places(places: npt.NDArray[np.bool_], values: Array) -> Array:
    """Values of solutions at their places; elsewhere NaN, or 0 for integers."""
    empty = np.nan if values.dtype.kind == "f" else 0
    found = np.full(places.shape + values.shape[1:], empty, values.dtype)
    found[places] = values
    return found


def responses(entries: Sequence[Entry], columns: Sequence[Any], motions: Motions) -> Response:
    """Responses of motions to each parameter.

    Parameters
    ----------
    entries : sequence of Entry
    columns : sequence of float or ndarray, shape (n,)
        Columns of the entries; length and angle of the rod, radius.
    motions : Motions
    """
    *numbers, length, angle, radius = columns
    v_x, v_y, omega = motions.twist.T
    size = np.maximum(np.hypot(v_x, v_y), np.abs(radius * omega))
    size = np.where(size > 0, size, 1.0)
    strengths, unit, numbers = _dimensionless(entries, numbers, size)
    motion, force = np.column_stack([size, size, size / radius]), np.column_stack([unit, unit])
    rows = [
        *numbers, length / radius, angle, *(motions.twist / motion).T, *(motions.force / force).T,
        *motions[2:],
    ]  # fmt: skip
    count = (("parameter", FIRST + len(entries) + _count_feet(entries)),)
    outputs = (
        Output("status", (), "i1"),
        Output("twist", (("twist_component", 3), *count)),
        Output("force", (("xy", 2), *count)),
    )
    status, by_twist, by_force = mapped(
        respond, tuple(each.kind for each in entries), rows, outputs
    )
    of = np.ones((len(size), by_twist.shape[2]))  # units of the parameters in the kernel
    of[:, 0] = np.where(motions.condition == FORCE, unit, size)
    of[:, 1], of[:, 2], of[:, 3] = size, radius, radius
    for i, strength in enumerate(strengths):
        of[:, FIRST + i] = strength
    of[:, FIRST + len(entries) :] = unit[:, None]
    by = of[:, None, :]
    return Response(status, by_twist * motion[..., None] / by, by_force * force[..., None] / by)


def _dimensionless(
    entries: Sequence[Entry], columns: Sequence[Any], size: Array
) -> tuple[list[Any], Array, list[Any]]:
    """Strengths, 1 for loads; unit of force; columns in this unit, for motions in units of `size`."""
    left, strengths, forces, found = list(columns), [], [], []
    for entry in entries:
        own = [left.pop(0) for _ in entry.forces]
        strengths.append(own[0] if len(own) == 1 else 1.0)
        scaled = [each * size ** (entry.degree - 1) for each in own]
        forces.append(np.abs(scaled[0]) if len(own) == 1 else np.hypot(scaled[0], scaled[1]))
        found.append((scaled, [left.pop(0) for _ in entry.others]))
    unit = np.max(np.broadcast_arrays(*forces, size * 0.0), axis=0)
    return strengths, unit, [
        each for scaled, others in found for each in (*(f / unit for f in scaled), *others)
    ]  # fmt: skip


def _count_feet(entries: Sequence[Entry]) -> int:
    """Number of support points, the maximum for each array of supports."""
    tables = [entry.kind.table for entry in entries if isinstance(entry.kind, Supports)]
    return sum(int((each.starts[:, SEGMENTS] - each.starts[:, ATOMS]).max()) for each in tables)


def by_effect(scene: Scene, entries: Sequence[Entry], responses: Array) -> Array:
    """Derivatives with respect to the strength of each effect of a scene; 0 for one absent from rest."""
    found = np.zeros((*responses.shape[:-1], len(scene.effects)))
    found[np.isnan(responses[..., 0])] = np.nan
    listed = scene.resisting
    for i, entry in enumerate(entries):
        found[..., listed[entry.number]] = responses[..., FIRST + i]
    return found


def shared(scene: Scene, entries: Sequence[Entry], response: Response) -> dict[str, Array]:
    """The fields that the derivatives of every problem share."""
    feet = FIRST + len(entries)
    return {
        "status": response.status,
        "twist_by_point": response.twist[..., 2:4],
        "twist_by_strength": by_effect(scene, entries, response.twist),
        "twist_by_foot": response.twist[..., feet:],
        "force_by_point": response.force[..., 2:4],
        "force_by_strength": by_effect(scene, entries, response.force),
        "force_by_foot": response.force[..., feet:],
    }
