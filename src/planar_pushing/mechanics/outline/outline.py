"""The outline of an object: a closed chain of sides, arcs and corners, with chains of its own for holes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from planar_pushing.mechanics.outline.chains import (
    OWN,
    RHO,
    Piece,
    circle,
    move_chain,
    number_chains,
    polygon_chain,
    require_chains,
    reverse_chain,
    sample_chain,
    split_chains,
)
from planar_pushing.mechanics.outline.drawing import DRAWN, KEPT, Corners, read_drawing
from planar_pushing.mechanics.outline.makers import (
    CROSSING,
    bulge_pieces,
    bulges_of_chain,
    ellipse_pieces,
    has_faint_pieces,
    rounded_chain,
)
from planar_pushing.mechanics.outline.plate import Plate, bounds, plate_of
from planar_pushing.mechanics.plane import Frame, positions_in_frame
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array, as_array

#: What an outline can be made of.
ALLOWED = "the corners of a simple polygon, a Polygon, a Disc, an Outline, or a polygon of shapely"
REMEDY = "give [(x, y), ...] in order, pp.Disc(radius), pp.rounded(corners, radius) or Outline.from_bulges"
#: Default deviation of a polygon from the outline, in sizes of the outline.
DEVIATION = 1e-3


class Outline:
    """The outline of an object: sides, arcs and corners, with the object on the left.

    Parameters
    ----------
    shape : sequence of pairs, Polygon, Disc, Outline, or an object with `coords` or `exterior`
        Corners in order, exact to a millionth of the outline's size: a vertex that close to the one before,
        or to a straight side, is no corner, and corners that close to the line of a side of the convex hull
        are on it. `Polygon` and polygons of shapely can have holes.
    holes : sequence of the same, optional
        Outlines of holes, besides those that the shape has itself.

    Attributes
    ----------
    pieces : ndarray, shape (n, 9), read-only
        One row a piece, with the columns x, y (start of a side, center of an arc, or the corner), rho
        (radius of curvature: infinite on a side, 0 at a corner, negative for a hollow arc), beta0, beta1
        (direction of the tangent at start and end, radians, cumulative along the chain), length, start (arc
        length along the chain), next and before (rows of the neighbors). The exterior is counterclockwise
        and comes first; each hole is a clockwise chain of its own. A polygon has two rows a corner: side k,
        then the corner at its end. A disc has one row.

    Raises
    ------
    InvalidValue
        If the shape is not a simple polygon or one of the other kinds, or a hole is not inside of it.

    Examples
    --------
    >>> import planar_pushing as pp
    >>> mug = pp.Outline(pp.Disc(0.04))
    >>> mug.size
    0.08
    >>> len(pp.rounded([(0, 0), (2, 0), (2, 1), (0, 1)], 0.1).pieces)
    8
    """

    __slots__ = ("_hash", "_kept", "pieces")

    pieces: Array

    def __init__(self, shape: Any, holes: Sequence[Any] = ()) -> None:
        outline = require_outline(shape, "shape")
        inner = [
            require_outline(hole, f"holes[{i}]") for i, hole in enumerate(_require_list(holes))
        ]
        self._set((_with_holes(outline, inner) if inner else outline).pieces)

    def _set(self, pieces: Array) -> None:
        # Equal outlines have equal bytes: no zero is negative.
        rows = np.array(pieces, dtype=float) + 0.0
        rows.flags.writeable = False
        for name, value in (("pieces", rows), ("_hash", hash(rows.tobytes())), ("_kept", {})):
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"an Outline is frozen; make another one instead of setting {name}")

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, Outline) and np.array_equal(self.pieces, other.pieces)

    def __hash__(self) -> int:
        return int(self._hash)

    def __reduce__(self) -> tuple[Callable[[Array], Outline], tuple[Array]]:
        return outline_of_pieces, (self.pieces,)

    def __repr__(self) -> str:
        """An expression that rebuilds the outline."""
        corners = self.corners
        if corners is not None and require_outline(list(corners)) == self:
            return f"Outline([{', '.join(map(str, corners))}])"
        if len(self.pieces) == 1:
            x, y, rho = self.pieces[0, :3].tolist()
            return f"Outline(Disc(radius={rho}, center=({x}, {y})))"
        rows = (", ".join(map(_number, row)) for row in self.pieces.tolist())
        return f"Outline.from_pieces([{', '.join(f'({row})' for row in rows)}])"

    @classmethod
    def from_pieces(cls, pieces: Any) -> Outline:
        """An outline from its rows, as `pieces` has them.

        Pieces that are none are left out: corners without a turn, sides and arcs without length, and the
        places at which a side, an arc or a circle is divided.

        Raises
        ------
        InvalidValue
            If the rows do not make closed chains whose points and directions join, or if chains with
            pieces that are left out cross themselves or one another.
        """
        rows = as_array(pieces)
        if rows is None or rows.ndim != 2 or rows.shape[1] != len(Piece._fields) or not len(rows):
            raise InvalidValue(
                "pieces", pieces, f"rows of {len(Piece._fields)} numbers: {', '.join(Piece._fields)}",
                "copy them from Outline.pieces",
            )  # fmt: skip
        require_chains(rows)
        return _without_needless(rows)

    @classmethod
    def from_bulges(cls, vertices: Any) -> Outline:
        """An outline of straight lines and arcs, as polylines of DXF files describe it.

        Parameters
        ----------
        vertices : sequence of (x, y, bulge)
            A bulge is the tangent of a quarter of the angle of the arc from its vertex to the next one,
            positive counterclockwise; 0 is a straight line, and 1 is half a circle.

        Raises
        ------
        InvalidValue
            If there are fewer than two vertices, a number is not finite, or the outline crosses itself.

        Examples
        --------
        >>> import planar_pushing as pp
        >>> slot = pp.Outline.from_bulges([(0, 0, 0), (2, 0, 1), (2, 1, 0), (0, 1, 1)])
        >>> round(slot.area, 6)
        2.785398
        """
        return outline_of_pieces(bulge_pieces(vertices))

    @classmethod
    def ellipse(cls, a: float, b: float, arcs: int = 256) -> Outline:
        """An ellipse about the origin with the half axes a along x and b along y, as a chain of arcs.

        Parameters
        ----------
        a, b : float
            Greater than 0, and at most a hundred times one another.
        arcs : int
            Even, from 8 to 1024. The error falls with the square of the number.

        Raises
        ------
        InvalidValue
            If a parameter is out of range.
        """
        return outline_of_pieces(ellipse_pieces(a, b, arcs))

    def _keep(self, name: str, compute: Callable[[], Any]) -> Any:
        """A property that is computed once."""
        if name not in self._kept:
            self._kept[name] = compute()
        return self._kept[name]

    _kept: dict[str, Any]
    _hash: int

    @property
    def corners(self) -> Corners | None:
        """The corners of a polygon without holes, counterclockwise; None for any other outline."""
        return self._keep("corners", self._corners)  # type: ignore[no-any-return]

    def _corners(self) -> Corners | None:
        is_polygon = self.exterior is self and not self.has_arcs
        return Corners.of(self.pieces[0::2, :2]) if is_polygon else None

    @property
    def has_arcs(self) -> bool:
        """Whether the outline has arcs."""
        rho = self.pieces[:, RHO]
        return bool((np.isfinite(rho) & (rho != 0.0)).any())

    @property
    def exterior(self) -> Outline:
        """The outline without holes."""
        return self._keep("exterior", self._exterior)  # type: ignore[no-any-return]

    def _exterior(self) -> Outline:
        chains = split_chains(self.pieces)
        return self if len(chains) == 1 else outline_of_pieces(chains[0])

    @property
    def size(self) -> float:
        """Largest extent along x or y."""
        return self._keep("size", self._size)  # type: ignore[no-any-return]

    def _size(self) -> float:
        low, high = bounds(self.pieces)
        return float((high - low).max())

    @property
    def tolerance(self) -> float:
        """Distance up to which two places are the same: a millionth of the size."""
        return DRAWN * self.size

    @property
    def _plate(self) -> Plate:
        return self._keep("plate", lambda: plate_of(self.pieces))  # type: ignore[no-any-return]

    @property
    def area(self) -> float:
        """Area, without the holes."""
        return self._plate.area

    @property
    def centroid(self) -> tuple[float, float]:
        """Center of the area."""
        return self._plate.centroid

    @property
    def moments(self) -> tuple[float, float, float]:
        """Second moments of the area about the centroid: of x x, x y and y y."""
        return self._plate.moments

    @property
    def gyration_radius(self) -> float:
        """Radius of gyration of a uniform plate about its centroid."""
        return self._plate.gyration_radius

    def vertices(self, tolerance: float | None = None) -> Array:
        """A polygon that stands for the exterior, with its vertices on the outline.

        Parameters
        ----------
        tolerance : float, optional
            Largest distance of the outline from the polygon; by default a thousandth of the size.

        Returns
        -------
        ndarray, shape (n, 2)
            The corners alone if the outline has no arcs.
        """
        deviation = DEVIATION * self.size if tolerance is None else tolerance
        if not (isinstance(deviation, (int, float)) and 0.0 < deviation < math.inf):
            raise InvalidValue(
                "tolerance", tolerance, "a number > 0", "give a length, or leave it out"
            )
        return sample_chain(split_chains(self.pieces)[0], deviation)

    def in_frame(self, frame: Frame) -> Outline:
        """The same outline expressed in another frame."""
        return _outline_in_frame(self, frame)


def rounded(outline: Any, radius: Any) -> Outline:
    """An outline of straight sides whose corners are rounded.

    Parameters
    ----------
    outline : sequence of pairs, Polygon, Outline, or an object with `coords` or `exterior`
        Corners in order, as in `Outline`. Holes stay as they are.
    radius : float or sequence of float
        One radius rounds all outer corners, and inner corners stay. With one radius for each vertex, in the
        order given, an inner corner gets a hollow fillet of its radius; 0 leaves a corner as it is.

    Returns
    -------
    Outline
        With an arc tangent to both sides at each rounded corner.

    Raises
    ------
    InvalidValue
        If the outline has arcs, a radius is negative, there are neither one radius nor as many as vertices,
        or the arcs are longer than a side.

    Examples
    --------
    >>> import planar_pushing as pp
    >>> box = pp.rounded([(-1, -1), (1, -1), (1, 1), (-1, 1)], 0.1)
    >>> round(box.area, 6)
    3.991416
    >>> len(pp.rounded([(-1, -1), (1, -1), (1, 1), (-1, 1)], 1.0).pieces)
    1
    """
    drawing = read_drawing(require_corners(outline) if isinstance(outline, Outline) else outline)
    drawn = require_outline(outline)
    exterior = rounded_chain(drawing, radius, drawn.tolerance)
    holes = [chain[:, :OWN] for chain in split_chains(drawn.pieces)[1:]]
    return outline_of_pieces(number_chains([exterior, *holes]))


def _number(value: float) -> str:
    """A number as an expression."""
    return 'float("inf")' if value == math.inf else repr(value)


def outline_of_pieces(pieces: Array) -> Outline:
    """An outline of rows that are known to be chains."""
    outline: Outline = object.__new__(Outline)
    outline._set(pieces)
    return outline


def require_outline(value: Any, name: str = "outline") -> Outline:
    """The outline that a value describes, which is read once.

    Raises
    ------
    InvalidValue
        If the value is not a simple polygon, a disc or an outline.
    """
    if isinstance(value, Outline):
        return value
    if isinstance(value, Corners):
        return outline_of_corners(value)
    if isinstance(value, Disc):
        return _of_disc(value)
    _require_kind(value, name)
    interiors = _interiors(value)
    corners = read_drawing(value, name).corners
    if interiors:
        return _of_rings(corners, interiors)
    return outline_of_corners(corners)


def require_corners(value: Any, name: str = "outline") -> Corners:
    """The corners of the exterior of an outline of straight sides; errors as in `require_outline`."""
    if isinstance(value, Corners):
        return value
    return straight_corners(require_outline(value, name), name)


def straight_corners(outline: Outline, name: str = "outline") -> Corners:
    """The corners of the exterior of an outline, or `InvalidValue` if it has arcs."""
    corners = outline.exterior.corners
    if corners is None:
        raise InvalidValue(
            name, "an outline with arcs", "one of straight sides here",
            "give the corners of a polygon, for instance outline.vertices(tolerance)",
        )  # fmt: skip
    return corners


def _require_kind(value: Any, name: str) -> None:
    """Refuse supports that have no outline, and numbers."""
    is_support = hasattr(value, "pieces") and not hasattr(value, "vertices")
    if value is None or isinstance(value, (int, float)) or is_support:
        raise InvalidValue(name, value, ALLOWED, REMEDY)


def _interiors(value: Any) -> tuple[Any, ...]:
    """Rings of the holes that a polygon has itself."""
    return tuple(getattr(value, "interiors", getattr(value, "holes", ())))


@cache_results(KEPT)
def outline_of_corners(corners: Corners) -> Outline:
    """The outline of the corners of a simple polygon."""
    return outline_of_pieces(number_chains([polygon_chain(np.array(corners))]))


@cache_results(KEPT)
def _of_disc(disc: Disc) -> Outline:
    return outline_of_pieces(
        number_chains([circle(float(disc.center[0]), float(disc.center[1]), disc.radius)])
    )


def _of_rings(corners: Corners, holes: Sequence[Any]) -> Outline:
    """A polygon with holes."""
    rings = [read_drawing(hole, f"holes[{i}]").corners for i, hole in enumerate(holes)]
    return _with_holes(outline_of_corners(corners), [outline_of_corners(ring) for ring in rings])


def _with_holes(outline: Outline, holes: Sequence[Outline]) -> Outline:
    """An outline with more holes, which are inside of it and apart from one another."""
    chains = split_chains(outline.pieces)
    samples = [sample_chain(chain, CROSSING * outline.size) for chain in chains]
    rings = [hole.vertices(CROSSING * outline.size) for hole in holes]
    Polygon(samples[0], holes=(*samples[1:], *rings))
    inner = [_hole_chain(hole.exterior) for hole in holes]
    return outline_of_pieces(number_chains([*(chain[:, :OWN] for chain in chains), *inner]))


def _without_needless(pieces: Array) -> Outline:
    """The outline of rows, which are drawn again if some of their pieces are none."""
    chains = split_chains(pieces)
    if not any(map(has_faint_pieces, chains)):
        return outline_of_pieces(pieces)
    drawn = [outline_of_pieces(bulge_pieces(bulges_of_chain(chain), "pieces")) for chain in chains]
    return _with_holes(drawn[0], drawn[1:]) if len(drawn) > 1 else drawn[0]


def _hole_chain(hole: Outline) -> Array:
    """Own columns of the boundary of a hole, clockwise."""
    if hole.corners is not None:
        return polygon_chain(np.array(hole.corners)[::-1])
    return reverse_chain(hole.pieces)


def _require_list(holes: Any) -> list[Any]:
    """The outlines of holes in a list."""
    if isinstance(holes, (list, tuple)):
        return [*holes]
    raise InvalidValue("holes", holes, "a sequence of outlines", "give each hole as an outline")


@cache_results(KEPT)
def _outline_in_frame(outline: Outline, frame: Frame) -> Outline:
    corners = outline.corners
    if corners is not None:
        return outline_of_corners(Corners(positions_in_frame(corners, frame)))
    chains = [move_chain(chain, frame) for chain in split_chains(outline.pieces)]
    return outline_of_pieces(number_chains(chains))
