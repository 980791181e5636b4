"""Slips: the force is on an edge of the friction cone, and the contact keeps up with the fence.

One effect leaves one motion under a line of force, so that every slip is decided. With both, the centre's
speed is ``v = W (h f - t) / (m (g k - h))`` and its normal motion ``v (A - B k)`` need not be monotone: a
motion that is there is verified, and how many there are is certified on the golden sample.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats, doubled
from planar_pushing.certified.doubled.ring import wrench
from planar_pushing.evidence.golden.residual.contact_modes.push import Decision, Flags, Pushes
from planar_pushing.evidence.golden.residual.finding import EPSILON
from planar_pushing.evidence.golden.residual.motion import edge, line_on_edge
from planar_pushing.evidence.golden.residual.spin import spin_ratio, steady

#: Roundings of a slip, whose speed is a quotient of differences.
_SLIP = 1e4


class Edge(NamedTuple):
    """Lines of force on one edge, over contact and rod length: direction, moment arm, reach of the rod."""

    x: Doubled
    y: Doubled
    arm: Doubled
    reach_x: Doubled
    reach_y: Doubled

    def motion(self, k: Any) -> tuple[Doubled, Doubled]:
        """Contact's motion per speed of the center (Eqs. 11-12)."""
        return self.x + self.reach_x * k, self.y - self.reach_y * k

    def over(self, shape: tuple[int, ...], place: Any) -> Edge:
        """The lines at places of an array."""
        return Edge(*(_broadcast(each, shape)[place] for each in self))


def _broadcast(number: Doubled, shape: tuple[int, ...]) -> Doubled:
    return Doubled(np.broadcast_to(number.high, shape), np.broadcast_to(number.low, shape))


def edge_of(pushes: Pushes, side: int) -> Edge:
    """Lines of force on an edge of the laws' friction cones."""
    line = line_on_edge(pushes.rod_angle, pushes.friction, side)
    cosine, sine = cosine_sine(radians(pushes.rod_angle))
    reach = doubled(pushes.length)
    return Edge(
        *edge(pushes.friction, side), line.aside * pushes.length, reach * sine, reach * cosine
    )


def steady_slips(pushes: Pushes, lines: Edge, k: Doubled, side: int) -> Decision:
    """Where one effect lets the contact slip: it moves with the fence, and over it to its side."""
    x, y = lines.motion(k)
    size = (x * x + y * y).sqrt()
    normal = (y / size).value()
    turn = ((x * pushes.y - y * pushes.x) / size).value()
    along = np.sign(normal) * np.sign(pushes.y.high)
    found = pushes.slips & (along > 0) & (np.sign(normal) * turn * side < 0)
    near = (np.abs(normal) <= pushes.near) | ((np.abs(turn) <= pushes.near) & (along > 0))
    return Decision(found, near & pushes.slips & (pushes.y.high != 0))


def steady_spin(effects: str, pushes: Pushes, lines: Edge) -> Doubled:
    """Spin ratio of one effect on an edge."""
    return spin_ratio(steady(effects, pushes.slider), pushes.slider, lines.arm)


class Slips(NamedTuple):
    """Slips with both effects: residuals, and whether the motion goes with the fence and to its side."""

    error: Floats
    goes: Flags


def slips(
    pushes: Pushes, lines: Edge, k: Floats, push: tuple[Doubled, Doubled], side: int
) -> Slips:
    """Put spin ratios into ``W (h f - t) (A - B k) = m (g k - h) w_y``.

    `push` is the pusher's motion along x and y; all arrays have one shape.
    """
    weight, mass, gyration = pushes.slider
    force, torque = wrench(np.abs(k))
    carried, torque = lines.arm * force, torque * np.where(k < 0, -1.0, 1.0)
    surplus, lag = (carried - torque) * weight, (doubled(k) * gyration - lines.arm) * mass
    x, y = lines.motion(k)
    friction = weight * (np.abs(carried.high) + np.abs(torque.high))
    reach = np.abs(lines.y.high) + np.abs(lines.reach_y.high * k)
    inertia = mass * (np.abs(gyration * k) + np.abs(lines.arm.high))
    scale = friction * reach + inertia * np.abs(push[1].high)
    error = np.abs((surplus * y - lag * push[1]).value()) / np.where(scale > 0, scale, 1.0)
    settles = np.abs(lag.high) <= 16 * EPSILON * inertia
    return Slips(error, _goes(_speed(surplus, lag, settles, y, push[1]), x, push[0], side))


def _speed(
    surplus: Doubled, lag: Doubled, still: Flags, normal: Doubled, pushed: Doubled
) -> Floats:
    """Speed of the center; where friction and inertia agree on k, that which keeps up with the fence."""
    with np.errstate(divide="ignore", invalid="ignore"):
        steady, driven = pushed.high / normal.high, surplus.high / np.where(still, 1.0, lag.high)
    return np.asarray(np.where(still, steady, driven))


def _goes(speed: Floats, x: Doubled, pushed: Doubled, side: int) -> Flags:
    """Whether the slider moves, and slips to the side opposite to that of its edge."""
    slip = (x * speed - pushed).high
    rounding = _SLIP * EPSILON * (np.abs(speed * x.high) + np.abs(pushed.high))
    return np.asarray((speed > 0) & (slip * side < rounding))
