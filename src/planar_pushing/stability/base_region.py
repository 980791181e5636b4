"""The base of an object, of which only the region is known, seen from the contact.

The origin is the contact, the contact moves with unit velocity, and the farthest point of the base is at
the distance 1. A motion with this velocity u and the rotation omega moves the point r along
``v = cos(eta) u + sin(eta) J r`` with tan(eta) = omega, where J rotates by +90 degrees: at eta = 0 the
object translates, at +-pi/2 it rotates about the contact. The centers of rotation ``cot(eta) J u`` form a
line through the contact, their path.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.pressure.support_in_frames import KINDS
from planar_pushing.mechanics.supports import Polygon, PressureMap, Ring
from planar_pushing.mechanics.supports.base import require_support
from planar_pushing.mechanics.supports.pressure_map import pressed_area
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import as_array

Ints = npt.NDArray[np.intp]
Flags = npt.NDArray[np.bool_]
#: Relative error of places: of a center of pressure on the rim of the base, or a point on a line.
CLOSE = 1e-12
#: Number of directions in which the hull of a base is examined at first.
DIRECTIONS = 720
#: Distance from the path of the centers within which a line lies on it.
PARALLEL = 1e-15
#: Share of the largest pressure below which there is none.
NO_PRESSURE = 1e-12


class Curves(NamedTuple):
    """Points, straight lines and circles that carry weight, or bound areas that do.

    Attributes
    ----------
    start : ndarray, shape (n, 2)
        A point, the start of a line, or the center of a circle.
    tangent : ndarray, shape (n, 2)
        Unit tangent of a line; zero for others.
    radius : ndarray, shape (n,)
        Radius of a circle; zero for others.
    length : ndarray, shape (n,)
    """

    start: Array
    tangent: Array
    radius: Array
    length: Array

    def points(self, number: Ints, along: Array) -> tuple[Array, Array]:
        """Points at arc lengths along curves, and the unit tangents there, zero for a point."""
        start, tangent = self.start[number], self.tangent[number]
        radius = self.radius[number][..., None]
        angle = along[..., None] / np.where(radius > 0.0, radius, 1.0)
        cosine, sine = np.cos(angle), np.sin(angle)
        out, across = np.concatenate([cosine, sine], -1), np.concatenate([-sine, cosine], -1)
        points = start + np.where(radius > 0.0, radius * out, along[..., None] * tangent)
        return points, np.where(radius > 0.0, across, tangent)

    @property
    def end(self) -> Array:
        """Ends of lines."""
        return self.start + self.tangent * self.length[:, None]

    @property
    def curvature(self) -> Array:
        """Curvature of each."""
        return np.divide(1.0, self.radius, out=np.zeros_like(self.radius), where=self.radius > 0.0)

    def nearest(self, point: Array) -> tuple[Array, Array]:
        """Arc length on each at which it is nearest to a place, and the distance there."""
        away = point - self.start
        line = np.clip((away * self.tangent).sum(axis=1), 0.0, self.length)
        turn = np.mod(np.arctan2(away[:, 1], away[:, 0]), 2.0 * np.pi)
        along = np.where(self.radius > 0.0, turn * self.radius, line)
        points, _ = self.points(np.arange(len(along)), along)
        return along, np.hypot(*(points - point).T)


class Areas(NamedTuple):
    """Rims of areas: ends of edges with the pressure on their left minus that on the right, and discs."""

    edges: Array
    discs: Array

    def contain(self, points: Array) -> Flags:
        """Whether there is pressure at points of shape (n, 2); undetermined on a rim."""
        a, b = self.edges[:, :2] - points[:, None], self.edges[:, 2:4] - points[:, None]
        side = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        up, down = (a[..., 1] <= 0.0) & (b[..., 1] > 0.0), (a[..., 1] > 0.0) & (b[..., 1] <= 0.0)
        wound = (up & (side > 0.0)).astype(float) - (down & (side < 0.0))
        away = points[:, None] - self.discs[:, :2]
        covered = (away**2).sum(axis=-1) < self.discs[:, 2] ** 2
        pressure = self.discs[:, 3] / np.maximum(np.pi * self.discs[:, 2] ** 2, 1e-300)
        total = wound @ self.edges[:, 4] + covered @ pressure
        most = np.abs(np.concatenate([self.edges[:, 4], pressure])).max(initial=0.0)
        return np.asarray(total > NO_PRESSURE * most)


@dataclass(frozen=True, eq=False)
class Base:
    """A base and its center of pressure, seen from the contact.

    Attributes
    ----------
    curves : Curves
    areas : Areas
    center : ndarray, shape (2,)
        The center of pressure.
    motion : ndarray, shape (2,)
        Unit vector along the contact's velocity.
    size : float
        The unit of length, in the user's.
    rate : float
        The unit of rotations.
    """

    curves: Curves
    areas: Areas
    center: Array
    motion: Array
    size: float
    rate: float

    @cached_property
    def path(self) -> Array:
        """Direction of the path of the centers of rotation."""
        return np.array([-self.motion[1], self.motion[0]])

    @cached_property
    def on_path(self) -> Flags:
        """Whether each curve lies on the path of the centers."""
        off = np.maximum(
            np.abs(self.curves.start @ self.motion), np.abs(self.curves.end @ self.motion)
        )
        return np.asarray((off <= PARALLEL) & (self.curves.radius == 0.0))

    def crossings(self) -> tuple[Ints, Array]:
        """Curves, and arc lengths on them, at which they cross the path of the centers."""
        start, radius = self.curves.start, self.curves.radius
        across, slope = start @ self.motion, self.curves.tangent @ self.motion
        lines = np.flatnonzero((slope != 0.0) & (radius == 0.0))
        along = -across[lines] / slope[lines]
        inside = (along >= 0.0) & (along <= self.curves.length[lines])
        rounds = np.flatnonzero((np.abs(across) <= radius) & (radius > 0.0))
        turn = math.atan2(self.motion[1], self.motion[0])
        half = np.arccos(-across[rounds] / radius[rounds])
        arcs = np.mod(turn + np.concatenate([half, -half]), 2.0 * np.pi) * np.tile(
            radius[rounds], 2
        )
        return np.concatenate([lines[inside], rounds, rounds]), np.concatenate(
            [along[inside], arcs]
        )

    def arrivals(self) -> Array:
        """Rotations eta at which the center of rotation arrives at a curve, or at the end of a line."""
        points, _ = self.curves.points(*self.crossings())
        ends = np.concatenate([self.curves.start, self.curves.end])
        flat = np.tile(self.curves.radius == 0.0, 2)
        ends = ends[flat & (np.abs(ends @ self.motion) <= CLOSE)]
        along = np.concatenate([points, ends]) @ self.path
        along = along[along != 0.0]
        return np.unique(np.arctan2(np.sign(along), np.abs(along)))

    @cached_property
    def inner_spans(self) -> tuple[tuple[float, float], ...]:
        """Intervals of eta in which the center of rotation may be inside an area."""
        ends = np.unique(self._crossings())
        if len(ends) < 2:
            return ()
        middles = (ends[:-1] + ends[1:]) / 2
        inside = self.areas.contain(middles[:, None] * self.path)
        spans = []
        for low, high in zip(ends[:-1][inside], ends[1:][inside], strict=True):
            parts = ((low, min(high, 0.0)), (max(low, 0.0), high))
            spans += [_turns(*part) for part in parts if part[0] < part[1]]
        return tuple(spans)

    def covers(self, eta: float) -> bool:
        """Whether the center of rotation may be inside an area."""
        return any(low <= eta <= high for low, high in self.inner_spans)

    def _crossings(self) -> Array:
        """Coordinates on the path at which it meets the rims of areas."""
        start, end = self.areas.edges[:, :2], self.areas.edges[:, 2:4]
        a, b = start @ self.motion, end @ self.motion
        meets = (np.minimum(a, b) <= CLOSE) & (np.maximum(a, b) >= -CLOSE)
        start, end, a, b = start[meets], end[meets], a[meets], b[meets]
        part = np.clip(np.divide(a, a - b, out=np.zeros_like(a), where=a != b), 0.0, 1.0)
        met = [start + part[:, None] * (end - start), start[a == b], end[a == b]]
        middle, radius = self.areas.discs[:, :2], self.areas.discs[:, 2]
        square = radius**2 - (middle @ self.motion) ** 2
        half = np.sqrt(np.maximum(square, 0.0))[square >= 0.0]
        along = (middle @ self.path)[square >= 0.0]
        return np.concatenate([np.concatenate(met) @ self.path, along - half, along + half])


def _turns(low: float, high: float) -> tuple[float, float]:
    """The interval of eta whose cotangents are [low, high], all of one sign."""
    sign = 1.0 if low >= 0.0 else -1.0
    ends = sorted(math.atan2(sign, sign * end) for end in (low, high))
    return ends[0] - CLOSE, ends[1] + CLOSE


def base_at(
    region: Any, center_of_pressure: Any, point: npt.ArrayLike, velocity: npt.ArrayLike
) -> Base:
    """A base seen from a contact that moves with a velocity.

    Raises
    ------
    InvalidValue
        If the region is neither an outline nor a support, a pair is not two finite numbers, the velocity is
        zero, or the center of pressure is outside of the region's convex hull.
    """
    support = require_region(region)
    # A rim between two cells of a map would only add work.
    pieces = pressed_area(support) if isinstance(support, PressureMap) else support.pieces()
    origin, (x, y) = np.array(_pair("point", point)), _pair("velocity", velocity)
    speed = math.hypot(x, y)
    if not speed:
        raise InvalidValue(
            "velocity", velocity, "a nonzero vector", "give the velocity of the contact"
        )
    center = np.array(_pair("center_of_pressure", center_of_pressure)) - origin
    curves, areas = _curves(pieces, origin), _areas(pieces, origin)
    if not curves.length.any() and (curves.start == curves.start[0]).all():
        raise InvalidValue(
            "region", region, "a region of more than one point",
            "one point that carries all weight does not resist rotation",
        )  # fmt: skip
    size = _reach(curves)
    scaled = Curves(curves.start / size, curves.tangent, curves.radius / size, curves.length / size)
    discs, edges = areas.discs.copy(), areas.edges.copy()
    discs[:, :3] /= size
    edges[:, :4] /= size
    off = _beyond(scaled, center / size)
    if off > CLOSE:
        raise InvalidValue(
            "center_of_pressure", tuple(map(float, center + origin)),
            "a position in the convex hull of the region",
            f"no pressure has a center {off * size:.3g} outside of the hull; check frame and units",
        )  # fmt: skip
    motion = np.array([x / speed, y / speed])
    return Base(scaled, Areas(edges, discs), center / size, motion, size, speed / size)


def require_region(value: Any) -> Any:
    """A region as a support: the support that was given, or a polygon of the outline."""
    if type(value) in KINDS or all(hasattr(type(value), name) for name in ("pieces", "extent")):
        support = require_support("region", value)
        if isinstance(support, Ring) and support.radius is None:
            raise InvalidValue(
                "region", support, "a ring with a radius", "give the radius, as in Ring(1.0)"
            )
        return support
    try:
        return Polygon(value)
    except InvalidValue as error:
        raise InvalidValue(
            "region", error.given,
            f"an outline, which is {error.allowed}, or a support, such as Points or Disc", error.remedy,
        ) from None  # fmt: skip


def _pair(name: str, value: Any) -> tuple[float, float]:
    numbers = as_array(value)
    if numbers is None or numbers.shape != (2,) or not np.isfinite(numbers).all():
        raise InvalidValue(name, value, "two finite numbers", "give x and y in the object's frame")
    return float(numbers[0]), float(numbers[1])


def _curves(pieces: Pieces, origin: Array) -> Curves:
    """All points, lines and circles of pieces."""
    plates = np.concatenate([np.empty((0, 5)), *pieces.plates])
    lines = np.concatenate([pieces.segments, plates])
    rounds = np.concatenate([pieces.rings, pieces.discs])
    away = lines[:, 2:4] - lines[:, :2]
    length = np.hypot(*away.T)
    zeros = np.zeros((len(rounds), 2))
    return Curves(
        np.concatenate([pieces.atoms[:, :2], lines[:, :2], rounds[:, :2]]) - origin,
        np.concatenate([np.zeros((len(pieces.atoms), 2)), away / length[:, None], zeros]),
        np.concatenate([np.zeros(len(pieces.atoms) + len(lines)), rounds[:, 2]]),
        np.concatenate([np.zeros(len(pieces.atoms)), length, 2.0 * np.pi * rounds[:, 2]]),
    )


def _areas(pieces: Pieces, origin: Array) -> Areas:
    edges = np.concatenate([np.empty((0, 5)), *pieces.plates])
    discs = pieces.discs.copy()
    discs[:, :2] -= origin
    return Areas(np.column_stack([edges[:, :4] - np.tile(origin, 2), edges[:, 4]]), discs)


def _reach(curves: Curves) -> float:
    """Largest distance from the origin."""
    ends = np.concatenate([curves.start, curves.end])
    return float((np.hypot(*ends.T) + np.tile(curves.radius, 2)).max())


def _beyond(curves: Curves, point: Array) -> float:
    """Distance of a place from the convex hull; negative inside."""
    angles, width = np.linspace(-np.pi, np.pi, DIRECTIONS + 1), 2.0 * np.pi / DIRECTIONS
    while True:
        normals = np.stack([np.cos(angles), np.sin(angles)])
        reach = np.maximum(curves.start @ normals, curves.end @ normals) + curves.radius[:, None]
        off = point @ normals - reach.max(axis=0)
        best = int(off.argmax())
        if width < 1e-9:
            return float(off[best])
        angles = np.linspace(angles[best] - width, angles[best] + width, 17)
        width /= 8.0
