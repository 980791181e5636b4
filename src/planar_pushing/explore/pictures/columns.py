"""Columns of a picture: areas, lines, dots, heads and labels, each in the order in which it is drawn."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array

#: Columns of each kind of mark.
COLUMNS: dict[str, tuple[str, ...]] = {
    "areas": ("xs", "ys", "fill"),
    "lines": ("xs", "ys", "color", "width", "dash", "alpha"),
    "heads": ("xs", "ys", "fill", "alpha"),
    "dots": ("x", "y", "size", "fill", "line", "marker"),
    "labels": ("x", "y", "text", "color", "dx", "dy"),
    "handles": ("x", "y", "name", "size", "alpha"),
}


@dataclass(slots=True)
class Marks:
    """The marks of a picture that is being made."""

    rows: dict[str, list[tuple[Any, ...]]] = field(
        default_factory=lambda: {name: [] for name in COLUMNS}
    )

    def area(self, rings: Iterable[Array], fill: str) -> None:
        """Area inside the first ring and outside of the others."""
        xs, ys = zip(*(_split(each) for each in rings), strict=True)
        self.rows["areas"].append((list(xs), list(ys), fill))

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
            self.rows["heads"].append((*_split(points), color, alpha))
        else:
            self.line(np.asarray(points)[:3], color, 2.2, alpha=alpha)

    def dot(
        self, place: npt.ArrayLike, size: float, fill: Any, line: str, marker: str = "circle"
    ) -> None:
        """Mark of a fixed size on the screen, pixels."""
        self.rows["dots"].append((*_place(place), size, fill, line, marker))

    def label(self, place: npt.ArrayLike, text: str, color: str, offset: npt.ArrayLike) -> None:
        """Text at an offset in pixels, y upwards."""
        dx, dy = _place(offset)
        self.rows["labels"].append((*_place(place), text, color, dx, -dy))

    def handle(self, place: npt.ArrayLike, name: str, *, selected: bool) -> None:
        """Place that can be dragged."""
        size, alpha = (30, 0.5) if selected else (26, 0.18)
        self.rows["handles"].append((*_place(place), name, size, alpha))

    @property
    def columns(self) -> dict[str, dict[str, list[Any]]]:
        """The columns of each kind, as lists."""
        return {name: as_columns(name, rows) for name, rows in self.rows.items()}


def as_columns(name: str, rows: list[tuple[Any, ...]]) -> dict[str, list[Any]]:
    """Columns of a kind of mark."""
    turned = [list(each) for each in zip(*rows, strict=True)] or [[] for _ in COLUMNS[name]]
    return dict(zip(COLUMNS[name], turned, strict=True))


def _split(points: Any) -> tuple[list[float], list[float]]:
    xs, ys = np.asarray(points, dtype=float).T.tolist()
    return xs, ys


def _place(given: npt.ArrayLike) -> tuple[float, float]:
    x, y = np.asarray(given, dtype=float).tolist()
    return x, y
