"""Placement of labels: each moves around its point to where it covers least."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from planar_pushing.drawing.canvas.marks import Area, Arrow, Dot, Label, Line, Picture, Sheet
from planar_pushing.mechanics.plane import Array

#: Directions tried around the preferred position, and distances in units of the preferred distance.
TURNS = np.deg2rad([0, 25, -25, 50, -50, 80, -80, 115, -115, 150, -150, 180])
STRETCHES = (1.0, 1.45, 2.0)
#: Free margin around a label, and distance between samples of a line, in points.
GAP, STEP = 1.5, 1.5


def settle(picture: Picture, sheet: Sheet) -> list[Label]:
    """Labels of a picture with the offsets that they take on a sheet.

    Held labels and labels without an offset stay; the others make room in turn.
    """
    labels = [mark for mark in picture.marks if isinstance(mark, Label)]
    fixed = [each for each in labels if each.held or not any(each.offset)]
    if len(fixed) == len(labels):
        return labels
    lines = np.concatenate([np.empty((0, 2)), *_samples(picture, sheet)])
    frame = np.array([(0.0, 0.0), sheet.size / sheet.point])
    taken = [_box(each, _at(each, sheet) + _down(each.offset)) for each in fixed]
    found = []
    for each in labels:
        if not (each.held or not any(each.offset)):
            place, box = _best(each, _at(each, sheet), lines, np.reshape(taken, (-1, 2, 2)), frame)
            taken.append(box)
            each = each._replace(offset=(float(place[0]), float(-place[1])))
        found.append(each)
    return found


def _at(label: Label, sheet: Sheet) -> Array:
    """Position of a label's point, in points from the upper left corner of the sheet."""
    return np.asarray(sheet.to(label.place) / sheet.point)


def _down(offset: tuple[float, float]) -> Array:
    return np.array([offset[0], -offset[1]])


def _box(label: Label, middle: Array) -> Array:
    """Corners of the box of a label about its center, shape (..., 2, 2)."""
    wide, high = label.extent
    shift = {"left": wide / 2, "right": -wide / 2}.get(label.align, 0.0)
    half = np.array([wide / 2 + GAP, high / 2 + GAP])
    center = np.asarray(middle) + np.array([shift, 0.0])
    return np.stack([center - half, center + half], axis=-2)


def _best(label: Label, at: Array, lines: Array, taken: Array, frame: Array) -> tuple[Array, Array]:
    """Offset of a label at the lowest cost, y downward, and its box there."""
    wide, high = label.extent
    places, detours = _places(_down(label.offset), max(0.0, wide - high) / 2)
    boxes = _box(label, at + places)
    costs = _costs(boxes, lines, taken, frame) + detours
    best = int(np.argmax(costs <= costs.min() + 1e-9))
    return places[best], boxes[best]


def _places(wanted: Array, beside: float) -> tuple[Array, Array]:
    """Offsets to try, shape (n, 2), and their distances from the preferred offset, shape (n,).

    A wide label beside its point can keep its end, not its center, at the preferred distance.
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
    """Cost of the marks that boxes of shape (n, corner, xy) would cover, shape (n,)."""
    low, high = boxes[:, None, 0], boxes[:, None, 1]
    inside = ((lines > low) & (lines < high)).all(axis=-1)
    covered = ((low <= taken[:, 1]) & (taken[:, 0] <= high)).all(axis=-1)
    outside = ((boxes < frame[0]) | (boxes > frame[1])).any(axis=(1, 2))
    return np.asarray(0.5 * inside.sum(axis=1) + 20.0 * covered.sum(axis=1) + 50.0 * outside)


def _samples(picture: Picture, sheet: Sheet) -> Iterator[Array]:
    """Points on the sheet along all drawn lines, and on dots."""
    for mark in picture.marks:
        if isinstance(mark, (Line, Arrow)):
            yield _along(sheet.to(mark.points) / sheet.point)
        elif isinstance(mark, Dot):
            around = mark.size / 2 * np.array([(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)])
            yield sheet.to(mark.place) / sheet.point + around
        elif isinstance(mark, Area) and mark.hatch:
            yield from (_along(sheet.to(ring) / sheet.point) for ring in mark.rings)


def _along(points: Array) -> Array:
    steps = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    at = np.linspace(0.0, along[-1], min(1000, 2 + int(along[-1] / STEP)))
    return np.stack([np.interp(at, along, points[:, i]) for i in (0, 1)], axis=1)
