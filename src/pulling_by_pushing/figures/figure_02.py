"""Figure 2: quasi-static pushing."""

from __future__ import annotations

import xarray as xr

from planar_pushing.drawing.canvas.style import COLUMN
from pulling_by_pushing.figures.figure import STATICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.solutions import angle_of, draw_balance, of_scene, shown

FIGURE = Figure(
    title="Quasi-static pushing",
    reads=("scenes/figure_02",),
    size=(COLUMN, 2.8),
    section=STATICS,
    promise="quasi-static pushing.",
)
draw = draw_balance


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the sticking solution."""
    return shown(sources, "figure_02")


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    return (
        "Quasi-static pushing. The slider turns about the velocity center, and the support "
        "friction, drawn along the ring, balances the force f of the pusher. The line of force "
        "is the mirror image about the rod of that in Fig. 3. The pusher moves into the slider (f at "
        f"{angle_of(data, 'force')}, vₛ at {angle_of(data, 'contact_motion')}; {of_scene(data)})."
    )
