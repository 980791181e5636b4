"""The marks of a picture as SVG, in the pixels of the page, which the browser draws as it comes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from html import escape
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.figures.style import GREY
from planar_pushing.mechanics.plane import Array

#: Room around what a picture holds.
MARGIN = 1.05
#: Width of the edge of a dot, pixels.
EDGE = 1.6


class Sheet(NamedTuple):
    """Where a picture is on the screen: the pixels of its origin, and those of a unit of length."""

    x: float
    y: float
    scale: float

    def to_screen(self, xs: Any, ys: Any) -> Iterator[tuple[float, float]]:
        """Pixels of places."""
        x, y, scale = self
        return ((x + scale * right, y - scale * up) for right, up in zip(xs, ys, strict=True))

    def place(self, pixel: npt.ArrayLike) -> Array:
        """The place at a pixel."""
        x, y = np.asarray(pixel, dtype=float)
        return np.array([(x - self.x) / self.scale, (self.y - y) / self.scale])


def sheet(corners: npt.ArrayLike, width: float, height: float) -> Sheet:
    """A picture that shows a box in its middle, to one scale in both directions."""
    low, high = np.asarray(corners, dtype=float)
    scale = float(np.min([width, height] / (high - low))) / MARGIN
    x, y = (low + high) / 2
    return Sheet(width / 2 - scale * float(x), height / 2 + scale * float(y), scale)


def markup(columns: dict[str, dict[str, list[Any]]], on: Sheet) -> str:
    """A picture's marks as elements of SVG; the group around them says where its origin is."""
    marks = "".join(
        draw(on, *row)
        for kind, draw in KINDS.items()
        for row in zip(*columns[kind].values(), strict=True)
    )
    return f'<g data-x="{on.x:.3f}" data-y="{on.y:.3f}" data-scale="{on.scale:.4f}">{marks}</g>'


def _path(on: Sheet, xs: Any, ys: Any) -> str:
    return "M" + " ".join(f"{x:.2f} {y:.2f}" for x, y in on.to_screen(xs, ys))


def _area(on: Sheet, xs: Any, ys: Any, fill: str) -> str:
    rings = "Z".join(_path(on, *ring) for ring in zip(xs, ys, strict=True))
    return f'<path d="{rings}Z" fill="{fill}" fill-rule="evenodd"/>'


def _line(on: Sheet, xs: Any, ys: Any, color: str, width: float, dash: str, alpha: float) -> str:
    dashes = ' stroke-dasharray="6"' if dash == "dashed" else ""
    return (
        f'<path d="{_path(on, xs, ys)}" fill="none" stroke="{color}" stroke-width="{width}" '
        f'stroke-linejoin="round" stroke-opacity="{alpha}"{dashes}/>'
    )


def _head(on: Sheet, xs: Any, ys: Any, color: str, alpha: float) -> str:
    return f'<path d="{_path(on, xs, ys)}Z" fill="{color}" stroke="{color}" opacity="{alpha}"/>'


def _dot(on: Sheet, x: float, y: float, size: float, fill: Any, line: str, marker: str) -> str:
    ((at_x, at_y),) = on.to_screen([x], [y])
    inner = MARKERS[marker](size / 2)
    return (
        f'<g transform="translate({at_x:.2f} {at_y:.2f})" fill="{fill or "none"}" color="{line}" '
        f'stroke="currentColor" stroke-width="{EDGE}">{inner}</g>'
    )


def _handle(on: Sheet, x: float, y: float, name: str, size: float, alpha: float) -> str:
    ((at_x, at_y),) = on.to_screen([x], [y])
    return (
        f'<circle data-handle="{name}" cx="{at_x:.2f}" cy="{at_y:.2f}" r="{size / 2}" fill="{GREY}" '
        f'fill-opacity="{alpha}" stroke="{GREY}" stroke-opacity="0.75" stroke-width="1.2"/>'
    )


def _label(on: Sheet, x: float, y: float, text: str, color: str, dx: float, dy: float) -> str:
    ((at_x, at_y),) = on.to_screen([x], [y])
    return f'<text x="{at_x + dx:.2f}" y="{at_y + dy:.2f}" fill="{color}">{escape(text)}</text>'


def _circle(radius: float) -> str:
    return f'<circle r="{radius}"/>'


def _circle_dot(radius: float) -> str:
    return f'<circle r="{radius}"/><circle r="{radius / 4}" fill="currentColor" stroke="none"/>'


def _plus(radius: float) -> str:
    """A cross with arms three quarters as wide as its radius."""
    half, arm = 3 * radius / 8, 5 * radius / 8
    return (
        f'<path d="M{half} {radius}v{-arm}h{arm}v{-2 * half}h{-arm}v{-arm}h{-2 * half}v{arm}h{-arm}'
        f'v{2 * half}h{arm}v{arm}Z"/>'
    )


MARKERS: dict[str, Callable[[float], str]] = {
    "circle": _circle,
    "circle_dot": _circle_dot,
    "plus": _plus,
}
#: How each kind of mark is drawn, from the lowest to the one on top.
KINDS: dict[str, Callable[..., str]] = {
    "areas": _area,
    "lines": _line,
    "heads": _head,
    "dots": _dot,
    "handles": _handle,
    "labels": _label,
}
