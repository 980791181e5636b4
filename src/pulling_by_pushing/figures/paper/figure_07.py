"""Figure 7: velocity cones for infinite friction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import add_fence, add_rod
from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.colors import DARK, MODES, MOTION
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Picture, arc, corners, unit
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
#: Sectors narrower than this, in degrees, are labeled beside the cone.
NARROW = 25.0
SLIPS = MODES[ContactMode.SLIP_RIGHT]


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    cones = data["motion_cones"]
    crossed = [cone.rod_length for cone in _each(cones) if crosses(cone)]
    above = (
        f"; for l = {' and '.join(number(float(each)) for each in crossed)} the fence passes above the "
        "ring"
        if crossed else ""
    )  # fmt: skip
    return (
        "Directions of the contact velocity for infinite friction (shaded): each cone spans 180 "
        "degrees and is tilted from the friction cone, which is the half plane above the fence. In "
        "the part of the cone below the fence, on the right, the fence pulls. For a pusher velocity "
        "v_p in the hatched sector on the left, the contact slips to the right. The bars are as "
        f"long as the radius of the ring{above} "
        f"({values(cones, 'rod_length', 'rod_angle', 'friction_coefficient', 'radius')})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw one panel for each rod length, each at its own scale."""
    given = [_panel(cone) for cone in _each(data["motion_cones"])]
    panels(figure, given, len(given))


def _each(cones: xr.Dataset) -> list[xr.Dataset]:
    """The cone of each rod length."""
    return [cones.isel(rod_length=index) for index in range(cones.sizes["rod_length"])]


def _panel(one: xr.Dataset) -> Panel:
    picture, length, ring = Picture(), float(one.rod_length), float(one.radius)
    center, reach = length * unit(float(one.rod_angle)), 0.6 * (length + ring)
    left, right = -1.25 * reach, max(center[0] + ring, 1.25 * reach)
    add_fence(picture, left, right, depth=0.07 * reach)
    add_support(picture, Ring(ring), Pose(center, 0.0), Ink(width=1.6))
    add_rod(picture, center, contact=(0.0, 0.0), ink=Ink(width=1.6))
    _cone(picture, one, reach)
    low = min(-0.75 * reach, center[1] - ring) - 0.3 * reach
    picture.scale_bar((left, low), ring, f"${mathematical(ring)}$")
    box = corners([(left, low), (right, max(center[1] + ring, 1.1 * reach))])
    return Panel(picture, box, f"$l = {mathematical(length)}$", 12.0)


def _cone(picture: Picture, one: xr.Dataset, reach: float) -> None:
    """Draw the velocity cone and, to its left, the pushes that make the contact slip."""
    right, left = float(one.motion_cone_right), float(one.motion_cone_left)
    sector = np.vstack([(0.0, 0.0), reach * arc(math.radians(left), math.pi)])
    picture.area(sector, color=SLIPS.fill, hatch=SLIPS.hatch, ink=SLIPS.ink, order=AREAS + 0.3)
    picture.cone(math.radians(right), math.radians(left), reach, MOTION)
    note: dict[str, Any] = {"size": NOTE, "held": True}
    picture.label(reach * unit(left), degrees(left), color=MOTION, offset=(-6.0, 8.0), **note)
    picture.label(reach * unit(right), degrees(right), color=MOTION, offset=(6.0, -7.0), **note)
    for word, start, stop in (("slip", left, 180.0), ("pull", right, 0.0)):
        middle = (start + stop) / 2
        if abs(stop - start) > NARROW:
            picture.label(0.66 * reach * unit(middle), word, color=DARK, **note)
        else:
            end = reach * unit(middle)
            side = -1.0 if word == "slip" else 1.0
            away = end + side * np.array([0.1 * reach, 0.0])
            picture.guide(0.8 * end, away, DARK, dash="")
            picture.label(away, word, color=DARK, offset=(side * 9.0, 0.0), **note)
