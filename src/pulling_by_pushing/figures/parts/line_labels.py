"""Labels at the lines of a panel: each where it covers least, with a leader to its line."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from matplotlib.patheffects import withStroke
from matplotlib.textpath import TextPath
from scipy.spatial import cKDTree

from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.mechanics.plane import Array, direction

#: Distance between samples of lines and leaders, and between the points of a line that are tried, points.
STEP, STRIDE = 1.5, 6.0
#: Lengths of leaders that are tried, points; none is drawn for the first.
LEADERS = (1.5, 7.0, 14.0, 22.0, 32.0, 45.0)
#: Directions of leaders that are tried.
TURNS = direction(np.deg2rad(np.arange(0, 360, 22.5)))
#: Free margin around a label, distance within which a leader touches a line, and distance at which another
#: line is clearly apart, points.
MARGIN, TOUCH, CLEAR = 2.5, 1.5, 6.0
#: Costs: a sample of a line under a label; a sample of a leader on another line; a point of a leader's
#: length; another line at the start of a leader, less with its distance; another line close to a label
#: without a leader.
COVER, CROSSING, LENGTH, SHARED, CLOSE = 2.0, 3.0, 0.15, 20.0, 20.0


class _Candidates(NamedTuple):
    """Leaders of one label, and centers of its text: shape (candidate, xy), points."""

    start: Array
    end: Array
    center: Array


def label_lines(ax: Any, lines: Mapping[str, Any]) -> None:
    """Write the name of each line of a panel beside it, in its color; the other lines are obstacles.

    The position of the axes must be final; their limits are held from now on.
    """
    ax.set(xlim=ax.get_xlim(), ylim=ax.get_ylim())
    low, high = panel = ax.bbox.get_points() * 72 / ax.figure.dpi
    paths = {line: _samples(line, low, high) for line in ax.lines}
    boxes: list[Array] = []
    leaders: list[Array] = []
    for name, line in lines.items():
        others = np.vstack([path for other, path in paths.items() if other is not line])
        width = TextPath((0.0, 0.0), name, size=NOTE).get_extents().width
        half = np.array([width, NOTE]) / 2 + MARGIN
        tries = _candidates(paths[line], half)
        forbidden = _is_forbidden(tries, half, panel, boxes, leaders)
        if not forbidden.all():
            tries = _Candidates(*(points[~forbidden] for points in tries))
        costs = _line_costs(tries, half, paths[line], others)
        start, end, center = (points[int(np.argmin(costs))] for points in tries)
        boxes.append(np.array([center - half, center + half]))
        leaders.append(_points_between(start, end))
        _write(ax, name, line, start, end, center)


def named_lines(ax: Any) -> dict[str, Any]:
    """Lines of a panel by the names that they have."""
    lines = {str(line.get_label()): line for line in ax.lines}
    return {name: line for name, line in lines.items() if not name.startswith("_")}


def _samples(line: Any, low: Array, high: Array) -> Array:
    """Points along a line, or its markers, within the panel; shape (point, xy), points."""
    path = line.get_transform().transform(line.get_xydata()) * 72 / line.figure.dpi
    if line.get_linestyle() not in {"None", "none", ""}:
        pairs = [pair for pair in pairwise(path) if np.isfinite(pair).all()]
        path = np.vstack([np.empty((0, 2)), *(_points_between(*pair) for pair in pairs)])
    inside: Array = path[((path >= low) & (path <= high)).all(axis=1)]
    return inside


def _points_between(start: Array, end: Array) -> Array:
    count = 1 + int(np.hypot(*(end - start)) / STEP)
    return np.asarray(start + np.linspace(0, 1, count, endpoint=False)[:, None] * (end - start))


def _candidates(path: Array, half: Array) -> _Candidates:
    """Leaders from points of a path in all directions, with a text of a half size at their ends."""
    along = np.cumsum(np.hypot(*np.diff(path, axis=0, prepend=path[:1]).T)) // STRIDE
    anchors = path[np.flatnonzero(np.diff(along, prepend=-1))]
    start, turn, length = (
        values.reshape(-1, values.shape[-1])
        for values in np.broadcast_arrays(
            anchors[:, None, None], TURNS[:, None], np.array(LEADERS)[:, None]
        )
    )
    end = start + turn * length
    reach = np.min(half / np.maximum(np.abs(turn), 1e-9), axis=1, keepdims=True)
    return _Candidates(start, end, end + turn * reach)


def _line_costs(tries: _Candidates, half: Array, path: Array, others: Array) -> Array:
    """Costs of candidates by the lines that they cover, cross or come close to."""
    start, end, center = tries
    length = np.hypot(*(end - start).T)
    tree = cKDTree(others)
    close = (_count_covered(center, half + CLEAR, others) > 0) & (length <= LEADERS[0])
    touches = (tree.query(_on_leaders(tries), distance_upper_bound=TOUCH)[0] < TOUCH).sum(axis=1)
    return np.asarray(
        LENGTH * length
        + COVER * _count_covered(center, half, np.vstack([path, others]))
        + SHARED * np.clip(1 - tree.query(start, distance_upper_bound=CLEAR)[0] / CLEAR, 0, 1)
        + CLOSE * close
        + CROSSING * touches
    )


def _is_forbidden(
    tries: _Candidates, half: Array, panel: Array, boxes: list[Array], leaders: list[Array]
) -> npt.NDArray[np.bool_]:
    """Whether the label or the leader of a candidate is on another one, or the label leaves the panel."""
    center = tries.center
    forbidden = ((center - half < panel[0]) | (center + half > panel[1])).any(axis=1)
    on_leaders = _on_leaders(tries)
    for low, high in boxes:
        forbidden |= ((center + half > low) & (center - half < high)).all(axis=1)
        forbidden |= ((on_leaders > low) & (on_leaders < high)).all(axis=2).any(axis=1)
    for leader in leaders:
        forbidden |= _count_covered(center, half, leader) > 0
    return np.asarray(forbidden, dtype=bool)


def _on_leaders(tries: _Candidates) -> Array:
    """Points on leaders beyond their starts, shape (candidate, point, xy)."""
    share = np.linspace(0.0, 1.0, 1 + int(max(LEADERS) / STEP))[1:, None]
    start, end, _ = tries
    return np.asarray(start[:, None] + share * (end - start)[:, None])


def _count_covered(center: Array, half: Array, points: Array) -> Array:
    """Number of points within boxes of a half size about centers."""
    tree = cKDTree(points / half)
    return np.asarray(tree.query_ball_point(center / half, 1.0, p=np.inf, return_length=True))


def _write(ax: Any, name: str, line: Any, *points: Array) -> None:
    to_data = ax.transData.inverted()
    start, end, center = (to_data.transform(point * ax.figure.dpi / 72) for point in points)
    color = line.get_color()
    if np.hypot(*(points[1] - points[0])) > LEADERS[0] + 0.1:
        ax.plot(*zip(start, end, strict=True), color=color, linewidth=0.5, zorder=4, label="_leader",
                scalex=False, scaley=False)  # fmt: skip
    ax.text(*center, name, color=color, fontsize=NOTE, ha="center", va="center", zorder=6,
            path_effects=[withStroke(linewidth=2.0, foreground="white")])  # fmt: skip
