"""Figures of a friction cone that a limit curve maps to a motion cone: 6 and 10."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from planar_pushing.drawing.body import add_fence, add_rod
from planar_pushing.drawing.canvas.colors import DARK, FORCE, MOTION
from planar_pushing.drawing.canvas.marks import Picture, unit
from planar_pushing.drawing.canvas.panels import Panel, panels
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import crosses, degrees, mathematical, number, values
from pulling_by_pushing.figures.figure import (
    DYNAMICS,
    FRICTION,
    INERTIA,
    Data,
    Drawing,
    Figure,
)
from pulling_by_pushing.figures.parts.curves import SMALL, add_curves, points

if TYPE_CHECKING:
    import xarray as xr

#: Force angles of a mapping, drawn between the edges of its cone, degrees.
INSIDE = (45.0, 90.0)
#: Force angle at which the ellipses are labeled, degrees.
LABEL_ANGLE = 318.0


class Mapped(NamedTuple):
    """Numbered forces, shape (n, 2), their angles and those of the motions that they cause, degrees."""

    forces: Array
    force_angles: Array
    motion_angles: Array


def map_cone(data: Data) -> Mapped:
    """Forces at the edges of the friction cone and inside it, and the motions to which they map."""
    curve, cone = data["curves"], data["motion_cones"]
    if curve.rod_length.ndim:
        curve = curve.sel(rod_length=cone.rod_length)
    right, left = float(cone.friction_cone_right), float(cone.friction_cone_left)
    between = [angle for angle in INSIDE if right < angle < left]
    within = curve.sel(force_angle=between)
    angles = np.array([right, *between, left])
    size = np.array([cone.limit_force_right, *within.force, cone.limit_force_left])
    motion = np.array([cone.motion_cone_right, *within.motion_angle, cone.motion_cone_left])
    return Mapped(size[:, None] * np.stack([unit(angle) for angle in angles]), angles, motion)


def velocities_caption(data: Data) -> str:
    """Caption of the mapping to a velocity cone."""
    known = values(
        data["motion_cones"], "rod_length", "rod_angle", "friction_coefficient", "radius", "weight"
    )
    return (
        "From the friction cone through the limit curve to the velocity cone. Each force inside "
        "the friction cone corresponds to a point of the limit curve; the normal there, with the "
        "same number, is the velocity of the contact. The edges of the friction cone map to those "
        f"of the velocity cone, whose right edge points away from the slider: pulling ({known})."
    )


def draw_velocities(figure: Any, data: Data) -> None:
    """Draw the three panels, with the same numbering of forces and velocities in all of them."""
    curve, picture = points(data["curves"]), Picture()
    picture.line(curve, DARK, order=3.0)
    cone = data["motion_cones"]
    titles = (
        rf"friction cone, $\mu = {mathematical(float(cone.friction_coefficient))}$",
        rf"limit curve, $l = {mathematical(float(cone.rod_length))}$",
        "velocity cone",
    )
    _panels(figure, data, picture, float(np.abs(curve).max()), "v", titles)


def accelerations_caption(data: Data) -> str:
    """Caption of the mapping to an acceleration cone."""
    cone = data["motion_cones"]
    lengths = ", ".join(number(float(length)) for length in data["curves"].rod_length)
    known = values(
        cone, "rod_length", "rod_angle", "friction_coefficient", "radius", "mass", "gyration_radius"
    )
    above = ". The fence passes above the ring" if crosses(cone) else ""
    return (
        "Without support friction, ellipses replace the limit curves (rod lengths "
        f"{lengths}); their major axes lie along the rod. The heavy ellipse is drawn with the forces "
        "of a friction cone and the accelerations that they cause, which are normal to the ellipse "
        f"and span the acceleration cone{above} ({known})."
    )


def draw_accelerations(figure: Any, data: Data) -> None:
    """Draw the three panels, with the same numbering of forces and accelerations in all of them."""
    ellipses, cone, picture = data["curves"], data["motion_cones"], Picture()
    length = float(cone.rod_length)
    add_curves(picture, ellipses, LABEL_ANGLE, bold=length)
    titles = (
        rf"friction cone, $\mu = {mathematical(float(cone.friction_coefficient))}$",
        "ellipses of four rod lengths" if ellipses.sizes["rod_length"] == 4 else "ellipses",
        rf"acceleration cone, $l = {mathematical(length)}$",
    )
    _panels(figure, data, picture, float(np.abs(points(ellipses)).max()), "a", titles)


def _panels(
    figure: Any, data: Data, middle: Picture, span: float, symbol: str, titles: tuple[str, ...]
) -> None:
    """Draw three panels from friction cone through curve to motion cone, with the same numbering.

    `middle` contains the curves, drawn to a distance `span` from the origin; `symbol` names the motion.
    """
    cone, arrows = data["motion_cones"], map_cone(data)
    first = _cone_panel(cone, "f", arrows.force_angles, titles[0])
    last = _cone_panel(cone, symbol, arrows.motion_angles, titles[2])
    _add_forces(middle, arrows, span, symbol)
    panels(figure, [first, Panel(middle, titles[1]), last], 3)


def _cone_panel(cone: xr.Dataset, name: str, angles: Array, title: str) -> Panel:
    """Panel with slider, fence, a cone at the contact, the angles of its edges, and numbered arrows."""
    picture, color = Picture(), FORCE if name == "f" else MOTION
    rod, ring = float(cone.rod_length), float(cone.radius)
    center, reach = rod * unit(float(cone.rod_angle)), 0.62 * (rod + ring)
    right = max(center[0] + ring, reach)
    add_fence(picture, -reach, right, depth=0.06 * reach)
    add_support(picture, Ring(ring), Pose(center, 0.0), Ink(width=1.6))
    add_rod(picture, center, contact=(0.0, 0.0), ink=Ink(width=1.6))
    right_edge, left_edge = np.deg2rad(angles[[0, -1]])
    picture.cone(right_edge, left_edge, reach, color)
    for edge in (angles[0], angles[-1]):
        x, y = unit(edge)
        picture.label(
            reach * unit(edge), degrees(edge), color=color, size=SMALL,
            offset=(15.0 * float(x), 8.0 * float(y)),
        )  # fmt: skip
    # Shorter than the rod, because an arrow can cover it.
    length = min(0.76 * reach, 0.7 * max(rod, ring))
    draw = picture.force if name == "f" else picture.motion
    for index, angle in enumerate(angles):
        draw((0, 0), length * unit(angle), rf"$\mathbf{{{name}}}_{index + 1}$", head=10, width=1.1)
    return Panel(picture, title, "slider")


def _add_forces(picture: Picture, arrows: Mapped, span: float, symbol: str) -> None:
    """Add forces from the origin to the curve, and the motions normal to it there."""
    for turn, name in zip((0.0, np.pi / 2), ("$f_x$", "$f_y$"), strict=True):
        picture.axis((0, 0), turn, 1.25 * span, name)
    angle = np.deg2rad(arrows.force_angles)
    picture.cone(angle[0], angle[-1], 1.12 * span, FORCE, strength=0.1)
    for index, (tip, motion) in enumerate(zip(arrows.forces, arrows.motion_angles, strict=True)):
        picture.force((0, 0), tip, rf"$\mathbf{{f}}_{index + 1}$", head=8, width=1.0, fraction=0.6,
                      offset=(0.0, 7.0))  # fmt: skip
        text = rf"$\mathbf{{{symbol}}}_{index + 1}$"
        picture.motion(tip, 0.42 * span * unit(float(motion)), text, head=8, width=1.0)


FIGURES = {
    "figure_06": Drawing(
        Figure(
            title="Friction cone, limit curve and velocity cone",
            reads=("curves", "motion_cones"),
            size=(PAGE, 2.5),
            takes=("rod_length", "friction_coefficient"),
            cuts={"effects": FRICTION},
            section="Sec. 3.1: friction cones and velocity cones",
            promise="how the friction cone of μ = 2 maps to a velocity cone through the limit curve of "
            "l = 2.",
        ),
        draw_velocities,
        velocities_caption,
    ),
    "figure_10": Drawing(
        Figure(
            title="Ellipses of the dynamic case and an acceleration cone",
            reads=("curves", "motion_cones"),
            size=(PAGE, 2.5),
            takes=("rod_length", "motion_cones.rod_length", "friction_coefficient"),
            cuts={"effects": INERTIA},
            section=DYNAMICS,
            promise="the ellipses that govern the map from force to acceleration in the pure dynamic "
            "case, for four rod lengths, and how a friction cone maps to an acceleration cone for l = 1.",
        ),
        draw_accelerations,
        accelerations_caption,
    ),
}
