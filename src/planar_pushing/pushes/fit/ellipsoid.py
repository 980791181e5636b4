"""Pushes of an object with an ellipsoidal limit surface, the model that planners fit.

Wrenches and twists are in the object's frame. The limit surface is ``w . A w = 1``, and the object moves
along ``A w`` under a wrench w.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.contacts import Contacts, Ends

#: Steps of the motion by the midpoint rule; their error is below one percent of the measurement error.
STEPS = 60


@dataclass(frozen=True, slots=True, eq=False)
class Ellipsoid:
    """An object with an ellipsoidal limit surface; `matrix` is A, shape (3, 3)."""

    matrix: Array

    @classmethod
    def about(cls, center: Array, matrix: Array) -> Ellipsoid:
        """Ellipsoid from a matrix for torques about a center."""
        x, y = center
        # Converts the torque about the origin to the torque about the center.
        moved = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [y, -x, 1.0]])
        return cls(moved.T @ matrix @ moved)

    def wrenches(self, twists: Array) -> Array:
        return np.asarray(np.linalg.solve(self.matrix, twists.T).T, dtype=float)

    def motions(self, wrenches: Array) -> Array:
        return wrenches @ self.matrix

    def ends(self, contacts: Contacts, friction: float) -> Ends:
        count, parts = contacts.path.shape[:2]
        pose, place, lasted = np.zeros((count, 3)), np.zeros(count), np.zeros(count)
        on = np.ones(count, dtype=bool)
        steps = -(-STEPS // parts)
        for k in range(parts):
            for _ in range(steps):
                way = contacts.path[:, k] / steps
                first, slid = self._moved(contacts, pose, place, way / 2.0, friction)
                step, slid = self._moved(contacts, pose + first, place + slid, way, friction)
                pose, place = (
                    pose + np.where(on[:, None], step, 0.0),
                    place + np.where(on, slid, 0.0),
                )
                on &= (place <= contacts.end) & (place >= contacts.start)
                # An object that does not move has separated from the finger.
                lasted += np.where(on & step.any(axis=1), 1.0 / (parts * steps), 0.0)
        return Ends(pose, lasted)

    def _moved(
        self, contacts: Contacts, pose: Array, place: Array, way: Array, friction: float
    ) -> tuple[Array, Array]:
        """Displacement of the object, and of the contact along its side, in a small step of the finger."""
        c, s = np.cos(pose[:, 2]), np.sin(pose[:, 2])
        w_x, w_y = way.T
        finger = np.column_stack([c * w_x + s * w_y, c * w_y - s * w_x])
        point = contacts.point + place[:, None] * contacts.tangent
        twist, slip = self._pushed(contacts, point, finger, friction)
        v_x, v_y, turn = twist.T
        step = np.column_stack([c * v_x - s * v_y, s * v_x + c * v_y, turn])
        return step, slip - contacts.radius * turn

    def _pushed(
        self, contacts: Contacts, point: Array, finger: Array, friction: float
    ) -> tuple[Array, Array]:
        """Twist of the object, and the finger's motion along the side: sticking, slipping or separating."""
        reach = np.zeros((len(point), 2, 3))
        reach[:, 0, 0] = reach[:, 1, 1] = 1.0
        reach[:, 0, 2], reach[:, 1, 2] = -point[:, 1], point[:, 0]
        # A force f at the contact moves the contact by G f.
        across = self.matrix @ reach.transpose(0, 2, 1)
        mobility = reach @ across
        force = np.linalg.solve(mobility, finger[..., None])[..., 0]
        normal, tangent = contacts.normal, contacts.tangent
        along, into = (force * tangent).sum(axis=1), (force * normal).sum(axis=1)
        sticks = contacts.sticks | ((into > 0.0) & (np.abs(along) <= friction * into))
        found, slip = np.where(sticks[:, None], force, 0.0), np.zeros(len(point))
        advance = (finger * normal).sum(axis=1)
        for sign in (1.0, -1.0):
            edge = normal + sign * friction * tangent
            motion = (mobility @ edge[..., None])[..., 0]
            rate = (motion * normal).sum(axis=1)
            size = np.divide(advance, rate, out=np.zeros_like(rate), where=rate != 0.0)
            slid = (finger * tangent).sum(axis=1) - size * (motion * tangent).sum(axis=1)
            fits = ~sticks & (size > 0.0) & (sign * slid > 0.0)
            found = np.where(fits[:, None], size[:, None] * edge, found)
            slip = np.where(fits, slid, slip)
        return (across @ found[..., None])[..., 0], slip
