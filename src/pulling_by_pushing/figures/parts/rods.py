"""Panels with a quantity of several supports over rod lengths and over rod angles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from planar_pushing.drawing.canvas.colors import DARK, GRAY
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import number, words
from pulling_by_pushing.figures.parts.gallery import name_ring

if TYPE_CHECKING:
    import xarray as xr

AXES, LETTERS = ("rod_length", "rod_angle"), "abcd"
#: Style of the ring's line, which is behind the others and wider.
BEHIND: dict[str, Any] = {"color": GRAY, "linewidth": 2.8, "alpha": 0.55}
#: Style of the ring's line under inertia alone.
INERTIA: dict[str, Any] = {"color": GRAY, "linewidth": 0.9, "linestyle": (0, (4, 3))}
#: Dashes of the supports of a panel, in addition to their colors.
DASHES: tuple[Any, ...] = (
    "-", (0, (5, 1.5)), (0, (2, 1)), (0, (9, 1.5, 2, 1.5)), (0, (1, 1)), (0, (5, 1.5, 1, 1.5)),
)  # fmt: skip


def over(rods: xr.Dataset, axis: str) -> xr.Dataset:
    """The rods over their lengths or over their angles; the other quantity is the same for all of them."""
    return rods.isel(rod=rods.sweep.values == axis)


def common_value(rods: xr.Dataset, axis: str) -> float:
    """Value of the quantity, length or angle, that the rods over the other one have in common."""
    (other,) = {*AXES} - {axis}
    return float(over(rods, other)[axis][0])


def cuts(rods: xr.Dataset, supports: xr.Dataset) -> tuple[str, str, str]:
    """Common rod length, common rod angle, and the ring with its radius, as text for a caption."""
    length, angle = (number(common_value(rods, axis)) for axis in AXES)
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
    colors: Mapping[str, str],
    rows: Sequence[Sequence[str]],
    heights: Callable[[xr.Dataset, str, str], Array],
) -> Iterator[Panel]:
    """Draw rows of panels, each with some of the supports over rod length and over rod angle.

    `colors` are those of the supports. `heights(rods, axis, prefix)` are those in the panel over an axis;
    the prefix is that of the variables of the ring, or empty.
    """
    axes = figure.subplots(len(rows), len(AXES), squeeze=False)
    inch = 1 / figure.get_figheight()
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.42 * inch, top=1 - 0.16 * inch,
                           hspace=0.16, wspace=0.2)  # fmt: skip
    pairs = ((ax, axis, names) for names, row in zip(rows, axes, strict=True)
             for ax, axis in zip(row, AXES, strict=True))  # fmt: skip
    for letter, (ax, axis, names) in zip(LETTERS, pairs, strict=False):
        part = over(rods, axis)
        looks = [(name, colors[name], DASHES[i % len(DASHES)]) for i, name in enumerate(names)]
        ax.plot(part[axis], heights(part, axis, "ring_"), label="ring", **BEHIND)
        for name, color, dash in looks:
            y = heights(part.sel(support=name), axis, "")
            ax.plot(part[axis], y, color=color, linestyle=dash, label=words(name))
        _frame(ax, rods, axis, named=names is rows[-1])
        ax.set_title(f"({letter})", loc="left", pad=2.0, color=DARK)
        yield Panel(ax, axis, looks)


def _frame(ax: Any, rods: xr.Dataset, axis: str, *, named: bool) -> None:
    if axis == "rod_length":
        lengths = over(rods, axis).rod_length.values
        ticks = [part * float(rods.radius) for part in (0.1, 0.2, 0.5, 1, 2, 5, 10)]
        ax.set_xscale("log")
        ax.set(xlim=(lengths[0], lengths[-1]), xticks=ticks, xticklabels=[f"{x:g}" for x in ticks])
        ax.set_xticks([], minor=True)
        text = rf"rod length $l$, at $\psi = {common_value(rods, 'rod_angle'):g}^\circ$"
    else:
        ax.set(xlim=(0.0, 180.0), xticks=range(0, 181, 45))
        text = rf"rod angle $\psi$ (degrees), at $l = {common_value(rods, 'rod_length'):g}$"
    if named:
        ax.set_xlabel(text, color=DARK)
    else:
        ax.tick_params(axis="x", labelbottom=False)
