"""A picture as a list of marks, which matplotlib draws or SVG contains.

Positions are in the units of the scene, with y upward. Widths, heads, dots, letters and offsets are in
points, so that their size on paper does not depend on the scene; a page sets the pixels per point. Marks
of a higher order cover those of a lower order. `SHAPES` are the outlines of dots.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.drawing.canvas.colors import DARK, FORCE, GUIDE, MOTION, tint
from planar_pushing.mechanics.plane import Array, direction

#: Drawing orders of areas, hatches, lines, dots, arrows, and labels.
AREAS, HATCHES, LINES, DOTS, ARROWS, LABELS = 0.0, 1.0, 2.0, 4.0, 5.0, 10.0
#: Font sizes in points.
SYMBOL, NOTE = 9.5, 7.5
#: Diameter of the white disc behind a symbol on an arc, in points.
LETTER = 11.0
#: Length and half the width of a head, in units of its size; an open head is wider.
FILLED, OPEN = (0.42, 0.165), (0.4, 0.21)
DASHES: dict[str, tuple[float, ...]] = {"": (), "--": (3.0, 1.8), ":": (1.0, 1.6)}

#: One or several positions as numbers: an array or array-like.
Positions = Any


class Area(NamedTuple):
    """Area inside the first ring of points and outside the others."""

    rings: tuple[Array, ...]
    color: str
    hatch: str = ""
    ink: str = DARK
    order: float = AREAS


class Line(NamedTuple):
    """Line through points, solid, dashed ("--") or dotted (":")."""

    points: Array
    color: str
    width: float = 1.2
    dash: str = ""
    order: float = LINES


class Hatch(NamedTuple):
    """Strokes of shape (n, 2, 2), such as those of a fence on the side away from the slider."""

    strokes: Array
    color: str
    width: float = 0.5
    order: float = HATCHES


class Arrow(NamedTuple):
    """Arrow with a head: filled for a force, open for a velocity or an acceleration."""

    points: Array
    color: str
    filled: bool
    width: float = 1.3
    head: float = 14.0
    dash: str = ""
    order: float = ARROWS

    def shape(self, point: float) -> tuple[Array, Array]:
        """Vertices of the shaft and of the head, with `point` as the length of a point in the scene."""
        tip, before = self.points[-1], self.points[-2]
        along = tip - before
        length = float(np.hypot(*along))
        ahead = along / (length or 1.0)
        across = np.array([-ahead[1], ahead[0]])
        deep, half = (FILLED if self.filled else OPEN) * np.array(self.head * point)
        size = float(np.hypot(*(tip - self.points[0])))
        shrink = min(1.0, 0.9 * size / deep) if len(self.points) == 2 else 1.0
        neck = tip - shrink * deep * ahead
        sides = neck + shrink * half * across, neck - shrink * half * across
        end = neck if self.filled else tip
        return np.vstack([self.points[:-1], end]), np.array([sides[0], tip, sides[1]])


class Dot(NamedTuple):
    """Mark at a position: "o" for a disc, "mass" or "pressure" for a center, "burst" for an impact."""

    position: Array
    size: float
    face: str | None
    edge: str
    width: float = 0.0
    shape: str = "o"
    order: float = DOTS


class Label(NamedTuple):
    """Text centered at an offset from a position; a held label stays there when others make room."""

    position: Array
    text: str
    color: str = DARK
    size: float = SYMBOL
    offset: tuple[float, float] = (0.0, 0.0)
    align: str = "center"
    held: bool = False
    order: float = LABELS

    @property
    def extent(self) -> tuple[float, float]:
        """Approximate width and height in points."""
        rows = [plain(row) for row in self.text.split("\n")]
        return 0.5 * self.size * max(map(len, rows)), 1.1 * self.size * len(rows)


Mark = Area | Line | Hatch | Arrow | Dot | Label


def plain(text: str) -> str:
    """Text without mathematical markup and with one letter for each symbol, for estimating its length."""
    letters = re.sub(r"\\[a-zA-Z]+", "x", re.sub(r"\\math(bf|rm)", "", text))
    return re.sub(r"[${}_^\\]", "", letters)


class Sheet(NamedTuple):
    """Map from a picture to a sheet: middle of the picture, scale in sheet units, size of the sheet."""

    middle: Array
    scale: float
    size: Array
    point: float

    @classmethod
    def around(
        cls, box: Array, size: Sequence[float], pad: float = 12.0, point: float = 1.0
    ) -> Sheet:
        """Sheet of a given size that shows a box of two corners with at least `pad` points around it."""
        corners, paper = np.asarray(box, dtype=float), np.asarray(size, dtype=float)
        room = np.maximum(paper - 2 * pad * point, 0.1 * paper)
        extent = np.maximum(corners[1] - corners[0], 1e-12)
        return cls(corners.mean(axis=0), float(np.min(room / extent)), paper, point)

    @property
    def box(self) -> Array:
        """Corners of the sheet in the scene."""
        half = self.size / self.scale / 2
        return np.array([self.middle - half, self.middle + half])

    @property
    def unit(self) -> float:
        """Length of a point in the scene."""
        return self.point / self.scale

    def to_sheet(self, positions: Positions) -> Array:
        """Positions on the sheet, y downward from its upper left corner."""
        away = (np.asarray(positions, dtype=float) - self.middle) * [self.scale, -self.scale]
        return np.asarray(away + self.size / 2)

    def to_scene(self, positions: Positions) -> Array:
        """Positions in the scene of positions on the sheet."""
        away = np.asarray(positions, dtype=float) - self.size / 2
        return np.asarray(away / [self.scale, -self.scale] + self.middle)


@dataclass(slots=True)
class Picture:
    """The marks of a picture; each method adds one mark or a few that belong together."""

    marks: list[Mark] = field(default_factory=list)

    def add(self, *marks: Mark) -> None:
        self.marks.extend(marks)

    @property
    def drawing_order(self) -> list[Mark]:
        """The marks in drawing order, covering marks last."""
        return sorted(self.marks, key=lambda mark: mark.order)

    def area(self, *rings: Positions, color: str, **rest: Any) -> None:
        self.add(Area(tuple(np.asarray(ring, dtype=float) for ring in rings), color, **rest))

    def line(self, points: Positions, color: str = DARK, **rest: Any) -> None:
        self.add(Line(np.asarray(points, dtype=float), color, **rest))

    def guide(
        self, start: Positions, stop: Positions, color: str = GUIDE, dash: str = "--"
    ) -> None:
        """Add a thin construction line, such as a line of force or a line of centers."""
        self.line([start, stop], color, width=0.7, dash=dash)

    def dot(self, position: Positions, size: float, face: str | None = DARK, **rest: Any) -> None:
        edge = rest.pop("edge", face or DARK)
        self.add(Dot(np.asarray(position, dtype=float), size, face, edge, **rest))

    def reserve(self, position: Positions, size: float) -> None:
        """Keep labels off a disc that something outside of the picture covers, such as a handle."""
        self.dot(position, size, None, edge="none")

    def label(self, position: Positions, text: str, **rest: Any) -> None:
        self.add(Label(np.asarray(position, dtype=float), text, **rest))

    def arrow(
        self,
        tail: Positions,
        vector: Positions,
        text: str = "",
        *,
        color: str,
        filled: bool,
        offset: tuple[float, float] | None = None,
        fraction: float = 1.0,
        **rest: Any,
    ) -> None:
        """Add an arrow from a tail along a vector; its label is beyond the tip or beside the shaft.

        `fraction` is the position of the label along the vector.
        """
        start, along = np.asarray(tail, dtype=float), np.asarray(vector, dtype=float)
        self.add(Arrow(np.array([start, start + along]), color, filled, **rest))
        if text:
            ahead = along / (float(np.hypot(*along)) or 1.0)
            wide = 5.0 + Label(start, text).extent[0] / 2
            away = (wide * float(ahead[0]), 9.0 * float(ahead[1])) if offset is None else offset
            self.label(start + fraction * along, text, color=color, offset=away)

    def force(self, tail: Positions, vector: Positions, text: str = "", **rest: Any) -> None:
        """Add the arrow of a force."""
        self.arrow(tail, vector, text, filled=True, **{"color": FORCE} | rest)

    def motion(self, tail: Positions, vector: Positions, text: str = "", **rest: Any) -> None:
        """Add the arrow of a velocity or an acceleration."""
        self.arrow(tail, vector, text, filled=False, **{"color": MOTION} | rest)

    def cone(
        self, right: float, left: float, radius: float, color: str, *, apex: Positions = (0.0, 0.0),
        strength: float = 0.16, order: float = AREAS + 0.5, hatch: str = "",
    ) -> None:  # fmt: skip
        """Add a cone of directions counterclockwise from right to left, radians; a line if they are equal.

        It covers the cones drawn before, so the largest must be drawn first.
        """
        origin, full = np.asarray(apex, dtype=float), left - right >= 2 * math.pi - 1e-9
        rim = origin + radius * arc(right, right + 2 * math.pi if full else left)
        self.area(
            rim if full else np.vstack([origin, rim]), color=tint(color, strength), ink=color,
            order=order, hatch=hatch,
        )  # fmt: skip
        if not full:
            for edge in (rim[0], rim[-1]):
                self.line([origin, edge], color, width=0.7, order=order + 0.1)

    def angle(
        self, start: float, stop: float, radius: float, text: str = "", *, vertex: Positions = (0, 0),
        color: str = GUIDE, offset: float = 6.0, fraction: float = 0.5,
    ) -> None:  # fmt: skip
        """Add the arc between two directions in radians, with its label outside it.

        A label without an offset interrupts the arc.
        """
        origin = np.asarray(vertex, dtype=float)
        self.line(origin + radius * arc(start, stop), color, width=0.7)
        if text:
            x, y = direction(start + fraction * (stop - start))
            away = offset * float(x), offset * float(y)
            position = origin + radius * np.array([x, y])
            if not offset:
                self.dot(position, LETTER, "white", order=LINES + 0.2)
            self.label(position, text, color=color, offset=away)

    def turn_arrow(self, position: Positions, sense: float, radius: float, color: str) -> None:
        """Add a curved arrow around a center, counterclockwise for a positive sense."""
        turns = np.deg2rad(np.linspace(-30.0, 210.0, 25))
        points = direction(turns) * [1.0 if sense > 0 else -1.0, 1.0]
        around = np.asarray(position, dtype=float) + radius * points
        self.add(Arrow(around, color, filled=False, width=0.9, head=8.0))

    def axis(
        self, origin: Positions, angle: float, length: float, name: str, color: str = GUIDE
    ) -> None:
        """Add a coordinate axis at an angle in radians, without a head: heads mark forces and motions."""
        start, (x, y) = np.asarray(origin, dtype=float), direction(angle)
        end = start + length * np.array([x, y])
        self.line([start, end], color, width=0.7, order=LINES + 0.5)
        self.label(end, name, color=color, offset=(7.0 * float(x), 7.0 * float(y)))

    def scale_bar(self, position: Positions, length: float, text: str) -> None:
        """Add a bar of a length from a position to the right, with its label above."""
        start = np.asarray(position, dtype=float)
        end = start + np.array([length, 0.0])
        self.line([start, end], GUIDE, width=1.6)
        self.label((start + end) / 2, text, color=GUIDE, size=NOTE, offset=(0.0, 6.5), held=True)


def arc(start: float, stop: float) -> Array:
    """Points of the unit circle between two directions in radians, 2 degrees apart."""
    count = 2 + int(abs(stop - start) / 0.035)
    return np.asarray(direction(np.linspace(start, stop, count)))


def unit(degrees: float) -> Array:
    """Unit vector at an angle in degrees."""
    return np.asarray(direction(math.radians(degrees)))


def corners(points: Iterable[Positions], margin: float = 0.0) -> Array:
    """Corners of the smallest upright box around points."""
    positions = np.concatenate(
        [np.reshape(np.asarray(group, dtype=float), (-1, 2)) for group in points]
    )
    return np.array([positions.min(axis=0) - margin, positions.max(axis=0) + margin])


def _turns(start: float, stop: float, count: int) -> Array:
    return np.asarray(direction(np.linspace(start, stop, count)))


def _quarter(start: float) -> Array:
    return np.vstack([[(0.0, 0.0)], _turns(start, start + np.pi / 2, 13)])


def _burst() -> Array:
    rays = _turns(np.pi / 2, 2.5 * np.pi, 17)[:-1]
    return rays * np.where(np.arange(16) % 2, 0.55, 1.0)[:, None]


_CIRCLE = _turns(0.0, 2 * np.pi, 33)[:-1]
_PLUS = np.array(
    [(1, 3), (1, 1), (3, 1), (3, -1), (1, -1), (1, -3), (-1, -3), (-1, -1), (-3, -1), (-3, 1),
     (-1, 1), (-1, 3)]
) / 3.0  # fmt: skip

#: A center of mass is a disc with two dark quadrants, and a center of pressure is a cross.
SHAPES: dict[str, tuple[tuple[Array, bool], ...]] = {
    "o": ((_CIRCLE, False),),
    "mass": ((_CIRCLE, False), (_quarter(0.0), True), (_quarter(np.pi), True)),
    "pressure": ((_PLUS, False),),
    "burst": ((_burst(), False),),
}
