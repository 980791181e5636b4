"""Numbers that the ledger can name: lengths in units of R, forces of W, angles in degrees."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from flint import arb, fmpq

from pulling_by_pushing.evidence.proofs.mechanics import BOTH, ONE, Mechanics, Pair, Scene, Triple
from pulling_by_pushing.evidence.proofs.registry import number
from pulling_by_pushing.evidence.proofs.verdicts import Fails
from pulling_by_pushing.oracle.balls import cross, dot, in_degrees, norm, rational

RING = Scene()
#: Halvings of the interval that contains a root.
ROOT_HALVINGS = 96
#: Degrees from the rod within which the chord of the limit curve bounds the force; degrees between force
#: and motion below which the two count as parallel; length of a step over the angle between them.
_GAP, _FLAT, _STRIDE = fmpq(1, 2), 2.0**-20, 0.9


def root(function: Callable[[fmpq], arb], low: fmpq, high: fmpq) -> arb:
    """Enclose the only zero of a function between two points at which it has opposite signs."""
    side = 1 if function(high) > 0 else -1
    if not (side * function(low) < 0 < side * function(high)):
        raise Fails(f"no change of sign between {float(low):g} and {float(high):g}")
    last = high
    for _ in range(ROOT_HALVINGS):
        middle = (low + last) / 2
        low, last = (middle, last) if side * function(middle) < 0 else (low, middle)
    step = last - low
    while not side * function(last) > 0:
        last, step = min(last + step, high), 2 * step
    return arb(low).union(arb(last))


def turn(mechanics: Mechanics, scene: Scene, force_angle: fmpq, power: fmpq = ONE) -> arb:
    """Angle from the force to the motion of the contact; it is below 90 degrees."""
    e = scene.in_rod_frame(force_angle)
    u = mechanics.motion(scene, force_angle, power)[:2]
    return in_degrees((cross(e, u) / dot(e, u)).atan())


def force(mechanics: Mechanics, scene: Scene, force_angle: fmpq) -> arb:
    """Magnitude of the force that moves the slider."""
    wrench = mechanics.wrench(scene, mechanics.motion(scene, force_angle, ONE))
    size: arb = dot(scene.in_rod_frame(force_angle), wrench[:2])
    return size


def friction(mechanics: Mechanics, k: arb) -> Pair:
    """Force f and torque t of the ring; f decreases with k and t increases."""
    ends = (k,) if k.is_exact() else (k.lower(), k.upper())
    wrenches = [mechanics.wrench(RING, (1, 0, end)) for end in ends]
    first, last = wrenches[0], wrenches[-1]
    return first[0].union(last[0]), first[2].union(last[2])


@number(right="degree", left="degree", half_angle="degree")
def friction_cone(mechanics: Mechanics, scene: Scene) -> tuple[arb, arb, arb]:
    """Edges and half-angle of the friction cone."""
    right, left = mechanics.friction_cone(scene)
    return right, left, (left - right) / 2


@number(right="degree", left="degree")
def motion_cone(mechanics: Mechanics, scene: Scene) -> Pair:
    """Right and left edge; with both effects, bounds over all magnitudes."""
    return mechanics.motion_cone(scene)


@number(right="degree", left="degree", right_gap="degree", left_gap="degree")
def bound_of_the_cases(mechanics: Mechanics, scene: Scene) -> tuple[arb, arb, arb, arb]:
    """Fig. 12: the cone that the seven cases allow, and its gaps to the exact cone."""
    right, left = mechanics.bound_of_the_cases(scene)
    exact = mechanics.motion_cone(replace(scene, effects=BOTH))
    gaps = exact[0] - right, left - exact[1]
    if not all(gap > 0 for gap in gaps):
        raise Fails("the bound does not contain the exact cone")
    return right, left, *gaps


@number("R")
def moment_arm(mechanics: Mechanics, scene: Scene, force_angle: float) -> arb:
    """Moment arm of a force at the contact about the slider's center, from the forces on the slider."""
    degrees = rational(force_angle)
    f_x, f_y, torque = mechanics.wrench(scene, mechanics.motion(scene, degrees, ONE))
    return (torque - rational(scene.rod_length) * f_y) / norm(f_x, f_y)


