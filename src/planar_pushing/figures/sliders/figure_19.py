"""Figure 19: a tripod that pivots."""

from __future__ import annotations

import json

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.curves import degrees, named, titled
from planar_pushing.figures.settings import Sources
from planar_pushing.figures.sliders.flats import flats, limit_line
from planar_pushing.figures.sliders.gallery import limit_forces, scene
from planar_pushing.figures.sliders.pivoting import distance_over_time, motion, snapshots
from planar_pushing.figures.style import DARK, FORCE, NOTE_SIZE
from planar_pushing.mechanics.cones import friction_cone, motion_cone
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.study_model import SliderEntry

LOG = "simulations/tripod"
#: Force angles of a curve, degrees.
ANGLES = np.linspace(0.0, 360.0, 1441)
#: The instants whose limit curves are drawn.
INSTANTS = ("at the start", "at the end")
#: Half the width of a panel of a limit curve, in units of the weight, and length of the motions in it.
SPAN, LENGTH = 1.0, 0.4
#: A motion cone that is narrower, degrees, has no width: rounding is left of it.
NARROW = 1e-9


def select(sources: Sources, settings: SliderEntry) -> xr.Dataset:
    """Select the motion over time; compute limit curve and cones at its start and at its end."""
    log = sources[LOG]
    file = SceneFile.model_validate(json.loads(log.attrs["scene"]))
    own = file.build()
    data = motion(log, own.friction[0].support, float(own.slider.radius))
    data["rod_length"] = named((), float(own.slider.rod_length), "length", "rod length")
    parts = [_instant(own, float(angle)) for angle in log.rod_angle.values[[0, -1]]]
    index = xr.Variable("instant", list(INSTANTS), {"units": "1", "long_name": "instant"})
    return titled(data.merge(xr.concat(parts, index)), "A tripod that pivots", sources)


def _instant(own: Scene, angle: float) -> xr.Dataset:
    """Limit curve with its pivots, and the edges of both cones, at a rod angle in degrees."""
    support, length = own.friction[0].support, float(own.slider.rod_length)
    here = scene({"": support}, length, angle, own.contact)
    forces, pivots = limit_forces(here, ANGLES)
    moved, allowed = motion_cone(here), friction_cone(here)
    edges = np.array([allowed.right, allowed.left], dtype=float)
    motions = np.rad2deg(np.array([moved.right.item(), moved.left.item()]))
    curve = ("force_angle", "xy")
    text = "number of the support point about which the slider pivots, -1 without one"
    found = {
        "rod_angle": named((), angle, "degree", "rod angle"),
        "limit_force": named(curve, forces[0], "force", "force on the limit curve"),
        "pivot": named("force_angle", pivots[0], "1", text),
        "friction_edge": named("edge", np.rad2deg(edges), "degree", "edge of the friction cone"),
        "motion_edge": named("edge", motions, "degree", "edge of the motion cone"),
    }
    phi = named("force_angle", ANGLES, "degree", "force angle")
    edge = named("edge", ["right", "left"], "1", "edge of the cone")
    return xr.Dataset(found, {"force_angle": phi, "edge": edge})


def draw(figure: Figure, data: xr.Dataset) -> None:
    """Draw the motion, the limit curves at both ends of it, and the distance of the motion center."""
    snapshots(figure, data, (0.0, 0.0, 0.36, 1.0))
    for place, left in zip((0, 1), (0.37, 0.69), strict=True):
        _curve(figure, data.isel(instant=place), (left, 0.31, 0.31, 0.55))
    distance_over_time(figure.add_axes((0.47, 0.125, 0.5, 0.17)), data)


def _curve(figure: Figure, one: xr.Dataset, rect: tuple[float, float, float, float]) -> None:
    """Limit curve with its flats, the friction cone, and the motions at its edges."""
    ax = drawing.schematic(figure, (-SPAN, SPAN, -0.75 * SPAN, SPAN), rect=rect, pad=3.0)
    forces, edges = one.limit_force.values, one.friction_edge.values
    drawing.cone(ax, (0, 0), edges[0], edges[1], 1.05 * SPAN, FORCE, strength=0.12)
    limit_line(ax, forces, one.pivot.values)
    for number, part in flats(one.pivot.values):
        middle = forces[part].mean(axis=0)
        offset = tuple(7.0 * middle / np.hypot(*middle))
        labels.label(ax, middle, str(number), offset=offset, size=NOTE_SIZE, color=FORCE)
    for edge, motion_edge in zip(edges, one.motion_edge.values, strict=True):
        tip = _on_curve(forces, float(edge))
        arrows.force_arrow(ax, (0, 0), tip, head=8, width=1.0)
        arrows.motion_arrow(ax, tip, LENGTH * arrows.unit(float(motion_edge)), head=8, width=1.0)
    width = float(np.ptp(one.motion_edge.values))
    wide = f"{degrees(width)} wide" if width > NARROW else "of no width"
    angle = rf"$\psi = {float(one.rod_angle):.0f}^\circ$"
    ax.set_title(f"{one.instant.item()}, {angle}:\nmotion cone {wide}", color=DARK)


def _on_curve(forces: Array, angle: float) -> Array:
    """Point of a limit curve at a force angle in degrees."""
    return np.array([np.interp(angle, ANGLES, forces[:, i]) for i in (0, 1)])
