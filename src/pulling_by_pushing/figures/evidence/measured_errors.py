"""Errors of friction models on measured pushes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.colors import DARK
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.comparison import (
    LOOKS,
    NAMES,
    RATIOS,
    by_quantity,
    panel,
    title,
)
from pulling_by_pushing.figures.figure import Figure
from pulling_by_pushing.figures.measured import PUSHES_FILE

FIGURE = Figure(
    title="Errors of models on measured pushes",
    reads=(PUSHES_FILE,),
    size=(PAGE, 3.6),
)
#: Statistics of a model, and the sizes of their last axes.
STATISTICS = {
    "median": (), "median_interval": (2,), "percentile_90": (), "ratio": (), "ratio_interval": (2,)
}  # fmt: skip
#: Panels in a row; height of a model, and space above and below a row of panels, inches.
COLUMNS, ROW, AROUND = 3, 0.15, 0.42


class Group(NamedTuple):
    """A group of pushes: its section of the file, its comparison there, its name, and a remark."""

    part: str
    key: str
    name: str
    remark: str = ""


#: Groups by rows of panels.
GROUPS = (
    (Group("three_feet", "comparison", "three feet"),),
    (Group("patch", "comparison", "whole face"),),
    (Group("polygons", "comparison", "polygons", ", sides"),
     Group("polygons", "with_corners", "polygons", ", corners too")),
)  # fmt: skip


class Part(NamedTuple):
    """Errors of one quantity in a group of pushes."""

    group: Group
    errors: xr.Dataset


def caption(data: dict[str, Any]) -> str:
    """Caption of the figure."""
    feet, face, polygons = (data[name]["pushes"] for name in ("three_feet", "patch", "polygons"))
    return (
        "Errors of friction models on measured pushes; each half of the pushes is predicted by models "
        "fitted to the other half, sorted by the first median in a row. A marker is the median, a thick "
        "line its 95 percent interval, and a "
        "thin line ends at the 90th percentile. To the right is the ratio of the median to that of the "
        "ellipsoid fitted to the same pushes, with its 95 percent interval. Values for the triangle are "
        f"means over {data['splits']} splits into halves, with intervals that contain pushes, splits, and "
        "fits; those for polygons are of one split, with intervals for given fits. Circles are pressures "
        "with exact mechanics, hollow diamonds are ellipsoids, and the hollow triangle is the convex "
        "quartic, which needs measured forces and is not compared for polygons. The object is a triangle "
        f"on three feet ({feet} pushes) or on its whole face ({face}), or a polygon pushed at a side "
        f"({polygons - data['polygons']['corner_pushes']}), or at a side or a corner ({polygons})."
    )


def parts(data: dict[str, Any]) -> list[list[Part]]:
    """Panels by rows, in each of which the models are in the order of the medians of the first panel."""
    return [_sort([part for group in row for part in _parts(data, group)]) for row in GROUPS]


def _sort(row: list[Part]) -> list[Part]:
    """Panels of a row with their models in the order of the medians of the first one that has them."""
    order: dict[str, None] = {}
    for part in row:
        medians = part.errors["median"].values.ravel()
        order |= dict.fromkeys(part.errors.model.values[np.argsort(medians, kind="stable")])
    return [
        Part(
            part.group,
            part.errors.sel(model=[name for name in order if name in part.errors.model.values]),
        )
        for part in row
    ]


def _parts(data: dict[str, Any], group: Group) -> list[Part]:
    quantities = by_quantity(statistics(data[group.part][group.key], "mm"))
    return [Part(group, errors) for errors in quantities.values()]


def statistics(comparison: Mapping[str, Mapping[str, Any]], unit: str) -> xr.Dataset:
    """A comparison in the file as a dataset like that of `compare`, with models in the order of `LOOKS`."""
    quantities, models = list(comparison), _in_order(comparison.values())
    variables: dict[str, Any] = {}
    for name, rest in STATISTICS.items():
        values = np.full((len(quantities), len(models), *rest), np.nan)
        for i, quantity in enumerate(quantities):
            for j, model in enumerate(models):
                if model in comparison[quantity]:
                    values[i, j] = comparison[quantity][model][name]
        variables[name] = ("quantity", "model", *(["bound"] if rest else [])), values
    return xr.Dataset(
        variables,
        {"quantity": quantities, "model": models},
        {"pose_units": unit, "angle_units": "degree"},
    )


def _in_order(comparisons: Iterable[Mapping[str, Any]]) -> list[str]:
    """Models with a value of some quantity, first those with an entry in `LOOKS`."""
    models = dict.fromkeys(name for models in comparisons for name in models)
    return [name for name in LOOKS if name in models] + [
        name for name in models if name not in LOOKS
    ]


def draw(figure: Any, data: dict[str, Any]) -> None:
    """Draw a panel for each quantity of each group."""
    rows = parts(data)
    wide = figure.get_figwidth()
    heights = [ROW * max(part.errors.sizes["model"] for part in row) for row in rows]
    height = sum(heights) + AROUND * len(rows)
    figure.set_figheight(height)
    for row, high, low in zip(rows, heights, _lows(heights, height), strict=True):
        width = (wide - NAMES) / COLUMNS
        for k, part in enumerate(row):
            left, axis = NAMES + k * width, width - RATIOS
            ax = figure.add_axes((left / wide, low / height, axis / wide, high / height))
            panel(ax, part.errors, named=k == 0)
            ax.set_title(title(part.errors) + part.group.remark, loc="left", fontsize=8)
            if k == 0:
                figure.text(0.07 / wide, (low + high + 0.06) / height, part.group.name, color=DARK,
                            weight="bold")  # fmt: skip


def _lows(heights: list[float], height: float) -> Iterator[float]:
    """Lower edge of the axes of each row, inches from the bottom."""
    top = height
    for high in heights:
        top -= AROUND + high
        yield top + 0.2
