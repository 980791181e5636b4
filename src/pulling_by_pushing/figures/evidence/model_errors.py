"""Which effects a push calls for: errors without one, what both cost, and an estimate against the error."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from matplotlib.axes import Axes

from planar_pushing.assessment.estimate import FACTOR
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, GRAY, MOTION, PUSHER
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import number
from pulling_by_pushing.figures.figure import Data, Figure

FIGURE = Figure(
    title="Which effects a push calls for",
    reads=("model_errors", "model_estimates"),
    size=(PAGE, 2.75),
    section="Ours, motion over time",
)
#: Colors of the supports, and their names, from the one on which the box turns most easily.
SUPPORTS = {
    "disc": (FORCE, "small disc"),
    "ring": ("#8F6400", "ring"),
    "base": (MOTION, "whole base"),
    "feet": (PUSHER, "four feet"),
}
#: Colors and markers of the effects that are left out, and their names, from the one drawn first.
EFFECTS = {
    "viscous": ("#1B7837", "^", "viscous friction"),
    "load": (MOTION, "s", "a load"),
    "inertia": (CENTER, "o", "inertia"),
}
#: Support, and speeds in m/s, at which the error of the first push is marked.
MARKED, SPEEDS = "base", (0.05, 0.2)
#: Error that is called small, m, and the parts of the pushes between which the bands extend.
SMALL, BAND = 1e-3, (0.1, 0.9)
DASHES, MILLI = (0, (4, 1.5)), 1e3
#: Limits of errors, of evaluations and of estimates.
ERRORS, COUNTS, ESTIMATES = (1e-4, 1e3), (50.0, 5e4), (1e-3, 1e4)
#: Heights of the panels' upper ends and of their titles, as fractions of the figure's.
TOPS, TITLE = (0.79, 0.9, 0.9), 0.945


def caption(data: Data) -> str:
    """Caption of the figure."""
    errors, estimates = data["model_errors"], data["model_estimates"]
    sides, way = (number(float(errors[name])) for name in ("length", "width")), errors.distance
    first = errors.isel(push=0)
    marked = [f"{number(value, 2)} mm at {number(speed)} m/s" for speed, value in _marked(errors)]
    return (
        f"Which effects a push calls for. (a) Largest displacement of a corner of a box of "
        f"{' m × '.join(sides)} m, which a finger pushes over {number(float(way))} m, if inertia (solid) "
        f"or friction (dashed) is left out: median of {errors.sizes['push']} pushes, with a band from "
        f"{BAND[0] * 100:.0f} to {BAND[1] * 100:.0f} percent; μₛ = "
        f"{number(float(errors.support_friction_coefficient))}, μ = "
        f"{number(float(errors.friction_coefficient))}. Dotted: the length v²/(2μₛg) over which the box "
        f"coasts, on the upper axis over the way of the finger. Circles: on the whole base, pushed "
        f"{number(float(first.place))} m from the middle at {number(float(first.pusher_angle))}°, "
        f"{' and '.join(marked)} without inertia. (b) Evaluations of the motion with both effects, and "
        f"with one alone (dashed). (c) Error against its estimate from the run without the effect, "
        f"for {estimates.sizes['push']} random pushes; the line is {number(FACTOR)} times the estimate, "
        f"dotted the estimate. Errors below {number(ERRORS[0])} mm are at the lower edge."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw errors over the speed, evaluations over the speed, and errors against estimates."""
    left, middle, right = figure.subplots(1, 3, width_ratios=(1.2, 0.85, 1.0))
    figure.subplots_adjust(left=0.07, right=0.975, bottom=0.15, wspace=0.36)
    titles = "(a) an effect is left out", "(b) friction and inertia", "(c) random pushes"
    for ax, top, title in zip((left, middle, right), TOPS, titles, strict=True):
        x, y, width, _ = ax.get_position().bounds
        ax.set_position((x, y, width, top - y))
        figure.text(x, TITLE, title, fontsize=8.5)
    _draw_errors(left, data["model_errors"])
    _draw_evaluations(middle, data["model_errors"])
    _draw_estimates(right, data["model_estimates"])


def coasting_length(errors: xr.Dataset, speed: Any) -> Any:
    """Length v^2/(2 mu_s g) over which a box coasts on its friction, m."""
    deceleration = errors.support_friction_coefficient * errors.gravity
    return speed**2 / (2.0 * float(deceleration))


def _marked(errors: xr.Dataset) -> list[tuple[float, float]]:
    """Speeds, m/s, and errors without inertia, mm, of the first push."""
    pushed = errors.pose_error.sel(support=MARKED, left_out="inertia").isel(push=0)
    return [(speed, MILLI * float(pushed.sel(speed=speed))) for speed in SPEEDS]


