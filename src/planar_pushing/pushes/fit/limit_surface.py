"""Pushes of an object whose limit surface is a level set of a smooth convex function.

Wrenches and twists are in the object's frame. The function is homogeneous of degree 2; its gradient, along
the twist, is homogeneous of degree 1. The motion under a line of force is then a gradient, and the force of
a sticking contact and the wrench for a twist are roots.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import RHO
from planar_pushing.mechanics.outline.grown import (
    Seats,
    are_blocked,
    places_of,
    roll_on,
    seats_at,
)
from planar_pushing.mechanics.outline.places import Places, nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.measured import Mask, Measured

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

    def poses(self, pushes: Measured, friction: float | Array) -> Array:
        """Displacements and rotations of the object's frame by pushes, shape (n, 3).

        The contact friction is that of all pushes, or of each of them, shape (n,).
        """
        friction = np.broadcast_to(np.asarray(friction, dtype=float), len(pushes))
        parts = pushes.path.shape[1]
        steps = -(-STEPS // parts)
        motion = _Motion.begin(pushes)
        for k in range(parts):
            for _ in range(steps):
                motion = self._advance(motion, pushes, pushes.path[:, k] / steps, friction)
        return motion.pose

    def _advance(
        self, motion: _Motion, pushes: Measured, advance: Array, friction: Array
    ) -> _Motion:
        """The motion after a small step of the finger, by the midpoint rule."""
        outline, radius = pushes.outline, motion.radius
        motion, push = motion.after(outline, advance)
        halfway = self._step(motion.pose, motion.seats, outline, radius, push / 2.0, friction)
        middle = roll_on(
            Seats(motion.seats.piece, motion.seats.along + halfway[1]), outline, radius
        )
        step, travel = self._step(motion.pose + halfway[0], middle, outline, radius, push, friction)
        goes = ~motion.is_open & ~motion.is_stopped
        seats = Seats(motion.seats.piece, motion.seats.along + np.where(goes, travel, 0.0))
        seats = roll_on(seats, outline, radius)
        return motion._replace(
            pose=motion.pose + np.where(goes[:, None], step, 0.0),
            seats=seats,
            # An object that does not move is not pushed.
            is_open=motion.is_open | ~step.any(axis=1),
            is_stopped=motion.is_stopped | (goes & are_blocked(seats, outline, radius)),
        )

    def _step(
        self, pose: Array, seats: Seats, outline: Outline, radius: Array, advance: Array, friction: Array
    ) -> tuple[Array, Array]:  # fmt: skip
        """Displacement of the object, and travel along the grown outline, in a small step of the finger."""
        places = places_of(seats, outline, radius)
        twist, slip = self._twist_of_push(places, _turn(advance, -pose[:, 2]), friction)
        step = np.column_stack([_turn(twist[:, :2], pose[:, 2]), twist[:, 2]])
        return step, slip - radius * twist[:, 2]

    def _twist_of_push(self, places: Places, finger: Array, friction: Array) -> tuple[Array, Array]:
        """Twist of the object, and the finger's motion along it: sticking, slipping or separating."""
        point, normal, tangent = places.point, places.normal, places.tangent
        reach = np.zeros((len(point), 2, 3))
        reach[:, 0, 0] = reach[:, 1, 1] = 1.0
        reach[:, 0, 2], reach[:, 1, 2] = -point[:, 1], point[:, 0]
        force = self.forces(reach, finger)
        along, into = (force * tangent).sum(axis=1), (force * normal).sum(axis=1)
        sticks = (into > 0.0) & (np.abs(along) <= friction * into)
        twist, slip = (
            self._motion_under(reach, np.where(sticks[:, None], force, 0.0)),
            np.zeros(len(point)),
        )
        advance = (finger * normal).sum(axis=1)
        for sign in (1.0, -1.0):
            edge = self._motion_under(reach, normal + sign * friction[:, None] * tangent)
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


class _Motion(NamedTuple):
    """The state of pushes.

    Attributes
    ----------
    pose : ndarray, shape (n, 3)
    finger : ndarray, shape (n, 2)
        Centers of the fingers.
    radius : ndarray, shape (n,)
    seats : Seats
    is_open, is_stopped : ndarray of bool, shape (n,)
        Whether the finger does not push the object; whether it would touch a second place.
    """

    pose: Array
    finger: Array
    radius: Array
    seats: Seats
    is_open: Mask
    is_stopped: Mask

    @classmethod
    def begin(cls, pushes: Measured) -> _Motion:
        """The state at the first touch."""
        places, outline = pushes.first_places, pushes.outline
        is_corner = outline.pieces[places.piece, RHO] == 0.0
        # A point at a corner is the limit of a small disc, whose normal changes as it rolls.
        radius = np.where(is_corner, np.maximum(pushes.radius, outline.tolerance), pushes.radius)
        none = np.zeros(len(pushes), dtype=bool)
        return cls(
            np.zeros((len(pushes), 3)), places.point - radius[:, None] * places.normal, radius,
            seats_at(places, outline, radius), none, none,
        )  # fmt: skip

    def after(self, outline: Outline, advance: Array) -> tuple[_Motion, Array]:
        """The state with the finger moved, and the part of its step in contact.

        A finger that does not push and that the step would bring into the object meets it.
        """
        moved = self._replace(finger=self.finger + advance)
        if not self.is_open.any():
            return moved, advance
        rows = np.flatnonzero(self.is_open)
        pose, radius = self.pose[rows], self.radius[rows]
        places = nearest_place(outline, _turn(moved.finger[rows] - pose[:, :2], -pose[:, 2]))
        seats, depth = seats_at(places, outline, radius), radius - places.gap
        rate = (_turn(advance[rows], -pose[:, 2]) * places.normal).sum(axis=1)
        meets = (depth > 0.0) & (rate > 0.0)
        part, piece, along = np.ones(len(advance)), self.seats.piece.copy(), self.seats.along.copy()
        is_open = self.is_open.copy()
        part[rows] = np.clip(np.divide(depth, rate, out=np.ones_like(rate), where=meets), 0.0, 1.0)
        piece[rows[meets]], along[rows[meets]] = seats.piece[meets], seats.along[meets]
        is_open[rows] = ~meets
        return moved._replace(seats=Seats(piece, along), is_open=is_open), part[:, None] * advance


def _turn(vectors: Array, angle: Array) -> Array:
    """Vectors of shape (n, 2) turned by angles."""
    (x, y), c, s = vectors.T, np.cos(angle), np.sin(angle)
    return np.column_stack([c * x - s * y, s * x + c * y])
