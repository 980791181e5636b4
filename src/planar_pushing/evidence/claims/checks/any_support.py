"""Secs. 3, 3.1 and 3.2 for any slider: a statement on each of its points holds for their sum.

In a motion whose contact has the velocity u, and the rotation k, a point at r from the contact slides at
v = u + k J r (J turns by +90 degrees). Friction takes the force v / |v| per unit weight there, and inertia
m v at the mass center: each force is a positive multiple of its v. The forces add up to that of the pusher,
and their torques about the contact, with m rho^2 k of inertia, to zero.
"""

from __future__ import annotations

from planar_pushing.certified.contact.modes import INFINITE_FREE, INFINITE_NONE
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.registry import proof
from planar_pushing.evidence.claims.verdicts import Evidence, facts, identity, together

Vector = tuple[ids.Polynomial, ids.Polynomial]

#: Velocity of the contact, a point of the slider, and how the point slides.
CONTACT = (ids.a, ids.b)
POINT = (ids.l * ids.p, ids.l * ids.q)
SLIDE = (ids.a - ids.k * POINT[1], ids.b + ids.k * POINT[0])


@proof
def power_of_any_support() -> Evidence:
    """The power f . v_s is the sum of p |v|.

    A point at r from the contact, which moves with u while the slider rotates at k, slides at v = u + k
    J r. Then v . v = u . v + k (r x v), an identity. The support's friction is p v / |v| at each point,
    and these forces add up to f without torque about the contact: summed, f . u is the sum of p |v|,
    which is positive. So the motion stays within 90 degrees of the force.
    """
    rest = ids.dot(SLIDE, SLIDE) - ids.dot(SLIDE, CONTACT) - ids.k * ids.cross(POINT, SLIDE)
    return identity({"the power of a point": rest})


@proof
def motion_never_turns_back() -> Evidence:
    """The motions of two forces on the limit curve turn as the forces do, or not at all.

    Take two forces on the limit curve with their motions, and at each point of the support the
    directions e_1, e_2 and speeds s_1, s_2 of the two slides. (e_1 - e_2) . (s_1 e_1 - s_2 e_2) = (s_1
    + s_2) (1 - e_1 . e_2) is not negative, an identity. Summed over the support, with no torque about
    the contact, the product of the differences of force and motion is not negative: the motion turns as
    the force does, or not at all.
    """
    # e_1, e_2 are (x, y) and (p, q); s_1, s_2 are e and t.
    forces = (ids.x - ids.p, ids.y - ids.q)
    slides = (ids.e * ids.x - ids.t * ids.p, ids.e * ids.y - ids.t * ids.q)
    rest = ids.dot(forces, slides) - (ids.e + ids.t) * (1 - ids.LEAN)
    return together(identity({"the product": ids.normal(rest)}), power_of_any_support())


@proof
def opposite_edges() -> Evidence:
    """The motions of the forces at 0 and at 180 degrees are opposite.

    The slide v = u + k J r of each point changes its sign with the motion, an identity, and the
    friction with it. So the limit curve is symmetric about the origin, and the motions of the forces at
    0 and at 180 degrees are opposite.
    """
    back = {"a": -ids.a, "b": -ids.b, "k": -ids.k}
    return identity(
        {f"part {i}": each + ids.replaced(each, **back) for i, each in enumerate(SLIDE)}
    )


@proof
def symmetric_about_rod() -> Evidence:
    """The limit curve of a mirrored support is symmetric about the rod.

    In the mirror image about the rod each point slides in the mirror image of its direction, an
    identity. A support that is its own image has therefore the same force at equal angles on the two
    sides of the rod.
    """
    image = {"a": -ids.a, "k": -ids.k, "p": -ids.p}
    along, across = (ids.replaced(each, **image) for each in SLIDE)
    return identity({"along the axis": along + SLIDE[0], "across it": across - SLIDE[1]})


