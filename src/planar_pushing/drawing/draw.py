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
from planar_pushing.drawing.contacts import ContactsPicture
from planar_pushing.drawing.motion import box
from planar_pushing.drawing.over_time import (
    draw_frames,
    explain,
    mark_time,
    series,
    strip,
    varying_names,
)
from planar_pushing.drawing.scene import add_scale, scene_picture
from planar_pushing.drawing.sketch import Sketch, with_curve
from planar_pushing.drawing.timeline import announce_end, impacts, key_rows, path_data
from planar_pushing.drawing.words import outcome
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.scene import Scene, require_scene, require_single
from planar_pushing.mechanics.solutions import Solution
from planar_pushing.mechanics.solve import solve
from planar_pushing.objects.several.contact import Contact
from planar_pushing.terms.domain import require_in_range
from planar_pushing.terms.errors import InvalidValue, require_flag, require_kind, require_number

#: Sizes of the pictures of a scene and of a log, inches; padding, points.
SCENE, LOG, PAD = (4.2, 4.0), (7.0, 3.6), 24.0
#: Height of the axes of a scene below a title of at most two lines, and of each further line, as fractions.
HIGH, LINE = 0.9, 0.04
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
    require_single(require_scene(scene))
    require_flag("cones", cones)
    require_flag("limit_curve", limit_curve)
    if ax is not None and not isinstance(ax, Axes):
        raise InvalidValue("ax", ax, "axes of matplotlib", "leave them out for a new figure")
    if pusher_angle is None:
        require_in_range("pusher_magnitude", pusher_magnitude)
        if solution is not None:
            allowed, remedy = "None without pusher_angle", "give the pusher_angle"
            raise InvalidValue("solution", solution, allowed, remedy)
        sketch = Sketch.of(scene)
    else:
        push = {"pusher_angle": pusher_angle, "pusher_magnitude": pusher_magnitude}
        for name, value in push.items():
            require_number(name, value, math.isfinite, "a finite number", "draw one push at a time")
        solutions = solve(scene, pusher_angle, pusher_magnitude)
        chosen = None if solution is None else _index_of(list(solutions), solution)
        sketch = Sketch.of(
            scene, pusher_angle, pusher_magnitude, solutions=solutions, chosen=chosen
        )
    return _draw_axes(with_curve(sketch, scene) if limit_curve else sketch, cones, ax)


def draw_contacts(
    contacts: Sequence[Contact],
    *,
    effects: Sequence[Effect],
    outline: Any = None,
    solution: int = 0,
    ax: Axes | None = None,
) -> Axes:
    """Draw an object with several contacts: their friction cones, forces and motions, and the center.

    Parameters
    ----------
    contacts, effects, outline
        As of `solve_contacts`, of one problem.
    solution : int
        Which of the solutions is drawn.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; by default those of a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        With a scale bar, and what the contacts do as the title. A force that is not determined is drawn by
        both ends of its range; one without a bound, by its direction.

    Raises
    ------
    InvalidValue
        As of `solve_contacts`, or if there is no such solution.
    """
    if ax is not None and not isinstance(ax, Axes):
        raise InvalidValue("ax", ax, "axes of matplotlib", "leave them out for a new figure")
    sketch = ContactsPicture(contacts, effects, outline, solution)
    with paper_style():
        title = wrap(sketch.title())
        axes = _axes_under_title(new_figure(SCENE), title) if ax is None else ax
        _draw_contacts(axes, sketch, title, "")
    return axes


def draw_contacts_on(figure: Figure, sketch: ContactsPicture, unit: str) -> None:
    """Draw several contacts on a separate figure, as `draw_contacts` does, with a unit of length."""
    with paper_style():
        title = wrap(sketch.title())
        _draw_contacts(_axes_under_title(figure, title), sketch, title, unit)


def _draw_contacts(axes: Axes, sketch: ContactsPicture, title: str, unit: str) -> None:
    """Draw several contacts with a scale bar and a title."""
    axes.set_axis_off()
    picture, frame = sketch.draw(), sketch.box()
    add_scale(picture, frame, 0.3 * float(np.ptp(frame[:, 0])), unit)
    to_axes(picture, axes, frame, PAD)
    axes.set_title(title, fontsize=NOTE + 0.5, color=GUIDE)


def outcome_of(sketch: Sketch) -> str:
    """Outcome of a push in words; empty without a push."""
    if sketch.pusher is None:
        return ""
    return outcome(sketch.solutions, sketch.pusher, sketch.chosen)


