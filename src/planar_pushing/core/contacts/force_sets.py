"""The forces of several contacts that balance a load.

Those along the unit forces of the contacts form a convex set. Its extreme points have three unit forces at
most, as three balance a wrench of the plane. All are found by trying the subsets, which are few.

The friction of a foot at the center of rotation is any force within a disc. Torques are then balanced about
the foot, and the force that remains must lie within the disc.
"""

from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.contacts.unit_forces import (
    FORCE_END,
    FORCES_INSIDE,
    INDEPENDENT,
    MOST_UNITS,
    UNIT_FORCE,
    ForceEnd,
    UnitForce,
    determinant_of,
    find_cancelling,
    length_of_unit,
)
from planar_pushing.core.numbers import Numbers, zeros
from planar_pushing.core.supports.tolerances import BALANCED, COINCIDENT, SHARE


class HeldLoad(NamedTuple):
    """A wrench about the origin, and the friction of a foot that rests.

    Attributes
    ----------
    x, y, torque : float
    limit, foot_x, foot_y : float
        Maximum friction and position of the foot; no limit without one.
    size : float
        Magnitude of the terms of the wrench.
    """

    x: float
    y: float
    torque: float
    limit: float
    foot_x: float
    foot_y: float
    size: float


def balance_load(
    units: Numbers, count: int, load: HeldLoad, slack: float, low: Numbers, high: Numbers
) -> bool:
    """Write the ends of the range of the inner force with which the contacts balance a load.

    Parameters
    ----------
    units : Numbers
        Unit forces, as `UnitForce`.
    count : int
    load : HeldLoad
    slack : float
        Error of a load that two unit forces balance, relative to the size of the load; of fewer at most
        `BALANCED`.
    low, high : Numbers
        Room for an end each.

    Returns
    -------
    bool
        Whether any forces balance the load.
    """
    ForceEnd(low).exists, ForceEnd(high).exists = False, False
    ForceEnd(low).is_infinite, ForceEnd(high).is_infinite = False, False
    for i in range(count):
        low[FORCES_INSIDE + i] = 0.0
    for i in range(-1, count):
        for j in range(i if i < 0 else i + 1, count):
            for k in range(j if j < 0 else j + 1, count):
                if k < 0:
                    continue
                if load.limit > 0.0:
                    _balance_with_foot(units, count, load, i, j, k, low, high)
                else:
                    _balance_with_units(units, count, load, slack, i, j, k, low, high)
    if load.limit > 0.0:
        _balance_with_foot(units, count, load, -1, -1, -1, low, high)
    elif fabs(load.x) + fabs(load.y) + fabs(load.torque) <= min(slack, BALANCED) * load.size:
        coefficients = zeros(MOST_UNITS)
        _offer_forces(units, count, coefficients, low, high)
    if ForceEnd(low).exists:
        find_cancelling(units, count, low, high)
    return ForceEnd(low).exists


def _offer_forces(
    units: Numbers, count: int, coefficients: Numbers, low: Numbers, high: Numbers
) -> None:
    """Widen the range of the inner force by forces that balance the load."""
    inner = 0.0
    for i in range(count):
        inner += coefficients[i] * UnitForce(units[UNIT_FORCE * i :]).inner
        low[FORCES_INSIDE + i] += coefficients[i]
    lowest, highest = ForceEnd(low), ForceEnd(high)
    if not lowest.exists or inner < lowest.inner:
        lowest.exists, lowest.inner = True, inner
        for i in range(count):
            low[FORCE_END + i] = coefficients[i]
    if not highest.exists or inner > highest.inner:
        highest.exists, highest.inner = True, inner
        for i in range(count):
            high[FORCE_END + i] = coefficients[i]


