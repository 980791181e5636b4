"""The limit curve of Sec. 3: its shape, its extrema, its normal, its limits."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import rational
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.line_of_force import limit_point, spin_ratio
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.setting import FRICTION, Effects, Slider, heading, lean
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs import lemmas, ring_boxes
from planar_pushing.evidence.claims.proofs.cover import cover
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    facts,
    identity,
    inequality,
    near,
    together,
)

_SLOPE = "t' > 0 on [0, 1], lower bound on boxes; Eq. (3)'s integrand makes it so for every k"


@check
def surface_normal() -> Evidence:
    """The twist (v, omega) is normal to the limit surface: f' + k t' = 0."""
    return lemmas.rates()


@check
def surface_convex() -> Evidence:
    """The normal (1, k) of the surface's meridian turns one way as (f, t) runs along it."""
    turning = ids.cross((-ids.k * ids.e, ids.e), (-ids.k * ids.a - ids.e, ids.a))
    method = "the meridian turns at the rate t'^2, an identity; least t' on [0, 1]"
    # e is t' and a is t'': the tangent is (-k e, e), and its derivative (-e - k a, a).
    turned = identity({"turning minus t'^2": ids.normal(turning - ids.e**2)}, method)
    inside = lemmas.same_sense("f > 0 and t / k > 0: the normal (1, k) points away from the origin")
    return together(lemmas.rising_torque(method), turned, inside)


@check
def motion_normal_to_curve() -> Evidence:
    """v_s is normal to the limit curve at f.

    In the frame of the rod f is (a, t / l) with ``a^2 = f^2 - t^2 / l^2`` and v_s is
    ``(a, t / l + k l f)`` times 1 / f; e is t', and f' = -k e.
    """
    slope_along = ids.f * (-ids.k * ids.e) * ids.l**2 - ids.t * ids.e  # l^2 a a'
    work = slope_along + (ids.t + ids.k * ids.l**2 * ids.f) * ids.e
    method = "v_s . df = 0 with f' = -k t', both identities"
    return together(identity({"v_s . df": ids.normal(work)}, method), lemmas.rates())


def _turn_from_force(method: str) -> Evidence:
    """Evidence for f x v_s = -k l cos(psi - phi)."""
    turn = ids.cross((ids.x, ids.y), ids.MOTION)
    leaning = ids.l * ids.k * (ids.p * ids.x + ids.q * ids.y)
    return identity({"f x v_s": ids.normal(turn + leaning)}, method)


@check
def parallel_at_four_angles(along: float, across: float) -> Evidence:
    """Force and v_s are parallel where k l cos(psi - phi) = 0, and nowhere else."""
    method = "f x v_s = -k l cos(psi - phi), an identity; k = 0 only at phi = psi; exact angles"
    found, slider = {}, Slider.of(1.0)
    for degrees, part in ((along, 1), (along + 180, 1), (across, 0), (across + 180, 0)):
        found[f"phi = {degrees:g}"] = lean(slider, heading(degrees))[part] == 0
    return together(facts(found, method), _turn_from_force(method), lemmas.rising_torque(_SLOPE))


@check
def greatest_force(force_angle: float, force: float) -> Evidence:
    """The force is greatest at phi and phi + 180, where the slider translates."""
    method = "f falls with |k| from W at k = 0; k = 0 exactly where the line meets the centre"
    slider, found = Slider.of(1.0), {}
    for degrees in (force_angle, force_angle + 180):
        spin = spin_ratio(slider, heading(degrees), FRICTION)
        found[f"translation at {degrees:g}"] = bool(spin == 0)
        found[f"force {force:g} W"] = bool(ring.profile(abs(spin))[0] == rational(force))
    return together(facts(found, method), lemmas.rising_torque(_SLOPE))


@check
def least_force(force_angle: float) -> Evidence:
    """The force is least at phi and phi + 180, where the moment arm is greatest."""
    method = "f falls and the moment arm rises with |k|; the arm is l exactly across the rod"
    sizes = {
        f"arm at {degrees:g}": abs(lean(Slider.of(1.0), heading(degrees))[1]) == 1
        for degrees in (force_angle, force_angle + 180)
    }
    return together(facts(sizes, method), lemmas.rising_torque(_SLOPE))


@check
def motion_along_force(along: float, across: float) -> Evidence:
    """theta_s = phi along and across the rod, where f x v_s vanishes and f . v_s > 0."""
    method = "f x v_s = -k l cos(psi - phi) vanishes, exactly; f . v_s = 1 + k h > 0"
    slider, found = Slider.of(1.0), {}
    for degrees in (along, across, along + 180, across + 180):
        cosine, sine = lean(slider, heading(degrees))
        found[f"phi = {degrees:g}"] = bool(cosine == 0 or sine == 0)
    return together(facts(found, method), _turn_from_force(method), lemmas.positive_work(method))


