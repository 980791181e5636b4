"""A problem to simulate: scene, pusher, initial state, and policy for the contact modes; and its numbers.

The fence is the line ``y = Y(t)`` in a frame with its origin at the contact at time 0, and its displacement
is ``(X, Y)``. The rod angle can be any real number. Only the rod's free end can touch the fence, so the
model is valid as long as the slider's center is above the fence. The simulation stops when the center
reaches the fence, where the rod lies along it. If the slider has an outline, the simulation also stops when
another point of the outline meets the pusher. A finger is the point ``(X, Y)``, or a disc with its center
one radius below the contact at time 0; it pushes a side of the slider that is along x at time 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.core.rows import LOAD, MASS, RING, SUPPORT
from planar_pushing.core.run import IN_COEFFICIENTS, IN_EVENTS, IN_PIECES, IN_TIMES, INPUTS
from planar_pushing.mechanics.arrays import Output, mapped
from planar_pushing.mechanics.effects import Viscous
from planar_pushing.mechanics.held import require_held
from planar_pushing.mechanics.outline import Corners, size
from planar_pushing.mechanics.rows import Entry, entries_of, unit_vector
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.supports.pressure.table import Table, joined_data
from planar_pushing.mechanics.world import World, required_pose, world_of
from planar_pushing.simulation.motion import (
    POINTS,
    constant_pieces,
    required_policies,
    smooth_pieces,
    starts_of,
    write_policies,
)
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.domain import SPEEDS, Number, require_fields, required_ratio
from planar_pushing.terms.errors import InvalidValue, has_entries, require_number
from planar_pushing.terms.numbers import Array, as_numbers
from planar_pushing.terms.options import SAMPLES, TOLERANCE, Policy, PusherFrame, Shape

#: Allowed initial twists.
TWIST = f"three finite numbers of at most {SPEEDS[1]:g}"
#: Allowed depth of the outline in the pusher, in extents of the outline. It is far above rounding error, so
#: that a side lying on the fence does not end a run without rotation.
DEPTH = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """The problem that `simulate` solves.

    In a batch, numbers are arrays over the scenes. `on_ambiguity` is converted to policies with start
    times, and the motion of the pusher to the axes of the fence frame. `world` is the world, if the
    object's pose in it is given.

    Raises
    ------
    InvalidValue
        If a value is out of range, a twist is given although the scene's effects determine it, or the
        outline initially penetrates the pusher.
    """

    scene: Scene
    pusher: Pusher
    duration: Number
    twist: Sequence[Number] = (0.0, 0.0, 0.0)
    gap: Number = 0.0
    on_ambiguity: Any = Policy.KEEP_CONTACT
    rtol: float = 1e-10
    object_pose: Any = None
    world: World | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        require_fields(self, "duration", "gap")
        rtol = require_number(
            "rtol", self.rtol, TOLERANCE.holds, TOLERANCE.allowed,
            "choose a tolerance that double precision can achieve",
        )  # fmt: skip
        self._set("rtol", rtol)
        self._set("twist", _required_twist(self.twist, self.scene))
        self._set("on_ambiguity", required_policies(self.on_ambiguity))
        require_held(self.scene)
        if self.shape == Shape.FENCE:
            require_above(self.scene.slider, self.gap)
        else:
            _require_narrow(self.pusher.radius, self.scene.slider.radius)
            require_apart(self.scene.slider, self.gap, self.pusher.radius)
        if self.object_pose is not None:
            self._set("object_pose", required_pose(self.object_pose))
            self._set("world", world_of(self.scene, self.object_pose))
        self._set("pusher", self._pusher_in_fence_frame())

    def _set(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    def _pusher_in_fence_frame(self) -> Pusher:
        """The pusher, with its motion along the axes of the fence frame."""
        if self.pusher.frame == PusherFrame.FENCE:
            return self.pusher
        if self.world is None:
            raise InvalidValue(
                "frame", str(self.pusher.frame), f"{PusherFrame.FENCE}, if no object_pose is given",
                "give simulate the object_pose, or give the motion along and normal to the fence",
            )  # fmt: skip
        return self.pusher.in_fence_frame(self.world.fence)

    @property
    def shape(self) -> Shape:
        """The shape of the pusher."""
        return Shape(self.pusher.shape)

    @property
    def follows_function(self) -> bool:
        """Whether the pusher's velocity is a function of time."""
        return not self.pusher.velocities

    @property
    def entries(self) -> list[Entry]:
        """The effects that resist, in the form of the core: friction, then viscous friction."""
        effects = [(i, effect) for i, effect in enumerate(self.scene.effects)]
        viscous = [(i, effect) for i, effect in effects if isinstance(effect, Viscous)]
        friction = [entry for entry in self.scene.rows.entries if entry.kind in (SUPPORT, RING)]
        return [*friction, *entries_of(viscous, self.scene)]


