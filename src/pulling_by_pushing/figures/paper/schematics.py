"""Figures of one solution of a scene: 2, 3, 4, 8 and 11."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import add_body, add_fence
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, GUIDE, MOTION, PUSHER
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Arrow, Picture, unit
from planar_pushing.drawing.canvas.panels import Panel, panels
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.drawing.scene import (
    add_center,
    add_center_mark,
    add_force,
    add_friction,
    add_line_of_force,
    add_motion,
    add_pusher,
    add_slider,
)
from planar_pushing.drawing.sketch import MOTION_CONE, Sketch
from planar_pushing.drawing.words import best_row
from planar_pushing.mechanics.plane import Array, direction
from pulling_by_pushing.figures.captions import acceleration, degrees, number, values
from pulling_by_pushing.figures.figure import DYNAMICS, STATICS, Data, Drawing, Figure

if TYPE_CHECKING:
    import xarray as xr

#: Points per unit of length by figure; 2 and 3 are to be compared, and a column has room for the others.
SCALES = {"balance": 42.0, "coordinates": 46.0, "slip": 27.3, "both": 29.0}
#: Quantities of a quasi-static scene given in a caption.
QUASI_STATIC = ("rod_length", "rod_angle", "friction_coefficient", "radius", "weight")


def solution(data: Data) -> xr.Dataset:
    """The scene with the solution to draw: sticking, otherwise the first that moves or the first."""
    (scene,) = data.values()
    return scene.isel(solution=best_row(scene["mode"].values))


def angle_of(one: xr.Dataset, name: str) -> str:
    """Angle of a vector of the solution, for a caption."""
    x, y = one[name].values.reshape(-1, 2)[0]
    return f"{np.rad2deg(np.arctan2(y, x)):.1f}°".replace("-", "−")


# -- Figures 2 and 3 -----------------------------------------------------------------------------------


def pushing_caption(data: Data) -> str:
    """Caption of quasi-static pushing."""
    one = solution(data)
    return (
        "Quasi-static pushing. The slider turns about the velocity center, and the support "
        "friction, drawn along the ring, balances the force f of the pusher. The line of force "
        "is the mirror image about the rod of that in Fig. 3. The pusher moves into the slider (f at "
        f"{angle_of(one, 'force')}, vₛ at {angle_of(one, 'contact_motion')}; "
        f"{values(one, *QUASI_STATIC)})."
    )


def pulling_caption(data: Data) -> str:
    """Caption of quasi-static pulling."""
    one = solution(data)
    return (
        "Quasi-static pulling, at the scale of Fig. 2. The line of the force f passes on the other "
        "side of the ring's center, far enough from it that the contact moves below the fence. It "
        f"sticks although the pusher moves away from the slider (f at {angle_of(one, 'force')}, "
        f"vₛ at {angle_of(one, 'contact_motion')}; {values(one, *QUASI_STATIC)})."
    )


def draw_balance(figure: Any, data: Data) -> None:
    """Draw the solution with the friction of the support."""
    sketch, picture = Sketch.of_dataset(solution(data)), Picture()
    add_slider(picture, sketch)
    one = sketch.solution
    assert one is not None
    for add in (add_force, add_line_of_force, add_motion, add_center):
        add(picture, sketch, one)
    add_pusher(picture, sketch)
    add_friction(picture, sketch)
    panels(figure, [Panel(picture)], scale=SCALES["balance"])


# -- Figure 4 ------------------------------------------------------------------------------------------

#: Direction of the marked element of the ring, degrees from the x' axis.
ELEMENT = 118.0


def coordinates_caption(data: Data) -> str:
    """Caption of the coordinate systems."""
    one = solution(data)
    return (
        "Coordinates: x and y are fixed to the pusher; x′ and y′ have their origin at the ring's "
        "center, with y′ along the force f. The ring's center moves at v along y′ and the slider "
        "turns at ω, so that the velocity center lies at −v/ω on the x′ axis; θ is the direction of an "
        f"element of the ring in Eqs. (1) to (3) (f at {angle_of(one, 'force')}; "
        f"{values(one, *QUASI_STATIC)})."
    )


def draw_coordinates(figure: Any, data: Data) -> None:
    """Draw the slider, the fence and the force with both pairs of axes."""
    sketch, picture = Sketch.of_dataset(solution(data)), Picture()
    ring, radius = sketch.center, sketch.half
    one = sketch.solution
    assert one is not None
    phi, psi = math.atan2(one.force[1], one.force[0]), sketch.pose.angle
    long = 1.9 * radius
    add_fence(picture, -0.9, ring[0] + radius, depth=0.14 * radius)
    add_body(picture, sketch.body, sketch.pose)
    picture.axis((0, 0), 0.0, ring[0] + 1.25 * radius, "$x$", DARK)
    picture.axis((0, 0), math.pi / 2, 2.1 * radius, "$y$", DARK)
    picture.axis(ring, phi - math.pi / 2, long, "$x$\N{PRIME}", DARK)
    picture.axis(ring, phi, long, "$y$\N{PRIME}", DARK)
    picture.force((0, 0), 1.15 * np.array([math.cos(phi), math.sin(phi)]), r"$\mathbf{f}$")
    picture.angle(0.0, phi, 0.95, r"$\phi$", color=FORCE, fraction=0.45, offset=0.0)
    picture.angle(0.0, psi, 0.5, r"$\psi$", color=DARK)
    _center_motion(picture, ring, one.center, one.twist, phi)
    _element(picture, ring, radius, math.degrees(phi) - 90)
    picture.label(0.6 * ring, "$l$", offset=(-6.0, 6.0), held=True)
    panels(figure, [Panel(picture)], scale=SCALES["coordinates"])


def _center_motion(picture: Picture, ring: Any, center: Any, twist: Any, phi: float) -> None:
    """Draw the velocity of the ring's center, the rotation, and the distance to the velocity center."""
    ahead = np.array([math.cos(phi), math.sin(phi)])
    picture.motion(ring, 0.75 * ahead * np.sign(twist[:2] @ ahead), "$v$", color=MOTION, head=11.0)
    picture.turn_arrow(center, float(twist[2]), 0.26, CENTER)
    picture.label(center, r"$\omega$", color=CENTER, offset=(20.0, 4.0))
    add_center_mark(picture, center)
    below = -0.34 * ahead
    for end, other in ((ring + below, center + below), (center + below, ring + below)):
        picture.add(Arrow(np.array([other, end]), GUIDE, True, 0.7, 7.0))
    for end in (ring, center):
        picture.guide(end, end + 1.15 * below, dash=":")
    away = 9.0 * -ahead
    middle = (ring + center) / 2 + below
    picture.label(
        middle, r"$-v/\omega$", color=GUIDE, size=NOTE + 1, offset=tuple(map(float, away))
    )


