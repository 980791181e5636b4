"""Sec. 3 for an unknown pressure: a square base whose center of pressure is its center.

A unit of pressure at r adds ``w . v / |v|`` to the force along d plus k times the torque about the contact
P, where v is the velocity of the point and ``w = d + k J (r - P)``. A sum is positive for every pressure
with the given center if an affine function of r is smaller on the whole base, and positive at the center.
Along a ray from the center of rotation the part of a unit of pressure is affine. If this center is outside
of the square, the inequality therefore holds inside if it holds on the sides.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, arb_series, fmpq

from pulling_by_pushing.evidence.claims import any_support
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.boxes import cover
from pulling_by_pushing.evidence.proofs.registry import proof
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    identity,
    inequality,
    near,
    together,
)
from pulling_by_pushing.oracle.balls import rational

Pair = tuple[fmpq, fmpq]
#: Corners of the square, counterclockwise.
CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
#: Contact of the push, and the velocity of its pusher.
POINT, VELOCITY = (fmpq(1, 2), fmpq(-1)), (fmpq(0), fmpq(1))
#: Rotations beyond which the torque about the contact is negative and positive for every pressure, and
#: affine functions that prove it: a, b_x, b_y.
LOW = 0.17468027, (6.0e-9, -0.7939129525749, -0.2939129396204)
HIGH = 0.441832885, (2.0e-9, 0.7095422201805, 0.8647673086457)
#: Distance from these to the rotations that pressures reach.
END_GAP = 5.0e-9
#: Pressures of one half on opposite points balance the torque close to these rotations.
LOW_POINT, HIGH_POINT = (1.0, -1.0), (1.0, 0.822237)
#: The clockwise center on the x axis, and the coefficient of friction, that suffice for every pressure; and
#: the functions that prove it, for a force inside of the right and the left edge of the friction cone, and
#: for a line of action to the right of the start of the side and to the left of its end.
CENTER_X, COEFFICIENT = 2.000000005, 0.236067981
INSIDE_RIGHT = 2.0e-9, -0.2236101646460, -0.3165713479412
INSIDE_LEFT = 2.0e-9, -0.1031652157684, 0.4370162968188
RIGHT_OF_START = 2.0e-9, 0.3162277690780, -0.3162277655425
LEFT_OF_END = 0.95, -1.0292239515436, 0.4407052351943


class RigidMotion(NamedTuple):
    """A motion: the velocity of a point of the object, and the rotation."""

    point: Pair
    velocity: Pair
    rotation: fmpq


class Load(NamedTuple):
    """The component of the force along d, plus k times the torque about the point of the motion."""

    along: Pair
    torque: fmpq


def part(motion: RigidMotion, load: Load, x: arb_series, y: arb_series) -> arb_series:
    """Contribution of unit pressure at (x, y) to a load; NaN where its speed may be zero."""
    x, y = x - motion.point[0], y - motion.point[1]
    (u_x, u_y), omega, (d_x, d_y), k = motion.velocity, motion.rotation, load.along, load.torque
    v_x, v_y = u_x - omega * y, u_y + omega * x
    speed = (v_x * v_x + v_y * v_y).sqrt()
    if not speed[0] > 0:
        return arb_series([arb.nan()] * 3, prec=3)
    return ((d_x - k * y) * v_x + (d_y + k * x) * v_y) / speed


def positive_sum(motion: RigidMotion, load: Load, affine: tuple[float, ...]) -> Evidence:
    """Evidence that an affine function is below the part of each point, and positive at the center.

    On a box of a side the difference is bounded by its Taylor polynomial at the middle.
    """
    a, b_x, b_y = map(rational, affine)
    evidence = inequality(arb(a))
    for (x, y), (end_x, end_y) in zip(CORNERS, CORNERS[1:] + CORNERS[:1], strict=True):

        def difference(
            s: arb, x: int = x, y: int = y, dx: int = end_x - x, dy: int = end_y - y
        ) -> arb_series:
            along = arb_series([s, 1], prec=3)
            point = x + dx * along, y + dy * along
            return part(motion, load, *point) - a - b_x * point[0] - b_y * point[1]

        def margin(low: arb, high: arb) -> arb:
            off = arb(0, ((high - low) / 2).upper())
            middle, box = difference(((low + high) / 2).mid()), difference(low.union(high))
            return (middle[0] + off * middle[1] + off * off * box[2]).lower()

        evidence = together(evidence, cover(margin, arb(0), arb(1)).evidence())
    return evidence


def torque(rotation: float, point: tuple[float, float]) -> arb:
    """Torque about the contact from one half of the pressure at a point and one half opposite."""
    motion, load = (
        RigidMotion(POINT, VELOCITY, rational(rotation)),
        Load((fmpq(0), fmpq(0)), fmpq(1)),
    )
    return _opposite(motion, load, point)


def _opposite(motion: RigidMotion, load: Load, point: tuple[float, float]) -> arb:
    """The load of one half of the pressure at a point and one half opposite."""
    x, y = map(rational, point)
    ends = (
        part(motion, load, *(arb_series([arb(s * z)], prec=1) for z in (x, y))) for s in (1, -1)
    )
    return sum((end[0] for end in ends), arb(0)) / 2


def rising_torque() -> Evidence:
    """Evidence that the torque about the contact of each pressure increases with the rotation.

    Its derivative, times the cube of the speed of a point, is a square.
    """
    arm = -any_support.POINT[1], any_support.POINT[0]
    v = any_support.SLIDE
    rate = ids.dot(arm, arm) * ids.dot(v, v) - ids.dot(arm, v) ** 2
    slopes = tuple(part.derivative("k") for part in v)
    return identity({
        "the derivative of the velocity by the rotation, along x": slopes[0] - arm[0],
        "the derivative of the velocity by the rotation, along y": slopes[1] - arm[1],
        "the derivative of the torque": rate - ids.cross(arm, v) ** 2,
    })  # fmt: skip


@proof
def rotation_for_any_pressure(low: float, high: float, within: float) -> Evidence:
    """The rotations of the push at (0.5, -1) with the velocity (0, 1): both ends, to within an accuracy."""
    no_force, moment = (fmpq(0), fmpq(0)), fmpq(1)
    outer = [
        positive_sum(
            RigidMotion(POINT, VELOCITY, rational(LOW[0])), Load(no_force, -moment), LOW[1]
        ),
        positive_sum(
            RigidMotion(POINT, VELOCITY, rational(HIGH[0])), Load(no_force, moment), HIGH[1]
        ),
    ]
    # Pressures that balance at a rotation between the proved end and this one.
    inner = LOW[0] + END_GAP, HIGH[0] - END_GAP
    attained = inequality(torque(inner[0], LOW_POINT)), inequality(-torque(inner[1], HIGH_POINT))
    ends = (
        arb(rational(LOW[0])).union(arb(rational(inner[0]))),
        arb(rational(inner[1])).union(arb(rational(HIGH[0]))),
    )
    inner_ends = near(ends[1], high, within), near(ends[0], low, within)
    return together(*inner_ends, *outer, *attained, rising_torque())


@proof
def stable_for_any_pressure(center: float, friction: float, within: float) -> Evidence:
    """The nearest clockwise center on the x axis, and the least friction there, to within an accuracy."""
    c, mu = rational(CENTER_X), rational(COEFFICIENT)
    zero, one = fmpq(0), fmpq(1)

    def about(x: int, y: int, center_x: fmpq = c) -> RigidMotion:
        return RigidMotion((fmpq(x), fmpq(y)), (fmpq(y), center_x - x), -one)

    stays = [
        positive_sum(about(0, 0), Load((-one, mu), zero), INSIDE_RIGHT),
        positive_sum(about(0, 0), Load((one, mu), zero), INSIDE_LEFT),
        positive_sum(about(-1, -1), Load((zero, zero), one), RIGHT_OF_START),
        positive_sum(about(1, -1), Load((zero, zero), -one), LEFT_OF_END),
    ]
    # One half of the pressure on two opposite corners needs this friction, and a center that is as far.
    closer = 2 * rational(2.0) - c
    fails = inequality(-_opposite(about(-1, -1, closer), Load((zero, zero), one), (1.0, 1.0)))
    force = [
        _opposite(about(0, 0), Load(axis, zero), (1.0, 1.0)) for axis in ((one, zero), (zero, one))
    ]
    nearest = near(arb(closer).union(arb(c)), center, within)
    coefficient = near((force[0] / force[1]).union(arb(mu)), friction, within)
    return together(nearest, coefficient, *stays, fails)
