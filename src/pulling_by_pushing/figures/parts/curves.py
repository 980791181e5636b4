"""Limit curves of the paper's slider, and the map from a friction cone to a motion cone."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import add_fence, add_rod
from planar_pushing.drawing.canvas.axes import Panel, is_column, panels
from planar_pushing.drawing.canvas.colors import DARK, FORCE, MOTION, rod_color
from planar_pushing.drawing.canvas.marks import NOTE, Picture, corners, unit
from planar_pushing.drawing.supports import Ink, Pose, add_support
from planar_pushing.mechanics.force.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.figures.parts.data import (
    attributed,
    degrees,
    labeled,
    mathematical,
    named,
    radius,
    rod_angle,
    scene_of,
)
from pulling_by_pushing.study.datasets.base import pushing

#: Force angles of a limit curve, degrees, dense enough for a smooth line.
ANGLES = np.linspace(0.0, 360.0, 361)
#: Force angles of a mapping, drawn between the edges of its cone, degrees.
INSIDE = (45.0, 90.0)


def forces(scene: Scene, angles: xr.DataArray) -> xr.Dataset:
    """Limit curve at force angles in degrees: force, components, and direction of motion in degrees."""
    phi = pushing(angles)
    curve = limit_curve(scene, phi)
    x, y = (phi.copy(data=each) for each in direction(phi.values).T)
    return attributed(
        xr.Dataset(
            {
                "force": curve.magnitude,
                "force_x": curve.magnitude * x,
                "force_y": curve.magnitude * y,
                "motion_angle": np.rad2deg(curve.motion_angle),
            }
        )
    )


def curves(grid: xr.Dataset, effects: str, lengths: tuple[float, ...]) -> xr.Dataset:
    """Limit curves for a set of effects at the study's rod angle, one for each rod length.

    The grid is too coarse for a smooth line, so the curves are computed here.
    """
    scene = scene_of(grid, effects, labeled("rod_length", lengths))
    found = forces(scene, labeled("force_angle", ANGLES))[["force_x", "force_y"]]
    return found.assign_coords(rod_angle=named((), rod_angle(grid), "degree", "rod angle"))


def cone_mapping(cones: xr.Dataset, effects: str, length: float, friction: float) -> xr.Dataset:
    """Forces at the edges of a friction cone and inside it, and the motions to which they map."""
    edges = cones.sel(
        effects=effects,
        rod_angle=rod_angle(cones),
        rod_length=length,
        friction_coefficient=friction,
    )
    right, left = float(edges.friction_cone_right), float(edges.friction_cone_left)
    between = [angle for angle in INSIDE if right < angle < left]
    angle = np.array([right, *between, left])
    within = forces(scene_of(cones, effects, length), labeled("force_angle", between))
    motion = [edges.motion_cone_right, *within.motion_angle, edges.motion_cone_left]
    magnitude = np.array([edges.limit_force_right, *within.force, edges.limit_force_left])
    tip = magnitude[:, None] * direction(np.deg2rad(angle))
    return xr.Dataset(
        {
            "mapped_force_x": named("map", tip[:, 0], "force", "mapped force along the fence"),
            "mapped_force_y": named("map", tip[:, 1], "force", "mapped force normal to the fence"),
            "mapped_force_angle": named("map", angle, "degree", "angle of the mapped force"),
            "mapped_motion_angle": named(
                "map", np.array(motion), "degree", "angle of the motion that the force causes"
            ),
            "mapped_rod_length": named((), length, "length", "rod length of the mapping"),
            "friction_coefficient": edges.friction_coefficient.variable,
            "radius": radius(cones),
        }
    )


def family(
    picture: Picture, data: xr.Dataset, place: float, side: str, bold: float | None = None
) -> None:
    """Draw the force curves of several rod lengths, labeled with the length at the angle `place`, degrees.

    The label of the first, outermost curve includes the symbol and is aligned to `side`; `bold` is the rod
    length of a curve to draw heavier.
    """
    for length in data.rod_length.values:
        curve = data.sel(rod_length=length)
        width = 1.2 if bold is None else (1.8 if length == bold else 0.9)
        points = np.stack([curve.force_x, curve.force_y], axis=-1)
        picture.line(points, rod_color(float(length)), width=width, order=3.0)
        at = curve.sel(force_angle=place, method="nearest")
        first = length == data.rod_length[0]
        text = f"$l = {mathematical(length)}$" if first else f"${mathematical(length)}$"
        tip = (float(at.force_x), float(at.force_y))
        picture.label(tip, text, size=NOTE, align=side if first else "center")


def mapping(
    figure: Any, data: xr.Dataset, middle: Picture, span: float, symbol: str, titles: Sequence[str]
) -> None:
    """Draw three panels from friction cone through curve to motion cone, with the same numbering.

    `middle` contains the curves, drawn to a distance `span` from the origin; `symbol` names the motion.
    """
    first, last = (
        _cone_panel(data, name, data[f"mapped_{of}_angle"].values)
        for name, of in (("f", "force"), (symbol, "motion"))
    )
    _forces_on_curve(middle, data, span, symbol)
    box = corners([(-1.25 * span, -1.1 * span), (1.35 * span, 1.3 * span)])
    given = [Panel(*first), Panel(middle, box, pad=6.0), Panel(*last)]
    named = [each._replace(title=title) for each, title in zip(given, titles, strict=True)]
    panels(figure, named, 1 if is_column(figure) else 3)


def _cone_panel(data: xr.Dataset, name: str, angles: Array) -> tuple[Picture, Array, str, float]:
    """Panel with slider, fence, a cone at the contact, the angles of its edges, and numbered arrows."""
    picture, color = Picture(), FORCE if name == "f" else MOTION
    rod, ring = float(data.mapped_rod_length), float(data.radius)
    center, reach = rod * unit(float(data.rod_angle)), 0.62 * (rod + ring)
    right = max(center[0] + ring, reach)
    low = min(center[1] - ring, -0.45 * reach if name != "f" else -0.1 * reach)
    box = corners([(-1.1 * reach, low), (right, max(center[1] + ring, 1.05 * reach))])
    add_fence(picture, -reach, right, depth=0.06 * reach)
    add_support(picture, Ring(ring), Pose(center, 0.0), Ink(width=1.6))
    add_rod(picture, center, contact=(0.0, 0.0), ink=Ink(width=1.6))
    right_edge, left_edge = np.deg2rad(angles[[0, -1]])
    picture.cone(right_edge, left_edge, reach, color)
    for edge in (angles[0], angles[-1]):
        x, y = unit(edge)
        picture.label(
            reach * unit(edge), degrees(edge), color=color, size=NOTE,
            offset=(15.0 * float(x), 8.0 * float(y)),
        )  # fmt: skip
    # Shorter than the rod, because an arrow can cover it.
    length = min(0.76 * reach, 0.7 * max(rod, ring))
    draw = picture.force if name == "f" else picture.motion
    for index, angle in enumerate(angles):
        draw((0, 0), length * unit(angle), rf"$\mathbf{{{name}}}_{index + 1}$", head=10, width=1.1)
    return picture, box, "", 20.0


def _forces_on_curve(picture: Picture, data: xr.Dataset, span: float, symbol: str) -> None:
    """Add forces from the origin to the curve, and the motions normal to it there."""
    for turn, name in zip((0.0, np.pi / 2), ("$f_x$", "$f_y$"), strict=True):
        picture.axis((0, 0), turn, 1.25 * span, name)
    angle = np.deg2rad(data.mapped_force_angle.values)
    picture.cone(angle[0], angle[-1], 1.12 * span, FORCE, strength=0.1)
    tips = np.stack([data.mapped_force_x, data.mapped_force_y], axis=-1)
    for index, (tip, motion) in enumerate(zip(tips, data.mapped_motion_angle.values, strict=True)):
        picture.force((0, 0), tip, rf"$\mathbf{{f}}_{index + 1}$", head=8, width=1.0, at=0.6,
                      offset=(0.0, 7.0))  # fmt: skip
        text = rf"$\mathbf{{{symbol}}}_{index + 1}$"
        picture.motion(tip, 0.42 * span * unit(float(motion)), text, head=8, width=1.0)


def curve_picture(data: xr.Dataset) -> tuple[Picture, float]:
    """Picture of one curve, and its largest coordinate."""
    points = np.stack([data.force_x, data.force_y], axis=-1)
    picture = Picture()
    picture.line(points, DARK, order=3.0)
    return picture, float(np.abs(points).max())