def _element(picture: Picture, ring: Any, radius: float, start: float) -> None:
    """Draw an element of the ring and its direction from the x' axis."""
    element = ring + radius * unit(start + ELEMENT)
    picture.guide(ring, element)
    picture.dot(element, 4.5, DARK)
    ends = math.radians(start), math.radians(start + ELEMENT)
    picture.angle(*ends, 0.32, r"$\theta$", vertex=ring, fraction=0.72)


# -- Figure 8 ------------------------------------------------------------------------------------------


def slip_caption(data: Data) -> str:
    """Caption of slip with infinite friction."""
    one = solution(data)
    right, left = (f"{float(one[f'motion_cone_{side}']):.1f}°" for side in ("right", "left"))
    known = values(one, "pusher_angle", *QUASI_STATIC)
    return (
        "Slip with infinite friction. The pusher velocity lies to the left of the shaded velocity "
        f"cone, which extends from {right} to {left}, so that the contact slips to the right: f and "
        "the contact velocity lie on the left edges of their cones, and f points along the fence "
        f"({known})."
    ).replace("-", "−")


def draw_slip(figure: Any, data: Data) -> None:
    """Draw the solution with its velocity cone and the angles of the cone's edges."""
    scene, picture = solution(data), Picture()
    sketch = Sketch.of_dataset(scene)
    one, reach = sketch.solution, sketch.reach
    assert one is not None
    left = -1.55 * reach
    add_slider(picture, sketch, left=left, right=sketch.center[0] + sketch.half)
    radius = MOTION_CONE * reach
    picture.cone(*sketch.motion, radius, MOTION, order=AREAS + 0.5)
    for edge, offset in zip(sketch.motion, ((4.0, -8.0), (-4.0, 9.0)), strict=True):
        text = degrees(math.degrees(edge))
        picture.label(radius * direction(edge), text, color=MOTION, size=NOTE, offset=offset)
    for add in (add_force, add_motion, add_center):
        add(picture, sketch, one)
    add_pusher(picture, sketch)
    text = rf"$\theta_p = {float(scene.pusher_angle):g}^\circ$"
    tip = sketch.motion_scale * scene.pusher_motion.values
    picture.label(tip, text, color=PUSHER, size=NOTE, offset=(-4.0, 13.0), held=True)
    panels(figure, [Panel(picture)], scale=SCALES["slip"])


