"""Warnings about pushes over time that are probably not meant as given."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import SceneWarning, warn_user
from planar_pushing.terms.numbers import Array, is_lazy
from planar_pushing.terms.options import Shape


def warn_of_doubts(problem: Problem) -> None:
    """Warn if a push over time is probably not meant as given.

    Warns
    -----
    SceneWarning
        If a fence pushes at an inner point of a side, all of which lies on it; if a finger pushes an object
        that `scene_at` made without an outline; or if the finger's radius is larger than the object.
    """
    scene = problem.scene
    is_finger = problem.shape == Shape.FINGER
    for message in _of_finger(scene, problem.pusher.radius) if is_finger else _of_fence(scene):
        warn_user(SceneWarning(message))


def _of_fence(scene: Scene) -> Iterator[str]:
    """A contact of `scene_at` at an inner point of a side."""
    slider = scene.slider
    if scene.placement is None or slider.outline is None or slider.flush:
        return
    start, end = slider.side
    if -np.inf < start < 0.0 < end < np.inf:
        yield (
            "pusher: a fence at an inner point of a side, while the whole side lies on it; push the point "
            'with Pusher(shape="finger"), or make the scene with scene_at(side=...)'
        )


def _of_finger(scene: Scene, radius: Number) -> Iterator[str]:
    """A finger whose contact moves along a wall of unknown shape, or one of an implausible size."""
    slider = scene.slider
    unknown = slider.outline is None and all(map(_is_infinite, slider.side))
    if scene.placement is not None and unknown:
        yield (
            "outline: none given, so the finger moves along a straight wall without ends; give scene_at "
            "the outline of the object, or Scene a Slider with the ends of its side"
        )
    extent = 2.0 * slider.radius if slider.outline is None else _diameter(np.array(slider.outline))
    if is_lazy(radius) or is_lazy(extent):
        return
    larger = np.ravel(radius > extent)
    if larger.any():
        widest = np.max(np.asarray(radius))
        yield (
            f"radius: {widest:.6g} of the finger, more than the size {np.min(extent):.6g} of the object; "
            "give both in one unit of length"
        )


def _diameter(corners: Array) -> float:
    """Largest distance between two corners, which does not depend on the frame."""
    x, y = corners.T
    return float(np.hypot(x[:, None] - x, y[:, None] - y).max())


def _is_infinite(end: Any) -> bool:
    """Whether a side has no end here, in all scenes."""
    return bool(np.all(np.isinf(np.asarray(end))))
