"""Marks as matplotlib artists."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path
from matplotlib.patheffects import withStroke

from planar_pushing.drawing.canvas.colors import DARK
from planar_pushing.drawing.canvas.labels import settle
from planar_pushing.drawing.canvas.marks import (
    DASHES,
    SHAPES,
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

#: Height of a row of titles in points.
TITLE = 16.0


def schematic(
    figure: Figure, rect: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0)
) -> Axes:
    """Axes without a frame in a region of a figure: left, bottom, width and height."""
    ax = figure.add_axes(rect)
    ax.set_axis_off()
    return ax


def to_axes(picture: Picture, ax: Axes, box: Array, pad: float = 12.0) -> Sheet:
    """Draw marks on axes that show a box with at least `pad` points around it."""
    figure = cast(Figure, ax.get_figure(root=True))
    place = ax.get_position(original=True)
    size = 72 * figure.get_size_inches() * [place.width, place.height]
    sheet = Sheet.around(box, tuple(size), pad)
    _show(picture, ax, sheet)
    return sheet


def onto(picture: Picture, ax: Axes, sheet: Sheet) -> None:
    """Draw marks on axes without changing their limits; the sheet gives the length of a point."""
    labels = iter(settle(picture, sheet))
    for mark in picture.marks:
        one = next(labels) if isinstance(mark, Label) else mark
        DRAWN[type(one)](ax, one, sheet)


def _area(ax: Axes, area: Area, sheet: Sheet) -> None:
    closed = [Path(np.vstack([ring, ring[:1]])) for ring in area.rings]
    patch = PathPatch(Path.make_compound_path(*_wound(closed)), facecolor=area.color, linewidth=0)
    patch.set(hatch=area.hatch or None, edgecolor=area.ink, zorder=area.order)
    ax.add_patch(patch)


def _wound(paths: list[Path]) -> list[Path]:
    """Paths with the first counterclockwise and the others clockwise, so that these are holes."""
    found = []
    for index, path in enumerate(paths):
        x, y = np.asarray(path.vertices).T
        left = float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) > 0
        same = left == (index == 0)
        found.append(path if same else Path(np.asarray(path.vertices)[::-1]))
    return found


def _line(ax: Axes, line: Line, sheet: Sheet) -> None:
    style: Any = (0, DASHES[line.dash]) if line.dash else "-"
    ax.plot(
        *line.points.T, color=line.color, linewidth=line.width, linestyle=style, zorder=line.order,
        solid_capstyle="butt", solid_joinstyle="round", scalex=False, scaley=False,
    )  # fmt: skip


def _hatch(ax: Axes, hatch: Hatch, sheet: Sheet) -> None:
    strokes = LineCollection(
        list(hatch.strokes), colors=hatch.color, linewidths=hatch.width, zorder=hatch.order
    )
    ax.add_collection(strokes, autolim=False)


def _arrow(ax: Axes, arrow: Arrow, sheet: Sheet) -> None:
    shaft, head = arrow.shape(sheet.unit)
    _line(ax, Line(shaft, arrow.color, arrow.width, arrow.dash, arrow.order), sheet)
    if arrow.filled:
        ax.add_patch(Polygon(head, facecolor=arrow.color, edgecolor="none", zorder=arrow.order))
    else:
        tip = ax.plot(
            *head.T, color=arrow.color, linewidth=arrow.width, zorder=arrow.order,
            scalex=False, scaley=False,
        )  # fmt: skip
        tip[0].set_solid_joinstyle("miter")


def _dot(ax: Axes, dot: Dot, sheet: Sheet) -> None:
    for points, filled in SHAPES[dot.shape]:
        where = dot.place + dot.size / 2 * sheet.unit * points
        face = "none" if dot.face is None else dot.edge if filled else dot.face
        patch = Polygon(where, facecolor=face, edgecolor=dot.edge, linewidth=dot.width)
        patch.set_zorder(dot.order)
        ax.add_patch(patch)


def _label(ax: Axes, label: Label, sheet: Sheet) -> None:
    white = withStroke(linewidth=2.0, foreground="white")
    ax.annotate(
        label.text, tuple(label.place), xytext=label.offset, textcoords="offset points",
        color=label.color, fontsize=label.size, ha=label.align, va="center", linespacing=0.95,
        annotation_clip=False, zorder=label.order, path_effects=[white],
    )  # fmt: skip


DRAWN: dict[type, Any] = {
    Area: _area,
    Line: _line,
    Hatch: _hatch,
    Arrow: _arrow,
    Dot: _dot,
    Label: _label,
}


class Panel(NamedTuple):
    """A picture with the box that it shows, its title, and its padding in points."""

    picture: Picture
    box: Array
    title: str = ""
    pad: float = 12.0


def panels(
    figure: Figure, given: Sequence[Panel], columns: int = 1, *, scale: float | None = None,
    alike: bool = False, share: Sequence[float] | None = None,
) -> list[Axes]:  # fmt: skip
    """Draw pictures in a grid, and fit the height of the figure to them.

    Parameters
    ----------
    given : sequence of Panel
    columns : int
        Number of panels in a row.
    scale : float, optional
        Points per unit of the scene; by default the panels fill the columns.
    alike : bool
        Whether all panels share the smallest of their scales.
    share : sequence of float, optional
        Widths of the columns as fractions of the figure's width; equal by default.
    """
    wide = 72 * figure.get_figwidth() * np.array(share or [1 / columns] * columns)
    fitting = [
        (wide[i % columns] - 2 * each.pad) / np.ptp(each.box[:, 0]) for i, each in enumerate(given)
    ]
    scales = [scale or (min(fitting) if alike else each) for each in fitting]
    heights = [
        s * np.ptp(each.box[:, 1]) + 2 * each.pad for s, each in zip(scales, given, strict=True)
    ]
    titles = TITLE if any(each.title for each in given) else 0.0
    rows = [max(heights[i : i + columns]) for i in range(0, len(given), columns)]
    whole = sum(rows) + titles * len(rows)
    figure.set_figheight(whole / 72)
    found, top = [], whole
    for row, high in enumerate(rows):
        top -= titles + high
        for column, each in enumerate(given[row * columns : (row + 1) * columns]):
            left = float(wide[:column].sum() / wide.sum())
            rect = left, top / whole, float(wide[column] / wide.sum()), high / whole
            ax = schematic(figure, rect)
            middle = Sheet(each.box.mean(axis=0), scales[row * columns + column],
                           np.array([wide[column], high]), 1.0)  # fmt: skip
            _show(each.picture, ax, middle)
            if each.title:
                figure.text(left + rect[2] / 2, (top + high + 0.6 * titles) / whole, each.title,
                            ha="center", va="center", color=DARK)  # fmt: skip
            found.append(ax)
    return found


def _show(picture: Picture, ax: Axes, sheet: Sheet) -> None:
    """Draw a picture on axes that cover a sheet."""
    (left, low), (right, high) = sheet.box
    ax.set(xlim=(left, right), ylim=(low, high))
    ax.set_aspect("equal", adjustable="datalim")
    onto(picture, ax, sheet)
