"""Placement of labels: each moves around its point to where it covers least."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np

from planar_pushing.drawing.canvas.marks import (
    Area,
    Arrow,
    Dot,
    Hatch,
    Label,
    Line,
    Picture,
    Sheet,
)
from planar_pushing.mechanics.plane import Array

#: Directions tried around the preferred position, and distances in units of the preferred distance.
TURNS = np.deg2rad([0, 25, -25, 50, -50, 80, -80, 115, -115, 150, -150, 180])
STRETCHES = (1.0, 1.45, 2.0)
#: The same with reserved positions, which are larger than other marks.
FARTHER = (*STRETCHES, 3.0)
#: Free margin around a label, and distance between samples of a line, in points.
GAP, STEP = 1.5, 1.5


def settle(picture: Picture, sheet: Sheet) -> list[Label]:
    """Labels of a picture with the offsets that they take on a sheet.

    Held labels and labels without an offset stay; the others make room in turn.
    """
    labels = [mark for mark in picture.marks if isinstance(mark, Label)]
    fixed = [label for label in labels if label.held or not any(label.offset)]
    if len(fixed) == len(labels):
        return labels
    lines = np.concatenate([np.empty((0, 2)), *_samples(picture, sheet)])
    frame = np.array([(0.0, 0.0), sheet.size / sheet.point])
    occupied = [_box(label, _position(label, sheet) + _down(label.offset)) for label in fixed]
    reserved = _reserved_boxes(picture, sheet)
    occupied += reserved
    stretches = FARTHER if reserved else STRETCHES
    settled = []
    for label in labels:
        if not (label.held or not any(label.offset)):
            boxes = np.reshape(occupied, (-1, 2, 2))
            point = _position(label, sheet)
            offset, box = _best(label, point, lines, boxes, frame, stretches)
            occupied.append(box)
            label = label._replace(offset=(float(offset[0]), float(-offset[1])))
        settled.append(label)
    return settled


def _reserved_boxes(picture: Picture, sheet: Sheet) -> list[Array]:
    """Boxes around the positions that labels must leave free, in points."""
    dots = [mark for mark in picture.marks if isinstance(mark, Dot) and mark.edge == "none"]
    half = [np.full(2, dot.size / 2) for dot in dots]
    centers = [sheet.to_sheet(dot.position) / sheet.point for dot in dots]
    return [
        np.array([middle - away, middle + away]) for middle, away in zip(centers, half, strict=True)
    ]


def _position(label: Label, sheet: Sheet) -> Array:
    """Position of a label's point, in points from the upper left corner of the sheet."""
    return np.asarray(sheet.to_sheet(label.position) / sheet.point)


def _down(offset: tuple[float, float]) -> Array:
    return np.array([offset[0], -offset[1]])


def _box(label: Label, middle: Array) -> Array:
    """Corners of the box of a label about its center, shape (..., 2, 2)."""
    wide, high = label.extent
    shift = {"left": wide / 2, "right": -wide / 2}.get(label.align, 0.0)
    half = np.array([wide / 2 + GAP, high / 2 + GAP])
    center = np.asarray(middle) + np.array([shift, 0.0])
    return np.stack([center - half, center + half], axis=-2)


def _best(
    label: Label,
    point: Array,
    lines: Array,
    occupied: Array,
    frame: Array,
    stretches: Sequence[float],
) -> tuple[Array, Array]:
    """Offset of a label at the lowest cost, y downward, and its box there."""
    wide, high = label.extent
    offsets, detours = _offsets(_down(label.offset), max(0.0, wide - high) / 2, stretches)
    boxes = _box(label, point + offsets)
    costs = _costs(boxes, lines, occupied, frame) + detours
    best = int(np.argmax(costs <= costs.min() + 1e-9))
    return offsets[best], boxes[best]


def _offsets(wanted: Array, beside: float, stretches: Sequence[float]) -> tuple[Array, Array]:
    """Offsets to try, shape (n, 2), and their distances from the preferred offset, shape (n,).

    A wide label beside its point can keep its end, not its center, at the preferred distance.
    """
    tries = itertools.product(stretches, TURNS, (0.0, beside))
    stretch, turn, shift = np.array(list(tries)).T
    cos, sin = np.cos(turn), np.sin(turn)
    offsets = stretch * np.array(
        [cos * wanted[0] - sin * wanted[1], sin * wanted[0] + cos * wanted[1]]
    )
    offsets[0] += shift * offsets[0] / np.hypot(*offsets)
    return offsets.T, 0.4 * np.abs(turn) + 1.5 * (stretch - 1) + 0.3 * (shift > 0)


def _costs(boxes: Array, lines: Array, occupied: Array, frame: Array) -> Array:
    """Cost of the marks that boxes of shape (n, corner, xy) would cover, shape (n,)."""
    low, high = boxes[:, None, 0], boxes[:, None, 1]
    inside = ((lines > low) & (lines < high)).all(axis=-1)
    covered = ((low <= occupied[:, 1]) & (occupied[:, 0] <= high)).all(axis=-1)
    outside = ((boxes < frame[0]) | (boxes > frame[1])).any(axis=(1, 2))
    return np.asarray(0.5 * inside.sum(axis=1) + 20.0 * covered.sum(axis=1) + 50.0 * outside)


def _samples(picture: Picture, sheet: Sheet) -> Iterator[Array]:
    """Points on the sheet along all drawn lines, on dots, and at both ends of a fence's strokes."""
    for mark in picture.marks:
        if isinstance(mark, (Line, Arrow)):
            yield _points_along(sheet.to_sheet(mark.points) / sheet.point)
        elif isinstance(mark, Hatch):
            yield sheet.to_sheet(mark.strokes.reshape(-1, 2)) / sheet.point
        elif isinstance(mark, Dot):
            around = mark.size / 2 * np.array([(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)])
            yield sheet.to_sheet(mark.position) / sheet.point + around
        elif isinstance(mark, Area) and mark.hatch:
            yield from (_points_along(sheet.to_sheet(ring) / sheet.point) for ring in mark.rings)


def _points_along(points: Array) -> Array:
    steps = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    distances = np.linspace(0.0, along[-1], min(1000, 2 + int(along[-1] / STEP)))
    return np.stack([np.interp(distances, along, points[:, i]) for i in (0, 1)], axis=1)
