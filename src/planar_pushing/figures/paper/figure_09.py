"""Figure 9: acceleration centers and acceleration cones, two coefficients of friction."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import CENTER, FORCE, MOTION
from planar_pushing.terms.quantities import described

PANELS = ("a", "b")
BOX = (-2.0, 4.1, -1.0, 4.3)


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select geometry, cones, and the centers dual to the edges of the friction cone."""
    panels = [_panel(sources[name]) for name in sorted(sources)]
    data = xr.concat(panels, xr.DataArray(list(PANELS), dims="panel", name="panel"), join="exact")
    data["panel"].attrs = {"units": "1", "long_name": "panel of the figure"}
    data.attrs = {"title": "Acceleration cones and centers (Fig. 9)"}
    return data


def _panel(scene: xr.Dataset) -> xr.Dataset:
    names = ["rod_length", "rod_angle", "radius", "ring_center"]
    names += [
        f"{kind}_cone_{side}" for kind in ("friction", "motion") for side in ("right", "left")
    ]
    data = scene[names]
    centers = scene["cone_center"].sel(effect="inertia", drop=True)
    for side, sample in (("right", 0), ("left", -1)):
        long_name = f"acceleration center of the {side} edge of the friction cone"
        attrs = described("length", long_name)
        data[f"center_{side}"] = centers.isel(cone_sample=sample).assign_attrs(attrs)
    half = np.deg2rad(90 - float(scene["friction_cone_right"]))
    mu = float(np.tan(half)) if half < np.pi / 2 else np.inf
    attrs = {"units": "1", "long_name": "coefficient of friction at the contact"}
    data["friction_coefficient"] = ((), mu, attrs)
    return data


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw a panel for each coefficient of friction."""
    width = 1 / data.sizes["panel"]
    for number, name in enumerate(data["panel"].values):
        ax = drawing.schematic(figure, BOX, rect=(number * width, 0.06, width, 0.94), pad=9.0)
        panel = data.sel(panel=name)
        _slider_and_cones(ax, panel)
        _line_of_centers(ax, panel)
        labels.declutter(ax)
        mu = float(panel["friction_coefficient"])
        value = f"{mu:.4g}" if np.isfinite(mu) else r"\infty"
        ax.text(0.5, -0.03, rf"({name})  $\mu = {value}$", transform=ax.transAxes, ha="center")


def _slider_and_cones(ax: Axes, panel: xr.Dataset) -> None:
    drawing.fence(ax, *BOX[:2], depth=0.14)
    drawing.slider(ax, panel["ring_center"].values, float(panel["radius"]))
    force = [float(panel[f"friction_cone_{side}"]) for side in ("right", "left")]
    motion = [float(panel[f"motion_cone_{side}"]) for side in ("right", "left")]
    drawing.cone(ax, (0, 0), motion[0], motion[1], 1.1, MOTION)
    drawing.cone(ax, (0, 0), force[0], force[1], 0.8, FORCE)
    for right_or_left, angle in zip("rl", force, strict=True):
        arrows.force_arrow(ax, (0, 0), 1.4 * arrows.unit(angle), rf"$\mathbf{{f}}_{right_or_left}$")
    for right_or_left, angle in zip("rl", motion, strict=True):
        arrows.motion_arrow(
            ax, (0, 0), 1.55 * arrows.unit(angle), rf"$\mathbf{{a}}_{right_or_left}$"
        )


def _line_of_centers(ax: Axes, panel: xr.Dataset) -> None:
    """Draw the line of centers, and on it what lies between the duals of the cone's edges."""
    right, left = panel["center_right"].values, panel["center_left"].values
    psi = float(panel["rod_angle"])
    along = arrows.unit(psi + 90)
    ends = [right + reach * along for reach in _reaches(right, along)]
    drawing.guide(ax, *ends, color=CENTER)
    if not float(panel["friction_cone_right"]) < psi < float(panel["friction_cone_left"]):
        _allowed(ax, right, left)
    else:
        # A force along the rod translates the slider: the centers pass through infinity.
        for start, stop, sign in ((right, ends[1], 1.0), (left, ends[0], -1.0)):
            _allowed(ax, start, stop)
            at = 0.3 * start + 0.7 * stop
            arrows.turning(ax, at, sign, 0.22)
            labels.label(ax, at, "$+$" if sign > 0 else "$-$", offset=(12.0, 12.0), color=CENTER)
    _marks(ax, right, left)


def _reaches(point: np.ndarray, along: np.ndarray) -> tuple[float, float]:
    """Signed distances along a line from a point to the two sides of the picture."""
    low, high = np.array(BOX[::2]), np.array(BOX[1::2])
    with np.errstate(divide="ignore"):
        to_low, to_high = (low - point) / along, (high - point) / along
    near, far = np.minimum(to_low, to_high), np.maximum(to_low, to_high)
    return float(np.max(near)), float(np.min(far))


def _allowed(ax: Axes, start: np.ndarray, stop: np.ndarray) -> None:
    ax.plot(*np.stack([start, stop], axis=1), color=CENTER, linewidth=2.0, zorder=4)


def _marks(ax: Axes, right: np.ndarray, left: np.ndarray) -> None:
    if np.allclose(right, left):
        drawing.center_mark(ax, right, "$c_r = c_l$", offset=(20.0, 6.0))
    else:
        drawing.center_mark(ax, right, "$c_r$", offset=(9.0, 5.0))
        drawing.center_mark(ax, left, "$c_l$", offset=(9.0, 5.0))
