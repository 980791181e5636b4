"""Sec. 4: acceleration centers, the seven geometric facts, and Figs. 9, 11 and 12."""

from __future__ import annotations

import math

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import cosine_sine, in_degrees, rational
from planar_pushing.certified.cones import conservative_cone, motion_cone
from planar_pushing.certified.contact.modes import INFINITE_FREE, Mode, coulomb
from planar_pushing.certified.line_of_force import spin_ratio
from planar_pushing.certified.setting import Effects, Slider, heading
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs import lemmas, ring_boxes
from planar_pushing.evidence.claims.proofs.cover import cover
from planar_pushing.evidence.claims.proofs.examples import modes_are
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    equal,
    facts,
    identity,
    inequality,
    least,
    near,
    together,
)

#: Magnitudes at which slip is looked for with both effects, in W / m.
_MAGNITUDES = (1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6)
_MIRROR = "the integrand of Eq. (1) is odd, and m a_c is along v; both exactly"


@check
def centers_on_a_line(rod_length: float, distance: float) -> Evidence:
    """Fig. 9: under inertia every center has the part rho^2 / l along the rod."""
    along = ids.l * ids.dot((ids.y, -ids.x), (ids.p, ids.q)) + ids.ARM  # times -1 / k, k = h
    method = "centre -1 / k on x', along the rod h / (l k) = 1 / l, an identity"
    place = equal(1 / arb(rational(rod_length)), distance, method, unit="R")
    return together(place, identity({"the part along the rod": ids.normal(along)}, method))


@check
def force_perpendicular_to_center_line() -> Evidence:
    """Fact 1: the force is along y', the center on x'."""
    return lemmas.no_sideways_force(_MIRROR)


def _forward() -> Evidence:
    """F > 0: at least 2 / pi on [0, 1], and f(k) = t(1 / k) >= 1 / (2 k) beyond."""
    inside = cover(lambda _, high: ring.profile(high)[0], arb(0), arb(1))
    beyond = cover(ring_boxes.turn, arb(0), arb(1))
    method = "least f on [0, 1] and least k f(k) beyond, by duality; inertia has m > 0"
    both = inequality(least([inside.least, beyond.least]), method)
    return together(both, inside.evidence(method), beyond.evidence(method))


@check
def force_opposes_acceleration() -> Evidence:
    """Fact 2."""
    return _forward()


@check
def forces_parallel() -> Evidence:
    """Fact 3: both are along y' (fact 1) with the same sense (fact 2), and so is their sum."""
    return together(lemmas.no_sideways_force(_MIRROR), _forward())


@check
def force_opposite_to_center() -> Evidence:
    """Fact 4: on x' the center is at -1 / k, the lines at H(k) and at k, of the sign of k."""
    method = "least H / k on [0, 1], where H / k >= t / k; its dual beyond; h / k = 1 for inertia"
    return lemmas.same_sense(method)


def _tangent(arm: float = 1.0) -> Evidence:
    """H(1) = 1, by duality."""
    method = "the integrands of Eqs. (2) and (3) agree at k = 1, exactly; h = k for inertia"
    force, torque = ring.profile(arb(1))
    return together(near(torque / force, arm, 1e-30, method, "R"), lemmas.duality())


def _rising() -> Evidence:
    """H rises: 1 - H(k) and 1 - k have the same sign."""
    method = "H(1) = 1 and least slope of H on [0, 1]; duality beyond; h = k for inertia"
    return lemmas.rising_arm(method)


@check
def center_outside_line_through() -> Evidence:
    """Fact 5: |k| < 1 gives |H| < 1."""
    return together(_rising(), _tangent())


@check
def center_on_ring_line_tangent(moment_arm: float) -> Evidence:
    """Fact 6: |k| = 1 gives |H| = 1."""
    return _tangent(moment_arm)


@check
def center_inside_line_outside() -> Evidence:
    """Fact 7: |k| > 1 gives |H| > 1."""
    return together(_rising(), _tangent())


