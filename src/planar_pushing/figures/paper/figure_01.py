"""Figure 1: the pushing problem, with every symbol.

A contact that slips to the right shows all of them: f on the left edge of the friction cone, v_s on the
left edge of the velocity cone, and v_p half way between that edge and the fence.
"""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.curves import chosen, number, radius, rod_angle, rod_lengths
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK, FORCE, GUIDE, MOTION, NOTE_SIZE, PUSHER

ROD_LENGTH = 3.0
FRICTION_COEFFICIENT = 0.5
SPEED = 2.9
LONG_NAMES = {
    "force_angle": "force angle",
    "slider_angle": "angle of the velocity of the slider's contact",
    "pusher_angle": "angle of the pusher velocity",
}


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select one slipping contact: its force angle and the two velocity angles."""
    cones = sources["motion_cones"]
    row = cones.sel(
        effects="support_friction",
        rod_angle=rod_angle(cones),
        rod_length=rod_lengths(settings, (ROD_LENGTH,))[0],
        friction_coefficient=chosen(settings.friction_coefficient, FRICTION_COEFFICIENT),
    )
    edge = row["motion_cone_left"].variable
    data = xr.Dataset(
        {
            "rod_length": row["rod_length"].variable,
            "rod_angle": row["rod_angle"].variable,
            "radius": radius(cones),
            "force_angle": row["friction_cone_left"].variable,
            "slider_angle": edge,
            "pusher_angle": 0.5 * (edge + 180.0),
        },
        attrs={"title": "The pushing problem (Fig. 1)"},
    )
    for name, words in LONG_NAMES.items():
        data[name].attrs = {"units": "degree", "long_name": words}
    return data


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider and fence with their lengths, vectors and angles."""
    psi, length = float(data["rod_angle"]), float(data["rod_length"])
    ring, size = length * arrows.unit(psi), float(data["radius"])
    ax = drawing.schematic(figure, (-SPEED - 0.2, ring[0] + size, -0.45, ring[1] + size), pad=8.0)
    drawing.fence(ax, -SPEED - 0.2, ring[0] + size, depth=0.16)
    drawing.slider(ax, ring, size)
    _vectors(ax, data)
    _angles(ax, data)
    _lengths(ax, ring, psi, size)
    labels.declutter(ax)


def _vectors(ax: Axes, data: xr.Dataset) -> None:
    pusher, slider = (float(data[f"{name}_angle"]) for name in ("pusher", "slider"))
    speed = SPEED * np.sin(np.deg2rad(pusher)) / np.sin(np.deg2rad(slider))
    force = 2.3 * arrows.unit(float(data["force_angle"]))
    arrows.force_arrow(ax, (0, 0), force, r"$\mathbf{f}$")
    arrows.motion_arrow(ax, (0, 0), speed * arrows.unit(slider), r"$\mathbf{v}_s$")
    arrows.motion_arrow(ax, (0, 0), SPEED * arrows.unit(pusher), r"$\mathbf{v}_p$", color=PUSHER)


def _angles(ax: Axes, data: xr.Dataset) -> None:
    for reach, name, symbol, color, at in (
        (0.5, "rod_angle", rf"${float(data['rod_angle']):g}^\circ$", DARK, 0.5),
        (1.05, "force_angle", r"$\phi$", FORCE, 0.62),
        (1.35, "slider_angle", r"$\theta_s$", MOTION, 0.62),
        (1.65, "pusher_angle", r"$\theta_p$", PUSHER, 0.62),
    ):
        drawing.angle_arc(ax, (0, 0), 0, float(data[name]), reach, symbol, color=color, at=at)


def _lengths(ax: Axes, ring: np.ndarray, psi: float, size: float) -> None:
    aside = arrows.unit(psi - 90)
    labels.label(ax, 0.55 * ring, "$l$", offset=(8 * aside[0], 8 * aside[1]))
    drawing.guide(ax, ring, ring + size * arrows.unit(0), color=DARK, style="-")
    labels.label(ax, ring + 0.5 * size * arrows.unit(0), f"${number(size)}$", offset=(0.0, 7.0))
    labels.label(ax, (0, 0), r"$\mu$", offset=(0.0, -13.0))
    labels.label(ax, ring + size * arrows.unit(90), "slider", offset=(0.0, -12.0), size=NOTE_SIZE)
    labels.label(ax, (-1.6, 0), "pusher", offset=(0.0, -13.0), size=NOTE_SIZE)
    corner = (ring[0] + 0.1, 0.0)
    arrows.coordinate_axes(ax, corner, 0, 0.6, ("$x$", "$y$"), color=GUIDE)
