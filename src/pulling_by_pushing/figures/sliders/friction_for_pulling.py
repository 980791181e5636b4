"""The friction that pulling requires."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.canvas.colors import GRAY, support_colors
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import words
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.gallery import SECTION, families, shapes
from pulling_by_pushing.figures.parts.line_labels import label_lines, named_lines
from pulling_by_pushing.figures.parts.rods import INERTIA, Panel, cuts, over, panels

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="The friction that pulling needs",
    reads=("support_rods", "supports"),
    size=(PAGE, 3.7),
    section=SECTION,
)
#: Friction coefficients labeled on the axis of friction angles.
TICKS = np.array([0.5, 0.7, 1, 1.5, 2, 3, 5, 10, np.inf])
#: A larger change of the friction angle between two samples, degrees, is a jump.
JUMP = 8.0
UPRIGHT = 90.0
#: Smallest friction angle in the panels over each quantity, degrees.
LOWEST = {"rod_length": 42.0, "rod_angle": 24.0}


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    rods = data["support_rods"]
    length, angle, ring = cuts(rods, data["supports"])
    return (
        "Smallest coefficient of friction at which the contact can stick while the pusher moves "
        "away, on the scale of arctan μ, for supports on areas (a, b) and on points and lines (c, d), "
        f"over the rod length (a, c; ψ = {angle}°) and over the rod angle (b, d; l = {length}), beside "
        f"that of {ring}. Where a curve reaches infinity, pulling is impossible; at ψ = 90° "
        "this happens for every support that is symmetric about the rod."
        f"{''.join(_remarks(rods))}"
    )


def _remarks(rods: xr.Dataset) -> Iterator[str]:
    """Remarks on the supports with discontinuous curves."""
    names = [words(str(name)) for name in rods.support.values if _jump(rods, name)]
    if names:
        yield (
            f" For the {' and the '.join(names)}, this happens only at 90° (dot): at "
            "angles close to it the motion along the fence is a pivot, and the curve ends at the open "
            "circle."
        )
    if "quadruped" in rods.support.values:
        yield " The quadruped's curve jumps where a foot is directly above the contact."


def draw(figure: Any, data: Data) -> None:
    """Draw the smallest friction over rod length and over rod angle."""
    rods = data["support_rods"]
    supports = shapes(data["supports"])
    rows = families(supports, float(rods.radius))
    for panel in panels(figure, rods, support_colors(supports), rows, _heights):
        swept = over(rods, panel.axis)
        law = _heights(swept, panel.axis, "inertia_")
        panel.ax.plot(swept[panel.axis], law, label="ring, inertia alone", **INERTIA)
        _label_friction(panel)
        if panel.axis == "rod_angle":
            _mark_jumps(panel, rods)
        label_lines(panel.ax, named_lines(panel.ax))


def _heights(rods: xr.Dataset, axis: str, prefix: str) -> Array:
    """Friction angles, with gaps where a curve jumps."""
    height: Array = rods[f"{prefix}pulling_friction_angle"].values
    return np.where(np.abs(np.diff(height, append=height[-1])) > JUMP, np.nan, height)


def _label_friction(panel: Panel) -> None:
    """Label friction coefficients on the axis of friction angles."""
    ax, lowest = panel.ax, LOWEST[panel.axis]
    ax.set_ylim(lowest, 91.5)
    ticks = TICKS[np.degrees(np.arctan(TICKS)) >= lowest]
    names = [r"$\infty$" if np.isinf(mu) else f"{mu:g}" for mu in ticks]
    ax.set_yticks(np.degrees(np.arctan(ticks)), names)
    ax.axhline(90.0, color=GRAY, linewidth=0.5, zorder=0)
    ax.annotate("never", (1.0, 90.3), xycoords=("axes fraction", "data"), annotation_clip=False,
                size=NOTE, color=GRAY, ha="right", va="bottom")  # fmt: skip
    ax.set_ylabel(r"smallest $\mu$ that pulls")


def _mark_jumps(panel: Panel, rods: xr.Dataset) -> None:
    """Mark curves whose value at 90 degrees differs from their limit there."""
    for name, color, _ in panel.looks:
        heights = _jump(rods, name)
        if heights:
            style: dict[str, Any] = {"color": color, "markersize": 4.0, "zorder": 5}
            for height, face in zip(heights, (color, "white"), strict=True):
                panel.ax.plot(UPRIGHT, height, "o", markerfacecolor=face, clip_on=False, **style)


def _jump(rods: xr.Dataset, name: object) -> tuple[float, float] | None:
    """Heights of a curve at the upright rod and beside it; None if they are equal."""
    turned = over(rods, "rod_angle").sel(support=name)
    height = turned.pulling_friction_angle.values
    for row in np.flatnonzero(turned.rod_angle.values[1:] == UPRIGHT) + 1:
        here, limit = float(height[row]), float(height[row - 1])
        if abs(here - limit) > JUMP:
            return here, limit
    return None
