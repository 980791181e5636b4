"""Marks of a motion over time: slider and pusher at an instant, their past paths, and the first pusher."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import add_body, add_fence, add_finger, body_in
from planar_pushing.drawing.canvas.colors import (
    CENTER,
    FENCE,
    GUIDE,
    IMPACT,
    MODES,
    PUSHER,
    SLIDER,
)
from planar_pushing.drawing.canvas.marks import (
    ARROWS,
    LINES,
    NOTE,
    Arrow,
    Picture,
    arc,
    corners,
)
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.supports import Ink, Pose
from planar_pushing.drawing.timeline import (
    contact,
    contact_jumps,
    corner_positions,
    finger_center,
    finger_radius,
    is_pivot,
    normal,
    pusher_heading,
    rod_end,
    runs,
    side_on_fence,
)
from planar_pushing.drawing.walls import DrawnWall, add_wall
from planar_pushing.mechanics.plane import Array

#: A longer step of the motion center between two rows, in units of the slider's span, is a jump.
JUMP = 0.5
#: Drawn length of the force, and of the velocity of the pusher at its highest speed, in units of the span.
FORCE_LENGTH, PUSHER_LENGTH = 0.4, 0.2
#: Half the width of the fence, and depth of its hatch, in units of the span.
FENCE_HALF, DEPTH = 0.32, 0.036
#: Room for the name of a velocity beyond its arrow, in units of the arrow's length.
ROOM = 0.4
#: Distance of the velocity of a finger from the finger, in units of the span.
ASIDE = 0.08
#: A force within this angle of the fence, radians, is drawn beside it, at this distance in spans.
ALONG_FENCE, BESIDE = 0.1, 0.05
#: A pusher that moved by less, in units of the span, covers its first position; with the larger distance
#: there is room for a label.
MOVED, NAMED = 1e-3, 0.08
#: Drawing orders of paths and of their arrowheads.
PATHS = ARROWS - 0.5


def pose(data: xr.Dataset, row: int) -> Pose:
    """Pose of the slider at a row."""
    angle = float(np.deg2rad(data["path_rod_angle"].values[row]))
    return Pose(data["path_position"].values[row], angle)


def span(data: xr.Dataset) -> float:
    """Extent of the slider from the contact."""
    body = body_in(data)
    x, y = body.middle
    return float(np.hypot(x + float(data["rod_length"]), y)) + body.half


def box(data: xr.Dataset) -> Array:
    """Corners of the box around slider, pusher and arrows over the motion, and the last center if near."""
    body, half, ends = body_in(data), FENCE_HALF * span(data), fence_ends(data)
    points = [contact(data), data["path_position"].values, *last_center(data)]
    points += [body.box(pose(data, row)) for row in range(data.sizes["time"])]
    points.append(contact(data) + force_arrows(data))
    points += [_outer_end(data, row, 1.0 + ROOM) for row in range(data.sizes["time"])]
    if "path_side" in data:
        # Of a finger much larger than the slider, only the region near the side is included.
        reach = min(finger_radius(data), half)
        points.append(data["path_side"].values)
        points += [contact(data) - reach * normal(data) + end * reach for end in (-1.0, 1.0)]
    else:
        low = zip(ends, (-0.1 * half, 0.0), strict=True)
        points += [data["path_pusher"].values + np.array(end) for end in low]
    for row in range(data.sizes["time"]):
        points += [ends for ends, _ in wall_segments(data, row)]
    return corners(points)


def fence_ends(data: xr.Dataset) -> tuple[float, float]:
    """Ends of the drawn fence, from the pusher's position; every contact and side lies between them."""
    half = FENCE_HALF * span(data)
    along = (contact(data) - data["path_pusher"].values)[data["path_mode"].values > 0, 0]
    if "path_flush" in data:
        sides = (corner_positions(data)[..., 0] - data["path_pusher"].values[:, :1])[
            data["path_flush"].values
        ]
        along = np.concatenate([along, sides.ravel()])
    margin = 0.1 * half
    start, end = along.min(initial=margin - half), along.max(initial=half - margin)
    return float(start) - margin, float(end) + margin


def last_center(data: xr.Dataset) -> list[Array]:
    """Last motion center; empty if it is far away or the slider never turns."""
    centers, positions = data["path_center"].values, data["path_position"].values
    turning = np.flatnonzero(np.isfinite(centers).all(axis=-1))
    if not turning.size:
        return []
    center = centers[turning[-1]]
    return [center] if np.hypot(*(center - positions[turning[-1]])) < span(data) else []


