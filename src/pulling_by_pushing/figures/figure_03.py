"""Figure 3: quasi-static pulling."""

from __future__ import annotations

import xarray as xr

from planar_pushing.drawing.canvas.style import COLUMN
from pulling_by_pushing.figures.figure import STATICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.solutions import angle_of, draw_balance, of_scene, shown

FIGURE = Figure(
    title="Quasi-static pulling",
    reads=("scenes/figure_03",),
    size=(COLUMN, 3.1),
    section=STATICS,
    promise="quasi-static pulling.",
)
draw = draw_balance


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the sticking solution."""
    return shown(sources, "figure_03")


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    return (
        "Quasi-static pulling, at the scale of Fig. 2. The line of the force f passes on the other "
        "side of the ring's center, far enough from it that the contact moves below the fence. It "
        f"sticks although the pusher moves away from the slider (f at {angle_of(data, 'force')}, "
        f"vₛ at {angle_of(data, 'contact_motion')}; {of_scene(data)})."
    )
