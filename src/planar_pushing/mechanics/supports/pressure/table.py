"""The pressures of several supports in one table, from which the compiled core picks one by number."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import numpy as np

from planar_pushing.mechanics.compiled import owning
from planar_pushing.mechanics.supports.in_frames import SupportInFrames
from planar_pushing.mechanics.supports.pressure.assembly import Gathered, gathered, stacked
from planar_pushing.mechanics.supports.pressure.in_frames import gather_in_frames
from planar_pushing.mechanics.supports.pressure.record import Array, Pressure
from planar_pushing.terms.caches import cached
from planar_pushing.terms.errors import InvalidValue

#: Rounding error of a center of pressure, relative to its coordinates.
ROUNDING = 1e-14
#: Maximum number of supports in a small tuple, and number of small tuples whose results are cached.
FEW, KEPT = 1000, 16
Found = TypeVar("Found")


class Table(NamedTuple):
    """Pressures stored one after the other, each in units of its own extent.

    Attributes
    ----------
    centers : ndarray, shape (n, 2)
        Centers of pressure.
    spreads : ndarray, shape (n, 3)
        As `spread` in `Pressure`.
    starts : ndarray of int, shape (n, 7)
        First rows of the pieces of each support, as in `Pressure`, and number of its first multipoles.
    rows, multipoles : ndarray
        As in `Pressure`, for all supports.
    """

    centers: Array
    spreads: Array
    starts: Any
    rows: Array
    multipoles: Array


def kept(function: Callable[[Any], Found]) -> Callable[[Iterable[Any]], Found]:
    """Cache a function of supports; for many supports, which can take gigabytes, the last result only."""
    few, many = cached(KEPT)(function), cached(1)(function)

    @wraps(function)
    def found(supports: Iterable[Any] | SupportInFrames) -> Found:
        if isinstance(supports, SupportInFrames):
            return (few if supports.size <= FEW else many)(supports)
        each = tuple(supports)
        return (few if len(each) <= FEW else many)(each)

    return found


def extents_of(supports: Iterable[Any]) -> Array:
    """Largest distances of supports from their centers of pressure.

    Raises
    ------
    InvalidValue
        If a support is a single point, which resists no rotation.
    """
    return _gathered(supports).extents


def extent_of(support: Any) -> float:
    """As `extents_of`, for one support."""
    return float(extents_of([support])[0])


@kept
def _gathered(supports: tuple[Any, ...] | SupportInFrames) -> Gathered:
    """The pieces of supports, none of which may be a single point."""
    if not isinstance(supports, SupportInFrames):
        return _required_extents(gathered([each.pieces() for each in supports]), supports)
    if not supports.is_rigid:
        return _gathered(supports.supports)
    found = gather_in_frames(supports.support.pieces(), supports.origins, supports.axes)
    return _required_extents(found, [supports.support] * supports.size)


def _required_extents(found: Gathered, supports: Sequence[Any]) -> Gathered:
    """Pieces of supports, or `InvalidValue` if a support is a single point."""
    # Rounding of the weights moves the center of pressure of a single point by a few ulp.
    points = np.flatnonzero(found.extents <= ROUNDING * np.abs(found.centers).sum(axis=1))
    if len(points):
        raise InvalidValue(
            "support", supports[points[0]], "a support with more than one point",
            "a point resists no rotation: its force is opposite to its motion",
        )  # fmt: skip
    return found


@kept
def table_of(supports: tuple[Any, ...] | SupportInFrames) -> Table:
    """`Table` of supports."""
    found = _gathered(supports)
    starts, rows, multipoles = stacked(found, found.extents)
    size = found.extents[:, None]
    return Table(found.centers / size, found.spreads / size**2, starts, rows, multipoles)


@owning
def pressure_of(table, i):
    """The i-th pressure of a table."""
    x, y, at = table.centers[i, 0], table.centers[i, 1], table.starts[i]
    spread = table.spreads[i, 0], table.spreads[i, 1], table.spreads[i, 2]
    starts = at[0], at[1], at[2], at[3], at[4], at[5]
    return Pressure(x, y, 1.0, spread, starts, at[6], table.rows, table.multipoles)