# -- Figure 11 -----------------------------------------------------------------------------------------

#: Drawn length of the pusher's force, in units of the reach.
LENGTH = 0.84


def both_caption(data: Data) -> str:
    """Caption of pulling with friction and inertia."""
    one = solution(data)
    known = values(one, *QUASI_STATIC, "mass", "gyration_radius")
    return (
        "Pulling from rest, with support friction and inertia. For an acceleration center on the "
        "ring, the support friction and the inertial force act along one line, whatever their "
        "magnitudes. This line is tangent to the ring opposite the center. The force f of the pusher "
        f"balances them (f at {angle_of(one, 'force')}, aₛ at {angle_of(one, 'contact_motion')}; "
        f"{known}, |aₚ| = {number(acceleration(one))}\N{NO-BREAK SPACE}μₛg)."
    )


def draw_both(figure: Any, data: Data) -> None:
    """Draw the solution with the friction around the ring and both resistances on the line of force."""
    scene, picture = solution(data), Picture()
    sketch = Sketch.of_dataset(scene)
    one = sketch.solution
    assert one is not None
    add_slider(picture, sketch)
    for add in (add_line_of_force, add_motion, add_center):
        add(picture, sketch, one)
    add_friction(picture, sketch)
    scale = LENGTH * sketch.reach / float(np.hypot(*one.force))
    picture.force((0, 0), scale * one.force, r"$\mathbf{f}$", width=1.6)
    heading = one.force / np.hypot(*one.force)
    foot = (heading @ sketch.center) * heading
    picture.guide(sketch.center, foot, dash=":")
    picture.dot(foot, 3.0, FORCE)
    for text, force in resistances(scene).items():
        tip = scale * force
        picture.force(foot, tip, width=1.4, head=11.0)
        picture.label(
            foot + tip / 2, text, color=FORCE, offset=(5.0, -6.0), align="left", held=True
        )
        foot = foot + tip
    panels(figure, [Panel(picture)], scale=SCALES["both"])


def resistances(scene: xr.Dataset) -> dict[str, Array]:
    """The two forces that balance the pusher's, by their labels; they lie on its line."""
    inertial = -float(scene.mass) * scene.twist.values[0, :2]
    return {"friction": -scene.force.values[0] - inertial, r"$-m\,\mathbf{a}$": inertial}


FIGURES = {
    "figure_02": Drawing(
        Figure(
            title="Quasi-static pushing",
            reads=("scenes/figure_02",),
            size=(COLUMN, 2.8),
            section=STATICS,
            promise="quasi-static pushing.",
        ),
        draw_balance,
        pushing_caption,
    ),
    "figure_03": Drawing(
        Figure(
            title="Quasi-static pulling",
            reads=("scenes/figure_03",),
            size=(COLUMN, 3.1),
            section=STATICS,
            promise="quasi-static pulling.",
        ),
        draw_balance,
        pulling_caption,
    ),
    "figure_04": Drawing(
        Figure(
            title="Coordinates",
            reads=("scenes/figure_02",),
            size=(COLUMN, 3.0),
            section=STATICS,
            promise="the conventions for the coordinates.",
        ),
        draw_coordinates,
        coordinates_caption,
    ),
    "figure_08": Drawing(
        Figure(
            title="Slip with infinite friction",
            reads=("scenes/figure_08",),
            size=(COLUMN, 2.6),
            section="Sec. 3.2: slip with infinite friction",
            promise="slip with infinite friction for l = 5.",
        ),
        draw_slip,
        slip_caption,
    ),
    "figure_11": Drawing(
        Figure(
            title="Pulling with support friction and inertia",
            reads=("scenes/figure_11",),
            size=(COLUMN, 3.3),
            section=DYNAMICS,
            promise="an example of pulling with support friction and inertia, l = 5.",
        ),
        draw_both,
        both_caption,
    ),
}
