"""Figure 19: a tripod that pivots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from planar_pushing.drawing.body import body_in
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE
from planar_pushing.drawing.canvas.marks import NOTE, Picture, unit
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import add_paths, box, snapshots
from planar_pushing.drawing.scene import limit_line
from planar_pushing.drawing.timeline import plotted
from planar_pushing.mechanics.plane import Array
from pulling_by_pushing.figures.captions import degrees, number, pusher_motion, values
from pulling_by_pushing.figures.figure import Data, Figure
from pulling_by_pushing.figures.parts.gallery import SECTION, curve, flat_parts

if TYPE_CHECKING:
    import xarray as xr

LOG, CURVES = "simulations/tripod", "support_curves"
FIGURE = Figure(
    title="A tripod that pivots",
    reads=(LOG, CURVES),
    cuts={CURVES: {"support": "tripod"}},
    size=(PAGE, 3.5),
    section=SECTION,
)
#: Instants with a limit curve, and number of instants drawn of the motion.
INSTANTS, COUNT = ("at the start", "at the end"), 3
#: Half the width of a limit-curve panel and length of the motions in it, in units of the weight.
SPAN, LENGTH = 1.0, 0.4
#: A motion cone narrower than this, degrees, is a single direction up to rounding.
NARROW = 1e-9


def feet(log: xr.Dataset) -> Array:
    """Positions of the support points over time, shape (point, time, 2)."""
    x, y = np.transpose(body_in(log).support.positions)[:, :, None]
    angle = np.deg2rad(log.rod_angle.values)
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(log.position.values + np.stack([c * x - s * y, s * x + c * y], axis=-1))


def gaps(log: xr.Dataset) -> Array:
    """Distance of the motion center from each support point over time, shape (point, time)."""
    away = feet(log) - plotted(log).path_center.values
    return np.asarray(np.hypot(away[..., 0], away[..., 1]))


class Instant(NamedTuple):
    """Limit curve at an instant, and the forces and motions at both edges of the friction cone.

    Attributes
    ----------
    curve : ndarray
        Shape (angle, 2).
    pivots : ndarray
        Number of the foot for each force, or -1; shape (angle,).
    edges, motions : ndarray
        Degrees, right and left.
    forces : ndarray
        Shape (2, 2).
    """

    curve: Array
    pivots: Array
    edges: Array
    motions: Array
    forces: Array


def instant(log: xr.Dataset, curves: xr.Dataset) -> Instant:
    """Limit curve for the rod angle of a row of a log: the one of the study's rod, turned."""
    turn = float(log.rod_angle) - float(curves.rod_angle)
    angle, points = (curves.force_angle.values + turn) % 360.0, curve(curves.force, turn)
    order = np.argsort(angle[:-1])
    order = np.append(order, order[0])
    slope = np.rad2deg(np.arctan(float(log.friction_coefficient)))
    edges = np.array([90.0 - slope, 90.0 + slope])
    away = (curves.motion_angle - curves.force_angle).values
    columns = [np.interp(edges, angle, each, period=360.0) for each in (*points.T, away)]
    return Instant(
        curve=points[order],
        pivots=curves.pivot.values[order],
        edges=edges,
        motions=edges + columns[2],
        forces=np.stack(columns[:2], axis=-1),
    )


def caption(data: Data) -> str:
    """Caption with the plotted values."""
    log = data[LOG]
    distance = number(float(np.hypot(*body_in(log).support.positions[0])))
    known = values(log, "friction_coefficient", "weight", "rod_length")
    start = number(float(log.rod_angle[0]))
    return (
        "A tripod that pivots. As the fence moves up, the contact slips and the motion center "
        "moves along the dashed path until it reaches a foot, where it stays. Slider, fence and "
        "force are shown at the labeled instants. Right: limit curves at the start and at the end, "
        "with the friction cone (shaded), the forces at its edges and the motions that they cause. "
        "At the end both edges lie on the flat of one foot, and the motion cone is a single "
        f"direction. Each flat has the number of its foot ({known}, ψ = {start}° at time 0, feet at "
        f"{distance} from the center; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw the motion, the limit curves at its start and end, and the distance of the motion center."""
    log = data[LOG]
    _motion(schematic(figure, (0.0, 0.0, 0.4, 1.0)), log)
    for index, name, left in ((0, INSTANTS[0], 0.4), (-1, INSTANTS[1], 0.7)):
        row = log.isel(time=index)
        ax = schematic(figure, (left, 0.33, 0.3, 0.52))
        _curve(
            ax, instant(row, data[CURVES]), rf"{name}, $\psi = {float(row.rod_angle):.0f}^\circ$"
        )
    distances = gaps(log)
    foot = int(np.argmin(distances[:, -1]))
    ax = figure.add_axes((0.5, 0.13, 0.47, 0.14))
    ax.plot(log.time, distances[foot], color=CENTER)
    ax.set(xlim=(float(log.time[0]), float(log.time[-1])), ylim=(0.0, None), xlabel="time")
    ax.set_ylabel(f"distance of\ncenter to foot {foot}", color=DARK)


def _motion(ax: Any, log: xr.Dataset) -> None:
    """Draw slider and fence at some instants, the path of the motion center, and the feet's numbers."""
    motion = plotted(log)
    frame = box(motion)
    frame[:, 0] = np.clip(frame[:, 0], -1.6, None)
    picture = snapshots(motion, frame, COUNT)
    add_paths(picture, motion, frame)
    for foot, point in enumerate(feet(log)[:, 0]):
        x, y = point - log.position.values[0]
        away = 9.0 / float(np.hypot(x, y))
        picture.label(point, str(foot), offset=(away * float(x), away * float(y)), size=NOTE)
    to_axes(picture, ax, frame, 14.0)


def _curve(ax: Any, shown: Instant, title: str) -> None:
    """Draw the limit curve with its flats, the friction cone, and the motions at its edges."""
    picture = Picture()
    right, left = np.deg2rad(shown.edges)
    for along in (unit(0.0), unit(90.0)):
        picture.line([-SPAN * along, SPAN * along], "#BBBBBB", width=0.4, order=1.0)
    picture.cone(right, left, 0.95 * SPAN, FORCE, strength=0.12)
    flat = flat_parts(shown.pivots)
    limit_line(picture, shown.curve, [part for _, part in flat], order=3.0)
    for foot, part in flat:
        x, y = shown.curve[part].mean(axis=0)
        away = 8.0 / float(np.hypot(x, y))
        picture.label(
            (x, y), str(foot), offset=(away * float(x), away * float(y)), size=NOTE, color=FORCE
        )
    for force, motion in zip(shown.forces, shown.motions, strict=True):
        picture.force((0, 0), force, head=8, width=1.0)
        picture.motion(force, LENGTH * unit(float(motion)), head=8, width=1.0)
    width = float(np.ptp(shown.motions))
    wide = f"{degrees(width)} wide" if width > NARROW else "a single direction"
    to_axes(picture, ax, np.array([(-SPAN, -0.8 * SPAN), (SPAN, SPAN)]), 3.0)
    ax.set_title(f"{title}:\nmotion cone {wide}", color=DARK)
