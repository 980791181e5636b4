"""Figure 8: slip with infinite friction."""

from __future__ import annotations

import math
from typing import Any

import xarray as xr

from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.colors import MOTION
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Picture, corners
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.drawing.scene import add_center, add_force, add_motion, add_pusher, add_slider
from planar_pushing.drawing.sketch import MOTION_CONE, Sketch
from planar_pushing.mechanics.plane import direction
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import degrees, values
from pulling_by_pushing.figures.parts.solutions import shown

FIGURE = Figure(
    title="Slip with infinite friction",
    reads=("scenes/figure_08",),
    size=(COLUMN, 2.6),
    section="Sec. 3.2: slip with infinite friction",
    promise="slip with infinite friction for l = 5.",
)


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the slipping solution."""
    return shown(sources, "figure_08")


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    right, left = (f"{float(data[f'motion_cone_{side}']):.1f}°" for side in ("right", "left"))
    known = values(
        data, "pusher_angle", "rod_length", "rod_angle", "friction_coefficient", "radius", "weight"
    )
    return (
        "Slip with infinite friction. The pusher velocity lies to the left of the shaded velocity "
        f"cone, which extends from {right} to {left}, so that the contact slips to the right: f and "
        "the contact velocity lie on the left edges of their cones, and f points along the fence "
        f"({known})."
    ).replace("-", "−")


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the solution with its velocity cone and the angles of the cone's edges."""
    sketch, picture = Sketch.of_dataset(data), Picture()
    one, reach = sketch.solution, sketch.reach
    assert one is not None
    left = -1.55 * reach
    add_slider(picture, sketch, left=left, right=sketch.center[0] + sketch.half)
    radius = MOTION_CONE * reach
    picture.cone(*sketch.motion, radius, MOTION, order=AREAS + 0.5)
    for edge, offset in zip(sketch.motion, ((4.0, -8.0), (-4.0, 9.0)), strict=True):
        text = degrees(math.degrees(edge))
        picture.label(radius * direction(edge), text, color=MOTION, size=NOTE, offset=offset)
    for add in (add_force, add_motion, add_center):
        add(picture, sketch, one)
    add_pusher(picture, sketch)
    text = rf"$\theta_p = {float(data.pusher_angle):g}^\circ$"
    picture.label(
        sketch.motion_scale * data.pusher_motion.values, text, size=NOTE, offset=(-4.0, 15.0)
    )
    box = corners([sketch.box, (left, 0.0)])
    panels(figure, [Panel(picture, box, pad=14.0)])
