"""The pressures of several supports in one array of numbers, in which the core finds each by its place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from planar_pushing.core.supports.piece_rows import COLUMNS, HEAD, PointRow, PressureHead
from planar_pushing.core.supports.pieces import MomentsRow, PlaceRow
from planar_pushing.core.supports.rows import EFFECT, LAST, EffectHead
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.kernels.columns import Columns, row_of
from planar_pushing.mechanics.pressure.assembly import (
    Gathered,
    gather_pieces,
    measure_support,
    stack,
)
from planar_pushing.mechanics.pressure.in_frames import gather_in_frames
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.pressure.support_in_frames import SupportInFrames
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.errors import InvalidValue

#: Rounding error of a center of pressure, relative to its coordinates.
ROUNDING = 1e-14
#: Room in front of a table for the entries of 15 effects.
FRONT = 16 * EFFECT
#: Maximum number of supports in a small tuple, and number of small tuples whose results are cached.
FEW, KEPT = 1000, 16
Found = TypeVar("Found")


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """Pressures stored one after the other, each in units of its own extent.

    Tables are compared by identity, so that results computed from them can be cached.

    Attributes
    ----------
    data : ndarray
        The heads of all pressures, the rows of their pieces, and the terms of their plates, as in
        `core.pieces`; places are relative to the beginning of this array.
    count : int
        Number of supports.
    memory : ndarray
        The data, preceded by room for the entries of a call that has no other table.
    entries : list
        The entries passed to `behind`, the first of which occupy that room.
    most_atoms : int
        Maximum number of atoms of a support.
    """

    data: Array
    count: int
    memory: Array
    entries: list[Array]
    most_atoms: int

    @property
    def head(self) -> Columns:
        """The heads by name, each of shape (count,): `PressureHead`."""
        return Columns(PressureHead, self.data[: HEAD * self.count].reshape(self.count, HEAD))

    @property
    def centers(self) -> Array:
        """Centers of pressure, shape (count, 2)."""
        centers: Array = self.head.center
        return centers

    @property
    def spreads(self) -> Array:
        """Means of x x, x y and y y from the centers of pressure, shape (count, 3)."""
        spreads: Array = self.head.spread
        return spreads

    @property
    def atom_counts(self) -> Any:
        """Numbers of atoms, shape (count,)."""
        return ((self.head.segments - self.head.atoms) / COLUMNS).astype(np.int64)

    def atoms(self, number: int) -> Array:
        """Positions and shares of the atoms of a support, shape (n, 3)."""
        first, last = int(self.head.atoms[number]), int(self.head.segments[number])
        return self.data[first:last].reshape(-1, COLUMNS)[:, : PointRow.size]

    def behind(self, entries: Array) -> Array:
        """Entries followed by the data, in the table's own memory if they equal the first entries."""
        if len(entries) > FRONT:
            return np.concatenate([entries, self.data])
        self.entries.append(entries)
        if len(self.entries) > 1 and not np.array_equal(self.entries[0], entries):
            return np.concatenate([entries, self.data])
        front = self.memory[FRONT - len(entries) :]
        front[: len(entries)] = entries
        return front


def cache_by_supports(function: Callable[[Any], Found]) -> Callable[[Iterable[Any]], Found]:
    """Cache a function of supports; for many supports, which can take gigabytes, only the last result."""
    few, many = cache_results(KEPT)(function), cache_results(1)(function)

    @wraps(function)
    def call(supports: Iterable[Any] | SupportInFrames) -> Found:
        if isinstance(supports, SupportInFrames):
            return (few if supports.size <= FEW else many)(supports)
        key = tuple(supports)
        return (few if len(key) <= FEW else many)(key)

    return call


def extents_of(supports: Iterable[Any]) -> Array:
    """Largest distances of supports from their centers of pressure.

    Raises
    ------
    InvalidValue
        If a support is a single point, which resists no rotation.
    """
    return _gather_supports(supports).extents


def extent_of(support: Any) -> float:
    """As `extents_of`, for one support."""
    return float(_gather_one(support).extents[0])


@cache_by_supports
def _gather_supports(supports: tuple[Any, ...] | SupportInFrames) -> Gathered:
    """The pieces of supports, none of which may be a single point."""
    if not isinstance(supports, SupportInFrames):
        if len(supports) == 1:
            return _gather_one(supports[0])
        group = gather_pieces([support.pieces() for support in supports])
        return _required_extents(group, supports)
    if not supports.is_rigid:
        return _gather_supports(supports.supports)
    group = gather_in_frames(supports.support.pieces(), supports.origins, supports.axes)
    return _required_extents(group, [supports.support] * supports.size)


