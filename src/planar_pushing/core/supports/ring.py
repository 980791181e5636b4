r"""Friction of a ring with uniform pressure: force, torque and their slope in closed form (Eqs. 2-3).

With ``m = k^2``, ``x = 1 - m`` and the complete elliptic integrals K, E of parameter m, inside the ring::

    f(k) = (2/pi) E                    force along the motion, in units of W
    t(k) = (2/pi) (E - x K) / k        torque, in units of W R
    t'(k) = (2/pi) (K - E) / m         and f' = -k t'

and outside, by self-duality, ``f(k) = t(1/|k|)`` and ``t(k) = sign(k) f(1/|k|)``. Far from the ring a
Landen step, m -> q^2 with ``q = (1 - k') / (1 + k')`` and ``k' = sqrt(x)``, gives E and K as two power
series in q^2, whose leading terms are canceled analytically. Near the ring E and K are series in x and
``log x`` (DLMF 19.12).
"""

from __future__ import annotations

from math import fabs, log, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record
from planar_pushing.core.numbers import INFINITY, Coefficients, Numbers

TWO_BY_PI = 2.0 / 3.141592653589793
#: Above this spin ratio the series in x and log x are used, below it those of the Landen step.
NEAR_RING = 0.9
#: Chebyshev interpolants of the series on the range where each is used, in powers of its variable. Their
#: contribution to the result is accurate to 1e-16; a test recomputes them with 60 digits. In y = q^2:
#: ``(Q - 1) / y`` and ``(Q - P) / y^2`` with P = 2F1(-1/2, -1/2; 1; y), the series of E (Gauss-Kummer), and
#: Q = 2F1(1/2, 1/2; 1; y), that of K.
FAR_FIRST = (
    0.25000000000000006, 0.14062499999994713, 0.09765625001365902, 0.07476806503340462,
    0.060562204329880964, 0.050886909305350364, 0.0439177652053106, 0.03810616153039507,
    0.03782446460764198, 0.015631813216525955, 0.06470609318632879,
)  # fmt: skip
FAR_SECOND = (
    0.1249999999999992, 0.09375000000104759, 0.07324218727682609, 0.059814471506772854,
    0.05046767903438272, 0.0436373810550743, 0.038132026670576843, 0.036578330911736325,
    0.01909765156726422, 0.059885914086535014,
)  # fmt: skip
#: In x, with L = -log(x) / 2: ``E = 1 + x (L a + b)`` and ``E - x K = 1 + x (L c + d)``.
FORCE_LOG = (
    0.5, 0.18750000000003117, 0.11718749999220156, 0.0854492195117455, 0.06729122144694714,
    0.05551642215986849, 0.047232963056293396, 0.04139374843883687, 0.034353845332090543,
    0.043458940292445174, -0.004674813014226711, 0.08407803334091984,
)  # fmt: skip
FORCE_REST = (
    0.44314718055994534, 0.056805192709958305, 0.021831370448182244, 0.0115445210546696,
    0.007142015431666473, 0.004854377345554587, 0.0035201761722187595, 0.0026098960809256976,
    0.00240180124637138, 0.0005366979555088722, 0.003532711288509859,
)  # fmt: skip
TORQUE_LOG = (
    -0.5, -0.06249999999997841, -0.023437500004529113, -0.012207030880500954,
    -0.0074768220451003065, -0.005046471555089506, -0.003640522022567207, -0.002689089387889427,
    -0.0024639413402626153, -0.0005555770823409454, -0.003605054428073503,
)  # fmt: skip
TORQUE_REST = (
    -0.9431471805599453, -0.03976839757002871, -0.009053774082596827, -0.003393079363912447,
    -0.0016242979642924528, -0.0009004133240894815, -0.0005468326506166093, -0.0003826524849336343,
    -0.00015523762071687332, -0.0003810325862280515,
)  # fmt: skip
#: Smallest complement x of k^2, used on the ring, where K is infinite but contributes nothing to the
#: wrench; and ``-log(x) / 2`` for x of rounding size, which bounds the slope so that a Newton step from the
#: ring is not zero.
SMALLEST_COMPLEMENT = 1e-300
STEEPEST = 18.0
#: First guess of the inverse, fitted to 2e-6 by least squares: below NEAR_ARM = H(NEAR_RING), ``k / (2 h)``
#: in powers of h^2; above it, ``(1 - k) / (1 - h)`` in powers of ``1 - h`` (rows) and of
#: ``1 / (3 - log(1 - h))``.
NEAR_ARM = 0.7
FAR_GUESS = (
    0.999999760385, -1.49988611473, 3.7410008829, -11.1557958789, 33.9655182731, -91.5921831635,
    191.508490522, -275.550931762, 236.605542579, -90.2721427178,
)  # fmt: skip
NEAR_GUESS = (0.000156516413, 0.970322332, -1.09258578, 12.5808268, -30.0963718)
NEAR_GUESS_1 = (0.441440572, -5.0783755, 22.8687427)
NEAR_GUESS_2 = (-1.89847635, 5.78040765)
NEAR_GUESS_3 = (-1.29486139, 2.40357923)
#: Below this moment arm the spin ratio is twice the arm to the last digit.
SMALL_ARM = 1e-9


