"""Friction of a ring with uniform pressure: force, torque and their slope in closed form (Eqs. 2-3).

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

from math import log, pi, sqrt

from planar_pushing.simulation.legacy.compiled import compiled

#: Above this spin ratio the series in x and log x are used, below it those of the Landen step.
NEAR_RING = 0.9
#: Chebyshev interpolants of the series on the range where each is used, in powers of its variable. Their
#: contribution to the result is accurate to 1e-16; a test recomputes them with 60 digits. In y = q^2:
#: ``(Q - 1) / y`` and ``(Q - P) / y^2`` with P = 2F1(-1/2, -1/2; 1; y), the series of E (Gauss-Kummer), and
#: Q = 2F1(1/2, 1/2; 1; y), that of K.
FIRST = (
    0.25000000000000006, 0.14062499999994713, 0.09765625001365902, 0.07476806503340462,
    0.060562204329880964, 0.050886909305350364, 0.0439177652053106, 0.03810616153039507,
    0.03782446460764198, 0.015631813216525955, 0.06470609318632879,
)  # fmt: skip
SECOND = (
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
LEAST, STEEPEST = 1e-300, 18.0


@compiled
def polynomial(coefficients, x):
    """Value of a polynomial; even and odd powers are summed in parallel, which halves the latency."""
    square, i = x * x, len(coefficients) - 1
    one, other = coefficients[i], coefficients[i - 1]
    while i >= 3:
        i -= 2
        one = one * square + coefficients[i]
        other = other * square + coefficients[i - 1]
    if i == 1:
        return other + x * one
    return one * square + coefficients[0] + x * other


@compiled
def _far(m, x):
    """`curves` for m below NEAR_RING squared.

    ``f = (1 + k') / 2 P``, ``t / k = B = ((1 - q/2) Q - q/2 (Q - P) / q^2) / (1 + k')``, and
    ``t' = 2 Q / (1 + k') - B``. The corrections to the leading terms are small, and so is their rounding.
    """
    ends = 1.0 + sqrt(x)
    half = m / (2.0 * ends * ends)  # q / 2
    y = 4.0 * half * half
    first, second = polynomial(FIRST, y), polynomial(SECOND, y)
    bracket = (1.0 - half) + y * (first * (1.0 - half) - half * second)
    force = ends / 2 * (1.0 + y * (first - y * second))
    return force, bracket / ends, (2.0 + 2.0 * y * first - bracket) / ends


@compiled
def _near(m, x):
    """`curves` for m from NEAR_RING squared to 1, where t' is its finite value beside the ring."""
    half_log = -log(x) / 2
    first = half_log * polynomial(FORCE_LOG, x) + polynomial(FORCE_REST, x)
    second = half_log * polynomial(TORQUE_LOG, x) + polynomial(TORQUE_REST, x)
    force, part = 1.0 + x * first, 2 / pi / m
    # K - E; a division by x would amplify the rounding of force and torque.
    slope = first - second - force
    slope -= max(half_log - STEEPEST, 0.0)
    return 2 / pi * force, part * (1.0 + x * second), part * slope


@compiled
def curves(m, x):
    """f(k), t(k) / k and t'(k) at ``m = k^2 <= 1`` and ``x = 1 - m > 0``, per unit weight and radius."""
    return _far(m, x) if m < NEAR_RING * NEAR_RING else _near(m, x)


@compiled
def inner(small, large):
    """f(k), t(k) and t'(k) at ``k = small / large``, 0 <= small <= large, per unit weight and radius."""
    k, gap = small / large, (large - small) / large
    force, lever, slope = curves(k * k, max(gap * (2.0 - gap), LEAST))
    return force, k * lever, slope


@compiled
def ring_wrench(speed, spin):
    """Force along the motion, torque, and slope over the ratio <= 1 of the two speeds (Eqs. 2-3).

    Parameters
    ----------
    speed, spin : float
        ``v >= 0`` and ``R omega``, not both zero.

    Returns
    -------
    force, torque, slope : float
        Per unit weight and radius.
    """
    size = abs(spin)
    force, torque, slope = inner(min(size, speed), max(size, speed))
    if size > speed:
        force, torque = torque, force
    return force, torque if spin >= 0.0 else -torque, slope


@compiled
def ring_response(speed, spin):
    """Force and torque as in `ring_wrench`, and the derivatives vv, vs = sv and ss of the potential."""
    force, torque, slope = ring_wrench(speed, spin)
    if abs(spin) <= speed:
        k, ss = spin / speed, slope / speed
        return force, torque, k * k * ss, -k * ss, ss
    k, vv = speed / spin, slope / abs(spin)
    return force, torque, vv, -k * vv, k * k * vv