def _gather_one(support: Any) -> Gathered:
    """The pieces of one support, as `_gather_supports`."""
    group = measure_support(support)
    (x, y), extent = group.centers[0].tolist(), float(group.extents[0])
    return group if extent > ROUNDING * (abs(x) + abs(y)) else _required_extents(group, [support])


def _required_extents(group: Gathered, supports: Sequence[Any]) -> Gathered:
    """Pieces of supports, or `InvalidValue` if a support is a single point."""
    # Rounding of the weights moves the center of pressure of a single point by a few ulp.
    points = np.flatnonzero(group.extents <= ROUNDING * np.abs(group.centers).sum(axis=1))
    if len(points):
        raise InvalidValue(
            "support", supports[points[0]], "a support with more than one point",
            "a point resists no rotation: its force is opposite to its motion",
        )  # fmt: skip
    return group


@cache_by_supports
def table_of(supports: tuple[Any, ...] | SupportInFrames) -> Table:
    """`Table` of supports, the same object while it is cached."""
    is_one = not isinstance(supports, SupportInFrames) and len(supports) == 1
    group = _gather_one(supports[0]) if is_one else _gather_supports(supports)
    return _table(group, group.extents)


def table_of_pieces(pieces: Pieces, radius: float) -> Table:
    """`Table` of one support in units of a radius other than its extent."""
    return _table(gather_pieces([pieces]), np.array([radius]))


def _table(group: Gathered, radii: Array) -> Table:
    """`Table` of supports, each in units of its own radius."""
    stacked = stack(group, radii, FRONT)
    return Table(stacked.data, len(radii), stacked.memory, [], stacked.most_atoms)


def joined_data(effects: Sequence[tuple[int, int, Table | None]], columns: int) -> Array:
    """The array that the rows of one call share: the effects, and the pressures of all supports.

    Parameters
    ----------
    effects : sequence of (int, int, Table or None)
        For each effect: its kind, its first column in a row, and for a support its table.
    columns : int
        Number of columns of all effects.

    Returns
    -------
    ndarray
        An `EffectHead` for each effect, that of the kind ``LAST`` with the number of columns, and then the
        tables. It is cached while the effects are the same, with tables compared by identity, and must not
        be written to.
    """
    key = tuple(effects)
    count = sum(table.count for _, _, table in key if table is not None)
    return (_few_joined if count <= FEW else _many_joined)(key, columns)


def _join_data(effects: tuple[tuple[int, int, Table | None], ...], columns: int) -> Array:
    entries: list[float] = []
    tables = [table for _, _, table in effects if table is not None]
    offset = EFFECT * (len(effects) + 1)
    for kind, column, table in effects:
        place = 0 if table is None else offset
        entries += row_of(EffectHead, kind=kind, column=column, table=place)
        offset += 0 if table is None else len(table.data)
    entries += row_of(EffectHead, kind=LAST, column=columns, table=0)
    front = np.array(entries, dtype=float)
    if len(tables) == 1:
        return tables[0].behind(front)
    return np.concatenate([front, *(table.data for table in tables)])


_few_joined, _many_joined = cache_results(KEPT)(_join_data), cache_results(1)(_join_data)


class Moments(NamedTuple):
    """Moments of a pressure, as in `core.pieces.Moments`, of the shape of the centers.

    Attributes
    ----------
    distance : ndarray
        D, the mean distance to the center of rotation.
    unit_x, unit_y : ndarray
        G, the mean unit vector away from it.
    torque : ndarray
        T, about the center of pressure.
    xx, xy, yy : ndarray
        Second derivatives of D.
    atom : ndarray
        Number of the atom at the center of rotation, or -1.
    """

    distance: Array
    unit_x: Array
    unit_y: Array
    torque: Array
    xx: Array
    xy: Array
    yy: Array
    atom: Array


def moments(table: Table, x: npt.ArrayLike, y: npt.ArrayLike, number: int = 0) -> Moments:
    """Moments of one pressure of a table at centers of rotation.

    Parameters
    ----------
    table : Table
    x, y : array_like
        In the body frame, in the unit of the table, up to 1e9 extents away.
    number : int, optional
        Number of the support.
    """
    columns = np.broadcast_arrays(*row_of(PlaceRow, head=float(HEAD * number), x=x, y=y))
    rows = np.stack([column.ravel() for column in columns], axis=1)
    results = run("moments", table.data, rows, MomentsRow.size)
    return Moments(*(moment.reshape(columns[0].shape)[()] for moment in results.T))
