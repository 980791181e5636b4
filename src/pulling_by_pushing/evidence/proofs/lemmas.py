"""Lemmas on the ring, each with its evidence, for every rod and every force angle."""

from __future__ import annotations

from flint import arb

from pulling_by_pushing.evidence.proofs import boxes
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.boxes import positive
from pulling_by_pushing.evidence.proofs.mechanics import profile
from pulling_by_pushing.evidence.proofs.verdicts import Evidence, identity, together

#: Numerators of the integrands of Eqs. (2)-(3), and the square of their denominator.
FORCE, TORQUE = 1 + ids.k * ids.c, ids.k + ids.c
RADICAND = 1 + ids.k**2 + 2 * ids.k * ids.c


def no_sideways_force() -> Evidence:
    """Evidence for Eq. (1): the integrand is odd about theta = pi."""
    odd = -ids.k * ids.s
    return identity(
        {
            "the numerator and its mirror image": odd + ids.substitute(odd, s=-ids.s),
            "the radicand": RADICAND - ids.substitute(RADICAND, s=-ids.s),
        }
    )


def rates() -> Evidence:
    """Evidence that t' is the mean of sin^2 / speed^3, and f' = -k t', from the integrands."""
    force, torque = (
        part.derivative("k") * RADICAND - part * (ids.k + ids.c) for part in (FORCE, TORQUE)
    )
    return identity(
        {
            "t' minus the mean of sin^2 / speed^3": ids.normal(torque - ids.s**2),
            "f' + k t'": ids.normal(force + ids.k * torque),
        }
    )


def duality() -> Evidence:
    """Evidence for f(1 / k) = t(k): the integrand of Eq. (2) at 1 / k is that of Eq. (3) at k > 0."""
    return identity(
        {
            "the radicand": RADICAND - _reverse(RADICAND, 2),
            "the numerator": TORQUE - _reverse(FORCE, 1),
        }
    )


def _reverse(polynomial: ids.Polynomial, power: int) -> ids.Polynomial:
    """k^power times the polynomial at 1 / k."""
    context = polynomial.context()
    index, coefficients = context.names().index("k"), {}
    for exponents, coefficient in polynomial.to_dict().items():
        powers = list(exponents)
        powers[index] = power - powers[index]
        coefficients[tuple(powers)] = coefficient
    return context.from_dict(coefficients)


def torque_rate() -> Evidence:
    """Evidence for ``t' = (f - k t) / (1 - k^2) - t / k``, from the integrands, 0 < k < 1.

    The right side is the mean of -cos / (k speed). It equals t', the mean of sin^2 / speed^3, because
    their difference is the derivative of sin / (k speed) around the ring.
    """

    def angle_derivative(polynomial: ids.Polynomial) -> ids.Polynomial:
        return polynomial.derivative("s") * ids.c - polynomial.derivative("c") * ids.s

    # The derivative times k speed^3, and the right side times k (1 - k^2) speed.
    derivative = angle_derivative(ids.s) * RADICAND - ids.s * angle_derivative(RADICAND) / 2
    right = (FORCE - ids.k * TORQUE) * ids.k - TORQUE * (1 - ids.k**2)
    return identity(
        {
            "sin^2 / speed^3 + cos / (k speed)": ids.normal(
                ids.k * ids.s**2 + ids.c * RADICAND - derivative
            ),
            "the right side": ids.normal(right + ids.c * (1 - ids.k**2)),
        }
    )


def elliptic_rates() -> Evidence:
    """Evidence that E and (E - (1 - k^2) K) / k satisfy the equations of f and t.

    The derivatives of K = b and E = a are those of DLMF 19.4.1-2: ``k a' = a - b`` and ``k (1 - k^2) b'
    = a - (1 - k^2) b``.
    """
    rest = 1 - ids.k**2
    torque = ids.a - rest * ids.b  # times k
    rate = (ids.a - ids.b) + 2 * ids.k**2 * ids.b - (ids.a - rest * ids.b)  # (k t)', times k
    steep = rate - torque  # t', times k^2
    return identity(
        {
            "t' by (f - k t) / (1 - k^2) - t / k": steep * rest
            - ids.k**2 * (ids.a - torque)
            + rest * torque,
            "f' by -k t'": (ids.a - ids.b) + steep,
        }
    )


def rising_torque() -> Evidence:
    """Evidence for t' > 0, and hence for t > 0 and a decreasing f, at every k > 0."""
    return together(positive(boxes.slope), rates())


def rising_arm() -> Evidence:
    """Evidence that H = t / f increases from 0 to infinity: on [0, 1] by boxes, beyond by duality."""
    return together(positive(boxes.arm_slope), rates(), duality())


def same_sense() -> Evidence:
    """Evidence that k and the moment arm have the same sign: t / k > 0 on [0, 1], t increases beyond."""
    return together(positive(boxes.turn), rates())


def least_work(low: arb, high: arb) -> arb:
    """Lower bound of 1 + k h on a box: k h = k t / f >= 0 there, and beyond by duality."""
    return 1 + low**2 * boxes.turn(low, low) / profile(low)[0]


def work() -> Evidence:
    """Evidence for f . u = 1 + k h with a unit force and a unit speed of the center."""
    power = ids.dot((ids.x, ids.y), ids.MOTION)
    return identity({"f . u": ids.normal(power - 1 - ids.k * ids.ARM)})


def positive_work() -> Evidence:
    """Evidence for f . u > 0, for any share of inertia: k h >= 0 under each effect."""
    return together(positive(least_work), work(), same_sense())


def turning() -> Evidence:
    """Evidence for u x du/dphi = 1 + k h - e l cos(psi - phi), with e = dk/dphi."""
    rate = -ids.y + ids.e * ids.l * ids.q, ids.x - ids.e * ids.l * ids.p
    rest = 1 + ids.k * ids.ARM - ids.e * ids.l * ids.ROD_COSINE
    return identity({"u x du/dphi": ids.normal(ids.cross(ids.MOTION, rate) - rest)})


def inertial_turning() -> Evidence:
    """Evidence for u x du/dphi = 1 + e l^2 and f . u = 1 + e h^2 under inertia, e = (R / rho)^2."""
    spin = ids.e * ids.ARM
    motion = tuple(ids.substitute(part, k=spin) for part in ids.MOTION)
    rate = ids.e * ids.l * -ids.ROD_COSINE  # derivative of the spin ratio by phi
    motion_rate = -ids.y + rate * ids.l * ids.q, ids.x - rate * ids.l * ids.p
    turning = ids.cross((motion[0], motion[1]), motion_rate) - 1 - ids.e * ids.l**2
    work = ids.dot((ids.x, ids.y), (motion[0], motion[1])) - 1 - ids.e * ids.ARM**2
    return identity({"u x du/dphi": ids.normal(turning), "f . u": ids.normal(work)})
