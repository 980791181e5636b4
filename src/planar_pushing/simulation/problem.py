"""A problem to simulate: scene, pusher, initial state, and policy for the contact modes.

The fence is the line ``y = Y(t)`` in a frame with its origin at the contact at time 0, and its displacement
is ``(X, Y)``. The rod angle can be any real number. Without an outline only the rod's free end, or both
ends of a flush side, can touch the fence, so the model is valid as long as the slider's center is above the
fence, and the simulation stops when it reaches the fence. Otherwise the corners of the outline can touch
it. A finger is the point ``(X, Y)``, or a disc with its center one radius below the contact at time 0.
Without an outline it pushes a side of the slider that is along x at time 0. Otherwise it follows the
outline; with inertia, the simulation stops when it touches the outline at two places.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np
import xarray as xr

from planar_pushing.core.supports.rows import RING, SUPPORT
from planar_pushing.mechanics.effects import Viscous
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.outline.chains import RHO, X, Y
from planar_pushing.mechanics.outline.places import (
    depth_tolerance,
    lowest_heights,
    nearest_place,
)
from planar_pushing.mechanics.rows import EffectColumns, entries_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.simulation.motion import require_policies
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.world import World, require_one_shape, require_pose, world_of
from planar_pushing.terms.declared import require_declared
from planar_pushing.terms.domain import DURATION, GAP, RTOL, SPEEDS, Number, require_ratio
from planar_pushing.terms.errors import InvalidValue, SceneWarning, has_entries, warn_user
from planar_pushing.terms.numbers import Array, as_numbers, is_lazy
from planar_pushing.terms.options import Policy, PusherFrame, Shape

#: Allowed initial twists.
TWIST = f"three finite numbers of at most {SPEEDS[1]:g}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """The problem that `simulate` solves.

    In a batch, numbers are arrays over the scenes. `on_ambiguity` is converted to policies with start
    times, and the motion of the pusher to the axes of the fence frame, except for a function of time under
    an array of worlds. `world` is the world, if the object's pose in it is given.

    Raises
    ------
    InvalidValue
        If a value is out of range, a twist is given although the scene's effects determine it, or the
        outline initially penetrates the pusher.
    """

    scene: Scene
    pusher: Pusher
    duration: Annotated[Number, DURATION]
    twist: Sequence[Number] = (0.0, 0.0, 0.0)
    gap: Annotated[Number, GAP] = 0.0
    on_ambiguity: Any = Policy.KEEP_CONTACT
    rtol: Annotated[float, RTOL] = 1e-10
    object_pose: Any = None
    world: World | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        require_declared(self)
        self._set("twist", _required_twist(self.twist, self.scene))
        self._set("on_ambiguity", require_policies(self.on_ambiguity))
        require_held(self.scene)
        if self.shape == Shape.FINGER:
            if self.scene.slider.flush:
                raise InvalidValue(
                    "pusher", "a finger on a side that lies on a fence", "a fence",
                    "push with a fence, or give the contact as a point of the object",
                )  # fmt: skip
            _require_narrow(self.pusher.radius, self.scene.slider.radius)
        self._require_outside()
        if self.object_pose is not None:
            self._set("object_pose", require_pose(self.object_pose))
            radius: Any = self.pusher.radius
            self._set("world", world_of(self.scene, self.object_pose, radius))
        self._set("pusher", self._pusher_in_fence_frame())

    def _set(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    def _require_outside(self) -> None:
        """Reject an outline of which a part is initially in the pusher, in at least one scene."""
        slider, is_fence = self.scene.slider, self.shape == Shape.FENCE
        if slider.outline is None:
            return
        if is_fence and np.any(np.asarray(slider.pocket) > 0.0):
            raise InvalidValue(
                "pusher", "a fence at an inner corner", "a point: a finger of radius 0",
                "a fence there would pass through the object",
            )  # fmt: skip
        fills = False
        try:
            if is_fence:
                distance = _height_of_outline(slider, self.gap)
            else:
                distance = _distance_of_outline(slider, self.gap, self.pusher.radius)
                fills = _fills_arc(slider, self.gap, self.pusher.radius)
        except ValueError:  # mismatched shapes, which the batch rejects itself
            return
        if fills:
            raise InvalidValue(
                "radius", self.pusher.radius, "a finger that touches the object at one place",
                "this one fills the hollow arc at the contact; choose another radius",
            )  # fmt: skip
        # A run ends at the full tolerance; the initial position must be within half of it.
        if distance >= -depth_tolerance(slider.outline) / 2:
            return
        if is_fence:
            raise InvalidValue(
                "outline", f"a point {-distance:.6g} below the fence",
                "an outline on the fence or above it",
                "rotate the slider, raise it by gap, or put the contact on the outline",
            )  # fmt: skip
        raise InvalidValue(
            "outline", f"an overlap of {-distance:.6g} with the finger", "a finger outside the object",
            "choose a smaller radius, or move the contact onto the outline and away from its other sides",
        )  # fmt: skip

    def _pusher_in_fence_frame(self) -> Pusher:
        """The pusher, with its motion along the axes of the fence frame."""
        if self.pusher.frame == PusherFrame.FENCE:
            return self.pusher
        if self.world is None:
            raise InvalidValue(
                "frame", str(self.pusher.frame), f"{PusherFrame.FENCE}, if no object_pose is given",
                "give simulate or simulate_batch the object_pose, or give the motion along and normal to "
                "the fence",
            )  # fmt: skip
        fence = self.world.fence
        if self.follows_function and any(map(np.ndim, fence.axis)):
            return self.pusher
        velocities = [part for _, velocity in self.pusher.velocities for part in velocity]
        require_one_shape([*fence.axis, *velocities])
        return self.pusher.in_fence_frame(fence)

    @property
    def shape(self) -> Shape:
        """The shape of the pusher."""
        return Shape(self.pusher.shape)

    @property
    def follows_function(self) -> bool:
        """Whether the pusher's velocity is a function of time."""
        return not self.pusher.velocities

    @property
    def passes_inner_corners(self) -> bool:
        """Whether a disc, of at least one scene, goes on where it touches two places: without inertia."""
        is_known = self.scene.slider.outline is not None
        return (
            is_known
            and not self.scene.stores_energy
            and bool(np.any(np.asarray(self.pusher.radius) > 0))
        )

    @property
    def entries(self) -> list[EffectColumns]:
        """The effects that resist, in the form of the core: friction, then viscous friction."""
        effects = [(i, effect) for i, effect in enumerate(self.scene.effects)]
        viscous = [(i, effect) for i, effect in effects if isinstance(effect, Viscous)]
        friction = [entry for entry in self.scene.rows.entries if entry.kind in (SUPPORT, RING)]
        return [*friction, *entries_of(viscous, self.scene)]