def _require_narrow(radius: Number, slider_radius: Number) -> None:
    """Reject a finger radius with an extreme ratio to the slider's radius, or with a mismatched shape."""
    try:
        ratio = radius / slider_radius
    except ValueError:
        shapes = np.shape(radius), np.shape(slider_radius)
        raise InvalidValue(
            "shapes", shapes, "() or (scenes,)", "give one number for each scene"
        ) from None
    required_ratio("finger_ratio", ratio)


def _required_twist(value: Any, scene: Scene) -> tuple[Number, ...]:
    """Validate an initial twist, which must be zero for a scene without inertia."""
    twist = tuple(map(as_numbers, value)) if has_entries(value) else ()
    fits = (each is not None and (np.abs(each) <= SPEEDS[1]).all() for each in twist)
    if len(twist) != 3 or not all(fits):
        raise InvalidValue("twist", value, TWIST, "give (v_x, v_y, omega)")
    if not scene.stores_energy and any(np.any(each != 0) for each in twist):
        raise InvalidValue(
            "twist", value, "(0, 0, 0) for a scene without inertia",
            "leave the twist out, since the fence determines a quasi-static motion",
        )  # fmt: skip
    return twist


def sample_count(value: object) -> int:
    """Validate a number of samples, which includes the first and the last instant."""
    count = require_number(
        "samples", value, lambda n: SAMPLES.holds(n) and n == int(n), SAMPLES.allowed,
        "request at least the first and the last instant",
    )  # fmt: skip
    return int(count)


def depth_tolerance(outline: Corners) -> float:
    """Allowed depth of the outline in the pusher, in the outline's unit."""
    return DEPTH * size(np.array(outline))


def require_above(slider: Slider, gap: Number) -> None:
    """Reject an outline that initially penetrates the fence.

    Raises
    ------
    InvalidValue
        If a corner of at least one slider is below the fence; the message gives its depth.
    """
    if slider.outline is None:
        return
    try:
        lowest = _lowest(slider, gap)
    except ValueError:  # mismatched shapes, which the batch rejects itself
        return
    # A run ends at the full tolerance; the initial position must be within half of it.
    if lowest < -depth_tolerance(slider.outline) / 2:
        raise InvalidValue(
            "outline", f"a corner {-lowest:.6g} below the fence", "corners on the fence or above it",
            "rotate the slider, raise it by gap, or put the contact on the outline",
        )  # fmt: skip


def _lowest(slider: Slider, gap: Number) -> float:
    """Height of the lowest corner above the fence, the minimum over several sliders."""
    c, s = np.cos(slider.rod_angle), np.sin(slider.rod_angle)
    heights = (gap + (slider.rod_length + x) * s + y * c for x, y in slider.outline)
    return min(float(np.min(np.asarray(height))) for height in heights)


