"""Marks as matplotlib artists."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path
from matplotlib.patheffects import withStroke

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
    region = ax.get_position(original=True)
    size = 72 * figure.get_size_inches() * [region.width, region.height]
    sheet = Sheet.around(box, tuple(size), pad)
    _show(picture, ax, sheet)
    return sheet


def onto(picture: Picture, ax: Axes, sheet: Sheet) -> None:
    """Draw marks on axes without changing their limits; the sheet gives the length of a point."""
    labels = iter(settle(picture, sheet))
    for mark in picture.marks:
        if isinstance(mark, Label):
            mark = next(labels)
        DRAWERS[type(mark)](ax, mark, sheet)


def _area(ax: Axes, area: Area, sheet: Sheet) -> None:
    closed = [Path(np.vstack([ring, ring[:1]])) for ring in area.rings]
    patch = PathPatch(Path.make_compound_path(*_wind(closed)), facecolor=area.color, linewidth=0)
    patch.set(hatch=area.hatch or None, edgecolor=area.ink, zorder=area.order)
    ax.add_patch(patch)


def _wind(paths: list[Path]) -> list[Path]:
    """Paths with the first counterclockwise and the others clockwise, so that these are holes."""
    wound = []
    for index, path in enumerate(paths):
        x, y = np.asarray(path.vertices).T
        left = float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) > 0
        same = left == (index == 0)
        wound.append(path if same else Path(np.asarray(path.vertices)[::-1]))
    return wound


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
        outline = dot.position + dot.size / 2 * sheet.unit * points
        face = "none" if dot.face is None else dot.edge if filled else dot.face
        patch = Polygon(outline, facecolor=face, edgecolor=dot.edge, linewidth=dot.width)
        patch.set_zorder(dot.order)
        ax.add_patch(patch)


def _label(ax: Axes, label: Label, sheet: Sheet) -> None:
    white = withStroke(linewidth=2.0, foreground="white")
    ax.annotate(
        label.text, tuple(label.position), xytext=label.offset, textcoords="offset points",
        color=label.color, fontsize=label.size, ha=label.align, va="center", linespacing=0.95,
        annotation_clip=False, zorder=label.order, path_effects=[white],
    )  # fmt: skip


DRAWERS: dict[type, Any] = {
    Area: _area,
    Line: _line,
    Hatch: _hatch,
    Arrow: _arrow,
    Dot: _dot,
    Label: _label,
}


def _show(picture: Picture, ax: Axes, sheet: Sheet) -> None:
    """Draw a picture on axes that cover a sheet."""
    (left, low), (right, high) = sheet.box
    ax.set(xlim=(left, right), ylim=(low, high))
    ax.set_aspect("equal", adjustable="datalim")
    onto(picture, ax, sheet)
