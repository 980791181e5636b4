"""Limit curves of a gallery of supports, compared with the ring."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.lines import Line2D

from planar_pushing.drawing.canvas.axes import onto
from planar_pushing.drawing.canvas.colors import DARK, FORCE, GRAY
from planar_pushing.drawing.canvas.marks import NOTE, Picture, Sheet
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.scene import limit_line
from planar_pushing.drawing.supports import Ink, Pose, add_support, extents
from pulling_by_pushing.figures.captions import number, values, words
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.gallery import SECTION, curve, flat_parts, name_ring, shapes

FIGURE = Figure(
    title="Limit curves of a gallery of supports",
    reads=("support_curves", "supports"),
    size=(PAGE, 2.7),
    section=SECTION,
)
#: Columns of panels.
COLUMNS = 6
#: Half the width of a panel, and of the picture of the slider in it, in units of the largest force.
SPAN, SKETCH = 1.22, 0.3
#: Space between columns as a fraction of a panel; height of a title between rows, inches.
GAP, TITLE = 0.06, 0.19
TICKS = (-0.5, 0.0, 0.5)


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    curves = data["support_curves"]
    radius = float(curves.radius)
    ring = name_ring(data["supports"], radius)
    return (
        f"Limit curves of a gallery of supports (solid), each with that of {ring} (dashed, radius "
        f"{number(radius)}): the forces through the contact, divided by the weight, under which the "
        "slider moves. The extent is the largest distance from the center of pressure. Each support is "
        "drawn in the corner, with its rod to the left. The curve of a support on points has flats "
        "(heavy): every force on a flat turns the slider about the same point and moves the contact in "
        f"the same direction ({values(curves, 'rod_length', 'rod_angle')})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw a panel for each support and one for the legend."""
    curves, supports = data["support_curves"], shapes(data["supports"])
    rows = math.ceil((len(supports) + 1) / COLUMNS)
    lines = [*curves.force, curves.ring_force]
    ahead = max(float(np.abs(curve(force)).max()) for force in lines)
    axes = figure.subplots(rows, COLUMNS, sharex=True, sharey=True, squeeze=False)
    _arrange(figure, rows)
    for ax in axes.flat:
        ax.set(
            xlim=(-SPAN * ahead, SPAN * ahead), ylim=(-SPAN * ahead, SPAN * ahead), aspect="equal"
        )
        ax.set(xticks=TICKS, yticks=TICKS)
    for ax, name in zip(axes.flat, supports, strict=False):
        _panel(figure, ax, supports[name], curves.sel(support=name), ahead)
        ax.set_title(words(name), pad=1.5, fontsize=NOTE + 0.5, color=DARK)
    for index in range(len(supports), axes.size):
        axes.flat[index].set_axis_off()
        axes.flat[index - COLUMNS].tick_params(labelbottom=True)
    _legend(axes.flat[-1])
    figure.supxlabel("force along the fence, $f_x / W$", fontsize=8.5, y=0.01)
    figure.supylabel("force normal to the fence, $f_y / W$", fontsize=8.5, x=0.006)


def _arrange(figure: Any, rows: int) -> None:
    """Place square panels side by side and fit the height of the figure to them."""
    wide = figure.get_figwidth()
    left, right, below, above = 0.48, 0.04, 0.4, 0.16
    side = (wide - left - right) / (COLUMNS + GAP * (COLUMNS - 1))
    high = rows * side + (rows - 1) * TITLE + below + above
    figure.set_figheight(high)
    figure.subplots_adjust(left=left / wide, right=1 - right / wide, bottom=below / high,
                           top=1 - above / high, wspace=GAP, hspace=TITLE / side)  # fmt: skip


def _panel(figure: Any, ax: Any, support: Any, one: Any, ahead: float) -> None:
    picture = Picture()
    for x, y in ((1.0, 0.0), (0.0, 1.0)):
        ends = SPAN * ahead * np.array([(-x, -y), (x, y)])
        picture.line(ends, "#CCCCCC", width=0.4, order=1.0)
    picture.line(curve(one.ring_force), GRAY, width=0.8, dash="--")
    flat = [part for _, part in flat_parts(one.pivot.values)]
    limit_line(picture, curve(one.force), flat, order=3.0)
    _slider(picture, support, ahead)
    size = 72 * figure.get_figwidth() * ax.get_position().width
    onto(picture, ax, Sheet(np.zeros(2), size / (2 * SPAN * ahead), np.array([size, size]), 1.0))


def _slider(picture: Picture, support: Any, ahead: float) -> None:
    """Draw the support with its rod along the fence, in the corner that the curves leave free."""
    low, high = extents(support, Pose((0.0, 0.0), 0.0))
    scale = SKETCH * ahead / float(np.max(high - low))
    middle = ahead * np.array([SPAN - 0.82 * SKETCH, 0.66 * SKETCH - SPAN])
    center = middle - scale * (low + high) / 2
    end = center + np.array([scale * low[0] - 0.14 * ahead, 0.0])
    picture.line([end, center], DARK, width=0.7)
    picture.dot(end, 2.5, DARK)
    add_support(picture, support, Pose(center, 0.0, scale), Ink(width=0.9))


def _legend(ax: Any) -> None:
    lines = (
        Line2D([], [], color=DARK, linewidth=1.0, label="limit curve"),
        Line2D([], [], color=GRAY, linewidth=0.8, linestyle="--", label="the ring's"),
        Line2D([], [], color=FORCE, linewidth=2.6, label="flat: one pivot"),
    )
    ax.legend(handles=lines, loc="center")
