"""Every consistent solution of one pushing problem, and the outcome (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.candidates import Candidates, candidates, contact_motion
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.errors import InvalidValue, require_number
from planar_pushing.mechanics.planar import Array, direction, motion_center
from planar_pushing.mechanics.scene import Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """One consistent solution.

    Attributes
    ----------
    mode : ContactMode
    force : ndarray, shape (2,)
        Force of the pusher on the slider; parts below the smallest double are 0, as in the motions.
    contact_motion : ndarray, shape (2,)
        Velocity or initial acceleration of the slider at the contact.
    twist : ndarray, shape (3,)
        (v_x, v_y, omega) at the ring centre.
    spin_ratio : float
        k = R omega / v; 0 at rest.
    center : ndarray, shape (2,)
        Motion centre relative to the contact; infinite for a translation and at rest.
    """

    mode: ContactMode
    force: Array
    contact_motion: Array
    twist: Array
    spin_ratio: float
    center: Array

    @property
    def adhesive(self) -> bool:
        """Whether the fence pulls on the slider, as only a perfectly rough contact can."""
        return bool(self.force[1] < -RESOLUTION * np.hypot(*self.force))


@dataclass(frozen=True, slots=True)
class Solutions:
    """All consistent solutions of one pushing problem, in the order of `ContactMode`."""

    solutions: tuple[Solution, ...]

    @property
    def outcome(self) -> Outcome:
        return Outcome(min(len(self.solutions), 2))

    @property
    def modes(self) -> tuple[ContactMode, ...]:
        return tuple(solution.mode for solution in self.solutions)

    def __iter__(self) -> Iterator[Solution]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)


def _solution(scene: Scene, found: Candidates, branch: int, magnitude: float) -> Solution:
    slider, twist = scene.slider, found.twist[branch]
    ratio, angle = float(found.spin_ratio[branch]), float(found.force_angle[branch])
    with np.errstate(over="ignore"):
        force, motion = found.force_unit * found.force[branch], magnitude * twist
        rates = motion / np.array([1.0, 1.0, slider.radius])
    if not np.all(np.isfinite([*force, *rates])):
        raise InvalidValue(
            "pusher_magnitude", magnitude, "one whose force and motion are doubles",
            "choose other units of motion, length, mass or force",
        )  # fmt: skip
    return Solution(
        mode=found.mode,
        force=force,
        contact_motion=magnitude * contact_motion(scene, twist),
        twist=rates,
        spin_ratio=ratio,
        center=motion_center(angle, ratio, slider.rod_length, slider.rod_angle, slider.radius),
    )


def solve(scene: Scene, pusher_angle: float, pusher_magnitude: float = 1.0) -> Solutions:
    """Every solution of the pushing problem from rest that is consistent (Sec. 2).

    Parameters
    ----------
    scene : Scene
    pusher_angle : float
        Angle of the pusher's velocity or initial acceleration, radians.
    pusher_magnitude : float
        Its magnitude, >= 0. It matters to the modes only where the scene has friction and inertia.

    Returns
    -------
    Solutions

    Raises
    ------
    InvalidValue
        Where the angle is not finite, the magnitude negative or not finite, or a force or a motion
        of the solution beyond the doubles.
    """
    angle = require_number(
        "pusher_angle", pusher_angle, np.isfinite, "a finite number of radians", "give one angle"
    )
    magnitude = require_number(
        "pusher_magnitude", pusher_magnitude, lambda x: 0 <= x < np.inf,
        "a finite number >= 0", "turn the pusher around by its angle, not by a sign",
    )  # fmt: skip
    found = candidates(scene, direction(angle), magnitude)
    return Solutions(
        tuple(
            _solution(scene, each, int(branch), magnitude)
            for each in found
            for branch in np.nonzero(each.consistent)[0]
        )
    )