@proof
def largest_through_center_of_pressure() -> Evidence:
    """The force is at most W, and W along the line through the center of pressure alone.

    |p e_1 + q e_2|^2 = (p + q)^2 - 2 p q (1 - e_1 . e_2) for two loads p, q that slide along e_1, e_2,
    an identity. So the force is at most W, and equal to it only where all points slide in one direction
    e. It then acts along e through the center of pressure, and, since it also acts at the contact,
    along the line through both. A translation along this line has that force.
    """
    # e_1, e_2 are (x, y) and (p, q); the loads are e and t.
    force = ids.e * ids.x + ids.t * ids.p, ids.e * ids.y + ids.t * ids.q
    rest = ids.dot(force, force) - (ids.e + ids.t) ** 2 + 2 * ids.e * ids.t * (1 - ids.LEAN)
    return identity({"the force": ids.normal(rest)})


@proof
def normal_push_sticks() -> Evidence:
    """Slip by `a` under the force (-1, 0) or (1, 0) against it works -|a|: no slider allows it.

    The power f . u is positive in every motion, under friction on any support but a single point, under
    inertia, and under both: v . v = u . v + k (r x v) at each point of the support and at the mass
    center, an identity. Let the pusher move along the normal. In a slip the force is along the fence
    and against the slip, and f . u = -|f| |slip| < 0, which is impossible. The motion that sticks is
    the pusher's, along the normal, so that its force has a positive normal part, which infinite
    friction transmits.
    """
    work = {
        f"slip to the {side}": ids.dot((-turn * ids.ONE, 0 * ids.ONE), (turn * ids.a, ids.b))
        + ids.a
        for side, turn in (("right", 1), ("left", -1))
    }
    return together(identity(work), power_of_any_support())


def _one_motion() -> Evidence:
    """Evidence that two motions (u_x, +-u_y, k) under one force slide every point along the normal.

    Under one force the two slides of a point are parallel; their cross product is 2 u_y times the part
    along the fence.
    """
    other = ids.replaced(SLIDE[0], b=-ids.b), ids.replaced(SLIDE[1], b=-ids.b)
    return identity({"the slides": ids.cross(other, SLIDE) - 2 * ids.b * SLIDE[0]})


@proof
def aligned_where_symmetric() -> Evidence:
    """The rod along the normal and a mirrored support: n . v_s = 0 under a force along the fence.

    Mirror image and reversal give one force along the fence from two motions, (u_x, u_y, k) and (u_x,
    -u_y, k), both by identities at each point. By convexity each point has one friction in both, so
    that its two slides are parallel; their cross product is 2 u_y times the slide along the fence, an
    identity. Either u_y = 0, or all friction is along the normal, and the force is not along the fence.
    So both edges of the cone of infinite friction are along the fence.
    """
    return together(symmetric_about_rod(), opposite_edges(), _one_motion())


def _no_other_edge() -> Evidence:
    """Evidence that a force on the left edge does no positive work on a motion to the right and away.

    The force is f (-t, 1), t the coefficient of friction, or (-f, 0); the motion is (a, -b), all
    positive.
    """
    motion = (ids.a, -ids.b)
    edges = {"Coulomb": (-ids.t * ids.f, ids.f), "infinite friction": (-ids.f, 0 * ids.f)}
    return facts(
        {
            name: all(term < 0 for term in ids.dot(force, motion).coeffs())
            for name, force in edges.items()
        }
    )


@proof
def pull_has_a_slip() -> Evidence:
    """Where a retreating fence sticks, a slip is consistent too.

    Let w, w_y < 0, stick under a force inside of the friction cone; f . w > 0 then requires f_x w_x >
    0, say w_x > 0. Move the contact's motion u from w to (0, w_y). Its force changes continuously, or
    through connected sets where a point of the support is the center of rotation, and f . u > 0
    throughout, so that f_y < 0 at the end: the force leaves the cone at some u_x in (0, w_x]. It leaves
    through the right edge, since on the left one every term of f . u is negative. This motion has the
    pusher's normal part and lags behind it under the force of the right edge: a slip to the left, or
    the stick itself where the stick also admits that force. The power is positive by v . v = u . v + k
    (r x v) at each point of the support and at the mass center.
    """
    return together(power_of_any_support(), _no_other_edge())


