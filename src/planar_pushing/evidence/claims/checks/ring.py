"""Eqs. (1)-(7): friction of the ring, force in the frame of the fence, balance of torque."""

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

    In the primed frame the center of the ring moves at $v$ along $y'$. With $k = omega / v$ and $R =
    1$, the point at the angle $theta$ has the velocity $v (-k sin theta, 1 + k cos theta)$. The
    friction force per unit weight that it exerts on the support is the unit vector along this velocity.
    The $y'$ component of this vector and its moment about the center are the integrands of Eqs. (2) and
    (3); their radicand is the squared speed divided by $v^2$. The $x'$ component is odd about $theta =
    pi$, so that its integral over the ring vanishes, which is Eq. (1). All steps are polynomial
    identities in $sin theta$ and $cos theta$, verified by reduction to normal form.
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

    There are two pairs of functions $(f, t)$, the integrals and the elliptic forms. For $0 < k < 1$
    both pairs satisfy $f' = -k t'$ and $t' = (f - k t) / (1 - k^2) - t / k$. For the integrals, the two
    sides of the first equation have equal integrands; those of the second differ by a derivative with
    respect to $theta$, whose integral around the ring vanishes. For the elliptic forms, both equations
    follow from the derivatives of $E$ and $K$ (DLMF 19.4). The solutions that remain finite at $k = 0$
    are multiples of one another, and $f(0) = 1$ for both pairs; hence they agree. For $k > 1$, $f(k) =
    t(1 / k)$ and $t(k) = f(1 / k)$, because the integrand of Eq. (2) at $1 / k$ is that of Eq. (3) at
    $k$.
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
    """Difference between the closed forms and the integrals as printed, and of Eq. (1) from zero.

    At spin ratios spaced evenly on a logarithmic scale, rigorous quadrature of Eqs. (2)-(3) as printed
    agrees with the closed forms to within $10^(-25)$, and the integral of Eq. (1) is zero to within
    $10^(-25)$.
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
    """Rotate a vector from the primed frame to the frame of the fence; x' is at phi - 90 degrees."""
    return force[0] * ids.y + force[1] * ids.x, -force[0] * ids.x + force[1] * ids.y


@proof
def fence_frame(rod_angle: float) -> Evidence:
    """Eqs. (4)-(6).

    The $x'$ axis is the direction of the force rotated by $-90$ degrees. A force $f_(y')$ along $y'$
    therefore has the components $f_(y') cos phi$ along the fence and $f_(y') sin phi$ across it. The
    torque about the contact is the torque about the ring's center plus the moment $l f_(y') sin(phi -
    psi)$ of the force at the center; $psi$ is 45 degrees in the paper. These are polynomial identities
    in the sines and cosines of $phi$ and $psi$.
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

    Differentiation of the integrands gives $f' = -k t'$ and $t' > 0$ for $k > 0$. The moment arm $H = t
    / f$ thus has the derivative $H' = t' (f + k t) / f^2$, which has a positive lower bound on boxes
    that cover $[0, 1]$. By duality, $H(1 / k) = 1 / H(k)$, so that $H$ also increases for $k > 1$. It
    increases from 0 to infinity and is odd in $k$. With $R = 1$, Eq. (7) reads $H(k) = l sin(psi -
    phi)$ and therefore has exactly one root $k$ for each force angle and rod length. In this motion the
    point at $-1 / k = -v / omega$ on the $x'$ axis is at rest; for $k = 0$ the slider translates, and
    this point is at infinity.
    """
    at_rest = ids.k + ids.k * -ids.ONE  # 1 + k x', times k, at x' = -1 / k
    return together(lemmas.rising_arm(), identity({"the velocity of the center": at_rest}))


@proof
def rotation_sense(sign: float) -> Evidence:
    """The sign printed below Eq. (7): `sign` times tau_0' has the sign of omega.

    Let $omega$ be counterclockwise, as in Eqs. (2)-(3). The ratio $t / k$ is at least $1 / 2$ on boxes
    that cover $[0, 1]$, $t$ increases for $k > 1$, and $t$ is odd in $k$. Therefore $tau_(0')$ has the
    sign of $omega$ for every spin ratio, and $-tau_(0')$ has the opposite sign.
    """
    way = rational(sign)
    return together(boxes.positive(lambda a, b: way * boxes.turn(a, b)), lemmas.rates())


@proof
def self_duality(force: float, within: float) -> Evidence:
    """Identity f(1 / k) = t(k) for k > 0, and both values at k = 1.

    The integrand of Eq. (2) at $1 / k$ equals that of Eq. (3) at $k$, identically in $theta$; hence
    $f(1 / k) = t(k)$. The maxima of $f$ and $t$ are 1. At $k = 1$, where the center of rotation is on
    the ring, both integrands are $abs(cos(theta / 2))$, whose mean over the ring is $2 / pi$.
    """
    half = 2 * ids.c**2 - 1  # cos(theta) by c = cos(theta / 2)
    top, bottom = (
        ids.replaced(each, k=ids.ONE, c=half) for each in (lemmas.FORCE, lemmas.RADICAND)
    )
    centered = identity({"the integrand at k = 1": top**2 - bottom * ids.c**2})
    return together(near(2 / arb.pi(), force, within, "W"), lemmas.duality(), centered)
