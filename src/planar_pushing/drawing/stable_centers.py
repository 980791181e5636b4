"""The rotation centers of stable pushes around the object and the fence."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.drawing.body import add_body, add_fence, body_of, name_centers
from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import CENTER, DARK, FORCE, tint
from planar_pushing.drawing.canvas.marks import AREAS, LINES, NOTE, Picture, Sheet, corners
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.draw import new_figure
from planar_pushing.drawing.scene import add_center_mark, add_scale
from planar_pushing.drawing.supports import Pose
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.stability.stable_centers import StableCenters, StableCurve, stable_centers
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import Sense, StableBound

#: Size of the picture, inches.
SIZE = (6.0, 4.0)
#: Margin around the object and the corners of the set, and largest distance of a corner that is shown, in
#: units of half the object.
AROUND, FARTHEST = 1.5, 5.0
#: Distance of a center at infinity, in units of the picture's size, and the angle between two of them.
INFINITE, APART = 50.0, 0.05
#: Number of positions across the picture at which a label of a set may be.
GRID = 48
#: Color and drawing order of the sets: above the areas of the object, below its outlines.
AREA, SETS = tint(CENTER, 0.16), AREAS + 0.5
#: Depth of the fence's hatch, in units of half the object.
DEPTH = 0.12
#: What bounds a set, and the color of its curve.
BOUNDS: dict[str, tuple[str, str]] = {
    StableBound.RIGHT_EDGE: ("force on the\nright edge", FORCE),
    StableBound.LEFT_EDGE: ("force on the\nleft edge", FORCE),
    StableBound.START: ("force through\nthe left end", DARK),
    StableBound.END: ("force through\nthe right end", DARK),
    StableBound.PIVOT: ("foot", CENTER),
}


def plot_stable_centers(scene: Scene | StableCenters, ax: Axes | None = None) -> Axes:
    """Draw the rotation centers of stable pushes around the object, in the fence frame.

    Parameters
    ----------
    scene : Scene or StableCenters
        A scene whose side lies on the fence, or the result of `stable_centers`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on, by default those of a new figure. Their frame is removed.

    Returns
    -------
    matplotlib.axes.Axes
        With the set of each sense as an area, and at each curve that bounds it the reason: the force is on
        an edge of the friction cone, or its line of action passes through an end of the side.

    Raises
    ------
    InvalidValue
        As `stable_centers`, or if `ax` is not axes of matplotlib.
    """
    region = scene if isinstance(scene, StableCenters) else stable_centers(scene)
    if ax is not None and not isinstance(ax, Axes):
        raise InvalidValue("ax", ax, "axes of matplotlib", "leave them out for a new figure")
    with paper_style():
        axes = schematic(new_figure(SIZE)) if ax is None else ax
        axes.set_axis_off()
        figure = cast(Figure, axes.get_figure(root=True))
        shape = np.multiply(axes.get_position(original=True).size, figure.get_size_inches())
        view = View(region, shape)
        to_axes(picture_of(view), axes, view.box, 0.0)
    return axes


class View:
    """The set in the fence frame, and the box that the picture shows.

    Attributes
    ----------
    region : StableCenters
    body, pose : Body, Pose
        The object.
    box : ndarray, shape (2, 2)
        Corners of the picture, which has the shape of its axes.
    curves : list of ndarray, shape (n, 2)
        The centers of each curve; those at infinity are far away.
    """

    def __init__(self, region: StableCenters, shape: Array) -> None:
        slider = region.scene.slider
        angle = float(slider.rod_angle)
        self.region, self.body = region, body_of(region.scene)
        self.pose = Pose(slider.rod_length * direction(angle), angle)
        finite = [curve.centers[[0, -1]] for curve in region.curves]
        ends = np.concatenate([np.empty((0, 2)), *finite])
        near = self._corners_in_reach(
            region.scene.to_fence(ends[np.isfinite(ends).all(axis=-1)], "point")
        )
        side = np.array([(end, 0.0) for end in slider.side])
        needed = corners([*self.object_box, *side, *near], AROUND * self.half)
        self.box = Sheet.around(needed, tuple(shape), 0.0).box
        self.curves = [self.centers(curve.twists, curve.sense) for curve in region.curves]

    @property
    def half(self) -> float:
        """Half the larger side of the object, or of the side on the fence."""
        start, end = self.region.scene.slider.side
        return max(self.body.half, 0.5 * float(end - start))

    @property
    def object_box(self) -> Array:
        """Corners of the box around the object."""
        return self.body.box(self.pose)

    def _corners_in_reach(self, ends: Array) -> Array:
        """The corners of the set that are not too far away."""
        away = np.linalg.norm(ends - self.object_box.mean(axis=0), axis=-1)
        return np.asarray(ends[away < FARTHEST * self.half])

    def centers(self, twists: Array, sense: Sense) -> Array:
        """Centers of twists of the object's frame in the fence frame, far away for translations."""
        v_x, v_y, omega = self.region.scene.to_fence(twists, "twist").T
        speed, sign = np.hypot(v_x, v_y), 1.0 if sense is Sense.COUNTERCLOCKWISE else -1.0
        far = INFINITE * float(np.ptp(self.box, axis=0).max())
        spin = np.maximum(np.abs(omega), speed / far)
        return np.asarray(self.pose.origin + sign * np.stack([-v_y, v_x], axis=-1) / spin[:, None])

    def shows(self, points: Array) -> Any:
        """Whether points are in the picture."""
        return ((points > self.box[0]) & (points < self.box[1])).all(axis=-1)


