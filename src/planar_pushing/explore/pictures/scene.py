"""The picture of a scene under a push: slider, fence or finger, cones, and every consistent solution."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.explore.handles import Frame, Handle, arrow_length, frame_of, places
from planar_pushing.explore.pictures.arrows import arrow, cone, force_arrow, motion_arrow
from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.explore.pictures.supports import add_centers, add_support
from planar_pushing.explore.state import State
from planar_pushing.explore.words import best
from planar_pushing.figures.parts.drawing import hatching, tint
from planar_pushing.figures.parts.sketch import CONE, Sketch
from planar_pushing.figures.parts.supports import Ink
from planar_pushing.figures.style import CENTER, FENCE, FORCE, GUIDE, MOTION, PUSHER, SLIDER, SLIP
from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.cones import friction_cone, motion_cone
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solutions import Solution, Solutions
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.options import Shape

#: How much of their color the solutions have that are not the one in full.
PALE = 0.3
#: Half the width of the fence and its depth, in units of the reach.
HALF, DEPTH = 1.75, 0.12


class Found(NamedTuple):
    """What the mechanics say of a state."""

    solutions: Solutions
    shown: int
    friction: AngleInterval
    motion: AngleInterval
    pusher: Array

    @property
    def solution(self) -> Solution | None:
        """The solution that is drawn in full."""
        return self.solutions[self.shown] if len(self.solutions) else None

    @property
    def force(self) -> Array | None:
        """Its force."""
        return None if self.solution is None else self.solution.force


def found(state: State) -> Found:
    """Solve the problem of a state."""
    scene, angle = state.scene, float(np.deg2rad(state.angle))
    solutions = solve(scene, angle, state.magnitude)
    shown = best(tuple(solutions), state.shown)
    pusher = state.magnitude * np.asarray(direction(angle))
    return Found(solutions, shown, *_cones(scene), pusher)


@lru_cache(maxsize=8)
def _cones(scene: Scene) -> tuple[AngleInterval, AngleInterval]:
    return friction_cone(scene), motion_cone(scene)


def sketch_of(state: State, solution: Solution, pusher: Array) -> Sketch:
    """The sizes of one solution's drawing, as the figures have them."""
    frame = frame_of(state.scene)
    mode = ("solution", np.array([solution.mode]))
    return Sketch(
        data=xr.Dataset({"rod_angle": state.file.slider.rod_angle, "mode": mode}),
        body=frame.body, ring=np.asarray(frame.pose.origin, dtype=float), pusher=pusher,
        force=solution.force, force_end=solution.force_end, motion=solution.contact_motion,
        center=solution.center, spin_ratio=solution.spin_ratio, pivots=solution.pivot >= 0,
    )  # fmt: skip


def picture(state: State, given: Found, selected: Handle = Handle.PUSHER) -> dict[str, Any]:
    """Columns of the picture, by the kind of mark."""
    marks, frame = Marks(), frame_of(state.scene)
    add_body(marks, state, frame)
    cones = [(given.motion, CONE, MOTION), (given.friction, 0.5, FORCE)]
    for interval, radius, color in sorted(cones, key=lambda each: -each[1]):
        cone(marks, interval.right, interval.left, radius * frame.reach, color)
    for index, solution in enumerate(given.solutions):
        if index != given.shown:
            _solution(marks, state, given, solution, PALE)
    if given.solution is not None:
        _solution(marks, state, given, given.solution, 1.0)
    if given.solution is None or given.solution.mode != ContactMode.STICK:
        _pusher(marks, state, frame)
    for name, place in places(state, given.force).items():
        marks.handle(place, name, selected=name == selected)
    return marks.columns


def add_body(marks: Marks, state: State, frame: Frame) -> None:
    """The slider with its rod, and the fence or the finger that pushes it."""
    if state.shape == Shape.FENCE:
        fence(marks, (0.0, 0.0), HALF * frame.reach, DEPTH * frame.reach)
    else:
        finger(marks, side_ends(state, frame), (0.0, 0.0))
    add_support(marks, frame.body, frame.pose, Ink())
    marks.line([(0.0, 0.0), frame.pose.origin], SLIDER, 2.4)
    marks.dot(frame.pose.origin, 6.0, SLIDER, SLIDER)
    marks.dot((0.0, 0.0), 9.0, SLIDER, SLIDER)
    add_centers(marks, frame.body, frame.pose)


