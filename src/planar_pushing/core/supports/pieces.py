"""Moments of a pressure that determine friction for a center of rotation (manual: theory, any support).

A pressure is stored in `data`, an array that the supports of a call share, as a head and rows of pieces.
All places are indices into `data`.

The head has the center of pressure x, y; the means of x x, x y and y y about it; the places at which the
rows of each kind begin, `ATOMS` to `EDGES`, where each kind ends at the beginning of the next one; the
place at which the terms of the plates begin, ``2 * ROWS`` numbers per plate; and the place at which the
edges end.

A row has six numbers, of which unused ones are zero:

- Atoms are points: x, y, share, and the square of the distance below which a center of rotation is on the
  point. No two are at the same place.
- Segments are uniform lines: x and y of the midpoint, unit tangent, half length, share.
- Rings and discs are uniform: x and y of the center, radius, share. A hole has a negative share.
- Plates are areas with uniform pressure between edges: x and y of the center of pressure, largest distance
  of an edge from it, share, and the places at which its edges begin and end.
- Edges of the plates: x and y of the midpoint from the plate's center, unit tangent, half length, and the
  pressure on the left of the tangent minus that on the right, per unit share.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.circles import disc_piece, ring_piece
from planar_pushing.core.supports.lines import plate_piece, segment_piece, turn_piece
from planar_pushing.core.supports.multipole import ROWS, distant_piece
from planar_pushing.core.supports.sums import Piece, add_piece

#: Numbers in the head of a pressure, and in a row.
HEAD = 16
COLUMNS = 6
#: Fields of a head.
CENTER = 0
SPREAD = 2
ATOMS = 5
SEGMENTS = 6
RINGS = 7
DISCS = 8
PLATES = 9
EDGES = 10
SERIES = 11
END = 12
#: Beyond this distance, in radii of the plate, `distant_piece` is used.
PLATE_FAR = 1.7


class Pressure(NamedTuple):
    """A pressure of unit weight, with lengths in units of the support's extent.

    Parameters
    ----------
    data : array
    head : int
        Place of its head in `data`.
    center_x, center_y : float
        Center of pressure.
    """

    data: Numbers
    head: int
    center_x: float
    center_y: float


class Moments(NamedTuple):
    """Moments of a pressure at a center of rotation c.

    Parameters
    ----------
    distance : float
        D, the mean of rho = |r - c|.
    unit_x, unit_y : float
        G, the mean of (r - c) / rho; minus the gradient of D with respect to c.
    torque : float
        T, about the center of pressure p of a slider that turns counterclockwise: ``D + (c - p) . G``.
    xx, xy, yy : float
        Second derivatives of D with respect to c.
    atom : int
        Number of the atom at c, or -1. That atom has no direction of motion, so it contributes to D only.
    """

    distance: float
    unit_x: float
    unit_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    atom: int


def pressure_at(data: Numbers, head: int) -> Pressure:
    """The pressure whose head is at a place in `data`."""
    return Pressure(data, head, data[head + CENTER], data[head + CENTER + 1])


def place_of(pressure: Pressure, field: int) -> int:
    """Place in `data` that a field of the head holds: ATOMS for the first atom, and so on."""
    return int(pressure.data[pressure.head + field])


def count_atoms(pressure: Pressure) -> int:
    """Number of atoms of a pressure."""
    head = pressure.data[pressure.head :]
    return int((head[SEGMENTS] - head[ATOMS]) / COLUMNS)


def place_of_atom(pressure: Pressure, number: int) -> int:
    """Place in `data` of the row of an atom: x, y, share."""
    return place_of(pressure, ATOMS) + COLUMNS * number


def pressure_moments(pressure: Pressure, x: float, y: float, blur: float) -> Moments:
    """Moments of a pressure at a center of rotation in the body frame, per unit weight.

    Parameters
    ----------
    pressure : Pressure
    x, y : float
        In units of the extent, up to 1e9 extents away; beyond that, use the limit of a translation.
    blur : float
        Uncertainty of the center, which counts as on every atom within this distance.

    Returns
    -------
    Moments

    Notes
    -----
    A rotation about c at omega is sustained by the force ``sgn(omega) J G`` (J rotates by +90 degrees: x, y
    to -y, x) and the torque ``sgn(omega) T`` about the center of pressure; its potential is |omega| D. In
    the limit of a translation v, the potential is |v|, the force v / |v|, and the torque zero.
    """
    atoms = sum_atoms(pressure, x, y, blur * blur)
    total = Piece(
        atoms.distance, atoms.unit_x, atoms.unit_y, atoms.torque, atoms.xx, atoms.xy, atoms.yy
    )
    total = add_segments(total, pressure, x, y)
    total = add_circles(total, pressure, x, y)
    total = add_plates(total, pressure, x, y)
    return Moments(
        total.distance, total.unit_x, total.unit_y, total.torque, total.xx, total.xy, total.yy,
        atoms.atom,
    )  # fmt: skip


def sum_atoms(pressure: Pressure, x: float, y: float, blur: float) -> Moments:
    """Sum over the atoms; an atom at (x, y) exerts no force.

    `blur` is the square of the distance within which an atom counts as at (x, y).
    """
    moves: bool
    data, hit, number = pressure.data, -1, 0
    distance, unit_x, unit_y, torque, xx, xy, yy = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    i, end = place_of(pressure, ATOMS), place_of(pressure, SEGMENTS)
    while i < end:
        q_x, q_y, share = data[i], data[i + 1], data[i + 2]
        r_x, r_y = q_x - x, q_y - y
        square = r_x * r_x + r_y * r_y
        moves = square > max(data[i + 3], blur)
        hit = max(hit, -1 if moves else number)
        # The square root and the division are independent, so the processor overlaps them.
        away, bend = sqrt(square), (1.0 if moves else 0.0) / (square if moves else 1.0)
        f_x, f_y = share * (away * bend) * r_x, share * (away * bend) * r_y
        distance += share * away
        unit_x += f_x
        unit_y += f_y
        torque += (q_x - pressure.center_x) * f_x + (q_y - pressure.center_y) * f_y
        xx += bend * f_y * r_y
        xy -= bend * f_x * r_y
        yy += bend * f_x * r_x
        i += COLUMNS
        number += 1
    return Moments(distance, unit_x, unit_y, torque, xx, xy, yy, hit)


def add_segments(total: Piece, pressure: Pressure, x: float, y: float) -> Piece:
    """Add the segments to the totals, whose torque is about the center of pressure."""
    data, p_x, p_y = pressure.data, pressure.center_x, pressure.center_y
    i, end = place_of(pressure, SEGMENTS), place_of(pressure, RINGS)
    while i < end:
        q_x, q_y, t_x, t_y = data[i], data[i + 1], data[i + 2], data[i + 3]
        r_x, r_y = q_x - x, q_y - y
        piece = segment_piece(r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x, data[i + 4])
        total = add_piece(
            total,
            share=data[i + 5],
            piece=turn_piece(piece, t_x, t_y),
            arm_x=q_x - p_x,
            arm_y=q_y - p_y,
        )
        i += COLUMNS
    return total


def add_circles(total: Piece, pressure: Pressure, x: float, y: float) -> Piece:
    """Add the rings and the discs, which follow them."""
    data, p_x, p_y = pressure.data, pressure.center_x, pressure.center_y
    i, end = place_of(pressure, RINGS), place_of(pressure, PLATES)
    first_disc = place_of(pressure, DISCS)
    while i < end:
        q_x, q_y, radius = data[i], data[i + 1], data[i + 2]
        if i < first_disc:
            piece = ring_piece(x - q_x, y - q_y, radius)
        else:
            piece = disc_piece(x - q_x, y - q_y, radius)
        total = add_piece(total, share=data[i + 3], piece=piece, arm_x=q_x - p_x, arm_y=q_y - p_y)
        i += COLUMNS
    return total


def add_plates(total: Piece, pressure: Pressure, x: float, y: float) -> Piece:
    """Add the polygons and the cells of pressure maps."""
    data, p_x, p_y = pressure.data, pressure.center_x, pressure.center_y
    i, end, terms = (
        place_of(pressure, PLATES),
        place_of(pressure, EDGES),
        place_of(pressure, SERIES),
    )
    while i < end:
        q_x, q_y, radius = data[i], data[i + 1], data[i + 2]
        r_x, r_y, far = x - q_x, y - q_y, PLATE_FAR * radius
        if r_x * r_x + r_y * r_y < far * far:
            piece = plate_piece(data, first=int(data[i + 4]), last=int(data[i + 5]), x=r_x, y=r_y)
        else:
            piece = distant_piece(data, terms, x=r_x, y=r_y, radius=radius)
        total = add_piece(total, share=data[i + 3], piece=piece, arm_x=q_x - p_x, arm_y=q_y - p_y)
        i += COLUMNS
        terms += 2 * ROWS
    return total


def moments(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Moments of pressures; a row holds the place of a head and x, y of a center, the results `Moments`."""
    for i in range(count):
        row, result = rows[i * columns :], results[i * width :]
        total = pressure_moments(pressure_at(data, int(row[0])), row[1], row[2], 0.0)
        result[0], result[1], result[2] = total.distance, total.unit_x, total.unit_y
        result[3], result[4], result[5] = total.torque, total.xx, total.xy
        result[6], result[7] = total.yy, float(total.atom)