def _index_of(solutions: Sequence[Solution], wanted: int | ContactMode) -> int:
    """Index of the requested solution."""
    if isinstance(wanted, ContactMode):
        indices = [i for i, candidate in enumerate(solutions) if candidate.mode is wanted]
    else:
        indices = [wanted] if wanted in range(len(solutions)) else []
    if not indices:
        modes = ", ".join(f"{i} ({candidate.mode})" for i, candidate in enumerate(solutions))
        allowed = modes or "none, because no solution is consistent"
        raise InvalidValue("solution", wanted, allowed, "choose one of these, or leave it out")
    return indices[0]


def _draw_axes(sketch: Sketch, cones: bool, ax: Axes | None) -> Axes:
    """Axes with the picture of a sketch, its scale bar and its title."""
    with paper_style():
        title = wrap(outcome_of(sketch))
        axes = _axes_under_title(new_figure(SCENE), title) if ax is None else ax
        axes.set_axis_off()
        picture, frame = scene_picture(sketch, cones=cones), sketch.box
        add_scale(picture, frame, 0.3 * float(np.ptp(frame[:, 0])), sketch.unit)
        to_axes(picture, axes, frame, PAD)
        axes.set_title(title, fontsize=NOTE + 0.5, color=GUIDE)
    return axes


def _axes_under_title(figure: Figure, title: str) -> Axes:
    """Axes on a figure below a title."""
    more = max(title.count("\n") - 1, 0)
    return schematic(figure, (0.0, 0.0, 1.0, HIGH - LINE * more))


def wrap(text: str, width: int = 64) -> str:
    """Text wrapped to lines of about equal width."""
    import textwrap

    return "\n".join(textwrap.wrap(text, width))


def new_figure(size: tuple[float, float]) -> Figure:
    """A figure that notebooks and windows display like those of pyplot, without requiring a window."""
    import matplotlib.pyplot as plt

    return plt.figure(figsize=size)


def draw_on(figure: Figure, sketch: Sketch, *, cones: bool = True) -> None:
    """Draw a sketch on a separate figure, as `draw` does."""
    _draw_axes(sketch, cones, _axes_under_title(figure, wrap(outcome_of(sketch))))


def plot_log(log: xr.Dataset, figure: Figure | None = None) -> Figure:
    """Draw a motion over time: slider and pusher at three instants, and time series.

    The instants are the first, the last and between them the first impact, or the middle if there is none.
    Each frame shows the force on the slider, the velocity of the pusher, the pusher's first position
    (dashed), the path of the contact up to then in the colors of its modes, and the motion center. The tick
    on a fence marks the point that the contact touched first.

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
    data = path_data(log)
    announce_end(log)
    with paper_style():
        figure = new_figure(LOG) if figure is None else figure
        motion_and_series(figure, data, impacts(log))
    return figure


def motion_and_series(figure: Figure, data: xr.Dataset, impact_rows: Sequence[int] = ()) -> None:
    """Draw frames of the motion above, and time series below, side by side if the figure is wide.

    `impact_rows` contains the rows of impacts.
    """
    wide = figure.get_figwidth() > figure.get_figheight()
    middle, bottom = (0.42, 0.2) if wide else (0.6, 0.15)
    frames = (0.0, middle, 1.0, 1.0 - middle)
    draw_frames(
        figure, data, key_rows(data, impact_rows), box(data), frames, impact_rows=impact_rows
    )
    names = varying_names(data, SERIES) or ["path_rod_angle"]
    count = len(names) + 1
    shape = (1, count) if wide else (count, 1)
    space: dict[str, Any] = (
        {"left": 0.095, "wspace": 0.42} if wide else {"left": 0.18, "hspace": 0.3}
    )
    grid = figure.add_gridspec(*shape, right=0.98, top=middle - 0.03, bottom=bottom, **space)
    axes = [figure.add_subplot(grid[number]) for number in range(count)]
    for ax, name in zip(axes, names, strict=False):
        series(ax, data, name, SERIES[name])
    strip(axes[-1], data)
    explain(figure, data, impact_rows)
    if not wide:
        figure.align_ylabels()
        for ax in axes[:-1]:
            ax.set_xlabel("")
            ax.tick_params(axis="x", labelbottom=False)
    for row in impact_rows:
        for ax in axes:
            mark_time(ax, data, row)
