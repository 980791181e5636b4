"""The limit surface and the limit curve of Sec. 3: shape, extrema and limits; the ellipse of Fig. 10."""

from __future__ import annotations

from flint import arb

from pulling_by_pushing.evidence.proofs import boxes, lemmas
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.boxes import positive
from pulling_by_pushing.evidence.proofs.mechanics import Scene, profile
from pulling_by_pushing.evidence.proofs.registry import proof
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    facts,
    identity,
    inequality,
    near,
    together,
)
from pulling_by_pushing.oracle.balls import rational

#: A rod at 45 degrees.
_ROD = Scene()


@proof
def limit_surface() -> Evidence:
    """The surface is closed, convex and contains the origin; the motion is normal to it."""
    # e is t' and a is t'': the tangent is (-k e, e), and its derivative (-e - k a, a).
    turning = ids.cross((-ids.k * ids.e, ids.e), (-ids.k * ids.a - ids.e, ids.a))
    convex = identity({"turning minus t'^2": ids.normal(turning - ids.e**2)})
    return together(lemmas.rising_torque(), convex, lemmas.same_sense())


@proof
def motion_normal_to_curve() -> Evidence:
    """v_s is normal to the limit curve at f; e is t', and f' = -k e."""
    slope_along = ids.f * (-ids.k * ids.e) * ids.l**2 - ids.t * ids.e  # l^2 a a'
    work = slope_along + (ids.t + ids.k * ids.l**2 * ids.f) * ids.e
    return together(identity({"v_s . df": ids.normal(work)}), lemmas.rates())


@proof
def extreme_forces(along: float, across: float, force: float) -> Evidence:
    """The force is maximal along the rod and minimal across it: at the given angles and their opposites."""
    arms = {
        f"greatest at {angle:g}": _ROD.in_rod_frame(angle)[1] == 0 for angle in (along, along + 180)
    }
    arms |= {
        f"least at {angle:g}": abs(_ROD.in_rod_frame(angle)[1]) == 1
        for angle in (across, across + 180)
    }
    arms[f"force {force:g} W"] = bool(profile(arb(0))[0] == rational(force))
    return together(facts(arms), lemmas.rising_torque(), lemmas.rising_arm())


@proof
def parallel_at_four_angles(along: float, across: float) -> Evidence:
    """Force and v_s are parallel along and across the rod, and nowhere else; theta_s is phi there."""
    products = {}
    for degrees, part in ((along, 1), (along + 180, 1), (across, 0), (across + 180, 0)):
        products[f"phi = {degrees:g}"] = _ROD.in_rod_frame(degrees)[part] == 0
    turn = ids.cross((ids.x, ids.y), ids.MOTION) + ids.l * ids.k * ids.ROD_COSINE
    crossed = identity({"f x v_s": ids.normal(turn)})
    return together(facts(products), crossed, lemmas.rising_torque(), lemmas.positive_work())


@proof
def never_an_ellipse() -> Evidence:
    """(1 - f^2) / t^2 would be constant on an ellipse."""
    force, torque = profile(arb(1))
    start = 2 * boxes.loss(arb(0), arb(0)) / boxes.turn(arb(0), arb(0)) ** 2
    return inequality(start - (1 - force**2) / torque**2)


@proof
def tends_to_circle(coefficient: float) -> Evidence:
    """1 - f < coefficient H^2 for every k in (0, 1]."""
    factor = rational(coefficient)

    def margin(low: arb, high: arb) -> arb:
        arm = boxes.turn(low, low) / profile(low)[0]
        return factor * arm**2 - boxes.loss(high, high)

    return positive(margin)


@proof
def tends_to_segment() -> Evidence:
    """The force across the rod is t W / l < W / l for every l."""
    return together(positive(boxes.loss), lemmas.duality(), lemmas.rising_torque())


@proof
def ellipsoid_turns_motion(
    angle: float, within: float, spin_ratio: float, missing: float
) -> Evidence:
    """Motion directions of ring and ellipsoid differ by less than arcsin(1/3), and come near it at k.

    `missing` is a bound on the difference from arcsin(1/3) at the spin ratio k, degrees.
    """
    arm, cosine = ids.ARM, ids.l * ids.ROD_COSINE
    ellipsoid = tuple(ids.substitute(part, k=ids.b) for part in ids.MOTION)
    turn = ids.cross(ids.MOTION, (ellipsoid[0], ellipsoid[1]))
    power = ids.dot(ids.MOTION, (ellipsoid[0], ellipsoid[1]))
    first, second = (1 + ids.k * ids.a) * (1 + ids.a**2), ids.k * ids.a  # a is the arm h, e is c
    rest = second * (first - 1) + (2 * ids.k - ids.a) * (2 * ids.a - ids.k)
    squares = (first + second * ids.e**2) ** 2 - 8 * ids.e**2 * (ids.k - ids.a) ** 2
    algebra = identity(
        {
            "the cross product": ids.normal(turn - cosine * (ids.k - ids.b)),
            "the scalar product": ids.normal(
                power - (1 + ids.k * arm) * (1 + ids.b * arm) - ids.k * ids.b * cosine**2
            ),
            "squares": squares - (first - second * ids.e**2) ** 2 - 4 * ids.e**2 * rest,
        }
    )
    supremum = _degrees((arb(1) / 3).asin())
    return together(
        near(supremum, angle, within, "degree"),
        algebra,
        inequality(_largest_turn(arb(rational(spin_ratio))) - supremum + rational(missing)),
        positive(lambda low, high: 2 * boxes.turn(low, high) - 1 + boxes.loss(low, high)),
        lemmas.rising_torque(),
        lemmas.duality(),
    )


def _largest_turn(k: arb) -> arb:
    """Largest angle between the motions of ring and ellipsoid at a spin ratio, over all rods, degrees."""
    force, torque = profile(k)
    arm = torque / force
    return _degrees(((k - arm) / (2 * (k * arm * (1 + k * arm) * (1 + arm**2)).sqrt())).atan())


def _degrees(radians: arb) -> arb:
    return radians * 180 / arb.pi()


@proof
def ellipse_of_inertia() -> Evidence:
    """Fig. 10: the curve of inertia and its normal; e is 1 / rho^2."""
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
