"""Motion of the support of a pushed slider over the plane, and the friction on it."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring

RING_ANGLES = np.arange(0.0, 360.0, 15.0)
#: A place slower than this, relative to the fastest place, is at the center of rotation.
STILL = 1e-12


def support_of(scene: Scene) -> Any:
    """Support of a scene with its dimensions; without one, the ring of the slider's radius."""
    resting = [
        effect.support for effect in (*scene.friction, *scene.effects) if hasattr(effect, "support")
    ]
    support = resting[0] if resting else Ring()
    return Ring(scene.slider.radius) if support == Ring() else support


def ring_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """Motion of points of the ring and the friction force on them, which is zero without friction."""
    outward = scene.slider.radius * direction(np.deg2rad(RING_ANGLES))
    motion = _motion(outward, twists)
    dims = ("solution", "support_angle", "xy")
    return {
        "support_motion": (dims, motion),
        "support_force": (dims, -_weight(scene) / (2 * np.pi) * _heading(motion, 0.0)),
    }


def place_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """As `ring_friction`, for any support: sample places and the friction force that each represents."""
    slider = scene.slider
    rows = places(support_of(scene).pieces())
    x, y = direction(slider.rod_angle)
    arm = rows[:, :2] @ np.array([[x, y], [-y, x]])
    motion = _motion(arm, twists)
    dims = ("solution", "place", "xy")
    return {
        "place_position": (("place", "xy"), slider.rod_length * np.array([x, y]) + arm),
        "place_share": ("place", rows[:, 2]),
        "place_motion": (dims, motion),
        "place_force": (dims, -_weight(scene) * rows[:, 2:] * _heading(motion, STILL)),
    }


def _weight(scene: Scene) -> float:
    """Friction force in a translation."""
    return float(sum(effect.weight for effect in scene.friction))


def _motion(arm: Array, twists: Array) -> Array:
    """Velocities of points at given positions relative to the slider's center."""
    turned = np.stack([-arm[:, 1], arm[:, 0]], axis=-1)
    return np.asarray(twists[:, None, :2] + twists[:, None, 2:] * turned)


def _heading(motion: Array, still: float) -> Array:
    """Unit vectors along motions; zero for motions slower than `still` times the fastest."""
    speed = np.linalg.norm(motion, axis=-1, keepdims=True)
    moves = speed > still * speed.max(axis=1, keepdims=True, initial=0.0)
    return np.asarray(np.divide(motion, speed, out=np.zeros_like(motion), where=moves))


#: Number of places of a ring and of a segment, and approximate number of all areas together, if it carries
#: the whole weight; one that carries a fraction has fewer, down to the minimum.
RING, SEGMENT, AREA, MINIMUM = 24, 9, 24, 4
#: Cells per side of the grid that estimates the fraction of its bounding box that an area fills.
MEASURED = 40


def places(pieces: Pieces) -> Array:
    """Places in the body frame and their fractions of the weight, shape (n, 3); support points first."""
    rings = [_around(*ring) for ring in pieces.rings]
    segments = [_along(*segment) for segment in pieces.segments]
    return np.concatenate([pieces.atoms, *rings, *segments, _cover_areas(pieces)])


def _count(total: int, share: float) -> int:
    """Number of places for a fraction of the weight."""
    return max(MINIMUM, round(total * share))


def _around(x: float, y: float, radius: float, share: float) -> Array:
    """Places around a ring."""
    count = _count(RING, share)
    around = [x, y] + radius * direction(np.linspace(0.0, 2.0 * np.pi, count, endpoint=False))
    return np.column_stack([around, np.full(count, share / count)])


def _along(x: float, y: float, end_x: float, end_y: float, share: float) -> Array:
    """Midpoints of equal parts of a segment."""
    count = _count(SEGMENT, share)
    part = (np.arange(count) + 0.5) / count
    along = np.stack([x + part * (end_x - x), y + part * (end_y - y)], axis=1)
    return np.column_stack([along, np.full(count, share / count)])


def _cover_areas(pieces: Pieces) -> Array:
    """Midpoints of nearly square cells that cover the areas, weighted by the pressure there."""
    middles, radii = pieces.discs[:, :2], pieces.discs[:, 2:3]
    ends = [edges[:, :4].reshape(-1, 2) for edges in pieces.plates]
    corners = np.concatenate([middles - radii, middles + radii, *ends])
    if not len(corners):
        return np.empty((0, 3))
    low, high = corners.min(axis=0), corners.max(axis=0)
    share = 1.0 - sum(float(kind[:, -1].sum()) for kind in pieces[:3])
    filled = np.mean(pressure_at(pieces, _middles(low, high, MEASURED, MEASURED)) > 0)
    side = np.sqrt(max(filled, 1 / MEASURED) * np.prod(high - low) / _count(AREA, share))
    columns, rows = (max(1, int(count)) for count in np.rint((high - low) / side))
    points = _middles(low, high, columns, rows)
    pressure = pressure_at(pieces, points)
    points, pressure = points[pressure > 0], pressure[pressure > 0]
    return np.column_stack([points, share * pressure / pressure.sum()])


def _middles(low: Array, high: Array, columns: int, rows: int) -> Array:
    """Midpoints of the cells of a grid over a box, shape (n, 2)."""
    x = low[0] + (np.arange(columns) + 0.5) * (high[0] - low[0]) / columns
    y = low[1] + (np.arange(rows) + 0.5) * (high[1] - low[1]) / rows
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)


def pressure_at(pieces: Pieces, points: Array) -> Array:
    """Pressure of the areas at points of shape (n, 2); exactly zero outside them."""
    total, largest = np.zeros(len(points)), np.zeros(len(points))
    for x, y, radius, share in pieces.discs:
        inside = np.hypot(points[:, 0] - x, points[:, 1] - y) < radius
        part = inside * share / (np.pi * radius**2)
        total, largest = total + part, np.maximum(largest, np.abs(part))
    for edges in pieces.plates:
        part = _pressure_of_plate(edges, points)
        total, largest = total + part, np.maximum(largest, np.abs(part))
    return np.where(total > 1e-9 * largest, total, 0.0)


def _pressure_of_plate(edges: Array, points: Array) -> Array:
    """Pressure within a plate: the sum of its steps across all edges to the right of a point."""
    x, y = points[:, 0, None], points[:, 1, None]
    start_x, start_y, end_x, end_y, step = edges.T
    upward = (start_y <= y) & (y < end_y)
    downward = (end_y <= y) & (y < start_y)
    height = np.where(start_y == end_y, 1.0, end_y - start_y)
    right = start_x + (y - start_y) / height * (end_x - start_x) > x
    return np.asarray(((upward * 1.0 - downward * 1.0) * right) @ step)
