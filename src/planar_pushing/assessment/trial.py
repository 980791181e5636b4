"""The runs of an assessment: one push, with whatever is varied."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.assessment.estimate import Poses, pose_change, poses
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.batch import simulate_batch
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.numbers import Array

#: Number of evenly spaced instants of a run that is compared at all times.
SAMPLES = 201
#: Runs whose ends differ by more than this part of the duration are not compared.
ENDS_TOGETHER = 0.01
#: An input is off to both sides.
SIDES = (1.0, -1.0)
#: The object's frame is the world's at time 0.
HOME = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Trial:
    """A push over a time, and the circles of the object over which poses are compared.

    Attributes
    ----------
    pusher : Pusher
    duration : float
    circles : ndarray, shape (circles, 3)
        Those of `outline_circles`.
    """

    pusher: Pusher
    duration: float
    circles: Array

    @property
    def size(self) -> float:
        """Diameter of the object about the middle of its corners; the diagonal of a box."""
        middle = self.circles[:, :2].mean(axis=0)
        reach = np.hypot(*(self.circles[:, :2] - middle).T) + self.circles[:, 2]
        return float(2.0 * reach.max())

    def run(
        self, scene: Scene, pusher: Pusher | None = None, samples: int = SAMPLES, **settings: Any
    ) -> xr.Dataset:
        """The log of a scene; only the start, the end and events with two samples."""
        return quietly(simulate)(
            scene, self.pusher if pusher is None else pusher, duration=self.duration,
            samples=samples, object_pose=HOME, **settings,
        )  # fmt: skip

    def batch(self, scene: Scene, copies: int, rtol: float) -> xr.Dataset:
        """Final states of equal runs."""
        durations = np.full(copies, self.duration)
        return quietly(simulate_batch)(
            scene, self.pusher, duration=durations, rtol=rtol, object_pose=HOME
        )

    def change(self, log: xr.Dataset, other: xr.Dataset) -> float:
        """Largest displacement between two runs; infinite if only one of them ends early."""
        ends = log.attrs["stopped_time"] - other.attrs["stopped_time"]
        if abs(ends) > ENDS_TOGETHER * self.duration:
            return np.inf
        return pose_change(log, other, self.circles)

    def end_displacement(self, log: xr.Dataset, other: xr.Dataset) -> Poses:
        """Displacement of the last pose of one run to that of another."""
        return poses(other, [-1]) - poses(log, [-1])

    def end_change(self, log: xr.Dataset, other: xr.Dataset) -> float:
        """Largest displacement between the last poses of two runs."""
        return float(self.end_displacement(log, other).reach(self.circles)[0])


def modes_of(log: xr.Dataset) -> str:
    """The contact modes of a run in their order, as words."""
    modes = log["mode"].values
    kept = modes[np.concatenate([[True], modes[1:] != modes[:-1]])]
    return " ".join(ContactMode(int(mode)).name for mode in kept if mode >= 0)


def evaluations_of(log: xr.Dataset) -> int:
    """Number of calls of the right-hand side of a run."""
    return int(log["evaluations"].values[-1, 0])
