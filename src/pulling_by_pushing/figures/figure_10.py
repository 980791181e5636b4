"""Figure 10: ellipses of the dynamic case, and a friction cone mapped to an acceleration cone."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.marks import Picture
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from pulling_by_pushing.figures.figure import DYNAMICS, INERTIA, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.curves import cone_mapping, curves, family, mapping
from pulling_by_pushing.figures.parts.data import (
    crosses,
    mathematical,
    number,
    several,
    titled,
    values,
)

FIGURE = Figure(
    title="Ellipses of the dynamic case and an acceleration cone",
    reads=("motion_cones",),
    takes=("rod_length", "mapped_rod_length", "friction_coefficient"),
    needs=INERTIA,
    size=(PAGE, 2.5),
    column=(COLUMN, 7.0),
    section=DYNAMICS,
    promise=(
        "the ellipses that govern the map from force to acceleration in the pure dynamic case, "
        "for four rod lengths, and how a friction cone maps to an acceleration cone for l = 1."
    ),
)
#: Force angle at which the ellipses are labeled, degrees.
LABEL_ANGLE = 318.0


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the ellipses, and the forces and accelerations of the mapping."""
    cones = sources["motion_cones"]
    data = curves(cones, "inertia", several(settings.rod_length))
    mapped, friction = settings.mapped_rod_length, settings.friction_coefficient
    data = data.merge(cone_mapping(cones, "inertia", mapped, friction))
    return titled(data, "Ellipses of the dynamic case and an acceleration cone", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    lengths = ", ".join(number(float(each)) for each in data.rod_length)
    known = values(data, "mapped_rod_length", "rod_angle", "friction_coefficient", "radius", "mass",
                   "gyration_radius")  # fmt: skip
    above = ". The fence passes above the ring" if crosses(data, data.mapped_rod_length) else ""
    return (
        "Without support friction, ellipses replace the limit curves (rod lengths "
        f"{lengths}); their major axes lie along the rod. The heavy ellipse is drawn with the forces "
        "of a friction cone and the accelerations that they cause, which are normal to the ellipse "
        f"and span the acceleration cone{above} ({known})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the three panels, with the same numbering of forces and accelerations in all of them."""
    picture, mapped = Picture(), float(data.mapped_rod_length)
    family(picture, data, LABEL_ANGLE, "left", bold=mapped)
    titles = (
        rf"friction cone, $\mu = {mathematical(float(data.friction_coefficient))}$",
        "ellipses of four rod lengths" if data.sizes["rod_length"] == 4 else "ellipses",
        rf"acceleration cone, $l = {mathematical(mapped)}$",
    )
    span = float(np.abs([data.force_x, data.force_y]).max())
    mapping(figure, data, picture, span, "a", titles)
