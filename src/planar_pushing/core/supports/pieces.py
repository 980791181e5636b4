"""Moments of a pressure that determine friction for a center of rotation (manual: theory, any support).

A pressure is stored in `data`, an array that the supports of a call share, as a `PressureHead` and rows of
pieces, all of one width, whose unused numbers are zero:

- Atoms are points, as `AtomRow`. No two are at the same place.
- Segments are uniform lines, as `LineRow`.
- Rings and discs are uniform, as `CircleRow`. A hole has a negative share.
- Plates are areas with uniform pressure between edges, as `StoredPlate`, around their center of pressure.
- Edges of the plates, as `LineRow`: midpoints are relative to the plate's center, and a jump is the
  pressure on the left of the tangent minus that on the right, per unit share.

All places are indices into `data`.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.circles import disc_piece, ring_piece
from planar_pushing.core.supports.lines import plate_piece, segment_piece, turn_piece
from planar_pushing.core.supports.multipole import ROWS, distant_piece
from planar_pushing.core.supports.piece_rows import (
    COLUMNS,
    AtomRow,
    CircleRow,
    LineRow,
    PressureHead,
    StoredPlate,
)
from planar_pushing.core.supports.sums import Piece, add_piece

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


def pressure_at(data: Numbers, place: int) -> Pressure:
    """The pressure whose head is at a place in `data`."""
    head = PressureHead(data[place:])
    return Pressure(data, place, head.center.x, head.center.y)


def head_of(pressure: Pressure) -> PressureHead:
    """The head of a pressure."""
    return PressureHead(pressure.data[pressure.head :])


def count_atoms(pressure: Pressure) -> int:
    """Number of atoms of a pressure."""
    head = head_of(pressure)
    return (head.segments - head.atoms) // COLUMNS


def atom_of(pressure: Pressure, number: int) -> AtomRow:
    """An atom of a pressure."""
    return AtomRow(pressure.data[head_of(pressure).atoms + COLUMNS * number :])


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
    head = head_of(pressure)
    i, end = head.atoms, head.segments
    while i < end:
        atom = AtomRow(data[i:])
        q_x, q_y, share = atom.x, atom.y, atom.share
        r_x, r_y = q_x - x, q_y - y
        square = r_x * r_x + r_y * r_y
        moves = square > max(atom.square, blur)
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
    head = head_of(pressure)
    i, end = head.segments, head.rings
    while i < end:
        line = LineRow(data[i:])
        q_x, q_y, t_x, t_y = line.x, line.y, line.t_x, line.t_y
        r_x, r_y = q_x - x, q_y - y
        piece = segment_piece(r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x, line.half)
        total = add_piece(
            total,
            share=line.share,
            piece=turn_piece(piece, t_x, t_y),
            arm_x=q_x - p_x,
            arm_y=q_y - p_y,
        )
        i += COLUMNS
    return total


def add_circles(total: Piece, pressure: Pressure, x: float, y: float) -> Piece:
    """Add the rings and the discs, which follow them."""
    data, p_x, p_y = pressure.data, pressure.center_x, pressure.center_y
    head = head_of(pressure)
    i, end = head.rings, head.plates
    first_disc = head.discs
    while i < end:
        circle = CircleRow(data[i:])
        q_x, q_y, radius = circle.x, circle.y, circle.radius
        if i < first_disc:
            piece = ring_piece(x - q_x, y - q_y, radius)
        else:
            piece = disc_piece(x - q_x, y - q_y, radius)
        total = add_piece(total, share=circle.share, piece=piece, arm_x=q_x - p_x, arm_y=q_y - p_y)
        i += COLUMNS
    return total


def add_plates(total: Piece, pressure: Pressure, x: float, y: float) -> Piece:
    """Add the polygons and the cells of pressure maps."""
    data, p_x, p_y = pressure.data, pressure.center_x, pressure.center_y
    head = head_of(pressure)
    i, end, terms = head.plates, head.edges, head.series
    while i < end:
        plate = StoredPlate(data[i:])
        q_x, q_y, radius = plate.x, plate.y, plate.radius
        r_x, r_y, far = x - q_x, y - q_y, PLATE_FAR * radius
        if r_x * r_x + r_y * r_y < far * far:
            piece = plate_piece(data, first=plate.first, last=plate.last, x=r_x, y=r_y)
        else:
            piece = distant_piece(data, terms, x=r_x, y=r_y, radius=radius)
        total = add_piece(total, share=plate.share, piece=piece, arm_x=q_x - p_x, arm_y=q_y - p_y)
        i += COLUMNS
        terms += 2 * ROWS
    return total


class PlaceRow(Record):
    """A center of rotation in the frame of a pressure, whose head is at a place in the data."""

    head: int
    x: float
    y: float


class MomentsRow(Record):
    """The numbers of `Moments`."""

    distance: float
    unit_x: float
    unit_y: float
    torque: float
    xx: float
    xy: float
    yy: float
    atom: int


def moments(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Moments of pressures: of each `PlaceRow` a `MomentsRow`."""
    for i in range(count):
        row, result = PlaceRow(rows[i * columns :]), MomentsRow(results[i * width :])
        total = pressure_moments(pressure_at(data, row.head), row.x, row.y, 0.0)
        result.distance, result.unit_x, result.unit_y = total.distance, total.unit_x, total.unit_y
        result.torque, result.xx, result.xy = total.torque, total.xx, total.xy
        result.yy, result.atom = total.yy, total.atom
