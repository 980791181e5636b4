"""Eqs. (1)-(7): friction of the ring, the force in the fence's frame, the balance of torque."""

from __future__ import annotations

from flint import acb, arb

from planar_pushing.certified import integrals, ring
from planar_pushing.certified.balls import exact_direction, rational
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs import lemmas
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    Verdict,
    identity,
    inequality,
    least,
    near,
    together,
)

#: Velocity of the ring's point at theta, over v, in the primed frame.
_POINT = (-ids.k * ids.s, 1 + ids.k * ids.c)


@check
def sideways_force(spin_ratio: float) -> Evidence:
    """Eq. (1): the integrand is odd about theta = pi."""
    method = "the integrand is odd about theta = pi, exactly; the integral by acb.integral"
    force = integrals.sideways(arb(rational(spin_ratio)))
    found = inequality(arb(10) ** -30 - abs(force), method, value=force, unit="W")
    return together(found, lemmas.no_sideways_force(method))


def _speed_differs(cross_term: float) -> ids.Polynomial:
    """Square of the point's speed minus the printed radicand."""
    printed = 1 + ids.k**2 + rational(cross_term) * ids.k * ids.c
    return ids.normal(ids.dot(_POINT, _POINT) - printed)


@check
def force_integral(cross_term: float) -> Evidence:
    """Eq. (2): the y' part of the unit velocity of the ring's points."""
    return identity(
        {
            "the numerator": ids.normal(_POINT[1] - (1 + ids.k * ids.c)),
            "the radicand": _speed_differs(cross_term),
        },
        "friction against the velocity of every point, as polynomials in cos and sin",
    )


@check
def torque_integral(cross_term: float) -> Evidence:
    """Eq. (3): its moment about the ring's center."""
    moment = ids.cross((ids.c, ids.s), _POINT)
    return identity(
        {
            "the numerator": ids.normal(moment - (ids.k + ids.c)),
            "the radicand": _speed_differs(cross_term),
        },
        "friction against the velocity of every point, as polynomials in cos and sin",
    )


@check
def closed_forms() -> Evidence:
    """Eqs. (2)-(3) are 2/pi E(k^2) and 2/pi (E - (1 - k^2) K) / k for 0 < k < 1, dual beyond.

    Both pairs solve f' = -k t', t' = (f - k t) / (1 - k^2) - t / k. The only solutions that stay finite
    at k = 0 are multiples of one another, and f(0) = 1 for both.
    """
    method = "both solve one linear system of two rates, identities; f(0) = 1; duality beyond k = 1"
    start = 2 / arb.pi() * acb(0).elliptic_e().real
    return together(
        near(start, 1.0, 1e-30, method),
        lemmas.rates(),
        lemmas.torque_rate(),
        lemmas.elliptic_rates(),
        lemmas.duality(),
    )


@check
def closed_forms_on_grid(least_ratio: float, greatest_ratio: float, count: float) -> Evidence:
    """Eqs. (2)-(3) as complete elliptic integrals, against the integrals as printed."""
    low, high, steps = arb(rational(least_ratio)), arb(rational(greatest_ratio)), int(count) - 1
    grid = [(low * (high / low) ** (arb(i) / steps)).mid() for i in range(steps + 1)]
    gaps = [
        abs(one - other)
        for k in grid
        for one, other in zip(ring.profile(k), integrals.printed(k), strict=True)
    ]
    widest = -least(-gap for gap in gaps)
    return inequality(
        arb(10) ** -25 - widest,
        "largest distance of 2/pi E(k^2) and 2/pi (E - (1 - k^2) K) / k, and of their duals, "
        "from acb.integral",
        value=widest,
        points=len(gaps),
        holds=Verdict.VERIFIED,
    )


def _turned(force: tuple[ids.Polynomial, ids.Polynomial]) -> tuple[ids.Polynomial, ids.Polynomial]:
    """A vector of the primed frame in the fence's, x' at phi - 90 degrees."""
    return force[0] * ids.y + force[1] * ids.x, -force[0] * ids.x + force[1] * ids.y


@check
def force_along_fence() -> Evidence:
    """Eq. (4)."""
    force = _turned((0 * ids.f, ids.f))[0]
    return identity({"f_x": ids.normal(force - ids.f * ids.x)}, "rotation of the frame, exactly")


@check
def force_across_fence() -> Evidence:
    """Eq. (5)."""
    force = _turned((0 * ids.f, ids.f))[1]
    return identity({"f_y": ids.normal(force - ids.f * ids.y)}, "rotation of the frame, exactly")


@check
def torque_about_contact(rod_angle: float) -> Evidence:
    """Eq. (6): the wrench at the center l (cos psi, sin psi), moved to the contact."""
    moved = ids.cross((ids.l * ids.p, ids.l * ids.q), (ids.f * ids.x, ids.f * ids.y))
    difference = ids.normal(moved - ids.l * ids.f * (ids.y * ids.p - ids.x * ids.q))
    angle, drawn = (exact_direction(rational(degrees)) for degrees in (rod_angle, 45.0))
    differences = {"l f sin(phi - psi)": difference}
    differences |= {f"psi = {rod_angle:g}": a - b for a, b in zip(angle, drawn, strict=True)}
    return identity(differences, "moment of the force about the contact, exactly")


@check
def unique_balance() -> Evidence:
    """Eq. (7): for every force angle one spin ratio balances the torque."""
    return lemmas.rising_arm(
        "t' > 0 and f' = -k t' from the integrands; lower bound of the slope of t / f on [0, 1]; "
        "duality maps it to k > 1 and the range to [0, inf)"
    )


@check
def center_on_axis() -> Evidence:
    """Below Eq. (7): the point at -v / omega on x' is at rest."""
    distance = -ids.ONE  # times v / omega
    return identity(
        {"velocity": ids.normal(ids.k + ids.k * distance)}, "rigid motion in the primed frame"
    )


@check
def rotation_sense_as_printed(spin_ratio: float) -> Evidence:
    """Below Eq. (7): -tau_0' has the sign of omega, with v > 0 and omega > 0."""
    _, torque = ring.profile(arb(rational(spin_ratio)))
    method = "sign of -tau_0' of Eq. (3) for omega > 0"
    return inequality(-torque, method, unit="W R")


@check
def rotation_sense() -> Evidence:
    """tau_0' has the sign of omega: t / k > 0 on [0, 1], and t rises."""
    return lemmas.same_sense("least t / k on [0, 1]; t rises with k, so t > 0 beyond")
