"""Figure 11: pulling with support friction and inertia, whose forces act along one line."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.colors import FORCE
from planar_pushing.drawing.canvas.marks import Picture, corners
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.drawing.scene import (
    add_center,
    add_friction,
    add_line_of_force,
    add_motion,
    add_slider,
)
from planar_pushing.drawing.sketch import Sketch
from pulling_by_pushing.figures.figure import DYNAMICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import named, values
from pulling_by_pushing.figures.parts.solutions import angle_of, shown

FIGURE = Figure(
    title="Pulling with support friction and inertia",
    reads=("scenes/figure_11",),
    size=(COLUMN, 3.3),
    section=DYNAMICS,
    promise="an example of pulling with support friction and inertia, l = 5.",
)
#: Drawn length of the pusher's force, in units of the reach.
LENGTH = 0.84


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the sticking solution and the forces that the two effects contribute to the balance."""
    data = shown(sources, "figure_11")
    effects = json.loads(data.attrs["parameters"])["scene"]["effects"]
    mass = next(float(each["mass"]) for each in effects if each["type"] == "inertia")
    inertial = -mass * data["twist"].values[:, :2]
    dims = ("solution", "xy")
    data["inertial_force"] = named(dims, inertial, "force", "inertial force, - m a")
    friction = -data["force"].values - inertial
    data["friction_force"] = named(dims, friction, "force", "resultant of the support friction")
    return data


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    known = values(data, "rod_length", "rod_angle", "friction_coefficient", "radius", "weight", "mass",
                   "gyration_radius", "pusher_magnitude")  # fmt: skip
    return (
        "Pulling from rest, with support friction and inertia. For an acceleration center on the "
        "ring, the support friction and the inertial force act along one line, whatever their "
        "magnitudes. This line is tangent to the ring opposite the center. The force f of the pusher "
        f"balances them (f at {angle_of(data, 'force')}, aₛ at {angle_of(data, 'contact_motion')}; "
        f"{known})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the solution with the friction around the ring and both resistances on the line of force."""
    sketch, picture = Sketch.of_dataset(data), Picture()
    one = sketch.solution
    assert one is not None
    add_slider(picture, sketch)
    for add in (add_line_of_force, add_motion, add_center):
        add(picture, sketch, one)
    add_friction(picture, sketch)
    scale = LENGTH * sketch.reach / float(np.hypot(*one.force))
    picture.force((0, 0), scale * one.force, r"$\mathbf{f}$", width=1.6)
    _resistances(picture, sketch, data, scale)
    panels(figure, [Panel(picture, corners([sketch.box]), pad=16.0)])


def _resistances(picture: Picture, sketch: Sketch, data: xr.Dataset, scale: float) -> None:
    """Draw both forces end to end from the point of tangency."""
    one = sketch.solution
    assert one is not None
    heading = one.force / np.hypot(*one.force)
    foot = (heading @ sketch.center) * heading
    picture.guide(sketch.center, foot, dash=":")
    picture.dot(foot, 3.0, FORCE)
    names = {"friction_force": "friction", "inertial_force": r"$-m\,\mathbf{a}$"}
    for name, text in names.items():
        force = scale * data[name].values[0]
        picture.force(foot, force, text, width=1.4, head=11.0, at=0.5, offset=(13.0, -10.0))
        foot = foot + force
