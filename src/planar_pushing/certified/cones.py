"""Motion cones and the paper's seven-case bound, enclosed; flags decided, ties by exact arithmetic."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial, reduce
from itertools import pairwise
from operator import getitem

from flint import arb, fmpq

from planar_pushing.certified.balls import in_degrees, precise, sign
from planar_pushing.certified.line_of_force import (
    exact_contact_motion,
    motion_angle,
    motion_degrees,
)
from planar_pushing.certified.setting import Effects, Heading, Slider, direction, edge, lean


@dataclass(frozen=True, slots=True)
class Cone:
    """Edges in degrees, unwrapped: right <= left."""

    right: arb
    left: arb


def friction_cone(friction_coefficient: float) -> Cone:
    """Edges of the friction cone."""
    return Cone(edge(friction_coefficient, 1).degrees, edge(friction_coefficient, -1).degrees)


@precise
def motion_cone(slider: Slider, effects: Effects, friction_coefficient: float) -> Cone:
    """Edges of the motion cone; with friction and inertia, of the union over all magnitudes."""
    right, left = (edge(friction_coefficient, side) for side in (1, -1))
    rights = [motion_angle(slider, right, share) for share in effects.shares]
    lefts = [motion_angle(slider, left, share) for share in effects.shares]
    return Cone(reduce(arb.min, rights), reduce(arb.max, lefts))


def _normal_signs(
    slider: Slider, effects: Effects, friction_coefficient: float, side: int
) -> list[int]:
    """Signs of the normal component of the contact's motion under an edge, one per share.

    The motion lies within 90 degrees of the force, so that its angle determines the sign, by comparison
    with 0 on the right edge (side 1) and with 180 on the left edge (side -1).
    """
    force, signs = edge(friction_coefficient, side), []
    for share in effects.shares:
        angle = motion_angle(slider, force, share)
        motion = exact_contact_motion(slider, force, share)
        normal = None if motion is None else partial(getitem, motion, 1)
        signs.append(sign(angle if side > 0 else 180 - angle, normal))
    return signs


@precise
def pulls(slider: Slider, effects: Effects, friction_coefficient: float) -> bool:
    """Whether some sticking motion leads away from the slider."""
    sides = (_normal_signs(slider, effects, friction_coefficient, side) for side in (1, -1))
    return any(min(signs) < 0 for signs in sides)


@precise
def slips_while_pushing(slider: Slider, effects: Effects, friction_coefficient: float) -> bool:
    """Whether some pusher motion into the slider lies outside the motion cone."""
    sides = (_normal_signs(slider, effects, friction_coefficient, side) for side in (1, -1))
    return any(min(signs) > 0 for signs in sides)


@precise
def conservative_cone(slider: Slider, friction_coefficient: float = math.inf) -> Cone:
    """Contact motions that the paper's seven cases allow with both effects (Sec. 4, Fig. 12).

    Between two neighboring tangents of the ring the case does not change: |k| is in [0, 1] where the
    lines of force cross the ring, and in [1, inf] where they miss it. At a fixed spin ratio the angle
    of the motion increases with the force angle, and at a fixed force angle it is monotone in the spin
    ratio. Each sector is therefore bounded by its values at the ends.
    """
    right, left = (edge(friction_coefficient, side) for side in (1, -1))
    bounds = [right, *_tangents(slider, right, left), left]
    rights, lefts = [], []
    for first, last in pairwise(bounds):
        misses = sign(_arm_between(slider, first, last) - 1) > 0
        ends = (arb(1), arb.pos_inf()) if misses else (arb(0), arb(1))
        rights += [_angle(slider, first, end) for end in ends]
        lefts += [_angle(slider, last, end) for end in ends]
    return Cone(reduce(arb.min, rights), reduce(arb.max, lefts))


def _tangents(slider: Slider, right: Heading, left: Heading) -> list[Heading]:
    """Directions of the lines of force tangent to the ring, between the edges and in order."""
    if slider.rod_length <= 1:
        return []
    half = in_degrees((1 / arb(slider.rod_length)).asin())
    found = [
        slider.rod_angle + turn + side * half for turn in (-360, -180, 0, 180) for side in (-1, 1)
    ]
    inside = [each for each in found if sign(each - right.degrees) > 0 > sign(each - left.degrees)]
    return [direction(degrees) for degrees in inside]


def _arm_between(slider: Slider, first: Heading, last: Heading) -> arb:
    # Not midway: a sector between tangents is symmetric about the rod, where the arm vanishes.
    inside = direction((3 * first.degrees + 5 * last.degrees) / 8)
    return slider.rod_length * abs(lean(slider, inside)[1])


def _angle(slider: Slider, force: Heading, size: arb) -> arb:
    """Angle of the motion at a spin ratio of this magnitude; infinite: rotation about the ring center."""
    _, sine = lean(slider, force)
    side = 0 if slider.rod_length == 0 else sign(sine)
    if size.is_finite():
        return motion_degrees(slider, force, side * size)
    return force.degrees if side == 0 else arb(slider.rod_angle - side * fmpq(90))
