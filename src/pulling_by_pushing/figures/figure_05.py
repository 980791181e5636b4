"""Figure 5: limit curves for several rod lengths."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.canvas.axes import onto
from planar_pushing.drawing.canvas.colors import DARK, rod_color
from planar_pushing.drawing.canvas.marks import NOTE, Picture, Sheet, unit
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.mechanics.plane import direction
from pulling_by_pushing.figures.figure import FRICTION, STATICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.curves import curves, family, forces
from pulling_by_pushing.figures.parts.data import (
    labeled,
    named,
    rod_angle,
    scene_of,
    several,
    titled,
    values,
)

FIGURE = Figure(
    title="Limit curves for several rod lengths",
    reads=("limit_curves",),
    takes=("rod_length",),
    needs=FRICTION,
    size=(COLUMN, 3.4),
    section=STATICS,
    promise="limit curves for rods of different lengths.",
)
#: Force angles, measured from the rod, at which force and velocity are parallel, degrees.
PARALLEL = (0.0, 90.0, 180.0, 270.0)
#: Force angle of the curves' labels, degrees; half the width of the axes, in units of W; their position.
LABEL_ANGLE, SPAN, PLACE = 168.0, 1.27, (0.135, 0.12, 0.855, 0.855)


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the curves, the limit for an infinite rod, and the velocities at the special angles."""
    grid = sources["limit_curves"]
    psi = rod_angle(grid)
    data = curves(grid, "support_friction", several(settings.rod_length))
    angles = labeled("force_angle", (psi + np.array(PARALLEL)) % 360)
    special = forces(scene_of(grid, "support_friction", data.rod_length), angles)
    special = special.rename(force_angle="parallel_angle")
    data["parallel_force"], data["parallel_motion_angle"] = special.force, special.motion_angle
    data.parallel_angle.attrs["long_name"] = "force angle at which force and velocity are parallel"
    # A force along the rod translates the slider, whatever the rod's length.
    ends = np.array([psi, (psi + 180) % 360])
    force = special.force.sel(parallel_angle=ends).isel(rod_length=-1).values
    tips = force[:, None] * direction(np.deg2rad(ends))
    for xy, each, words in zip("xy", tips.T, ("along", "normal to"), strict=True):
        long_name = f"force {words} the fence, infinite rod"
        data[f"infinite_rod_{xy}"] = named("end", each, "force", long_name)
    return titled(data, "Limit curves for several rod lengths", sources)


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    known = values(data, "rod_length", "rod_angle", "radius", "weight")
    return (
        "Limit curves for several rod lengths l: the forces through the contact under which the "
        "slider moves quasi-statically. For l = 0 the curve is a circle, and the velocity is "
        "parallel to the force everywhere; for an infinite rod it is a segment along the rod. Open "
        "arrows are velocities of the contact, normal to the curves; for l > 0 they are parallel to "
        f"the force only at the four force angles drawn ({known})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the curves about one origin, with the velocities that are parallel to the force."""
    ax = figure.add_axes(PLACE)
    ax.set(xlim=(-SPAN, SPAN), ylim=(-SPAN, SPAN), aspect="equal")
    ax.set(xticks=[-1, 0, 1], yticks=[-1, 0, 1])
    ax.set_xlabel("force along the fence, $f_x / W$")
    ax.set_ylabel("force normal to the fence, $f_y / W$")
    picture = Picture()
    for angle in data.parallel_angle.values[:2]:
        picture.guide(-0.95 * unit(angle), 0.95 * unit(angle), dash=":")
    family(picture, data, LABEL_ANGLE, "right")
    ends = np.stack([data.infinite_rod_x, data.infinite_rod_y], axis=-1)
    picture.line(ends, rod_color(np.inf), width=1.6, order=3.0)
    picture.label(0.55 * ends[1], r"$\infty$", color=DARK, size=NOTE + 1)
    _velocities(picture, data)
    wide = 72 * figure.get_figwidth() * PLACE[2]
    onto(picture, ax, Sheet(np.zeros(2), wide / (2 * SPAN), np.array([wide, wide]), 1.0))


def _velocities(picture: Picture, data: xr.Dataset) -> None:
    """Draw the normals at the special angles; curves that coincide share one normal."""
    for angle in data.parallel_angle.values:
        here = data.sel(parallel_angle=angle)
        feet = np.round(here.parallel_force.values, 9)
        for index in np.unique(feet, return_index=True)[1]:
            foot = float(here.parallel_force[index]) * unit(angle)
            along = unit(float(here.parallel_motion_angle[index]))
            shared = np.ptp(feet) == 0
            text = r"$\mathbf{v}_s$" if feet[index] == feet.max() else ""
            picture.motion(foot, (0.28 if shared else 0.11) * along, text, head=7, width=1.0)
