"""Sec. 4: inertia alone, Eqs. (8)-(13), and its acceleration cones."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified.balls import cosine_sine, exact_direction, rational, sign
from planar_pushing.certified.cones import motion_cone, pulls
from planar_pushing.certified.contact.modes import Mode, coulomb
from planar_pushing.certified.setting import Effects, Slider
from planar_pushing.evidence.claims.checks.infinite_friction import slips_beyond_edge
from planar_pushing.evidence.claims.checks.velocity_cones import EDGES, cone_edges
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs.examples import modes_are
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    equal,
    facts,
    identity,
    inequality,
    together,
)

_NEWTON = "Newton's law, exactly"
_FORCE = ids.f * ids.x, ids.f * ids.y


@check
def acceleration_along_fence(mass: float) -> Evidence:
    """Eq. (8) from m a_cx = f_x."""
    return identity({"a_cx": rational(mass) * _FORCE[0] - _FORCE[0]}, _NEWTON)


@check
def acceleration_across_fence(mass: float) -> Evidence:
    """Eq. (9) from m a_cy = f_y."""
    return identity({"a_cy": rational(mass) * _FORCE[1] - _FORCE[1]}, _NEWTON)


def _torque() -> ids.Polynomial:
    """Torque about the center of a force at the contact, which lies at -l (cos psi, sin psi)."""
    return ids.cross((-ids.l * ids.p, -ids.l * ids.q), _FORCE)


@check
def gyration_of_ring(gyration_radius: float) -> Evidence:
    """A point of the ring at (cos, sin) has this distance from the center, squared."""
    size = ids.c**2 + ids.s**2 - rational(gyration_radius) ** 2
    return identity({"the mean square distance": ids.normal(size)}, "all mass is at R = 1, exactly")


@check
def angular_acceleration(gyration_radius: float) -> Evidence:
    """Eq. (10) from m rho^2 alpha = torque."""
    printed = _FORCE[0] * ids.l * ids.q - _FORCE[1] * ids.l * ids.p
    size = rational(gyration_radius) ** 2
    return identity({"alpha_c": ids.normal(size * printed - _torque())}, _NEWTON)


def _rod_end(gyration_radius: float) -> tuple[ids.Polynomial, ids.Polynomial]:
    """a_s = a_c + alpha x r with r from the center to the contact."""
    alpha = _torque() / rational(gyration_radius) ** 2
    return _FORCE[0] + alpha * ids.l * ids.q, _FORCE[1] - alpha * ids.l * ids.p


def _printed_across() -> ids.Polynomial:
    """Right side of Eq. (12) and left side of Eq. (13)."""
    own = _FORCE[1] * (1 + ids.l**2 * ids.p**2)
    return own - _FORCE[0] * ids.l**2 * ids.q * ids.p


@check
def rod_end_along_fence(gyration_radius: float) -> Evidence:
    """Eq. (11)."""
    printed = _FORCE[0] * (1 + ids.l**2 * ids.q**2) - _FORCE[1] * ids.l**2 * ids.q * ids.p
    return identity({"a_sx": ids.normal(_rod_end(gyration_radius)[0] - printed)}, _NEWTON)


@check
def rod_end_across_fence(gyration_radius: float) -> Evidence:
    """Eq. (12)."""
    difference = ids.normal(_rod_end(gyration_radius)[1] - _printed_across())
    return identity({"a_sy": difference}, _NEWTON)


@check
def pulling_condition(rod_length: float, friction_coefficient: float) -> Evidence:
    """Eq. (13): its left side is a_sy, and at an example it is negative where the fence can pull."""
    difference = ids.normal(_rod_end(1.0)[1] - _printed_across())
    length, mu = rational(rod_length), rational(friction_coefficient)
    method = "the left side is a_sy, an identity for every l, psi and force"
    value = 1 + length**2 / 2 - mu * length**2 / 2
    example = inequality(arb(-value), method, value=arb(value), unit="f_y")
    possible = facts({"pulls": pulls(Slider.of(rod_length), Effects.INERTIA, float(mu))}, method)
    return together(example, possible, identity({"a_sy": difference}, method))


def _coefficients(rod_length: float) -> tuple[tuple[arb, arb], tuple[ids.Polynomial, ...]]:
    """Coefficients of f_y and of -f_x in Eq. (13) at psi = 45 degrees: balls, and exactly."""
    square, (c, s) = rational(rod_length) ** 2, cosine_sine(fmpq(45))
    cosine, sine = exact_direction(fmpq(45))
    balls = 1 + square * c * c, square * s * c
    return balls, (1 + square * cosine * cosine, square * sine * cosine)


@check
def condition_coefficients(rod_length: float, normal: float, tangential: float) -> Evidence:
    """Below Eq. (13): 3 f_y - 2 mu f_y."""
    balls, exact = _coefficients(rod_length)
    method = "cos and sin of 45 degrees in exact arithmetic"
    return together(
        *(
            equal(ball, claimed, method, known)
            for claimed, ball, known in zip((normal, tangential), balls, exact, strict=True)
        )
    )


@check
def inertia_threshold(rod_length: float, threshold: float) -> Evidence:
    """Below Eq. (13): the coefficient beyond which the fence pulls, exactly."""
    (normal, tangential), exact = _coefficients(rod_length)
    mu, slider = rational(threshold), Slider.of(rod_length)
    rest = sign(normal - mu * tangential, lambda: exact[0] - mu * exact[1])
    found = {
        f"a_sy = 0 at mu = {threshold:g}": rest == 0,
        "no pulling at it": not pulls(slider, Effects.INERTIA, threshold),
        "pulling just beyond": pulls(slider, Effects.INERTIA, threshold + 2.0**-40),
    }
    method = "ratio of the coefficients of Eq. (13) in exact arithmetic"
    return facts(found, method, value=normal / tangential, unit="1", claimed=threshold)


@check
def positive_inertial_work() -> Evidence:
    """F . a_s = 1 + h^2 for a unit force on a unit mass with unit radius of gyration."""
    work = ids.normal(ids.dot((ids.x, ids.y), _inertial()) - 1 - ids.ARM**2)
    method = "f . a_s = 1 + h^2 >= 1, an identity; every force angle, l and psi"
    return together(inequality(arb(1), method), identity({"f . a_s": work}, method))


def _inertial() -> tuple[ids.Polynomial, ids.Polynomial]:
    """Motion with k = h, Eq. (10)."""
    return ids.replaced(ids.MOTION[0], k=ids.ARM), ids.replaced(ids.MOTION[1], k=ids.ARM)


@check
def acceleration_turns_with_force() -> Evidence:
    """|a_s|^2 d theta / d phi = 1 + l^2, whatever the force angle."""
    rate = ids.l * -(ids.p * ids.x + ids.q * ids.y)  # dh / dphi
    turned = (-ids.y + rate * ids.l * ids.q, ids.x - rate * ids.l * ids.p)
    difference = ids.normal(ids.cross(_inertial(), turned) - 1 - ids.l**2)
    method = "|a_s|^2 d theta / d phi = 1 + l^2 >= 1, an identity; every l and psi"
    return together(inequality(arb(1), method), identity({"the turning": difference}, method))


@check
def acceleration_cone(
    rod_length: float, friction_coefficient: float, right: float, left: float, within: float
) -> Evidence:
    """Both edges of an acceleration cone, in degrees."""
    return cone_edges(Effects.INERTIA, rod_length, friction_coefficient, (right, left), within)


@check
def acceleration_cone_reaches_away(
    rod_length: float, friction_coefficient: float, pusher_angle: float
) -> Evidence:
    """The right edge is below the fence, and a pusher between both can pull."""
    cone = motion_cone(Slider.of(rod_length), Effects.INERTIA, friction_coefficient)
    away = inequality(-cone.right, EDGES, value=cone.right, unit="degree", claimed=0.0)
    expected, law = (Mode.SEPARATE, Mode.STICK, Mode.SLIP_LEFT), coulomb(friction_coefficient)
    pull = modes_are(expected, rod_length, Effects.INERTIA, law, pusher_angle)
    return together(away, pull)


@check
def slip_with_inertia(rod_length: float, pusher_angle: float) -> Evidence:
    """Slip is the only solution from this pusher angle up to 180 degrees."""
    return slips_beyond_edge(Effects.INERTIA, rod_length, pusher_angle)


@check
def rod_on_a_wall(numerator: float, denominator: float) -> Evidence:
    """Eq. (13) with (l / rho)^2 = 3, a uniform rod held at its end.

    The coefficient is (1 + 3 c^2) / (3 s c), least where the square (s - 2 c)^2 vanishes.
    """
    critical = rational(numerator) / rational(denominator)
    square = (ids.s - 2 * ids.c) ** 2
    rest = 1 + 3 * ids.c**2 - 3 * critical * ids.s * ids.c - square
    method = "1 + 3 c^2 - 3 mu s c = (s - 2 c)^2 at the least mu, an identity"
    found = (1 + fmpq(3, 5)) / fmpq(6, 5)  # tan psi = 2: c^2 = 1/5 and s c = 2/5
    number = facts(
        {"the coefficient": found == critical}, method, value=arb(found), unit="1",
        claimed=numerator / denominator,
    )  # fmt: skip
    return together(number, identity({"the square": ids.normal(rest)}, method))