def picture_of(view: View) -> Picture:
    """The sets, the curves that bound them, the fence and the object."""
    picture, law = Picture(), view.region.scene.law
    (left, low), (right, high) = view.box
    if law.rough:
        picture.area(
            [(left, low), (right, low), (right, high), (left, high)], color=AREA, order=SETS
        )
        position = (0.5 * (left + right), low + 0.9 * (high - low))
        picture.label(position, "every push is stable", color=CENTER, size=NOTE)
    elif law.left > law.right:
        for sense in Sense:
            add_set(picture, view, sense)
    add_object(picture, view)
    for curve, centers in zip(view.region.curves, view.curves, strict=True):
        add_curve(picture, view, curve, centers)
    unit = view.region.scene.units
    inner = view.box + 0.03 * (high - low) * np.array([[1.0, 1.0], [-1.0, -1.0]])
    add_scale(picture, inner, 0.2 * float(right - left), unit.length if unit else "")
    return picture


def add_object(picture: Picture, view: View) -> None:
    """Add the fence, the side that lies on it, and the object."""
    (left, _), (right, _) = view.box
    add_fence(picture, float(left), float(right), depth=DEPTH * view.half)
    side = np.array([(end, 0.0) for end in view.region.scene.slider.side])
    add_body(picture, view.body, view.pose, side=side)
    name_centers(picture, view.body, view.pose)


def add_set(picture: Picture, view: View, sense: Sense) -> None:
    """Add the stable centers of one sense as areas, with a turning arrow and the sense in words."""
    for ring in rings(view, sense):
        picture.area(ring, color=AREA, order=SETS)
    position, room = clearest(view, sense)
    if room > 0.0:
        turn = 1.0 if sense is Sense.COUNTERCLOCKWISE else -1.0
        picture.turn_arrow(position, turn, min(0.14 * view.half, 0.7 * room), CENTER)
        text, held = f"stable,\n{sense}", room > 0.4 * view.half
        picture.label(position, text, color=CENTER, size=NOTE, offset=(0.0, -17.0), held=held)


def rings(view: View, sense: Sense) -> list[Array]:
    """Boundaries of the set of one sense; along infinity they follow the stable translations.

    Each chain of curves ends at a translation. The boundary goes on along the translations, with the set on
    its right, to the nearest one from which a chain comes.
    """
    curves = view.region.curves
    senses = [curve.sense is sense for curve in curves]
    if all(senses) or not any(senses):
        return [np.concatenate(view.curves)] if any(senses) else []
    first = senses.index(False)
    chains: list[list[int]] = []
    for i in [*range(first, len(curves)), *range(first)]:
        if senses[i] and senses[i - 1]:
            chains[-1].append(i)
        elif senses[i]:
            chains.append([i])
    onward = -1.0 if sense is Sense.COUNTERCLOCKWISE else 1.0
    ends = np.array([[_heading(view, curves[chain[k]], k) for k in (0, -1)] for chain in chains])
    after = [
        int(np.argmin((onward * (ends[:, 0] - leave)) % (2 * np.pi)))
        for leave in ends[:, 1:].ravel()
    ]
    closed, left = [], set(range(len(chains)))
    while left:
        ring, i = [], min(left)
        while i in left:
            left.remove(i)
            ring += [view.curves[k] for k in chains[i]]
            span = onward * ((onward * (ends[after[i], 0] - ends[i, 1])) % (2 * np.pi))
            turns = ends[i, 1] + np.linspace(0.0, span, 2 + int(abs(span) / APART))
            ring.append(_far(view, turns, sense))
            i = after[i]
        closed.append(np.concatenate(ring))
    return closed