def _balance_with_units(
    units: Numbers, count: int, load: HeldLoad, slack: float, i: int, j: int, k: int,
    low: Numbers, high: Numbers,
) -> None:  # fmt: skip
    """Offer the forces along one, two or three unit forces; missing ones are -1 and first."""
    coefficients = zeros(MOST_UNITS)
    row = zeros(UNIT_FORCE)
    target, last = UnitForce(row), UnitForce(units[UNIT_FORCE * k :])
    target.x, target.y, target.torque = load.x, load.y, load.torque
    size = load.size
    if i >= 0:
        first, second = UnitForce(units[UNIT_FORCE * i :]), UnitForce(units[UNIT_FORCE * j :])
        scale = length_of_unit(first) * length_of_unit(second) * length_of_unit(last)
        determinant = determinant_of(first, second, last)
        if fabs(determinant) <= INDEPENDENT * scale:
            return
        coefficients[i] = determinant_of(target, second, last) / determinant
        coefficients[j] = determinant_of(first, target, last) / determinant
        coefficients[k] = determinant_of(first, second, target) / determinant
    elif j >= 0:
        second = UnitForce(units[UNIT_FORCE * j :])
        x, y = (
            second.y * last.torque - second.torque * last.y,
            (second.torque * last.x - second.x * last.torque),
        )
        torque = second.x * last.y - second.y * last.x
        square = x * x + y * y + torque * torque
        one, other = length_of_unit(second), length_of_unit(last)
        if sqrt(square) <= INDEPENDENT * one * other:
            return
        across = load.x * x + load.y * y + load.torque * torque
        if fabs(across) > slack * size * sqrt(square):
            return
        row_of_normal = zeros(UNIT_FORCE)
        normal = UnitForce(row_of_normal)
        normal.x, normal.y, normal.torque = x, y, torque
        coefficients[j] = determinant_of(target, last, normal) / square
        coefficients[k] = determinant_of(second, target, normal) / square
    else:
        length = length_of_unit(last)
        part = (load.x * last.x + load.y * last.y + load.torque * last.torque) / (length * length)
        rest = fabs(load.x - part * last.x) + fabs(load.y - part * last.y)
        rest += fabs(load.torque - part * last.torque)
        if rest > min(slack, BALANCED) * size:
            return
        coefficients[k] = part
    largest = load.size
    for m in range(count):
        largest = max(largest, fabs(coefficients[m]))
    for m in range(count):
        if coefficients[m] < -COINCIDENT * largest:
            return
        coefficients[m] = max(coefficients[m], 0.0)
    _offer_forces(units, count, coefficients, low, high)


def _torque_about(force: UnitForce, x: float, y: float) -> float:
    """Torque of a unit force about a point; zero if its line passes through the point, to rounding."""
    torque = force.torque - (x * force.y - y * force.x)
    return 0.0 if fabs(torque) <= COINCIDENT * (fabs(force.torque) + fabs(x) + fabs(y)) else torque


