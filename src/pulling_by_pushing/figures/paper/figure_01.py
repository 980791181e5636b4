"""Figure 1: the pushing problem with every symbol.

A contact that slips to the right shows every symbol: f lies on the left edge of the friction cone, v_s on
the left edge of the velocity cone, and v_p halfway between that edge and the fence.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import add_fence, add_rod
from planar_pushing.drawing.canvas.colors import DARK, FORCE, GUIDE, MOTION, PUSHER
from planar_pushing.drawing.canvas.marks import NOTE, Picture, unit
from planar_pushing.drawing.canvas.panels import Panel, panels
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import mathematical, values
from pulling_by_pushing.figures.figure import FRICTION, STATICS, Data, Figure

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="The pushing problem",
    reads=("motion_cones",),
    size=(COLUMN, 2.2),
    takes=("rod_length", "friction_coefficient"),
    cuts={"effects": FRICTION},
    section=STATICS,
    promise="an example of the pushing problem.",
)
#: Drawn lengths of the pusher's velocity and of the force.
SPEED, FORCE_LENGTH = 2.9, 2.3
#: Direction of the labels on the arcs, between the rod and the force, degrees.
BETWEEN = 78.0


def angles(cone: xr.Dataset) -> dict[str, float]:
    """Angles of the force and of both velocities, degrees, on the left edges of their cones."""
    edge = float(cone.motion_cone_left)
    return {
        "force": float(cone.friction_cone_left),
        "slider": edge,
        "pusher": 0.5 * (edge + 180.0),
    }


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    cone = data["motion_cones"]
    force, slider, pusher = (f"{angle:.1f}°" for angle in angles(cone).values())
    return (
        "The pushing problem: a fence pushes a ring at the free end of its rod. Filled arrowheads "
        "mark forces, and open ones mark velocities and accelerations; angles are measured from the "
        f"fence. Here the contact slips to the right (φ = {force}, θₛ = {slider}, θₚ = {pusher}; "
        f"{values(cone, 'rod_length', 'rod_angle', 'friction_coefficient', 'radius')})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the slider and the fence with lengths, vectors and angles."""
    cone = data["motion_cones"]
    psi, length = float(cone.rod_angle), float(cone.rod_length)
    ring, size = length * unit(psi), float(cone.radius)
    left, right = -SPEED - 0.2, ring[0] + size
    picture = Picture()
    add_fence(picture, left, right, depth=0.16)
    add_support(picture, Ring(size), Pose(ring, 0.0), Ink())
    add_rod(picture, ring, contact=(0.0, 0.0), ink=Ink())
    _vectors(picture, **angles(cone))
    _angles(picture, psi, **angles(cone))
    _lengths(picture, ring, psi, size)
    for turn, name in ((0.0, "$x$"), (np.pi / 2, "$y$")):
        picture.axis((left + 0.3, ring[1] - 0.2), turn, 0.7, name)
    panels(figure, [Panel(picture)])


def _vectors(picture: Picture, force: float, slider: float, pusher: float) -> None:
    speed = SPEED * np.sin(np.deg2rad(pusher)) / np.sin(np.deg2rad(slider))
    picture.force((0, 0), FORCE_LENGTH * unit(force), r"$\mathbf{f}$")
    picture.motion((0, 0), speed * unit(slider), r"$\mathbf{v}_s$")
    picture.motion((0, 0), SPEED * unit(pusher), r"$\mathbf{v}_p$", color=PUSHER)


def _angles(picture: Picture, psi: float, force: float, slider: float, pusher: float) -> None:
    picture.angle(0.0, np.deg2rad(psi), 0.45, r"$\psi$", color=DARK)
    for reach, end, symbol, color in (
        (0.95, force, r"$\phi$", FORCE),
        (1.3, slider, r"$\theta_s$", MOTION),
        (1.65, pusher, r"$\theta_p$", PUSHER),
    ):
        picture.angle(
            0.0, np.deg2rad(end), reach, symbol, color=color, fraction=BETWEEN / end, offset=0.0
        )


def _lengths(picture: Picture, ring: np.ndarray, psi: float, size: float) -> None:
    x, y = 8.0 * unit(psi - 90)
    picture.label(0.55 * ring, "$l$", offset=(float(x), float(y)))
    end = ring + size * unit(-45.0)
    picture.guide(ring, end, DARK, dash="")
    picture.label((ring + end) / 2, f"$R = {mathematical(size)}$", size=NOTE, offset=(0.0, 9.0))
    picture.label((0, 0), r"$\mu$", offset=(0.0, -13.0), held=True)
    picture.label(ring + size * unit(90), "slider", offset=(0.0, -12.0), size=NOTE, color=GUIDE)
    picture.label((-1.6, 0), "pusher", offset=(0.0, -13.0), size=NOTE, color=GUIDE)
