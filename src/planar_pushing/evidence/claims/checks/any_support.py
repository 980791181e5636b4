"""Secs. 3, 3.1 and 3.2 for any slider: a statement about each of its points holds for their sum.

In a motion with the contact velocity u and the rotation k, a point at r from the contact slides at v =
u + k J r, where J rotates by +90 degrees. Friction at this point requires the force v / |v| per unit
weight, and inertia the force m v at the mass center; each force is a positive multiple of its v. The
forces sum to the force of the pusher. Their torques about the contact, together with m rho^2 k of
inertia, sum to zero.
"""

from __future__ import annotations

from planar_pushing.certified.contact.modes import INFINITE_FREE, INFINITE_NONE
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.registry import proof
from planar_pushing.evidence.claims.verdicts import Evidence, facts, identity, together

Vector = tuple[ids.Polynomial, ids.Polynomial]

#: Velocity of the contact, position of a point of the slider, and velocity of this point.
CONTACT = (ids.a, ids.b)
POINT = (ids.l * ids.p, ids.l * ids.q)
SLIDE = (ids.a - ids.k * POINT[1], ids.b + ids.k * POINT[0])


@proof
def power_of_any_support() -> Evidence:
    """The power f . v_s is the sum of p |v|.

    Let the contact move at $bold(u)$ while the slider rotates at $k$. A point of the support at
    $bold(r)$ from the contact slides at $bold(v) = bold(u) + k J bold(r)$, where $J$ rotates by 90
    degrees, and $bold(v) dot bold(v) = bold(u) dot bold(v) + k (bold(r) times bold(v))$, an identity.
    The friction of a point with the load $p$ is $p bold(v) / abs(bold(v))$, or any force of magnitude
    up to $p$ if $bold(v) = 0$. These forces sum to $bold(f)$, and their torques about the contact sum
    to zero. Hence $bold(f) dot bold(u)$ is the sum of $p abs(bold(v))$ over the support, which is
    positive unless a single point carries the whole load and is the center of rotation. The motion
    therefore lies within 90 degrees of the force.
    """
    rest = ids.dot(SLIDE, SLIDE) - ids.dot(SLIDE, CONTACT) - ids.k * ids.cross(POINT, SLIDE)
    return identity({"the power of a point": rest})


@proof
def motion_never_turns_back() -> Evidence:
    """As the force rotates, the motion rotates in the same sense or not at all.

    Let $bold(f)_1$ and $bold(f)_2$ be two forces on the limit curve, and $bold(u)_1$ and $bold(u)_2$
    their motions. At each point of the support let $bold(e)_1$ and $bold(e)_2$ be the directions of the
    two slides, and $s_1$ and $s_2$ their speeds. By an identity, $(bold(e)_1 - bold(e)_2) dot (s_1
    bold(e)_1 - s_2 bold(e)_2) = (s_1 + s_2) (1 - bold(e)_1 dot bold(e)_2)$, which is not negative.
    Summed over the support, where the torque about the contact vanishes, this gives $(bold(f)_1 -
    bold(f)_2) dot (bold(u)_1 - bold(u)_2) >= 0$. Friction does not depend on the speed, so that each
    motion can be scaled separately; hence $(bold(f)_1 - bold(f)_2) dot bold(u)_1 >= 0$ and $(bold(f)_2
    - bold(f)_1) dot bold(u)_2 >= 0$. The limit curve is therefore convex, with the motion as its
    outward normal. It encloses the origin, since $bold(f) dot bold(u) > 0$, and as the force rotates,
    the outward normal rotates in the same sense or not at all.
    """
    # e_1, e_2 are (x, y) and (p, q); s_1, s_2 are e and t.
    forces = (ids.x - ids.p, ids.y - ids.q)
    slides = (ids.e * ids.x - ids.t * ids.p, ids.e * ids.y - ids.t * ids.q)
    rest = ids.dot(forces, slides) - (ids.e + ids.t) * (1 - ids.LEAN)
    return together(identity({"the product": ids.normal(rest)}), power_of_any_support())


@proof
def opposite_edges() -> Evidence:
    """The motions under the forces at 0 and at 180 degrees are opposite.

    If a motion is reversed, the slide $bold(v) = bold(u) + k J bold(r)$ of each point changes sign, an
    identity, and so does the friction. The limit curve is therefore symmetric about the origin, and the
    motions under the force at 180 degrees are opposite to those under the force at 0 degrees.
    """
    back = {"a": -ids.a, "b": -ids.b, "k": -ids.k}
    return identity(
        {f"component {i}": each + ids.replaced(each, **back) for i, each in enumerate(SLIDE)}
    )


