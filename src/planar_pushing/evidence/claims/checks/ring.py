"""Eqs. (1)-(7): friction of the ring, the force in the fence's frame, the balance of torque."""

from __future__ import annotations

from flint import acb, arb

from planar_pushing.certified import integrals, ring
from planar_pushing.certified.balls import exact_direction, rational
from planar_pushing.evidence.claims.proofs import boxes, lemmas
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.registry import proof, sample
from planar_pushing.evidence.claims.verdicts import (
    Evidence,
    identity,
    inequality,
    least,
    near,
    together,
)

#: Velocity of the ring's point at theta, over v, in the primed frame.
_POINT = (-ids.k * ids.s, 1 + ids.k * ids.c)


@proof
def friction_integrals(cross_term: float) -> Evidence:
    """Eqs. (1)-(3) from the velocity of each point; `cross_term` is the factor 2 in the radicand.

    With k = omega / v, R = 1, the ring's point at the angle theta moves at v (-k sin(theta), 1 + k
    cos(theta)) in the primed frame, and its friction is the unit vector along this velocity. The y'
    part of the unit vector and its moment about the center are the integrands of Eqs. (2) and (3); the
    radicand is the square of the speed over v. The integrand along x' is odd about theta = pi, so that
    Eq. (1) follows. All are identities of polynomials in sin(theta) and cos(theta), reduced to normal
    form.
    """
    printed = 1 + ids.k**2 + rational(cross_term) * ids.k * ids.c
    moment = ids.cross((ids.c, ids.s), _POINT)
    found = identity(
        {
            "the numerator of Eq. (2)": ids.normal(_POINT[1] - lemmas.FORCE),
            "the numerator of Eq. (3)": ids.normal(moment - lemmas.TORQUE),
            "the radicand": ids.normal(ids.dot(_POINT, _POINT) - printed),
        }
    )
    return together(found, lemmas.no_sideways_force())


@proof
def closed_forms() -> Evidence:
    """Eqs. (2)-(3) as complete elliptic integrals.

    For 0 < k < 1 both pairs solve f' = -k t', t' = (f - k t) / (1 - k^2) - t / k: the integrals because
    the two sides of each equation differ by a derivative around the ring, the elliptic forms by the
    derivatives of E and K (DLMF 19.4). Solutions that stay finite at k = 0 are multiples of one
    another, and f(0) = 1 for both. For k > 1 the integrand of Eq. (2) at 1 / k is that of Eq. (3) at k.
    """
    start = 2 / arb.pi() * acb(0).elliptic_e().real
    return together(
        lemmas.rates(),
        near(start, 1.0, 1e-30),
        lemmas.torque_rate(),
        lemmas.elliptic_rates(),
        lemmas.duality(),
    )


@sample
def closed_forms_on_grid(least_ratio: float, greatest_ratio: float, count: float) -> Evidence:
    """Distance of the closed forms, and of Eq. (1) from zero, from the integrals as printed.

    At spin ratios that are spaced evenly in their logarithm, rigorous quadrature of Eqs. (1)-(3) as
    printed agrees with the closed forms to 1e-25, and Eq. (1) vanishes to 1e-25.
    """
    low, high, steps = arb(rational(least_ratio)), arb(rational(greatest_ratio)), int(count) - 1
    grid = [(low * (high / low) ** (arb(i) / steps)).mid() for i in range(steps + 1)]
    gaps = [
        abs(one - other)
        for k in grid
        for one, other in zip(ring.profile(k), integrals.printed(k), strict=True)
    ]
    gaps += [abs(integrals.sideways(k)) for k in grid]
    widest = -least(-gap for gap in gaps)
    return inequality(arb(10) ** -25 - widest, value=widest, points=len(gaps))


def _turned(force: tuple[ids.Polynomial, ids.Polynomial]) -> tuple[ids.Polynomial, ids.Polynomial]:
    """A vector of the primed frame in the fence's, x' at phi - 90 degrees."""
    return force[0] * ids.y + force[1] * ids.x, -force[0] * ids.x + force[1] * ids.y


@proof
def fence_frame(rod_angle: float) -> Evidence:
    """Eqs. (4)-(6).

    The x' axis is the direction of the force rotated by -90 degrees, so that a force f_y' along y' has
    the components f_y' cos(phi) and f_y' sin(phi) along and across the fence. Moving it from the ring's
    center to the contact adds its moment l f_y' sin(phi - psi), where psi is 45 degrees. These are
    identities of polynomials in the sines and cosines of phi and psi.
    """
    along, across = _turned((0 * ids.f, ids.f))
    moved = ids.cross((ids.l * ids.p, ids.l * ids.q), (ids.f * ids.x, ids.f * ids.y))
    torque = moved - ids.l * ids.f * (ids.y * ids.p - ids.x * ids.q)
    given, printed = (exact_direction(rational(degrees)) for degrees in (rod_angle, 45.0))
    differences = {
        "f_x": ids.normal(along - ids.f * ids.x),
        "f_y": ids.normal(across - ids.f * ids.y),
        "tau_0": ids.normal(torque),
    }
    differences |= {f"psi = {rod_angle:g}": a - b for a, b in zip(given, printed, strict=True)}
    return identity(differences)


@proof
def unique_center() -> Evidence:
    """Eq. (7) has one root; the center is at -1 / k on x'.

    The integrands give f' = -k t' and t' > 0 for every k > 0. On boxes that cover [0, 1] the slope of H
    = t / f has a positive lower bound, and duality, H(1 / k) = 1 / H(k), extends this to k > 1: H rises
    from 0 to infinity. Eq. (7) is H(k) = l sin(psi - phi), R = 1, and has therefore one root k for each
    force angle and rod length. In the motion with this k the point at -v / omega on the x' axis is at
    rest.
    """
    at_rest = ids.k + ids.k * -ids.ONE  # 1 + k x', times k, at x' = -1 / k
    return together(lemmas.rising_arm(), identity({"the velocity of the center": at_rest}))


@proof
def rotation_sense(sign: float) -> Evidence:
    """Below Eq. (7): `sign` times tau_0' has the sign of omega.

    With omega counter-clockwise, as in Eqs. (2)-(3), t / k is at least 1/2 on [0, 1], by its lower
    bound on boxes, and t rises beyond. So tau_0' has the sign of omega for every spin ratio, and
    -tau_0' for none.
    """
    way = rational(sign)
    return together(boxes.positive(lambda a, b: way * boxes.turn(a, b)), lemmas.rates())


@proof
def self_duality(force: float, within: float) -> Evidence:
    """Identity f(1 / k) = t(k) for k > 0, and both at k = 1.

    The integrand of Eq. (2) at 1 / k is that of Eq. (3) at k, exactly, so that f(1 / k) = t(k). At k =
    1 both integrands are |cos(theta / 2)|, whose mean is 2 / pi.
    """
    half = 2 * ids.c**2 - 1  # cos(theta) by c = cos(theta / 2)
    top, bottom = (
        ids.replaced(each, k=ids.ONE, c=half) for each in (lemmas.FORCE, lemmas.RADICAND)
    )
    centered = identity({"the integrand at k = 1": top**2 - bottom * ids.c**2})
    return together(near(2 / arb.pi(), force, within, "W"), lemmas.duality(), centered)
