"""Figure 16: limit curves of a gallery of supports, compared with the ring."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.lines import Line2D

from planar_pushing.drawing.canvas.axes import is_column, onto
from planar_pushing.drawing.canvas.colors import DARK, FORCE, GRAY
from planar_pushing.drawing.canvas.marks import NOTE, Picture, Sheet
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.drawing.scene import limit_line
from planar_pushing.drawing.supports import Ink, Pose, add_support, extents
from planar_pushing.mechanics.contact import InfiniteFriction
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import named, number, titled, values
from pulling_by_pushing.figures.parts.gallery import (
    SECTION,
    described_supports,
    flat_parts,
    limit_forces,
    ring_beside,
    scene,
    supports,
)
from pulling_by_pushing.study.datasets.base import words

FIGURE = Figure(
    title="Limit curves of a gallery of supports",
    reads=("supports",),
    takes=("rod_length",),
    size=(PAGE, 5.4),
    column=(COLUMN, 4.75),
    section=SECTION,
)
#: Force angles of a curve, degrees.
ANGLES = np.linspace(0.0, 360.0, 721)
#: Half the width of a panel, and of the picture of the slider in it, in units of the largest force.
SPAN, SKETCH = 1.22, 0.3
TICKS = (-0.5, 0.0, 0.5)
ACROSS = {"x": "along", "y": "normal to"}


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the curves, the pivots of their forces, and the ring's curve."""
    grid = sources["supports"]
    found = supports(grid)
    rod = settings.rod_length, settings.rod_angle, InfiniteFriction()
    forces, pivots = limit_forces(scene(found, *rod), ANGLES)
    ring, _ = limit_forces(scene({"ring": ring_beside(found)}, *rod), ANGLES)
    data = described_supports(grid, settings)
    dims = ("support", "force_angle")
    for i, (name, text) in enumerate(ACROSS.items()):
        about = f"force {text} the fence on the limit curve"
        data[f"force_{name}"] = named(dims, forces[..., i], "force", about)
        data[f"ring_force_{name}"] = named(dims[1:], ring[0, :, i], "force", f"{about} of the ring")
    text = "number of the support point about which the slider pivots, -1 without one"
    data["pivot"] = named(dims, pivots, "1", text)
    data = data.assign_coords(force_angle=named("force_angle", ANGLES, "degree", "force angle"))
    return titled(data, "Limit curves of every support", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    radius = number(float(data.ring_extent))
    return (
        "Limit curves of a gallery of supports (solid), each with that of a ring of the same "
        f"extent (dashed, radius {radius}): the forces through the contact, divided by the weight, "
        "under which the slider moves. The extent is the largest distance from the center of "
        "pressure. Each support is drawn in the corner, with its rod to the left. The curve of a "
        "support on points has flats (heavy): every force on a flat turns the slider about the same "
        "point and moves the contact in the same direction "
        f"({values(data, 'rod_length', 'rod_angle')})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw a panel for each support and one for the legend."""
    found = supports(data)
    columns = 3 if is_column(figure) else 4
    rows = math.ceil((len(found) + 1) / columns)
    ahead = max(float(np.abs(data[f"{of}force_{x}"]).max()) for of in ("", "ring_") for x in "xy")
    axes = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    _place(figure, rows, columns)
    for ax in axes.flat:
        ax.set(
            xlim=(-SPAN * ahead, SPAN * ahead), ylim=(-SPAN * ahead, SPAN * ahead), aspect="equal"
        )
        ax.set(xticks=TICKS, yticks=TICKS)
    for ax, name in zip(axes.flat, found, strict=False):
        _panel(figure, ax, found[name], data.sel(support=name), ahead)
        ax.text(
            0.03, 0.97, words(name), transform=ax.transAxes, va="top", size=NOTE + 0.5, color=DARK
        )
    for ax in axes.flat[len(found) :]:
        ax.set_axis_off()
    _legend(axes.flat[-1])
    figure.supxlabel("force along the fence, $f_x / W$", fontsize=8.5, y=0.01)
    figure.supylabel("force normal to the fence, $f_y / W$", fontsize=8.5, x=0.006)


def _place(figure: Any, rows: int, columns: int) -> None:
    """Place square panels side by side and fit the height of the figure to them."""
    wide = figure.get_figwidth()
    left, right, below, above = 0.48, 0.04, 0.42, 0.06
    high = rows * (wide - left - right) / columns + below + above
    figure.set_figheight(high)
    figure.subplots_adjust(left=left / wide, right=1 - right / wide, bottom=below / high,
                           top=1 - above / high, wspace=0.06, hspace=0.06)  # fmt: skip


def _panel(figure: Any, ax: Any, support: Any, one: xr.Dataset, ahead: float) -> None:
    picture = Picture()
    for x, y in ((1.0, 0.0), (0.0, 1.0)):
        ends = SPAN * ahead * np.array([(-x, -y), (x, y)])
        picture.line(ends, "#CCCCCC", width=0.4, order=1.0)
    ring = np.stack([one.ring_force_x, one.ring_force_y], axis=-1)
    picture.line(ring, GRAY, width=0.8, dash="--")
    curve = np.stack([one.force_x, one.force_y], axis=-1)
    limit_line(picture, curve, [part for _, part in flat_parts(one.pivot.values)], order=3.0)
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
        Line2D([], [], color=GRAY, linewidth=0.8, linestyle="--", label="of a ring"),
        Line2D([], [], color=FORCE, linewidth=2.6, label="flat: one pivot"),
    )
    ax.legend(handles=lines, loc="center")
