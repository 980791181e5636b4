"""Random pushes of boxes in SI units: four supports, a finger on a side or a fence at a corner."""

from dataclasses import dataclass

import numpy as np

import planar_pushing as pp
from planar_pushing.simulation.early_end import quietly

GRAVITY = 9.80665
EFFECTS = ("inertia", "viscous", "load")
quiet = quietly(pp.simulate)


@dataclass(frozen=True)
class RandomPush:
    """A push of a box under friction, and effects that can be left out, by their names."""

    scene: pp.Scene
    pusher: pp.Pusher
    duration: float
    corners: np.ndarray
    others: dict

    def log(self, scene):
        return quiet(scene, self.pusher, duration=self.duration, samples=201, object_pose=(0, 0, 0))


def random_push(rng):
    """Draw a push: half of the pushers stop at the end, and the box coasts."""
    a, b = rng.uniform(0.05, 0.3, 2)
    mass, speed = log_uniform(rng, 0.2, 3.0), log_uniform(rng, 0.01, 0.5)
    table, law = rng.uniform(0.1, 0.6), pp.Coulomb(rng.uniform(0.1, 0.8))
    weight, box = float(pp.weight(mass, table)), pp.Polygon.rectangle(a, b)
    support = supports(a, b)[rng.integers(4)]
    friction = pp.SupportFriction(support=support, weight=weight)
    if rng.random() < 0.5:
        shape, point, normal = "finger", (rng.uniform(-0.4, 0.4) * a, -b / 2), None
    else:
        angle = np.deg2rad(90 * rng.uniform(0.15, 0.85))
        shape, point, normal = "fence", (-a / 2, -b / 2), (np.cos(angle), np.sin(angle))
    scene = pp.scene_at(point, normal, effects=(friction,), contact=law, outline=box)
    angle = np.deg2rad(90 + rng.uniform(-50, 50))
    velocity, time = (
        (speed * np.cos(angle), speed * np.sin(angle)),
        rng.uniform(0.02, 0.1) / speed,
    )
    pieces = [(0.0, velocity)]
    duration = time
    if rng.random() < 0.5:
        pieces.append((time, (0.0, 0.0)))
        duration += 1.6 * speed / (table * GRAVITY)
    turn, size = rng.uniform(0, 2 * np.pi), log_uniform(rng, 1e-4, 0.3) * weight
    others = {
        "inertia": pp.Inertia(mass=mass, gyration_radius=float(np.hypot(a, b) / np.sqrt(12))),
        "viscous": pp.Viscous(
            support=support, coefficient=log_uniform(rng, 1e-4, 0.3) * weight / speed
        ),
        "load": pp.Load(force=(size * np.cos(turn), size * np.sin(turn)), center=(0.0, 0.0)),
    }
    corners = np.array([(x, y) for x in (-a / 2, a / 2) for y in (-b / 2, b / 2)])
    return RandomPush(scene, pp.Pusher(velocity=pieces, shape=shape), duration, corners, others)


def log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def supports(a, b):
    """The whole base, four feet, a ring and a small disc."""
    feet = [(0.45 * x * a, 0.45 * y * b) for x in (-1, 1) for y in (-1, 1)]
    short = min(a, b)
    return (
        pp.Polygon.rectangle(a, b), pp.Points(feet), pp.Ring(0.4 * short), pp.Disc(0.08 * short)
    )  # fmt: skip


def corner_change(log, other, corners):
    """Largest displacement of a corner at the common instants of two logs."""
    times = np.intersect1d(log.time.values, other.time.values)
    places = []
    for run in (log, other):
        # The last entry of each instant.
        rows = np.searchsorted(run.time.values, times, side="right") - 1
        angle = np.deg2rad(run.object_angle.values[rows])[:, None]
        x, y = corners.T
        turned = [
            x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle),
        ]  # fmt: skip
        places.append(run.object_position.values[rows][:, None] + np.stack(turned, axis=-1))
    return float(np.linalg.norm(places[1] - places[0], axis=-1).max())
