"""Labels: text at an offset from a point, and moving labels off what they would cover."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, Patch
from matplotlib.path import Path
from matplotlib.text import Annotation

from planar_pushing.figures.style import DARK, SYMBOL_SIZE
from planar_pushing.mechanics.plane import Array

#: Directions around the wanted place, and distances from the point in units of the wanted one.
TURNS = np.deg2rad([0, 25, -25, 50, -50, 80, -80, 115, -115, 150, -150, 180])
STRETCHES = (1.0, 1.45, 2.0)
GAP = 2.0  # points that a label keeps free around itself


def label(
    ax: Axes,
    xy: npt.ArrayLike,
    text: str,
    *,
    offset: tuple[float, float] = (0.0, 0.0),
    color: str = DARK,
    size: float = SYMBOL_SIZE,
    **text_options: Any,
) -> Annotation:
    """Write `text`, centered `offset` points from `xy` (data coordinates)."""
    x, y = np.asarray(xy, dtype=float)
    options = {"ha": "center", "va": "center", "zorder": 10, "linespacing": 0.95, **text_options}
    return ax.annotate(
        text,
        (float(x), float(y)),
        xytext=offset,
        textcoords="offset points",
        color=color,
        fontsize=size,
        annotation_clip=False,
        **options,
    )


def declutter(ax: Axes) -> None:
    """Move each label to the place around its point where it covers least, the nearest first.

    Labels without an offset stay. Call it last, when the limits of the axes are set.
    """
    lines = _line_points(ax)
    labels = [each for each in ax.texts if isinstance(each, Annotation) and each.get_text()]
    fixed = [each for each in labels if np.allclose(each.xyann, 0)]
    taken = [_box(each) for each in fixed]
    frame = ax.get_window_extent().get_points()
    for each in labels:
        if each not in fixed:
            taken.append(_settle(each, lines, np.reshape(taken, (-1, 2, 2)), frame))


def _settle(text: Annotation, lines: Array, taken: Array, frame: Array) -> Array:
    """Move a label to its cheapest place and return the box that it takes there."""
    wanted = np.asarray(text.xyann, dtype=float)
    box, pixels = _box(text), pixels_per_point(text)
    width, height = box[1] - box[0]
    places, detours = _places(wanted, max(0.0, width - height) / (2 * pixels))
    boxes = box + pixels * (places - wanted)[:, None]
    costs = _costs(boxes, lines, taken, frame) + detours
    best = int(np.argmax(costs <= costs.min() + 1e-9))
    text.xyann = (float(places[best, 0]), float(places[best, 1]))
    return np.asarray(boxes[best])


def _places(wanted: Array, beside: float) -> tuple[Array, Array]:
    """Offsets to try, shape (n, 2), and how far from the wanted one each is, shape (n,).

    A wide label beside its point may keep its end, not its middle, at the wanted distance.
    """
    tries = itertools.product(STRETCHES, TURNS, (0.0, beside))
    stretch, turn, shift = np.array(list(tries)).T
    cos, sin = np.cos(turn), np.sin(turn)
    places = stretch * np.array(
        [cos * wanted[0] - sin * wanted[1], sin * wanted[0] + cos * wanted[1]]
    )
    places[0] += shift * places[0] / np.hypot(*places)
    return places.T, 0.4 * np.abs(turn) + 1.5 * (stretch - 1) + 0.3 * (shift > 0)


def _costs(boxes: Array, lines: Array, taken: Array, frame: Array) -> Array:
    """What boxes of shape (n, corner, xy) would cover, shape (n,)."""
    low, high = boxes[:, None, 0], boxes[:, None, 1]
    inside = ((lines > low) & (lines < high)).all(axis=-1)
    covered = ((low <= taken[:, 1]) & (taken[:, 0] <= high)).all(axis=-1)
    outside = ((boxes < frame[0]) | (boxes > frame[1])).any(axis=(1, 2))
    return np.asarray(0.5 * inside.sum(axis=1) + 20.0 * covered.sum(axis=1) + 50.0 * outside)


def _box(text: Annotation) -> Array:
    """Corners of the place that a label takes, display coordinates."""
    return text.get_window_extent().padded(GAP * pixels_per_point(text)).get_points()


def pixels_per_point(text: Annotation) -> float:
    """Scale between a text's offset and display coordinates."""
    figure = text.get_figure(root=True)
    return float(figure.dpi) / 72 if figure else 1.0


def _line_points(ax: Axes) -> Array:
    """Points along all that is drawn as a line, in display coordinates, about two pixels apart."""
    shapes: list[Line2D | Patch] = [*ax.lines]
    shapes += [
        each for each in ax.patches if not each.get_fill() or isinstance(each, FancyArrowPatch)
    ]
    paths = [each.get_transform().transform_path(each.get_path()) for each in shapes]
    for strokes in ax.collections:
        if isinstance(strokes, LineCollection):
            onto = strokes.get_transform()
            paths += [onto.transform_path(path) for path in strokes.get_paths()]
    points = [_sampled(path) for path in paths]
    return np.concatenate([np.empty((0, 2)), *points])


def _sampled(path: Path) -> Array:
    points = []
    for polygon in map(np.asarray, path.to_polygons(closed_only=False)):
        steps = np.linalg.norm(np.diff(polygon, axis=0), axis=1)
        along = np.concatenate([[0.0], np.cumsum(steps)])
        at = np.linspace(0, along[-1], min(2000, 2 + int(along[-1] / 2)))
        points.append(np.stack([np.interp(at, along, polygon[:, i]) for i in (0, 1)], axis=1))
    return np.concatenate([np.empty((0, 2)), *points])
