"""Paths of a finger: in the world as given, and after the first touch."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.arguments import numbers
from planar_pushing.terms.errors import InvalidValue

#: A touch this close to the end of a leg counts as at its end.
ROUNDING = 1e-9


class Path(NamedTuple):
    """Finger centers, shape S + (samples, 2), and their times; None if only both ends are known."""

    points: Array
    times: Array | None


def require_path(start: Any, end: Any, path: Any, times: Any, count: int) -> Path:
    """Return the paths of all pushes, shape (count, samples, 2), or raise `InvalidValue`."""
    ends, samples = (start is not None, end is not None), (path is not None, times is not None)
    if ends != (True, True) or any(samples):
        if any(ends) or samples != (True, True):
            raise InvalidValue(
                "finger_path", "another choice",
                "finger_start and finger_end, or finger_path and path_time",
                "give one of these pairs",
            )  # fmt: skip
        return _sampled_path(path, times, count)
    both = [numbers(*pair) for pair in (("finger_start", start), ("finger_end", end))]
    for name, points in zip(("finger_start", "finger_end"), both, strict=True):
        if points.shape != (count, 2):
            raise InvalidValue(
                name, f"shape {points.shape}", f"shape ({count}, 2)", "give a row for each push"
            )
        _require_finite(name, points[:, None])
    return Path(np.stack(both, axis=1), None)


def _sampled_path(path: Any, times: Any, count: int) -> Path:
    points, moments = numbers("finger_path", path), numbers("path_time", times)
    if points.ndim != 3 or points.shape[::2] != (count, 2) or points.shape[1] < 2:
        raise InvalidValue(
            "finger_path",
            f"shape {points.shape}",
            f"shape ({count}, samples, 2)",
            "give a path for each push",
        )
    if moments.shape != points.shape[:2]:
        raise InvalidValue(
            "path_time",
            f"shape {moments.shape}",
            f"shape {points.shape[:2]}",
            "give a time for each sample",
        )
    _require_finite("finger_path", points[:, :2])
    known = np.isfinite(points).all(axis=2)
    if (np.diff(known.astype(int), axis=1) > 0).any() or (known != np.isfinite(moments)).any():
        raise InvalidValue(
            "finger_path",
            "a sample that is missing",
            "NaN only after the end of a path",
            "leave the sample out",
        )
    return Path(points, moments)


def _require_finite(name: str, points: Array) -> None:
    bad = np.flatnonzero(~np.isfinite(points).all(axis=(1, 2)))
    if len(bad):
        raise InvalidValue(
            name, f"{points[bad[0]].tolist()} of push {bad[0]}", "finite numbers",
            "leave out what was not measured",
        )  # fmt: skip


def after_touch(path: Path, row: int, leg: int, fraction: float) -> Path:
    """Displacements and times of one finger since the first touch, given as a fraction of a leg."""
    points = path.points[row]
    points = points[np.isfinite(points).all(axis=1)]
    touch = points[leg] + fraction * (points[leg + 1] - points[leg])
    rest = slice(leg + 2 if fraction > 1.0 - ROUNDING and leg + 2 < len(points) else leg + 1, None)
    moved = np.concatenate([np.zeros((1, 2)), points[rest] - touch])
    if path.times is None:
        return Path(moved, None)
    times = path.times[row]
    moment = times[leg] + fraction * (times[leg + 1] - times[leg])
    later = times[: len(points)][rest]
    return Path(moved, np.concatenate([[0.0], later - moment]))
