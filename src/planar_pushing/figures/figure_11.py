"""Figure 11: pulling, with support friction and inertia."""

from __future__ import annotations

from collections.abc import Mapping

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures import scene
from planar_pushing.figures.sketch import shown
from planar_pushing.figures.style import COLUMN_WIDTH
from planar_pushing.study.models import FigureEntry

SIZE = (COLUMN_WIDTH, 3.3)
CAPTION = (
    "Pulling from rest, with support friction and inertia. About an acceleration centre on the ring both "
    "resist along one line, tangent to the ring opposite to the centre, whatever their magnitudes."
)
LAYERS = (
    scene.body,
    scene.force,
    scene.line_of_force,
    scene.motions,
    scene.center,
    scene.moment_arm,
)


def select(sources: Mapping[str, xr.Dataset], settings: FigureEntry) -> xr.Dataset:
    """Select the solution that sticks."""
    return shown(sources["scenes/figure_11"])


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider, fence, line of force, acceleration and acceleration centre."""
    scene.draw_scene(figure, data, LAYERS)
