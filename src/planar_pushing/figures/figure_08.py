"""Figure 8: slip with infinite friction."""

from __future__ import annotations

from collections.abc import Mapping

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures import scene
from planar_pushing.figures.sketch import shown
from planar_pushing.figures.style import COLUMN_WIDTH
from planar_pushing.study.models import FigureEntry

SIZE = (COLUMN_WIDTH, 2.8)
CAPTION = (
    "Slip with infinite friction. The pusher velocity lies to the left of the shaded velocity cone, so "
    "the slider slips to the right: f and the slider velocity lie on the left edges of their cones."
)
LAYERS = (scene.body, scene.motion_cone, scene.force, scene.motions, scene.center)


def select(sources: Mapping[str, xr.Dataset], settings: FigureEntry) -> xr.Dataset:
    """Select the solution that slips."""
    return shown(sources["scenes/figure_08"])


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider, fence, velocity cone, force, and the velocities of pusher, slider and slip."""
    scene.draw_scene(figure, data, LAYERS)
