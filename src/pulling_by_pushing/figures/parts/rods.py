"""A quantity of every support over rod lengths and over rod angles, in four panels."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from planar_pushing.drawing.canvas.colors import DARK, GRAY, support_colors
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import number, words
from pulling_by_pushing.figures.parts.gallery import families, name_ring

if TYPE_CHECKING:
    import xarray as xr

AXES = ("rod_length", "rod_angle")
#: Style of the ring's line, which is behind the others and wider.
BEHIND: dict[str, Any] = {"color": GRAY, "linewidth": 2.8, "alpha": 0.55}
#: Dashes of the supports of a panel, in addition to their colors.
DASHES: tuple[Any, ...] = (
    "-", (0, (5, 1.5)), (0, (2, 1)), (0, (9, 1.5, 2, 1.5)), (0, (5, 1.5, 1, 1.5)), (0, (1, 1)),
)  # fmt: skip


def over(rods: xr.Dataset, axis: str) -> xr.Dataset:
    """The rods over their lengths or over their angles; the other quantity is the same for all of them."""
    return rods.isel(rod=rods.sweep.values == axis)


def fixed(rods: xr.Dataset, axis: str) -> float:
    """Value of the quantity, length or angle, that the rods over the other one have in common."""
    (other,) = {*AXES} - {axis}
    return float(over(rods, other)[axis][0])


def cuts(rods: xr.Dataset, supports: xr.Dataset) -> tuple[str, str, str]:
    """Fixed rod length, fixed rod angle, and the ring with its radius, as text for a caption."""
    length, angle = (number(fixed(rods, axis)) for axis in AXES)
    radius = float(rods.radius)
    return length, angle, f"{name_ring(supports, radius)}, of radius {number(radius)}"


class Panel(NamedTuple):
    """A panel: its axes, the quantity on its horizontal axis, and its supports with color and dash."""

    ax: Any
    axis: str
    looks: list[tuple[str, str, Any]]


def panels(
    figure: Any,
    rods: xr.Dataset,
    shapes: Mapping[str, Any],
    heights: Callable[[xr.Dataset, str, str], Array],
) -> Iterator[Panel]:
    """Draw supports on areas above those on points and lines, over rod length and over rod angle.

    `heights(rods, axis, prefix)` are those in the panel over an axis; the prefix is that of the variables
    of the ring, or empty.
    """
    colors = support_colors(shapes)
    axes = figure.subplots(2, 2)
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.09, top=0.97, hspace=0.16, wspace=0.2)
    for index, ax in enumerate(axes.flat):
        names, axis = families(shapes, float(rods.radius))[index // 2], AXES[index % 2]
        part = over(rods, axis)
        looks = [(name, colors[name], DASHES[i % len(DASHES)]) for i, name in enumerate(names)]
        ax.plot(part[axis], heights(part, axis, "ring_"), label="ring", **BEHIND)
        for name, color, dash in looks:
            y = heights(part.sel(support=name), axis, "")
            ax.plot(part[axis], y, color=color, linestyle=dash, label=words(name))
        _frame(ax, rods, axis, named=index > 1)
        ax.set_title(f"({'abcd'[index]})", loc="left", pad=2.0, color=DARK)
        yield Panel(ax, axis, looks)


def _frame(ax: Any, rods: xr.Dataset, axis: str, *, named: bool) -> None:
    if axis == "rod_length":
        lengths = over(rods, axis).rod_length.values
        ticks = [part * float(rods.radius) for part in (0.1, 0.2, 0.5, 1, 2, 5, 10)]
        ax.set_xscale("log")
        ax.set(xlim=(lengths[0], lengths[-1]), xticks=ticks, xticklabels=[f"{x:g}" for x in ticks])
        ax.set_xticks([], minor=True)
        text = rf"rod length $l$, at $\psi = {fixed(rods, 'rod_angle'):g}^\circ$"
    else:
        ax.set(xlim=(0.0, 180.0), xticks=range(0, 181, 45))
        text = rf"rod angle $\psi$ (degrees), at $l = {fixed(rods, 'rod_length'):g}$"
    if named:
        ax.set_xlabel(text, color=DARK)
    else:
        ax.tick_params(axis="x", labelbottom=False)
