"""Selection and drawing of figures of one solution of a scene, at a common scale."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.marks import Picture
from planar_pushing.drawing.scene import (
    add_center,
    add_force,
    add_friction,
    add_line_of_force,
    add_motion,
    add_pusher,
    add_slider,
)
from planar_pushing.drawing.sketch import Sketch
from planar_pushing.drawing.words import best_row
from pulling_by_pushing.figures.figure import Sources
from pulling_by_pushing.figures.parts.data import values

#: Variables of a scene's dataset shown in its picture.
PLOTTED = (
    "rod_length", "rod_angle", "radius", "ring_center", "friction_cone_right", "friction_cone_left",
    "motion_cone_right", "motion_cone_left", "pusher_angle", "pusher_magnitude", "pusher_motion", "outcome",
    "mode", "adhesive", "force", "contact_motion", "twist", "spin_ratio", "center", "effect",
)  # fmt: skip
#: Variables of friction around a ring, or of other supports.
MORE = ("support_force", "place_position", "place_force", "force_end", "pivot")
#: Points per unit of length in the figures to be compared.
SCALE = 42.0
#: Quantities of a quasi-static scene given in a caption.
QUASI_STATIC = ("rod_length", "rod_angle", "friction_coefficient", "radius", "weight")


def shown(sources: Sources, name: str) -> xr.Dataset:
    """Select the solution to draw: sticking, otherwise the first that moves, otherwise the first."""
    (scene,) = (each for key, each in sources.items() if key == f"scenes/{name}")
    more = [each for each in MORE if each in scene]
    return scene[[*PLOTTED, *more]].isel(solution=best_row(scene["mode"].values))


def angle_of(data: xr.Dataset, name: str) -> str:
    """Angle of a vector of the solution, for a caption."""
    x, y = data[name].values.reshape(-1, 2)[0]
    return f"{np.rad2deg(np.arctan2(y, x)):.1f}°".replace("-", "−")


def balance(data: xr.Dataset) -> tuple[Sketch, Picture]:
    """Sketch of the solution and its picture, without cones and friction."""
    sketch, picture = Sketch.of_dataset(data), Picture()
    add_slider(picture, sketch)
    one = sketch.solution
    assert one is not None
    for add in (add_force, add_line_of_force, add_motion, add_center):
        add(picture, sketch, one)
    add_pusher(picture, sketch)
    return sketch, picture


def draw_balance(figure: Any, data: xr.Dataset, scale: float | None = SCALE) -> None:
    """Draw the solution with the friction of the support."""
    sketch, picture = balance(data)
    add_friction(picture, sketch)
    panels(figure, [Panel(picture, sketch.box, pad=18.0)], scale=scale)


def of_scene(data: xr.Dataset) -> str:
    """Values of a quasi-static scene for a caption."""
    return values(data, *QUASI_STATIC)
