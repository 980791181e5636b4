"""Figure 15: slip with infinite friction over time."""

from __future__ import annotations

import xarray as xr

from planar_pushing.figures.motion import simulation
from planar_pushing.figures.motion.timeline import plotted
from planar_pushing.figures.parts.curves import titled
from planar_pushing.figures.settings import Settings, Sources

draw = simulation.draw


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the motion over time."""
    data = plotted(sources["simulations/figure_15"])
    return titled(data, "Slip with infinite friction over time", sources)
