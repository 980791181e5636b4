"""Lemmas on the friction of any support: what holds at each of its points holds for their sum.

In a motion whose contact has the velocity u, and the rotation k, a point at r from the contact slides at
v = u + k J r (J turns by +90 degrees) and takes the force v / |v| per unit weight. The forces of all points
add up to that of the pusher, and their torques about the contact to zero.
"""

from __future__ import annotations

from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    facts,
    identity,
    together,
)

#: Velocity of the contact, a point of the support, and how the point slides.
CONTACT = (ids.a, ids.b)
POINT = (ids.l * ids.p, ids.l * ids.q)
SLIDE = (ids.a - ids.k * POINT[1], ids.b + ids.k * POINT[0])


def power() -> Evidence:
    """Evidence for f . u + k tau = sum of |v|: v . v = v . u + k (r x v) at each point."""
    rest = ids.dot(SLIDE, SLIDE) - ids.dot(SLIDE, CONTACT) - ids.k * ids.cross(POINT, SLIDE)
    return identity({"the power of a point": rest}, "v . v = u . v + k (r x v) at each point")


def monotone() -> Evidence:
    """Evidence that force and motion turn the same way: the friction of a point is monotone in v.

    With the directions (x, y) and (p, q) and the sizes e and t of two slides, the product of the
    differences of force and of slide is (e + t) (1 - cos of the angle between them) >= 0.
    """
    forces = (ids.x - ids.p, ids.y - ids.q)
    slides = (ids.e * ids.x - ids.t * ids.p, ids.e * ids.y - ids.t * ids.q)
    cosine = ids.dot((ids.x, ids.y), (ids.p, ids.q))
    rest = ids.dot(forces, slides) - (ids.e + ids.t) * (1 - cosine)
    method = "(e1 - e2) . (s1 e1 - s2 e2) = (s1 + s2) (1 - e1 . e2) >= 0 at each point"
    return together(identity({"the product": ids.normal(rest)}, method), power())


def reversal() -> Evidence:
    """Evidence that the reversed motion takes the reversed force: v changes its sign with u and k."""
    back = {"a": -ids.a, "b": -ids.b, "k": -ids.k}
    sums = {f"part {i}": each + ids.replaced(each, **back) for i, each in enumerate(SLIDE)}
    return identity(sums, "v changes its sign with the motion, at each point")


def mirror() -> Evidence:
    """Evidence that the mirrored motion of a mirrored support takes the mirrored force."""
    image = {"a": -ids.a, "k": -ids.k, "p": -ids.p}
    along, across = (ids.replaced(each, **image) for each in SLIDE)
    parts = {"along the fence": along + SLIDE[0], "across it": across - SLIDE[1]}
    return identity(parts, "v is mirrored with the motion and the point, at each point")


def spread() -> Evidence:
    """Evidence for c T <= a^2 |G|, with a center at c > a and all pressure within a of its own center.

    The point at x along the direction of the center, r from the center of pressure and e = a^2 - r^2 >= 0,
    is at rho from the center, ``rho^2 = s^2 - 2 c x - e`` with ``s^2 = a^2 + c^2``. The mean of x is zero,
    so the part (c^2 - a^2) x / s may be taken from each point's
    ``(a^2 (c - x) - c (r^2 - c x)) / rho = (c e + (c^2 - a^2) x) / rho``. Over rho s (s + rho) is left

        ``c e s (s + rho) + (c^2 - a^2) x (2 c x + e)``

    where e (c s^2 - (c^2 - a^2) |x|) >= 0, as |x| <= a: nothing is negative. Here t is s, k is rho,
    f is c - a.
    """
    c, a, x, e, s, rho = ids.c, ids.a, ids.x, ids.e, ids.t, ids.k
    excess = c**2 - a**2
    own = a**2 * (c - x) - c * (a**2 - e - c * x) - (c * e + excess * x)
    gap = (a**2 + c**2) - (a**2 - e + c**2 - 2 * c * x) - (2 * c * x + e)
    left = (c * e + excess * x) * s * (s + rho) - excess * x * rho * (s + rho)
    parts = c * e * s * (s + rho) + excess * x * (s**2 - rho**2)
    bound = ids.replaced(c * (a**2 + c**2) - excess * a, c=ids.a + ids.f)
    method = (
        "for a centre at c > a: c T <= a^2 |G|, by an inequality at each point, where the mean of x "
        "is zero; identities, and a polynomial in a and c - a without negative terms"
    )
    return together(
        identity(
            {"the part of a point": own, "s^2 - rho^2": gap, "what is left of it": left - parts},
            method,
        ),
        facts({"c s^2 > (c^2 - a^2) a": all(term > 0 for term in bound.coeffs())}, method),
    )
