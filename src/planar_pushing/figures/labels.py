"""Labels: text at an offset from a point, and moving labels off what they would cover."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch, Patch
from matplotlib.path import Path
from matplotlib.text import Annotation
from matplotlib.transforms import Bbox

from planar_pushing.figures.style import DARK, SYMBOL_SIZE

Array = npt.NDArray[np.float64]

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
    """Write `text`, centred `offset` points from `xy` (data coordinates)."""
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
    frame = ax.get_window_extent()
    for each in labels:
        if each not in fixed:
            taken.append(_settle(each, lines, taken, frame))


def _settle(text: Annotation, lines: Array, taken: list[Bbox], frame: Bbox) -> Bbox:
    """Move a label to its cheapest place and return the box that it takes there."""
    wanted = np.asarray(text.xyann, dtype=float)
    box, pixels = _box(text), pixels_per_point(text)
    beside = max(0.0, box.width - box.height) / (2 * pixels)
    best, best_box, best_cost = wanted, box, np.inf
    for place, detour in _places(wanted, beside):
        moved = box.translated(*(pixels * (place - wanted)))
        cost = _cost(moved, lines, taken, frame) + detour
        if cost < best_cost - 1e-9:
            best, best_box, best_cost = place, moved, cost
    text.xyann = (float(best[0]), float(best[1]))
    return best_box


def _places(wanted: Array, beside: float) -> Iterator[tuple[Array, float]]:
    """Offsets to try, and how far from the wanted one they are.

    A wide label beside its point may keep its end, not its middle, at the wanted distance.
    """
    for stretch, turn, shift in itertools.product(STRETCHES, TURNS, (0.0, beside)):
        cos, sin = np.cos(turn), np.sin(turn)
        place = stretch * np.array([[cos, -sin], [sin, cos]]) @ wanted
        place[0] += shift * place[0] / np.hypot(*place)
        yield place, 0.4 * abs(turn) + 1.5 * (stretch - 1) + 0.3 * (shift > 0)


def _cost(box: Bbox, lines: Array, taken: list[Bbox], frame: Bbox) -> float:
    inside = np.all((lines > box.min) & (lines < box.max), axis=1)
    outside = not (frame.containsx(box.x0) and frame.containsx(box.x1))
    outside |= not (frame.containsy(box.y0) and frame.containsy(box.y1))
    covered = sum(Bbox.intersection(box, other) is not None for other in taken)
    return 0.5 * float(np.count_nonzero(inside)) + 20.0 * covered + 50.0 * outside


def _box(text: Annotation) -> Bbox:
    return text.get_window_extent().padded(GAP * pixels_per_point(text))


def pixels_per_point(text: Annotation) -> float:
    """Scale between a text's offset and display coordinates."""
    figure = text.get_figure(root=True)
    return float(figure.dpi) / 72 if figure else 1.0


def _line_points(ax: Axes) -> Array:
    """Points along all that is drawn as a line, in display coordinates, about two pixels apart."""
    shapes: list[Line2D | Patch] = [*ax.lines]
    shapes += [each for each in ax.patches if not each.get_fill() or _is_arrow(each)]
    paths = [each.get_transform().transform_path(each.get_path()) for each in shapes]
    for strokes in ax.collections:
        if isinstance(strokes, LineCollection):
            onto = strokes.get_transform()
            paths += [onto.transform_path(path) for path in strokes.get_paths()]
    points = [_sampled(path) for path in paths]
    return np.concatenate([np.empty((0, 2)), *points])


def _is_arrow(patch: object) -> bool:
    return isinstance(patch, FancyArrowPatch)


def _sampled(path: Path) -> Array:
    points = []
    for polygon in map(np.asarray, path.to_polygons(closed_only=False)):
        steps = np.linalg.norm(np.diff(polygon, axis=0), axis=1)
        along = np.concatenate([[0.0], np.cumsum(steps)])
        at = np.linspace(0, along[-1], min(2000, 2 + int(along[-1] / 2)))
        points.append(np.stack([np.interp(at, along, polygon[:, i]) for i in (0, 1)], axis=1))
    return np.concatenate([np.empty((0, 2)), *points])