@proof
def pulls_where_it_slips() -> Evidence:
    """Under definition 1 a slider can be pulled exactly if it can slip in a push.

    A slip in a push has a force along the fence, and u_y > 0. The reversed motion has the reversed
    force, by identities at each point: it is along the fence, so that it belongs to the closed cone,
    and the motion is a pull that sticks. Conversely, let a pull stick. If its force has f_y > 0, the
    path of motions from w to (0, w_y) crosses a force along the fence, as in the entry pull-has-a-slip;
    otherwise its own force is along the fence. Either way a force along the fence moves the contact
    with u_y < 0. The reversed motion has u_y > 0, and is a slip in a push by a pusher with this normal
    part that is ahead of it. Under definition 2 no force is along the fence, and nothing slips.
    """
    laws = {
        "definition 1 slips": INFINITE_FREE.slips,
        "definition 2 does not": not INFINITE_NONE.slips,
    }
    return together(facts(laws), opposite_edges(), power_of_any_support(), _no_other_edge())


def _slide(place: Vector, center: Vector) -> Vector:
    """Velocity of a place while the slider rotates at k about a center."""
    return -ids.k * (place[1] - center[1]), ids.k * (place[0] - center[0])


@proof
def corner_of_a_line() -> Evidence:
    """Slides about a center on the line beyond its ends; here a is d, b is c, and y is the point's.

    The contact is the origin and the line runs from (d, -b) to (d, b). About a center (d, c) with |c| >
    b each point (d, y) of the line slides along the fence, at k (c - y), which has one sign for all of
    them: the force is W along the fence, through the middle of the line, at the level of the contact.
    The contact moves along (c, -d) or (-c, d). So one force allows all directions within atan(d / b) of
    the fence, and the cone of infinite friction, whose edges are such forces, spans 180 degrees and
    twice this angle.
    """
    center = (ids.a, ids.b)
    slide, contact = _slide((ids.a, ids.y), center), _slide((0 * ids.a, 0 * ids.a), center)
    return identity(
        {
            "slide across the fence": slide[1],
            "slide along the fence": slide[0] - ids.k * (ids.b - ids.y),
            "motion of the contact": ids.cross(contact, (ids.b, -ids.a)),
        }
    )


@proof
def center_within_bound() -> Evidence:
    """A center at c > a has c d <= a^2, so that d <= a gives c <= a^2 / d, and d > a gives c <= a.

    Let the center of rotation be at c > a from the center of pressure, in the direction of x, and a
    point of the support at r <= a from the center of pressure and rho from that of rotation. The bound
    c d <= a^2 says that the mean of (a^2 (c - x) - c (r^2 - c x)) / rho is not negative. With e = a^2 -
    r^2 and s^2 = a^2 + c^2 each term less (c^2 - a^2) x / s is a positive multiple of c e s (s + rho) +
    (c^2 - a^2) x (2 c x + e), by identities; this is not negative, as |x| <= a and c s^2 > (c^2 - a^2)
    a, a polynomial in a and c - a without negative terms. The mean of x is zero.
    """
    c, a, x, e, s, rho = ids.c, ids.a, ids.x, ids.e, ids.t, ids.k  # f: c - a
    excess = c**2 - a**2
    own = a**2 * (c - x) - c * (a**2 - e - c * x) - (c * e + excess * x)
    gap = (a**2 + c**2) - (a**2 - e + c**2 - 2 * c * x) - (2 * c * x + e)
    left = (c * e + excess * x) * s * (s + rho) - excess * x * rho * (s + rho)
    parts = c * e * s * (s + rho) + excess * x * (s**2 - rho**2)
    bound = ids.replaced(c * (a**2 + c**2) - excess * a, c=ids.a + ids.f)
    return together(
        identity({"a point": own, "s^2 - rho^2": gap, "the rest": left - parts}),
        facts({"c s^2 > (c^2 - a^2) a": all(term > 0 for term in bound.coeffs())}),
    )
