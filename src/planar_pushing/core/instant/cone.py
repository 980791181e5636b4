"""The contact law: its friction cone, and the forces that it transmits (Secs. 2-5)."""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.force import ContactMotion, motion_under_force, replace_force
from planar_pushing.core.instant.solution import Push, force_along
from planar_pushing.core.supports.psi import guess_spin, psi
from planar_pushing.core.supports.resistance import has_friction
from planar_pushing.core.supports.rows import NO_POINT, scale_effects
from planar_pushing.core.supports.tolerances import ALIGNED, COINCIDENT, RESOLUTION, SLOWEST

#: Maximum number of times that a step from an edge into the friction cone is halved.
HALVES = 40
#: Positions of a force relative to the cone; in the middle two, an edge is within the force's rounding
#: error.
BEYOND, JUST_BEYOND, JUST_WITHIN, WITHIN = range(4)


class Law(NamedTuple):
    """A contact law: the edges of its friction cone, and the behavior there.

    A `rough` law transmits every force. The edges of a `closed` cone belong to the cone.
    """

    right: Direction
    left: Direction
    slips: bool
    closed: bool
    rough: bool


def force_across(edge: Direction, f_x: float, f_y: float) -> float:
    """The force across an edge, ``e x f``, positive to the left of it."""
    return edge.along * f_y + edge.across * f_x


def _inner_edge(push: Push, law: Law, number: int) -> tuple[float, float]:
    """One of three edges along which all forces of the cone have a positive moment.

    The third is along the fence: in a cone without width a force can be opposite to it.
    """
    if number == 2:
        return push.t_x, push.t_y
    if number == 1:
        return -law.left.along, law.left.across
    return law.right.along, -law.right.across


def position_in_cone(push: Push, law: Law, motion: ContactMotion) -> int:
    """Position of a force relative to the friction cone: `BEYOND` to `WITHIN`."""
    position = WITHIN
    for i in range(3):
        e_x, e_y = _inner_edge(push, law, i)
        inside = e_x * motion.f_y - e_y * motion.f_x
        noise = fabs(e_x) * (motion.noise_y + RESOLUTION * fabs(motion.f_y))
        noise += fabs(e_y) * (motion.noise_x + RESOLUTION * fabs(motion.f_x))
        if inside < -noise:
            position = min(position, BEYOND)
        elif inside < 0.0:
            position = min(position, JUST_BEYOND)
        elif inside <= noise:
            position = min(position, JUST_WITHIN)
    return position


def settle_pivot(push: Push, law: Law, stick: ContactMotion) -> ContactMotion:
    """A pivot with its force in the middle of those that the law transmits, if it transmits any."""
    if stick.half_x == 0.0 and stick.half_y == 0.0:
        return stick
    low, high = -1.0, 1.0
    rounding = ALIGNED * (fabs(stick.half_x) + fabs(stick.half_y))
    for i in range(0 if law.rough else 3):
        e_x, e_y = _inner_edge(push, law, i)
        depth = e_x * stick.f_y - e_y * stick.f_x
        change = e_x * stick.half_y - e_y * stick.half_x
        if change > rounding:
            low = max(low, -depth / change)
        elif change < -rounding:
            high = min(high, -depth / change)
    part = min(max((low + high) / 2.0, -1.0), 1.0)
    half = max((high - low) / 2.0, 0.0)
    return replace_force(
        stick,
        f_x=stick.f_x + part * stick.half_x,
        f_y=stick.f_y + part * stick.half_y,
        half_x=half * stick.half_x,
        half_y=half * stick.half_y,
    )


def hold_at_rest(push: Push, law: Law, stick: ContactMotion, scale: float) -> ContactMotion:
    """A slider at rest; a force outside the cone is moved into it if friction can sustain that.

    Friction holds the slider under a convex set of forces. The largest of them along an edge is the force
    of the slowest motion under that edge.
    """
    if law.rough or position_in_cone(push, law, stick) == WITHIN:
        return stick
    for i in range(2):
        edge, side = law.right if i == 0 else law.left, 1.0 if i == 0 else -1.0
        if law.closed and side * force_across(edge, stick.f_x, stick.f_y) >= 0.0:
            continue
        slow = motion_under_force(
            push.effects, push.contact, e_x=edge.along, e_y=-edge.across, along=SLOWEST * scale
        )
        moves = fabs(slow.u_x) + fabs(slow.u_y)
        if slow.converged and moves <= COINCIDENT * scale and force_along(edge, slow) > 0.0:
            held = replace_force(stick, slow.f_x, slow.f_y, half_x=0.0, half_y=0.0)
            return held if law.closed else _move_inside(push, law, held, edge, side)
    return stick


def _move_inside(
    push: Push, law: Law, stick: ContactMotion, edge: Direction, side: float
) -> ContactMotion:
    """A slider at rest with its force moved from an edge into the cone, to one that friction sustains.

    Of the forces that friction holds, the one of the slowest motion across the edge is farthest from the
    edge.
    """
    if not has_friction(push.effects):
        return stick  # only one force holds the contact
    x, y, part = side * edge.across, side * edge.along, 1.0
    effects = scale_effects(push.effects, 1.0, 0.0)
    guess = guess_spin(effects, push.contact, x, y)
    root = psi(effects, push.contact, x, y, guess, NO_POINT, 0.0)
    for _ in range(HALVES):
        f_x = stick.f_x + part * (root.f_x - stick.f_x)
        f_y = stick.f_y + part * (root.f_y - stick.f_y)
        if force_across(law.right, f_x, f_y) > 0.0 and force_across(law.left, f_x, f_y) < 0.0:
            return replace_force(stick, f_x, f_y, half_x=0.0, half_y=0.0)
        part /= 2.0
    return stick
