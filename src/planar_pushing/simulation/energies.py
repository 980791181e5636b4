"""The effects of a scene as the time-stepping integrator sees them, and where the energy goes."""

from __future__ import annotations

import math

from planar_pushing.mechanics.response import Effects, of_degree
from planar_pushing.simulation.incremental import REST, Trial, Twist
from planar_pushing.simulation.pusher import Vector
from planar_pushing.simulation.support import Support


class Energies:
    """Work of the fence since the start, and the energies that it became.

    Work equals the change of kinetic energy plus what is dissipated, to rounding.

    Parameters
    ----------
    effects : effects of degree 1 or 2, lengths scaled by the radius

    Attributes
    ----------
    support : Support
        The effects of degree 1.
    mass, moment : float
        Of the effects of degree 2, the moment over the radius squared.
    work, lost : float
        Work of the fence, and energy dissipated at the contact.
    dissipated : list of float
        By each effect.
    """

    def __init__(self, effects: Effects) -> None:
        self.friction = [i for i, effect in enumerate(effects) if effect.degree == 1]
        self.support = Support(of_degree(effects, 1))
        parts = [effect.profile(1.0) for effect in of_degree(effects, 2)]
        self.mass = math.fsum(float(mass) for mass, _ in parts)
        self.moment = math.fsum(float(moment) for _, moment in parts)
        self.work, self.lost, self.dissipated = 0.0, 0.0, [0.0] * len(effects)

    def kinetic(self, twist: Twist) -> float:
        """Kinetic energy of a twist; 0 without inertia."""
        linear = self.mass * (twist[0] ** 2 + twist[1] ** 2)
        return (linear + self.moment * twist[2] ** 2) / 2

    def account(self, trial: Trial, before: Twist, moved: Vector, h: float) -> None:
        """Enter a step of length h, in which the fence moved by `moved`.

        Friction dissipates its potential at the end of the step. What is left belongs to the contact;
        in flight it is the scheme's own loss, which goes to friction.
        """
        work = (trial.impulse[0] * moved[0] + trial.impulse[1] * moved[1]) / h
        left = work + self.kinetic(before) - self.kinetic(trial.twist)
        flight = trial.impulse == (0.0, 0.0)
        powers = self._powers(before if flight and trial.twist == REST else trial.twist)
        total = h * math.fsum(powers)
        share = left / total if flight and total > 0.0 else 1.0
        for index, power in zip(self.friction, powers, strict=True):
            self.dissipated[index] += share * h * power
        self.work += work
        self.lost += 0.0 if flight else left - total

    def _powers(self, twist: Twist) -> tuple[float, ...]:
        if not self.friction or twist == REST:
            return (0.0,) * len(self.friction)
        return self.support.powers(math.hypot(twist[0], twist[1]), twist[2])

    def evaluations(self, inertia: int) -> tuple[int, ...]:
        """Evaluations of each effect, given those of the inertia."""
        made = self.support.evaluations
        return tuple(made if i in self.friction else inertia for i in range(len(self.dissipated)))
