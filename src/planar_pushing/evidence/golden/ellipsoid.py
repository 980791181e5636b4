"""Errors of the ellipsoid in place of a support: means enclosed, maxima enclosed where a search ends.

Means are over the motions that `fit_ellipsoid` names: spread over half a sphere of (v_x, v_y, a omega) by the
golden angle. That no motion is worse than the one at which a maximum is enclosed rests on the search.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from functools import partial

from flint import arb, ctx

from planar_pushing.certified.balls import in_degrees, norm
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import Pieces

Motion = tuple[arb, arb, arb]
#: Names of the errors of force and of motion.
KINDS = ("force", "motion")
MOTIONS = 20_000
#: Motions from which a maximum is searched, directions of a step, the first step and the last, and the
#: least gain of a step, in radians.
STARTS, AROUND, FIRST, LAST, GAIN = 4, 8, 0.02, 1e-13, 1e-15
#: Bits of the search.
COARSE = 64


def errors(support: Pieces) -> dict[str, arb]:
    """Worst and mean angles between the support and its ellipsoid, degrees."""
    x, y = (arb(each) for each in support.center)
    constant = moments(support, (x, y)).distance / support.extent
    rows = [_angles(support, constant, each) for each in map(_spread, range(MOTIONS))]
    found = {}
    for i, kind in enumerate(KINDS):
        found[f"mean_{kind}_error"] = in_degrees(sum((row[i] for row in rows), arb(0)) / MOTIONS)
        ranked = sorted(range(MOTIONS), key=lambda n: -float(rows[n][i]))[:STARTS]
        every = [_climbed(support, constant, i, n) for n in ranked]
        every += [_about_foot(support, constant, i, foot) for foot in range(len(support.points))]
        found[f"worst_{kind}_error"] = in_degrees(max(every, key=float))
    return found


def _spread(index: int) -> Motion:
    """A motion of half a sphere, by the golden angle."""
    spin, turn = arb(2 * index + 1) / (2 * MOTIONS), index * arb.pi() * (3 - arb(5).sqrt())
    speed = (1 - spin * spin).sqrt()
    return speed * turn.cos(), speed * turn.sin(), spin


def _angles(support: Pieces, constant: arb, motion: Motion) -> tuple[arb, arb]:
    """Angles of force and of motion at a motion that turns counter-clockwise."""
    v_x, v_y, spin = motion
    x, y = support.center
    extent = support.extent
    c = x - extent * v_y / spin, y + extent * v_x / spin
    now = moments(support, c)
    wrench = -now.y, now.x, now.torque(c, (x, y)) / extent
    return _from_ellipsoid(constant, motion, wrench)


def _from_ellipsoid(constant: arb, motion: Motion, wrench: Motion) -> tuple[arb, arb]:
    square = constant * constant
    (a, b, c), (d, e, f) = motion, wrench
    return _angle(wrench, (a, b, square * c)), _angle(motion, (d, e, f / square))


def _angle(a: Motion, b: Motion) -> arb:
    cross = (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
    dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return arb.atan2(norm(norm(cross[0], cross[1]), cross[2]), dot)


def _climbed(support: Pieces, constant: arb, kind: int, start: int) -> arb:
    """Error at the motion to which steps from a motion climb."""

    def error(place: tuple[float, ...]) -> arb:
        size = math.copysign(math.hypot(*place), place[2])
        v_x, v_y, spin = (arb(each) / size for each in place)
        return _angles(support, constant, (v_x, v_y, spin))[kind]

    return _steps(error, tuple(map(float, _spread(start))), FIRST)


def _about_foot(support: Pieces, constant: arb, kind: int, foot: int) -> arb:
    """Largest error of rotations about a foot, with full friction there in any direction."""
    place, share = support.points[foot].place, support.points[foot].share
    x, y = (a - b for a, b in zip(place, support.center, strict=True))
    extent, c = support.extent, (arb(place[0]), arb(place[1]))
    now = moments(support, c)
    motion = arb(y) / extent, -arb(x) / extent, arb(1)

    def error(turn: tuple[float, ...]) -> arb:
        s, t = arb(turn[0]).sin_cos()
        own = share * t, share * s
        torque = now.torque(c, support.center) + x * own[1] - y * own[0]
        wrench = -now.y + own[0], now.x + own[1], torque / extent
        return _from_ellipsoid(constant, motion, wrench)[kind]

    starts = [(math.pi * i / 8,) for i in range(16)]
    with ctx.workprec(COARSE):
        best = max(starts, key=lambda each: float(error(each)))
    return _steps(error, best, 0.2)


def _steps(error: Callable[[tuple[float, ...]], arb], at: tuple[float, ...], step: float) -> arb:
    """Error where steps to larger errors end, which are halved where none leads there."""
    with ctx.workprec(COARSE):
        here = float(error(at))
        while step > LAST:
            tried = max(_beside(at, step), key=lambda each: float(error(each)))
            there = float(error(tried))
            if there > here + GAIN:
                at, here = tried, there
            else:
                step /= 2
    return error(at)


def _beside(at: tuple[float, ...], step: float) -> Iterable[tuple[float, ...]]:
    """Places at a distance."""
    if len(at) == 1:
        return [(at[0] - step,), (at[0] + step,)]
    return map(partial(_moved, at, step), range(AROUND))


def _moved(at: tuple[float, ...], step: float, i: int) -> tuple[float, ...]:
    """A place at a distance on the sphere, in one of several directions."""
    x, y, z = at
    size = math.hypot(x, y, z)
    turn, flat = 2 * math.pi * i / AROUND, math.hypot(x, y) or 1.0
    one = (-y / flat, x / flat, 0.0) if x or y else (1.0, 0.0, 0.0)
    other = (
        (y * one[2] - z * one[1]) / size,
        (z * one[0] - x * one[2]) / size,
        (x * one[1] - y * one[0]) / size,
    )
    c, s = step * math.cos(turn), step * math.sin(turn)
    return x + c * one[0] + s * other[0], y + c * one[1] + s * other[1], z + c * one[2] + s * other[2]
