"""Figure 3: quasi-static pulling."""

from __future__ import annotations

from collections.abc import Mapping

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures import scene
from planar_pushing.figures.sketch import shown
from planar_pushing.figures.style import COLUMN_WIDTH
from planar_pushing.study.models import FigureEntry

SIZE = (COLUMN_WIDTH, 3.1)
CAPTION = (
    "Quasi-static pulling. The force f passes close by the ring centre on its other side: the contact "
    "sticks although the pusher moves away from the slider."
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
    return shown(sources["scenes/figure_03"])


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw slider, fence, forces, motion and velocity centre."""
    scene.draw_scene(figure, data, LAYERS)
