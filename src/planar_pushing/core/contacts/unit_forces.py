"""Unit forces of several contacts, and the forces along them that cancel one another.

The forces of each contact are combinations, without negative coefficients, of a few unit forces: the edges
of its friction cone, or the one edge of a slip. Forces that cancel can be added to any others without end.
Their extreme directions have four unit forces at most, as three balance a wrench of the plane. All are
found by trying the subsets, which are few.
"""

from __future__ import annotations

from math import fabs, sqrt

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.numbers import Numbers, zeros

#: Maximum number of unit forces: four contacts, each with two tangents and two normals.
MOST_UNITS = 16
#: Vectors are independent if their determinant, relative to their lengths, exceeds this.
INDEPENDENT = 1e-10


class UnitForce(Record):
    """A unit force and its torque about the origin.

    Attributes
    ----------
    x, y, torque : float
    inner : float
        What it adds to the inner force: half its component along the line between two contacts, positive at
        the first and negative at the second.
    contact : int
        Number of its contact.
    """

    x: float
    y: float
    torque: float
    inner: float
    contact: int


class ForceEnd(Record):
    """An end of the range of the inner force, before the coefficients of the unit forces.

    Attributes
    ----------
    inner : float
        The inner force.
    is_infinite : bool
        Whether the inner force has no bound there. The coefficients are then those of a direction.
    exists : bool
        Whether any forces balance the load.
    """

    inner: float
    is_infinite: bool
    exists: bool


UNIT_FORCE, FORCE_END = size_of(UnitForce), size_of(ForceEnd)
#: Numbers of an end with its coefficients, and the place of the sums of the coefficients of all extreme
#: forces and directions, which follow those of the lower end. The sums are inside of the set.
END_OF_FORCES, FORCES_INSIDE = FORCE_END + 2 * MOST_UNITS, FORCE_END + MOST_UNITS


def determinant_of(one: UnitForce, two: UnitForce, three: UnitForce) -> float:
    """Determinant of three wrenches."""
    x = two.y * three.torque - two.torque * three.y
    y = two.torque * three.x - two.x * three.torque
    torque = two.x * three.y - two.y * three.x
    return one.x * x + one.y * y + one.torque * torque


def length_of_unit(force: UnitForce) -> float:
    """Length of the wrench of a unit force."""
    return sqrt(force.x * force.x + force.y * force.y + force.torque * force.torque)


def find_cancelling(units: Numbers, count: int, low: Numbers, high: Numbers) -> bool:
    """Write the directions in which the inner force has no bound, as forces of a unit inner force.

    Returns
    -------
    bool
        Whether forces of at least two contacts can cancel one another.
    """
    cancels = False
    coefficients = zeros(MOST_UNITS)
    for i in range(count):
        one = UnitForce(units[UNIT_FORCE * i :])
        for j in range(i + 1, count):
            two = UnitForce(units[UNIT_FORCE * j :])
            x, y = one.y * two.torque - one.torque * two.y, one.torque * two.x - one.x * two.torque
            torque = one.x * two.y - one.y * two.x
            length = sqrt(x * x + y * y + torque * torque)
            first, second = length_of_unit(one), length_of_unit(two)
            if length <= INDEPENDENT * first * second:
                if one.x * two.x + one.y * two.y + one.torque * two.torque < 0.0:
                    for m in range(count):
                        coefficients[m] = 0.0
                    coefficients[i], coefficients[j] = 1.0 / first, 1.0 / second
                    cancels = _offer_direction(units, count, coefficients, low, high) or cancels
                continue
            for k in range(j + 1, count):
                three = UnitForce(units[UNIT_FORCE * k :])
                third = length_of_unit(three)
                determinant = determinant_of(one, two, three)
                if fabs(determinant) <= INDEPENDENT * first * second * third:
                    for m in range(count):
                        coefficients[m] = 0.0
                    _write_coplanar(one, two, three, x, y, torque, coefficients, i, j, k)
                    cancels = _offer_direction(units, count, coefficients, low, high) or cancels
                    continue
                for n in range(k + 1, count):
                    four = UnitForce(units[UNIT_FORCE * n :])
                    for m in range(count):
                        coefficients[m] = 0.0
                    coefficients[i] = -determinant_of(four, two, three) / determinant
                    coefficients[j] = -determinant_of(one, four, three) / determinant
                    coefficients[k] = -determinant_of(one, two, four) / determinant
                    coefficients[n] = 1.0
                    cancels = _offer_direction(units, count, coefficients, low, high) or cancels
    return cancels


def _write_coplanar(
    one: UnitForce, two: UnitForce, three: UnitForce, x: float, y: float, torque: float,
    coefficients: Numbers, i: int, j: int, k: int,
) -> None:  # fmt: skip
    """Write coefficients with which three wrenches in the plane with normal (x, y, torque) cancel."""
    row = zeros(UNIT_FORCE)
    normal = UnitForce(row)
    normal.x, normal.y, normal.torque = x, y, torque
    square = x * x + y * y + torque * torque
    coefficients[i] = determinant_of(two, three, normal) / square
    coefficients[j] = determinant_of(three, one, normal) / square
    coefficients[k] = 1.0


def _offer_direction(
    units: Numbers, count: int, coefficients: Numbers, low: Numbers, high: Numbers
) -> bool:
    """Take a direction of forces that cancel, if no coefficient is negative; whether contacts oppose."""
    inner, owner, several, largest = 0.0, -1, False, 0.0
    for m in range(count):
        largest = max(largest, fabs(coefficients[m]))
    for m in range(count):
        if coefficients[m] < -INDEPENDENT * largest:
            return False
        if coefficients[m] > INDEPENDENT * largest:
            force = UnitForce(units[UNIT_FORCE * m :])
            inner += coefficients[m] * force.inner
            if owner >= 0 and owner != force.contact:
                several = True
            owner = force.contact
    if not several:
        return False
    for m in range(count):
        low[FORCES_INSIDE + m] += max(coefficients[m], 0.0)
    if fabs(inner) > INDEPENDENT * largest:
        if inner > 0.0 and not ForceEnd(high).is_infinite:
            ForceEnd(high).is_infinite = True
            for m in range(count):
                high[FORCE_END + m] = max(coefficients[m], 0.0) / inner
        elif inner < 0.0 and not ForceEnd(low).is_infinite:
            ForceEnd(low).is_infinite = True
            for m in range(count):
                low[FORCE_END + m] = -max(coefficients[m], 0.0) / inner
    return True
