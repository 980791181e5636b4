"""Sec. 4: Eqs. (8)-(13), and the geometry of acceleration centers."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import (
    cosine_sine,
    exact_direction,
    in_degrees,
    rational,
    sign,
)
from planar_pushing.certified.cones import pulls
from planar_pushing.certified.setting import Effects, Slider
from planar_pushing.evidence.claims.proofs import boxes, lemmas
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.registry import proof
from planar_pushing.evidence.claims.verdicts import (
    Evidence,
    equal,
    facts,
    identity,
    inequality,
    near,
    together,
)

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
    """Eqs. (8)-(12).

    All mass of the ring is at the distance 1 from its center, which is therefore its radius of
    gyration. Newton's law for a unit mass gives Eqs. (8) and (9), and the moment of the force about the
    center gives Eq. (10). The acceleration of the rod's end is that of the center plus $alpha_c$ times
    the vector from the center to the end, rotated by 90 degrees: Eqs. (11) and (12). All five are
    polynomial identities in the force and in the sines and cosines of $phi$ and $psi$.
    """
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


def _coefficients(rod_length: float) -> tuple[tuple[arb, arb], tuple[ids.Polynomial, ...]]:
    """Coefficients of f_y and of -f_x in Eq. (13) at psi = 45 degrees: balls, and exactly."""
    square, (c, s) = rational(rod_length) ** 2, cosine_sine(fmpq(45))
    cosine, sine = exact_direction(fmpq(45))
    balls = 1 + square * c * c, square * s * c
    return balls, (1 + square * cosine * cosine, square * sine * cosine)


@proof
def pulling_condition(rod_length: float, normal: float, tangential: float) -> Evidence:
    """Eq. (13), and its form for psi = 45 degrees.

    The left side of Eq. (13) is $a_(s y)$ of Eq. (12), an identity for every $l$, $psi$, and force. At
    $psi = 45°$ and $l = 2$ its coefficients are 3 and 2, in exact arithmetic with $cos 45°$.
    """
    balls, exact = _coefficients(rod_length)
    coefficients = [
        equal(ball, claimed, known)
        for claimed, ball, known in zip((normal, tangential), balls, exact, strict=True)
    ]
    printed = identity({"a_sy": ids.normal(_rod_end(1.0)[1] - _PRINTED[1])})
    return together(*coefficients, printed)


@proof
def inertia_threshold(rod_length: float, threshold: float) -> Evidence:
    """The coefficient above which the fence pulls under inertia, exactly.

    Under the force of the right edge, $f_x = mu f_y$, the left side of Eq. (13) is linear in $mu$ with
    a negative slope and vanishes at the threshold, in exact arithmetic with $cos 45°$. The enclosed
    edges of the acceleration cone agree: pulling is impossible at the threshold and possible just above
    it.
    """
    (normal, tangential), exact = _coefficients(rod_length)
    mu, slider = rational(threshold), Slider.of(rod_length)
    rest = sign(normal - mu * tangential, lambda: exact[0] - mu * exact[1])
    found = {
        f"a_sy = 0 at mu = {threshold:g}": rest == 0,
        "falling with mu": bool(tangential > 0),
        "no pulling at it": not pulls(slider, Effects.INERTIA, threshold),
        "pulling just beyond": pulls(slider, Effects.INERTIA, threshold + 2.0**-40),
    }
    return facts(found, value=normal / tangential, unit="1", claimed=threshold)


@proof
def rod_on_a_wall(numerator: float, denominator: float) -> Evidence:
    """Eq. (13) for a uniform rod has the critical coefficient numerator / denominator.

    A uniform rod held at its end has $(l / rho)^2 = 3$. With $c = cos psi$ and $s = sin psi$, the
    condition of Eq. (13) reads $1 + 3 c^2 - 3 mu s c < 0$. At $mu = 4 / 3$ the left side is the square
    $(s - 2 c)^2$, an identity, which vanishes only at $tan psi = 2$. For a smaller $mu$ the left side
    is positive for every $psi$; for a larger $mu$ it is negative at $tan psi = 2$.
    """
    critical = rational(numerator) / rational(denominator)
    square = (ids.s - 2 * ids.c) ** 2
    rest = 1 + 3 * ids.c**2 - 3 * critical * ids.s * ids.c - square
    found = (1 + fmpq(3, 5)) / fmpq(6, 5)  # tan psi = 2: c^2 = 1/5 and s c = 2/5
    number = facts(
        {"the coefficient": found == critical},
        value=arb(found), unit="1", claimed=numerator / denominator,
    )  # fmt: skip
    return together(number, identity({"the square": ids.normal(rest)}))


@proof
def centers_on_a_line(rod_length: float, distance: float) -> Evidence:
    """Fig. 9: under inertia every center has the component rho^2 / l along the rod; rho = R = 1.

    The center is at $-1 / k$ on the $x'$ axis, with $k = h R / rho^2$. Its coordinate along the rod,
    measured from the ring's center away from the contact, is $rho^2 / l$ for every force angle, an
    identity. The centers therefore lie on a line perpendicular to the rod, the force dual of the
    contact.
    """
    along = ids.l * ids.dot((ids.y, -ids.x), (ids.p, ids.q)) + ids.ARM  # times -1 / k, k = h
    place = equal(1 / arb(rational(rod_length)), distance, unit="R")
    return together(place, identity({"the component along the rod": ids.normal(along)}))


def _forward() -> Evidence:
    """Evidence for F > 0: at least 2 / pi on [0, 1], and f(k) = t(1 / k) >= 1 / (2 k) beyond."""
    return together(
        boxes.positive(lambda _, high: ring.profile(high)[0]), boxes.positive(boxes.turn)
    )


@proof
def lines_of_force() -> Evidence:
    """Facts 1-3.

    The integrand of Eq. (1) is odd, so that friction acts along $y'$. The inertial force is along the
    acceleration of the ring's center, and hence along $y'$ too; the acceleration center is on $x'$. The
    force $f$ is at least $2 / pi$ on boxes that cover $[0, 1]$, and for $k > 1$, with $q = 1 / k$, $k
    f(k) = t(q) / q >= 1 / 2$ by duality. Friction therefore opposes the motion of the center for every
    $k$, as inertia does since $m > 0$. The two forces have the same direction along $y'$, and so does
    their sum.
    """
    return together(lemmas.no_sideways_force(), _forward())


@proof
def lines_opposite_center() -> Evidence:
    """Fact 4.

    The center is at $-1 / k$ on $x'$; the line of friction is at $H(k)$ and that of inertia at $k$,
    with $rho = R = 1$. Both have the sign of $k$, since $t / k$ is at least $1 / 2$ on boxes that cover
    $[0, 1]$ and $t$ increases for $k > 1$.
    """
    return together(lemmas.same_sense(), _forward())


def _tangent(arm: float = 1.0) -> Evidence:
    """H(1) = 1, by duality."""
    force, torque = ring.profile(arb(1))
    return together(near(torque / force, arm, 1e-30, "R"), lemmas.duality())


@proof
def line_and_center(moment_arm: float) -> Evidence:
    """Facts 5-7: H - 1 has the sign of k - 1.

    Let $k > 0$; the case $k < 0$ is its mirror image. The integrands of Eqs. (2) and (3) agree at $k =
    1$, so that $H(1) = 1$: the line is tangent to the ring. The arm $H$ increases, with a positive
    derivative on boxes that cover $[0, 1]$ and by duality for $k > 1$, so that $H - 1$ has the sign of
    $k - 1$. For inertia $h = k$, with $rho = R = 1$.
    """
    return together(_tangent(moment_arm), lemmas.rising_arm())


@proof
def cases_by_line_of_force() -> Evidence:
    """Cases 1-7: center inside, on, outside the ring or at infinity; here b is h.

    Let $h >= 0$; the case $h < 0$ is its mirror image. With the share $sigma$ of inertia, between 0 and
    1, the balance of torque is $(1 - sigma) (t - h f) + sigma (k - h)$, with $rho = R = 1$. For $k < 0$
    both terms are negative, and for $k >= 0$ the balance increases. At $k = 0$ it is $-h$, and at $k =
    1$ it is $(1 - h) ((1 - sigma) f + sigma)$, both identities. Therefore the root $k$ has the sign of
    $h$, and $k - 1$ has the sign of $h - 1$, for every $sigma$.
    """
    rest = 1 - ids.a
    on_ring = rest * (ids.f - ids.b * ids.f) + ids.a * (1 - ids.b)
    still = rest * (0 - ids.b) - ids.a * ids.b  # f(0) = 1, t(0) = 0
    found = {
        "the balance at k = 1": on_ring - (1 - ids.b) * (rest * ids.f + ids.a),
        "the balance at k = 0": still + ids.b,
    }
    return together(identity(found), lemmas.rising_arm())


@proof
def center_on_ring_pulls(rod_length: float) -> Evidence:
    """Fig. 11: k = 1 under the tangent on the right, for every share of inertia.

    At $k = 1$, where $f = t$, friction and inertia have the same line of force, the tangent, whatever
    their magnitudes. For the tangent on the right $phi = psi - arcsin(1 / l)$, and $bold(n) dot
    bold(a)_s = sin phi - l cos psi$ per unit acceleration of the center. For $l = 5$ and $psi = 45°$
    this is negative, by ball arithmetic, while the force points into the slider.
    """
    length = arb(rational(rod_length))
    tilt = in_degrees((1 / length).asin())
    cosine, _ = cosine_sine(fmpq(45))
    into = ((45 - tilt) / 180).sin_pi()
    away = inequality(length * cosine - into, value=into - length * cosine)
    return together(away, inequality(into), _tangent())
