"""One contact of an object, or an array of contacts, converted to flat arrays and back."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.kernels.arrays import broadcast_numbers, is_labeled
from planar_pushing.mechanics.plane import Array, Placement, labeled_like
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import require_array

#: What a point or a normal must be, and the remedy.
PAIR = "two finite numbers", "give x and y in the object's frame"


class Contacts(NamedTuple):
    """Contacts of an object; their shape S is () for a single one.

    Attributes
    ----------
    placement : Placement
        Of numbers, or of arrays of shape S with the labels of the points; normals along +y if none are
        given.
    point, normal : array_like, shape S + (2,)
        As given, for messages; the normal can be None.
    """

    placement: Placement
    point: Any
    normal: Any

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape S."""
        return np.shape(self.placement.point[0])

    @property
    def points(self) -> Array:
        """Points, shape (n, 2)."""
        return _flat(self.placement.point)

    @property
    def normals(self) -> Array:
        """Unit normals, shape (n, 2)."""
        return _flat(self.placement.normal)

    def original(self, name: str, i: int) -> Any:
        """The i-th point or normal, as given."""
        value = getattr(self, name)
        return value if not self.shape else np.reshape(value, (-1, 2))[i]

    def number(self, values: Array) -> Number:
        """A number of a single contact, or an array of shape S, from a flat array."""
        x = self.placement.point[0]
        if type(x) is float:
            return float(values[0])
        return labeled_like(x, values.reshape(self.shape)) if self.shape else float(values[0])

    def pair(self, vectors: Array) -> tuple[Number, Number]:
        """As `number`, for both components of vectors of shape (n, 2)."""
        return self.number(vectors[:, 0]), self.number(vectors[:, 1])

    def repeat(self, *numbers: Number) -> tuple[Contacts, list[Number]]:
        """The contacts and numbers, broadcast against one another, labeled arrays by name."""
        x, y, n_x, n_y, *values = broadcast_numbers(
            *self.placement.point, *self.placement.normal, *numbers
        )
        return Contacts(Placement((x, y), (n_x, n_y)), self.point, self.normal), values


def require_contacts(point: Any, normal: Any) -> Contacts:
    """Contacts at points of shape S + (2,), with one normal or normals of this shape.

    Raises
    ------
    InvalidValue
        If a shape differs, a number is not finite, or a normal is zero.
    """
    one, inward = _plain_pair(point), (0.0, 1.0) if normal is None else _plain_pair(normal)
    if one is not None and inward is not None:
        return Contacts(Placement(one, inward), point, normal)
    points = require_array("point", point, *PAIR)
    if points.ndim > 1 and (points.shape[-1] != 2 or not points.size):
        raise InvalidValue(
            "point", points.shape, "shape S + (2,)", "give x and y along the last axis"
        )
    if normal is not None:
        normal = _required_normal(normal, points)
    upright = (0.0, 1.0) if normal is None else normal
    if points.ndim > 1:
        every = np.broadcast_to(upright, points.shape)
        return Contacts(_placements(points, every, point), point, normal)
    return Contacts(Placement(point, upright), point, normal)


def _plain_pair(value: Any) -> tuple[float, float] | None:
    """Two floats, as most points and normals of one contact are given; None for anything else."""
    if type(value) is np.ndarray and value.shape == (2,) and value.dtype == np.float64:
        value = value.tolist()
    if type(value) not in (tuple, list) or len(value) != 2:
        return None
    x, y = value
    return (x, y) if type(x) is type(y) is float else None


def _required_normal(value: Any, points: Array) -> Any:
    """The normal of a single contact as given, or normals of the shape of many points."""
    vectors = require_array("normal", value, *PAIR)
    if points.ndim <= 1:
        if vectors.shape != (2,):
            raise InvalidValue("normal", value, *PAIR)
        return value
    try:
        return np.broadcast_to(vectors, points.shape)
    except ValueError:
        remedy = "give one vector, or one for each point"
        raise InvalidValue(
            "normal", vectors.shape, f"shape (2,) or {points.shape}", remedy
        ) from None


def _placements(points: Array, normals: Array, labeled_points: Any) -> Placement:
    """Placements at points of shape S + (2,); errors as in `Placement`, for the first that is refused."""
    try:
        return Placement(
            _label_components(points, labeled_points), _label_components(normals, labeled_points)
        )
    except InvalidValue:
        for point, normal in zip(points.reshape(-1, 2), normals.reshape(-1, 2), strict=True):
            Placement(tuple(point.tolist()), tuple(normal.tolist()))
        raise


def _label_components(vectors: Array, points: Any) -> tuple[Number, Number]:
    """Components of vectors, over the dimensions of the points if these are labeled."""
    x, y = vectors[..., 0], vectors[..., 1]
    if not is_labeled(points):
        return x, y
    import xarray as xr

    *dims, last = points.dims
    coords = {
        name: coordinate
        for name, coordinate in points.coords.items()
        if last not in coordinate.dims
    }
    return xr.DataArray(x, coords, dims), xr.DataArray(y, coords, dims)


def _flat(pair: tuple[Number, Number]) -> Array:
    """Pairs of numbers, shape (n, 2)."""
    return np.array([np.ravel(component) for component in pair]).T
