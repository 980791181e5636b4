"""The limit surface and the limit curve of Sec. 3: shape, extrema, limits; the ellipse of Fig. 10."""

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
    """The surface is closed, convex, and holds the origin; the motion is normal to it.

    The surface is that of revolution of the meridian (f, t), which runs from (1, 0) at k = 0 to (0, 1)
    as k grows, and of its mirror images. By the integrands f' = -k t', so that the twist, proportional
    to (1, k), is normal to the tangent (f', t'). The normal turns one way, at the rate t'^2 > 0, with
    t' bounded from below on boxes that cover [0, 1] and positive beyond by its integrand. Since f > 0
    and t / k > 0 the normal points away from the origin, which is inside.
    """
    # e is t' and a is t'': the tangent is (-k e, e), and its derivative (-e - k a, a).
    turning = ids.cross((-ids.k * ids.e, ids.e), (-ids.k * ids.a - ids.e, ids.a))
    turned = identity({"turning minus t'^2": ids.normal(turning - ids.e**2)})
    return together(lemmas.rising_torque(), turned, lemmas.same_sense())


@proof
def motion_normal_to_curve() -> Evidence:
    """v_s is normal to the limit curve at f; e is t', and f' = -k e.

    In the frame of the rod the force on the curve is (a, t / l) with a^2 = f^2 - t^2 / l^2, and the
    contact moves along (a, t / l + k l f). The product of this motion with the tangent of the curve
    vanishes by f' = -k t'; both are polynomial identities, for every l.
    """
    slope_along = ids.f * (-ids.k * ids.e) * ids.l**2 - ids.t * ids.e  # l^2 a a'
    work = slope_along + (ids.t + ids.k * ids.l**2 * ids.f) * ids.e
    return together(identity({"v_s . df": ids.normal(work)}), lemmas.rates())


@proof
def extreme_forces(along: float, across: float, force: float) -> Evidence:
    """The force is maximal along the rod and minimal across it: at these angles, and 180 degrees from them.

    The torque about the contact vanishes only with k = 0 where the line of force meets the center, that
    is at the force angles along the rod, for every l > 0. There the slider translates and the force is
    W. As the moment arm l |sin(psi - phi)| grows, |k| grows and f falls, because t' > 0 (a lower bound
    on boxes of [0, 1], the integrand beyond); the arm is largest, l, at the force angles across the
    rod.
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

    The cross product of the force direction and v_s, per speed of the center, is -k l cos(psi - phi),
    an identity. Since k vanishes along the rod only, the product vanishes at the four angles and at no
    other. The scalar product is 1 + k h >= 1, bounded on boxes, so that the two directions are equal
    there and not opposite.
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

    In the frame of the rod the curve is (sqrt(f^2 - t^2 / l^2), t / l). It meets its axes at right
    angles, so that an ellipse would have these axes, and 1 - f^2 would be a multiple of t^2 on an
    interval of k. Both are analytic on [0, 1), so the multiple would be the same on all of it; but (1 -
    f^2) / t^2 is 2 at k = 0 and smaller at k = 1, where its value is enclosed.
    """
    force, torque = ring.profile(arb(1))
    start = 2 * boxes.loss(arb(0), arb(0)) / boxes.turn(arb(0), arb(0)) ** 2
    return inequality(start - (1 - force**2) / torque**2)


@proof
def tends_to_circle(coefficient: float) -> Evidence:
    """1 - f <= coefficient H^2 for every k in [0, 1].

    For l <= 1 a force on the curve has k in [0, 1] and H(k) <= l. The quotients (1 - f) / k^2 and H / k
    are enclosed on boxes that cover [0, 1], and (1 - f) <= 1.1 H^2 holds on each, so that every radius
    lies between (1 - 1.1 l^2) W and W.
    """
    most = rational(coefficient)

    def margin(low: arb, high: arb) -> arb:
        arm = boxes.turn(low, low) / ring.profile(low)[0]
        return most * arm**2 - boxes.loss(high, high)

    return positive(margin)


@proof
def tends_to_segment() -> Evidence:
    """The force across the rod is t W / l < W / l for every l.

    The component of the force across the rod is t W / l, and t(k) < 1 for every k: t rises, and t(1 /
    k) = f(k) < 1 on (0, 1], by the lower bound of (1 - f) / k^2 on boxes. So the half-width is below W
    / l, while the curve reaches W along the rod for every l.
    """
    return together(positive(boxes.loss), lemmas.duality(), lemmas.rising_torque())


@proof
def ellipse_of_inertia() -> Evidence:
    """Fig. 10: the curve of inertia and its normal; e is 1 / rho^2.

    The force m v of a unit kinetic energy, v^2 (1 + (h / rho)^2) = 1, with h = l sin(psi - phi),
    satisfies F_along^2 + (1 + (l / rho)^2) F_across^2 = c^2 in the frame of the rod, an identity. By
    Eqs. (11)-(12) the acceleration of the contact is proportional to the gradient of the left side.
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