class RingForce(NamedTuple):
    """Force along the motion and torque of a ring, and a slope, per unit weight and radius."""

    force: float
    torque: float
    slope: float


class RingResponse(NamedTuple):
    """Force along the motion and torque of a ring, and second derivatives of its potential."""

    force: float
    torque: float
    vv: float
    vs: float
    ss: float


def polynomial(coefficients: Coefficients, count: int, x: float) -> float:
    """Value of a polynomial; even and odd powers are summed in parallel, which halves the latency."""
    square, i = x * x, count - 1
    one, other = coefficients[i], coefficients[i - 1]
    while i >= 3:
        i -= 2
        one = one * square + coefficients[i]
        other = other * square + coefficients[i - 1]
    if i == 1:
        return other + x * one
    return one * square + coefficients[0] + x * other


def ring_curves_far(m: float, x: float) -> RingForce:
    """Force, torque and its slope of a ring far from the center, for m below NEAR_RING squared.

    ``f = (1 + k') / 2 P``, ``t / k = B = ((1 - q/2) Q - q/2 (Q - P) / q^2) / (1 + k')``, and
    ``t' = 2 Q / (1 + k') - B``. The corrections to the leading terms are small, and so is their rounding.
    """
    ends = 1.0 + sqrt(x)
    half = m / (2.0 * ends * ends)  # q / 2
    y = 4.0 * half * half
    first = polynomial(FAR_FIRST, len(FAR_FIRST), y)
    second = polynomial(FAR_SECOND, len(FAR_SECOND), y)
    bracket = (1.0 - half) + y * (first * (1.0 - half) - half * second)
    force = ends / 2.0 * (1.0 + y * (first - y * second))
    return RingForce(force, bracket / ends, (2.0 + 2.0 * y * first - bracket) / ends)


def ring_curves_near(m: float, x: float) -> RingForce:
    """Force, torque and its slope of a ring near the center, for m from NEAR_RING squared to 1.

    The slope t', which is infinite at 1, is bounded.
    """
    half_log = -log(x) / 2.0
    first = half_log * polynomial(FORCE_LOG, len(FORCE_LOG), x)
    first += polynomial(FORCE_REST, len(FORCE_REST), x)
    second = half_log * polynomial(TORQUE_LOG, len(TORQUE_LOG), x)
    second += polynomial(TORQUE_REST, len(TORQUE_REST), x)
    force, part = 1.0 + x * first, TWO_BY_PI / m
    # K - E; a division by x would amplify the rounding of force and torque.
    slope = first - second - force
    slope -= max(half_log - STEEPEST, 0.0)
    return RingForce(TWO_BY_PI * force, part * (1.0 + x * second), part * slope)


def ring_curves(m: float, x: float) -> RingForce:
    """f(k), t(k) / k in place of the torque, and t'(k), at ``m = k^2 <= 1`` and ``x = 1 - m > 0``."""
    return ring_curves_far(m, x) if m < NEAR_RING * NEAR_RING else ring_curves_near(m, x)


def inner_ring(small: float, large: float) -> RingForce:
    """f(k), t(k) and t'(k) at ``k = small / large``, 0 <= small <= large, large > 0."""
    k, gap = small / large, (large - small) / large
    curve = ring_curves(k * k, max(gap * (2.0 - gap), SMALLEST_COMPLEMENT))
    return RingForce(curve.force, k * curve.torque, curve.slope)


