"""Figure 4: the two coordinate systems."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.shown import shown
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import CENTER, DARK, FORCE


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the force and the velocity center of quasi-static pushing."""
    scene = shown(sources["scenes/figure_02"]).isel(solution=0)
    names = ["rod_length", "rod_angle", "radius", "ring_center", "force", "center"]
    return scene[names].assign_attrs(title="Coordinate systems (Fig. 4)")


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider, fence and force under the two pairs of axes."""
    ring, radius = data["ring_center"].values, float(data["radius"])
    force, center = data["force"].values, data["center"].values
    phi = float(np.rad2deg(np.arctan2(force[1], force[0])))
    top, long = float(ring[1] + 1.9 * radius), 1.75 * radius
    ax = drawing.schematic(figure, (-0.9, ring[0] + long, -0.2, top), pad=10.0)
    drawing.fence(ax, -0.9, 0.8 * long, depth=0.14 * radius)
    drawing.slider(ax, ring, radius)
    arrows.coordinate_axes(ax, (0, 0), 0, 1.2 * long, ("$x$", "$y$"), color=DARK)
    arrows.coordinate_axes(ax, ring, phi - 90, long, ("$x$\N{PRIME}", "$y$\N{PRIME}"), color=DARK)
    arrows.force_arrow(ax, (0, 0), 1.6 * arrows.unit(phi), r"$\mathbf{f}$")
    drawing.angle_arc(ax, (0, 0), 0, phi, 0.7, r"$\phi$", color=FORCE, at=0.3)
    aside = arrows.unit(phi)
    drawing.center_mark(
        ax, center, r"$-v/\omega$", offset=(-12 * aside[0], -12 * aside[1]), color=CENTER
    )
    labels.label(ax, 0.5 * ring, "$l$", offset=(6.0, -6.0))
    labels.declutter(ax)
