"""The contact-mode map: consistent modes over the direction of the push and a second axis."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.drawing.canvas.colors import DARK, GUIDE, look_of
from planar_pushing.drawing.canvas.marks import NOTE, Area, Picture
from planar_pushing.explorer.lengths import factor, label
from planar_pushing.explorer.pictures.curve import words_alone
from planar_pushing.explorer.pictures.handles import unit_of_magnitude
from planar_pushing.explorer.state import (
    MAGNITUDES,
    ROD_ANGLES,
    State,
    with_law,
    with_push,
    with_rod,
    without_display,
)
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.force.cones import is_magnitude_open
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

#: Numbers of directions and values of the first map, and the largest numbers of the second map. An even
#: number of directions avoids the push along the fence, which is a special case.
COARSE, FINE = (36, 15), (240, 161)
#: Time limit of the second map in seconds.
TIME = 0.3
#: Largest friction angle with a finite coefficient.
STEEPEST = 89.0
#: Friction coefficients labeled on the axis.
FRICTIONS = (0.0, 0.25, 0.5, 1.0, 2.0, 5.0)
#: Width of the map for a height of 1, and the box around the map and its labels.
WIDE = 1.5
BOX = np.array([(-0.17, -0.15), (WIDE + 0.03, 1.08)])


#: Text in the place of the map of a side on the fence.
NO_MAP = (
    "A side lies on the fence: the map is for contacts\nat one point, which have no flush modes."
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """A second axis of the map, linear in its coordinate.

    `values` returns the scenes and magnitudes over coordinates, `coordinate_of` the coordinate of a state,
    and `state_at` the state at a coordinate.
    """

    title: str
    ends: Callable[[State], tuple[float, float]]
    values: Callable[[State, Array], tuple[Scene, Any]]
    coordinate_of: Callable[[State], float]
    state_at: Callable[[State, float], State]
    ticks: Callable[[State], dict[float, str]]


class Map(NamedTuple):
    """Codes of the sets of modes, with rows over directions and columns over the axis, and its ends."""

    codes: npt.NDArray[np.uint8]
    left: float
    right: float


def _friction_angle(state: State) -> float:
    coefficient = getattr(state.scene.contact, "friction_coefficient", np.inf)
    return float(np.rad2deg(np.arctan(coefficient)))


def _to_friction(state: State, angle: float) -> State:
    coefficient = round(float(np.tan(np.deg2rad(np.clip(angle, 0.0, STEEPEST)))), 3)
    return with_law(state, {"law": "coulomb", "friction_coefficient": coefficient})


def _over_friction(state: State, angle: Array) -> tuple[Scene, Any]:
    return replace(state.scene, contact=Coulomb(np.tan(np.deg2rad(angle)))), state.magnitude


def _over_rod(name: str, scale: float) -> Callable[[State, Array], tuple[Scene, Any]]:
    def values(state: State, along: Array) -> tuple[Scene, Any]:
        rod: dict[str, Any] = {name: scale * along}
        return replace(state.scene, slider=replace(state.scene.slider, **rod)), state.magnitude

    return values


def _longest(state: State) -> float:
    return float(max(5.0 * state.size, 1.25 * state.file.slider.rod_length))


AXES: dict[str, Axis] = {
    "magnitude": Axis(
        title="magnitude of the push, m a / W",
        ends=lambda state: (float(np.log10(MAGNITUDES[0])), float(np.log10(MAGNITUDES[1]))),
        values=lambda state, power: (state.scene, unit_of_magnitude(state.scene) * 10.0**power),
        coordinate_of=lambda state: float(
            np.log10(state.magnitude / unit_of_magnitude(state.scene))
        ),
        state_at=lambda state, power: with_push(
            state, state.angle, unit_of_magnitude(state.scene) * 10.0**power
        ),
        ticks=lambda state: {float(power): f"{10.0**power:g}" for power in range(-2, 3)},
    ),
    "friction": Axis(
        title="coefficient of friction \u03bc",
        ends=lambda state: (0.0, 90.0),
        values=_over_friction,
        coordinate_of=_friction_angle,
        state_at=_to_friction,
        ticks=lambda state: (
            {float(np.rad2deg(np.arctan(mu))): f"{mu:g}" for mu in FRICTIONS} | {90.0: "\u221e"}
        ),
    ),
    "rod angle": Axis(
        title="rod angle (degrees)",
        ends=lambda state: (0.0, 180.0),
        values=_over_rod("rod_angle", np.pi / 180),
        coordinate_of=lambda state: state.file.slider.rod_angle,
        state_at=lambda state, angle: with_rod(
            state, state.file.slider.rod_length, float(np.clip(angle, *ROD_ANGLES))
        ),
        ticks=lambda state: {float(angle): f"{angle}" for angle in range(0, 181, 45)},
    ),
    "rod length": Axis(
        title="rod length",
        ends=lambda state: (0.0, _longest(state)),
        values=_over_rod("rod_length", 1.0),
        coordinate_of=lambda state: state.file.slider.rod_length,
        state_at=lambda state, length: with_rod(state, length, state.file.slider.rod_angle),
        ticks=lambda state: {
            float(length): f"{length * factor(state):.3g}"
            for length in np.linspace(0.0, _longest(state), 6)
        },
    ),
}


def axes_of(state: State) -> list[str]:
    """Axes that matter to a state, the most informative first.

    An object with an outline has no rod of its own: its contact moves along the outline.
    """
    absent = set() if is_magnitude_open(state.scene) else {"magnitude"}
    absent |= {"rod angle", "rod length"} if state.has_outline else set()
    return [name for name in AXES if name not in absent]


def axis_of(state: State) -> str:
    """Axis of the map of a state: the chosen axis if it matters."""
    allowed = axes_of(state)
    if state.across in allowed:
        return state.across
    coulomb = isinstance(state.scene.contact, Coulomb)
    takes_first = coulomb or allowed[0] == "magnitude" or "rod angle" not in allowed
    return allowed[0] if takes_first else "rod angle"


def maps(state: State) -> Iterator[Map]:
    """Yield a coarse map, then one as fine as time allows; an empty one for a side on the fence."""
    if state.flush:
        yield Map(np.empty((0, 0), dtype=np.uint8), 0.0, 1.0)
        return
    start = time.perf_counter()
    yield mode_map(state, COARSE)
    seconds = (time.perf_counter() - start) / np.prod(COARSE)
    finer = float(np.sqrt(min(TIME / seconds / np.prod(FINE), 1.0)))
    size = 2 * round(finer * FINE[0] / 2), round(finer * FINE[1])
    if size[0] > COARSE[0]:
        fine = mode_map(state, size)
        _finest[_key_of(state)] = fine
        if len(_finest) > KEPT:
            _finest.pop(next(iter(_finest)), None)
        yield fine


#: The last fine maps, by their states, and the number of them that are kept.
_finest: dict[State, Map] = {}
KEPT = 8


def _key_of(state: State) -> State:
    """A state without the parts on which its map does not depend, such as the motion over time."""
    file = state.file.model_copy(update={"simulate": None})
    bare = replace(without_display(state), file=file, angle=0.0, several=None)
    return replace(bare, across=axis_of(state))


def quick_map(state: State) -> Map:
    """A fine map that is known, or a coarse one, which is ready as soon as a picture of the push."""
    known = _finest.get(_key_of(state))
    return next(maps(state)) if known is None else known


def mode_map(state: State, size: tuple[int, ...]) -> Map:
    """Sets of consistent modes at the centers of cells."""
    axis = AXES[axis_of(state)]
    left, right = axis.ends(state)
    angle = -180.0 + (np.arange(size[0]) + 0.5) * 360.0 / size[0]
    along = left + (np.arange(size[1]) + 0.5) * (right - left) / size[1]
    scene, magnitude = axis.values(state, along[None, :])
    solutions = solve(scene, np.deg2rad(angle)[:, None], magnitude)
    bits = np.where(solutions.mode >= 0, 1 << np.maximum(solutions.mode, 0).astype(int), 0)
    codes = np.bitwise_or.reduce(bits, axis=-1).astype(np.uint8)
    return Map(np.broadcast_to(codes, size).copy(), left, right)


def state_at(state: State, position: Array) -> State:
    """State at a position in the picture of its map."""
    axis, (x, y) = AXES[axis_of(state)], np.clip(position, 0.0, (WIDE, 1.0))
    left, right = axis.ends(state)
    other = axis.state_at(state, float(left + (right - left) * x / WIDE))
    return with_push(other, float(360.0 * y - 180.0), other.magnitude)


def position_of(state: State) -> Array:
    """Position of a state in the picture of its map."""
    axis = AXES[axis_of(state)]
    left, right = axis.ends(state)
    return np.array(
        [WIDE * (axis.coordinate_of(state) - left) / (right - left), state.angle / 360.0 + 0.5]
    )


# -- marks -------------------------------------------------------------------------------------------


def map_picture(state: State, modes: Map) -> Picture:
    """Picture of the map with its axes; its height is 1."""
    if state.flush:
        return words_alone(BOX, NO_MAP)
    picture = Picture()
    for code in np.unique(modes.codes):
        look = look_of(int(code))
        cells = tuple(_rectangles(modes.codes == code))
        picture.add(Area(cells, look.fill, look.hatch, look.ink))
    frame = [(0.0, 0.0), (WIDE, 0.0), (WIDE, 1.0), (0.0, 1.0), (0.0, 0.0)]
    picture.line(frame, GUIDE, width=0.7)
    _name_axes(picture, state)
    return picture


def _rectangles(inside: npt.NDArray[np.bool_]) -> Iterator[Array]:
    """Corners of rectangles that cover cells of a map, one for each run of cells in a row."""
    rows, columns = inside.shape
    edges = np.diff(np.pad(inside, ((0, 0), (1, 1))).astype(int), axis=1)
    starts, stops = (np.argwhere(edges == sign) for sign in (1, -1))
    for (row, start), (_, stop) in zip(starts, stops, strict=True):
        x, y = WIDE * np.array([start, stop]) / columns, np.array([row, row + 1]) / rows
        yield np.array([(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])])


def _name_axes(picture: Picture, state: State) -> None:
    axis = AXES[axis_of(state)]
    left, right = axis.ends(state)
    note: dict[str, Any] = {"size": NOTE, "held": True, "color": DARK}
    for value, text in axis.ticks(state).items():
        x = WIDE * (value - left) / (right - left)
        picture.line([(x, 0.0), (x, -0.015)], GUIDE, width=0.7)
        picture.label((x, 0.0), text, offset=(0.0, -8.0), **note)
    for angle in range(-180, 181, 60):
        y = angle / 360 + 0.5
        picture.line([(0.0, y), (-0.015, y)], GUIDE, width=0.7)
        text = f"{angle}".replace("-", "\u2212")
        picture.label((0.0, y), text, offset=(-6.0, 0.0), align="right", **note)
    name = label(axis.title, state) if axis.title == "rod length" else axis.title
    picture.label((WIDE / 2, 0.0), name, offset=(0.0, -18.0), **note)
    title = "direction of the push (degrees)"
    picture.label((0.0, 1.0), title, offset=(0.0, 10.0), align="left", **note)


def cross(state: State) -> Picture:
    """Picture of a cross at the position of a state."""
    picture = Picture()
    if state.flush:
        return picture
    here = position_of(state)
    for color, width, half in (("#FFFFFF", 3.6, 0.034), (DARK, 1.5, 0.03)):
        for arm in half * np.eye(2):
            picture.line([here - arm, here + arm], color, width=width)
    return picture


def sets_of(modes: Map) -> list[int]:
    """Codes of the sets of modes on a map, smaller sets first."""
    codes = {int(code) for code in np.unique(modes.codes)}
    return sorted(codes, key=lambda code: (code.bit_count(), code))
