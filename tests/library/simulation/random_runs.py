"""Random runs over time of all supports, by a fence or a finger of constant velocity, from a seed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from mechanics.degenerate import RANDOM, normal_of, random_support, symmetric_feet
from simulation.runs import run as log_of

import planar_pushing as pp

#: Steps of the time-stepping method in a run; its error is of first order in their length.
STEPS = 4000


@dataclass(frozen=True)
class RandomRun:
    """A scene and how it is pushed over time."""

    scene: Any
    velocity: tuple[float, float]
    shape: str
    duration: float
    twist: tuple[float, float, float]
    radius: float = 0.0

    def log(self, method, finer=1):
        """The log of the run by a method; steps of equal length may be so many times finer."""
        step = {"step": self.duration / STEPS / finer}
        steps = step if method == "time-stepping" else {}
        pusher = pp.Pusher(velocity=self.velocity, shape=self.shape, radius=self.radius)
        twist = {"twist": self.twist} if self.scene.stores_energy else {}
        return log_of(
            self.scene, pusher, self.duration, method=method, samples=41, **twist, **steps
        )


def random_run(seed, inertia, kind=None, shape=None):
    """A run that follows from the seed.

    Parameters
    ----------
    seed : int
    inertia : bool
        Whether the slider has inertia, its mass aside in half of the runs. It starts with a twist in half.
    kind : str, optional
        One of `mechanics.degenerate.RANDOM`, or "symmetric" for equal feet; otherwise any.
    shape : {"fence", "finger"}, optional
        Otherwise either.
    """
    random = np.random.default_rng([seed, inertia])
    kind = kind or random.choice([*RANDOM, "symmetric"])
    support = symmetric_feet(random) if kind == "symmetric" else random_support(random, kind)
    length, psi = random.uniform(0.3, 3.0), random.choice([np.pi / 2, random.uniform(0.6, 2.5)])
    slider = pp.Slider(rod_length=length, rod_angle=float(psi))
    law = random.choice([pp.Coulomb(random.uniform(0.05, 1.0)), pp.InfiniteFriction()])
    friction = pp.SupportFriction(support=support, weight=random.uniform(0.5, 2.0))
    effects = (friction, _mass(random, length, psi)) if inertia else (friction,)
    twist = tuple(random.choice([0, 1]) * random.uniform(-0.5, 0.5, 3))
    return RandomRun(
        scene=pp.Scene(slider=slider, contact=law, effects=effects),
        velocity=_velocity(random),
        shape=shape or str(random.choice(["fence", "finger"])),
        duration=random.uniform(1.0, 4.0),
        twist=twist if inertia else (0.0, 0.0, 0.0),
    )


def _mass(random, length, psi):
    """A mass at the origin, on the contact's normal, or anywhere beside."""
    n_x, n_y = normal_of(psi)
    up = random.uniform(0.0, 1.5)
    centers = [(0.0, 0.0), (up * n_x - length, up * n_y), 0.3 * random.normal(size=2)]
    center = tuple(float(x) for x in centers[random.integers(3)])
    ratio = random.uniform(0.3, 1.5)
    return pp.Inertia(mass=random.uniform(0.2, 3.0), gyration_radius=ratio, center=center)


def _velocity(random):
    """Mostly into the slider, some of them exactly along the normal."""
    angle = random.choice([np.pi / 2, random.uniform(0.2, 2.9), random.uniform(-3.0, 3.0)])
    speed = 10 ** random.uniform(-1, 0.3)
    return float(speed * np.cos(angle)), float(speed * np.sin(angle))
