"""A measured pressure, uniform in each cell of a grid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from planar_pushing.mechanics.plane import Frame, position_in_frame
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.supports.base import (
    POSITION,
    InPieces,
    Position,
    array,
    coordinates,
    require_all,
    require_size,
)
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.declared import NUMBER, Read, replace_checked, require_declared
from planar_pushing.terms.errors import InvalidValue, number_of

#: Cells along a side of a block; a distant block is evaluated by one series.
BLOCK = 4
#: Number of maps whose blocks are kept.
KEPT = 16
#: Largest deviation of the squared length of a unit vector from 1: rounding of its two components.
UNIT = 1e-12


def _edges(name: str, value: object) -> tuple[float, ...]:
    """Edges of cells along an axis."""
    remedy = "give the edges of the cells in increasing order"
    edges = coordinates(name, value, (None,), "a sequence of finite numbers", remedy)
    if len(edges) < 2 or not (np.diff(edges) > 0).all():
        raise InvalidValue(name, edges.tolist(), "at least two increasing numbers", remedy)
    require_size(name, float(np.diff(edges).min()))
    return tuple(edges.tolist())


def _cells(name: str, value: object) -> tuple[tuple[float, ...], ...]:
    """Pressures of cells."""
    allowed, remedy = "rows of finite numbers", "give a row of pressures for each interval of y"
    cells = array(name, value, (None, None), allowed, remedy)
    require_all(name, cells, lambda p: p >= 0, "a number >= 0", "a support cannot pull; clip noise")
    if not cells.any():
        raise InvalidValue(name, 0.0, "at least one number > 0", "leave out empty maps")
    return tuple(map(tuple, cells.tolist()))


def _unit(name: str, value: object) -> Position:
    """A unit vector."""
    x, y = POSITION.require(name, value)
    if abs(x**2 + y**2 - 1.0) > UNIT:
        raise InvalidValue(name, (x, y), "a unit vector", "divide it by its length")
    return x, y


EDGES = Read(
    _edges, "at least two increasing numbers", {"type": "array", "minItems": 2, "items": NUMBER}
)
CELLS = Read(
    _cells, "a row of numbers >= 0 for each interval of y",
    {"type": "array", "items": {"type": "array", "items": NUMBER | {"minimum": 0}}},
)  # fmt: skip
AXIS = Read(_unit, "a unit vector", POSITION.schema)


@dataclass(frozen=True, slots=True)
class PressureMap(InPieces):
    """Support on a grid of rectangular cells, with uniform pressure in each.

    Parameters
    ----------
    x, y : sequence of float
        Edges of the cells, increasing: one more than the columns and rows.
    pressure : array_like, shape (len(y) - 1, len(x) - 1)
        Pressure in each cell, >= 0 and not all zero, in any unit; ``pressure[j][i]`` is the cell from
        ``x[i]`` to ``x[i + 1]`` and from ``y[j]`` to ``y[j + 1]``.
    origin, axis : pair of float, optional
        Position of the origin of x and y in the body frame, and direction of x there; by default x and y
        are those of the body frame.

    Raises
    ------
    InvalidValue
        If edges do not increase, a number is not finite, the map does not fit its axes, a pressure is
        negative, or all pressures are zero.
    """

    x: Annotated[Any, EDGES]
    y: Annotated[Any, EDGES]
    pressure: Annotated[Any, CELLS]
    origin: Annotated[Any, POSITION] = None
    axis: Annotated[Any, AXIS] = None

    def __post_init__(self) -> None:
        require_declared(self)
        shape = len(self.y) - 1, len(self.x) - 1
        if np.shape(self.pressure) != shape:
            raise InvalidValue(
                "pressure", self.pressure,
                f"{number_of(shape[0], 'row')} of {number_of(shape[1], 'number')}, to fit y and x",
                "give the edges of the cells in x and y, one more than columns and rows",
            )  # fmt: skip

    @property
    def frame(self) -> Frame:
        """The frame of x and y in the body frame."""
        return Frame(self.origin or (0.0, 0.0), self.axis or (1.0, 0.0))

    def in_frame(self, frame: Frame) -> PressureMap:
        """The same map expressed in another frame."""
        map_frame = self.frame
        x, y = frame.vector_in(map_frame.axis).tolist()
        return replace_checked(
            self, origin=position_in_frame(map_frame.origin, frame), axis=(x + 0.0, y + 0.0)
        )

    def pieces(self) -> Pieces:
        edges, lengths = _blocks(self.x, self.y, self.pressure)
        is_moved = self.origin is not None or self.axis is not None
        edges = _edges_in_parent(edges, self.frame) if is_moved else edges.copy()
        return Pieces(plates=tuple(np.split(edges, lengths)))


@cache_results(KEPT)
def _blocks(
    x_edges: tuple[float, ...], y_edges: tuple[float, ...], pressure: tuple[tuple[float, ...], ...]
) -> tuple[Array, list[int]]:
    """Edges of all blocks of cells, and the numbers at which those of the second and later blocks begin.

    They are in the frame of the map, so that they are found once for all contacts of an object.
    """
    x, y, cells = np.array(x_edges), np.array(y_edges), np.array(pressure)
    loads = cells / cells.max()
    loads /= np.diff(y) @ loads @ np.diff(x)
    plates = [
        _block(x[i : i + BLOCK + 1], y[j : j + BLOCK + 1], loads[j : j + BLOCK, i : i + BLOCK])
        for j in range(0, len(y) - 1, BLOCK)
        for i in range(0, len(x) - 1, BLOCK)
        if loads[j : j + BLOCK, i : i + BLOCK].any()
    ]
    return np.concatenate(plates), np.cumsum([len(plate) for plate in plates[:-1]]).tolist()


def pressed_area(measured: PressureMap) -> Pieces:
    """The area of a map that has pressure, as one plate with the same pressure everywhere."""
    cells = np.array(measured.pressure) > 0.0
    plate = _block(np.array(measured.x), np.array(measured.y), cells.astype(float))
    if measured.origin is not None or measured.axis is not None:
        plate = _edges_in_parent(plate, measured.frame)
    return Pieces(plates=(plate,))


def _edges_in_parent(plate: Array, frame: Frame) -> Array:
    """Edges transformed from a frame to its parent frame."""
    ends = frame.point_out(plate[:, :4].reshape(-1, 2)).reshape(-1, 4)
    return np.column_stack([ends, plate[:, 4]])


def _block(x: Array, y: Array, cells: Array) -> Array:
    """Lines of a grid across which the pressure jumps: x and y of both ends, and the jump."""
    upward = -np.diff(cells, axis=1, prepend=0, append=0)
    across = np.diff(cells, axis=0, prepend=0, append=0)
    j, i = np.nonzero(upward)
    vertical = np.column_stack([x[i], y[j], x[i], y[j + 1], upward[j, i]])
    j, i = np.nonzero(across)
    level = np.column_stack([x[i], y[j], x[i + 1], y[j], across[j, i]])
    return np.concatenate([vertical, level])
