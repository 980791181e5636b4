"""Figure 2: quasi-static pushing."""

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
    "Quasi-static pushing. The support friction of a slider that turns about the velocity centre, "
    "drawn along the ring, balances the force f of the pusher; the pusher moves into the slider."
)
LAYERS = (
    scene.body,
    scene.force,
    scene.line_of_force,
    scene.motions,
    scene.center,
    scene.support_friction,
)


def select(sources: Mapping[str, xr.Dataset], settings: FigureEntry) -> xr.Dataset:
    """Select the solution that sticks."""
    return shown(sources["scenes/figure_02"])


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider, fence, forces, motion and velocity centre."""
    scene.draw_scene(figure, data, LAYERS)
