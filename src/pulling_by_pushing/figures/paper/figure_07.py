"""Figure 7: velocity cones for infinite friction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import add_fence, add_rod
from planar_pushing.drawing.canvas.colors import DARK, MODES, MOTION
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Picture, arc, unit
from planar_pushing.drawing.canvas.panels import Panel, panels
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import crosses, degrees, mathematical, number, values
from pulling_by_pushing.figures.figure import FRICTION, Data, Figure

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Velocity cones for infinite friction",
    reads=("motion_cones",),
    size=(PAGE, 2.0),
    takes=("rod_length",),
    cuts={"effects": FRICTION, "friction_coefficient": np.inf},
    section="Sec. 3.2: slip with infinite friction",
    promise="velocity cones of infinite friction.",
)
#: Least radius of a cone, in radii of the ring: its ends, with their labels, are outside the ring.
BEYOND = 1.35
SLIPS = MODES[ContactMode.SLIP_RIGHT]


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    cones = data["motion_cones"]
    crossed = [cone.rod_length for cone in _by_length(cones) if crosses(cone)]
    above = (
        f"; for l = {' and '.join(number(float(length)) for length in crossed)} the fence passes above the "
        "ring"
        if crossed else ""
    )  # fmt: skip
    return (
        "Directions of the contact velocity for infinite friction (shaded): each cone spans 180 "
        "degrees and is tilted from the friction cone, which is the half plane above the fence. In "
        "the part of the cone below the fence, on the right, the fence pulls. For a pusher velocity "
        "vₚ in the hatched sector on the left, the contact slips to the right. The bars are as "
        f"long as the radius of the ring{above} "
        f"({values(cones, 'rod_length', 'rod_angle', 'friction_coefficient', 'radius')})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw one panel for each rod length, each at its own scale."""
    pictures = [_panel(cone) for cone in _by_length(data["motion_cones"])]
    panels(figure, pictures, len(pictures))


def _by_length(cones: xr.Dataset) -> list[xr.Dataset]:
    """The cone of each rod length."""
    return [cones.isel(rod_length=index) for index in range(cones.sizes["rod_length"])]


def _panel(one: xr.Dataset) -> Panel:
    picture, length, ring = Picture(), float(one.rod_length), float(one.radius)
    center, reach = length * unit(float(one.rod_angle)), max(0.6 * (length + ring), BEYOND * ring)
    add_fence(picture, -1.05 * reach, 1.05 * reach, depth=0.07 * reach)
    add_support(picture, Ring(ring), Pose(center, 0.0), Ink(width=1.6))
    add_rod(picture, center, contact=(0.0, 0.0), ink=Ink(width=1.6))
    _cone(picture, one, reach)
    low = min(-0.55 * reach, center[1] - ring)
    picture.scale_bar((-1.05 * reach, low), ring, f"${mathematical(ring)}$")
    return Panel(picture, f"$l = {mathematical(length)}$")


def _cone(picture: Picture, one: xr.Dataset, reach: float) -> None:
    """Draw the velocity cone and, to its left, the pushes that make the contact slip."""
    right, left = float(one.motion_cone_right), float(one.motion_cone_left)
    sector = np.vstack([(0.0, 0.0), reach * arc(math.radians(left), math.pi)])
    picture.area(sector, color=SLIPS.fill, hatch=SLIPS.hatch, ink=SLIPS.ink, order=AREAS + 0.3)
    picture.cone(math.radians(right), math.radians(left), reach, MOTION)
    note: dict[str, Any] = {"size": NOTE, "held": True}
    for edge, side, align in ((left, -1.0, "right"), (right, 1.0, "left")):
        shift = (side * 2.0, -side * 7.0)
        picture.label(
            reach * unit(edge), degrees(edge), color=MOTION, offset=shift, align=align, **note
        )
    for word, edge, align in (("slip", left - 180.0, "right"), ("pull", right, "left")):
        side = -1.0 if word == "slip" else 1.0
        middle = side * reach * unit(edge / 2)
        picture.label(middle, word, color=DARK, offset=(side * 4.0, 0.0), align=align, **note)