def _require_narrow(radius: Number, slider_radius: Number) -> None:
    """Reject a finger radius with an extreme ratio to the slider's radius, or with a mismatched shape."""
    require_one_shape([radius, slider_radius])
    require_ratio("finger_ratio", radius / slider_radius)


def _required_twist(value: Any, scene: Scene) -> tuple[Number, ...]:
    """Validate an initial twist, which must be zero for a scene without inertia."""
    twist = tuple(map(as_numbers, value)) if has_entries(value) else ()
    fits = (component is not None and (np.abs(component) <= SPEEDS[1]).all() for component in twist)
    if len(twist) != 3 or not all(fits):
        raise InvalidValue("twist", value, TWIST, "give (v_x, v_y, omega)")
    if not scene.stores_energy and any(np.any(component != 0) for component in twist):
        raise InvalidValue(
            "twist", value, "(0, 0, 0) for a scene without inertia",
            "leave the twist out, since the fence determines a quasi-static motion",
        )  # fmt: skip
    return twist


def _height_of_outline(slider: Slider, gap: Number) -> float:
    """Height of the outline above the fence, the minimum over several sliders."""
    length, angle = slider.rod_length, slider.rod_angle
    (origin_x, origin_y), (c, s) = slider.outline_frame
    x, y = origin_x - length * c, origin_y - length * s
    n_x, n_y = np.sin(angle), np.cos(angle)
    n_x, n_y = c * n_x - s * n_y, s * n_x + c * n_y

    def lowest(x: Array, y: Array, n_x: Array, n_y: Array) -> Array:
        """Smallest heights of the outline over points, along directions."""
        x, y, n_x, n_y = np.broadcast_arrays(x, y, n_x, n_y)
        normals = np.stack([np.asarray(n_x, float), n_y], axis=-1)
        heights = lowest_heights(slider.outline, normals.reshape(-1, 2))
        return np.asarray(heights.reshape(x.shape) - (n_x * x + n_y * y))

    height = gap + xr.apply_ufunc(lowest, x, y, n_x, n_y, dask="allowed")
    return float(np.min(np.asarray(height)))


