"""Pictures for users: a scene under a push, and a log over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planar_pushing.drawing.canvas.axes import schematic, to_axes
from planar_pushing.drawing.canvas.colors import GUIDE
from planar_pushing.drawing.canvas.marks import NOTE
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.drawing.motion import box, snapshots
from planar_pushing.drawing.over_time import explain, mark_time, series, strip, varying
from planar_pushing.drawing.scene import add_scale, scene_picture
from planar_pushing.drawing.sketch import Sketch, with_curve
from planar_pushing.drawing.timeline import announce_end, impacts, plotted
from planar_pushing.drawing.words import outcome
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.scene import Scene, required_scene, required_single
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.domain import required
from planar_pushing.terms.errors import InvalidValue, require_flag, require_kind, require_number

#: Sizes of the pictures of a scene and of a log, inches; padding, points.
SCENE, LOG, PAD = (4.2, 4.0), (7.0, 3.2), 24.0
#: Height of the axes of a scene below a title of at most two lines, and of each further line, as fractions.
HIGH, LINE = 0.9, 0.04
#: Number of instants at which slider and pusher are drawn.
COUNT = 5
#: Variables plotted over time if they vary, and their labels.
SERIES = {
    "path_rod_angle": "rod angle $\\psi$\n(degrees)",
    "path_slip": "slip",
    "path_gap": "gap",
}


def draw(
    scene: Scene,
    pusher_angle: float | None = None,
    pusher_magnitude: float = 1.0,
    *,
    solution: int | ContactMode | None = None,
    cones: bool = True,
    limit_curve: bool = False,
    ax: Axes | None = None,
) -> Axes:
    """Draw a scene under a push with its consistent solutions, or the slider and its cones.

    Parameters
    ----------
    scene : Scene
        A single scene with scalar parameters.
    pusher_angle : float, optional
        Direction of the pusher's motion, radians counterclockwise from the fence; if omitted, the picture
        shows the slider and its cones.
    pusher_magnitude : float
        Magnitude of this motion: of a velocity, or of an acceleration if the scene has inertia; >= 0.
    solution : int or ContactMode, optional
        Number or mode of the solution to draw in full; the others are pale. By default the sticking
        solution, otherwise the first in which the pusher transmits a force.
    cones : bool
        Whether to show the friction cone and the motion cone; of a side on the fence, the friction cones at
        both ends.
    limit_curve : bool
        Whether to show the limit curve around the contact, for a scene with one effect and one point of
        contact.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on, by default those of a new figure. Their frame is removed.

    Returns
    -------
    matplotlib.axes.Axes
        With a scale bar of a round length, and the outcome in words as the title.

    Raises
    ------
    InvalidValue
        If the scene is an array of scenes, a value is not allowed, or there is no such solution or no limit
        curve.

    Notes
    -----
    A side that lies on the fence is a heavy line with a dot at each end. The force acts at x*, where its
    line of action crosses the side; thin arrows are the forces at both ends where they are determined.
    """
    required_single(required_scene(scene))
    require_flag("cones", cones)
    require_flag("limit_curve", limit_curve)
    if ax is not None and not isinstance(ax, Axes):
        raise InvalidValue("ax", ax, "axes of matplotlib", "leave them out for a new figure")
    if pusher_angle is None:
        required("pusher_magnitude", pusher_magnitude)
        if solution is not None:
            allowed, remedy = "None without pusher_angle", "give the pusher_angle"
            raise InvalidValue("solution", solution, allowed, remedy)
        sketch = Sketch.of(scene)
    else:
        push = {"pusher_angle": pusher_angle, "pusher_magnitude": pusher_magnitude}
        for name, given in push.items():
            require_number(name, given, math.isfinite, "a finite number", "draw one push at a time")
        found = solve(scene, pusher_angle, pusher_magnitude)
        chosen = None if solution is None else _number(list(found), solution)
        sketch = Sketch.of(scene, pusher_angle, pusher_magnitude, found=found, chosen=chosen)
    return _draw_axes(with_curve(sketch, scene) if limit_curve else sketch, cones, ax)


def said(sketch: Sketch) -> str:
    """Outcome of a push in words; empty without a push."""
    if sketch.pusher is None:
        return ""
    return outcome(sketch.solutions, sketch.pusher, sketch.chosen)


def _number(found: Sequence[Any], wanted: int | ContactMode) -> int:
    """Number of the requested solution."""
    if isinstance(wanted, ContactMode):
        numbers = [i for i, each in enumerate(found) if each.mode is wanted]
    else:
        numbers = [wanted] if wanted in range(len(found)) else []
    if not numbers:
        modes = ", ".join(f"{i} ({each.mode})" for i, each in enumerate(found))
        allowed = modes or "none, because no solution is consistent"
        raise InvalidValue("solution", wanted, allowed, "choose one of these, or leave it out")
    return numbers[0]


def _draw_axes(sketch: Sketch, cones: bool, ax: Axes | None) -> Axes:
    """Axes with the picture of a sketch, its scale bar and its title."""
    with paper_style():
        title = wrapped(said(sketch))
        own = _axes_under_title(new_figure(SCENE), title) if ax is None else ax
        own.set_axis_off()
        picture, frame = scene_picture(sketch, cones=cones), sketch.box
        add_scale(picture, frame, 0.3 * float(np.ptp(frame[:, 0])), sketch.unit)
        to_axes(picture, own, frame, PAD)
        own.set_title(title, fontsize=NOTE + 0.5, color=GUIDE)
    return own


def _axes_under_title(figure: Figure, title: str) -> Axes:
    """Axes on a figure below a title."""
    more = max(title.count("\n") - 1, 0)
    return schematic(figure, (0.0, 0.0, 1.0, HIGH - LINE * more))


def wrapped(text: str, width: int = 64) -> str:
    """Text wrapped to lines of about equal width."""
    import textwrap

    return "\n".join(textwrap.wrap(text, width))


def new_figure(size: tuple[float, float]) -> Figure:
    """A figure that notebooks and windows display like those of pyplot, without requiring a window."""
    import matplotlib.pyplot as plt

    return plt.figure(figsize=size)


def draw_on(figure: Figure, sketch: Sketch, *, cones: bool = True) -> None:
    """Draw a sketch on a separate figure, as `draw` does."""
    _draw_axes(sketch, cones, _axes_under_title(figure, wrapped(said(sketch))))


def plot_log(log: xr.Dataset, figure: Figure | None = None) -> Figure:
    """Draw a motion over time: slider and pusher at several instants, and time series.

    Parameters
    ----------
    log : xarray.Dataset
        Returned by `simulate`. For the log of a run that did not finish, the package's logger says where
        the log ends.
    figure : matplotlib.figure.Figure, optional
        Figure to draw on; by default a new one.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InvalidFile
        If the dataset is not a log.
    """
    if figure is not None:
        require_kind("figure", figure, Figure, "give a figure of matplotlib, or leave it out")
    data = plotted(log)
    announce_end(log)
    with paper_style():
        own = new_figure(LOG) if figure is None else figure
        motion_and_series(own, data, impacts(log))
    return own


def motion_and_series(figure: Figure, data: xr.Dataset, struck: Sequence[int] = ()) -> None:
    """Draw the trajectory on the left or at the top, and time series on the right or below.

    `struck` contains the rows of impacts, at which slider and pusher are drawn too.
    """
    wide = figure.get_figwidth() > figure.get_figheight()
    ax = schematic(figure, (0.0, 0.0, 0.6, 1.0) if wide else (0.0, 0.5, 1.0, 0.5))
    frame = box(data)
    to_axes(snapshots(data, frame, COUNT, struck), ax, frame, 14.0)
    shown = varying(data, SERIES) or ["path_rod_angle"]
    edges = (
        {"left": 0.69, "top": 0.97, "bottom": 0.19}
        if wide
        else {"left": 0.17, "top": 0.47, "bottom": 0.1}
    )
    grid = figure.add_gridspec(
        len(shown) + 1, 1, right=0.97, hspace=0.28, height_ratios=[*(1.0 for _ in shown), 0.35],
        **edges,
    )  # fmt: skip
    for place, name in enumerate(shown):
        series(figure.add_subplot(grid[place]), data, name, SERIES[name])
    last = figure.add_subplot(grid[len(shown)])
    strip(last, data)
    explain(last, data)
    figure.align_ylabels()
    for row in struck:
        for each in figure.axes[1:]:
            mark_time(each, data, row)
