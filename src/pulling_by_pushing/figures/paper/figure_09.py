"""Figure 9: acceleration centers and acceleration cones for two coefficients of friction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from planar_pushing.drawing.body import Body, add_body, add_fence
from planar_pushing.drawing.canvas.colors import CENTER, FORCE, MOTION, PUSHER
from planar_pushing.drawing.canvas.marks import LINES, Picture, unit
from planar_pushing.drawing.canvas.panels import Panel, panels
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.supports import Pose
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.captions import degrees, mathematical, number, values
from pulling_by_pushing.figures.figure import DYNAMICS, Data, Figure

if TYPE_CHECKING:
    import xarray as xr

FIGURE = Figure(
    title="Acceleration cones and centers",
    reads=("scenes/figure_09a", "scenes/figure_09b"),
    size=(PAGE, 3.2),
    section=DYNAMICS,
    promise="acceleration cones for l = 2 with (a) μ = 2 and (b) μ = ∞.",
)
PANELS = ("a", "b")
#: Corners of a panel, units of length.
BOX = np.array([(-2.15, -1.35), (4.1, 3.9)])
#: Radii of the cones, lengths of the arrows along their edges, and length of the pusher's arrow.
RADII, LENGTHS, PUSH = (1.1, 0.8), (1.5, 1.35), 1.95


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    scenes = list(data.values())
    pushes = ", ".join(
        f"({letter}) μ = {number(float(scene.friction_coefficient))}, "
        f"aₚ at {number(float(scene.pusher_angle), 4)}°"
        for letter, scene in zip(PANELS, scenes, strict=True)
    )
    known = values(scenes[0], "rod_length", "rod_angle", "radius", "mass", "gyration_radius")
    return (
        "Acceleration cones for inertia alone, from rest. The acceleration centers c_r and c_l are "
        "the force duals of the edges f_r and f_l of the friction cone. The friction cone allows "
        "the heavy part of the line of centers, which passes through infinity, with "
        "counterclockwise (+) or clockwise (−) rotation. (a) The pusher's acceleration aₚ is "
        "inside the acceleration cone and points away from the slider: pulling is consistent. "
        "(b) aₚ points above the fence and is outside the cone: slip is the only solution "
        f"({pushes}; {known})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw a panel for each coefficient of friction."""
    drawn = []
    for letter, scene in zip(PANELS, data.values(), strict=True):
        picture = Picture()
        _slider_and_cones(picture, scene)
        _line_of_centers(picture, scene)
        text = rf"({letter})  $\mu = {mathematical(float(scene.friction_coefficient))}$"
        drawn.append(Panel(picture, text, "slider"))
    panels(figure, drawn, 2)


def _slider_and_cones(picture: Picture, scene: xr.Dataset) -> None:
    pose = Pose(scene.ring_center.values, math.radians(float(scene.rod_angle)))
    add_fence(picture, BOX[0, 0] + 0.1, BOX[1, 0] - 0.1, depth=0.14)
    add_body(picture, Body(support=Ring(float(scene.radius))), pose)
    for edges, radius, length, color, letter, strength in (
        (_edges(scene, "motion"), RADII[0], LENGTHS[0], MOTION, "a", 0.14),
        (_edges(scene, "friction"), RADII[1], LENGTHS[1], FORCE, "f", 0.34),
    ):
        # A darker friction cone, so that the cones differ in gray too.
        picture.cone(*edges, radius, color, strength=strength)
        draw = picture.force if letter == "f" else picture.motion
        for side, edge in zip("rl", edges, strict=True):
            angle = math.degrees(edge)
            tip, text = length * unit(angle), rf"$\mathbf{{{letter}}}_{side}$"
            draw((0, 0), tip)
            # The label of a force along the fence is above it, off the hatching.
            shift = 11.0 * float(np.cos(edge)), 7.0
            if letter == "a":
                text = f"{text}, {degrees(angle)}"
                shift = -5.0, 10.0 * float(np.sign(np.sin(edge)))
            picture.label(tip, text, color=color, offset=shift, held=True)
    x, y = push = PUSH * unit(float(scene.pusher_angle))
    picture.motion((0, 0), push, color=PUSHER, order=5.5)
    shift = 10.0 * float(np.sign(x)), 5.0 * float(np.sign(y))
    picture.label(push, r"$\mathbf{a}_p$", color=PUSHER, offset=shift, held=True)


def _edges(scene: xr.Dataset, name: str) -> tuple[float, float]:
    right, left = (math.radians(float(scene[f"{name}_cone_{side}"])) for side in ("right", "left"))
    return right, left


def _line_of_centers(picture: Picture, scene: xr.Dataset) -> None:
    """Draw the line of centers and, on it, the interval between the duals of the cone's edges."""
    centers = scene["cone_center"].sel(effect="inertia")
    right, left = centers.values[0], centers.values[-1]
    psi = float(scene["rod_angle"])
    along = unit(psi + 90)
    ends = [right + reach * along for reach in _reaches(right, along)]
    picture.guide(ends[0], ends[1], CENTER)
    if not float(scene["friction_cone_right"]) < psi < float(scene["friction_cone_left"]):
        _add_allowed_centers(picture, right, left)
    else:
        # A force along the rod translates the slider: the centers pass through infinity.
        for start, stop, sign in ((right, ends[1], 1.0), (left, ends[0], -1.0)):
            _add_allowed_centers(picture, start, stop)
            middle = 0.36 * start + 0.64 * stop
            picture.turn_arrow(middle, sign, 0.22, CENTER)
            text = "$+$" if sign > 0 else "\N{MINUS SIGN}"
            picture.label(middle, text, offset=(12.0, 12.0), color=CENTER)
            picture.label(stop, r"$\infty$", offset=(-10.0, -4.0), color=CENTER)
    _marks(picture, right, left)


def _reaches(point: Array, along: Array) -> tuple[float, float]:
    """Signed distances along a line from a point to the two sides of the picture."""
    low, high = BOX + np.array([[0.25], [-0.25]])
    with np.errstate(divide="ignore"):
        to_low, to_high = (low - point) / along, (high - point) / along
    near, far = np.minimum(to_low, to_high), np.maximum(to_low, to_high)
    return float(np.max(near)), float(np.min(far))


def _add_allowed_centers(picture: Picture, start: Array, stop: Array) -> None:
    picture.line([start, stop], CENTER, width=2.0, order=LINES + 1.5)


def _marks(picture: Picture, right: Array, left: Array) -> None:
    if np.allclose(right, left):
        add_center_mark(picture, right)
        text = r"$\mathbf{c}_r = \mathbf{c}_l$"
        picture.label(right, text, offset=(-26.0, -2.0), color=CENTER)
        return
    for center, side in ((right, "r"), (left, "l")):
        add_center_mark(picture, center)
        picture.label(center, rf"$\mathbf{{c}}_{side}$", offset=(11.0, 5.0), color=CENTER)