def _balance_with_foot(
    units: Numbers, count: int, load: HeldLoad, i: int, j: int, k: int, low: Numbers, high: Numbers
) -> None:
    """Offer extreme forces along up to three unit forces beside the friction of the foot that rests."""
    x, y = load.foot_x, load.foot_y
    torque = load.torque - (x * load.y - y * load.x)
    if fabs(torque) <= COINCIDENT * (load.size + fabs(load.torque)):
        torque = 0.0
    places, start, one, other = zeros(3), zeros(3), zeros(3), zeros(3)
    number = 0
    if i >= 0:
        places[number] = float(i)
        number += 1
    if j >= 0:
        places[number] = float(j)
        number += 1
    if k >= 0:
        places[number] = float(k)
        number += 1
    # One of the unit forces balances the torque; the others are free, with its coefficient in step.
    lead, best = -1, 0.0
    for m in range(number):
        turn = _torque_about(UnitForce(units[UNIT_FORCE * int(places[m]) :]), x, y)
        if fabs(turn) > best:
            lead, best = m, fabs(turn)
    free = number
    if lead >= 0:
        lever = _torque_about(UnitForce(units[UNIT_FORCE * int(places[lead]) :]), x, y)
        start[lead] = torque / lever
        free = number - 1
        filled = 0
        for m in range(number):
            if m != lead:
                turn = _torque_about(UnitForce(units[UNIT_FORCE * int(places[m]) :]), x, y)
                if filled == 0:
                    one[m], one[lead] = 1.0, -turn / lever
                else:
                    other[m], other[lead] = 1.0, -turn / lever
                filled += 1
    elif torque != 0.0:
        return
    elif number == 1:
        one[0] = 1.0
    elif number == 2:
        one[0], other[1] = 1.0, 1.0
    else:
        free = 0 if number == 0 else 3
    if free > 2:
        return
    rest_x, rest_y, one_x, one_y, other_x, other_y = -load.x, -load.y, 0.0, 0.0, 0.0, 0.0
    inner_one, inner_other = 0.0, 0.0
    for m in range(number):
        force = UnitForce(units[UNIT_FORCE * int(places[m]) :])
        rest_x, rest_y = rest_x + start[m] * force.x, rest_y + start[m] * force.y
        one_x, one_y = one_x + one[m] * force.x, one_y + one[m] * force.y
        other_x, other_y = other_x + other[m] * force.x, other_y + other[m] * force.y
        inner_one, inner_other = (
            inner_one + one[m] * force.inner,
            inner_other + other[m] * force.inner,
        )
    limit = load.limit * (1.0 + SHARE)
    if free == 0:
        if rest_x * rest_x + rest_y * rest_y <= limit * limit:
            _offer_in_disc(
                units, count, load, places=places, number=number, start=start, one=one,
                other=other, a=0.0, b=0.0, low=low, high=high,
            )  # fmt: skip
    elif free == 1:
        square = one_x * one_x + one_y * one_y
        half = rest_x * one_x + rest_y * one_y
        inside = half * half - square * (rest_x * rest_x + rest_y * rest_y - limit * limit)
        if square <= COINCIDENT * COINCIDENT or inside < 0.0:
            return
        root = sqrt(inside)
        for sign in range(2):
            a = (-half + (root if sign == 0 else -root)) / square
            _offer_in_disc(
                units, count, load, places=places, number=number, start=start, one=one,
                other=other, a=a, b=0.0, low=low, high=high,
            )  # fmt: skip
    else:
        determinant = one_x * other_y - one_y * other_x
        if fabs(determinant) <= INDEPENDENT * (fabs(one_x) + fabs(one_y)) * (
            fabs(other_x) + fabs(other_y)
        ):
            return
        # The inner force as a function of the force at the foot, whose extreme values are on the circle.
        u_x = (inner_one * other_y - inner_other * one_y) / determinant
        u_y = (inner_other * one_x - inner_one * other_x) / determinant
        size = sqrt(u_x * u_x + u_y * u_y)
        for sign in range(2):
            # If the inner force is the same everywhere, the foot without a force stands for the whole disc.
            part = load.limit / size if size > 0.0 else 0.0
            part = part if sign == 0 else -part
            h_x, h_y = part * u_x - rest_x, part * u_y - rest_y
            _offer_in_disc(
                units, count, load, places=places, number=number, start=start, one=one,
                other=other, a=(h_x * other_y - h_y * other_x) / determinant,
                b=(one_x * h_y - one_y * h_x) / determinant, low=low, high=high,
            )  # fmt: skip


def _offer_in_disc(
    units: Numbers, count: int, load: HeldLoad, places: Numbers, number: int,
    start: Numbers, one: Numbers, other: Numbers, a: float, b: float, low: Numbers, high: Numbers,
) -> None:  # fmt: skip
    """Offer forces with given free coefficients, if none is negative."""
    coefficients = zeros(MOST_UNITS)
    largest = load.size
    for m in range(number):
        coefficient = start[m] + a * one[m] + b * other[m]
        coefficients[int(places[m])] = coefficient
        largest = max(largest, fabs(coefficient))
    for m in range(count):
        if coefficients[m] < -COINCIDENT * largest:
            return
        coefficients[m] = max(coefficients[m], 0.0)
    _offer_forces(units, count, coefficients, low, high)