def velocity_arrow(data: xr.Dataset, row: int) -> Array:
    """Tail and tip of the pusher's velocity at a row, drawn beside the pusher, shape (2, 2).

    The tip is at the pusher if it moves toward the slider, otherwise the tail. The arrow of a fence is
    below its hatch, at the end that is farther from the slider; that of a finger is to the right of its
    path. A pusher at rest has an arrow of no length.
    """
    velocity = data["path_pusher_velocity"].values
    fastest = float(np.hypot(*velocity.T).max()) or 1.0
    along = PUSHER_LENGTH * span(data) * velocity[row] / fastest
    heading = pusher_heading(data, row)
    if "path_side" in data:
        x, y = along / (float(np.hypot(*along)) or 1.0)
        reach = min(finger_radius(data), FENCE_HALF * span(data))
        beside = (reach + ASIDE * span(data)) * np.array([y, -x])
        anchor = contact(data)[row] - reach * normal(data)[row] + beside
    else:
        left, right = fence_ends(data)
        leans_right = np.mean(data["path_position"].values[:, 0] - contact(data)[:, 0]) >= 0
        x = 0.8 * (left if leans_right else right)
        anchor = data["path_pusher"].values[row] + np.array([x, -1.4 * DEPTH * span(data)])
    tail = anchor - along if heading > 0 else anchor
    return np.array([tail, tail + along])


def _outer_end(data: xr.Dataset, row: int, length: float = 1.0) -> Array:
    """End of the pusher's velocity that is away from the pusher, for a multiple of its length."""
    tail, tip = velocity_arrow(data, row)
    near, far = (tip, tail) if pusher_heading(data, row) > 0 else (tail, tip)
    return np.asarray(near + length * (far - near))


def wall_segments(data: xr.Dataset, row: int) -> list[tuple[Array, Array]]:
    """The drawn segment of each wall, beside the slider at a row, and its unit normal."""
    if "wall_point" not in data:
        return []
    where, segments = data["path_position"].values[row], []
    for point, across in zip(data["wall_point"].values, data["wall_normal"].values, strict=True):
        ends = DrawnWall(point, across).segment(where, span(data))
        if ends is not None:
            segments.append((ends, across))
    return segments


