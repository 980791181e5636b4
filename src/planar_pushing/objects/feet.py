"""Feet that replace a support, for tools with friction at points, and their error."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.wrench import wrench
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.pressure.pieces import Pieces
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Composite, Points, Ring

#: Number of samples of a line, and of an area along x and along y, before it is divided among feet. They
#: are multiples of powers of two, so that halves of a symmetric support are halves of its samples.
LINE, AREA = 1920, 240
#: Pressure below this fraction of the maximum is rounding error, left in the hole of a disc.
ROUNDING = 1e-9
#: Number of motions at which feet and support are compared; twice as many change the mean error by less
#: than 1 percent.
MOTIONS = 2_000
#: Number of directions around each foot, and distance in radii, of centers of rotation beside it.
AROUND, BESIDE = 16, 1e-6


class Feet(NamedTuple):
    """Points that carry a support's weight.

    Attributes
    ----------
    places : ndarray, shape (n, 2)
        In the body frame.
    weights : ndarray, shape (n,)
        Forces of friction: shares of W.
    """

    places: Array
    weights: Array


def feet_of(scene: Scene, count: int) -> Feet:
    """Feet for the friction of a scene: its own points, and `count` for the rest of each support.

    The pressure that is not on points is repeatedly halved along the longer extent until there is one piece
    per foot, which is at the center of pressure of the piece. The feet are then moved away from their
    common center by one factor, so that the torque of spinning about it equals that of the support.
    """
    parts = [
        _feet(_of_scene(effect.support, scene), effect.weight, count) for effect in scene.friction
    ]
    return Feet(*map(np.concatenate, zip(*parts, strict=True)))


def force_errors(scene: Scene, feet: Feet) -> tuple[float, float]:
    """Mean and maximum angle between the wrenches of the scene's friction and of the feet, in radians.

    The wrenches (f_x, f_y, tau / R) are about the center of pressure and for the same motion; the motions
    are spread evenly over the sphere of (v_x, v_y, R omega). The maximum includes rotations about points
    beside each foot.
    """
    radius = scene.slider.radius
    center = feet.weights @ feet.places / feet.weights.sum()
    approximation = SupportFriction(support=Points(*feet), weight=feet.weights.sum())

    def loads(effect: Any, motions: Array) -> Array:
        v_x, v_y, spin = motions[:, 0], motions[:, 1], motions[:, 2] / radius
        twists = np.column_stack([v_x + spin * center[1], v_y - spin * center[0], spin])
        f_x, f_y, torque = wrench(effect, twists, scene.slider).T
        torque = torque - center[0] * f_y + center[1] * f_x
        return np.column_stack([f_x, f_y, torque / radius])

    def errors(motions: Array) -> Array:
        exact = sum(loads(effect, motions) for effect in scene.friction)
        approximate = loads(approximation, motions)
        cross = np.linalg.norm(np.cross(exact, approximate), axis=1)
        return np.asarray(np.arctan2(cross, np.einsum("ij,ij->i", exact, approximate)))

    spread = errors(_spread_motions(MOTIONS))
    beside = errors(_beside((feet.places - center) / radius))
    return float(spread.mean()), float(max(spread.max(), beside.max()))


def _of_scene(support: Any, scene: Scene) -> Any:
    """The support, with the slider's radius for a ring without one."""
    lacks_radius = isinstance(support, Ring) and support.radius is None
    return replace(support, radius=scene.slider.radius) if lacks_radius else support


def _feet(support: Any, weight: float, count: int) -> Feet:
    points, rest = _sample_pressure(support)
    if len(rest):
        points = np.concatenate([points, _divide_samples(rest, count)])
    return Feet(points[:, :2], weight * points[:, 2] / points[:, 2].sum())


def _sample_pressure(support: Any) -> tuple[Array, Array]:
    """Points of a support, and samples of its remaining pressure; rows of x, y and share."""
    if isinstance(support, Composite):
        shares = [share for share, _ in support.members]
        parts = [_sample_pressure(member) for _, member in support.members]
        scaled = [
            [rows * (1.0, 1.0, share) for rows in part]
            for share, part in zip(shares, parts, strict=True)
        ]
        points, rest = map(np.concatenate, zip(*scaled, strict=True))
        return points, rest
    pieces: Pieces = support.pieces()
    spread = [_on_segment(row) for row in pieces.segments]
    spread += [_on_ring(row) for row in pieces.rings]
    if len(pieces.discs) or pieces.plates:
        spread.append(_on_area(pieces))
    return pieces.atoms, np.concatenate([np.empty((0, 3)), *spread])


