"""Pushers and walls, and the places where each touches an object.

A finger is a disc, whose center moves; a fence and a wall are lines, which stay parallel to themselves. The
object is in their frame by its pose: the position of its body frame, and its angle.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import Law
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import BETA0, BETA1, LENGTH, RHO, X, Y
from planar_pushing.terms.numbers import Array

#: Radius of a point finger, in sizes of the outline: it goes around corners as a disc.
POINT_RADIUS = 1e-7
#: Depth of a disc's center in a piece, in sizes of the outline, up to which it touches this piece.
DEPTH = 1e-2
#: Part of a piece's length, or angle in radians, by which a place can be beyond its end.
BEYOND = 1e-12

Vector = tuple[float, float]
#: A position over time, relative to that at time 0, and its velocity.
Path = Callable[[float], tuple[Vector, Vector]]


@dataclass(frozen=True, slots=True)
class Mover:
    """A finger, a fence or a wall.

    Attributes
    ----------
    law : Law
    start : (x, y)
        Position in the world at time 0: of the center of a finger, or of a point of a line.
    radius : float
        Of a finger.
    normal : (n_x, n_y), optional
        Unit normal of a line toward its free side; None for a finger.
    path : callable
        Displacement and velocity at a time.
    """

    law: Law
    start: Vector
    radius: float
    normal: Vector | None
    path: Path

    def at(self, time: float) -> tuple[Vector, Vector]:
        """Position and velocity at a time."""
        (x, y), velocity = self.path(time)
        return (self.start[0] + x, self.start[1] + y), velocity


def rests(time: float) -> tuple[Vector, Vector]:
    """The path of a wall."""
    return (0.0, 0.0), (0.0, 0.0)


class Pose(NamedTuple):
    """Position of the body frame in the world, and its angle."""

    x: float
    y: float
    angle: float

    def after(self, twist: Vector3, time: float) -> Pose:
        """The pose after a constant twist in the body frame; exact for a rotation about a point."""
        v_x, v_y, omega = twist
        half = omega * time / 2.0
        part = math.sin(half) / half if half else 1.0
        middle = self.angle + half
        c, s = math.cos(middle) * part * time, math.sin(middle) * part * time
        return Pose(
            self.x + c * v_x - s * v_y, self.y + s * v_x + c * v_y, self.angle + omega * time
        )


Vector3 = tuple[float, float, float]


class Touch(NamedTuple):
    """A place where a mover touches the object or is near to it, in the body frame.

    Attributes
    ----------
    mover : int
    gap : float
        Distance, negative where they overlap.
    point, normal : (x, y)
        Of the object, and the unit normal into it.
    velocity : (v_x, v_y)
        Of the mover.
    """

    mover: int
    gap: float
    point: Vector
    normal: Vector
    velocity: Vector


class Shape:
    """The pieces of an outline in the body frame, and the touches of movers.

    Parameters
    ----------
    outline : Outline
    """

    def __init__(self, outline: Outline) -> None:
        pieces = outline.pieces
        self.size = float(outline.size)
        self.sides = pieces[np.isinf(pieces[:, RHO])]
        round_ = ~np.isinf(pieces[:, RHO]) & ~(
            (pieces[:, RHO] == 0.0) & (pieces[:, BETA1] < pieces[:, BETA0])
        )
        self.rounds = pieces[round_]
        tangents = np.stack([np.cos(self.sides[:, BETA0]), np.sin(self.sides[:, BETA0])], axis=-1)
        self.tangents, self.starts = tangents, self.sides[:, [X, Y]]
        self.normals = np.stack([-tangents[:, 1], tangents[:, 0]], axis=-1)
        # Ends of sides beside arcs; those at corners are corners.
        ends = [*self.starts, *(self.starts + self.sides[:, [LENGTH]] * tangents)]
        corners = self.rounds[self.rounds[:, RHO] == 0.0][:, [X, Y]]
        self.corners = corners
        self.joints = np.array(
            [end for end in ends if not _is_among(end, pieces[pieces[:, RHO] == 0.0][:, [X, Y]])]
        ).reshape(-1, 2)
        self.points = np.concatenate([corners, self.joints])

    def touches(
        self, number: int, mover: Mover, pose: Pose, time: float, reach: float
    ) -> list[Touch]:
        """The touches of one mover that are nearer than a reach, in the order of their places."""
        (x, y), (v_x, v_y) = mover.at(time)
        c, s = math.cos(pose.angle), math.sin(pose.angle)
        velocity = c * v_x + s * v_y, c * v_y - s * v_x
        dx, dy = x - pose.x, y - pose.y
        center = c * dx + s * dy, c * dy - s * dx
        if mover.normal is None:
            radius = max(mover.radius, POINT_RADIUS * self.size)
            places = self._near_disc(center, radius, reach)
        else:
            n_x, n_y = mover.normal
            places = self._near_line(center, (c * n_x + s * n_y, c * n_y - s * n_x), reach)
        return [Touch(number, gap, point, normal, velocity) for gap, point, normal in places]

    def _near_disc(
        self, center: Vector, radius: float, reach: float
    ) -> list[tuple[float, Vector, Vector]]:
        """Gaps, points and normals of the pieces that are nearest to a disc at an inner place of theirs."""
        found: list[tuple[float, Vector, Vector]] = []
        deepest = radius + DEPTH * self.size
        if len(self.sides):
            away = np.asarray(center) - self.starts
            along = (away * self.tangents).sum(axis=1)
            gaps = -(away * self.normals).sum(axis=1) - radius
            slack = BEYOND * self.size
            near = (along >= -slack) & (along <= self.sides[:, LENGTH] + slack)
            for k in np.flatnonzero(near & (gaps <= reach) & (gaps >= -deepest)):
                point = self.starts[k] + along[k] * self.tangents[k]
                _add_place(found, gaps[k], point, self.normals[k], slack)
        for row in self.rounds:
            away_x, away_y = center[0] - row[X], center[1] - row[Y]
            distance, rho = math.hypot(away_x, away_y), row[RHO]
            sign = -1.0 if rho < 0.0 else 1.0
            gap = sign * (distance - abs(rho)) - radius
            if not distance or not -deepest <= gap <= reach:
                continue
            n_x, n_y = -sign * away_x / distance, -sign * away_y / distance
            if _has_direction(row, math.atan2(-n_x, n_y)):
                point = np.array([row[X] - rho * n_x, row[Y] - rho * n_y])
                _add_place(found, gap, point, (n_x, n_y), BEYOND * self.size)
        return sorted(found, key=lambda place: math.atan2(place[2][1], place[2][0]))

    def _near_line(
        self, origin: Vector, normal: Vector, reach: float
    ) -> list[tuple[float, Vector, Vector]]:
        """Gaps and points of the corners, the ends of sides and the arcs that are near to a line."""
        n_x, n_y = normal
        heights = (self.points - origin) @ np.array(normal)
        found = [
            (float(heights[k]), (float(self.points[k, 0]), float(self.points[k, 1])), normal)
            for k in np.flatnonzero(heights <= reach)
        ]
        for row in self.rounds:
            if row[RHO] <= 0.0 or not _has_direction(row, math.atan2(-n_x, n_y)):
                continue
            height = (row[X] - origin[0]) * n_x + (row[Y] - origin[1]) * n_y - row[RHO]
            if height <= reach:
                point = float(row[X] - row[RHO] * n_x), float(row[Y] - row[RHO] * n_y)
                if all(math.dist(point, other) > BEYOND * self.size for _, other, _ in found):
                    found.append((float(height), point, normal))
        return sorted(found, key=lambda place: place[1][0] * n_y - place[1][1] * n_x)


def _add_place(
    found: list[tuple[float, Vector, Vector]],
    gap: float,
    point: Array,
    normal: object,
    slack: float,
) -> None:
    """Add a place, unless it is that at which two pieces join."""
    n_x, n_y = map(float, normal)  # type: ignore[call-overload]
    for other_gap, (x, y), (m_x, m_y) in found:
        turned = math.hypot(n_x - m_x, n_y - m_y)
        apart = math.hypot(point[0] - x, point[1] - y)
        if abs(other_gap - gap) <= slack and turned <= 1e-6 and apart <= 1e3 * slack:
            return
    found.append((float(gap), (float(point[0]), float(point[1])), (n_x, n_y)))


def _has_direction(row: Array, direction: float) -> bool:
    """Whether the tangent of an arc or a corner has a direction."""
    low, high = sorted((float(row[BETA0]), float(row[BETA1])))
    middle = (low + high) / 2.0
    turn = math.remainder(direction - middle, 2.0 * math.pi)
    return abs(turn) <= (high - low) / 2.0 + BEYOND


def _is_among(point: Array, others: Array) -> bool:
    """Whether a point is one of others."""
    return bool(len(others)) and bool(np.hypot(*(others - point).T).min() <= 1e-12 + 1e-9)
