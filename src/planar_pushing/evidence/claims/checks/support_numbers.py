"""Numbers of any slider that the ledger can name: lengths in units of a, forces of W, angles in degrees."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified.balls import in_degrees, rational
from planar_pushing.certified.effects.under import Moved, under
from planar_pushing.certified.potential import direction
from planar_pushing.certified.potential.resistance import (
    Effect,
    Friction,
    Inertia,
    Resistance,
    Scene,
    resistance,
)
from planar_pushing.certified.setting import Effects
from planar_pushing.certified.supports.pressure.pieces import pieces
from planar_pushing.evidence.claims.registry import quantity
from planar_pushing.evidence.claims.verdicts import Fails

#: Share of a foot of a regular tripod.
_FOOT = fmpq(1, 3)
RING = pieces({"shape": "ring", "radius": 1.0})
#: Degrees from the rod within which the chord of the limit curve bounds the force of the L, and degrees
#: between force and motion below which the two count as parallel.
_GAP, _FLAT = fmpq(1, 2), 2.0**-20
#: Length of a step, as a fraction of the angle between force and motion.
_STRIDE = 0.9
#: An L of two equal legs about its center of pressure, not symmetric about any line along or across a leg.
L_CORNERS = ((-5, -5), (7, -5), (7, 1), (1, 1), (1, 7), (-5, 7))
L_SHAPE = pieces({"shape": "polygon", "vertices": L_CORNERS})


def _tripod() -> tuple[arb, arb]:
    """Force of the two feet that slide about the third, along its tangent, and their torque about it."""
    apart = arb(3).sqrt()
    return 2 * _FOOT * (fmpq(3, 2) / apart), 2 * _FOOT * apart


@quantity(nearest="a", farthest="a")
def tripod_offset() -> tuple[arb, arb]:
    """Offsets of a push across a foot's radius that rotate a tripod about that foot.

    A push $F$ at the offset $d$ has the torque $(1 + d) F$ about the foot, which balances the friction
    of the two other feet as they slide about it. The foot carries the rest of $F$, at most its share of
    $W$, with equality at both ends of the interval.
    """
    force, torque = _tripod()
    return torque / (force + _FOOT) - 1, torque / (force - _FOOT) - 1


@quantity("degree")
def tripod_span(rod_length: float) -> arb:
    """Interval of force angles that rotate a tripod about the foot on the rod's line.

    The component of the force across the rod balances the torque of the two feet that slide about the
    third. The component along the rod is free until the force of the third foot reaches its share of
    $W$, at both ends of the interval.
    """
    force, torque = _tripod()
    across = torque / (rational(rod_length) + 1)
    along = (_FOOT**2 - (across - force) ** 2).sqrt()
    return 2 * in_degrees((along / across).atan())


@quantity("degree")
def line_corner_span(distance: float, half_length: float) -> arb:
    """Span of the cone of a line across the fence under infinite friction.

    The span is 180 degrees plus twice $arctan(d / b)$, the angle between the fence and the motion of
    the contact about an end of the line.
    """
    half = arb.atan2(arb(rational(distance)), arb(rational(half_length)))
    return 180 + 2 * in_degrees(half)


@quantity("W")
def foot_ahead_margin(distance: float, share: float, aside: float, beyond: float) -> arb:
    """Share of a foot straight ahead less its force as the pivot under a force along the fence.

    In a rotation about the foot the contact moves along the fence. The other feet, of equal shares, lie
    at $(x, y)$ and $(-2 x, -y)$ from it and slide about it. The force along the fence balances their
    torque about the foot, and the foot carries the rest of the force, which is less than its share.
    """
    own, x, y = rational(share), rational(aside), rational(beyond)
    rest, places = (1 - own) / 2, [(x, y), (-2 * x, -y)]
    sizes = [arb(x * x + y * y).sqrt() for x, y in places]
    slides = [(y / size, x / size) for (x, y), size in zip(places, sizes, strict=True)]
    push = (sizes[0] + sizes[1]) / rational(distance)
    along, across = push + slides[0][0] + slides[1][0], slides[0][1] + slides[1][1]
    return own - rest * (along * along + across * across).sqrt()


@quantity("1")
def constant_of_rectangle(aspect: float) -> arb:
    """The mean distance from the center, by triangles on the edges, divided by half the diagonal."""
    long, short = arb(rational(aspect)), arb(1)
    diagonal = (long**2 + short**2).sqrt()
    first, second = (
        one**3 * (other / one).asinh() + one * other * diagonal
        for one, other in ((long, short), (short, long))
    )
    return (first + second) / (6 * long * short * diagonal)


@quantity("1")
def constant_of_annulus(hole: float) -> arb:
    """Integration constant of an annulus.

    The mean distance from the center is $(2 / 3) (1 + q + q^2) / (1 + q)$ outer radii, where $q$ is the
    ratio of the radii.
    """
    part = rational(hole)
    return arb(fmpq(2, 3) * (1 + part + part**2) / (1 + part))


def _scene(length: fmpq, angle: float, *effects: Effect) -> Resistance:
    return resistance(Scene(length, direction.degrees(rational(angle)), effects))


def _turned(total: Resistance, turn: fmpq, power: fmpq) -> tuple[Moved, arb]:
    """Motion under a force at an angle from the rod, and the angle from the force to the motion."""
    push = total.push(direction.degrees(turn))
    moved = under(total, push, power)
    x, y = moved.motion
    across, along = push.x * y - push.y * x, push.x * x + push.y * y
    return moved, in_degrees((across / along).atan())


def _l_shape(rod_length: float, rod_angle: float = 90.0) -> Resistance:
    """Friction of the L, with a rod length that is a multiple of the L's extent, rounded to a double."""
    length = rational(float(rational(rod_length) * L_SHAPE.extent))
    return _scene(length, rod_angle, Friction(L_SHAPE, fmpq(1)))


