"""Marks of a motion over time: slider and pusher at several instants, and their past paths."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import add_body, add_fence, add_finger, body_in
from planar_pushing.drawing.canvas.colors import (
    CENTER,
    FENCE,
    FORCE,
    GUIDE,
    IMPACT,
    MODES,
    SLIDER,
    tint,
)
from planar_pushing.drawing.canvas.marks import ARROWS, LINES, NOTE, Arrow, Picture, corners
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.supports import Ink, Pose
from planar_pushing.drawing.timeline import (
    contact,
    contact_jumps,
    corner_positions,
    finger_center,
    finger_radius,
    normal,
    pivots,
    rod_end,
    rows,
    runs,
    side_on_fence,
)
from planar_pushing.mechanics.plane import Array

#: Strength of the color of the first snapshot.
PALEST = 0.3
#: A longer step of the motion center between two rows, in units of the slider's span, is a jump.
JUMP = 0.5
#: Drawn length of the force, half the width of the fence, depth of its hatch, in units of the span.
FORCE_LENGTH, FENCE_HALF, DEPTH = 0.42, 0.45, 0.036
#: Instants with fences closer than this, in units of the picture's height, share a time label.
CLOSE = 0.06
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
    """Corners of the box around slider and pusher over the whole motion, and the last center if near."""
    body, half, ends = body_in(data), FENCE_HALF * span(data), fence_ends(data)
    points = [contact(data), data["path_position"].values, *last_center(data)]
    points += [body.box(pose(data, row)) for row in range(data.sizes["time"])]
    if "path_side" in data:
        # Of a finger much larger than the slider, only the region near the side is included.
        reach = min(finger_radius(data), half)
        points.append(data["path_side"].values)
        points += [contact(data) - reach * normal(data) + end * reach for end in (-1.0, 1.0)]
    else:
        low = zip(ends, (-0.1 * half, 0.0), strict=True)
        points += [data["path_pusher"].values + np.array(end) for end in low]
    return corners(points)


def fence_ends(data: xr.Dataset) -> tuple[float, float]:
    """Ends of the drawn fence, from the pusher's position; it is longer than all sides that lie on it."""
    half = FENCE_HALF * span(data)
    if "path_flush" not in data:
        return -half, half
    along = corner_positions(data)[..., 0] - data["path_pusher"].values[:, :1]
    sides = along[data["path_flush"].values]
    start, end = sides.min(initial=0.9 * -half), sides.max(initial=0.9 * half)
    return float(start) - 0.1 * half, float(end) + 0.1 * half


def last_center(data: xr.Dataset) -> list[Array]:
    """Last motion center; empty if it is far away or the slider never turns."""
    centers, places = data["path_center"].values, data["path_position"].values
    turning = np.flatnonzero(np.isfinite(centers).all(axis=-1))
    if not turning.size:
        return []
    found = centers[turning[-1]]
    return [found] if np.hypot(*(found - places[turning[-1]])) < span(data) else []


def add_instant(picture: Picture, data: xr.Dataset, row: int, strength: float = 1.0) -> None:
    """Add pusher, slider and force at a row."""
    touch, size = contact(data)[row], span(data)
    ink, whole = Ink(tint(SLIDER, strength), 1.5), strength == 1
    if "path_side" in data:
        side, center = data["path_side"].values[row], finger_center(data)[row]
        add_finger(picture, side, touch, ink.color, center)
    else:
        x, y = data["path_pusher"].values[row]
        (start, end), depth = fence_ends(data), DEPTH * size
        color = tint(FENCE, strength)
        add_fence(picture, x + start, x + end, y=y, color=color, width=1.0, depth=whole * depth)
        picture.line([(x, y - depth), (x, y)], color, width=2.0)
    tip = touch if "path_flush" in data else rod_end(data)[row]
    on_fence = side_on_fence(data, row)
    add_body(picture, body_in(data), pose(data, row), contact=tip, side=on_fence, ink=ink)
    force = data["path_force"].values[row]
    if np.any(force):
        along = FORCE_LENGTH * size * force / np.hypot(*force)
        picture.force(touch, along, color=tint(FORCE, strength), head=9.0, width=1.0)


def add_paths(picture: Picture, data: xr.Dataset, frame: Array, last: int | None = None) -> None:
    """Add the paths up to a row: of the contact in the colors of its modes, and of the motion center."""
    touch, end = contact(data), len(data["time"]) if last is None else last + 1
    jumps = contact_jumps(data)
    _path_of_center(picture, data["path_center"].values[:end], span(data), frame)
    for run in runs(data):
        stop = min(run.stop + 1, end)
        cuts = [run.start, *jumps[(jumps > run.start) & (jumps < stop)], stop]
        for start, finish in pairwise(cuts):
            if finish - start > 1:
                part = touch[start:finish]
                picture.line(part, MODES[run.mode].ink, width=2.4, order=PATHS)


def _path_of_center(picture: Picture, center: Array, size: float, frame: Array) -> None:
    """Add the path of the motion center inside the frame, with an arrowhead where it leaves or enters.

    A jump, as at a change of mode, is not part of the path.
    """
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


def snapshots(
    data: xr.Dataset, frame: Array, count: int, struck: Sequence[int] = (), *, times: bool = True
) -> Picture:
    """Add slider and pusher at several instants, earlier ones paler, with their times and the paths."""
    picture = Picture()
    chosen = sorted({*rows(data, count), *struck})
    for strength, row in zip(np.linspace(PALEST, 1.0, len(chosen)), chosen, strict=True):
        add_instant(picture, data, row, float(strength))
    if times:
        _times(picture, data, frame, [*struck, chosen[-1], *chosen[:-1]])
    add_paths(picture, data, frame)
    for each in last_center(data):
        add_center_mark(picture, each, size=4.5)
    for run in pivots(data):
        place = data["path_center"].values[run.start]
        add_center_mark(picture, place, size=4.5, pivot=True)
        picture.label(place, "pivot", offset=(0.0, -12.0), color=CENTER, size=NOTE)
    for row in struck:
        add_impact(picture, data, row)
    return picture


def _times(picture: Picture, data: xr.Dataset, frame: Array, chosen: Sequence[int]) -> None:
    """Label instants with their times at the fence ends or the slider's center; close ones share one."""
    finger, named = "path_side" in data, np.empty((0, 2))
    end = np.array([0.0 if finger else fence_ends(data)[1], 0.0])
    for row in chosen:
        place = data["path_position" if finger else "path_pusher"].values[row] + end
        if np.all(np.hypot(*(named - place).T) > CLOSE * np.ptp(frame[:, 1])):
            named = np.vstack([named, place])
            text, offset = (
                f"$t = {data['time'].values[row]:.3g}$",
                (0.0, 8.0) if finger else (17.0, 0.0),
            )
            picture.label(place, text, color=GUIDE, size=NOTE, offset=offset, held=True)


def add_impact(picture: Picture, data: xr.Dataset, row: int) -> None:
    """Add a burst beside the contact at an impact, joined to it by a line."""
    place = contact(data)[row]
    away = 0.16 * span(data) * np.array([1.0, -0.6])
    picture.line([place, place + away], IMPACT, width=0.8, order=PATHS)
    picture.dot(place + away, 10.0, IMPACT, shape="burst", edge="white", width=0.6)
    picture.label(place + away, "impact", color=IMPACT, size=NOTE, offset=(22.0, 0.0))
