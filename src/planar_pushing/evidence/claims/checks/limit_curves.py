"""The limit surface and the limit curve of Sec. 3: shape, extrema and limits; the ellipse of Fig. 10."""

from __future__ import annotations

from flint import arb

from planar_pushing.certified import ring
from planar_pushing.certified.balls import rational
from planar_pushing.certified.setting import Slider, heading, lean
from planar_pushing.evidence.claims.proofs import boxes, lemmas
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs.boxes import positive
from planar_pushing.evidence.claims.registry import proof
from planar_pushing.evidence.claims.verdicts import (
    Evidence,
    facts,
    identity,
    inequality,
    together,
)


@proof
def limit_surface() -> Evidence:
    """The surface is closed, convex and contains the origin; the motion is normal to it.

    The limit surface of the ring is a surface of revolution about the torque axis. Its meridian
    consists of the curve $(f, t)$, which runs from $(1, 0)$ at $k = 0$ to $(0, 1)$ as $k$ tends to
    infinity, and of the mirror images of this curve in both axes. The integrands give $f' = -k t'$, so
    that the motion, which is proportional to $(1, k)$, is normal to the tangent $(f', t')$. The tangent
    rotates in one sense, since its cross product with its derivative is $t'^2 > 0$; $t'$ has a positive
    lower bound on boxes that cover $[0, 1]$ and is positive for $k > 1$ by its integrand. At the two
    ends the normal lies on an axis, so that the mirror images join smoothly: the meridian is closed and
    convex, and so is the surface. Since $f > 0$ and $t / k > 0$, the normal points away from the
    origin, which is therefore inside.
    """
    # e is t' and a is t'': the tangent is (-k e, e), and its derivative (-e - k a, a).
    turning = ids.cross((-ids.k * ids.e, ids.e), (-ids.k * ids.a - ids.e, ids.a))
    turned = identity({"turning minus t'^2": ids.normal(turning - ids.e**2)})
    return together(lemmas.rising_torque(), turned, lemmas.same_sense())


@proof
def motion_normal_to_curve() -> Evidence:
    """v_s is normal to the limit curve at f; e is t', and f' = -k e.

    In the frame of the rod the force on the limit curve is $(F_"along", t / l)$ with $F_"along"^2 = f^2
    - t^2 / l^2$, and the contact moves in the direction $(F_"along", t / l + k l f)$. The scalar
    product of this motion with the tangent of the curve is $(f' + k t') f$, which vanishes because $f'
    = -k t'$. Both steps are polynomial identities and hold for every $l > 0$.
    """
    slope_along = ids.f * (-ids.k * ids.e) * ids.l**2 - ids.t * ids.e  # l^2 a a'
    work = slope_along + (ids.t + ids.k * ids.l**2 * ids.f) * ids.e
    return together(identity({"v_s . df": ids.normal(work)}), lemmas.rates())


@proof
def extreme_forces(along: float, across: float, force: float) -> Evidence:
    """The force is maximal along the rod and minimal across it: at the given angles and their opposites.

    The moment arm of the force is $h = l sin(psi - phi)$, and $k$ is the root of $H(k) = h$. For $l >
    0$ the arm vanishes only at the two force angles along the rod; there $k = 0$, the slider
    translates, and the force is $W$. As $abs(h)$ grows, $abs(k)$ grows, because $H$ increases, and the
    force $f$ decreases, because $f' = -k t'$ and $t' > 0$ (a lower bound on boxes that cover $[0, 1]$,
    the sign of the integrand for $k > 1$). The arm $abs(h)$ has its maximum $l$ at the two force angles
    across the rod, where the force is therefore minimal.
    """
    arms = {
        f"greatest at {angle:g}": lean(Slider.of(1.0), heading(angle))[1] == 0
        for angle in (along, along + 180)
    }
    arms |= {
        f"least at {angle:g}": abs(lean(Slider.of(1.0), heading(angle))[1]) == 1
        for angle in (across, across + 180)
    }
    arms[f"force {force:g} W"] = bool(ring.profile(arb(0))[0] == rational(force))
    return together(facts(arms), lemmas.rising_torque(), lemmas.rising_arm())