@number(spin_ratio="1", angle="degree")
def motion(mechanics: Mechanics, scene: Scene, force_angle: float, power: float = 1.0) -> Pair:
    """Motion under a line of force."""
    degrees, size = rational(force_angle), rational(power)
    u_x, u_y, omega = mechanics.motion(scene, degrees, size)
    spin = omega / norm(u_x, u_y + omega * rational(scene.rod_length))
    return spin, degrees + turn(mechanics, scene, degrees, size)


@number("W")
def force_difference(mechanics: Mechanics, scene: Scene, turn: float) -> arb:
    """Force to the right of the rod less that to the left, at an angle from it."""
    rod, angle = rational(scene.rod_angle), rational(turn)
    return force(mechanics, scene, rod - angle) - force(mechanics, scene, rod + angle)


def _along_fence(mechanics: Mechanics, scene: Scene) -> arb:
    """The force angle below the rod's at which the contact moves along the fence."""
    return root(
        lambda degrees: degrees + turn(mechanics, scene, degrees),
        fmpq(0),
        rational(scene.rod_angle),
    )


@number("R")
def pulling_offset(mechanics: Mechanics, scene: Scene) -> arb:
    """Offset on the right of the center beyond which the contact moves away."""
    from_rod = rational(scene.rod_angle) - _along_fence(mechanics, scene)
    return rational(scene.rod_length) * (from_rod / 180).sin_pi()


@number("1")
def pulling_coefficient(mechanics: Mechanics, scene: Scene) -> arb:
    """Coefficient of friction beyond which the fence pulls."""
    return (_along_fence(mechanics, scene) / 180).cot_pi()


@number("degree")
def force_angle(
    mechanics: Mechanics, scene: Scene, pusher_angle: float, mode: str, magnitude: float = 1.0
) -> arb:
    """Angle of the force in the only solution of a contact mode."""
    angles = [f for name, f in mechanics.modes(scene, pusher_angle, magnitude) if name == mode]
    if len(angles) != 1 or angles[0] is None:
        raise Fails(f"{len(angles)} solutions of the mode {mode}")
    return angles[0]


@number("1")
def ellipse_shortfall(mechanics: Mechanics, scene: Scene) -> arb:
    """Largest radial distance inside the ellipse with the same extrema, as a fraction of its radius."""
    length = rational(scene.rod_length)

    def difference(k: fmpq, by_torque: fmpq | arb, by_force: fmpq) -> arb:
        f, t = friction(mechanics, arb(k))
        return by_torque * t - by_force * f

    end = root(lambda k: difference(k, ONE, length), length / 4, 4 * length)
    squeeze = (1 / friction(mechanics, end)[0] ** 2 - 1) / arb(length) ** 2

    def spin_ratio_at(size: arb) -> arb:
        return root(lambda k: difference(k, size, k), fmpq(1, 2**20), rational(float(end)))

    k_at_minimum = spin_ratio_at(squeeze.lower()).union(spin_ratio_at(squeeze.upper()))
    f, t = friction(mechanics, k_at_minimum)
    return 1 - (f**2 + squeeze * t**2).sqrt()


@number(least="W/m", force="W", return_force="W")
def normal_motion_dip(mechanics: Mechanics, scene: Scene) -> Triple:
    """Minimum of n . u under the right edge with both effects, the force there, and that at its zero."""
    return mechanics.dip(replace(scene, effects=BOTH))


@number("a^2")
def offset_times_center_distance(mechanics: Mechanics, scene: Scene, spin_ratio: float) -> arb:
    """Product of the offset of a line of force and the distance of the center."""
    k = arb(rational(spin_ratio))
    f, t = friction(mechanics, 1 / k)
    return f / t / k