def fence(marks: Marks, middle: Any, half: float, depth: float) -> None:
    """Piece of the fence, hatched on the side away from the slider."""
    x, y = middle
    for stroke in hatching(x - half, x + half, depth, y):
        marks.line(stroke, FENCE, 0.8)
    marks.line([(x - half, y), (x + half, y)], FENCE, 2.2)


def side_ends(state: State, frame: Frame) -> Array:
    """Ends of the side that a finger pushes, those that it has or those that are drawn."""
    ends = np.clip(state.scene.slider.side, -HALF * frame.reach, HALF * frame.reach)
    return np.array([(float(end), 0.0) for end in ends])


def finger(marks: Marks, side: Array, place: Any) -> None:
    """The side as a line, and the finger as a point."""
    marks.line(side, SLIDER, 2.0)
    marks.dot(place, 14.0, tint(PUSHER, 0.5), PUSHER)


def _pusher(marks: Marks, state: State, frame: Frame) -> None:
    vector = frame.reach * arrow_length(state) * np.asarray(direction(np.deg2rad(state.angle)))
    motion_arrow(marks, (0.0, 0.0), vector, frame.reach, f"{letter(state)}\u209a", color=PUSHER)


def letter(state: State) -> str:
    """Letter of the motions: accelerations where inertia resists, else velocities."""
    return "a" if state.scene.stores_energy else "v"


def _solution(
    marks: Marks, state: State, given: Found, solution: Solution, strength: float
) -> None:
    """Force, motion, slip and center of a solution; pale where another one is in full."""
    if solution.mode == ContactMode.SEPARATE:
        return
    sketch = sketch_of(state, solution, given.pusher)
    _force(marks, sketch, strength)
    _motion(marks, state, given, sketch, strength)
    _center(marks, sketch, strength)


def _force(marks: Marks, sketch: Sketch, strength: float) -> None:
    name = "f" if strength == 1.0 else ""
    if not sketch.moves:
        return
    for each in sketch.forces:
        end = sketch.end_of_line(each)
        marks.line([(0.0, 0.0), end], FORCE, 1.1, dash="dashed", alpha=strength)
        force_arrow(marks, (0.0, 0.0), sketch.drawn_force(each), sketch.reach, name, alpha=strength)
        name = ""


def _motion(marks: Marks, state: State, given: Found, sketch: Sketch, strength: float) -> None:
    """Motion of the slider's contact, and what it slips over the pusher, to the scale of the push."""
    scale = sketch.reach * arrow_length(state) / state.magnitude
    motion, pusher = scale * sketch.motion, scale * given.pusher
    own = letter(state)
    name = f"{own}\u209b = {own}\u209a" if sketch.sticks else f"{own}\u209b"
    text = name if strength == 1.0 else ""
    motion_arrow(marks, (0.0, 0.0), motion, sketch.reach, text, alpha=strength)
    if not sketch.sticks:
        word = "slip" if strength == 1.0 else ""
        arrow(
            marks, pusher, motion - pusher, sketch.reach, word, color=SLIP, filled=False,
            width=2.0, alpha=strength, at=0.5, aside=1.0,
        )  # fmt: skip


def _center(marks: Marks, sketch: Sketch, strength: float) -> None:
    """Motion center, or where it lies if it is far away."""
    color = CENTER if strength == 1.0 else tint(CENTER, PALE)
    if sketch.center_is_near:
        marks.line([sketch.ring, sketch.center], color, 1.1, dash="dashed")
        if sketch.pivots:
            marks.dot(sketch.center, 22.0, None, color)
        marks.dot(sketch.center, 11.0, "white", color, "circle_dot")
        if strength == 1.0:
            ahead = sketch.toward_center
            text = "pivot" if sketch.pivots else "centre"
            marks.label(sketch.center, text, color, (40 * ahead[0], 20 * ahead[1]))
    elif np.any(sketch.toward_center):
        marks.line([sketch.ring, sketch.far_center], color, 1.1, dash="dashed")
        if strength == 1.0:
            far = sketch.center_distance / sketch.radius
            words = f"centre {far:,.0f} radii away" if far < 1e6 else "centre almost at infinity"
            marks.label(sketch.far_center, words, GUIDE, (0.0, 14.0))


def bounds(state: State) -> Array:
    """Corners of what a picture of a scene has to hold, whatever the push."""
    frame = frame_of(state.scene)
    reach = 1.36 * frame.reach
    around = 0.3 * frame.body.half * np.array([[-1.0, -1.0], [1.0, 1.0]])
    corners = [*(frame.body.box(frame.pose) + around), (-1.3 * reach, -reach), (1.3 * reach, reach)]
    return np.array([np.min(corners, axis=0), np.max(corners, axis=0)])
