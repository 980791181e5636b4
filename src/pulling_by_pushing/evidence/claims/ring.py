"""Eqs. (1)-(7): friction of the ring, force in the frame of the fence, balance of torque."""

from __future__ import annotations

from collections.abc import Callable

from flint import acb, arb

from pulling_by_pushing.evidence.proofs import boxes, lemmas
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.mechanics import profile
from pulling_by_pushing.evidence.proofs.registry import proof, sample
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    identity,
    inequality,
    near,
    smallest,
    together,
)
from pulling_by_pushing.oracle.balls import at_degrees, rational

#: Velocity of the ring's point at theta, over v, in the primed frame.
_POINT = (-ids.k * ids.s, 1 + ids.k * ids.c)


@proof
def friction_integrals(cross_term: float) -> Evidence:
    """Eqs. (1)-(3) from the velocity of each point; `cross_term` is the factor 2 in the radicand."""
    printed = 1 + ids.k**2 + rational(cross_term) * ids.k * ids.c
    moment = ids.cross((ids.c, ids.s), _POINT)
    integrands = identity(
        {
            "the numerator of Eq. (2)": ids.normal(_POINT[1] - lemmas.FORCE),
            "the numerator of Eq. (3)": ids.normal(moment - lemmas.TORQUE),
            "the radicand": ids.normal(ids.dot(_POINT, _POINT) - printed),
        }
    )
    return together(integrands, lemmas.no_sideways_force())


@proof
def closed_forms() -> Evidence:
    """Eqs. (2)-(3) as complete elliptic integrals."""
    start = 2 / arb.pi() * acb(0).elliptic_e().real
    return together(
        lemmas.rates(),
        near(start, 1.0, 1e-30),
        lemmas.torque_rate(),
        lemmas.elliptic_rates(),
        lemmas.duality(),
    )


def elliptic(k: arb) -> tuple[arb, arb]:
    """The closed forms of Eqs. (2)-(3) at an exact k other than 1."""
    if k > 1:
        return elliptic(1 / k)[::-1]
    first, second = acb(k * k).elliptic_k().real, acb(k * k).elliptic_e().real
    return 2 / arb.pi() * second, 2 / arb.pi() * (second - (1 - k * k) * first) / k


def printed_integrals(k: arb) -> tuple[arb, arb, arb]:
    """Eqs. (1)-(3) as printed, per unit weight, by rigorous quadrature at an exact k other than 1."""

    def mean(numerator: Callable[[acb], acb]) -> arb:
        def integrand(theta: acb, analytic: bool) -> acb:
            # 1 + k^2 + 2 k cos(theta), written so that balls retain its minimum at theta = pi.
            square = (1 - k) ** 2 + 4 * k * (theta / 2).cos() ** 2
            return numerator(theta) / square.sqrt(analytic=analytic)

        halves = (
            acb.integral(integrand, side * arb.pi(), (side + 1) * arb.pi()) for side in (0, 1)
        )
        return sum(halves, acb(0)).real / (2 * arb.pi())

    return (
        mean(lambda theta: -k * theta.sin()),
        mean(lambda theta: 1 + k * theta.cos()),
        mean(lambda theta: k + theta.cos()),
    )


@sample
def closed_forms_on_grid(least_ratio: float, greatest_ratio: float, count: float) -> Evidence:
    """Differences of the closed forms, and of those of the proofs, from the integrals as printed."""
    low, high, steps = arb(rational(least_ratio)), arb(rational(greatest_ratio)), int(count) - 1
    gaps = []
    for i in range(steps + 1):
        k = (low * (high / low) ** (arb(i) / steps)).mid()
        sideways, *integrals = printed_integrals(k)
        pairs = zip((*elliptic(k), *profile(k)), integrals * 2, strict=True)
        gaps += [abs(sideways), *(abs(value - integral) for value, integral in pairs)]
    widest = -smallest(-gap for gap in gaps)
    return inequality(arb(10) ** -25 - widest, value=widest, points=len(gaps))


def _to_fence_frame(
    force: tuple[ids.Polynomial, ids.Polynomial],
) -> tuple[ids.Polynomial, ids.Polynomial]:
    """Rotate a vector from the primed frame to the frame of the fence; x' is at phi - 90 degrees."""
    return force[0] * ids.y + force[1] * ids.x, -force[0] * ids.x + force[1] * ids.y


@proof
def fence_frame(rod_angle: float) -> Evidence:
    """Eqs. (4)-(6)."""
    along, across = _to_fence_frame((0 * ids.f, ids.f))
    moment = ids.cross((ids.l * ids.p, ids.l * ids.q), (ids.f * ids.x, ids.f * ids.y))
    torque = moment - ids.l * ids.f * (ids.y * ids.p - ids.x * ids.q)
    claimed, printed = (at_degrees(degrees).exact or () for degrees in (rod_angle, 45.0))
    differences = {
        "f_x": ids.normal(along - ids.f * ids.x),
        "f_y": ids.normal(across - ids.f * ids.y),
        "tau_0": ids.normal(torque),
    }
    differences |= {f"psi = {rod_angle:g}": a - b for a, b in zip(claimed, printed, strict=True)}
    return identity(differences)


@proof
def unique_center() -> Evidence:
    """Eq. (7) has one root; the center is at -1 / k on x'."""
    at_rest = ids.k + ids.k * -ids.ONE  # 1 + k x', times k, at x' = -1 / k
    return together(lemmas.rising_arm(), identity({"the velocity of the center": at_rest}))


@proof
def rotation_sense(sign: float) -> Evidence:
    """The sign printed below Eq. (7): `sign` times tau_0' has the sign of omega."""
    sense = rational(sign)
    return together(boxes.positive(lambda a, b: sense * boxes.turn(a, b)), lemmas.rates())


@proof
def self_duality(force: float, within: float) -> Evidence:
    """Identity f(1 / k) = t(k) for k > 0, and both values at k = 1."""
    half = 2 * ids.c**2 - 1  # cos(theta) by c = cos(theta / 2)
    top, bottom = (
        ids.substitute(part, k=ids.ONE, c=half) for part in (lemmas.FORCE, lemmas.RADICAND)
    )
    centered = identity({"the integrand at k = 1": top**2 - bottom * ids.c**2})
    return together(near(2 / arb.pi(), force, within, "W"), lemmas.duality(), centered)
