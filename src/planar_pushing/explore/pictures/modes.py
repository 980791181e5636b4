"""The contact-mode map: which modes are consistent, over the direction of the push and a second axis."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.explore.handles import magnitude_matters, unit_of_magnitude
from planar_pushing.explore.state import MAGNITUDES, ROD_ANGLES, State, pushed, with_law, with_rod
from planar_pushing.figures.parts.mode_sets import OTHER, STYLES
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve

#: Directions and values of the first map, and the most of the second one. An even number of directions
#: keeps off the push along the fence, which is a case of its own.
COARSE, FINE = (36, 15), (240, 161)
#: Seconds that the second map may take.
TIME = 0.3
#: Friction angles that have a finite coefficient.
STEEPEST = 89.0
#: Coefficients of friction and magnitudes that the axis names.
FRICTIONS = (0.0, 0.25, 0.5, 1.0, 2.0, 5.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """A second axis of the map, linear in its coordinate.

    `values` gives the scenes and magnitudes over coordinates, `here` the coordinate of a state, and `gone`
    the state at a coordinate.
    """

    title: str
    ends: Callable[[State], tuple[float, float]]
    values: Callable[[State, Array], tuple[Scene, Any]]
    here: Callable[[State], float]
    gone: Callable[[State, float], State]
    ticks: Callable[[State], dict[float, str]]


class Map(NamedTuple):
    """Codes of the sets of modes, rows over directions, columns over the axis."""

    codes: Any
    axis: str
    left: float
    right: float


def _over_friction(state: State, angle: Array) -> tuple[Scene, Any]:
    law = Coulomb(np.tan(np.deg2rad(angle)))
    return replace(state.scene, contact=law), state.magnitude


def _friction_angle(state: State) -> float:
    coefficient = getattr(state.scene.contact, "friction_coefficient", np.inf)
    return float(np.rad2deg(np.arctan(coefficient)))


def _to_friction(state: State, angle: float) -> State:
    coefficient = round(float(np.tan(np.deg2rad(np.clip(angle, 0.0, STEEPEST)))), 3)
    return with_law(state, {"law": "coulomb", "friction_coefficient": coefficient})


def _over_magnitude(state: State, size: Array) -> tuple[Scene, Any]:
    return state.scene, unit_of_magnitude(state.scene) * 10.0**size


def _over_rod(name: str, scale: float) -> Callable[[State, Array], tuple[Scene, Any]]:
    def values(state: State, along: Array) -> tuple[Scene, Any]:
        rod: dict[str, Any] = {name: scale * along}
        slider = replace(state.scene.slider, **rod)
        return replace(state.scene, slider=slider), state.magnitude

    return values


def _longest(state: State) -> float:
    return float(max(5.0 * state.size, 1.25 * state.file.slider.rod_length))


AXES: dict[str, Axis] = {
    "magnitude": Axis(
        title="size of the push, m a / W",
        ends=lambda state: (float(np.log10(MAGNITUDES[0])), float(np.log10(MAGNITUDES[1]))),
        values=_over_magnitude,
        here=lambda state: float(np.log10(state.magnitude / unit_of_magnitude(state.scene))),
        gone=lambda state, size: pushed(
            state, state.angle, unit_of_magnitude(state.scene) * 10.0**size
        ),
        ticks=lambda state: {float(e): f"{10.0**e:g}" for e in range(-2, 3)},
    ),
    "friction": Axis(
        title="coefficient of friction \u03bc",
        ends=lambda state: (0.0, 90.0),
        values=_over_friction,
        here=_friction_angle,
        gone=_to_friction,
        ticks=lambda state: (
            {float(np.rad2deg(np.arctan(mu))): f"{mu:g}" for mu in FRICTIONS} | {90.0: "\u221e"}
        ),
    ),
    "rod angle": Axis(
        title="rod angle (degrees)",
        ends=lambda state: (0.0, 180.0),
        values=_over_rod("rod_angle", np.pi / 180),
        here=lambda state: state.file.slider.rod_angle,
        gone=lambda state, angle: with_rod(
            state, state.file.slider.rod_length, float(np.clip(angle, *ROD_ANGLES))
        ),
        ticks=lambda state: {float(each): f"{each}" for each in range(0, 181, 45)},
    ),
    "rod length": Axis(
        title="rod length",
        ends=lambda state: (0.0, _longest(state)),
        values=_over_rod("rod_length", 1.0),
        here=lambda state: state.file.slider.rod_length,
        gone=lambda state, length: with_rod(state, length, state.file.slider.rod_angle),
        ticks=lambda state: {
            float(each): f"{each:.3g}" for each in np.linspace(0.0, _longest(state), 6)
        },
    ),
}


def axes_of(state: State) -> tuple[str, ...]:
    """Axes that matter to a state, the most telling first."""
    first = ("magnitude",) if magnitude_matters(state.scene) else ()
    return (*first, "friction", "rod angle", "rod length")


def axis_of(state: State) -> str:
    """The axis of a state's map: the chosen one where it matters."""
    allowed = axes_of(state)
    if state.across in allowed:
        return state.across
    coulomb = isinstance(state.scene.contact, Coulomb)
    return allowed[0] if coulomb or allowed[0] == "magnitude" else "rod angle"


def maps(state: State) -> Any:
    """A coarse map, and one as fine as half a second allows."""
    start = time.perf_counter()
    yield mode_map(state, COARSE)
    each = (time.perf_counter() - start) / np.prod(COARSE)
    finer = float(np.sqrt(min(TIME / each / np.prod(FINE), 1.0)))
    size = 2 * round(finer * FINE[0] / 2), round(finer * FINE[1])
    if size[0] > COARSE[0]:
        yield mode_map(state, size)


def mode_map(state: State, size: tuple[int, ...]) -> Map:
    """Sets of consistent modes at the middles of cells."""
    name = axis_of(state)
    left, right = AXES[name].ends(state)
    angle = -180.0 + (np.arange(size[0]) + 0.5) * 360.0 / size[0]
    along = left + (np.arange(size[1]) + 0.5) * (right - left) / size[1]
    scene, magnitude = AXES[name].values(state, along[None, :])
    found = solve(scene, np.deg2rad(angle)[:, None], magnitude)
    bits = np.where(found.mode >= 0, 1 << np.maximum(found.mode, 0).astype(int), 0)
    codes = np.bitwise_or.reduce(bits, axis=-1).astype(np.uint8)
    return Map(np.broadcast_to(codes, size).copy(), name, left, right)


def gone(state: State, angle: float, along: float) -> State:
    """The state at a place of its map."""
    found = AXES[axis_of(state)].gone(state, along)
    return pushed(found, float(np.clip(angle, -180.0, 180.0)), found.magnitude)


def look(code: int) -> tuple[str, str]:
    """Name and color of a set of modes, as in Fig. 13."""
    name, color, _ = STYLES.get(code, OTHER)
    return name, color
