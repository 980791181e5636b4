"""The pressures of several supports in one table, of which the compiled core takes one by its number."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.supports.pressure.record import Array, Pressure
from planar_pushing.terms.errors import InvalidValue

#: The pieces of a record, in the order of the columns of `Table.starts`.
PIECES = ("atoms", "segments", "rings", "discs", "plates")


class Table(NamedTuple):
    """Pressures one behind the other, each in units of its own extent.

    Attributes
    ----------
    centers : ndarray, shape (n, 2)
        Centres of pressure.
    starts : ndarray of int, shape (n + 1, 5)
        Where the pieces of each support begin, in the order of `PIECES`.
    atoms, segments, rings, discs, plates, first, edges, multipoles : ndarray
        As in `Pressure`, of all supports.
    """

    centers: Array
    starts: Any
    atoms: Array
    segments: Array
    rings: Array
    discs: Array
    plates: Array
    first: Any
    edges: Array
    multipoles: Array


def extent_of(support: Any) -> float:
    """Largest distance of a support from its centre of pressure.

    Raises
    ------
    InvalidValue
        Where the support is one point, which resists no rotation.
    """
    extent = float(support.extent)
    if extent == 0.0:
        raise InvalidValue(
            "support", support, "a support that is larger than a point",
            "a point resists no rotation: its force is opposite to its motion",
        )  # fmt: skip
    return extent


def table_of(supports: Sequence[Any]) -> Table:
    """The table of supports, whose `record` gives each one's pressure."""
    records = [support.record(extent_of(support)) for support in supports]
    counts = [[len(getattr(record, name)) for name in PIECES] for record in records]
    edges = np.cumsum([0, *(len(record.edges) for record in records)])
    first = [record.first[:-1] + start for record, start in zip(records, edges, strict=False)]
    stacked = [np.concatenate([getattr(record, name) for record in records]) for name in PIECES]
    return Table(
        np.array([[record.center_x, record.center_y] for record in records]),
        np.cumsum([[0] * len(PIECES), *counts], axis=0),
        **dict(zip(PIECES, stacked, strict=True)),
        first=np.concatenate([*first, edges[-1:]]),
        edges=np.concatenate([record.edges for record in records]),
        multipoles=np.concatenate([record.multipoles for record in records]),
    )


@compiled
def pressure_of(table, i):
    """One of the pressures."""
    start, end = table.starts[i], table.starts[i + 1]
    return Pressure(
        table.centers[i, 0], table.centers[i, 1], 1.0,
        table.atoms[start[0] : end[0]], table.segments[start[1] : end[1]],
        table.rings[start[2] : end[2]], table.discs[start[3] : end[3]],
        table.plates[start[4] : end[4]], table.first[start[4] : end[4] + 1],
        table.edges, table.multipoles[start[4] : end[4]],
    )  # fmt: skip
