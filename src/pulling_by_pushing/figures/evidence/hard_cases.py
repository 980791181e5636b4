"""The hard cases: their errors in units in the last place, compared with their condition numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from planar_pushing.drawing.canvas.colors import FORCE, GRAY, MOTION
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import number
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Errors of the hard cases",
    reads=("hard_cases",),
    size=(PAGE, 2.4),
)
#: Names of the groups, in the order of `line`.
GROUPS = (
    "center on\nthe ring",
    "translation,\nrotation",
    "lengths,\nangles",
    "cone\nedges",
    "slow,\nfast",
    "rest",
    "slips\nmerge",
    "feet",
    "edges",
    "rims",
    "segments",
    "thin\nshapes",
    "motion",
)
#: Smaller errors, zero included, are drawn at this value.
FLOOR = 0.01
#: Gap between two groups, in cases.
GAP = 4


def positions(lines: Array) -> Array:
    """Abscissa of each case, in order, with gaps between the groups."""
    return np.asarray(np.arange(lines.size) + GAP * (lines.astype(int) - 1))


def caption(data: Data) -> str:
    """Caption of the figure."""
    errors = data["hard_cases"]
    cases, ill = errors.sizes["case"], int((errors.ill_conditioned > 0).sum())
    worst = errors.isel(case=int(np.argmax(errors.condition.values)))
    return (
        f"Errors of the {cases} hard cases in units in the last place (ulp), ordered within each "
        "group from best to worst condition: rings first, then other supports. A stroke is the "
        "condition number: rounding of the inputs causes an error of its order; shaded: up to four ulp. "
        f"Diamonds are the {ill} ill-conditioned "
        "cases, in which rounding the inputs costs six digits or more. "
        f"To read: the highest stroke ({worst.case.item()}) says that rounding can change the result by "
        "that many ulp; the marker below is the error, "
        f"{number(float(worst.error_ulp), 2)} ulp."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw errors as dots and condition numbers as strokes, ordered by condition within each group."""
    cases = data["hard_cases"]
    cases = cases.isel(case=np.lexsort((cases.condition.values, cases.line.values)))
    ax = figure.add_axes((0.075, 0.17, 0.915, 0.72))
    abscissa = positions(cases.line.values)
    error = np.maximum(cases.error_ulp.values, FLOOR)
    ill = cases.ill_conditioned.values > 0
    ax.set(
        yscale="log", xlim=(abscissa[0] - GAP / 2, abscissa[-1] + GAP / 2), ylim=(FLOOR / 1.6, 1e18)
    )
    ax.axhspan(FLOOR / 1.6, 4, color="#E3EEF6", zorder=0, lw=0, label="up to 4 ulp")
    ax.plot(
        abscissa, np.maximum(cases.condition, 1), "_", color=GRAY, ms=3, mew=1.4,
        label="condition number",
    )  # fmt: skip
    ax.plot(abscissa[~ill], error[~ill], "o", color=MOTION, ms=2.6, mew=0, label="error")
    ax.plot(
        abscissa[ill], error[ill], "D", color=FORCE, ms=3.4, mew=0,
        label="error, ill-conditioned",
    )  # fmt: skip
    _decorate(ax, cases.line.values, abscissa)
    ax.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncols=4,
        handletextpad=0.4,
        columnspacing=1.5,
    )


def _decorate(ax: Axes, lines: Array, abscissa: Array) -> None:
    middles = [abscissa[lines == line].mean() for line in range(1, len(GROUPS) + 1)]
    names = [name if "\n" in name else f"{name}\n" for name in GROUPS]
    ax.set_xticks(middles, names)
    ax.tick_params(axis="x", length=0)
    for line in range(2, len(GROUPS) + 1):
        ax.axvline(abscissa[lines == line][0] - (GAP + 1) / 2, color="#D0D0D0", lw=0.5, zorder=0)
    powers = (4, 8, 12, 16)
    ax.set_yticks(
        [FLOOR, 1, *(10**n for n in powers)], ["0", "1", *(f"$10^{{{n}}}$" for n in powers)]
    )
    ax.minorticks_off()
    ax.set_ylabel("error (ulp)")
