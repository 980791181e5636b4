"""Figure 4: the two coordinate systems."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import add_body, add_fence
from planar_pushing.drawing.canvas.axes import Panel, panels
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, GUIDE, MOTION
from planar_pushing.drawing.canvas.marks import NOTE, Arrow, Picture, corners, unit
from planar_pushing.drawing.canvas.style import COLUMN
from planar_pushing.drawing.scene import add_center_mark
from planar_pushing.drawing.sketch import Sketch
from pulling_by_pushing.figures.figure import STATICS, Figure, Settings, Sources
from pulling_by_pushing.figures.parts.solutions import angle_of, of_scene, shown

FIGURE = Figure(
    title="Coordinates",
    reads=("scenes/figure_02",),
    size=(COLUMN, 3.0),
    section=STATICS,
    promise="the conventions for the coordinates.",
)
#: Direction of the marked element of the ring, degrees from the x' axis.
ELEMENT = 118.0


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the solution of quasi-static pushing."""
    return shown(sources, "figure_02").assign_attrs(title="Coordinate systems (Fig. 4)")


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    return (
        "Coordinates: x and y are fixed to the pusher; x′ and y′ have their origin at the ring's "
        "center, with y′ along the force f. The ring's center moves at v along y′ and the slider "
        "turns at ω, so that the velocity center lies at −v/ω on the x′ axis; θ is the direction of an "
        f"element of the ring in Eqs. (1) to (3) (f at {angle_of(data, 'force')}; {of_scene(data)})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the slider, the fence and the force with both pairs of axes."""
    sketch, picture = Sketch.of_dataset(data), Picture()
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
    picture.force((0, 0), 1.4 * np.array([math.cos(phi), math.sin(phi)]), r"$\mathbf{f}$")
    picture.angle(0.0, phi, 0.95, r"$\phi$", color=FORCE, at=0.75)
    picture.angle(0.0, psi, 0.6, r"$\psi$", color=DARK, at=0.5)
    _motion(picture, ring, one.center, one.twist, phi)
    _element(picture, ring, radius, math.degrees(phi) - 90)
    picture.label(0.42 * ring, "$l$", offset=(7.0, -7.0))
    box = corners([(-0.9, -0.3), ring + np.array([long, 1.9 * radius]), (0, 2.3 * radius)])
    panels(figure, [Panel(picture, box, pad=10.0)])


def _motion(picture: Picture, ring: Any, center: Any, twist: Any, phi: float) -> None:
    """Draw the velocity of the ring's center, the rotation, and the distance to the velocity center."""
    ahead = np.array([math.cos(phi), math.sin(phi)])
    picture.motion(ring, 0.75 * ahead * np.sign(twist[:2] @ ahead), "$v$", color=MOTION, head=11.0)
    picture.turning(center, float(twist[2]), 0.26, CENTER)
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
    place = ring + radius * unit(start + ELEMENT)
    picture.guide(ring, place)
    picture.dot(place, 4.5, DARK)
    ends = math.radians(start), math.radians(start + ELEMENT)
    picture.angle(*ends, 0.32, r"$\theta$", vertex=ring, at=0.72)
