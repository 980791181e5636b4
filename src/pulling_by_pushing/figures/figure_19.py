"""Figure 19: a tripod that pivots."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.drawing.body import scene_in
from planar_pushing.drawing.canvas.axes import is_column, schematic, to_axes
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE
from planar_pushing.drawing.canvas.marks import NOTE, Picture, unit
from planar_pushing.drawing.canvas.style import COLUMN, PAGE
from planar_pushing.drawing.motion import add_paths, box, snapshots
from planar_pushing.drawing.scene import limit_line
from planar_pushing.drawing.timeline import plotted
from planar_pushing.mechanics.force.cones import friction_cone, motion_cone
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from pulling_by_pushing.figures.figure import Figure, Settings, Sources
from pulling_by_pushing.figures.parts.data import degrees, named, number, titled, values
from pulling_by_pushing.figures.parts.gallery import SECTION, flat_parts, limit_forces, scene
from pulling_by_pushing.figures.parts.pushes import told

FIGURE = Figure(
    title="A tripod that pivots",
    reads=("simulations/tripod",),
    size=(PAGE, 3.5),
    column=(COLUMN, 6.6),
    section=SECTION,
)
#: Force angles of a curve, degrees.
ANGLES = np.linspace(0.0, 360.0, 1441)
#: Instants with a limit curve, and number of instants drawn of the motion.
INSTANTS, COUNT = ("at the start", "at the end"), 3
#: Half the width of a limit-curve panel and length of the motions in it, in units of the weight.
SPAN, LENGTH = 1.0, 0.4
#: A motion cone narrower than this, degrees, is a single direction up to rounding.
NARROW = 1e-9


def select(sources: Sources, settings: Settings) -> xr.Dataset:
    """Select the motion over time; compute the limit curve and the cones at its start and end."""
    log = sources["simulations/tripod"]
    own, data = scene_in(log.attrs["scene"]), plotted(log)
    points = own.friction[0].support.positions
    data["support_point"] = named(
        ("point", "xy"), points, "length", "support point in the body frame"
    )
    gaps = np.stack([np.hypot(*(place - data.path_center.values).T) for place in feet(data)])
    last = int(np.argmin(gaps[:, -1]))
    data["pivot_point"] = named((), last, "1", "number of the support point that is the last pivot")
    text = "distance of the motion center from the last pivot"
    data["center_distance"] = named("time", gaps[last], "length", text)
    parts = [_instant(own, float(angle)) for angle in log.rod_angle.values[[0, -1]]]
    index = xr.Variable("instant", list(INSTANTS), {"units": "1", "long_name": "instant"})
    return titled(data.merge(xr.concat(parts, index)), "A tripod that pivots", sources)


def feet(data: xr.Dataset) -> Array:
    """Positions of the support points over time, shape (point, time, 2)."""
    x, y = data.support_point.values.T[:, :, None]
    angle = np.deg2rad(data.path_rod_angle.values)
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(data.path_position.values + np.stack([c * x - s * y, s * x + c * y], axis=-1))


def _instant(own: Scene, angle: float) -> xr.Dataset:
    """Limit curve with its pivots, and the edges of both cones, for a rod angle in degrees."""
    support, length = own.friction[0].support, float(own.slider.rod_length)
    law: Any = own.contact
    here = scene({"": support}, length, angle, law)
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


def caption(data: xr.Dataset) -> str:
    """Caption with the plotted values."""
    distance = number(float(np.hypot(*data.support_point.values[0])))
    start = number(float(data.path_rod_angle.values[0]))
    return (
        "A tripod that pivots. As the fence moves up, the contact slips and the motion center "
        "moves along the dashed path until it reaches a foot, where it stays. Slider, fence and "
        "force are shown at the labeled instants. Right: limit curves at the start and at the end, "
        "with the friction cone (shaded), the forces at its edges and the motions that they cause. "
        "At the end both edges lie on the flat of one foot, and the motion cone is a single "
        "direction. Each flat has the number of its foot "
        f"({values(data, 'friction_coefficient', 'weight')}, l = "
        f"{number(float(data.rod_length))}, ψ = {start}° at time 0, feet at {distance} from the "
        f"center; {told(data)})."
    )


def draw(figure: Any, data: xr.Dataset) -> None:
    """Draw the motion, the limit curves at its start and end, and the distance of the motion center."""
    if is_column(figure):
        places = (
            (0.0, 0.47, 1.0, 0.53),
            [(0.0, 0.2, 0.5, 0.2), (0.5, 0.2, 0.5, 0.2)],
            (0.22, 0.07, 0.75, 0.1),
        )
    else:
        places = (
            (0.0, 0.0, 0.4, 1.0),
            [(0.4, 0.33, 0.3, 0.52), (0.7, 0.33, 0.3, 0.52)],
            (0.5, 0.13, 0.47, 0.14),
        )
    _motion(schematic(figure, places[0]), data)
    for place, rect in enumerate(places[1]):
        _curve(schematic(figure, rect), data.isel(instant=place))
    ax = figure.add_axes(places[2])
    ax.plot(data.time, data.center_distance, color=CENTER)
    ax.set(xlim=(float(data.time[0]), float(data.time[-1])), ylim=(0.0, None), xlabel="time")
    ax.set_ylabel(f"distance of\ncenter to foot {int(data.pivot_point)}", color=DARK)


def _motion(ax: Any, data: xr.Dataset) -> None:
    """Draw slider and fence at some instants, the path of the motion center, and the feet's numbers."""
    frame = box(data)
    frame[:, 0] = np.clip(frame[:, 0], -1.6, None)
    picture = snapshots(data, frame, COUNT)
    add_paths(picture, data, frame)
    for foot, place in enumerate(feet(data)[:, 0]):
        x, y = place - data.path_position.values[0]
        away = 9.0 / float(np.hypot(x, y))
        picture.label(place, str(foot), offset=(away * float(x), away * float(y)), size=NOTE)
    to_axes(picture, ax, frame, 14.0)