def require_apart(slider: Slider, gap: Number, radius: Number) -> None:
    """Reject an outline that initially overlaps the finger.

    Raises
    ------
    InvalidValue
        If at least one slider overlaps its finger; the message gives the depth.
    """
    if slider.outline is None:
        return
    corners = np.array(slider.outline)

    def distances(x: Array, y: Array) -> Array:
        """Distances of points from the outline."""
        output = [Output("distance")]
        return mapped("outline_distances", corners.ravel(), [x, y, len(corners), 0], output)[0]

    try:
        across, angle = radius + gap, slider.rod_angle
        x, y = -slider.rod_length - across * np.sin(angle), -across * np.cos(angle)
        apart = xr.apply_ufunc(distances, x, y, dask="allowed") - radius
        nearest = float(np.min(np.asarray(apart)))
    except ValueError:  # mismatched shapes, which the batch rejects itself
        return
    if nearest < -depth_tolerance(slider.outline) / 2:
        raise InvalidValue(
            "outline", f"an overlap of {-nearest:.6g} with the finger", "a finger outside the object",
            "choose a smaller radius, or move the contact onto the outline and away from its other sides",
        )  # fmt: skip


class Scenes(NamedTuple):
    """The scenes of a problem as numbers for the core, in which lengths are in radii of the slider.

    Attributes
    ----------
    problem : Problem
    data : ndarray
        Numbers that all scenes share: effects and outline.
    inputs : ndarray, shape (scenes, numbers)
        Beginning of the rows of inputs: numbers of the effects, and of the scene.
    radius, ends : ndarray, shape (scenes,)
        Radii of the sliders, and durations.
    velocities : ndarray, shape (scenes, pieces, 2)
        Piecewise constant velocities of the pushers, without pieces for a function of time.
    """

    problem: Problem
    data: Array
    inputs: Array
    radius: Array
    ends: Array
    velocities: Array

    @classmethod
    def of(cls, problem: Problem, data: Array, columns: Array) -> Scenes:
        """Scenes from the arrays of `numbers_of`, shape (scenes, columns)."""
        pieces = len(problem.pusher.velocities)
        first = columns.shape[1] - 2 * pieces
        radius, ends = columns[:, first - 2], columns[:, first - 1]
        velocities = columns[:, first:].reshape(len(columns), pieces, 2) / radius[:, None, None]
        return cls(problem, data, columns[:, : first - 2], radius, ends, velocities)

    def pieces(self, part: slice) -> tuple[Array, npt.NDArray[Any]]:
        """Pieces of the pusher's motion, shape (scenes, pieces, numbers), and how many of each are valid.

        Those of a function of time are of the first scene of the part only.

        Raises
        ------
        InvalidValue
            If a function does not return a velocity.
        """
        pusher, policies = self.problem.pusher, self.problem.on_ambiguity
        ends, radius, cuts = self.ends[part], self.radius[part], starts_of(policies)
        if self.problem.follows_function:
            end = float(ends[0])
            inner = {time for time in (*pusher.breakpoints, *cuts) if 0 < time < end}
            times = [0.0, *sorted(inner), end]
            pieces = smooth_pieces(pusher.velocity_at, times, float(radius[0]))[None]
            counts = np.array([pieces.shape[1]])
        else:
            starts = [time for time, _ in pusher.velocities]
            pieces, counts = constant_pieces(starts, self.velocities[part], ends, cuts)
        write_policies(pieces, policies)
        return pieces, counts

    def rows(
        self, part: slice, pieces: Array, counts: npt.NDArray[Any], times: Array, events: bool
    ) -> Array:
        """Rows of inputs of a part of the scenes.

        Parameters
        ----------
        part : slice
        pieces, counts : ndarray
            As returned by `pieces`.
        times : ndarray, shape (scenes, kinds, times)
            Times to log, or intervals of steps in the form of the core.
        events : bool
            Whether each event is logged as well.
        """
        inputs = self.inputs[part].copy()
        scene = inputs[:, inputs.shape[1] - INPUTS :]
        scene[:, IN_PIECES], scene[:, IN_TIMES], scene[:, IN_EVENTS] = (
            counts,
            times.shape[-1],
            events,
        )
        scene[:, IN_COEFFICIENTS] = POINTS if self.problem.follows_function else 1
        shape = len(inputs), -1
        return np.concatenate([inputs, times.reshape(shape), pieces.reshape(shape)], axis=1)


