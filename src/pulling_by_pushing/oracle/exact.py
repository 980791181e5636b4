"""Exact properties of a slider: its symmetries, tangents, and the directions of some motions and forces."""

from __future__ import annotations

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import ZERO, Direction, Exact
from pulling_by_pushing.oracle.body import ORIGIN, Body
from pulling_by_pushing.oracle.support import ring

ONE = fmpq(1)


def is_straight(body: Body, direction: Direction) -> bool:
    """Whether a line through the contact passes exactly through the centers of pressure and of mass."""
    centers = [body.pressure] if body.weight != 0 else []
    if body.mass != 0:
        centers.append((body.mass_center[0] + body.length, body.mass_center[1]))
    if any(not arb(part).is_zero() for part in body.load):
        return False
    return all(direction.across(center) == 0 for center in centers)


def is_even(body: Body) -> bool:
    """Whether the slider is its own mirror image in the rod: force and motion across it are parallel."""
    support = body.weight == 0 or (body.support is not None and body.support.is_even)
    return bool(support and (body.mass == 0 or not body.mass_center[1]))


def is_across(direction: Direction) -> bool:
    """Whether a direction is exactly across the rod."""
    return direction.along((ONE, ZERO)) == 0


def is_tangent(body: Body, direction: Direction) -> bool:
    """Whether a line of force is tangent to a ring, on which all effects then turn the slider (k = 1)."""
    radius = ring_radius(body)
    if radius is None or (body.mass != 0 and body.gyration != radius * radius):
        return False
    if not abs(body.length * direction.ball[1] / radius).contains(1):
        return False
    length, square = body.length, radius * radius
    return direction.sign(lambda x, y: (length * y) ** 2 - square * (x * x + y * y)) == 0


def ring_radius(body: Body) -> fmpq | None:
    """Radius of a support that is a ring about the slider's center, with the mass there too, or None."""
    if body.weight == 0 or body.support is None or (body.mass != 0 and body.mass_center != ORIGIN):
        return None
    pieces = (*body.support.points, *body.support.circles, *body.support.lines)
    circle = body.support.circles[0] if body.support.circles else None
    if len(pieces) != 1 or circle is None or circle.profile is not ring or circle.center != ORIGIN:
        return None
    return circle.radius


def exact_motion(body: Body, force: Direction) -> tuple[Exact, Exact] | None:
    """A positive multiple of the contact's motion under a force, in the fence's frame, if it is known."""
    if is_parallel(body, force):
        return force.in_fence_frame
    if force.exact is None or not (body.weight == 0 or is_tangent(body, force)):
        return None
    # Eqs. (11)-(12); a line of force tangent to the ring, without a mass aside, is as if rho were R.
    gyration = body.gyration if body.weight == 0 else (ring_radius(body) or ONE) ** 2
    (x, y), a, b = force.exact, body.mass_center[0] + body.length, body.mass_center[1]
    turn = (a * y - b * x) / gyration
    return force.to_fence((x - turn * b, y + turn * a))


def is_parallel(body: Body, direction: Direction) -> bool:
    """Whether force and motion of the contact are along one direction, by symmetry or for a translation."""
    return is_straight(body, direction) or (is_even(body) and is_across(direction))


def exact_force(body: Body, t: Direction) -> tuple[Exact, Exact] | None:
    """A positive multiple of the force of a sticking motion, in the fence's frame, if it is algebraic."""
    if is_parallel(body, t):
        return t.in_fence_frame
    if t.exact is None:
        return None
    if body.weight == 0:  # Eqs. (11)-(12)
        (x, y), a, b = t.exact, body.mass_center[0] + body.length, body.mass_center[1]
        turn = (b * x - a * y) / (body.gyration + a * a + b * b)
        return t.to_fence((x - turn * b, y + turn * a))
    return _force_across_line(body, t)


def _force_across_line(body: Body, t: Direction) -> tuple[Exact, Exact] | None:
    """The force across a support on a line, if the center of rotation lies on that line beyond its ends."""
    ends = body.support.ends if body.mass == 0 and body.support is not None else None
    if ends is None:
        return None
    (a, b), (c, d) = ends
    x, y = body.pressure
    if x * (c - a) + y * (d - b) != 0:
        return None
    sides = [t.along((x + body.length, y)) for x, y in ends]
    if sides[0] * sides[1] < 0 or sides == [0, 0]:
        return None
    normal = d - b, a - c
    side = t.along(normal)
    return t.to_fence((side * normal[0], side * normal[1]))