@number("W")
def pivot_margin(mechanics: Mechanics, scene: Scene, force_angle: float | fmpq) -> arb:
    """Share of the first foot less its force while the slider rotates about it under a line of force.

    The friction f of the other feet, with the torque T about the contact, and the force ``F e - f`` of the
    foot balance ``F e``: the torque of the latter about the contact is -T.
    """
    (x, y), weights = map(rational, scene.support["positions"][0]), scene.support["weights"]
    r, e = (x + rational(scene.rod_length), y), scene.in_rod_frame(force_angle)
    side = cross(e, r).sgn()
    f_x, f_y, torque = mechanics.wrench(scene, (side * r[1], -side * r[0], side), without=0)
    push = (cross(r, (f_x, f_y)) - torque) / cross(r, e)
    share = rational(weights[0]) / sum(map(rational, weights), fmpq(0))
    return share - norm(push * e[0] - f_x, push * e[1] - f_y)


@number("degree")
def pivot_span(mechanics: Mechanics, scene: Scene) -> arb:
    """Interval of force angles about that of the fence for which the first foot is the pivot."""
    return 2 * root(lambda degrees: pivot_margin(mechanics, scene, degrees), fmpq(0), fmpq(80))


@number("a")
def pivot_rod_length(
    mechanics: Mechanics, scene: Scene, force_angle: float, low: float, high: float
) -> arb:
    """The rod length between two others at which the first foot ceases to be the pivot."""

    def margin(length: fmpq) -> arb:
        return pivot_margin(mechanics, replace(scene, rod_length=length), force_angle)

    return root(margin, rational(low), rational(high))


@number("degree")
def corner_span(mechanics: Mechanics, scene: Scene) -> arb:
    """Span of the cone of a line that a force along the fence rotates about its end."""
    (x, y), fence = map(rational, scene.support["end"]), scene.in_rod_frame(0)
    motion = y, -x - rational(scene.rod_length)
    f_x, f_y, torque = mechanics.wrench(scene, (*motion, 1))
    if not (torque.contains(0) and cross(fence, (f_x, f_y)).contains(0)):
        raise Fails("the force is not along the fence")
    return 180 + 2 * in_degrees(abs(arb.atan2(cross(fence, motion), dot(fence, motion))))


@number("1")
def integration_constant(mechanics: Mechanics, scene: Scene) -> arb:
    """Torque of a rotation about the center of a support, over its extent; its center is the contact."""
    corners = scene.support.get("vertices", ())
    square = max((rational(x) ** 2 + rational(y) ** 2 for x, y in corners), default=None)
    extent = rational(scene.support["radius"]) if square is None else arb(square).sqrt()
    return mechanics.wrench(scene, (0, 0, 1))[2] / extent


@number("degree")
def least_force_off(mechanics: Mechanics, scene: Scene) -> arb:
    """Angle between the minimal force and the direction across the rod.

    The force decreases where the motion leads it. The motion never rotates backward, so that one angle
    between force and motion decides the sign up to the angle of this motion.
    """
    rod, ends = rational(scene.rod_angle), (_GAP, 180 - _GAP)
    low, high = ends
    for side in (1, -1):
        angle = low if side > 0 else high
        while (step := side * turn(mechanics, scene, rod + angle)) > _FLAT:
            angle += side * rational(_STRIDE * float(step.lower()))
        low, high = (angle, high) if side > 0 else (low, angle)
    bottom = force(mechanics, scene, rod + (low + high) / 2)
    top = arb.min(*(force(mechanics, scene, rod + end) for end in ends))
    if not top * arb.cos_pi_fmpq(_GAP / 180) > bottom:
        raise Fails("the force is as small along the rod")
    return abs(arb(low).union(arb(high)) - 90)
