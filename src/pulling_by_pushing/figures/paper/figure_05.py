"""Figure 5: limit curves for several rod lengths."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.canvas.axes import onto
from planar_pushing.drawing.canvas.colors import DARK, rod_color
from planar_pushing.drawing.canvas.marks import NOTE, Picture, Sheet, unit
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import values
from pulling_by_pushing.figures.figure import FRICTION, STATICS, Data, Figure
from pulling_by_pushing.figures.parts.curves import add_curves

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Limit curves for several rod lengths",
    reads=("curves",),
    size=(COLUMN, 3.4),
    takes=("rod_length",),
    cuts={"effects": FRICTION},
    section=STATICS,
    promise="limit curves for rods of different lengths.",
)
#: Force angles, measured from the rod, at which force and velocity are parallel, degrees.
PARALLEL = (0.0, 90.0, 180.0, 270.0)
#: Force angle of the curves' labels, degrees; half the width of the axes, in units of W; their position.
LABEL_ANGLE, SPAN, PLACE = 155.0, 1.27, (0.135, 0.12, 0.855, 0.855)


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    known = values(data["curves"], "rod_length", "rod_angle", "radius", "weight")
    return (
        "Limit curves for several rod lengths l: the forces through the contact under which the "
        "slider moves quasi-statically. For l = 0 the curve is a circle, and the velocity is "
        "parallel to the force everywhere; for an infinite rod it is a segment along the rod. Open "
        "arrows are velocities of the contact, normal to the curves; for l > 0 they are parallel to "
        f"the force only at the four force angles drawn ({known})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the curves about one origin, with the velocities that are parallel to the force."""
    curves = data["curves"]
    ax = figure.add_axes(PLACE)
    ax.set(xlim=(-SPAN, SPAN), ylim=(-SPAN, SPAN), aspect="equal")
    ax.set(xticks=[-1, 0, 1], yticks=[-1, 0, 1])
    ax.set_xlabel("force along the fence, $f_x / W$")
    ax.set_ylabel("force normal to the fence, $f_y / W$")
    picture, rod = Picture(), float(curves.rod_angle)
    for turn in PARALLEL[:2]:
        picture.guide(-0.95 * unit(rod + turn), 0.95 * unit(rod + turn), dash=":")
    add_curves(picture, curves, LABEL_ANGLE)
    # A force along the rod translates the slider, whatever the rod's length.
    ends = np.stack([forces(curves, angle)[-1] * unit(angle) for angle in (rod, rod + 180)])
    picture.line(ends, rod_color(np.inf), width=1.6, order=3.0)
    picture.label(0.55 * ends[1], r"$\infty$", color=DARK, size=NOTE + 1)
    for turn in PARALLEL:
        _add_velocities(picture, forces(curves, rod + turn), rod + turn)
    wide = 72 * figure.get_figwidth() * PLACE[2]
    onto(picture, ax, Sheet(np.zeros(2), wide / (2 * SPAN), np.array([wide, wide]), 1.0))


def forces(curves: xr.Dataset, angle: float) -> Array:
    """Forces at a force angle in degrees, by rod length."""
    x, sizes = curves.force_angle.values, curves.force.transpose("rod_length", ...).values
    return np.array([np.interp(angle % 360, x, force) for force in sizes])


def _add_velocities(picture: Picture, feet: Array, angle: float) -> None:
    """Draw the velocities parallel to the forces at an angle; curves that coincide share one."""
    feet = np.round(feet, 9)
    shared = np.ptp(feet) == 0
    for foot in np.unique(feet):
        text = r"$\mathbf{v}_s$" if foot == feet.max() else ""
        along = (0.28 if shared else 0.11) * unit(angle)
        picture.motion(foot * unit(angle), along, text, head=7, width=1.0)
