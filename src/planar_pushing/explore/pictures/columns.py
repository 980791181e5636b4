"""Columns of a picture: areas, lines, dots, heads and labels, each in the order in which it is drawn."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array

#: Columns of each kind of mark, which are the fields of the glyph that draws it.
COLUMNS: dict[str, tuple[str, ...]] = {
    "areas": ("xs", "ys", "fill", "alpha", "line", "width"),
    "lines": ("xs", "ys", "color", "width", "dash", "alpha"),
    "heads": ("xs", "ys", "fill", "line", "alpha"),
    "dots": ("x", "y", "size", "fill", "line", "marker"),
    "labels": ("x", "y", "text", "color", "dx", "dy"),
    "handles": ("x", "y", "name", "size", "alpha"),
}
#: Digits of coordinates, which are sent as text.
DIGITS = 5


@dataclass(slots=True)
class Marks:
    """The marks of a picture that is being made."""

    rows: dict[str, list[tuple[Any, ...]]] = field(
        default_factory=lambda: {name: [] for name in COLUMNS}
    )

    def area(
        self,
        rings: Iterable[Array],
        fill: str,
        *,
        alpha: float = 1.0,
        line: Any = None,
        width: float = 0.0,
    ) -> None:
        """Area inside the first ring and outside of the others."""
        xs, ys = zip(*(_split(each) for each in rings), strict=True)
        row = [list(xs)], [list(ys)], fill, alpha, line or fill, width
        self.rows["areas"].append(row)

    def line(
        self,
        points: Any,
        color: str,
        width: float = 1.5,
        *,
        dash: str = "solid",
        alpha: float = 1.0,
    ) -> None:
        """Line through points."""
        self.rows["lines"].append((*_split(points), color, width, dash, alpha))

    def head(self, points: Any, color: str, *, filled: bool, alpha: float = 1.0) -> None:
        """Head of an arrow: filled for a force, open for a motion, as in the figures."""
        if filled:
            self.rows["heads"].append((*_split(points), color, color, alpha))
        else:
            self.line(np.asarray(points)[:3], color, 2.2, alpha=alpha)

    def dot(
        self, place: npt.ArrayLike, size: float, fill: Any, line: str, marker: str = "circle"
    ) -> None:
        """Mark of a fixed size on the screen, pixels."""
        x, y = np.asarray(place, dtype=float)
        self.rows["dots"].append((_short(x), _short(y), size, fill, line, marker))

    def label(self, place: npt.ArrayLike, text: str, color: str, offset: npt.ArrayLike) -> None:
        """Text at an offset in pixels, y upwards."""
        (x, y), (dx, dy) = np.asarray(place, dtype=float), np.asarray(offset, dtype=float)
        row = _short(x), _short(y), text, color, round(float(dx), 1), round(float(-dy), 1)
        self.rows["labels"].append(row)

    def handle(self, place: npt.ArrayLike, name: str, *, selected: bool) -> None:
        """Place that can be dragged."""
        x, y = np.asarray(place, dtype=float)
        alpha = 0.5 if selected else 0.18
        self.rows["handles"].append((_short(x), _short(y), name, 30 if selected else 26, alpha))

    @property
    def columns(self) -> dict[str, dict[str, list[Any]]]:
        """The columns of each kind, as the page's sources hold them."""
        return {name: as_columns(name, rows) for name, rows in self.rows.items()}


def as_columns(name: str, rows: list[tuple[Any, ...]]) -> dict[str, list[Any]]:
    """Columns of a kind of mark."""
    turned = [list(each) for each in zip(*rows, strict=True)] or [[] for _ in COLUMNS[name]]
    return dict(zip(COLUMNS[name], turned, strict=True))


def _split(points: Any) -> tuple[list[float], list[float]]:
    rounded = np.round(np.asarray(points, dtype=float), DIGITS)
    return rounded[:, 0].tolist(), rounded[:, 1].tolist()


def _short(number: Any) -> float:
    return round(float(number), DIGITS)