def add_walls(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add the walls near the slider, hatched on the side away from it."""
    for ends, across in wall_segments(data, row):
        add_wall(picture, ends, across, span(data))


def add_instant(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add walls, pusher, slider and force at a row."""
    add_walls(picture, data, row)
    touch, size = contact(data)[row], span(data)
    if "path_side" in data:
        side, center = data["path_side"].values[row], finger_center(data)[row]
        add_finger(picture, side, touch, SLIDER, center)
    else:
        x, y = data["path_pusher"].values[row]
        (start, end), depth = fence_ends(data), DEPTH * size
        add_fence(picture, x + start, x + end, y=y, color=FENCE, width=1.0, depth=depth)
        picture.line([(x, y - depth), (x, y)], FENCE, width=2.0)
    tip = touch if "path_flush" in data else rod_end(data)[row]
    on_fence = side_on_fence(data, row)
    ink = Ink(SLIDER, 1.5)
    add_body(picture, body_in(data), pose(data, row), contact=tip, side=on_fence, ink=ink)
    arrow = force_arrows(data)[row]
    if np.any(arrow):
        picture.force(touch + _beside(data, arrow), arrow, r"$\mathbf{f}$", head=9.0, width=1.2)


def force_arrows(data: xr.Dataset) -> Array:
    """Drawn vector of the force on the slider at every row, shape (time, 2); all have the same length."""
    force = np.nan_to_num(data["path_force"].values)
    magnitude = np.hypot(*force.T)[:, None]
    return np.asarray(FORCE_LENGTH * span(data) * force / np.where(magnitude > 0, magnitude, 1.0))


def _beside(data: xr.Dataset, force: Array) -> Array:
    """Shift of the arrow of a force along the fence, which would otherwise cover the fence."""
    on_fence = "path_side" not in data and abs(np.arctan2(force[1], abs(force[0]))) < ALONG_FENCE
    return np.array([0.0, BESIDE * span(data) if on_fence else 0.0])


def add_velocity(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add the velocity of the pusher at a row, unless it is at rest, with its name at the outer end."""
    tail, tip = velocity_arrow(data, row)
    along = tip - tail
    if not np.any(along):
        return
    outer = _outer_end(data, row)
    ahead = (outer - (tail + tip) / 2) / (np.hypot(*along) / 2)
    picture.motion(tail, along, color=PUSHER, head=9.0, width=1.2)
    offset = 9.0 * float(ahead[0]), 8.0 * float(ahead[1])
    picture.label(outer, r"$\mathbf{v}_p$", color=PUSHER, offset=offset, held=True)


def add_first_pusher(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add the first position of the pusher as a dashed line, unless the pusher is still there."""
    pusher = data["path_pusher"].values
    away, size = pusher[row] - pusher[0], span(data)
    if np.hypot(*away) < MOVED * size:
        return
    if "path_side" in data:
        radius = finger_radius(data)
        if radius:
            rim = finger_center(data)[0] + radius * arc(0.0, 2 * np.pi)
            picture.line(rim, GUIDE, width=0.8, dash="--", order=LINES - 0.5)
        else:
            picture.dot(pusher[0], 6.0, None, edge=GUIDE, width=0.8)
        return
    start, end = fence_ends(data)
    ends = pusher[0] + np.array([(start, 0.0), (end, 0.0)])
    picture.line(ends, GUIDE, width=0.8, dash="--", order=LINES - 0.5)
    if abs(away[1]) > NAMED * size:
        moves_right = away[0] > 0
        offset = (13.0 if moves_right else -13.0, -5.5 if away[1] > 0 else 5.5)
        picture.label(
            ends[0 if moves_right else 1],
            "$t = 0$",
            color=GUIDE,
            size=NOTE,
            offset=offset,
            held=True,
        )


def add_paths(picture: Picture, data: xr.Dataset, frame: Array, last: int | None = None) -> None:
    """Add the paths up to a row: of the contact in the colors of its modes, and of the motion center."""
    row = len(data["time"]) - 1 if last is None else last
    add_center_path(picture, data, frame, row)
    add_contact_path(picture, data, row)


def add_contact_path(picture: Picture, data: xr.Dataset, last: int) -> None:
    """Add the path of the contact up to a row, in the colors of its modes."""
    touch, jumps = contact(data), contact_jumps(data)
    for run in runs(data):
        stop = min(run.stop, last) + 1
        cuts = [run.start, *jumps[(jumps > run.start) & (jumps < stop)], stop]
        for start, finish in pairwise(cuts):
            if finish - start > 1:
                points = touch[start:finish]
                picture.line(points, MODES[run.mode].ink, width=2.4, order=PATHS)


def add_center_path(picture: Picture, data: xr.Dataset, frame: Array, last: int) -> None:
    """Add the path of the motion center up to a row, with an arrowhead where it leaves or enters the frame.

    A jump, as at a change of mode, is not part of the path.
    """
    center, size = data["path_center"].values[: last + 1], span(data)
    middle, half = frame.mean(axis=0), np.ptp(frame, axis=0) / 2
    with np.errstate(invalid="ignore"):
        inside = np.all(np.abs(center - middle) < 0.99 * half, axis=-1)
        near = np.hypot(*np.diff(center, axis=0).T) < JUMP * size
    for part in _pieces(center, inside, near):
        picture.line(part, CENTER, width=0.9, dash="--", order=LINES + 0.5)
    for step in (1, -1):
        for here in np.flatnonzero(inside & ~np.roll(inside, -step)):
            there = here + step
            if 0 <= there < len(center) and near[min(here, there)]:
                _head(picture, center[here], center[there] - center[here])


def _pieces(center: Array, inside: Any, near: Any) -> Iterable[Array]:
    """Sections of a path that are inside the frame and contain no jump."""
    joined = np.concatenate([[False], near & inside[1:] & inside[:-1], [False]])
    starts, stops = (np.flatnonzero(np.diff(joined.astype(int)) == sign) for sign in (1, -1))
    return [center[start : stop + 1] for start, stop in zip(starts, stops, strict=True)]


def _head(picture: Picture, tip: Array, along: Array) -> None:
    """Add an open arrowhead at the end of a path."""
    stub = 1e-3 * along / np.hypot(*along)
    picture.add(Arrow(np.array([tip - stub, tip]), CENTER, False, 0.9, 7.0, order=PATHS))


def frame_picture(
    data: xr.Dataset, row: int, frame: Array, *, center: bool = True, impact: bool = False
) -> Picture:
    """Picture of a motion at a row, inside a frame of two corners.

    It shows slider, pusher, force and velocity of the pusher, the pusher's first position and the path of
    the contact up to the row, the motion center if it is inside the frame, and an impact.
    """
    picture = Picture()
    add_first_pusher(picture, data, row)
    add_contact_path(picture, data, row)
    add_instant(picture, data, row)
    add_velocity(picture, data, row)
    if center:
        _add_center(picture, data, row, frame)
    if impact:
        add_impact(picture, data, row)
    return picture


def _add_center(picture: Picture, data: xr.Dataset, row: int, frame: Array) -> None:
    """Add the motion center at a row, or the support point about which the slider pivots, with its name."""
    center = data["path_center"].values[row]
    if not np.all((frame[0] < center) & (center < frame[1])):  # also of a slider that does not turn
        return
    pivot = is_pivot(data, row)
    add_center_mark(picture, center, size=4.5, pivot=pivot)
    name = "pivot" if pivot else "motion\ncenter"
    picture.label(center, name, offset=(0.0, 14.0), color=CENTER, size=NOTE)


def add_impact(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add a burst beside the contact at an impact, joined to it by a line."""
    touch = contact(data)[row]
    burst = touch + 0.13 * span(data) * np.array([1.0, -0.4])
    picture.line([touch, burst], IMPACT, width=0.8, order=PATHS)
    picture.dot(burst, 10.0, IMPACT, shape="burst", edge="white", width=0.6)
    picture.label(burst, "impact", color=IMPACT, size=NOTE, offset=(20.0, 0.0), held=True)
