"""Figure 6: a friction cone mapped through the limit curve to the velocity cone."""

from __future__ import annotations

from typing import Any

import xarray as xr

from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from pulling_by_pushing.figures.figure import FRICTION, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.curves import cone_mapping, curve_picture, curves, mapping
from pulling_by_pushing.figures.parts.data import mathematical, titled, values

FIGURE = Figure(
    title="Friction cone, limit curve and velocity cone",
    reads=("motion_cones",),
    takes=("rod_length", "friction_coefficient"),
    needs=FRICTION,
    size=(PAGE, 2.5),
    column=(COLUMN, 7.0),
    section="Sec. 3.1: friction cones and velocity cones",
    promise="how the friction cone of μ = 2 maps to a velocity cone through the limit curve of l = 2.",
)


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the limit curve and the forces and velocities of the mapping."""
    length, cones = settings.rod_length, sources["motion_cones"]
    data = curves(cones, "support_friction", (length,)).squeeze("rod_length")
    mapped = cone_mapping(cones, "support_friction", length, settings.friction_coefficient)
    return titled(data.merge(mapped), "Friction cone, limit curve and velocity cone", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    known = values(
        data, "mapped_rod_length", "rod_angle", "friction_coefficient", "radius", "weight"
    )
    return (
        "From the friction cone through the limit curve to the velocity cone. Each force inside "
        "the friction cone corresponds to a point of the limit curve; the normal there, with the "
        "same number, is the velocity of the contact. The edges of the friction cone map to those "
        f"of the velocity cone, whose right edge points away from the slider: pulling ({known})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the three panels, with the same numbering of forces and velocities in all of them."""
    picture, span = curve_picture(data)
    titles = (
        rf"friction cone, $\mu = {mathematical(float(data.friction_coefficient))}$",
        rf"limit curve, $l = {mathematical(float(data.mapped_rod_length))}$",
        "velocity cone",
    )
    mapping(figure, data, picture, span, "v", titles)
