"""Sec. 4: Eqs. (8)-(13), and the geometry of acceleration centers."""

from __future__ import annotations

from flint import arb, fmpq

from pulling_by_pushing.evidence.proofs import boxes, lemmas
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs.mechanics import INERTIA, Mechanics, Scene, profile
from pulling_by_pushing.evidence.proofs.registry import proof
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    equal,
    facts,
    identity,
    inequality,
    near,
    together,
)
from pulling_by_pushing.oracle.balls import cosine_sine, in_degrees, rational, sign

#: How far beside a threshold of the coefficient of friction the cones are asked for.
_BESIDE = 2.0**-36
_FORCE = ids.f * ids.x, ids.f * ids.y
#: Torque about the center of a force at the contact, which lies at -l (cos psi, sin psi).
_TORQUE = ids.cross((-ids.l * ids.p, -ids.l * ids.q), _FORCE)
#: Right sides of Eqs. (11) and (12).
_PRINTED = (
    _FORCE[0] * (1 + ids.l**2 * ids.q**2) - _FORCE[1] * ids.l**2 * ids.q * ids.p,
    _FORCE[1] * (1 + ids.l**2 * ids.p**2) - _FORCE[0] * ids.l**2 * ids.q * ids.p,
)


def _rod_end(gyration_radius: float) -> tuple[ids.Polynomial, ids.Polynomial]:
    """a_s = a_c + alpha x r, with r from the center to the contact."""
    alpha = _TORQUE / rational(gyration_radius) ** 2
    return _FORCE[0] + alpha * ids.l * ids.q, _FORCE[1] - alpha * ids.l * ids.p


@proof
def equations_of_motion(mass: float, gyration_radius: float) -> Evidence:
    """Eqs. (8)-(12)."""
    size, rho = rational(mass), rational(gyration_radius)
    printed = _FORCE[0] * ids.l * ids.q - _FORCE[1] * ids.l * ids.p
    end = _rod_end(gyration_radius)
    return identity(
        {
            "the radius of gyration": ids.normal(ids.c**2 + ids.s**2 - rho**2),
            "a_cx": size * _FORCE[0] - _FORCE[0],
            "a_cy": size * _FORCE[1] - _FORCE[1],
            "alpha_c": ids.normal(rho**2 * printed - _TORQUE),
            "a_sx": ids.normal(end[0] - _PRINTED[0]),
            "a_sy": ids.normal(end[1] - _PRINTED[1]),
        }
    )


def _coefficients(rod_length: float) -> tuple[fmpq, fmpq]:
    """Coefficients of f_y and of -f_x in Eq. (13) at psi = 45 degrees, where cos^2 = sin cos = 1 / 2."""
    half = rational(rod_length) ** 2 / 2
    return 1 + half, half


@proof
def pulling_condition(rod_length: float, normal: float, tangential: float) -> Evidence:
    """Eq. (13), and its form for psi = 45 degrees."""
    pairs = zip(_coefficients(rod_length), (normal, tangential), strict=True)
    coefficients = [equal(arb(exact), claimed) for exact, claimed in pairs]
    printed = identity({"a_sy": ids.normal(_rod_end(1.0)[1] - _PRINTED[1])})
    return together(*coefficients, printed)


@proof
def inertia_threshold(mechanics: Mechanics, rod_length: float, threshold: float) -> Evidence:
    """The coefficient above which the fence pulls under inertia, exactly."""
    normal, tangential = _coefficients(rod_length)
    before, beyond = (
        mechanics.motion_cone(Scene(rod_length=rod_length, law=threshold + gap, effects=INERTIA))[0]
        for gap in (-_BESIDE, _BESIDE)
    )
    decided = {
        f"a_sy = 0 at mu = {threshold:g}": normal == rational(threshold) * tangential,
        "falling with mu": tangential > 0,
        "no pulling just below": sign(before) > 0,
        "pulling just beyond": sign(beyond) < 0,
    }
    return facts(decided, value=arb(normal / tangential), unit="1", claimed=threshold)


@proof
def rod_on_a_wall(numerator: float, denominator: float) -> Evidence:
    """Eq. (13) for a uniform rod has the critical coefficient numerator / denominator."""
    critical = rational(numerator) / rational(denominator)
    square = (ids.s - 2 * ids.c) ** 2
    rest = 1 + 3 * ids.c**2 - 3 * critical * ids.s * ids.c - square
    coefficient = (1 + fmpq(3, 5)) / fmpq(6, 5)  # tan psi = 2: c^2 = 1/5 and s c = 2/5
    number = facts(
        {"the coefficient": coefficient == critical},
        value=arb(coefficient), unit="1", claimed=numerator / denominator,
    )  # fmt: skip
    return together(number, identity({"the square": ids.normal(rest)}))


@proof
def centers_on_a_line(rod_length: float, distance: float) -> Evidence:
    """Fig. 9: under inertia every center has the component rho^2 / l along the rod; rho = R = 1."""
    along = ids.l * ids.dot((ids.y, -ids.x), (ids.p, ids.q)) + ids.ARM  # times -1 / k, k = h
    component = equal(1 / arb(rational(rod_length)), distance, unit="R")
    return together(component, identity({"the component along the rod": ids.normal(along)}))


def _forward() -> Evidence:
    """Evidence for F > 0: at least 2 / pi on [0, 1], and f(k) = t(1 / k) >= 1 / (2 k) beyond."""
    return together(boxes.positive(lambda _, high: profile(high)[0]), boxes.positive(boxes.turn))


@proof
def lines_of_force() -> Evidence:
    """Facts 1-3."""
    return together(lemmas.no_sideways_force(), _forward())


@proof
def lines_opposite_center() -> Evidence:
    """Fact 4."""
    return together(lemmas.same_sense(), _forward())


def _tangent(arm: float = 1.0) -> Evidence:
    """H(1) = 1, by duality."""
    force, torque = profile(arb(1))
    return together(near(torque / force, arm, 1e-30, "R"), lemmas.duality())


@proof
def line_and_center(moment_arm: float) -> Evidence:
    """Facts 5-7: H - 1 has the sign of k - 1."""
    return together(_tangent(moment_arm), lemmas.rising_arm())


@proof
def cases_by_line_of_force() -> Evidence:
    """Cases 1-7: center inside, on, outside the ring or at infinity; here b is h."""
    rest = 1 - ids.a
    on_ring = rest * (ids.f - ids.b * ids.f) + ids.a * (1 - ids.b)
    still = rest * (0 - ids.b) - ids.a * ids.b  # f(0) = 1, t(0) = 0
    balances = {
        "the balance at k = 1": on_ring - (1 - ids.b) * (rest * ids.f + ids.a),
        "the balance at k = 0": still + ids.b,
    }
    return together(identity(balances), lemmas.rising_arm())


@proof
def center_on_ring_pulls(rod_length: float) -> Evidence:
    """Fig. 11: k = 1 under the tangent on the right, for every share of inertia."""
    length = arb(rational(rod_length))
    tilt = in_degrees((1 / length).asin())
    cosine, _ = cosine_sine(fmpq(45))
    into = ((45 - tilt) / 180).sin_pi()
    away = inequality(length * cosine - into, value=into - length * cosine)
    return together(away, inequality(into), _tangent())
