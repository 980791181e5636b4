"""Rotations about a point of the support, whose own friction is any force up to its share."""

from __future__ import annotations

from typing import NamedTuple

from flint import arb

from planar_pushing.certified.balls import sign
from planar_pushing.certified.supports.pressure.moments import Vector, moments
from planar_pushing.certified.supports.push import Push, ball


class About(NamedTuple):
    """A rotation about a point of the support under a line of force.

    Attributes
    ----------
    sense : int
        Sign of the rotation.
    force : tuple of arb
        Force at the contact.
    own : arb
        Square of the force that the point takes.
    """

    sense: int
    force: Vector
    own: arb


def about(push: Push, i: int) -> About | None:
    """The rotation about a point; None where the line of force meets the point.

    The rest of the support takes the force f and the torque T about the contact. With the point at r from
    the contact, ``e = (T t - r (t x f)) / (t x r)`` makes f + e parallel to t, without torque.
    """
    place = push.support.points[i].place
    sense, c = push.side(place), ball(place)
    if sense == 0:
        return None
    rest = moments(push.support, c)
    f_x, f_y, torque = -sense * rest.y, sense * rest.x, sense * rest.torque(c, push.contact)
    across, arm = push.x * f_y - push.y * f_x, push.arm(c)
    e_x = (torque * push.x - (c[0] + push.length) * across) / arm
    e_y = (torque * push.y - c[1] * across) / arm
    return About(sense, (f_x + e_x, f_y + e_y), e_x * e_x + e_y * e_y)


def pivot(push: Push) -> tuple[int, About] | None:
    """Number of the point about which the slider turns, and the rotation; None where there is none.

    Raises
    ------
    Undecided
        Where a point takes its share to all digits.
    """
    for i, point in enumerate(push.support.points):
        found = about(push, i)
        if found is not None and sign(found.own - point.share**2) < 0:
            return i, found
    return None
