"""Figure 5: limit curves for several rod lengths."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.curves import (
    curves,
    family,
    forces,
    labelled,
    named,
    on_curve,
    rod_angle,
    rod_lengths,
    scene_of,
    titled,
)
from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import DARK
from planar_pushing.mechanics.plane import Array, direction

#: Force angles from the rod at which force and velocity are parallel, degrees.
PARALLEL = (0.0, 90.0, 180.0, 270.0)


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Compute the curves, the limit of an infinite rod, and the velocities at the special angles."""
    grid = sources["limit_curves"]
    psi, lengths = rod_angle(grid), rod_lengths(settings, (0.0, 0.5, 1.0, 2.0, 5.0))
    data = curves(grid, "support_friction", lengths)
    angles = labelled("force_angle", (psi + np.array(PARALLEL)) % 360)
    special = forces(scene_of(grid, "support_friction", data.rod_length), angles)
    special = special.rename(force_angle="parallel_angle")
    data["parallel_force"], data["parallel_motion_angle"] = special.force, special.motion_angle
    data.parallel_angle.attrs["long_name"] = "force angle at which force and velocity are parallel"
    # Along the rod the force translates the slider, whatever the rod's length.
    ends = np.array([psi, (psi + 180) % 360])
    force = special.force.sel(parallel_angle=ends).isel(rod_length=-1).values
    tips = force[:, None] * direction(np.deg2rad(ends))
    for xy, values, words in zip("xy", tips.T, ("along", "normal to"), strict=True):
        long_name = f"force {words} the fence, infinite rod"
        data[f"infinite_rod_{xy}"] = named("end", values, "force", long_name)
    return titled(data, "Limit curves for several rod lengths", sources)


#: Where the curves' labels stand, degrees, and half the width of the axes, in units of W.
LABEL_ANGLE = 165.0
SPAN = 1.24


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the curves around one origin, with the velocities where they are parallel to the force."""
    ax = figure.add_axes((0.125, 0.115, 0.865, 0.865))
    ax.set(xlim=(-SPAN, SPAN), ylim=(-SPAN, SPAN), aspect="equal")
    ax.set(xticks=[-1, 0, 1], yticks=[-1, 0, 1])
    ax.set_xlabel("force along the fence, $f_x / W$")
    ax.set_ylabel("force normal to the fence, $f_y / W$")
    for angle in data.parallel_angle.values[:2]:
        drawing.guide(
            ax, -SPAN * 0.75 * arrows.unit(angle), SPAN * 0.75 * arrows.unit(angle), style=":"
        )
    family(ax, data, LABEL_ANGLE, "right")
    ax.plot(data.infinite_rod_x, data.infinite_rod_y, color=DARK, zorder=3)
    _velocities(ax, data)
    on_curve(ax, 0.62 * _far_end(data), r"$\infty$", DARK)
    labels.declutter(ax)


def _far_end(data: xr.Dataset) -> Array:
    """Return the end of the infinite rod's segment that lies away from the slider."""
    return np.array([float(data.infinite_rod_x[1]), float(data.infinite_rod_y[1])])


def _velocities(ax: Axes, data: xr.Dataset) -> None:
    """Normals at the special angles; where curves coincide, one for all of them."""
    for angle in data.parallel_angle.values:
        here = data.sel(parallel_angle=angle)
        feet = np.round(here.parallel_force.values, 9)
        for index in np.unique(feet, return_index=True)[1]:
            foot = float(here.parallel_force[index]) * arrows.unit(angle)
            along = arrows.unit(float(here.parallel_motion_angle[index]))
            shared = np.ptp(feet) == 0
            text = r"$\mathbf{v}_s$" if feet[index] == feet.max() else ""
            arrows.motion_arrow(
                ax, foot, (0.3 if shared else 0.15) * along, text, head=8, width=1.0
            )
