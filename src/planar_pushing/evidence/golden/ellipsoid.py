"""Errors of the ellipsoid as a model of a support: means, and maxima at the end of a search.

Means are over the motions of `fit_ellipsoid`, which are spread over half a sphere of (v_x, v_y, a
omega) by the golden angle. The statement that no motion is worse than the one at which a maximum is
enclosed rests on the search.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from flint import arb, ctx
from scipy.optimize import minimize

from planar_pushing.certified.balls import in_degrees, norm
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import Pieces

Motion = tuple[arb, arb, arb]
#: Names of the errors of force and of motion.
KINDS = ("force", "motion")
MOTIONS = 20_000
#: Number of motions from which a maximum is searched, and initial width of the search.
STARTS, WIDTH = 4, 0.02
#: Working precision in bits.
BITS = 96


def errors(support: Pieces) -> dict[str, arb]:
    """Maximum and mean angles between the support and its ellipsoid, degrees."""
    with ctx.workprec(BITS):
        return _errors(support)


def _errors(support: Pieces) -> dict[str, arb]:
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
    """A motion from half a sphere, by the golden angle."""
    spin, turn = arb(2 * index + 1) / (2 * MOTIONS), index * arb.pi() * (3 - arb(5).sqrt())
    speed = (1 - spin * spin).sqrt()
    return speed * turn.cos(), speed * turn.sin(), spin


def _angles(support: Pieces, constant: arb, motion: Motion) -> tuple[arb, arb]:
    """Errors of force and of motion for a motion that rotates counter-clockwise."""
    v_x, v_y, spin = motion
    (x, y), extent = support.center, support.extent
    # An exact center takes a tenth of the time; it changes the motion only by a rounding error.
    c = (x - extent * v_y / spin).mid(), (y + extent * v_x / spin).mid()
    now = moments(support, c)
    about = spin * (c[1] - y) / extent, spin * (x - c[0]) / extent, spin
    wrench = -now.y, now.x, now.torque(c, (x, y)) / extent
    return _from_ellipsoid(constant, about, wrench)


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
    """Error at the motion where a search from the given motion ends."""
    x, y, z = map(float, _spread(start))
    flat = math.hypot(x, y)
    one, other = (-y / flat, x / flat, 0.0), (-x * z / flat, -y * z / flat, flat)

    def error(place: Sequence[float]) -> arb:
        near = [
            c + place[0] * a + place[1] * b for c, a, b in zip((x, y, z), one, other, strict=True)
        ]
        size = math.copysign(math.hypot(*near), near[2])
        v_x, v_y, spin = (arb(each) / size for each in near)
        return _angles(support, constant, (v_x, v_y, spin))[kind]

    return _largest(error, [0.0, 0.0], WIDTH)


def _about_foot(support: Pieces, constant: arb, kind: int, foot: int) -> arb:
    """Maximum error of rotations about a foot, with full friction there in any direction."""
    place, share = support.points[foot].place, support.points[foot].share
    x, y = (a - b for a, b in zip(place, support.center, strict=True))
    extent, c = support.extent, (arb(place[0]), arb(place[1]))
    now = moments(support, c)
    motion = arb(y) / extent, -arb(x) / extent, arb(1)

    def error(turn: Sequence[float]) -> arb:
        s, t = arb(turn[0]).sin_cos()
        own = share * t, share * s
        torque = now.torque(c, support.center) + x * own[1] - y * own[0]
        wrench = -now.y + own[0], now.x + own[1], torque / extent
        return _from_ellipsoid(constant, motion, wrench)[kind]

    starts = ([math.pi * i / 8] for i in range(16))
    return _largest(error, max(starts, key=lambda each: float(error(each))), 0.2)


def _largest(error: Callable[[Sequence[float]], arb], start: list[float], width: float) -> arb:
    """Error at the place where the Nelder-Mead method from the given start ends."""
    simplex = [
        start,
        *([c + width * (i == j) for j, c in enumerate(start)] for i in range(len(start))),
    ]
    found = minimize(
        lambda place: -float(error(place.tolist())), start, method="Nelder-Mead",
        options={"initial_simplex": simplex, "xatol": 1e-14, "fatol": 1e-16, "maxfev": 1000},
    )  # fmt: skip
    return error(found.x.tolist())
