"""Motion over time in doubles: a light slider by an implicit integrator, and slips that alternate.

A ring with a small mass on a fence is stiff: support friction stops a relative motion within a time of the
order of m v / W. The equations of motion are written out for the rod angle and the place of the contact on
the fence, and integrated by the Radau method. Slips under friction alone that alternate with the motion of
the fence are integrated piece by piece by the Runge-Kutta method of order four. Two tolerances, or two step
sizes, tell how many digits are known.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

Floats = npt.NDArray[np.float64]
#: Smallest parameter of the elliptic integrals for which the torque is their difference.
SMALL = 1e-6
#: Largest spin ratio of a slip.
LARGEST_RATIO = 1e3


class Light(NamedTuple):
    """A ring of radius 1 and weight 1 with a mass, at rest, and a fence that starts to move at once.

    Attributes
    ----------
    length, angle : float
        Length and angle of the rod, radians.
    mu, mass : float
        Coefficient of friction; mass, with a radius of gyration of 1.
    fence : tuple of float
        Velocity of the fence.
    """

    length: float
    angle: float
    mu: float
    mass: float
    fence: tuple[float, float]


def ring_wrench(v_x: float, v_y: float, spin: float) -> tuple[float, float, float]:
    """Force that support friction needs, and torque about the center (Eqs. 2-3)."""
    speed = float(np.hypot(v_x, v_y))
    small, large = sorted((speed, abs(spin)))
    m = (small / large) ** 2 if large > 0 else 0.0
    first = ellipe(m)
    second = (first - (1 - m) * ellipk(m)) / small * large if m > SMALL else _series(m)
    force, torque = (first, second) if speed >= abs(spin) else (second, first)
    scale = 2 / np.pi
    along = scale * force / speed if speed > 0 else 0.0
    return along * v_x, along * v_y, scale * torque * float(np.sign(spin))


def _series(m: float) -> float:
    return float(np.pi / 4 * np.sqrt(m) * (1 + m / 8 + 3 * m * m / 64))


class LightMotion:
    """Motion of a light slider; its state is the rod angle, the slip and their rates."""

    def __init__(self, light: Light) -> None:
        """Motion of a slider at rest that the fence meets with an inelastic impact."""
        self.light = light
        slope = np.hypot(1.0, light.mu)
        #: Left edge of the friction cone, on which the force of a slip to the right lies, and right edge.
        self.edges = {1: (-light.mu / slope, 1 / slope), -1: (light.mu / slope, 1 / slope)}

    def spin_of_impact(self) -> float:
        """Rate of rotation after the impact, which sticks: its impulse has no torque about the contact.

        Raises
        ------
        ArithmeticError
            If the impulse is outside the friction cone.
        """
        (x, y), (u, v) = self.rod(self.light.angle), self.light.fence
        spin = -(x * v - y * u) / (1 + self.light.length**2)
        along, across = u - spin * y, v + spin * x
        if not abs(along) < self.light.mu * across:
            raise ArithmeticError("the contact slips during the impact")
        return spin

    def rod(self, angle: float) -> tuple[float, float]:
        """Vector from the contact to the center."""
        return self.light.length * float(np.cos(angle)), self.light.length * float(np.sin(angle))

    def changes(self, state: Floats, sense: int) -> Floats:
        """Rates of the state while the contact slips in a sense, or sticks (0)."""
        angle, _, spin, slip = state
        (x, y), (u, v), mass = self.rod(angle), self.light.fence, self.light.mass
        f_x, f_y, torque = ring_wrench(u + slip - spin * y, v + spin * x, spin)
        about_contact, inertia = x * f_y - y * f_x + torque, mass * (1 + self.light.length**2)
        if sense == 0:
            return np.array([spin, 0.0, -about_contact / inertia, 0.0])
        e_x, e_y = self.edges[sense]
        centripetal = mass * spin**2 * (e_x * y - e_y * x)
        matrix = [[inertia, -mass * y], [mass * (e_x * x + e_y * y), -mass * e_y]]
        right = [-about_contact, centripetal - e_x * f_y + e_y * f_x]
        return np.array([spin, slip, *np.linalg.solve(matrix, right)])


def follow(light: Light, duration: float, rtol: float) -> tuple[float, float, float]:
    """Time at which the slip ends, and rod angle and slip after a duration.

    Raises
    ------
    ArithmeticError
        If the contact does not slip right after the impact, or its slip does not end.
    """
    motion = LightMotion(light)
    start = np.array([light.angle, 0.0, motion.spin_of_impact(), 0.0])
    senses = [sense for sense in (1, -1) if sense * motion.changes(start, sense)[3] > 0]
    if len(senses) != 1:
        raise ArithmeticError("the contact does not begin to slip in one sense")
    (sense,) = senses

    def slip_rate(_: float, state: Floats) -> float:
        return float(sense * state[3])

    slip_rate.terminal, slip_rate.direction = True, -1  # type: ignore[attr-defined]
    options = {"method": "Radau", "rtol": rtol, "atol": rtol * 1e-3}
    first = solve_ivp(
        lambda _, state: motion.changes(state, sense), (0.0, duration),
        start, events=slip_rate, **options,
    )  # fmt: skip
    if first.status != 1:
        raise ArithmeticError("the slip does not end")
    angle, place, spin, _ = first.y[:, -1]
    second = solve_ivp(
        lambda _, state: motion.changes(state, 0), (first.t[-1], duration),
        [angle, place, spin, 0.0], **options,
    )  # fmt: skip
    return float(first.t[-1]), float(second.y[0, -1]), float(place)


def slip_rates(length: float, angle: float, mu: float, fence: tuple[float, float]) -> Floats:
    """Rate of the rod angle, and velocity of the contact along the fence, of a slip under friction alone.

    The force is on the edge of the friction cone that opposes the slip, and its moment arm fixes the spin
    ratio, the center's velocity being along the force (Eqs. 6 and 10). The slip is to the side from which
    the fence comes.
    """
    slope, side = np.hypot(1.0, mu), np.sign(fence[0])
    e_x, e_y = side * mu / slope, 1 / slope
    x, y = length * np.cos(angle), length * np.sin(angle)
    arm = float(e_x * y - e_y * x)

    def excess(k: float) -> float:
        force, _, torque = ring_wrench(1.0, 0.0, k)
        return torque - arm * force

    k = brentq(excess, -LARGEST_RATIO, LARGEST_RATIO, xtol=1e-16, rtol=4 * np.finfo(float).eps)
    speed = fence[1] / (e_y - k * x)
    rates = np.array([k * speed, speed * e_x + k * speed * y])
    if not (rates[1] - fence[0]) * side < 0 < speed:
        raise ArithmeticError("the contact does not slip against the motion of the fence")
    return rates


def alternate(
    length: float,
    angle: float,
    mu: float,
    fence: tuple[float, float],
    pieces: int,
    step: float,
    parts: int,
) -> tuple[float, float]:
    """Rod angle and place of the contact after slips under a fence that alternates between mirror images.

    Raises
    ------
    ArithmeticError
        If the contact does not slip against the motion of the fence.
    """
    state, size = np.array([angle, 0.0]), step / parts
    for i in range(pieces):
        velocity = (fence[0] * (-1) ** i, fence[1])
        for _ in range(parts):
            k1 = slip_rates(length, state[0], mu, velocity)
            k2 = slip_rates(length, state[0] + size / 2 * k1[0], mu, velocity)
            k3 = slip_rates(length, state[0] + size / 2 * k2[0], mu, velocity)
            k4 = slip_rates(length, state[0] + size * k3[0], mu, velocity)
            state = state + size / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return float(state[0]), float(state[1])