@proof
def symmetric_about_rod() -> Evidence:
    """The limit curve of a mirror-symmetric support is symmetric about the rod.

    If a motion is reflected in the line of the rod, the mirror image of each point slides in the
    reflected direction, an identity. For a support that equals its own mirror image, the forces at
    equal angles on the two sides of the rod therefore have the same magnitude.
    """
    image = {"a": -ids.a, "k": -ids.k, "p": -ids.p}
    along, across = (ids.replaced(each, **image) for each in SLIDE)
    return identity({"along the axis": along + SLIDE[0], "across it": across - SLIDE[1]})


@proof
def largest_through_center_of_pressure() -> Evidence:
    """The force is at most W, and equals W only along the line through the center of pressure.

    For two loads $p$ and $q$ that slide along $bold(e)_1$ and $bold(e)_2$, $abs(p bold(e)_1 + q
    bold(e)_2)^2 = (p + q)^2 - 2 p q (1 - bold(e)_1 dot bold(e)_2)$, an identity. The force is therefore
    at most $W$, with equality only if the friction of all points has one direction $bold(e)$. In this
    case the resultant acts along $bold(e)$ through the center of pressure; since it also acts at the
    contact, it acts along the line through both points. Conversely, a translation along this line
    requires the force $W$.
    """
    # e_1, e_2 are (x, y) and (p, q); the loads are e and t.
    force = ids.e * ids.x + ids.t * ids.p, ids.e * ids.y + ids.t * ids.q
    rest = ids.dot(force, force) - (ids.e + ids.t) ** 2 + 2 * ids.e * ids.t * (1 - ids.LEAN)
    return identity({"the force": ids.normal(rest)})


@proof
def normal_push_sticks() -> Evidence:
    """Slip by `a` against the force (-1, 0) or (1, 0) has the power -|a|: no slider allows it.

    The power $bold(f) dot bold(u)$ is positive in every motion, with friction on any support beyond a
    single point, with inertia, or with both. Indeed, $bold(v) dot bold(v) = bold(u) dot bold(v) + k
    (bold(r) times bold(v))$ at each point of the support and at the mass center, an identity, so that
    $bold(f) dot bold(u)$ is the sum of $p abs(bold(v))$ over the support, of $m abs(bold(v))^2$ at the
    mass center, and of $m rho^2 k^2$. Let the pusher move along the normal. The contact cannot
    separate, since the pusher approaches. In a slip the force is along the fence and opposes the slip
    $u_x$ of the contact; then $bold(f) dot bold(u) = -abs(bold(f)) abs(u_x) < 0$, which is impossible.
    If the contact sticks, $bold(u)$ is the motion of the pusher. The rotation that minimizes the convex
    potential of the effects at this $bold(u)$ leaves no torque about the contact, and the positive
    power implies a positive normal component of the force, which infinite friction transmits.
    """
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
    other = ids.replaced(SLIDE[0], b=-ids.b), ids.replaced(SLIDE[1], b=-ids.b)
    return identity({"the slides": ids.cross(other, SLIDE) - 2 * ids.b * SLIDE[0]})


@proof
def aligned_where_symmetric() -> Evidence:
    """The rod along the normal and a mirror-symmetric support: n . v_s = 0 under a force along the fence.

    Let the rod lie along the normal and the support be symmetric about it. If the motion $(u_x, u_y,
    k)$ requires a force along the fence, its mirror image, reversed, is $(u_x, -u_y, k)$ and requires
    the same force, by identities at each point. At each point let $bold(e)_1$ and $bold(e)_2$ be the
    directions of the slides in these two motions, and $s_1$ and $s_2$ their speeds. Since the two
    forces are equal, the sum of $(s_1 + s_2) (1 - bold(e)_1 dot bold(e)_2)$ over the support vanishes,
    as in @every-support, and so does each of its terms: each point has the same friction in both
    motions. Its two slides are thus parallel; their cross product is $2 u_y$ times the slide along the
    fence, an identity. Either $u_y = 0$, or every slide is along the normal. In the second case no
    point is at rest in both motions, so that all friction is along the normal, and the force is not
    along the fence. Therefore $u_y = 0$, and both edges of the cone of infinite friction are along the
    fence.
    """
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
    """If a retreating fence sticks, a slip is consistent too.

    Let the contact stick to a fence that moves at $bold(w)$ with $w_y < 0$, and let each force of this
    motion be inside the friction cone. For such a force $bold(f) dot bold(w) > 0$, $f_y >= 0$, and $w_y
    < 0$, so that $f_x w_x > 0$; let $w_x > 0$ without loss of generality. Vary the motion $bold(u)$ of
    the contact from $bold(w)$ to $(0, w_y)$. Its force changes continuously, or through connected sets
    if a point of the support is the center of rotation. Throughout, $bold(f) dot bold(u) > 0$, because
    $bold(v) dot bold(v) = bold(u) dot bold(v) + k (bold(r) times bold(v))$ at each point of the support
    and at the mass center, an identity. At the end this requires $f_y < 0$; hence the force leaves the
    cone at some $u_x$ in $(0, w_x)$. It leaves through the right edge, since on the left edge no term
    of $bold(f) dot bold(u)$ is positive. The motion at this $u_x$ has the normal component of $bold(w)$
    and lags behind the fence under the force of the right edge: it is a slip to the left.
    """
    return together(power_of_any_support(), _no_other_edge())


