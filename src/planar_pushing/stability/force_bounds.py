"""The contact forces that are possible for some pressure with a given center, from inside and from outside.

At each rotation the largest component of the force is a linear program, in which the torque about the
contact vanishes. Its multipliers at the ends of an interval of rotations prove a bound for the whole
interval, by `certificates`; intervals are halved until the largest bound is close to an attained force.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import count

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.stability.base_region import CLOSE, Base
from planar_pushing.stability.certificates import Bound, proved_maximum
from planar_pushing.stability.linear_program import (
    Candidates,
    Pressure,
    largest,
    velocities,
)
from planar_pushing.stability.rotation_bounds import End, balance_rotation, torque

#: Difference between a proved and an attained force at which the halving ends, per unit weight.
ACCURACY = 5e-4
#: Maximum number of intervals of rotations for a direction, and number at first.
INTERVALS, FIRST = 200, 4
#: Width of the smallest interval of rotations, and speed of a point at rest.
NARROWEST, RESTING = 1e-9, 1e-12
#: Accuracy, per unit weight, with which a force is compared with an edge of the friction cone.
EDGE = 1e-7
#: Maximum number of directions in which an extreme angle is sought, and rounding error of a unit force.
TRIALS, ROUNDING = 8, 1e-15
#: The negative bound of an interval, a number that orders equal ones, and the interval.
Interval = tuple[float, int, Bound]


@dataclass(eq=False)
class Forces:
    """Forces between two rotations eta: those attained are kept, to start from in other directions.

    Parameters
    ----------
    candidates : Candidates
    ends : tuple of two End
        The smallest and the largest rotation.
    """

    candidates: Candidates
    ends: tuple[End, End]
    attained: list[Array] = field(default_factory=list)
    order: Iterator[int] = field(default_factory=count)

    @property
    def base(self) -> Base:
        """The base."""
        return self.candidates.base

    @property
    def unique(self) -> Array | None:
        """The only possible force where the center of pressure is the contact.

        The power of the force is the mean speed, which is at least the speed of the center of pressure, 1.
        """
        return self.base.motion if np.hypot(*self.base.center) <= CLOSE else None

    def attained_maximum(self, direction: Array) -> float:
        """Largest component of an attained force."""
        if self.unique is not None:
            return float(self.unique @ direction)
        return max((float(force @ direction) for force in self.attained), default=-math.inf)

    def keeps_within(self, outward: Array, limit: float) -> bool:
        """Whether the component of the force along a direction is proved to be at most a small number."""
        return self.proved_maximum(outward, EDGE, decides=True) <= limit

    def extreme_angle(self, side: int) -> tuple[float, float]:
        """Attained and proved largest angle from the contact's motion to the left (side 1) or right (-1).

        The power of the force, the mean speed of the pressure, is positive: the angle is below 90 degrees.
        """
        u, across = self.base.motion, side * self.base.path
        if self.unique is not None:
            return 0.0, 0.0
        min_power = -self.proved_maximum(-u)
        angle = max(math.atan2(force @ across, force @ u) for force in self.attained)
        for _ in range(TRIALS):
            outward = math.cos(angle) * across - math.sin(angle) * u
            over = self.proved_maximum(outward)
            best = max(math.atan2(force @ across, force @ u) for force in self.attained)
            if best - angle <= ACCURACY:
                break
            angle = best
        beyond = (
            math.asin(min(max(over, 0.0) / min_power, 1.0)) if min_power > 0.0 else math.pi / 2.0
        )
        return best, min(angle + beyond, math.pi / 2.0)

    def proved_maximum(
        self, direction: Array, accuracy: float = ACCURACY, decides: bool = False
    ) -> float:
        """Upper bound of the component of the force along a unit vector; attained forces come close to it.

        Parameters
        ----------
        direction : ndarray, shape (2,)
        accuracy : float, optional
            Difference from an attained force, per unit weight, that is small enough.
        decides : bool, optional
            Whether the sign of the maximum is enough, unless it is smaller than the accuracy.
        """
        if self.unique is not None:
            return float(self.unique @ direction)
        # Programs have solutions between the attained ends; the outer intervals extend to the proved ones.
        # The largest force may jump where the center of rotation arrives at a curve.
        first, last = self.ends
        jumps = self.base.arrivals()
        jumps = jumps[(jumps > first.attained) & (jumps < last.attained)]
        nodes = np.linspace(first.attained, last.attained, FIRST + 1)
        nodes = np.sort(np.concatenate([nodes, jumps]))
        rows = [self._multiplier(float(eta), direction, accuracy) for eta in nodes]
        nodes[0], nodes[-1] = first.proved, last.proved
        queue: list[Interval] = []
        for low, high, m, n in zip(nodes[:-1], nodes[1:], rows[:-1], rows[1:], strict=True):
            self._add(queue, Bound(float(low), float(high), m, n, direction), accuracy)
        for _ in range(INTERVALS):
            most, bound, attained = -queue[0][0], queue[0][2], self.attained_maximum(direction)
            if most <= attained + accuracy or bound.high - bound.low < NARROWEST:
                break
            if decides and (most <= -accuracy or attained > accuracy):
                break
            heapq.heappop(queue)
            middle = (bound.low + bound.high) / 2.0
            row = self._multiplier(middle, direction, accuracy)
            self._add(queue, replace(bound, high=middle, last=row), accuracy)
            self._add(queue, replace(bound, low=middle, first=row), accuracy)
        return -queue[0][0]

    def _add(self, queue: list[Interval], bound: Bound, accuracy: float) -> None:
        """Put an interval into the queue, after the larger bounds."""
        most = proved_maximum(self.base, bound, accuracy / 4.0)
        enough = max(self.attained_maximum(bound.direction), bound.value(self.base.center))
        if most > enough + accuracy:
            # Multipliers that are not unique may differ too much; one alone may do.
            for row in (bound.first, bound.last):
                alone = replace(bound, first=row, last=row)
                most = min(most, proved_maximum(self.base, alone, accuracy / 4.0))
        heapq.heappush(queue, (-most, next(self.order), bound))

    def _multiplier(self, eta: float, direction: Array, accuracy: float) -> Array:
        optimum = largest(self.candidates, eta, direction, None, accuracy / 50.0)
        if optimum.exact:
            self.attained += forces_of(self.base, optimum.pressure, direction)
        return optimum.multiplier


def forces_of(base: Base, pressure: Pressure, direction: Array) -> list[Array]:
    """The force of a pressure in balance; extreme ones along a direction if a point is at rest."""
    eta = balance_rotation(base, pressure, 1)
    v = velocities(base, eta, pressure.points)
    speed = np.hypot(v[:, 0], v[:, 1])
    rests = speed <= RESTING
    share = float(pressure.shares[rests].sum())
    moving = Pressure(pressure.points[~rests], pressure.shares[~rests])
    force = moving.shares @ (v[~rests] / speed[~rests, None])
    if not share:
        return [force]
    # The force of the point at rest balances the torque of the others; across it is free within a disc.
    arm = 1.0 / math.tan(eta)
    along = torque(base, moving, eta) / (share * arm) if arm else 0.0
    if abs(along) > 1.0:
        return []
    across = math.sqrt(1.0 - along**2)
    return [
        force + share * (along * base.motion + side * across * base.path) for side in (-1.0, 1.0)
    ]
