"""Force and torque about the contact that sustain a motion, and their derivatives.

A motion is a scale times a unit motion, which consists of the motion of the contact along `t` and the
rotation `spin`. Friction depends only on the unit motion, inertia on both. Body frame.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from functools import lru_cache, reduce
from typing import NamedTuple

from flint import arb, ctx

from planar_pushing.certified.balls import Undecided, norm, unit
from planar_pushing.certified.potential.resistance import Resistance
from planar_pushing.certified.supports.pressure.moments import Moments, Vector, moments
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place

#: Angle between a support's velocities below which expansion about a translation gives more digits.
NEARLY = 1e-3


class Motion(NamedTuple):
    """A motion of the contact along t and a rotation, both times a scale.

    For balls of motions the center of rotation can be known more precisely than from t and spin.
    """

    t: Vector
    spin: arb
    scale: arb = arb(1)
    about: Vector | None = None


class Response(NamedTuple):
    """Force at the contact, torque about it, and the feet whose own friction is left out.

    These feet lie in the ball of the center of rotation.
    """

    x: arb
    y: arb
    torque: arb
    feet: tuple[int, ...] = ()


class Slopes(NamedTuple):
    """Derivatives of the force by contact motion and rotation, and of the torque by rotation."""

    xx: arb
    xy: arb
    yy: arb
    xs: arb
    ys: arb
    ss: arb

    def felt(self) -> tuple[arb, arb, arb]:
        """Derivatives xx, xy, yy of the force if the rotation leaves no torque."""
        x, y = self.xs / self.ss, self.ys / self.ss
        return self.xx - self.xs * x, self.xy - self.xs * y, self.yy - self.ys * y


def response(total: Resistance, motion: Motion, foot: int = -1) -> Response:
    """Force and torque of a motion; with a foot, of the rotation about it.

    Raises
    ------
    Undecided
        If the balls do not bound them.
    """
    (x, y), spin, scale = motion[:3]
    if total.weight == 0:
        own = Response(arb(0), arb(0), arb(0))
    elif spin.contains(0):
        own = _nearly_straight(total, motion)
    else:
        own = _about(total, motion, foot)
    (s_x, s_y), mass = total.first, total.mass
    return Response(
        own.x + scale * (mass * x - spin * s_y) - total.load[0],
        own.y + scale * (mass * y + spin * s_x) - total.load[1],
        own.torque + scale * (s_x * y - s_y * x + spin * total.second) - total.load[2],
        own.feet,
    )


def center(total: Resistance, motion: Motion) -> Vector:
    """Center of rotation of a motion with nonzero rotation."""
    if motion.about is not None:
        return motion.about
    return -total.length - motion.t[1] / motion.spin, motion.t[0] / motion.spin


def _about(total: Resistance, motion: Motion, foot: int) -> Response:
    """Friction of a rotation; over wide balls, and about distant centers, also by expansions."""
    _, feet = _seen(total, motion, foot)
    if feet or (_is_narrow(motion) and _straightness(total, motion)[2] > NEARLY):
        return _by_moments(total, motion, foot)
    every = [_nearly_straight(total, motion)]
    with suppress(Undecided):
        every.append(_by_moments(total, motion, foot))
    with suppress(Undecided):
        every.append(_expanded(total, motion))
    return Response(
        _common(each.x for each in every),
        _common(each.y for each in every),
        _common(each.torque for each in every),
    )


def _is_narrow(motion: Motion) -> bool:
    x, y = motion.t
    return min(int(each.rel_accuracy_bits()) for each in (norm(x, y), motion.spin)) > ctx.prec // 4


def _by_moments(total: Resistance, motion: Motion, foot: int) -> Response:
    weight, sense = total.weight, 1 if motion.spin > 0 else -1
    c, feet = _seen(total, motion, foot)
    now = moments(_without(total.support, feet), c)
    torque = now.torque(c, (-total.length, arb(0)))
    return Response(-sense * weight * now.y, sense * weight * now.x, sense * weight * torque, feet)


def _expanded(total: Resistance, motion: Motion) -> Response:
    """Friction by the mean value theorem about the middle of the ball of the center of rotation."""
    weight, sense = total.weight, 1 if motion.spin > 0 else -1
    c = center(total, motion)
    middle = c[0].mid(), c[1].mid()
    start, over = moments(total.support, middle), moments(total.support, c)
    d = c[0] - middle[0], c[1] - middle[1]
    x, y = _product(over, d)
    lever = _product(over, (c[0] + total.length, c[1]))
    torque = start.torque(middle, (-total.length, arb(0))) - lever[0] * d[0] - lever[1] * d[1]
    return Response(
        -sense * weight * (start.y - y), sense * weight * (start.x - x), sense * weight * torque
    )


def _common(balls: Iterable[arb]) -> arb:
    """The intersection of the balls that are finite."""
    found = [each for each in balls if each.is_finite()]
    if not found:
        raise Undecided("friction over a ball too wide")
    return reduce(arb.intersection, found)


def _seen(total: Resistance, motion: Motion, foot: int) -> tuple[Vector, tuple[int, ...]]:
    """Center of rotation, and the feet where it can be."""
    if foot >= 0:
        x, y = total.support.points[foot].place
        return (arb(x), arb(y)), (foot,)
    c = center(total, motion)
    feet = [i for i, each in enumerate(total.support.points) if _overlap(c, each.place)]
    return c, tuple(feet)


def _overlap(c: Vector, place: Place) -> bool:
    return bool(c[0].overlaps(arb(place[0])) and c[1].overlaps(arb(place[1])))


@lru_cache(maxsize=256)
def _without(support: Pieces, feet: tuple[int, ...]) -> Pieces:
    """A support without some of its points; the remaining shares sum to less than 1."""
    if not feet:
        return support
    points = tuple(each for i, each in enumerate(support.points) if i not in feet)
    lines, circles = (support.segments, support.edges), (support.rings, support.discs)
    return Pieces(points, lines[0], *circles, lines[1])


def _straightness(total: Resistance, motion: Motion) -> tuple[arb, arb, arb]:
    """Speed of the contact, reach of the support from it, and largest angle of its velocities from t.

    The direction of a velocity v close to u differs by at most ``2 |v - u| / |u|`` from that of u.
    """
    (x, y), spin = motion.t, motion.spin
    speed, (p_x, p_y) = norm(x, y), total.pressure
    reach = (total.support.extent + arb(p_x * p_x + p_y * p_y).sqrt()).upper()
    return speed, reach, (2 * abs(spin) * reach / speed).upper()


def _nearly_straight(total: Resistance, motion: Motion) -> Response:
    """Friction of a translation, and of motions close to it, by the first derivatives there.

    The second derivative of the direction of ``u + omega J r`` by omega is at most ``3 r^2 / speed^2``.
    """
    (x, y), weight, (p_x, p_y) = motion.t, total.weight, total.pressure
    speed, reach, turn = _straightness(total, motion)
    e_x, e_y, least = unit(x / speed), unit(y / speed), 1 - turn / 2
    off = (
        arb(0, arb.min(turn, 3 * turn * turn / (8 * least * least)).upper())
        if least > 0
        else arb(0, 2)
    )
    rate = motion.spin / speed if least > 0 else arb(0)
    (xx, xy, yy), own = _second(total), e_x * p_x + e_y * p_y
    torque = p_x * e_y - p_y * e_x + rate * (e_x * e_x * xx + 2 * e_x * e_y * xy + e_y * e_y * yy)
    return Response(
        weight * (e_x - rate * e_y * own + off),
        weight * (e_y + rate * e_x * own + off),
        weight * (torque + reach * off),
    )


def slopes(total: Resistance, motion: Motion, foot: int = -1) -> Slopes:
    """Derivatives at a motion, times its scale; infinite or NaN where they do not exist."""
    own = Slopes(*[arb(0)] * 6)
    if total.weight != 0:
        straight = motion.spin.contains(0)
        own = _bent_straight(total, motion) if straight else _bent(total, motion, foot)
    (s_x, s_y), mass, scale = total.first, total.mass, motion.scale
    return Slopes(
        own.xx + scale * mass, own.xy, own.yy + scale * mass,
        own.xs - scale * s_y, own.ys + scale * s_x, own.ss + scale * total.second,
    )  # fmt: skip


def _bent(total: Resistance, motion: Motion, foot: int) -> Slopes:
    """Derivatives of the friction of a rotation, from the second derivatives of D at its center."""
    c, feet = _seen(total, motion, foot)
    if feet and foot < 0:
        return Slopes(*[arb.nan()] * 6)
    now = moments(_without(total.support, feet), c)
    rate = total.weight / abs(motion.spin)
    x, y = c[0] + total.length, c[1]
    to_x, to_y = _product(now, (x, y))
    return Slopes(
        rate * now.yy, -rate * now.xy, rate * now.xx,
        -rate * to_y, rate * to_x, rate * (x * to_x + y * to_y),
    )  # fmt: skip


def _product(now: Moments, v: Vector) -> Vector:
    return now.xx * v[0] + now.xy * v[1], now.xy * v[0] + now.yy * v[1]


def _bent_straight(total: Resistance, motion: Motion) -> Slopes:
    """Derivatives near a translation, where they are the mean of ``(n, t . r) (n, t . r)^T / speed``."""
    (x, y), weight = motion.t, total.weight
    speed, reach, turn = _straightness(total, motion)
    least = speed - reach * abs(motion.spin).upper()
    if not least > 0:
        return Slopes(*[arb.nan()] * 6)
    t_x, t_y = x / speed, y / speed
    (p_x, p_y), (xx, xy, yy) = total.pressure, _second(total)
    own, across = t_x * p_x + t_y * p_y, t_x * t_x * xx + 2 * t_x * t_y * xy + t_y * t_y * yy
    # Bounds on the change of a product of two factors, and on 1 / speed minus that of the contact.
    turned, slower = (2 + turn) * turn, reach * abs(motion.spin).upper() / (speed * least)
    off = arb(0, (turned / speed + (1 + turn) ** 2 * slower).upper())
    return Slopes(
        weight * (t_y * t_y / speed + off),
        weight * (-t_x * t_y / speed + off),
        weight * (t_x * t_x / speed + off),
        weight * (-t_y * own / speed + reach * off),
        weight * (t_x * own / speed + reach * off),
        weight * (across / speed + reach * reach * off),
    )


def _second(total: Resistance) -> tuple[arb, arb, arb]:
    """Second moments of the pressure about the contact."""
    (xx, xy, yy), (x, y), length = total.support.second, total.support.center, total.length
    return arb(xx + 2 * length * x + length * length), arb(xy + length * y), arb(yy)
