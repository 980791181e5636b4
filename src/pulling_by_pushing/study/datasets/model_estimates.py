"""Estimates of what leaving out an effect changes, and what it does change, in random pushes of boxes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.assessment.estimate import (
    estimate_pose_change,
    jump_times,
    outline_circles,
    pose_change,
)
from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.effects.support_friction import weight
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Disc, Points, Polygon, Ring
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.simulation.fields import FIELDS, Arrays, arrays
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.runs import Run
from pulling_by_pushing.study.datasets.model_errors import GRAVITY
from pulling_by_pushing.study.model import ModelEstimates

#: Supports of a box with these sides: a small disc, a ring, its base, and feet near its corners.
SUPPORTS: Mapping[str, Any] = {
    "disc": lambda x, y: Disc(0.08 * min(x, y)),
    "ring": lambda x, y: Ring(0.4 * min(x, y)),
    "base": Polygon.rectangle,
    "feet": lambda x, y: Points([(0.45 * x * i, 0.45 * y * j) for i in (-1, 1) for j in (-1, 1)]),
}
#: Effects beside friction that are left out.
EFFECTS = ("inertia", "viscous", "load")
#: Instants of a run: shares of friction are differences between them.
SAMPLES = 201
#: Significant digits of random numbers, so that they are the same on each machine.
DIGITS = 4
#: Variables of a log that are read; a whole log would take as long as its run.
READ = {"time", "rod_angle", "twist", "object_position", "object_angle"}
#: Duration of a run after the pusher has stopped, as a part of the time in which the box comes to rest.
REST = 1.6


@dataclass(frozen=True, slots=True, kw_only=True)
class Push:
    """A random push of a box in SI units; angles in degrees.

    A finger pushes the lower side at a part of half its length from the middle, or a fence the lower left
    corner, with its normal at a part of the right angle there. `viscous_share` is that of the friction at
    the pusher's speed, `load_share` that of a constant force.
    """

    length: float
    width: float
    mass: float
    support_friction_coefficient: float
    friction_coefficient: float
    speed: float
    distance: float
    support: str
    is_at_corner: bool
    place: float
    angle: float
    stops: bool
    viscous_share: float
    load_share: float
    load_angle: float


def random_push(chooser: np.random.Generator) -> Push:
    """Draw a push: boxes of 5 to 30 cm at 1 to 50 cm/s, of which half stop."""

    def uniform(low: float, high: float) -> float:
        return float(f"{chooser.uniform(low, high):.{DIGITS}g}")

    def logarithmic(low: float, high: float) -> float:
        return float(f"{low * (high / low) ** chooser.uniform():.{DIGITS}g}")

    is_at_corner = bool(chooser.random() < 0.5)
    return Push(
        length=uniform(0.05, 0.3),
        width=uniform(0.05, 0.3),
        mass=logarithmic(0.2, 3.0),
        support_friction_coefficient=uniform(0.1, 0.6),
        friction_coefficient=uniform(0.1, 0.8),
        speed=logarithmic(0.01, 0.5),
        distance=uniform(0.02, 0.1),
        support=str(chooser.choice(list(SUPPORTS))),
        is_at_corner=is_at_corner,
        place=uniform(0.15, 0.85) if is_at_corner else uniform(-0.8, 0.8),
        angle=uniform(40.0, 140.0),
        stops=bool(chooser.random() < 0.5),
        viscous_share=logarithmic(1e-4, 0.3),
        load_share=logarithmic(1e-4, 0.3),
        load_angle=uniform(0.0, 360.0),
    )


def model_estimates(part: ModelEstimates) -> xr.Dataset:
    """Build the estimates, and the errors of runs without an effect, for the random pushes of a study."""
    chooser = np.random.default_rng(part.seed)
    pushes = [random_push(chooser) for _ in range(part.pushes)]
    rows = np.array(list(map(_compare, pushes)))
    names = "pose_error", "estimate", "stopping_length", "force_share", "torque_share"
    labels = "support", "speed", "is_at_corner"
    return xr.Dataset(
        {name: (("push", "effect"), rows[..., i]) for i, name in enumerate(names)},
        {"effect": list(EFFECTS)}
        | {name: ("push", [getattr(push, name) for push in pushes]) for name in labels},
    )


def effects_of(push: Push) -> tuple[Effect, ...]:
    """Friction on the support, and the effects beside it, as in `EFFECTS`; the mass is uniform."""
    sides = push.length, push.width
    support = SUPPORTS[push.support](*sides)
    force = float(weight(push.mass, push.support_friction_coefficient, GRAVITY))
    angle, load = math.radians(push.load_angle), push.load_share * force
    gyration = math.hypot(*sides) / math.sqrt(12.0)
    return (
        SupportFriction(support=support, weight=force),
        Inertia(mass=push.mass, gyration_radius=gyration),
        Viscous(support=support, coefficient=push.viscous_share * force / push.speed),
        Load(force=(load * math.cos(angle), load * math.sin(angle)), center=(0.0, 0.0)),
    )


def scenes_of(push: Push) -> list[Scene]:
    """The box at its contact under friction alone, and with each of the other effects."""
    friction, *others = effects_of(push)
    x, y, normal = push.place * push.length / 2.0, -push.width / 2.0, None
    if push.is_at_corner:
        turn = math.radians(90.0 * push.place)
        x, normal = -push.length / 2.0, (math.cos(turn), math.sin(turn))
    outline = Polygon.rectangle(push.length, push.width)
    contact = Coulomb(push.friction_coefficient)
    return [
        scene_at((x, y), normal, effects=effects, contact=contact, outline=outline)
        for effects in [(friction,), *((friction, other) for other in others)]
    ]


def motion_of(push: Push) -> tuple[Pusher, float]:
    """The pusher, and the duration of the run: until it has moved over the distance, or the box rests."""
    angle, duration = math.radians(push.angle), push.distance / push.speed
    velocity = push.speed * math.cos(angle), push.speed * math.sin(angle)
    pieces: Any = [(0.0, velocity)]
    shape: Any = "fence" if push.is_at_corner else "finger"
    if push.stops:
        pieces.append((duration, (0.0, 0.0)))
        duration += REST * push.speed / (push.support_friction_coefficient * GRAVITY)
    return Pusher(velocity=pieces, shape=shape), duration


def _compare(push: Push) -> list[tuple[float, ...]]:
    """For each effect the error without it, and its estimate, stopping length and shares of friction."""
    pusher, duration = motion_of(push)
    friction, *others = scenes_of(push)
    log, *logs = (_log(scene, pusher, duration) for scene in (friction, *others))
    circles, jumps = outline_circles(friction), jump_times(pusher)
    rows: list[tuple[float, ...]] = []
    for scene, other in zip(others, logs, strict=True):
        estimate = estimate_pose_change(log, friction, scene.effects[1], circles, jumps)
        shares = estimate.force_share, estimate.torque_share
        rows.append((pose_change(log, other, circles), estimate.total, estimate.stopping, *shares))
    return rows


def _log(scene: Scene, pusher: Pusher, duration: float) -> Arrays:
    """The variables `READ` of the log of `simulate`; the pose of the box is the world's at the start.

    A box has no inner corner, on which `simulate` would use another kind of run.
    """
    problem = Problem(scene=scene, pusher=pusher, duration=duration, object_pose=(0.0, 0.0, 0.0))
    rows = np.concatenate(list(Run(problem, np.linspace(0.0, duration, SAMPLES))))
    return arrays(rows, problem, [field for field in FIELDS if field.name in READ])
