"""Forces in the picture of a scene: the pusher's, the friction of the support, and the limit curve."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from planar_pushing.figures.parts import arrows, drawing, labels
from planar_pushing.figures.parts.sketch import SUPPORT_LENGTH, Sketch
from planar_pushing.figures.style import CENTER, FORCE
from planar_pushing.mechanics.plane import Array

#: How much of its color the fan of a pivot's forces has; it lies over the cones.
FAN, FAN_ORDER = 0.42, 0.8
#: Motions whose angles differ by less, degrees, are one motion: a pivot, a flat of the curve.
ALIKE = 1e-7


def force(ax: Axes, sketch: Sketch) -> None:
    """Force of the pusher on the slider; a fan of all those that a pivot leaves open."""
    if not sketch.moves:
        return
    name = r"$\mathbf{f}$ (adhesive)" if sketch.adhesive else r"$\mathbf{f}$"
    drawn = [sketch.drawn_force(each) for each in sketch.forces]
    for vector in drawn:
        arrows.force_arrow(ax, (0, 0), vector, name if len(drawn) == 1 else "", width=1.6)
    if len(drawn) > 1:
        _fan(ax, drawn, name)


def _fan(ax: Axes, ends: list[Array], name: str) -> None:
    """Directions between two forces, any of which a pivot can have."""
    right, left = (float(np.rad2deg(np.arctan2(*each[::-1]))) for each in ends)
    turn, length = (left - right) % 360, min(float(np.hypot(*each)) for each in ends)
    drawing.cone(
        ax, (0, 0), right, right + turn, 0.8 * length, FORCE, strength=FAN, zorder=FAN_ORDER
    )
    ahead = arrows.unit(right + turn / 2)
    shift = (11.0 * float(ahead[0]), 9.0 * float(ahead[1]))
    labels.label(ax, 0.8 * length * ahead, name, offset=shift, color=FORCE)


def line_of_force(ax: Axes, sketch: Sketch) -> None:
    """Line on which the pusher's force and the resistance of the slider act."""
    if sketch.moves:
        for each in sketch.forces:
            drawing.guide(ax, (0, 0), sketch.end_of_line(each), color=FORCE)


def support_friction(ax: Axes, sketch: Sketch) -> None:
    """Friction of the support on the slider, where it rubs."""
    if not sketch.moves:
        return
    places, (pulls,) = sketch.rubbing
    largest = float(np.max(np.hypot(*pulls.T), initial=0.0))
    length = SUPPORT_LENGTH * sketch.radius
    for place, pull in zip(places, pulls, strict=True):
        if np.any(pull):
            along = length * pull / largest
            head = min(7.0, 0.9 * float(np.hypot(*along)) * points_per_unit(ax))
            arrows.force_arrow(ax, place, along, width=0.7, head=head)


def points_per_unit(ax: Axes) -> float:
    """Scale of the picture: points on paper for a unit of length."""
    figure = ax.get_figure(root=True)
    left, right = ax.transData.transform([(0.0, 0.0), (1.0, 0.0)])
    return float(72 * (right[0] - left[0]) / figure.dpi) if figure else 1.0


def limit_curve(ax: Axes, sketch: Sketch) -> None:
    """The curve, heavier along its flats, where one pivot belongs to an interval of forces."""
    curve, motion = sketch.curve, sketch.data["limit_motion_angle"].values
    ax.plot(*curve.T, color=FORCE, linewidth=0.9, zorder=2.4)
    for flat in flats(motion):
        ax.plot(*curve[flat].T, color=CENTER, linewidth=2.4, zorder=2.5)


def flats(motion: Array) -> list[slice]:
    """Where a limit curve is flat: points whose motions have one angle, in degrees."""
    flat = np.concatenate([[False], np.abs(np.diff(motion)) < ALIKE, [False]])
    turns = np.flatnonzero(flat[1:] != flat[:-1]).reshape(-1, 2)
    return [slice(int(start), int(stop) + 1) for start, stop in turns]
