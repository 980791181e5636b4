"""Pictures of the push and of its motion over time, and their markup for the page."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from planar_pushing.drawing.body import name_centers
from planar_pushing.drawing.canvas.colors import DARK, ENERGIES, GUIDE, LIGHT, MODES, PUSHER
from planar_pushing.drawing.canvas.marks import AREAS, NOTE, Area, Picture, Sheet
from planar_pushing.drawing.canvas.svg import content, to_svg
from planar_pushing.drawing.motion import (
    add_first_pusher,
    add_instant,
    add_paths,
    add_velocity,
    span,
)
from planar_pushing.drawing.scene import (
    HALF,
    PALE,
    add_center_mark,
    add_cones,
    add_pusher,
    add_slider,
    add_solution,
)
from planar_pushing.drawing.sketch import FAR, Sketch
from planar_pushing.drawing.walls import DrawnWall, walls_before
from planar_pushing.drawing.words import best
from planar_pushing.explorer.pictures.following import FollowedMotion, energies, row_at
from planar_pushing.explorer.pictures.handles import arrow_length, frame_of, handle_positions
from planar_pushing.explorer.pictures.layout import Held, Spot, add_names, place_handles
from planar_pushing.explorer.python_lines import settings
from planar_pushing.explorer.state import Handle, State
from planar_pushing.mechanics.force.cones import is_magnitude_open
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.solutions import Solution
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.options import Shape

#: Width of the picture over time for energies of height 1, top of the modes, and box around both.
LONG, TOP = 5.0, 1.5
TIME_BOX = np.array([(-0.5, -0.38), (LONG + 0.1, TOP + 0.05)])


class SolvedPush(NamedTuple):
    """A push with its consistent solutions and their sketch."""

    state: State
    solutions: tuple[Solution, ...]
    chosen: int
    sketch: Sketch

    @property
    def force(self) -> Array | None:
        """Force of the solution drawn in full."""
        return None if self.chosen < 0 else self.solutions[self.chosen].force


def solve_push(state: State) -> SolvedPush:
    """Solve the push of a state."""
    scene, angle = state.scene, float(np.deg2rad(state.angle))
    solutions = solve(scene, angle, state.magnitude)
    consistent = tuple(solutions)
    chosen = best(consistent, state.shown)
    side = scene.slider.side if state.shape == Shape.FINGER else None
    sketch = Sketch.of(
        scene, angle, state.magnitude, solutions=solutions, chosen=chosen, side=side,
        finger_radius=state.finger_radius,
        pusher_length=arrow_length(state), walls=walls_of(state),
    )  # fmt: skip
    return SolvedPush(state, consistent, chosen, sketch)


def walls_of(state: State) -> tuple[DrawnWall, ...]:
    """The walls of a state in the fence frame; none beside a slider that has lost its outline."""
    if state.file.simulate is None or state.scene.slider.outline is None:
        return ()
    return walls_before(state.scene, settings(state))


def spots_of(push: SolvedPush, sheet: Sheet, held: Held | None = None) -> dict[Handle, Spot]:
    """Handles of a push on a sheet."""
    return place_handles(handle_positions(push.state, push.force), sheet, held)


def push_picture(push: SolvedPush, sheet: Sheet | None = None, held: Held | None = None) -> Picture:
    """Picture of slider, pusher and cones, with the chosen solution in full and the others pale.

    On a sheet, the handles have their names beside them, and other labels keep off both.
    """
    picture, sketch = Picture(), push.sketch
    half = HALF * sketch.reach
    add_slider(picture, sketch, -half, half)
    add_cones(picture, sketch)
    for solution in push.solutions:
        if solution is not sketch.solution:
            add_solution(picture, sketch, solution, PALE)
    if sketch.solution is not None:
        add_solution(picture, sketch, sketch.solution)
    add_pusher(picture, sketch)
    if sketch.pusher is not None and np.any(sketch.contact_of(sketch.solution)):
        # The fence moves alike everywhere; the handle is at the tip of this arrow.
        picture.motion((0, 0), sketch.motion_scale * sketch.pusher, color=PUSHER)
    if sheet is not None:
        add_names(picture, spots_of(push, sheet, held), sheet)
    name_centers(picture, sketch.body, sketch.pose)
    return picture


def push_box(state: State) -> Array:
    """Corners of the picture of a push in any direction."""
    frame = frame_of(state.scene)
    ends = [(end, 0.0) for end in frame.ends or ()]
    reach = frame.reach * (1.36 if is_magnitude_open(state.scene) else 1.12)
    low, high = frame.body.box(frame.pose) + frame.half * np.array([[-0.3], [0.5]])
    around = np.array([low, high, (-1.5 * reach, -reach), (1.5 * reach, reach), *ends])
    for wall in walls_of(state):
        segment = wall.segment(frame.pose.origin, 2.0 * frame.half)
        around = around if segment is None else np.concatenate([around, segment])
    return np.array([around.min(axis=0), around.max(axis=0)])


def instant_picture(motion: FollowedMotion, time: float) -> Picture:
    """Picture of slider and pusher at a time, with the first pusher, past paths and the motion center."""
    picture, data, row = Picture(), motion.data, row_at(motion, time)
    add_first_pusher(picture, data, row)
    add_instant(picture, data, row)
    add_velocity(picture, data, row)
    add_paths(picture, data, motion.box, row)
    center, position = (data[f"path_{name}"].values[row] for name in ("center", "position"))
    if np.hypot(*(center - position)) < FAR * span(data):
        pivot = "path_pivot" in data and data["path_pivot"].values[row] >= 0
        add_center_mark(picture, center, pivot=pivot)
    return picture


def time_picture(motion: FollowedMotion) -> Picture:
    """Picture of the contact modes as a bar, a line above it if several are consistent, and energies.

    Strokes on the bar mark a side that lies on the fence.
    """
    picture, end = Picture(), float(motion.times[-1]) or 1.0
    for run in motion.runs:
        left, right = (LONG * motion.times[row] / end for row in (run.start, run.stop))
        look, low = MODES[run.mode], TOP - 0.3
        corners = np.array([(left, low), (right, low), (right, TOP), (left, TOP)])
        picture.add(Area((corners,), look.fill, look.hatch, look.ink))
        picture.line([*corners, corners[0]], look.ink, width=0.6)
        if run.several:
            picture.line([corners[3], corners[2]], DARK, width=3.0)
        if run.flush:
            strokes = corners - [(0.0, 0.0), (0.0, 0.0), (0.0, 0.2), (0.0, 0.2)]
            picture.add(Area((strokes,), "#FFFFFF", "|", DARK, AREAS + 0.1))
            picture.line([*strokes, strokes[0]], DARK, width=0.6)
    _energies(picture, motion, end)
    return picture


def _energies(picture: Picture, motion: FollowedMotion, end: float) -> None:
    """Add the energies over time, on an axis of height 1."""
    curves = energies(motion)
    low = min(0.0, *(float(values.min()) for values in curves.values()))
    high = max(1e-12, *(float(values.max()) for values in curves.values()))
    note: dict[str, Any] = {"size": NOTE, "held": True}
    for value in (low, high) if low < -0.01 * high else (0.0, high):
        y = (value - low) / (high - low)
        picture.line([(0.0, y), (LONG, y)], LIGHT, width=0.5)
        picture.label((0.0, y), f"{value:.3g}", offset=(-4.0, 0.0), align="right", **note)
    for value in np.linspace(0.0, end, 5):
        position = LONG * value / end, 0.0
        picture.label(position, f"{value:.3g}", offset=(0.0, -9.0), **note)
    picture.label((LONG / 2, 0.0), "time", offset=(0.0, -20.0), color=GUIDE, **note)
    for name, values in curves.items():
        points = [LONG * motion.times / end, (values - low) / (high - low)]
        width = 3.0 if name == "work" else 1.4  # the others add up to it and often cover it
        picture.line(np.stack(points, axis=-1), ENERGIES[name], width=width)


def time_line_picture(motion: FollowedMotion, time: float) -> Picture:
    """Picture of a line at a time."""
    picture, x = Picture(), LONG * min(time / (float(motion.times[-1]) or 1.0), 1.0)
    picture.line([(x, 0.0), (x, TOP)], DARK, width=1.4)
    return picture


def chip(name: str, fill: str, hatch: str = "", ink: str = DARK) -> str:
    """Legend entry: a small area and its name."""
    picture, side = Picture(), np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    picture.add(Area((side,), fill, hatch, ink, AREAS))
    svg = to_svg(picture, side[[0, 2]], (13, 13), pad=0.0)
    return f'<span class="key">{svg}{name}</span>'


def markup(picture: Picture, sheet: Sheet, more: str = "") -> str:
    """SVG elements of a picture, in a group with its origin and scale in pixels."""
    x, y = sheet.to_sheet((0.0, 0.0))
    return (
        f'<g data-x="{x:.2f}" data-y="{y:.2f}" data-scale="{sheet.scale:.4f}">'
        f"{content(picture, sheet)}{more}</g>"
    )