@check
def never_an_ellipse() -> Evidence:
    """(1 - f^2) / t^2 would be constant on an ellipse; it is 2 at k = 0 and less at k = 1.

    In the frame of the rod the curve is (sqrt(f^2 - t^2 / l^2), t / l). It meets its axes at right
    angles, so an ellipse would have these axes, and ``1 - f^2`` would be a multiple of t^2 on an
    interval of k and hence, both being analytic, on all of [0, 1).
    """
    force, torque = ring.profile(arb(1))
    start = 2 * ring_boxes.loss(arb(0), arb(0)) / ring_boxes.turn(arb(0), arb(0)) ** 2
    end = (1 - force**2) / torque**2
    method = (
        "(1 - f^2) / t^2 at k = 0 minus at k = 1; it is constant if any limit curve is an ellipse"
    )
    return inequality(start - end, method)


def limit_spin(length: arb) -> tuple[arb, arb]:
    """Greatest spin ratio on the limit curve, and the force there."""
    k = spin_of_arm(length, fmpq(1), FRICTION)
    return k, ring.profile(k)[0]


@check
def distance_from_ellipse(rod_length: float, part: float, within: float) -> Evidence:
    """Largest radial distance from the ellipse with the same extrema, as a part of its radius.

    The curve is sqrt(f^2 + e t^2) of the ellipse's radius, which is 1 at both ends of the spin ratios.
    Its slope has the sign of e H / k - 1, which rises: t / k rises and f falls on [0, 1], dually beyond.
    """
    length = arb(rational(rod_length))
    end, tip = limit_spin(length)
    squeeze = (1 / tip**2 - 1) / length**2

    def place(size: arb) -> arb:
        """Spin ratio at which the slope vanishes, for an exact e; it falls with e."""

        def steepness(k: arb) -> arb:
            force, torque = ring.profile(k)
            return size * torque / (k * force) - 1

        return increasing_root(steepness, arb(2) ** -20, end.lower())

    lowest = place(squeeze.lower()).union(place(squeeze.upper()))
    force, torque = ring.profile(lowest)
    method = "at the one spin ratio of greatest distance, enclosed by a change of sign"
    return near(1 - (force**2 + squeeze * torque**2).sqrt(), part, within, method)


@check
def tends_to_circle(coefficient: float) -> Evidence:
    """1 - f <= coefficient H^2 for every k in [0, 1]: the radii lie within that part of l^2."""
    most = rational(coefficient)

    def margin(low: arb, high: arb) -> arb:
        arm = ring_boxes.turn(low, low) / ring.profile(low)[0]
        return most * arm**2 - ring_boxes.loss(high, high)

    method = "coefficient * (H / k)^2 - (1 - f) / k^2 on boxes of [0, 1], that is l <= 1"
    return cover(margin, arb(0), arb(1)).evidence(method)


@check
def tends_to_segment(rod_length: float, half_width: float, within: float) -> Evidence:
    """The force across the rod is t W / l < W / l for every l; its greatest value at one l."""
    _, tip = limit_spin(arb(rational(rod_length)))
    number = near(
        tip, half_width, within, "t < 1 for every k, so the half-width is below W / l", "W"
    )
    below = cover(ring_boxes.loss, arb(0), arb(1)).evidence("t(1 / k) = f(k) < 1 on (0, 1]")
    return together(number, below)


@check
def ellipse_of_inertia(
    rod_length: float, gyration_radius: float, ratio: float, within: float
) -> Evidence:
    """Fig. 10: F_along^2 + (1 + (l / rho)^2) F_across^2 = c^2, with the ratio of the axes."""
    # v^2 (1 + e h^2) = 1 with e = 1 / rho^2: a^2 and b^2 are the squares of the parts of f / v.
    arm = ids.l**2 * ids.s**2
    unit = 1 + ids.e * arm
    curve = ids.c**2 + ids.s**2 * (1 + ids.e * ids.l**2) - unit
    exact = identity({"the ellipse": ids.normal(curve)}, "kinetic energy of the motion, exactly")
    slider = Slider.of(rod_length, gyration_radius=gyration_radius)
    sizes = [limit_point(slider, Effects.INERTIA, heading(degrees))[0] for degrees in (45, 135)]
    return together(near(sizes[1] / sizes[0], ratio, within, exact.method), exact)


@check
def acceleration_normal_to_ellipse() -> Evidence:
    """Fig. 10: a_s is (cos, (1 + e l^2) sin) in the frame of the rod, the ellipse's gradient."""
    motion = ids.c, ids.s + ids.e * ids.l * ids.s * ids.l
    gradient = ids.c, (1 + ids.e * ids.l**2) * ids.s
    return identity(
        {"a_s x gradient": ids.normal(ids.cross(motion, gradient))}, "Eqs. (11)-(12), exactly"
    )