def _on_segment(row: Array) -> Array:
    along = (np.arange(LINE)[:, None] + 0.5) / LINE
    places = row[:2] + along * (row[2:4] - row[:2])
    return np.column_stack([places, np.full(LINE, row[4] / LINE)])


def _on_ring(row: Array) -> Array:
    turn = 2.0 * pi * (np.arange(LINE) + 0.5) / LINE
    places = row[:2] + row[2] * np.column_stack([np.cos(turn), np.sin(turn)])
    return np.column_stack([places, np.full(LINE, row[3] / LINE)])


def _on_area(pieces: Pieces) -> Array:
    """Samples of discs and plates on a common grid, with shares proportional to the pressure."""
    discs, edges = pieces.discs, np.concatenate([np.empty((0, 5)), *pieces.plates])
    reach = discs[:, 2:3]
    ends = np.concatenate([discs[:, :2] - reach, discs[:, :2] + reach, edges[:, :2], edges[:, 2:4]])
    low, size = ends.min(axis=0), np.ptp(ends, axis=0)
    x, y = (low[:, None] + size[:, None] * (np.arange(AREA) + 0.5) / AREA)[:2]
    pressure = np.array([_along_column(edges, abscissa, y) for abscissa in x])
    for c_x, c_y, radius, share in discs:
        inside = np.hypot(x[:, None] - c_x, y - c_y) < radius
        pressure += share / (pi * radius**2) * inside
    i, j = np.nonzero(pressure > ROUNDING * pressure.max())
    loads = pressure[i, j]
    shares = discs[:, 3].sum() + (edges[:, 4] * _doubled_areas(edges)).sum() / 2.0
    return np.column_stack([x[i], y[j], shares * loads / loads.sum()])


def _doubled_areas(edges: Array) -> Array:
    """Twice the signed areas between edges and the origin."""
    return np.asarray(edges[:, 0] * edges[:, 3] - edges[:, 1] * edges[:, 2])


def _along_column(edges: Array, x: float, y: Array) -> Array:
    """Pressure of plates at points (x, y) of one column, as the sum of the jumps of all edges below."""
    start, end, low, high, jump = edges[:, 0], edges[:, 2], edges[:, 1], edges[:, 3], edges[:, 4]
    sense = np.sign(end - start) * ((start > x) != (end > x))
    met = sense != 0.0
    height = low[met] + (x - start[met]) / (end - start)[met] * (high - low)[met]
    return np.asarray((sense * jump)[met] @ (height[:, None] < y))


def _divide_samples(samples: Array, count: int) -> Array:
    """Feet of samples, with equal shares; rows of x, y and share."""
    feet = np.array(_halve_samples(samples, count))
    center = _center(samples)
    exact, approximate = (
        rows[:, 2] @ np.hypot(*(rows[:, :2] - center).T) for rows in (samples, feet)
    )
    feet[:, :2] = center + (feet[:, :2] - center) * exact / approximate
    return feet


def _halve_samples(samples: Array, count: int) -> list[Array]:
    shares = samples[:, 2]
    if count == 1:
        return [np.append(_center(samples), shares.sum())]
    spread = shares @ (samples[:, :2] - _center(samples)) ** 2
    along = int(spread[1] > spread[0] * (1.0 + ROUNDING))
    rows = samples[np.lexsort((samples[:, 1 - along], samples[:, along]))]
    carried = rows[:, 2].cumsum()
    first = count // 2
    cut = int(np.searchsorted(carried, carried[-1] * first / count * (1.0 + ROUNDING)))
    return _halve_samples(rows[:cut], first) + _halve_samples(rows[cut:], count - first)


def _center(rows: Array) -> Array:
    return np.asarray(rows[:, 2] @ rows[:, :2] / rows[:, 2].sum())


def _spread_motions(count: int) -> Array:
    """Motions spread evenly over a hemisphere; the opposite motions have the opposite wrenches."""
    index = np.arange(count)
    spin, turn = (index + 0.5) / count, index * pi * (3.0 - sqrt(5.0))
    speed = np.sqrt(1.0 - spin * spin)
    return np.column_stack([speed * np.cos(turn), speed * np.sin(turn), spin])


def _beside(feet: Array) -> Array:
    """Rotations about points beside each foot; feet are relative to the center of pressure, in radii."""
    turn = 2.0 * pi * (np.arange(AROUND) + 0.5) / AROUND
    around = BESIDE * np.column_stack([np.cos(turn), np.sin(turn)])
    x, y = (feet[:, None] + around).reshape(-1, 2).T
    return np.column_stack([y, -x, np.ones(len(x))])
