"""Angle intervals with open or closed ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.core.supports.tolerances import RESOLUTION as RESOLUTION
from planar_pushing.mechanics.kernels.arrays import dataset, is_labeled, label_result, same
from planar_pushing.terms.domain import RADIANS, TO_RADIANS, TURNS, require_in_range
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Number, as_numbers, is_lazy
from planar_pushing.terms.options import Status


@dataclass(frozen=True, slots=True)
class AngleInterval:
    """Directions from `right` counterclockwise to `left`, radians, unwrapped: right <= left.

    ``angle in interval`` tests one direction, and `contains` an array of directions.

    Parameters
    ----------
    right, left : float or array
        The edges in radians, as seen when looking along the interval's middle.
    closed : bool or array
        Whether the edges belong to the interval.
    status : int or array, optional
        For a motion cone, values of `Status`.
    """

    right: Number
    left: Number
    closed: Number = True
    status: Number = int(Status.CONSISTENT)

    def __post_init__(self) -> None:
        edges = self.right, self.left
        for name in ("right", "left"):
            object.__setattr__(self, name, _edge(getattr(self, name), edges))
        if not (
            is_lazy(self.right)
            or np.all((self.right <= self.left) | (np.asarray(self.status) == Status.UNSOLVED))
        ):
            raise InvalidValue("AngleInterval", edges, "right <= left", "unwrap the edges first")

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def __contains__(self, angle: object) -> bool:
        inside = self.contains(require_in_range("angle", angle))
        if inside.ndim:
            raise InvalidValue(
                "angle", angle, "one angle, and one interval", "call contains for more"
            )
        return bool(inside)

    @property
    def degrees(self) -> tuple[Number, Number]:
        """The edges `right` and `left` in degrees."""
        return _in_degrees(self.right), _in_degrees(self.left)

    @property
    def span(self) -> Number:
        """Angle between the edges, radians."""
        return self.left - self.right

    def contains(self, angle: npt.ArrayLike) -> npt.NDArray[np.bool_]:
        """Whether each direction lies in the interval; edges are resolved to `RESOLUTION`.

        Parameters
        ----------
        angle : float or array
            Radians, taken modulo 2 pi.
        """
        middle = (self.right + self.left) / 2
        off = np.subtract(require_in_range("angle", angle), middle)
        offset = np.abs(np.remainder(off + np.pi, 2 * np.pi) - np.pi)
        margin = np.where(self.closed, RESOLUTION, -RESOLUTION)
        return np.asarray(offset <= self.span / 2 + margin)


def _edge(value: Any, edges: tuple[Any, Any]) -> Number:
    """An edge in double precision, NaN where there is no interval."""
    edge = value if is_lazy(value) else as_numbers(value)
    if edge is None:
        raise InvalidValue("AngleInterval", edges, "numbers of radians", "give both edges")
    if not is_lazy(edge) and (np.abs(edge) > TURNS).any():
        raise InvalidValue("AngleInterval", edges, RADIANS, TO_RADIANS)
    return edge


def _in_degrees(edge: Number) -> Number:
    degrees = np.rad2deg(edge)
    return degrees if np.ndim(degrees) else float(degrees)


def interval(
    right: Number, left: Number, closed: Number, status: Number = int(Status.CONSISTENT)
) -> Any:
    """Angle interval; for labeled edges, a dataset with the variables `right`, `left` and `closed`."""
    if not (is_labeled(right) or is_labeled(left)):
        return AngleInterval(right, left, closed, status)
    edges = {"right": right, "left": left, "closed": closed * (right == right)}
    if is_labeled(status):
        edges["status"] = status
    return dataset([label_result(name, edge.drop_attrs()) for name, edge in edges.items()])