@proof
def parallel_at_four_angles(along: float, across: float) -> Evidence:
    """Force and v_s are parallel along and across the rod, and nowhere else; theta_s is phi there.

    For a unit force and a unit speed of the center, $bold(f) times bold(v)_s = -k l cos(psi - phi)$, an
    identity. The spin ratio $k$ vanishes only at the two force angles along the rod, and the cosine
    only at the two across it; hence the product vanishes at these four angles and at no other. The
    scalar product is $1 + k h >= 1$, because $k$ and $h$ have the same sign, by lower bounds on boxes.
    The two directions are therefore equal at the four angles, and not opposite.
    """
    found = {}
    for degrees, part in ((along, 1), (along + 180, 1), (across, 0), (across + 180, 0)):
        found[f"phi = {degrees:g}"] = lean(Slider.of(1.0), heading(degrees))[part] == 0
    turn = ids.cross((ids.x, ids.y), ids.MOTION) + ids.l * ids.k * ids.LEAN
    crossed = identity({"f x v_s": ids.normal(turn)})
    return together(facts(found), crossed, lemmas.rising_torque(), lemmas.positive_work())


@proof
def never_an_ellipse() -> Evidence:
    """(1 - f^2) / t^2 would be constant on an ellipse.

    In the frame of the rod the limit curve consists of the points $(sqrt(f^2 - t^2 / l^2), t / l)$ and
    their mirror images in both axes. An ellipse with this symmetry has the same axes, so that $1 - f^2$
    would be a constant multiple of $t^2$ on an interval of $k$ that begins at 0. Both functions are
    analytic on $[0, 1)$ and continuous at 1, so that the multiple would be the same on $[0, 1]$. But
    $(1 - f^2) / t^2$ tends to 2 as $k$ tends to 0, and at $k = 1$ it has a smaller value, $pi^2 / 4 -
    1$, which is enclosed.
    """
    force, torque = ring.profile(arb(1))
    start = 2 * boxes.loss(arb(0), arb(0)) / boxes.turn(arb(0), arb(0)) ** 2
    return inequality(start - (1 - force**2) / torque**2)


@proof
def tends_to_circle(coefficient: float) -> Evidence:
    """1 - f < coefficient H^2 for every k in (0, 1].

    For $l <= 1$ every force on the limit curve has $abs(H(k)) <= l <= H(1) = 1$, so that $abs(k) <= 1$.
    The quotients $(1 - f) / k^2$ and $H / k$ increase on $[0, 1]$; their enclosures on boxes that cover
    this interval give $1 - f < 1.1 H^2$, except at $k = 0$, where both sides vanish. Every radius of
    the curve therefore lies between $(1 - 1.1 l^2) W$ and $W$.
    """
    most = rational(coefficient)

    def margin(low: arb, high: arb) -> arb:
        arm = boxes.turn(low, low) / ring.profile(low)[0]
        return most * arm**2 - boxes.loss(high, high)

    return positive(margin)


@proof
def tends_to_segment() -> Evidence:
    """The force across the rod is t W / l < W / l for every l.

    The component of the force across the rod is $t W / l$. For every $k$, $t < 1$: the torque $t$
    increases with $k$, and $t(1 / k) = f(k) < 1$ on $(0, 1]$, by the lower bound of $(1 - f) / k^2$ on
    boxes. The half-width of the curve is therefore below $W / l$, while the component along the rod
    takes all values from $-W$ to $W$ for every $l$.
    """
    return together(positive(boxes.loss), lemmas.duality(), lemmas.rising_torque())


@proof
def ellipse_of_inertia() -> Evidence:
    """Fig. 10: the curve of inertia and its normal; e is 1 / rho^2.

    If the center moves at $v$, the spin ratio is $k = h / rho^2$ by Eq. (10), with $R = 1$ and $h = l
    sin(psi - phi)$, and the kinetic energy is proportional to $v^2 (1 + (h / rho)^2)$. The force $F$ is
    proportional to $v$; the forces of equal energy thus satisfy $F^2 (1 + (h / rho)^2) = c^2$. In the
    frame of the rod this reads $F_"along"^2 + (1 + (l / rho)^2) F_"across"^2 = c^2$, an identity. By
    Eqs. (11)-(12) the acceleration of the contact is proportional to the gradient of the left side and
    hence normal to the ellipse.
    """
    unit = 1 + ids.e * ids.l**2 * ids.s**2
    curve = ids.c**2 + ids.s**2 * (1 + ids.e * ids.l**2) - unit
    motion = ids.c, ids.s + ids.e * ids.l * ids.s * ids.l
    gradient = ids.c, (1 + ids.e * ids.l**2) * ids.s
    return identity(
        {
            "the ellipse": ids.normal(curve),
            "a_s x gradient": ids.normal(ids.cross(motion, gradient)),
        }
    )