def numbers_of(problem: Problem) -> tuple[Array, list[Number]]:
    """The numbers of a problem: those that all scenes share, and one column for each of the others.

    The columns are the inputs of the core, except for times and pieces; then radius, duration, and
    components of a piecewise constant velocity. The core has lengths in units of the radius. Its masses and
    viscous friction coefficients are therefore those of the scene multiplied by the radius. The weight is
    zero without friction, and the mass is zero without inertia.
    """
    scene, slider, entries = problem.scene, problem.scene.slider, problem.entries
    radius, (mass, gyration), (v_x, v_y, omega) = slider.radius, scene.inertia, problem.twist
    is_finger, finger_radius = problem.shape == Shape.FINGER, problem.pusher.radius
    effects, columns = _effects_of(entries, scene)
    data, corners = joined_data(effects, len(columns)), _corners_of(slider)
    columns += [
        scene.weight if scene.friction else 0.0,
        mass * radius if scene.stores_energy else 0.0,
        gyration, *scene.mass_center, *_load_of(scene), slider.length_ratio, slider.rod_angle,
        *scene.law, v_x / radius, v_y / radius, omega, problem.gap / radius, is_finger,
        finger_radius / radius, *(end / radius for end in slider.side), _fineness(slider),
        len(corners), len(data), sum(entry.degree == 1 for entry in entries), len(entries),
        problem.rtol, 0.0, 0.0, 0.0, 0.0, radius, problem.duration,
    ]  # fmt: skip
    columns += [part for _, velocity in problem.pusher.velocities for part in velocity]
    return np.concatenate([data, corners.ravel()]) if len(corners) else data, columns


def _effects_of(
    entries: list[Entry], scene: Scene
) -> tuple[list[tuple[int, int, Table | None]], list[Number]]:
    """Kinds, first columns and tables of effects, and their columns; the core fills inertia and loads."""
    effects: list[tuple[int, int, Table | None]] = []
    columns: list[Number] = []
    for entry in entries:
        effects.append((entry.kind, len(columns), entry.table))
        factor = scene.slider.radius if entry.degree == 2 else 1.0
        columns += [*(force * factor for force in entry.forces), *entry.others]
    for kind, width, effects_of_kind in ((MASS, 4, scene.masses), (LOAD, 3, scene.loads)):
        if effects_of_kind:
            effects.append((kind, len(columns), None))
            columns += [0.0] * width
    return effects, columns


def _corners_of(slider: Slider) -> Array:
    """Corners of the outline in units of its tolerance, shape (corners, 2); empty without an outline."""
    if slider.outline is None:
        return np.empty((0, 2))
    return np.array(slider.outline) / depth_tolerance(slider.outline)


def _fineness(slider: Slider) -> Number:
    """Radius in units of the outline's tolerance, 0 without an outline."""
    return 0.0 if slider.outline is None else slider.radius / depth_tolerance(slider.outline)


def _load_of(scene: Scene) -> list[Number]:
    """Force of the loads in the initial body frame, and its cross and dot products with their points."""
    total: list[Number] = [0.0, 0.0, 0.0, 0.0]
    if not scene.loads:
        return total
    c, s = unit_vector(scene.slider.rod_angle)
    for load in scene.loads:
        (x, y), (p_x, p_y) = load.force, scene.mass_center
        if load.center is not None:
            p_x, p_y = (coordinate / scene.slider.radius for coordinate in load.center)
        g_x, g_y = x * c + y * s, y * c - x * s
        terms = g_x, g_y, p_x * g_y - p_y * g_x, p_x * g_x + p_y * g_y
        total = [sum(pair) for pair in zip(total, terms, strict=True)]
    return total
