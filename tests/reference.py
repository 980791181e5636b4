"""A straight-line transcription of the paper's equations at high precision.

Only mpmath is used, every argument is taken as the exact number it is, and nothing here is imported
by the package. R is 1, angles are radians. The integrals of Eqs. (2)-(3) are evaluated as printed;
the elliptic forms are there for wide sweeps and are themselves checked against the integrals.
"""

from __future__ import annotations

from mpmath import mp, mpf

mp.dps = 30

#: Half of an integrand's digits may cancel next to the singular point (k = 1, theta = pi).
QUADRATURE_DIGITS = 32


def _breaks(k: mpf) -> list[mpf]:
    """Nodes of the quadrature: theta = pi, and steps towards it where |1 - k| makes a layer there.

    The singular point of k < 0 is theta = 0, both ends of the range.
    """
    layer, step, steps = abs(1 - abs(k)), mpf(1), []
    while 0 < layer < step and len(steps) < 40:
        steps.append(step)
        step /= 8
    if k > 0:
        return sorted(
            {mpf(0), mp.pi, 2 * mp.pi, *(mp.pi + a for a in steps), *(mp.pi - a for a in steps)}
        )
    return sorted({mpf(0), mp.pi, 2 * mp.pi, *steps, *(2 * mp.pi - a for a in steps)})


def _ring_integral(numerator, k) -> mpf:
    with mp.workdps(QUADRATURE_DIGITS):
        k = mpf(k)

        def integrand(theta):
            square = 1 + k**2 + 2 * k * mp.cos(theta)
            return numerator(theta, k) / mp.sqrt(square) if square > 0 else mpf(0)

        return mp.quad(integrand, _breaks(k)) / (2 * mp.pi)


def eq_01_sideways_force(k):
    """Eq. (1): f_x' of unit weight, the friction of the ring's points integrated around it."""
    return _ring_integral(lambda theta, k: -k * mp.sin(theta), k)


def eq_02_force(k, weight=1):
    """Eq. (2): f_y' for v > 0 and the spin ratio k = omega / v."""
    return weight * _ring_integral(lambda theta, k: 1 + k * mp.cos(theta), k)


def eq_03_torque(k, weight=1):
    """Eq. (3): tau_0' for v > 0 and the spin ratio k = omega / v."""
    return weight * _ring_integral(lambda theta, k: k + mp.cos(theta), k)


def eq_04_force_x(force, phi):
    """Eq. (4)."""
    return mpf(force) * mp.cos(phi)


def eq_05_force_y(force, phi):
    """Eq. (5)."""
    return mpf(force) * mp.sin(phi)


def eq_06_torque_about_contact(force, torque, length, phi, psi):
    """Eq. (6), with the rod angle psi in place of 45 degrees."""
    return mpf(torque) + mpf(length) * mpf(force) * mp.sin(mpf(phi) - mpf(psi))


def eq_07_spin_ratio(length, phi, psi):
    """Eq. (7): the k at which Eq. (6) vanishes, with Eqs. (2)-(3) integrated as printed."""
    arm = moment_arm(length, phi, psi)
    if arm == 0:
        return mpf(0)

    def torque(k):
        return eq_06_torque_about_contact(eq_02_force(k), eq_03_torque(k), length, phi, psi)

    # H(k) lies between k / 2 and k inside the ring, between k and 2 k outside of it.
    guess = (1.5 if abs(arm) < 1 else 0.75) * arm
    return mp.findroot(torque, (guess, 0.9 * guess), tol=mpf(10) ** -36)


def eq_08_to_10_acceleration(fx, fy, length, psi):
    """Eqs. (8)-(10): (a_cx, a_cy, alpha_c) for unit mass and radius of gyration."""
    fx, fy, length, psi = map(mpf, (fx, fy, length, psi))
    return fx, fy, fx * length * mp.sin(psi) - fy * length * mp.cos(psi)


def eq_11_rod_end_x(fx, fy, length, psi):
    """Eq. (11): a_sx."""
    fx, fy, length, psi = map(mpf, (fx, fy, length, psi))
    return fx * (1 + length**2 * mp.sin(psi) ** 2) - fy * length**2 * mp.sin(psi) * mp.cos(psi)


def eq_12_rod_end_y(fx, fy, length, psi):
    """Eq. (12): a_sy."""
    fx, fy, length, psi = map(mpf, (fx, fy, length, psi))
    return fy * (1 + length**2 * mp.cos(psi) ** 2) - fx * length**2 * mp.sin(psi) * mp.cos(psi)


