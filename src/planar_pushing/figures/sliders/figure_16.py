"""Figure 16: limit curves of the gallery beside the ring's."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing
from planar_pushing.figures.parts.curves import named, titled
from planar_pushing.figures.parts.supports import Ink, Pose, draw_support
from planar_pushing.figures.settings import Sources
from planar_pushing.figures.sliders.flats import FLAT, limit_line
from planar_pushing.figures.sliders.gallery import (
    RING,
    described_supports,
    limit_forces,
    scene,
    supports,
)
from planar_pushing.figures.style import DARK, FORCE, GREY
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.study.datasets.base import words
from planar_pushing.study.files.study_model import SliderEntry

#: Force angles of a curve, degrees.
ANGLES = np.linspace(0.0, 360.0, 721)
COLUMNS = 4
#: Half the width of a panel, and the radius of the slider's picture, in units of the largest force.
SPAN, SKETCH = 1.3, 0.24
#: Width of the sketches' outlines, points.
OUTLINE = 0.9
#: How the ring's curve is drawn.
OF_RING: dict[str, Any] = {"color": GREY, "linewidth": 0.8, "linestyle": "--"}
ACROSS = {"x": "along", "y": "normal to"}


def select(sources: Sources, settings: SliderEntry) -> xr.Dataset:
    """Compute the curves, which of their forces pivot, and the ring's curve."""
    grid = sources["supports"]
    rod = settings.rod_length, settings.rod_angle, InfiniteFriction()
    forces, pivots = limit_forces(scene(supports(grid), *rod), ANGLES)
    ring, _ = limit_forces(scene({"ring": RING}, *rod), ANGLES)
    data = described_supports(grid, settings)
    dims = ("support", "force_angle")
    for i, (name, text) in enumerate(ACROSS.items()):
        what = f"force {text} the fence on the limit curve"
        data[f"force_{name}"] = named(dims, forces[..., i], "force", what)
        data[f"ring_force_{name}"] = named(dims[1:], ring[0, :, i], "force", f"{what} of the ring")
    text = "number of the support point about which the slider pivots, -1 without one"
    data["pivot"] = named(dims, pivots, "1", text)
    data = data.assign_coords(force_angle=named("force_angle", ANGLES, "degree", "force angle"))
    return titled(data, "Limit curves of every support", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw a panel for each support, and one that names the lines."""
    found = supports(data)
    rows = math.ceil((len(found) + 1) / COLUMNS)
    ahead = max(float(np.abs(data[f"{of}force_{x}"]).max()) for of in ("", "ring_") for x in "xy")
    span = SPAN * ahead
    for place, name in enumerate([*found, ""]):
        row, column = divmod(place, COLUMNS)
        rect = (column / COLUMNS, 1 - (row + 1) / rows, 1 / COLUMNS, 1 / rows)
        ax = drawing.schematic(figure, (-span, span, -span, span), rect=rect, pad=3.0)
        if not name:
            _legend(ax)
            continue
        _curve(ax, data.sel(support=name))
        _slider(ax, found[name], data.sel(support=name), ahead)
        ax.text(-span, span, words(name), ha="left", va="top", color=DARK)


def _curve(ax: Axes, one: xr.Dataset) -> None:
    """The curve with its flats, and the ring's behind it."""
    ax.plot(one.ring_force_x, one.ring_force_y, zorder=2, **OF_RING)
    limit_line(ax, np.stack([one.force_x, one.force_y], axis=-1), one.pivot.values)


def _legend(ax: Axes) -> None:
    ax.plot([], [], label="limit curve", color=DARK)
    ax.plot([], [], label="limit curve of a ring", **OF_RING)
    ax.plot([], [], label="flat: one pivot", color=FORCE, linewidth=FLAT)
    ax.legend(loc="center")


def _slider(ax: Axes, support: object, one: xr.Dataset, ahead: float) -> None:
    """The slider with its rod, as it lies above the fence, in the corner that the curves leave free."""
    psi, scale = float(one.rod_angle), SKETCH * ahead / float(one.extent)
    center = ahead * np.array([SPAN - 1.1 * SKETCH, -SPAN + 1.9 * SKETCH])
    foot = center - scale * float(one.rod_length) * arrows.unit(psi)
    ax.plot(*np.stack([foot, center]).T, color=DARK, linewidth=0.7, zorder=3)
    drawing.dot(ax, foot, size=2.5)
    draw_support(ax, support, Pose(center, np.deg2rad(psi), scale), Ink(width=OUTLINE))
