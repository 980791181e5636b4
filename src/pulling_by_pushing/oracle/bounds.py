"""The paper's bounds with friction and inertia: the seven-case cone and the regions of centers (Sec. 4)."""

from __future__ import annotations

from functools import reduce
from itertools import pairwise

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import (
    ZERO,
    Direction,
    Number,
    at_degrees,
    in_degrees,
    sign,
    terms,
)
from pulling_by_pushing.oracle.prove import Slider


def region_ends(slider: Slider, force: Direction, radius: fmpq) -> list[list[Number]]:
    """Ends of the bound on the region of centers under a line of force, from the contact.

    The centers lie inside the ring for a line that misses it, and outside for a line that crosses it.
    """
    length, e = slider.body.length, force.about(slider.rod_angle)
    side = e.across((length, ZERO))
    misses = e.sign(lambda x, y: (length * y) ** 2 - radius * radius * (x * x + y * y))
    inner, outer = {1: (arb.pos_inf(), arb(1)), 0: (arb(1), arb(1)), -1: (arb(1), arb(0))}[misses]
    spins = [side * inner, side * outer] if side else [arb(0), arb(0)]
    return [_center(slider, force, radius, spin, side) for spin in spins]


def _center(slider: Slider, force: Direction, radius: fmpq, spin: arb, side: int) -> list[Number]:
    """Center at a spin ratio; at infinity it lies on the side toward which the region extends."""
    length, (x, y) = slider.body.length, force.ball
    rod = [length * part for part in slider.rod]
    if not spin.is_finite():
        return [terms(part, length) for part in rod]
    if spin == 0:
        flip = -1 if side < 0 else 1
        return [
            terms(rod_part, length)
            if part.is_zero()
            else Number(arb.pos_inf() * flip * part.sgn(), arb(0))
            for rod_part, part in zip(rod, (-y, x), strict=True)
        ]
    parts, turn = (-y * radius / spin, x * radius / spin), force.roundings
    return [
        terms(rod_part + part, rod_part, part, turn * radius / spin, turn * length)
        for rod_part, part in zip(rod, parts, strict=True)
    ]


def conservative_cone(slider: Slider, radius: fmpq) -> tuple[Number, Number]:
    """Right and left edge, in degrees, of the motions that the seven cases allow under infinite friction.

    Between two neighboring tangents of the ring the case does not change: |k| is in [0, 1] where the
    lines of force cross the ring, and in [1, inf] where they miss it. At a fixed spin ratio the angle of
    the motion increases with the force angle, and at a fixed force angle it is monotone in the spin
    ratio. Each sector is therefore bounded by its values at the ends.
    """
    length, right, left = slider.body.length / radius, arb(0), arb(180)
    angles = [right, *_tangents(slider, length), left]
    rights, lefts = [], []
    for first, last in pairwise(angles):
        # Not midway: a sector between tangents is symmetric about the rod, where the arm vanishes.
        from_force = slider.rod_angle - (3 * first + 5 * last) / 8
        misses = sign(length * abs((from_force / 180).sin_pi()) - 1) > 0
        for spin in (arb(1), arb.pos_inf()) if misses else (arb(0), arb(1)):
            rights.append(_angle(slider.rod_angle, length, first, spin))
            lefts.append(_angle(slider.rod_angle, length, last, spin))
    return terms(reduce(arb.min, rights), 180), terms(reduce(arb.max, lefts), 180)


def _tangents(slider: Slider, length: fmpq) -> list[arb]:
    """Angles of the lines of force tangent to the ring, between the edges and in order."""
    if length <= 1:
        return []
    half = in_degrees((1 / arb(length)).asin())
    angles = [
        slider.rod_angle + turn + side * half for turn in (-360, -180, 0, 180) for side in (-1, 1)
    ]
    fence = at_degrees(fmpq(0)).about(slider.rod_angle)
    if fence.sign(lambda x, y: (length * y) ** 2 - (x * x + y * y)) == 0:  # one of them is an edge
        angles = [angle for angle in angles if not (angle.contains(0) or angle.contains(180))]
    return [angle for angle in angles if sign(angle) > 0 > sign(angle - 180)]


def _angle(rod_angle: fmpq, length: fmpq, force: arb, size: arb) -> arb:
    """Angle of the motion at a spin ratio of this magnitude; infinite: rotation about the ring's center."""
    from_force = (rod_angle - force) / 180
    cosine, sine = from_force.cos_pi(), from_force.sin_pi()
    side = 0 if length == 0 or sine.is_zero() else sign(sine)
    if not size.is_finite():
        return force if side == 0 else arb(rod_angle - side * fmpq(90))
    spin_length = side * size * length
    return force - in_degrees((spin_length * cosine / (1 + spin_length * sine)).atan())