def _draw_errors(ax: Axes, errors: xr.Dataset) -> None:
    """Draw errors without inertia, with a band, and without friction, over the speed."""
    speeds = errors.speed.values
    ax.axhspan(ERRORS[0], SMALL * MILLI, color="#EFEFEF", linewidth=0, zorder=0)
    for name, (color, _) in SUPPORTS.items():
        millimeters = MILLI * errors.pose_error.sel(support=name)
        inertia, friction = (millimeters.sel(left_out=each) for each in ("inertia", "friction"))
        low, high = (inertia.quantile(part, "push").values for part in BAND)
        ax.fill_between(speeds, low, high, color=color, alpha=0.13, linewidth=0, zorder=1)
        ax.plot(speeds, inertia.median("push"), color=color, zorder=3)
        ax.plot(
            speeds, friction.median("push"), color=color, linestyle=DASHES, linewidth=0.9, zorder=2
        )
    ax.plot(
        speeds, MILLI * coasting_length(errors, speeds), ":", color=DARK, linewidth=1.0, zorder=4
    )
    ax.plot(*zip(*_marked(errors), strict=True), "o", color=DARK, markerfacecolor="white", zorder=5)
    _set_speeds(ax, speeds)
    ax.set(yscale="log", ylim=ERRORS, ylabel="error of the pose (mm)")
    for text, place, align in (
        ("within 1 mm", (0.97, 0.035), "right"),
        ("without inertia", (0.36, 0.17), "left"),
        ("without friction", (0.04, 0.87), "left"),
        (r"$v^2\!/(2\mu_s g)$", (0.745, 0.925), "right"),
    ):
        ax.text(*place, text, transform=ax.transAxes, fontsize=NOTE, ha=align)
    _add_coasting(ax, errors)


def _add_coasting(ax: Axes, errors: xr.Dataset) -> None:
    """Add the upper axis: the coasting length as a part of the way."""
    way = float(errors.distance)

    def parts(speed: npt.ArrayLike) -> Array:
        return np.asarray(coasting_length(errors, np.asarray(speed)) / way)

    def speeds(part: npt.ArrayLike) -> Array:
        return np.asarray(np.sqrt(np.asarray(part) * way / float(coasting_length(errors, 1.0))))

    upper = ax.secondary_xaxis("top", functions=(parts, speeds))
    upper.set_xlabel(r"$v^2/(2\mu_s g)$ over the way", fontsize=NOTE)
    first, last = np.log10(parts(np.asarray(ax.get_xlim())))
    upper.set_xticks(10.0 ** np.arange(np.ceil(first), np.floor(last) + 1))
    upper.minorticks_off()


def _draw_evaluations(ax: Axes, errors: xr.Dataset) -> None:
    """Draw evaluations with both effects and with friction alone over the speed."""
    speeds = errors.speed.values
    for name, (color, label) in SUPPORTS.items():
        counts = errors.sel(support=name)
        alone = counts.evaluations_alone.sel(left_out="inertia").median("push")
        ax.plot(speeds, counts.evaluations.median("push"), color=color, label=label)
        ax.plot(speeds[[0, -1]], [alone, alone], color=color, linestyle=DASHES, linewidth=0.9)
    inertia = float(errors.evaluations_alone.sel(left_out="friction").median())
    ax.axhline(inertia, color=GRAY, linestyle=(0, (6, 1.5, 1, 1.5)), linewidth=0.9, zorder=1)
    _set_speeds(ax, speeds)
    ax.set(yscale="log", ylim=COUNTS, ylabel="evaluations of the motion")
    ax.annotate(
        "inertia alone", (speeds[0], inertia), (3, 3), textcoords="offset points", fontsize=NOTE
    )
    ax.legend(loc="upper right", borderaxespad=0.0, labelspacing=0.3)
    ax.text(0.035, 0.03, "friction alone", transform=ax.transAxes, fontsize=NOTE)


def _draw_estimates(ax: Axes, estimates: xr.Dataset) -> None:
    """Draw errors against estimates, with the line of the largest error that is expected."""
    for name, (color, marker, label) in EFFECTS.items():
        row = estimates.sel(effect=name)
        errors = np.maximum(MILLI * row.pose_error.values, ERRORS[0])
        ax.plot(MILLI * row.estimate.values, errors, marker, color=color, markersize=2.2,
                markeredgewidth=0, alpha=0.5)  # fmt: skip
        ax.plot([], [], marker, color=color, markersize=3.5, markeredgewidth=0, label=label)
    ends = np.array(ESTIMATES)
    ax.plot(ends, FACTOR * ends, color=DARK, linewidth=0.9)
    ax.plot(ends, ends, ":", color=GRAY, linewidth=0.9)
    ax.set(xscale="log", yscale="log", xlim=ESTIMATES, ylim=ERRORS)
    ax.set(xlabel="estimate without the effect (mm)", ylabel="error of the pose (mm)")
    ax.legend(loc="lower right", handletextpad=0.1, borderaxespad=0.0, labelspacing=0.3)


def _set_speeds(ax: Axes, speeds: Array) -> None:
    """Set the axis of speeds."""
    ax.set(xscale="log", xlim=(speeds[0], speeds[-1]), xlabel="speed of the finger (m/s)")