def _heading(view: View, curve: StableCurve, end: int) -> float:
    """Direction of the motion at the first or the last twist of a curve, in the fence frame."""
    x, y, _ = view.region.scene.to_fence(curve.twists[end], "twist")
    return float(np.arctan2(y, x))


def _far(view: View, headings: Array, sense: Sense) -> Array:
    """Centers of translations along directions of the fence frame."""
    motions = np.concatenate([direction(headings), np.zeros((len(headings), 1))], axis=-1)
    return view.centers(view.region.scene.to_object(motions, "twist"), sense)


def clearest(view: View, sense: Sense) -> tuple[Array, float]:
    """The stable center that is farthest from curves, object and rim, and its distance; 0 without one."""
    (left, low), (right, high) = view.box
    x, y = np.linspace(left, right, GRID + 2)[1:-1], np.linspace(low, high, GRID + 2)[1:-1]
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    stable = view.region.contains(view.region.scene.to_object(points, "point"), sense)
    points = points[stable]
    if not len(points):
        return np.zeros(2), 0.0
    curves = np.concatenate([np.empty((0, 2)), *view.curves])
    away = [np.hypot(*(points - center).T) for center in curves[view.shows(curves)]]
    away += [_outside(points, view.object_box), np.abs(points[:, 1])]
    away += [*(points - view.box[0]).T, *(view.box[1] - points).T]
    room = np.min(away, axis=0)
    best = int(np.argmax(room))
    return points[best], float(room[best])


def _outside(points: Array, box: Array) -> Array:
    """Distances of points from a box, 0 within it."""
    away = np.maximum(np.maximum(box[0] - points, points - box[1]), 0.0)
    return np.asarray(np.linalg.norm(away, axis=-1))


def add_curve(picture: Picture, view: View, curve: StableCurve, centers: Array) -> None:
    """Add a curve with its reason; a pivot is a double circle."""
    text, color = BOUNDS[curve.bound]
    law = view.region.scene.law
    if law.right == law.left:
        text = f"stable, {curve.sense}:\nforce along the normal"
    if curve.bound is StableBound.PIVOT:
        if view.shows(centers)[0]:
            add_center_mark(picture, centers[0], pivot=True)
            picture.label(centers[0], text, color=color, size=NOTE, offset=(0.0, 13.0))
        return
    shows = view.shows(centers)
    near = shows.copy()
    near[1:] |= shows[:-1]
    near[:-1] |= shows[1:]
    starts = np.flatnonzero(np.diff(near, prepend=False, append=False)).reshape(-1, 2)
    for start, stop in starts:
        picture.line(centers[start:stop], color, width=1.4, order=LINES + 0.2)
    if len(starts):
        start, stop = max(starts, key=lambda run: _length(centers[run[0] : run[1]]))
        part = centers[start:stop][view.shows(centers[start:stop])]
        middle = int(np.searchsorted(_lengths_along(part), 0.5 * _length(part)))
        before, after = part[max(middle - 1, 0)], part[min(middle + 1, len(part) - 1)]
        # The set is on the right of the curve as seen with the sense of the rotation from above.
        heading = after - before if curve.sense is Sense.COUNTERCLOCKWISE else before - after
        out = np.array([-heading[1], heading[0]]) / (np.hypot(*heading) or 1.0)
        offset = float(32.0 * out[0]), float(14.0 * out[1])
        picture.label(part[middle], text, color=color, size=NOTE, offset=offset)


def _lengths_along(points: Array) -> Array:
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _length(points: Array) -> float:
    return float(_lengths_along(points)[-1])