@proof
def pulls_where_it_slips() -> Evidence:
    """Under definition 1 a slider can be pulled if and only if it can slip in a push.

    In a slip during a push the force is along the fence, and $u_y > 0$. The reversed motion requires
    the reversed force, by identities at each point. This force is along the fence as well and belongs
    to the closed cone, so that the reversed motion is a pull that sticks. Conversely, let the contact
    stick in a pull at $bold(w)$. If its force has $f_y > 0$, some motion between $bold(w)$ and $(0,
    w_y)$ requires a force along the fence, as in @pull-has-a-slip; otherwise the force of the pull is
    itself along the fence. In both cases a force along the fence moves the contact with $u_y < 0$. The
    reversed motion has $u_y > 0$ and is a slip in a push: the pusher has the same normal component and
    moves faster along the fence than the contact, in the direction of the force. Under definition 2 no
    force is along the fence, and nothing slips.
    """
    laws = {
        "definition 1 slips": INFINITE_FREE.slips,
        "definition 2 does not": not INFINITE_NONE.slips,
    }
    return together(facts(laws), opposite_edges(), power_of_any_support(), _no_other_edge())


def _slide(place: Vector, center: Vector) -> Vector:
    """Velocity of a point while the slider rotates at k about a center."""
    return -ids.k * (place[1] - center[1]), ids.k * (place[0] - center[0])


@proof
def corner_of_a_line() -> Evidence:
    """Slides about a center on the line beyond its ends; here a is d, b is c, and y is that of the point.

    Let the contact be the origin, and let the line of pressure run from $(d, -b)$ to $(d, b)$. During a
    rotation at $k$ about a center $(d, c)$ with $abs(c) > b$, each point $(d, y)$ of the line slides
    along the fence at $k (c - y)$, which has the same sign for all of them. The force is therefore $W$
    along the fence and passes through the middle of the line, at the level of the contact. The contact
    moves along $(c, -d)$ or $(-c, d)$. Thus one force allows all directions within $arctan(d / b)$ of
    the fence, and the cone of infinite friction, which is bounded by such forces, spans 180 degrees
    plus twice this angle.
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

    Let $c$ be the distance of the center of rotation from the center of pressure. For $c <= a$ both
    statements hold, since $a <= a^2 / d$ if $d <= a$. For $c > a$ the bound $c d <= a^2$, proved below,
    gives $c <= a^2 / d$ if $d <= a$ and excludes $d > a$. Let a point of the support lie at $r <= a$
    from the center of pressure and at $rho$ from the center of rotation, and let $x$ be its coordinate
    toward the latter, from the center of pressure. Per unit weight, the torque $T$ about the center of
    pressure is the mean of $(r^2 - c x) / rho$, and the force is at least its component across $x$, the
    mean of $(c - x) / rho$. For a unit rotation $T$ is the mean of $bold(v) dot (bold(v) - bold(w)) /
    abs(bold(v))$, where $bold(w)$, the velocity of the center of pressure, is the mean of $bold(v)$.
    The mean of $abs(bold(v))$ is at least $abs(bold(w))$; hence $T >= 0$. Since $d$ is the ratio of
    torque and force, the bound $c d <= a^2$ follows if the mean of $(a^2 (c - x) - c (r^2 - c x)) /
    rho$ is not negative. With $e = a^2 - r^2$ and $s^2 = a^2 + c^2$, each term minus $(c^2 - a^2) x /
    s$ is a positive multiple of $c e s (s + rho) + (c^2 - a^2) x (2 c x + e)$, by identities. This is
    not negative, because $abs(x) <= a$ and $c s^2 > (c^2 - a^2) a$; the difference of the two sides is
    a polynomial in $a$ and $c - a$ without negative terms. The mean of $x$ is zero, which proves the
    bound.
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