def _curve(ax: Any, one: xr.Dataset) -> None:
    """Draw the limit curve with its flats, the friction cone, and the motions at its edges."""
    picture, forces = Picture(), one.limit_force.values
    edges = np.deg2rad(one.friction_edge.values)
    for along in (unit(0.0), unit(90.0)):
        picture.line([-SPAN * along, SPAN * along], "#BBBBBB", width=0.4, order=1.0)
    picture.cone(edges[0], edges[1], 0.95 * SPAN, FORCE, strength=0.12)
    flat = flat_parts(one.pivot.values)
    limit_line(picture, forces, [part for _, part in flat], order=3.0)
    for foot, part in flat:
        x, y = forces[part].mean(axis=0)
        away = 8.0 / float(np.hypot(x, y))
        picture.label(
            (x, y), str(foot), offset=(away * float(x), away * float(y)), size=NOTE, color=FORCE
        )
    for edge, motion in zip(one.friction_edge.values, one.motion_edge.values, strict=True):
        tip = np.array([np.interp(float(edge), ANGLES, forces[:, i]) for i in (0, 1)])
        picture.force((0, 0), tip, head=8, width=1.0)
        picture.motion(tip, LENGTH * unit(float(motion)), head=8, width=1.0)
    width = float(np.ptp(one.motion_edge.values))
    wide = f"{degrees(width)} wide" if width > NARROW else "a single direction"
    to_axes(picture, ax, np.array([(-SPAN, -0.8 * SPAN), (SPAN, SPAN)]), 3.0)
    ax.set_title(
        rf"{one.instant.item()}, $\psi = {float(one.rod_angle):.0f}^\circ$:"
        f"\nmotion cone {wide}",
        color=DARK,
    )
