"""A problem to simulate: scene, pusher, initial state, and policy for the contact modes.

The fence is the line ``y = Y(t)`` in a frame with its origin at the contact at time 0, and its displacement
is ``(X, Y)``. The rod angle can be any real number. Only the rod's free end can touch the fence, so the
model is valid as long as the slider's center is above the fence. The simulation stops when the center
reaches the fence, where the rod lies along it. If the slider has an outline, the simulation also stops when
another point of the outline meets the pusher. A finger is the point ``(X, Y)``, or a disc with its center
one radius below the contact at time 0; it pushes a side of the slider that is along x at time 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from planar_pushing.mechanics.held import require_held
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.world import World, required_pose, world_of
from planar_pushing.simulation.outlines import require_above, require_apart
from planar_pushing.simulation.policies import marked, required_policies, starts_of
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.domain import SPEEDS, Number, require_fields, required_ratio
from planar_pushing.terms.errors import InvalidValue, has_entries, require_number
from planar_pushing.terms.numbers import as_numbers
from planar_pushing.terms.options import SAMPLES, TOLERANCE, Policy, PusherFrame, Shape

#: Allowed initial twists.
TWIST = f"three finite numbers of at most {SPEEDS[1]:g}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """The problem that `simulate` solves.

    In a batch, numbers are arrays over the scenes. `on_ambiguity` is converted to policies with start
    times, and the motion of the pusher to the axes of the fence frame.

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

    def __post_init__(self) -> None:
        require_fields(self, "duration", "gap")
        rtol = require_number(
            "rtol", self.rtol, TOLERANCE.holds, TOLERANCE.allowed,
            "choose a tolerance that double precision can achieve",
        )  # fmt: skip
        object.__setattr__(self, "rtol", rtol)
        object.__setattr__(self, "twist", _twist(self.twist, self.scene))
        object.__setattr__(self, "on_ambiguity", required_policies(self.on_ambiguity))
        require_held(self.scene)
        if self.shape == Shape.FENCE:
            require_above(self.scene.slider, self.gap)
        else:
            _require_narrow(self.pusher.radius, self.scene.slider.radius)
            require_apart(self.scene.slider, self.gap, self.pusher.radius)
        if self.object_pose is not None:
            object.__setattr__(self, "object_pose", required_pose(self.object_pose))
        object.__setattr__(self, "pusher", self._pusher_along_the_fence())

    def _pusher_along_the_fence(self) -> Pusher:
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
    def world(self) -> World | None:
        """The world, if the object's pose in it is given."""
        return None if self.object_pose is None else world_of(self.scene, self.object_pose)

    @property
    def shape(self) -> Shape:
        """The shape of the pusher."""
        return Shape(self.pusher.shape)

    @property
    def follows_function(self) -> bool:
        """Whether the pusher's velocity is a function of time."""
        return not self.pusher.pieces and not self.pusher.arrays

    def fence(self, duration: float, radius: float) -> Any:
        """The pusher's motion as an array of pieces, each with its policy; errors as in `Pusher`."""
        cuts = starts_of(self.on_ambiguity)
        return marked(self.pusher.fence(duration, radius, cuts), self.on_ambiguity)


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


def _twist(given: Any, scene: Scene) -> tuple[Number, ...]:
    """Validate an initial twist, which must be zero for a scene without inertia."""
    twist = tuple(map(as_numbers, given)) if has_entries(given) else ()
    fits = (each is not None and (np.abs(each) <= SPEEDS[1]).all() for each in twist)
    if len(twist) != 3 or not all(fits):
        raise InvalidValue("twist", given, TWIST, "give (v_x, v_y, omega)")
    if not scene.stores_energy and any(np.any(each != 0) for each in twist):
        raise InvalidValue(
            "twist", given, "(0, 0, 0) for a scene without inertia",
            "leave the twist out, since the fence determines a quasi-static motion",
        )  # fmt: skip
    return twist


def sample_count(given: object) -> int:
    """Validate a number of samples, which includes the first and the last instant."""
    count = require_number(
        "samples", given, lambda n: SAMPLES.holds(n) and n == int(n), SAMPLES.allowed,
        "request at least the first and the last instant",
    )  # fmt: skip
    return int(count)