def _finger_centers(slider: Slider, gap: Number, radius: Number) -> tuple[Number, Number]:
    """Position of the finger's center at time 0, in the object's frame."""
    across, angle = radius + gap, slider.rod_angle
    x, y = -slider.rod_length - across * np.sin(angle), -across * np.cos(angle)
    (origin_x, origin_y), (c, s) = slider.outline_frame
    return origin_x + x * c - y * s, origin_y + x * s + y * c


def _distance_of_outline(slider: Slider, gap: Number, radius: Number) -> float:
    """Distance of the outline from the finger, the minimum over several sliders."""

    def distances(x: Array, y: Array) -> Array:
        """Distances of points in the object's frame from the outline."""
        points = np.stack(np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float)), axis=-1)
        spots = nearest_place(slider.outline, points.reshape(-1, 2))
        return spots.gap.reshape(points.shape[:-1])

    x, y = _finger_centers(slider, gap, radius)
    distance = xr.apply_ufunc(distances, x, y, dask="allowed") - radius
    return float(np.min(np.asarray(distance)))


def _fills_arc(slider: Slider, gap: Number, radius: Number) -> bool:
    """Whether a finger is all along a hollow arc of its radius, in at least one scene."""
    x, y = _finger_centers(slider, gap, radius)
    depth = depth_tolerance(slider.outline)
    for center_x, center_y, rho in slider.outline.pieces[:, [X, Y, RHO]].tolist():
        if -math.inf < rho < 0.0:
            away, slack = np.hypot(x - center_x, y - center_y), abs(radius + rho)
            if np.any(np.asarray((away <= depth) & (slack <= depth))):
                return True
    return False


def warn_of_doubts(problem: Problem) -> None:
    """Warn if a push over time is probably not meant as given.

    Warns
    -----
    SceneWarning
        If a fence pushes at an inner point of a side, all of which lies on it; if a finger pushes an object
        that `scene_at` made without an outline; or if the finger's radius is larger than the object.
    """
    scene = problem.scene
    is_finger = problem.shape == Shape.FINGER
    for message in _of_finger(scene, problem.pusher.radius) if is_finger else _of_fence(scene):
        warn_user(SceneWarning(message))


def _of_fence(scene: Scene) -> Iterator[str]:
    """A contact of `scene_at` at an inner point of a side."""
    slider = scene.slider
    if scene.placement is None or slider.outline is None or slider.flush:
        return
    start, end = slider.side
    inner = (start > -np.inf) & (start < 0.0) & (end > 0.0) & (end < np.inf)
    if np.any(np.asarray(inner)):
        yield (
            "pusher: a fence at an inner point of a side, while the whole side lies on it; push the point "
            'with Pusher(shape="finger"), or make the scene with scene_at(side=...)'
        )


def _of_finger(scene: Scene, radius: Number) -> Iterator[str]:
    """A finger whose contact moves along a wall of unknown shape, or one of an implausible size."""
    slider = scene.slider
    unknown = slider.outline is None and all(map(_is_infinite, slider.side))
    if scene.placement is not None and unknown:
        yield (
            "outline: none given, so the finger moves along a straight wall without ends; give scene_at "
            "the outline of the object, or Scene a Slider with the ends of its side"
        )
    is_known = slider.outline is not None
    extent = _diameter(slider.outline.vertices()) if is_known else 2.0 * slider.radius
    if is_lazy(radius) or is_lazy(extent):
        return
    larger = np.ravel(radius > extent)
    if larger.any():
        widest = np.max(np.asarray(radius))
        yield (
            f"radius: {widest:.6g} of the finger, more than the size {np.min(extent):.6g} of the object; "
            "give both in one unit of length"
        )


def _diameter(corners: Array) -> float:
    """Largest distance between two corners."""
    x, y = corners.T
    return float(np.hypot(x[:, None] - x, y[:, None] - y).max())


def _is_infinite(end: Any) -> bool:
    """Whether a side has no end here, in all scenes."""
    return bool(np.all(np.isinf(np.asarray(end))))
