"""Pushes of an object whose limit surface is a level set of a smooth convex function.

Wrenches and twists are in the object's frame. The function is homogeneous of degree 2; its gradient, along
the twist, is homogeneous of degree 1. The motion under a line of force is then a gradient, and the force of
a sticking contact and the wrench for a twist are roots.
"""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.contacts import Contacts, Ends

#: Steps of the motion by the midpoint rule; their error is below one percent of the measurement error.
STEPS = 60


class LimitSurface(ABC):
    """An object with a smooth limit surface."""

    @abstractmethod
    def motions(self, wrenches: Array) -> Array:
        """Twists under wrenches of shape (n, 3); zero without a wrench."""

    @abstractmethod
    def forces(self, reach: Array, velocities: Array) -> Array:
        """Coefficients f, shape (n, k), of wrenches ``f @ reach`` whose twists t have ``reach @ t`` = v.

        `reach` has shape (n, k, 3) and the velocities v have shape (n, k).
        """

    def wrenches(self, twists: Array) -> Array:
        return self.forces(np.tile(np.eye(3), (len(twists), 1, 1)), twists)

    def ends(self, contacts: Contacts, friction: float) -> Ends:
        count, parts = contacts.path.shape[:2]
        pose, position, lasted = np.zeros((count, 3)), np.zeros(count), np.zeros(count)
        on = np.ones(count, dtype=bool)
        steps = -(-STEPS // parts)
        for k in range(parts):
            for _ in range(steps):
                advance = contacts.path[:, k] / steps
                first, slid = self._step_of_pose(contacts, pose, position, advance / 2.0, friction)
                step, slid = self._step_of_pose(
                    contacts, pose + first, position + slid, advance, friction
                )
                pose, position = (
                    pose + np.where(on[:, None], step, 0.0),
                    position + np.where(on, slid, 0.0),
                )
                on &= (position <= contacts.end) & (position >= contacts.start)
                # An object that does not move has separated from the finger.
                lasted += np.where(on & step.any(axis=1), 1.0 / (parts * steps), 0.0)
        return Ends(pose, lasted)

    def _step_of_pose(
        self, contacts: Contacts, pose: Array, position: Array, advance: Array, friction: float
    ) -> tuple[Array, Array]:
        """Displacement of the object, and of the contact along its side, in a small step of the finger."""
        c, s = np.cos(pose[:, 2]), np.sin(pose[:, 2])
        w_x, w_y = advance.T
        finger = np.column_stack([c * w_x + s * w_y, c * w_y - s * w_x])
        point = contacts.point + position[:, None] * contacts.tangent
        twist, slip = self._twist_of_push(contacts, point, finger, friction)
        v_x, v_y, turn = twist.T
        step = np.column_stack([c * v_x - s * v_y, s * v_x + c * v_y, turn])
        return step, slip - contacts.radius * turn

    def _twist_of_push(
        self, contacts: Contacts, point: Array, finger: Array, friction: float
    ) -> tuple[Array, Array]:
        """Twist of the object, and the finger's motion along the side: sticking, slipping or separating."""
        reach = np.zeros((len(point), 2, 3))
        reach[:, 0, 0] = reach[:, 1, 1] = 1.0
        reach[:, 0, 2], reach[:, 1, 2] = -point[:, 1], point[:, 0]
        force = self.forces(reach, finger)
        normal, tangent = contacts.normal, contacts.tangent
        along, into = (force * tangent).sum(axis=1), (force * normal).sum(axis=1)
        sticks = contacts.sticks | ((into > 0.0) & (np.abs(along) <= friction * into))
        twist, slip = (
            self._motion_under(reach, np.where(sticks[:, None], force, 0.0)),
            np.zeros(len(point)),
        )
        advance = (finger * normal).sum(axis=1)
        for sign in (1.0, -1.0):
            edge = self._motion_under(reach, normal + sign * friction * tangent)
            motion = (reach @ edge[..., None])[..., 0]
            rate = (motion * normal).sum(axis=1)
            size = np.divide(advance, rate, out=np.zeros_like(rate), where=rate != 0.0)
            slid = (finger * tangent).sum(axis=1) - size * (motion * tangent).sum(axis=1)
            fits = ~sticks & (size > 0.0) & (sign * slid > 0.0)
            twist = np.where(fits[:, None], size[:, None] * edge, twist)
            slip = np.where(fits, slid, slip)
        return twist, slip

    def _motion_under(self, reach: Array, force: Array) -> Array:
        """Twists under forces at the contacts."""
        return self.motions((force[:, None] @ reach)[:, 0])
