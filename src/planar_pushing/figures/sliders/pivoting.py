"""Motion over time of a slider on points: its pictures at some instants, and its motion center."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.motion.timeline import motion_center, rows
from planar_pushing.figures.parts import drawing, labels
from planar_pushing.figures.parts.arrows import unit
from planar_pushing.figures.parts.curves import named
from planar_pushing.figures.style import CENTER, DARK, FENCE, NOTE_SIZE, SLIDER
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Points

#: Instants at which the slider is drawn, and how much of its color the first of them keeps.
COUNT, PALEST = 3, 0.3
#: Half the width of the fence.
HALF = 0.8
#: Columns of a log that the picture shows.
SHOWN = ("position", "fence", "rod_angle")


def motion(log: xr.Dataset, points: Points, radius: float) -> xr.Dataset:
    """Select the motion, its motion center, and how far that is from the point that it comes to."""
    data = log[list(SHOWN)].rename({name: f"path_{name}" for name in SHOWN}).drop_attrs(deep=False)
    data["path_center"] = motion_center(log)
    data["support_point"] = named(
        ("point", "xy"), points.positions, "length", "support point in the body frame"
    )
    gaps = np.stack(
        [np.hypot(*(_point(data, i) - data.path_center.values).T) for i in _numbers(data)]
    )
    last = int(np.argmin(gaps[:, -1]))
    data["pivot_point"] = named((), last, "1", "number of the support point that is the last pivot")
    text = "distance of the motion center from the last pivot"
    data["center_distance"] = named("time", gaps[last], "length", text)
    return data


def _numbers(data: xr.Dataset) -> range:
    return range(data.sizes["point"])


def _point(data: xr.Dataset, number: int) -> Array:
    """Place of a support point over time."""
    x, y = data.support_point.values[number]
    angle = np.deg2rad(data.path_rod_angle.values)
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(data.path_position.values + np.stack([c * x - s * y, s * x + c * y], axis=-1))


def snapshots(figure: Figure, data: xr.Dataset, rect: tuple[float, float, float, float]) -> None:
    """Slider and fence at some instants, paler the earlier, and the path of the motion center."""
    chosen = rows(data, COUNT)
    feet = np.stack([_point(data, number) for number in _numbers(data)])
    ax = drawing.schematic(figure, _box(data, feet[:, chosen]), rect=rect, pad=8.0)
    for strength, row in zip(np.linspace(PALEST, 1.0, COUNT), chosen, strict=True):
        _slider(ax, data, feet[:, row], row, float(strength))
    ax.plot(*data.path_center.values.T, color=CENTER, linewidth=1.0, dashes=(3, 1.5), zorder=2.5)
    drawing.center_mark(ax, data.path_center.values[-1], size=5.5)
    for number in _numbers(data):
        away = feet[number, 0] - data.path_position.values[0]
        offset = tuple(8.0 * away / np.hypot(*away))
        labels.label(ax, feet[number, 0], str(number), offset=offset, size=NOTE_SIZE)


def _box(data: xr.Dataset, feet: Array) -> tuple[float, float, float, float]:
    points = [*feet.reshape(-1, 2), *data.path_center.values]
    points += [(x + side, y) for x, y in data.path_fence.values[[0, -1]] for side in (-HALF, HALF)]
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _slider(ax: Axes, data: xr.Dataset, feet: Array, row: int, strength: float) -> None:
    """Rod, feet and fence at one row."""
    center, (x, y) = data.path_position.values[row], data.path_fence.values[row]
    color = drawing.tint(SLIDER, strength)
    contact = center - float(data.rod_length) * unit(float(data.path_rod_angle[row]))
    for foot in feet:
        ax.plot(*np.stack([center, foot]).T, color=color, linewidth=0.6, zorder=3)
    ax.plot(*np.stack([contact, center]).T, color=color, linewidth=1.0, zorder=3)
    ax.plot(*feet.T, "o", color=color, markersize=4.5, zorder=4)
    drawing.dot(ax, contact, color=color, size=3.0)
    ends = [x - HALF, x + HALF]
    ax.plot(ends, [y, y], color=drawing.tint(FENCE, strength), linewidth=1.0, zorder=2)


def distance_over_time(ax: Axes, data: xr.Dataset) -> None:
    """How far the motion center is from the point that it comes to."""
    ax.plot(data.time, data.center_distance, color=CENTER)
    ax.set(xlim=(float(data.time[0]), float(data.time[-1])), ylim=(0.0, None))
    ax.set_xlabel("time")
    ax.locator_params(axis="x", nbins=5)
    ax.set_ylabel(f"motion centre\nfrom foot {int(data.pivot_point)}", color=DARK)
