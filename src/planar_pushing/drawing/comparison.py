"""Errors of friction models on measured pushes: medians, 90th percentiles, and ratios."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import cycle
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.drawing.canvas.colors import DARK, GRAY
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.terms.errors import InvalidValue


class Look(NamedTuple):
    """Name and style of a model; ellipsoids are hollow diamonds, and quartics hollow triangles."""

    name: str
    color: str
    marker: str = "o"


#: Styles of the models of `compare`; their colors differ in gray level.
LOOKS: dict[str, Look] = {
    "known_feet": Look("known feet", "#0A2E66"),
    "identified": Look("identified pressure", "#B5400A"),
    "uniform": Look("uniform pressure", "#3E5A2A"),
    "known_feet_ellipsoid": Look("ellipsoid of known feet", "#3C86CC", "D"),
    "uniform_ellipsoid": Look("ellipsoid of uniform pressure", "#A1934A", "D"),
    "fitted_quartic": Look("fitted quartic", "#C0408F", "^"),
    "fitted_ellipsoid": Look("fitted ellipsoid", "#1C1C1C", "D"),
}
#: Markers of limit surfaces without a pressure.
HOLLOW = ("D", "^")
#: Colors of models given by the user.
OTHERS = ("#8A3C70", "#00838F", "#5E4A80", GRAY)
#: Quantities of `compare`: title, and the attribute with the unit of the errors.
QUANTITIES = {
    "wrench": ("wrench from motion", "angle_units"),
    "motion": ("motion from force", "angle_units"),
    "pose": ("final pose", "pose_units"),
}
#: Plotted variables over (quantity, model).
NEEDED = ("median", "percentile_90", "ratio")
#: Width of the column of ratios, points.
COLUMN = 52.0
#: Sizes in inches: a row, the space above and below the rows, the model names, an axis, its ratios.
ROW, AROUND, NAMES, AXIS, RATIOS = 0.165, 0.5, 1.65, 1.3, 0.85


def plot_comparison(dataset: xr.Dataset, ax: Any = None) -> list[Axes]:
    """Draw the errors of friction models on measured pushes, one panel for each quantity.

    A marker is the median error, a thick line its 95 percent interval, and a thin line ends at the 90th
    percentile. To the right is the ratio of the median to that of the ellipsoid fitted to the same pushes,
    with its interval. Circles are pressures, hollow diamonds are ellipsoids, and the hollow triangle is the
    quartic.

    Parameters
    ----------
    dataset : xarray.Dataset
        Returned by `compare`.
    ax : matplotlib.axes.Axes or sequence of Axes, optional
        Axes to draw on, one for each quantity with values; by default those of a new figure.

    Returns
    -------
    list of matplotlib.axes.Axes
        One for each quantity, in the order of the dataset.

    Raises
    ------
    InvalidValue
        If the dataset is not a comparison or contains no errors, or the number of axes is wrong.
    """
    parts = by_quantity(_require_comparison(dataset))
    with paper_style():
        axes = _new_axes(parts) if ax is None else _require_axes(ax, list(parts))
        for number, (axis, errors) in enumerate(zip(axes, parts.values(), strict=True)):
            panel(axis, errors, named=number == 0 or ax is not None)
            axis.set_title(title(errors))
    return axes


def by_quantity(dataset: xr.Dataset) -> dict[str, xr.Dataset]:
    """Quantities that have values, each with the models that have values."""
    parts = {}
    for name in map(str, dataset["quantity"].values):
        errors = dataset.sel(quantity=name)
        rows = np.flatnonzero(np.isfinite(errors["median"].values))
        if len(rows):
            parts[name] = errors.isel(model=rows)
    return parts


def title(errors: xr.Dataset) -> str:
    """Name of a quantity with the unit of its error."""
    name, key = QUANTITIES.get(str(errors["quantity"].item()), (str(errors["quantity"].item()), ""))
    unit = {"degree": "degrees"}.get(str(errors.attrs.get(key)), str(errors.attrs.get(key, "")))
    return f"{name} ({unit})" if unit else name


def looks(models: Iterable[str]) -> dict[str, Look]:
    """Styles of models by name; models given by the user take the other colors in turn."""
    free = cycle(OTHERS)
    return {
        name: LOOKS.get(name) or Look(name.replace("_", " "), next(free), "s") for name in models
    }


def panel(ax: Axes, errors: xr.Dataset, *, named: bool = True) -> None:
    """Draw the errors of one quantity, with a row for each model and the first at the top."""
    styles = looks(map(str, errors["model"].values))
    median, most = errors["median"].values, errors["percentile_90"].values
    low, high = _interval(errors, "median")
    for row, look in enumerate(styles.values()):
        face = "white" if look.marker in HOLLOW else look.color
        ax.plot([median[row], most[row]], [row, row], color=look.color, lw=0.8, zorder=2)
        ax.plot(most[row], row, "|", color=look.color, ms=6, mew=1.2, zorder=2)
        ax.plot([low[row], high[row]], [row, row], color=look.color, lw=2.6, zorder=3,
                solid_capstyle="butt")  # fmt: skip
        ax.plot(
            median[row], row, look.marker, color=look.color, mfc=face, ms=4.2, mew=1.1, zorder=4
        )
    ax.set(ylim=(len(styles) - 0.4, -0.6), xlim=(0.0, 1.06 * float(np.nanmax([*most, *median]))))
    ax.set_yticks(range(len(styles)), [look.name if named else "" for look in styles.values()])
    ax.tick_params(axis="y", length=0)
    ax.minorticks_off()
    ax.locator_params(axis="x", nbins=4)
    ax.grid(True, axis="x")
    ax.set_axisbelow(True)
    _ratios(ax, errors)


def _ratios(ax: Axes, errors: xr.Dataset) -> None:
    """Write the ratios to the reference to the right of the rows, with a heading above."""
    low, high = _interval(errors, "ratio")
    for row, ratio in enumerate(errors["ratio"].values):
        sure = np.isfinite([low[row], high[row]]).all() and low[row] < high[row]
        text = f"{ratio:.2f} ({low[row]:.2f}\N{EN DASH}{high[row]:.2f})" if sure else f"{ratio:.2f}"
        ax.annotate(text, (1.04, row), xycoords=("axes fraction", "data"), fontsize=NOTE - 0.5,
                    color=DARK, va="center", annotation_clip=False)  # fmt: skip
    ax.annotate("ratio", (1.04, 1.0), (COLUMN, 4.0), xycoords="axes fraction", textcoords="offset points",
                fontsize=NOTE - 0.5, color=GRAY, ha="right", va="baseline",
                annotation_clip=False)  # fmt: skip


def _interval(errors: xr.Dataset, name: str) -> tuple[Any, Any]:
    """Ends of an interval, NaN if the dataset has none."""
    known = f"{name}_interval" in errors
    ends = (
        errors[f"{name}_interval"].values if known else np.full((errors.sizes["model"], 2), np.nan)
    )
    return ends[:, 0], ends[:, 1]


def _require_comparison(dataset: Any) -> xr.Dataset:
    """Return a comparison that contains errors, or raise `InvalidValue`."""
    allowed, remedy = "a dataset returned by compare", "call compare on pushes first"
    if not isinstance(dataset, xr.Dataset):
        raise InvalidValue("dataset", type(dataset).__name__, allowed, remedy)
    lacking = [name for name in NEEDED if name not in dataset]
    lacking += [dim for dim in ("quantity", "model") if dim not in dataset.coords]
    if lacking:
        raise InvalidValue("dataset", f"one without {lacking[0]}", allowed, remedy)
    if not np.isfinite(dataset["median"].values).any():
        raise InvalidValue("dataset", "no errors", "errors of a model", "compare other pushes")
    return dataset


def _new_axes(parts: dict[str, xr.Dataset]) -> list[Axes]:
    """Axes side by side on a figure that notebooks and windows display."""
    import matplotlib.pyplot as plt

    rows, width = max(errors.sizes["model"] for errors in parts.values()), AXIS + RATIOS
    wide, high = NAMES + len(parts) * width, ROW * rows + AROUND
    figure = plt.figure(figsize=(wide, high))
    return [
        figure.add_axes(((NAMES + k * width) / wide, 0.22 / high, AXIS / wide, ROW * rows / high))
        for k in range(len(parts))
    ]


def _require_axes(ax: Any, quantities: Sequence[str]) -> list[Axes]:
    """Return the given axes, one for each quantity, or raise `InvalidValue`."""
    axes = [ax] if isinstance(ax, Axes) else list(np.ravel(np.asarray(ax, dtype=object)))
    if len(axes) != len(quantities) or not all(isinstance(axis, Axes) for axis in axes):
        allowed = f"{len(quantities)} axes, for {', '.join(quantities)}"
        raise InvalidValue(
            "ax", f"{len(axes)} axes", allowed, "give one for each quantity, or none"
        )
    return axes
