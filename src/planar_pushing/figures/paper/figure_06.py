"""Figure 6: a friction cone, mapped through the limit curve to the velocity cone."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts import labels
from planar_pushing.figures.parts.curves import (
    BUTT,
    chosen,
    cone_mapping,
    curves,
    mapping_panels,
    number,
    rod_lengths,
    titled,
)
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the limit curve and the forces and velocities of the mapping."""
    length = rod_lengths(settings, (2.0,))[0]
    data = curves(sources["motion_cones"], "support_friction", (length,)).squeeze("rod_length")
    friction = chosen(settings.friction_coefficient, 2.0)
    data = data.merge(cone_mapping(sources["motion_cones"], "support_friction", length, friction))
    return titled(data, "Friction cone, limit curve and velocity cone", sources)


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the three panels, the forces and velocities numbered alike in all of them."""
    curve = np.stack([data.force_x, data.force_y], axis=-1)
    titles = (
        rf"friction cone, $\mu = {number(float(data.friction_coefficient))}$",
        rf"limit curve, $l = {number(float(data.mapped_rod_length))}$",
        "velocity cone",
    )
    ax = mapping_panels(figure, data, [curve], "v", titles)
    ax.plot(*curve.T, color=DARK, **BUTT)
    labels.declutter(ax)
