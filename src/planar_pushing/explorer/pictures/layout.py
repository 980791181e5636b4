"""Where the handles are on the sheet: beside one another, each with its name."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from planar_pushing.drawing.canvas.marks import NOTE, Arrow, Label, Line, Picture, Sheet
from planar_pushing.explorer.state import Handle
from planar_pushing.mechanics.plane import Array

#: Radius of a handle, free distance between two, and largest distance at which one is grabbed, in pixels.
RADIUS, FREE, GRAB = 11.0, 5.0, 30.0
#: Diameter of a handle in points at the smallest scale of the page, and distance of its name from it
#: in pixels.
DIAMETER, BESIDE = 17.6, 3.0
#: Distance between samples of a line in pixels, and the largest number of samples.
SAMPLE, MOST = 4.0, 1000
#: Color of the names.
NAME = "#555555"
#: Order in which handles take their places: the first ones mark a point of the slider.
ORDER = Handle.CONTACT, Handle.ROD, Handle.PUSHER, Handle.SIZE, Handle.LINE
#: Directions in which a handle makes room, and distances in diameters.
TURNS = np.deg2rad([0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150, 180])
STEPS = (1.25, 1.7, 2.2, 2.8)
#: Places along its line that the handle of the line of force tries, in units of its own.
ALONG = (1.15, 0.85, 1.3, 0.7, 1.5, 0.55)


class Held(NamedTuple):
    """The handle that follows the pointer, and its offset in pixels from what it moves."""

    handle: Handle
    offset: tuple[float, float]


class Spot(NamedTuple):
    """A handle on the sheet, and what it moves, in pixels."""

    center: Array
    anchor: Array

    @property
    def offset(self) -> tuple[float, float]:
        """Offset of the handle from what it moves."""
        x, y = (self.center - self.anchor).tolist()
        return x, y


def place_handles(
    positions: Mapping[Handle, Array], sheet: Sheet, held: Held | None = None
) -> dict[Handle, Spot]:
    """Handles on a sheet, none of which covers another one.

    A handle is at its position, unless another one is there. The handle of the line of force then moves
    along its line, and any other one aside. A handle that is held keeps its offset, and the others make
    room.
    """
    anchors = {name: sheet.to_sheet(position) for name, position in positions.items()}
    origin = sheet.to_sheet((0.0, 0.0))
    spots: dict[Handle, Spot] = {}
    if held is not None and held.handle in anchors:
        anchor = anchors[held.handle]
        spots[held.handle] = Spot(anchor + held.offset, anchor)
    for name in ORDER:
        if name in anchors and name not in spots:
            spots[name] = _free_spot(name, anchors[name], origin, spots, sheet)
    return {name: spots[name] for name in positions}


def _free_spot(
    name: Handle, anchor: Array, origin: Array, spots: Mapping[Handle, Spot], sheet: Sheet
) -> Spot:
    """The first spot of a handle on the sheet that no other one covers; its position if there is none."""
    centers = np.array([spot.center for spot in spots.values()]).reshape(-1, 2)
    for center in _tries(name, anchor, origin):
        inside = ((center >= RADIUS) & (center <= sheet.size - RADIUS)).all()
        if inside and (np.hypot(*(centers - center).T) >= 2.0 * RADIUS + FREE).all():
            on_line = name == Handle.LINE
            return Spot(center, center if on_line else anchor)
    return Spot(anchor, anchor)


def _tries(name: Handle, anchor: Array, origin: Array) -> Iterator[Array]:
    """Spots to try for a handle: along its line, or around its position, away from the contact first."""
    yield anchor
    away = anchor - origin
    if name == Handle.LINE:
        yield from (origin + part * away for part in ALONG)
    ahead = math.atan2(away[1], away[0]) if np.any(away) else math.pi / 4
    for step in STEPS:
        for turn in TURNS:
            angle = ahead + turn
            yield anchor + 2.0 * RADIUS * step * np.array([math.cos(angle), math.sin(angle)])


def nearest_spot(spots: Mapping[Handle, Spot], pixel: Array) -> Handle | None:
    """The handle at a position on the sheet; None if there is none."""
    distances = {name: math.dist(spot.center, pixel) for name, spot in spots.items()}
    name = min(distances, key=distances.__getitem__)
    return name if distances[name] < GRAB else None


class Name(NamedTuple):
    """A place of a name: its middle and half of its size in pixels, and how it is aligned."""

    middle: Array
    half: Array
    align: str

    @property
    def box(self) -> Array:
        """Its corners."""
        return np.array([self.middle - self.half, self.middle + self.half])


def add_names(picture: Picture, spots: Mapping[Handle, Spot], sheet: Sheet) -> None:
    """Add the names of handles, each beside its own; all other labels keep off both."""
    lines = np.concatenate([np.empty((0, 2)), *_points_of_lines(picture, sheet)])
    for spot in spots.values():
        picture.reserve(sheet.to_scene(spot.center), DIAMETER)
    boxes = [Name(spot.center, np.full(2, RADIUS), "center").box for spot in spots.values()]
    for name, spot in spots.items():
        text = str(name)
        size = sheet.point * np.array(Label(spot.center, text, size=NOTE).extent)
        tries = list(_names_around(spot.center, size / 2.0))
        best = min(tries, key=lambda place: _cost(place.box, boxes, lines, sheet))
        boxes.append(best.box)
        edge = {"left": -1.0, "right": 1.0, "center": 0.0}[best.align]
        right, down = (
            best.middle + edge * best.half * np.array([1.0, 0.0]) - spot.center
        ) / sheet.point
        picture.label(
            sheet.to_scene(spot.center), text, size=NOTE, color=NAME, align=best.align,
            offset=(float(right), -float(down)), held=True,
        )  # fmt: skip


def _names_around(center: Array, half: Array) -> Iterator[Name]:
    """Places of a name that touches its handle: beside it, below and above it, and at its corners."""
    wide, high = half.tolist()
    x, y, diagonal = RADIUS + BESIDE, RADIUS + BESIDE / 2.0 + high, 0.75 * RADIUS + BESIDE
    sides = {"left": 1.0, "right": -1.0}
    for align, sign in sides.items():
        yield Name(center + sign * (x + wide) * np.array([1.0, 0.0]), half, align)
    for sign in (1.0, -1.0):
        yield Name(center + sign * y * np.array([0.0, 1.0]), half, "center")
    for align, sign in sides.items():
        for down in (1.0, -1.0):
            offset = np.array([sign * (diagonal + wide), down * (diagonal + high / 2.0)])
            yield Name(center + offset, half, align)


def _points_of_lines(picture: Picture, sheet: Sheet) -> Iterator[Array]:
    """Points on the sheet along lines and arrows."""
    for mark in picture.marks:
        if isinstance(mark, (Line, Arrow)):
            points = sheet.to_sheet(mark.points)
            along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
            distances = SAMPLE * np.arange(math.ceil(min(along[-1] / SAMPLE, MOST)))
            yield np.stack([np.interp(distances, along, points[:, i]) for i in (0, 1)], axis=-1)


def _cost(box: Array, others: list[Array], lines: Array, sheet: Sheet) -> float:
    """Cost of what a name would cover: lines a little, handles and names more; it stays on the sheet."""
    crossed = ((lines > box[0]) & (lines < box[1])).all(axis=-1).sum()
    covered = sum(bool(((box[0] < other[1]) & (other[0] < box[1])).all()) for other in others)
    outside = bool(((box[0] < 0.0) | (box[1] > sheet.size)).any())
    return float(crossed + 20.0 * covered + 200.0 * outside)


def markup_of_handles(spots: Mapping[Handle, Spot], chosen: Handle) -> str:
    """Handles as circles, with a mark on the one that the keys move and a line to what each moves."""
    circles = ""
    for name, (center, anchor) in spots.items():
        (x, y), (foot_x, foot_y) = center.tolist(), anchor.tolist()
        if math.dist(center, anchor) > RADIUS:
            ends = f'x1="{foot_x:.1f}" y1="{foot_y:.1f}" x2="{x:.1f}" y2="{y:.1f}"'
            circles += f'<line class="leader" {ends}/>'
        look = "handle chosen" if name == chosen else "handle"
        circle = f'cx="{x:.1f}" cy="{y:.1f}" r="{RADIUS}"'
        circles += (
            f'<circle class="{look}" data-handle="{name}" {circle}><title>{name}</title></circle>'
        )
    return circles
