"""Figure 2: quasi-static pushing."""

from __future__ import annotations

import xarray as xr

from planar_pushing.figures.figure import COLUMN, STATICS, Figure, Settings, Sources
from planar_pushing.figures.parts.solutions import angle_of, draw_balance, of_scene, shown

FIGURE = Figure(
    title="Quasi-static pushing",
    reads=("scenes/figure_02",),
    size=(COLUMN, 2.8),
    section=STATICS,
    promise="quasi-static pushing.",
)
draw = draw_balance


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the solution that sticks."""
    return shown(sources, "figure_02")


def caption(data: xr.Dataset) -> str:
    """Caption with the values that are drawn."""
    return (
        "Quasi-static pushing. The friction of the support on a slider that turns about the "
        "velocity center, drawn along the ring, balances the force f of the pusher, whose line is "
        "the mirror image about the rod of that of Fig. 3. The pusher moves into the slider (f at "
        f"{angle_of(data, 'force')}, vₛ at {angle_of(data, 'contact_motion')}; {of_scene(data)})."
    )