def ring_wrench(speed: float, spin: float) -> RingForce:
    """Force along the motion, torque, and slope with respect to the ratio <= 1 of the speeds (Eqs. 2-3).

    Parameters
    ----------
    speed, spin : float
        ``v >= 0`` and ``R omega``, not both zero.

    Returns
    -------
    RingForce
        Per unit weight and radius.
    """
    size = fabs(spin)
    curve = inner_ring(min(size, speed), max(size, speed))
    force, torque = curve.force, curve.torque
    if size > speed:
        force, torque = torque, force
    return RingForce(force, torque if spin >= 0.0 else -torque, curve.slope)


def ring_response(speed: float, spin: float) -> RingResponse:
    """Force and torque as in `ring_wrench`, and the derivatives vv, vs = sv and ss of the potential."""
    curve = ring_wrench(speed, spin)
    if fabs(spin) <= speed:
        k, ss = spin / speed, curve.slope / speed
        return RingResponse(curve.force, curve.torque, vv=k * k * ss, vs=-k * ss, ss=ss)
    k, vv = speed / spin, curve.slope / fabs(spin)
    return RingResponse(curve.force, curve.torque, vv, vs=-k * vv, ss=k * k * vv)


def estimate_spin_ratio(arm: float) -> float:
    """Spin ratio, accurate to 2e-6; near the ring, its distance from 1 is accurate to 6e-6."""
    if arm < NEAR_ARM:
        return 2.0 * arm * polynomial(FAR_GUESS, len(FAR_GUESS), arm * arm)
    complement = 1.0 - arm
    part = 1.0 / (3.0 - log(complement + SMALLEST_COMPLEMENT))
    rest = polynomial(NEAR_GUESS_2, len(NEAR_GUESS_2), part)
    rest += complement * polynomial(NEAR_GUESS_3, len(NEAR_GUESS_3), part)
    rest = polynomial(NEAR_GUESS_1, len(NEAR_GUESS_1), part) + complement * rest
    gap = polynomial(NEAR_GUESS, len(NEAR_GUESS), part) + complement * rest
    return 1.0 - complement * gap


def inner_spin_ratio(arm: float) -> float:
    """Root of ``t(k) - h f(k)`` for 0 <= h <= 1 by a Halley step, with ``t'' = (f / x - 2 t') / k``."""
    if arm < SMALL_ARM:
        return 2.0 * arm
    k = estimate_spin_ratio(arm)
    curve = inner_ring(k, 1.0)
    lever, x = 1.0 + arm * k, (1.0 - k) * (1.0 + k) + SMALLEST_COMPLEMENT
    excess, rate = curve.torque - arm * curve.force, curve.slope * lever
    bend = (curve.force / x - 2.0 * curve.slope) / k * lever + arm * curve.slope
    # The estimate is so close that the denominator is positive, or on the ring large.
    return min(k - excess * rate / (rate * rate - excess * bend / 2.0), 1.0)


def ring_spin_ratio(arm: float) -> float:
    """Spin ratio k under a force with this moment arm in radii: the inverse of ``H = t / f`` (Eq. 7)."""
    size = fabs(arm)
    k = inner_spin_ratio(size if size <= 1.0 else 1.0 / size)
    if size > 1.0:
        k = 1.0 / k if k > 0.0 else INFINITY
    return k if arm >= 0.0 else -k


class RingProfile(Record):
    """Force along the motion and torque of a ring, per unit weight and radius."""

    force: float
    torque: float


def ring_profiles(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Force along the motion and torque at spin ratios, one per row; a ratio can be infinite."""
    for i in range(count):
        k, result = rows[i * columns], RingProfile(results[i * width :])
        result.force, result.torque = 0.0, 1.0 if k > 0.0 else -1.0
        if fabs(k) < INFINITY:
            curve = ring_wrench(1.0, k)
            result.force, result.torque = curve.force, curve.torque


def ring_spin_ratios(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Spin ratios under forces with moment arms in radii, one per row."""
    for i in range(count):
        results[i * width] = ring_spin_ratio(rows[i * columns])
