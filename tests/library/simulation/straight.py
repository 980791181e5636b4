"""A finger against a flat side, integrated by scipy straight from Newton's law.

Everything is seen from the world; the side is the line n . (c - F) = constant beside the center F of the
finger, which may be a disc. Nothing is shared with the package.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, root


class Pushed:
    """A slider that slips along a finger; its support is points, in the body frame.

    `sense` is the sign of the slip, 0 of a contact that sticks (without a mass), `mass` (m, gyration
    radius, center), `velocity` of the finger is a + b t, given as (a, b), `radius` is that of the finger.
    """

    def __init__(self, rod, psi, points, weights, mu, sense, velocity, mass=None, radius=0.0):
        self.rod, self.psi, self.mu, self.sense = rod, psi, mu, sense
        self.points, self.weights = np.asarray(points, float), np.asarray(weights, float)
        self.start, self.rate = np.asarray(velocity[0], float), np.asarray(velocity[1], float)
        self.mass, self.gyration, center = mass or (0.0, 1.0, (0.0, 0.0))
        self.center, self.guess, self.radius = np.asarray(center, float), None, radius

    def finger(self, t):
        """Place and velocity of the finger's center; the contact is at the origin at time 0."""
        place = self.start * t + self.rate * t * t / 2
        return place - (0.0, self.radius), self.start + self.rate * t

    def axes(self, angle):
        """Tangent and normal of the side, and the body frame in the world."""
        turn = angle - self.psi
        c, s = math.cos(angle), math.sin(angle)
        tangent = np.array([math.cos(turn), math.sin(turn)])
        return tangent, np.array([-tangent[1], tangent[0]]), np.array([[c, -s], [s, c]])

    def friction(self, body, v, omega):
        """Force on the support that sustains a motion, and its torque about the slider's center."""
        places = self.points @ body.T
        moves = v + omega * np.stack([-places[:, 1], places[:, 0]], axis=-1)
        forces = self.weights[:, None] * moves / np.hypot(*moves.T)[:, None]
        return forces.sum(axis=0), float(
            np.sum(places[:, 0] * forces[:, 1] - places[:, 1] * forces[:, 0])
        )

    def edge(self, tangent, normal):
        """Direction of the force on the slider: friction acts against the slip."""
        return normal - self.sense * self.mu * tangent

    def quasi_static(self, t, state):
        """Rates of (x, y, angle) of the slider's center; friction balances the finger's force."""
        place, w = self.finger(t)
        tangent, normal, body = self.axes(state[2])
        r, e = state[:2] - (place + self.radius * normal), self.edge(tangent, normal)

        def lacks(twist):
            v, omega = twist[:2], twist[2]
            f, torque = self.friction(body, v, omega)
            u = v + omega * np.array([r[1], -r[0]])
            about = torque + (r[0] * f[1] - r[1] * f[0])
            return e[0] * f[1] - e[1] * f[0], about, normal @ (u - w)

        start = np.array([*w, 0.1]) if self.guess is None else self.guess
        found = root(lacks, start, method="hybr", options={"xtol": 1e-13})
        self.guess = found.x
        return found.x

    def sticking(self, t, state):
        """Rates of (x, y, angle) where the contact's point moves with the finger: no torque about it."""
        place, w = self.finger(t)
        _, normal, body = self.axes(state[2])
        r = state[:2] - (place + self.radius * normal)

        def about(omega):
            f, torque = self.friction(body, w + omega * np.array([-r[1], r[0]]), omega)
            return torque + (r[0] * f[1] - r[1] * f[0])

        omega = brentq(about, -50.0, 50.0, xtol=1e-14, rtol=1e-14)
        return np.array([*(w + omega * np.array([-r[1], r[0]])), omega])

    def dynamic(self, t, state):
        """Rates of place, angle, velocity and rotation of the center of mass."""
        place, w = self.finger(t)
        angle, v, omega = state[2], state[3:5], state[5]
        tangent, normal, body = self.axes(angle)
        offset = body @ self.center
        r, e = state[:2] - place, self.edge(tangent, normal)
        arm = r - self.radius * normal
        f, torque = self.friction(body, v + omega * np.array([offset[1], -offset[0]]), omega)
        drag = -torque + (offset[0] * f[1] - offset[1] * f[0])
        moment = self.mass * self.gyration**2

        def lifts(size):
            """Second derivative of n . (c - F), for the center of mass c."""
            a = (size * e - f) / self.mass
            turn = (drag - size * (arm[0] * e[1] - arm[1] * e[0])) / moment
            own = -turn * (tangent @ r) - omega**2 * (normal @ r) - 2 * omega * (tangent @ (v - w))
            # The side is not at rest in the body frame of the center of mass: its distance is.
            return own + normal @ (a - self.rate), a, turn

        one, other = lifts(0.0)[0], lifts(1.0)[0]
        _, a, turn = lifts(one / (one - other))
        return np.array([*v, omega, *a, turn])

    def follow(self, duration, twist=None, until=None):
        """The state at the end, the place of the finger along the side there, and the time of the end."""
        _, _, body = self.axes(self.psi)
        start = self.rod * np.array([math.cos(self.psi), math.sin(self.psi)])
        rates = self.quasi_static if self.sense else self.sticking
        if self.mass:
            rates, offset, (v, omega) = self.dynamic, body @ self.center, (twist[:2], twist[2])
            start = [
                *(start + offset),
                self.psi,
                *(v + omega * np.array([-offset[1], offset[0]])),
                omega,
            ]
        else:
            start = [*start, self.psi]
        found = solve_ivp(
            rates, (0, duration), start, method="DOP853", rtol=1e-12, atol=1e-12, dense_output=True
        )
        time = duration
        if until is not None:
            time = brentq(lambda t: self.along(t, found.sol(t)) - until, 0, duration, xtol=1e-13)
        return time, found.sol(time), self.along(time, found.sol(time))

    def place(self, state):
        """Place of the slider's center."""
        return state[:2] - (self.axes(state[2])[2] @ self.center if self.mass else 0.0)

    def along(self, t, state):
        """Where the finger is on the side, from the contact at time 0."""
        tangent = self.axes(state[2])[0]
        return float(
            tangent @ (self.finger(t)[0] - self.place(state)) + self.rod * math.cos(self.psi)
        )
