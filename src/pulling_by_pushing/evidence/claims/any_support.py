"""Secs. 3, 3.1 and 3.2 for any slider: a statement about each of its points holds for their sum.

In a motion with the contact velocity u and the rotation k, a point at r from the contact slides at v =
u + k J r, where J rotates by +90 degrees. Friction at this point requires the force v / |v| per unit
weight, and inertia the force m v at the mass center; each force is a positive multiple of its v. The
forces sum to the force of the pusher. Their torques about the contact, together with m rho^2 k of
inertia, sum to zero.
"""

from __future__ import annotations

from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.mechanics import LAWS
from pulling_by_pushing.evidence.proofs.registry import proof
from pulling_by_pushing.evidence.proofs.verdicts import Evidence, facts, identity, together

Vector = tuple[ids.Polynomial, ids.Polynomial]

#: Velocity of the contact, position of a point of the slider, and velocity of this point.
CONTACT = (ids.a, ids.b)
POINT = (ids.l * ids.p, ids.l * ids.q)
SLIDE = (ids.a - ids.k * POINT[1], ids.b + ids.k * POINT[0])


@proof
def power_of_any_support() -> Evidence:
    """The power f . v_s is the sum of p |v|."""
    rest = ids.dot(SLIDE, SLIDE) - ids.dot(SLIDE, CONTACT) - ids.k * ids.cross(POINT, SLIDE)
    return identity({"the power of a point": rest})


@proof
def motion_never_turns_back() -> Evidence:
    """As the force rotates, the motion rotates in the same sense or not at all."""
    # e_1, e_2 are (x, y) and (p, q); s_1, s_2 are e and t.
    forces = (ids.x - ids.p, ids.y - ids.q)
    slides = (ids.e * ids.x - ids.t * ids.p, ids.e * ids.y - ids.t * ids.q)
    rest = ids.dot(forces, slides) - (ids.e + ids.t) * (1 - ids.ROD_COSINE)
    return together(identity({"the product": ids.normal(rest)}), power_of_any_support())


@proof
def opposite_edges() -> Evidence:
    """The motions under the forces at 0 and at 180 degrees are opposite."""
    back = {"a": -ids.a, "b": -ids.b, "k": -ids.k}
    return identity(
        {f"component {i}": part + ids.substitute(part, **back) for i, part in enumerate(SLIDE)}
    )


@proof
def symmetric_about_rod() -> Evidence:
    """The limit curve of a mirror-symmetric support is symmetric about the rod."""
    image = {"a": -ids.a, "k": -ids.k, "p": -ids.p}
    along, across = (ids.substitute(part, **image) for part in SLIDE)
    return identity({"along the axis": along + SLIDE[0], "across it": across - SLIDE[1]})


@proof
def largest_through_center_of_pressure() -> Evidence:
    """The force is at most W, and equals W only along the line through the center of pressure."""
    # e_1, e_2 are (x, y) and (p, q); the loads are e and t.
    force = ids.e * ids.x + ids.t * ids.p, ids.e * ids.y + ids.t * ids.q
    rest = ids.dot(force, force) - (ids.e + ids.t) ** 2 + 2 * ids.e * ids.t * (1 - ids.ROD_COSINE)
    return identity({"the force": ids.normal(rest)})


@proof
def normal_push_sticks() -> Evidence:
    """Slip by `a` against the force (-1, 0) or (1, 0) has the power -|a|: no slider allows it."""
    work = {
        f"slip to the {side}": ids.dot((-turn * ids.ONE, 0 * ids.ONE), (turn * ids.a, ids.b))
        + ids.a
        for side, turn in (("right", 1), ("left", -1))
    }
    return together(identity(work), power_of_any_support())


def _one_motion() -> Evidence:
    """Evidence that two motions (u_x, +-u_y, k) under one force slide every point along the normal.

    Under one force the two slides of a point are parallel; their cross product is 2 u_y times the
    component along the fence.
    """
    other = ids.substitute(SLIDE[0], b=-ids.b), ids.substitute(SLIDE[1], b=-ids.b)
    return identity({"the slides": ids.cross(other, SLIDE) - 2 * ids.b * SLIDE[0]})


@proof
def aligned_where_symmetric() -> Evidence:
    """The rod along the normal, a mirror-symmetric support: n . v_s = 0 under a force along the fence."""
    return together(symmetric_about_rod(), opposite_edges(), _one_motion())


def _no_other_edge() -> Evidence:
    """Evidence that a force on the left edge does no positive work on a motion to the right and away.

    The force is f (-t, 1), where t is the coefficient of friction, or (-f, 0); the motion is (a, -b),
    with all variables positive.
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
    """If a retreating fence sticks, a slip is consistent too."""
    return together(power_of_any_support(), _no_other_edge())


@proof
def pulls_where_it_slips() -> Evidence:
    """Under definition 1 a slider can be pulled if and only if it can slip in a push."""
    laws = {
        "definition 1 slips": LAWS["definition-1"].slips,
        "definition 2 does not": not LAWS["definition-2"].slips,
    }
    return together(facts(laws), opposite_edges(), power_of_any_support(), _no_other_edge())


def _slide(point: Vector, center: Vector) -> Vector:
    """Velocity of a point while the slider rotates at k about a center."""
    return -ids.k * (point[1] - center[1]), ids.k * (point[0] - center[0])


@proof
def corner_of_a_line() -> Evidence:
    """Slides about a center on the line beyond its ends; here a is d, b is c, y is that of the point."""
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
    """A center at c > a has c d <= a^2, so that d <= a gives c <= a^2 / d, and d > a gives c <= a."""
    c, a, x, e, s, rho = ids.c, ids.a, ids.x, ids.e, ids.t, ids.k  # f: c - a
    excess = c**2 - a**2
    term = a**2 * (c - x) - c * (a**2 - e - c * x) - (c * e + excess * x)
    gap = (a**2 + c**2) - (a**2 - e + c**2 - 2 * c * x) - (2 * c * x + e)
    left = (c * e + excess * x) * s * (s + rho) - excess * x * rho * (s + rho)
    parts = c * e * s * (s + rho) + excess * x * (s**2 - rho**2)
    bound = ids.substitute(c * (a**2 + c**2) - excess * a, c=ids.a + ids.f)
    return together(
        identity({"a point": term, "s^2 - rho^2": gap, "the rest": left - parts}),
        facts({"c s^2 > (c^2 - a^2) a": all(term > 0 for term in bound.coeffs())}),
    )
