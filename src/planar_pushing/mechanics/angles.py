"""Angle intervals with open or closed ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.numerics.arrays import dataset, is_labelled, named
from planar_pushing.mechanics.numerics.root import EPSILON
from planar_pushing.terms.domain import Number, is_lazy
from planar_pushing.terms.errors import InvalidValue

#: Directions closer than this (radians) are one direction: a few ulp of pi.
RESOLUTION = 8 * EPSILON


@dataclass(frozen=True, slots=True)
class AngleInterval:
    """Directions from `right` counter-clockwise to `left`, radians, unwrapped: right <= left.

    Parameters
    ----------
    right, left : float or array
        The edges as seen when looking along the interval's middle.
    closed : bool or array
        Whether the edges belong to the interval.
    """

    right: Number
    left: Number
    closed: Number = True

    def __post_init__(self) -> None:
        if not (is_lazy(self.right) or np.all(self.right <= self.left)):
            raise InvalidValue(
                "AngleInterval", (self.right, self.left), "right <= left", "unwrap the edges first"
            )

    @property
    def span(self) -> Number:
        """Angle between the edges, radians."""
        return self.left - self.right

    def contains(self, angle: npt.ArrayLike) -> npt.NDArray[np.bool_]:
        """Whether each angle, taken modulo a full turn, lies in the interval.

        An edge counts as reached within `RESOLUTION`.
        """
        middle = (self.right + self.left) / 2
        offset = np.abs(np.remainder(np.subtract(angle, middle) + np.pi, 2 * np.pi) - np.pi)
        margin = np.where(self.closed, RESOLUTION, -RESOLUTION)
        return np.asarray(offset <= self.span / 2 + margin)


def interval(right: Number, left: Number, closed: Number) -> Any:
    """An angle interval; of labelled edges a dataset with the same names, `right`, `left` and `closed`."""
    if not (is_labelled(right) or is_labelled(left)):
        return AngleInterval(right, left, closed)
    edges = {"right": right, "left": left, "closed": closed * (right == right)}
    return dataset([named(name, edge.drop_attrs()) for name, edge in edges.items()])
