"""The numbers of supports by name: pieces in a unit of length of the user, and stored pressures."""

from __future__ import annotations

from planar_pushing.core._record import Record, size_of


class CenterRow(Record):
    """A center of pressure."""

    x: float
    y: float


class Spread(Record):
    """Means of x x, x y and y y about a center of pressure."""

    xx: float
    xy: float
    yy: float


class PressureHead(Record):
    """Head of a stored pressure; all places are indices into the data of the pressure.

    Attributes
    ----------
    center : CenterRow
    spread : Spread
    atoms, segments, rings, discs, plates, edges : int
        Places at which the rows of each kind begin, and those of the kind before end.
    series : int
        Place at which the terms of the plates begin, ``2 * ROWS`` numbers for each plate.
    end : int
        Place at which the edges end.
    """

    center: CenterRow
    spread: Spread
    atoms: int
    segments: int
    rings: int
    discs: int
    plates: int
    edges: int
    series: int
    end: int


class PointRow(Record):
    """A point: position and share."""

    x: float
    y: float
    share: float


class AtomRow(PointRow):
    """A stored point, with the square of the distance below which a center of rotation is on it."""

    square: float


class EndsRow(Record):
    """A line from one end to the other: its share or, for the edge of a plate, the jump of the pressure."""

    x: float
    y: float
    end_x: float
    end_y: float
    share: float


class LineRow(Record):
    """A stored line: midpoint, unit tangent, half length, and share or jump."""

    x: float
    y: float
    t_x: float
    t_y: float
    half: float
    share: float


class CircleRow(Record):
    """A ring or a disc: center, radius and share."""

    x: float
    y: float
    radius: float
    share: float


class EdgeLoad(Record):
    """The load of a triangle of a plate, and the load times the sum of the ends of its edge."""

    load: float
    load_x: float
    load_y: float


class PlateSums(EdgeLoad):
    """The sums of a plate over its edges, and their number."""

    unused: float
    edges: int


class PlateRow(Record):
    """A measured plate: center of pressure, largest distance from it, share, and number of edges."""

    x: float
    y: float
    radius: float
    share: float
    edges: int


class StoredPlate(CircleRow):
    """A stored plate: as a circle, and the places at which its edges begin and end."""

    first: int
    last: int


class SupportMeasures(Record):
    """Center and second moments of a support."""

    center: CenterRow
    spread: Spread


class ReachRow(Record):
    """A vector from a center to an extreme point, and what is added to its length."""

    x: float
    y: float
    more: float


#: Numbers of a point, a line, a circle and a plate in a unit of length of the user.
POINT, LINE, CIRCLE, PLATE = (
    size_of(PointRow),
    size_of(EndsRow),
    size_of(CircleRow),
    size_of(PlateRow),
)
EDGE_LOAD, MEASURED, REACH = size_of(EdgeLoad), size_of(SupportMeasures), size_of(ReachRow)
#: Numbers of the head of a stored pressure, and of the row of each of its pieces.
HEAD, COLUMNS = size_of(PressureHead), size_of(LineRow)