def eq_13_pulls(fx, fy, length, psi):
    """Eq. (13): whether a force accelerates the rod's end away from the slider."""
    return eq_12_rod_end_y(fx, fy, length, psi) < 0


# --- Elliptic forms, for sweeps -----------------------------------------------------------------


def _inner_force(k):
    return 2 / mp.pi * mp.ellipe(k**2)


def _inner_torque(k):
    if k < mpf("0.1"):
        return k / 2 * mp.hyp2f1(mpf(1) / 2, mpf(1) / 2, 2, k**2)
    # K's logarithm at k = 1 is beaten by the factor (1 - k^2).
    singular = (1 - k**2) * mp.ellipk(k**2) if k < 1 else mpf(0)
    return 2 / mp.pi * (mp.ellipe(k**2) - singular) / k


def ring_force(k):
    """f(k) of Eq. (2) for unit weight; |k| > 1 through the integral's own symmetry."""
    k = abs(mpf(k))
    return _inner_force(k) if k <= 1 else _inner_torque(1 / k)


def ring_torque(k):
    """t(k) of Eq. (3) for unit weight."""
    k = mpf(k)
    size = abs(k)
    return mp.sign(k) * (_inner_torque(size) if size <= 1 else _inner_force(1 / size))


def moment_arm(length, phi, psi):
    """l sin(psi - phi), the angles taken as exact numbers."""
    return mpf(length) * mp.sin(mpf(psi) - mpf(phi))


def _bracketed(function, low, high):
    """Root in [low, high] to 24 digits of itself."""
    if low == high or function(low) == 0:
        return low
    if function(high) == 0:
        return high
    part = mp.findroot(
        lambda part: function(min(low * part, high)),
        (mpf(1), high / low),
        solver="anderson",
        tol=mpf(10) ** -24,
        verify=False,
    )
    return low * part


def friction_spin_ratio(arm):
    """k with t(k) / f(k) = arm, the solution of Eq. (7)."""
    size = abs(mpf(arm))
    if size in (0, 1):
        return mpf(arm)
    inner = min(size, 1 / size)
    k = _bracketed(
        lambda k: _inner_torque(k) - inner * _inner_force(k), inner, min(2 * inner, mpf(1))
    )
    return mp.sign(arm) * (k if size < 1 else 1 / k)


def inertia_spin_ratio(arm, rho=1):
    """k with rho^2 k = arm (Eq. 10)."""
    return mpf(arm) / mpf(rho) ** 2


def mixed_spin_ratio(arm, s, rho=1):
    """k with (t + s rho^2 k) / (f + s) = arm, both effects starting from rest (Sec. 4)."""
    size, s, rho = abs(mpf(arm)), mpf(s), mpf(rho)
    ends = sorted((friction_spin_ratio(size), inertia_spin_ratio(size, rho)))
    k = _bracketed(lambda k: ring_torque(k) - size * ring_force(k) + s * (rho**2 * k - size), *ends)
    return mp.sign(arm) * k


def motion_angle(length, phi, psi, k):
    """Angle of the contact's motion, on the branch within 90 degrees of the force."""
    length, phi, psi = map(mpf, (length, phi, psi))
    ux = mp.cos(phi) + k * length * mp.sin(psi)
    uy = mp.sin(phi) - k * length * mp.cos(psi)
    along = ux * mp.cos(phi) + uy * mp.sin(phi)
    across = uy * mp.cos(phi) - ux * mp.sin(phi)
    return phi + mp.atan2(across, along)


def friction_motion_angle(length, phi, psi):
    """theta_s under support friction alone (Sec. 3)."""
    return motion_angle(length, phi, psi, friction_spin_ratio(moment_arm(length, phi, psi)))


def inertia_motion_angle(length, phi, psi, rho=1):
    """Angle of a_s under inertia alone (Sec. 4)."""
    k = inertia_spin_ratio(moment_arm(length, phi, psi), rho)
    return motion_angle(length, phi, psi, k)


def mixed_motion_angle(length, phi, psi, share, rho=1):
    """Angle of the initial a_s with both effects, share = s / (1 + s)."""
    arm, share = moment_arm(length, phi, psi), mpf(share)
    if share == 1:
        return inertia_motion_angle(length, phi, psi, rho)
    return motion_angle(length, phi, psi, mixed_spin_ratio(arm, share / (1 - share), rho))