@quantity("degree")
def l_cone_right(rod_length: float, rod_angle: float) -> arb:
    """Right edge of the cone of the L under infinite friction.

    The motion under the force along the fence is enclosed in ball arithmetic with the closed forms of
    the polygon's edges; the length of the rod, a multiple of the extent, is rounded to a double.
    """
    return _turned(_l_shape(rod_length, rod_angle), -rational(rod_angle), fmpq(1))[1]


@quantity("W")
def l_force_difference(rod_length: float, turn: float) -> arb:
    """Force of the L to the right of its rod less that to the left, at an angle from the rod.

    The two forces are enclosed in ball arithmetic with the closed forms of the polygon's edges; the
    length of the rod, a multiple of the extent, is rounded to a double.
    """
    total, angle = _l_shape(rod_length), rational(turn)
    right, left = (_turned(total, side * angle, fmpq(1))[0].force for side in (-1, 1))
    return right - left


@quantity("degree")
def l_least_force_off(rod_length: float) -> arb:
    """Angle between the minimal force of the L and the direction across the rod.

    The magnitude of the force decreases with the force angle where the motion leads the force, and
    increases where the motion lags. The motion never rotates backward, so that its enclosure at one
    angle decides the sign up to the next angle. Steps from the direction of the rod and from the
    opposite one cover 180 degrees, except for a small interval that contains the minimal force and for
    half a degree about the rod, where the convex curve lies outside its chord.
    """
    total, ends = _l_shape(rod_length), (_GAP, 180 - _GAP)
    low, high = (_marched(total, end, way) for end, way in zip(ends, (1, -1), strict=True))
    bottom = _turned(total, (low + high) / 2, fmpq(1))[0].force
    top = arb.min(*(_turned(total, end, fmpq(1))[0].force for end in ends))
    if not top * arb.cos_pi_fmpq(_GAP / 180) > bottom:
        raise Fails("the force is as small along the rod")
    return abs(arb(low).union(arb(high)) - 90)


def _marched(total: Resistance, start: fmpq, way: int) -> fmpq:
    """The last angle up to which the force is known to decrease, measured from the start."""
    while (step := way * _turned(total, start, fmpq(1))[1]) > _FLAT:
        start += way * rational(_STRIDE * float(step.lower()))
    return start


@quantity("degree")
def motion_with_mass_aside(
    rod_length: float, rod_angle: float, gyration_radius: float, mass_along: float,
    mass_across: float, force_angle: float, effects: str, power: float = 1.0,
) -> arb:  # fmt: skip
    """Direction of the contact's motion with the mass center off the ring's, along and across the rod.

    The motion $bold(u)$ under a force of the direction $bold(e)$ is enclosed in ball arithmetic. Among
    the motions with a given component $bold(e) dot bold(u)$, in $W / m$, it is the one that requires no
    force across $bold(e)$.
    """
    place = rational(mass_along), rational(mass_across)
    own: dict[Effects, list[Effect]] = {
        Effects.FRICTION: [Friction(RING, fmpq(1))],
        Effects.INERTIA: [Inertia(fmpq(1), rational(gyration_radius) ** 2, place)],
    }
    own[Effects.BOTH] = own[Effects.FRICTION] + own[Effects.INERTIA]
    total = _scene(rational(rod_length), rod_angle, *own[Effects(effects)])
    force = rational(force_angle)
    return force + _turned(total, force - rational(rod_angle), rational(power))[1]
