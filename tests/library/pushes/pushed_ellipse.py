"""A point finger that slips along a true ellipse with a uniform pressure, by sums and Newton's method.

It shares no code with the library: the ellipse is parametric, the friction of the support is a sum over
places, and the twist under an edge of the friction cone is the minimum of the dissipation over all twists
with the same power of a force along this edge.
"""

from __future__ import annotations

import numpy as np

#: Smallest speed of a place at which its friction is full, relative to that of the finger.
SMOOTH = 1e-4


def uniform_places(axes, rings=10, spokes=40):
    """Places and equal shares of a uniform pressure within an ellipse."""
    radius = np.sqrt((np.arange(rings) + 0.5) / rings)
    angle = 2.0 * np.pi * (np.arange(spokes) + 0.5) / spokes
    x, y = (np.outer(radius, part).ravel() for part in (np.cos(angle), np.sin(angle)))
    return axes * np.column_stack([x, y])


def friction(places, contact, u, omega):
    """Force, torque about the contact, and their derivatives by (u_x, u_y, omega), shape (n, 3, 3)."""
    arm = places - contact[:, None]
    v_x, v_y = u[:, :1] - omega[:, None] * arm[..., 1], u[:, 1:] + omega[:, None] * arm[..., 0]
    size = np.sqrt(v_x**2 + v_y**2 + SMOOTH**2 * (u**2).sum(axis=1)[:, None])
    d_x, d_y = v_x / size, v_y / size
    load = np.stack([d_x, d_y, arm[..., 0] * d_y - arm[..., 1] * d_x]).mean(axis=2).T
    moves = np.stack([np.ones_like(v_x), np.zeros_like(v_x), -arm[..., 1]], axis=-1)
    sideways = np.stack([np.zeros_like(v_x), np.ones_like(v_x), arm[..., 0]], axis=-1)
    along = d_x[..., None] * moves + d_y[..., None] * sideways
    outer = (
        moves[..., :, None] * moves[..., None, :] + sideways[..., :, None] * sideways[..., None, :]
    )
    outer = outer - along[..., :, None] * along[..., None, :]
    return load, (outer / size[..., None, None]).mean(axis=1)


def minimize(places, contact, u, omega, free):
    """Motion of the contact and rotation with the least dissipation over u + s free and omega."""
    s = np.zeros(len(u))
    for _ in range(60):
        load, bend = friction(places, contact, u + s[:, None] * free, omega)
        way = np.zeros((len(u), 3, 2))
        way[:, :2, 0], way[:, 2, 1] = free, 1.0
        slope = (load[:, None] @ way)[:, 0]
        square = way.transpose(0, 2, 1) @ bend @ way + 1e-12 * np.eye(2)
        step = -np.linalg.solve(square, slope[..., None])[..., 0]
        still = ~free.any(axis=1)
        step[still] = np.column_stack([0.0 * s, -slope[:, 1] / square[:, 1, 1]])[still]
        most = np.maximum(np.abs(step[:, 0]), 50.0 * np.abs(step[:, 1]))
        step /= np.maximum(1.0, most / (0.3 * np.hypot(*u.T)))[:, None]
        s, omega = s + step[:, 0], omega + step[:, 1]
        if np.abs(step * [1.0, 50.0]).max() < 1e-10:
            break
    return u + s[:, None] * free, omega


def push_ellipse(axes, places, mu, start, direction, distance, steps=120):
    """Poses (x, y, angle) of the ellipse after pushes, and the places of the last contacts, as angles.

    `start` are the parameters of the first contacts, shape (n,), and `direction` unit vectors, (n, 2).
    """
    angle, place, moved = np.zeros(len(start)), start.astype(float), 0.0

    def rates(angle, place):
        c, s = np.cos(angle), np.sin(angle)
        finger = np.column_stack([c * direction[:, 0] + s * direction[:, 1],
                                  c * direction[:, 1] - s * direction[:, 0]])  # fmt: skip
        contact = axes * np.column_stack([np.cos(place), np.sin(place)])
        tangent = axes * np.column_stack([-np.sin(place), np.cos(place)])
        speed = np.hypot(*tangent.T)
        tangent = tangent / speed[:, None]
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        zero = np.zeros(len(angle))
        u, omega = minimize(places, contact, finger, zero, np.zeros_like(finger))
        load, _ = friction(places, contact, u, omega)
        along, into = (load[:, :2] * tangent).sum(axis=1), (load[:, :2] * normal).sum(axis=1)
        # The finger passes to the side toward which a sticking contact would need more friction.
        sign = np.sign(along)
        edge = normal + mu * sign[:, None] * tangent
        free = np.column_stack([-edge[:, 1], edge[:, 0]])
        slips = (np.abs(along) > mu * into)[:, None]
        w, spin = minimize(places, contact, edge / np.hypot(*edge.T)[:, None], zero, free)
        scale = (finger * normal).sum(axis=1) / (w * normal).sum(axis=1)
        u = np.where(slips, scale[:, None] * w, u)
        omega = np.where(slips[:, 0], scale * spin, omega)
        return omega, ((finger - u) * tangent).sum(axis=1) / speed

    for _ in range(steps):
        h = distance / steps
        first = rates(angle, place)
        middle = rates(angle + h / 2.0 * first[0], place + h / 2.0 * first[1])
        angle, place, moved = angle + h * middle[0], place + h * middle[1], moved + h
    before = axes * np.column_stack([np.cos(start), np.sin(start)])
    x, y = (axes * np.column_stack([np.cos(place), np.sin(place)])).T
    c, s = np.cos(angle), np.sin(angle)
    finger = before + distance * direction
    return np.column_stack([finger - np.column_stack([c * x - s * y, s * x + c * y]), angle]), place
