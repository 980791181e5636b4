"""A tripod that pivots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from planar_pushing.drawing.body import body_in
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, GUIDE
from planar_pushing.drawing.canvas.marks import NOTE, Picture, unit
from planar_pushing.drawing.canvas.style import PAGE
from planar_pushing.drawing.motion import (
    add_center_path,
    add_contact_path,
    add_first_pusher,
    add_instant,
    add_velocity,
    box,
)
from planar_pushing.drawing.over_time import series
from planar_pushing.drawing.scene import add_center_mark, limit_line
from planar_pushing.drawing.timeline import is_pivot, path_data
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
    size=(PAGE, 3.2),
    section=SECTION,
)
#: Instants with a limit curve.
INSTANTS = ("start", "end")
#: Width of a column of pictures and height of the limit curves, as fractions; padding, points.
COLUMN, CURVE, PAD = 0.33, 0.45, 5.0
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
    away = feet(log) - path_data(log).path_center.values
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
    columns = [np.interp(edges, angle, column, period=360.0) for column in (*points.T, away)]
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
        "A tripod that pivots. As the fence moves up with the velocity vₚ, the contact slips to the left "
        "(thick path), and the motion center moves along the dashed path to foot 0, where it stays. The "
        "fence touches only the rod's end and passes over foot 2. Below: limit curves with the friction "
        "cone (shaded), the forces at its edges and their motions; each flat has the number of its foot. "
        "At the end both edges lie on one flat, and the motion cone is a single direction "
        f"({known}, ψ = {start}° at time 0, feet at {distance} from the center; {pusher_motion(log)})."
    )


def draw(figure: Any, data: Data) -> None:
    """Draw slider and limit curve at the start and at the end, and the distance of the motion center."""
    log = data[LOG]
    motion = path_data(log)
    frame = box(motion)
    for column, (row, name) in enumerate(zip((0, log.sizes["time"] - 1), INSTANTS, strict=True)):
        left = column * COLUMN
        ax = schematic(figure, (left, CURVE, COLUMN, 0.925 - CURVE))
        to_axes(_slider(motion, feet(log)[:, row], row, frame), ax, frame, PAD)
        title = (
            rf"{name}, $t = {float(log.time[row]):.3g}$, $\psi = {float(log.rod_angle[row]):.0f}$°"
        )
        ax.set_title(title, color=DARK)
        below = schematic(figure, (left, 0.01, COLUMN, CURVE - 0.1))
        _curve(below, instant(log.isel(time=row), data[CURVES]))
    motion["distance"] = ("time", gaps(log)[_pivot(log)])
    ax = figure.add_axes((2 * COLUMN + 0.1, 0.25, 0.88 - 2 * COLUMN, 0.5))
    series(
        ax, motion, "distance", f"distance of motion\ncenter to foot {_pivot(log)}", color=CENTER
    )
    ax.set_ylim(0.0, None)


def _pivot(log: xr.Dataset) -> int:
    """Number of the foot that is nearest to the motion center at the end."""
    return int(np.argmin(gaps(log)[:, -1]))


def _slider(motion: xr.Dataset, places: Array, row: int, frame: Array) -> Picture:
    """Picture of slider and fence at a row, with the paths up to it and the numbers of the feet."""
    picture = Picture()
    add_first_pusher(picture, motion, row)
    add_contact_path(picture, motion, row)
    add_center_path(picture, motion, frame, row)
    add_instant(picture, motion, row)
    add_velocity(picture, motion, row)
    center = motion["path_center"].values[row]
    pivot = is_pivot(motion, row)
    add_center_mark(picture, center, size=4.5, pivot=pivot)
    name, offset = ("pivot", (0.0, 14.0)) if pivot else ("motion\ncenter", (20.0, 0.0))
    picture.label(center, name, offset=offset, color=CENTER, size=NOTE, held=True)
    height = float(motion["path_pusher"].values[row, 1])
    for foot, point in enumerate(places):
        x, y = point - motion["path_position"].values[row]
        away = 11.0 / float(np.hypot(x, y))
        offset = (away * float(x), away * float(y))
        picture.label(point, str(foot), offset=offset, size=NOTE + 1.0, held=True)
        if point[1] < height:
            text = f"the fence has\npassed over foot {foot}"
            picture.label(point, text, offset=(36.0, -14.0), size=NOTE, color=GUIDE, held=True)
    return picture


def _curve(ax: Any, state: Instant) -> None:
    """Draw the limit curve with its flats, the friction cone, and the motions at its edges."""
    picture = Picture()
    right, left = np.deg2rad(state.edges)
    for along in (unit(0.0), unit(90.0)):
        picture.line([-SPAN * along, SPAN * along], "#BBBBBB", width=0.4, order=1.0)
    picture.cone(right, left, 0.95 * SPAN, FORCE, strength=0.12)
    flat = flat_parts(state.pivots)
    limit_line(picture, state.curve, [part for _, part in flat], order=3.0)
    for foot, part in flat:
        x, y = state.curve[part].mean(axis=0)
        away = 8.0 / float(np.hypot(x, y))
        picture.label(
            (x, y), str(foot), offset=(away * float(x), away * float(y)), size=NOTE, color=FORCE
        )
    for force, motion in zip(state.forces, state.motions, strict=True):
        picture.force((0, 0), force, head=8, width=1.0)
        picture.motion(force, LENGTH * unit(float(motion)), head=8, width=1.0)
    width = float(np.ptp(state.motions))
    wide = f"{degrees(width)} wide" if width > NARROW else "a single direction"
    to_axes(picture, ax, np.array([(-SPAN, -0.8 * SPAN), (SPAN, SPAN)]), 3.0)
    ax.set_title(f"motion cone: {wide}", color=DARK)
