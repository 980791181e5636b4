"""Figure 10: the ellipses of the dynamic case, and a friction cone mapped to an acceleration cone."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts import labels
from planar_pushing.figures.parts.curves import (
    chosen,
    cone_mapping,
    curves,
    family,
    mapping_panels,
    number,
    rod_lengths,
    titled,
)
from planar_pushing.figures.settings import Settings, Sources

#: Where the labels of the ellipses stand, degrees.
LABEL_ANGLE = 330.0


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the ellipses, and the forces and accelerations of the mapping."""
    data = curves(sources["motion_cones"], "inertia", rod_lengths(settings, (0.5, 1.0, 2.0, 5.0)))
    mapped = chosen(settings.mapped_rod_length, 1.0)
    friction = chosen(settings.friction_coefficient, 5.0)
    data = data.merge(cone_mapping(sources["motion_cones"], "inertia", mapped, friction))
    return titled(data, "Ellipses of the dynamic case and an acceleration cone", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the three panels, forces and accelerations numbered alike in all of them."""
    ellipses = np.stack([data.force_x, data.force_y], axis=-1)
    titles = (
        rf"friction cone, $\mu = {number(float(data.friction_coefficient))}$",
        "ellipses of several rod lengths",
        rf"acceleration cone, $l = {number(float(data.mapped_rod_length))}$",
    )
    ax = mapping_panels(figure, data, list(ellipses), "a", titles)
    family(ax, data, LABEL_ANGLE, "left", bold=float(data.mapped_rod_length))
    labels.declutter(ax)