@check
def sectors_of_the_cases() -> Evidence:
    """Cases 1-3: with both effects k - 1 has the sign of h - 1, whatever their magnitudes.

    The balance (1 - a) (t - h f) + a (k - h) rises with k; at k = 1, where f = t, it is
    (1 - h) ((1 - a) f + a). Here b is h.
    """
    balance = (1 - ids.a) * (ids.f - ids.b * ids.f) + ids.a * (1 - ids.b)
    factored = (1 - ids.b) * ((1 - ids.a) * ids.f + ids.a)
    method = "balance at k = 1 is (1 - h) times a positive number, an identity; it rises with k"
    return together(_rising(), identity({"the balance": balance - factored}, method))


@check
def force_through_center_translates(rod_length: float, force_angle: float) -> Evidence:
    """Case 4: k = 0 for every share of inertia."""
    slider, force = Slider.of(rod_length), heading(force_angle)
    shares = [fmpq(i, 10) for i in range(11)]
    found = {f"share {share}": bool(spin_ratio(slider, force, share) == 0) for share in shares}
    return facts(found, "the moment arm vanishes exactly, and with it k for every share")


@check
def center_on_ring_pulls(rod_length: float) -> Evidence:
    """Fig. 11: k = 1 under the tangent on the right, phi = psi - asin(1 / l), for every share."""
    length = arb(rational(rod_length))
    tilt = in_degrees((1 / length).asin())
    cosine, _ = cosine_sine(fmpq(45))
    normal = ((45 - tilt) / 180).sin_pi() - length * cosine
    method = "n . a_s per acceleration of the centre at k = 1, where f = t for every share"
    away = inequality(-normal, method, value=normal)
    into = inequality(((45 - tilt) / 180).sin_pi(), method)
    return together(away, into, _tangent())


@check
def pull_with_both_is_ambiguous(
    rod_length: float, friction_coefficient: float, pusher_angle: float, magnitude: float
) -> Evidence:
    """Breaking contact, sticking and slipping are consistent with both effects."""
    expected, law = (Mode.SEPARATE, Mode.STICK, Mode.SLIP_LEFT), coulomb(friction_coefficient)
    return modes_are(expected, rod_length, Effects.BOTH, law, pusher_angle, magnitude)


@check
def bound_of_the_cases(rod_length: float, right: float, left: float, within: float) -> Evidence:
    """Fig. 12: the cone that the seven cases allow under infinite friction."""
    cone = conservative_cone(Slider.of(rod_length))
    method = "motions at the ends of the sectors between the tangents of the ring"
    return together(
        near(cone.left, left, within, method, "degree"),
        near(cone.right, right, within, method, "degree"),
    )


@check
def bound_holds_exact_cone(
    rod_length: float, right_gap: float, left_gap: float, within: float
) -> Evidence:
    """Fig. 12: the exact cone lies inside; by how much at each edge."""
    slider = Slider.of(rod_length)
    bound, exact = conservative_cone(slider), motion_cone(slider, Effects.BOTH, math.inf)
    method = "edges of the bound against those of the union over all magnitudes"
    gaps = exact.right - bound.right, bound.left - exact.left
    inside = inequality(least(gaps), method, unit="degree")
    numbers = (
        near(gap, claimed, within, method, "degree")
        for gap, claimed in zip(gaps, (right_gap, left_gap), strict=True)
    )
    return together(inside, *numbers)


@check
def exact_cone(rod_length: float, right: float, left: float, within: float) -> Evidence:
    """The union over all magnitudes of the motions under infinite friction."""
    cone = motion_cone(Slider.of(rod_length), Effects.BOTH, math.inf)
    method = "at each edge the outer one of the velocity and the acceleration cone"
    return together(
        near(cone.left, left, within, method, "degree"),
        near(cone.right, right, within, method, "degree"),
    )


@check
def slip_at_every_magnitude(rod_length: float, pusher_angle: float) -> Evidence:
    """Fig. 12: sticking needs a motion in the exact cone, whatever the magnitude.

    Under a force on the left edge n . u runs from 0 to infinity, so some slip meets every pusher.
    """
    slider = Slider.of(rod_length)
    edge = motion_cone(slider, Effects.BOTH, math.inf).left
    method = "pusher angle minus the left edge of the union over all magnitudes; modes at seven"
    beyond = inequality(rational(pusher_angle) - edge, method, value=edge, unit="degree")
    slips = (
        modes_are((Mode.SLIP_RIGHT,), rod_length, Effects.BOTH, INFINITE_FREE, pusher_angle, size)
        for size in _MAGNITUDES
    )
    return together(beyond, *slips)
