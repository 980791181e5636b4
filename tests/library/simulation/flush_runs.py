"""Random runs over time of outlines whose sides come to lie on a fence, from a seed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from simulation.runs import run

import planar_pushing as pp

SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
TRIANGLE = ((-1.0, -0.6), (1.1, -0.5), (0.1, 1.2))
SLAB = ((-1.5, -0.2), (1.5, -0.2), (1.5, 0.2), (-1.5, 0.2))
LEANING = ((0.0, 0.0), (1.0, 0.0), (3.0, 2.0), (2.0, 2.0))
#: Its mouth is between two sides that lie on the fence together.
HORSESHOE = (
    (-1.0, -1.0), (-0.6, -1.0), (-0.6, 0.4), (0.6, 0.4), (0.6, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0),
)  # fmt: skip
OUTLINES = (SQUARE, TRIANGLE, SLAB, LEANING, HORSESHOE)


def polygon(count, radius=1.0):
    """A regular polygon."""
    angles = 2 * np.pi * (np.arange(count) + 0.5) / count - np.pi / 2
    return tuple(zip(radius * np.cos(angles), radius * np.sin(angles), strict=True))


def rotated(places, angle):
    """Places turned about the origin."""
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(places) @ np.array([[c, s], [-s, c]])


def heights(log, outline):
    """Heights of the corners over the fence from the object's pose, shape (instants, corners)."""
    spin = np.exp(1j * np.deg2rad(log.object_angle.values))
    corners = log.object_position.values @ (1, 1j)
    corners = corners[:, None] + spin[:, None] * (np.asarray(outline) @ (1, 1j))
    return corners.imag - log.pusher_position.values[:, 1:]


def tilted(outline, tilt, effects, law, corner=None):
    """A scene of an object that is turned by an angle, with its lowest corner, or a point, on the fence."""
    point = outline[int(np.argmin(rotated(outline, tilt)[:, 1]))] if corner is None else corner
    normal = rotated([(0.0, 1.0)], -tilt)[0]
    return pp.scene_at(point, normal, effects=effects, contact=law, outline=outline)


@dataclass(frozen=True)
class FlushRun:
    """An object, turned by an angle at the start, and how a fence pushes it."""

    outline: Any
    tilt: float
    effects: Any
    law: Any
    velocity: Any
    duration: float
    twist: tuple[float, float, float] = (0.0, 0.0, 0.0)
    gap: float = 0.0
    policy: str = "keep-contact"

    @property
    def scene(self):
        return tilted(self.outline, self.tilt, self.effects, self.law)

    def log(self, method="event-driven", steps=1000, samples=41, **options):
        step = {"step": self.duration / steps} if method == "time-stepping" else {}
        scene = self.scene
        given = {"twist": self.twist} if scene.stores_energy else {}
        return run(
            scene, self.velocity, self.duration, method=method, samples=samples, gap=self.gap,
            on_ambiguity=self.policy, object_pose=(0, 0, self.tilt), **given | step | options,
        )  # fmt: skip


def random_support(random, outline):
    """The whole outline, feet in its corners, a ring or a disc within, or a segment."""
    corners = np.asarray(outline)
    center = corners.mean(axis=0)
    kind = random.integers(5)
    if kind == 0:
        return pp.Polygon(outline)
    if kind == 1:
        weights = (
            random.uniform(0.2, 1.0, len(corners))
            if random.random() < 0.5
            else np.ones(len(corners))
        )
        return pp.Points(tuple(map(tuple, 0.9 * (corners - center) + center)), weights)
    if kind == 2:
        return pp.Ring(0.4, tuple(center))
    if kind == 3:
        return pp.Disc(0.5, tuple(center))
    return pp.Segment(tuple(center - np.array((0.3, 0.1))), tuple(center + np.array((0.4, 0.2))))


def random_velocity(random, duration):
    """Constant, waypoints, or a direction that turns."""
    kind = random.integers(3)
    speed = random.uniform(0.5, 1.5)
    if kind == 0:
        angle = random.uniform(0.6, 2.5)
        return float(speed * np.cos(angle)), float(speed * np.sin(angle))
    if kind == 1:
        angles = [random.uniform(0.4, 2.7), random.uniform(0.1, 3.0), random.uniform(0.4, 2.7)]
        return [
            (float(i * duration / 3), (float(speed * np.cos(a)), float(speed * np.sin(a))))
            for i, a in enumerate(angles)
        ]
    first, rate = random.uniform(0.8, 2.3), random.uniform(-1.0, 1.0)
    return lambda t: (
        float(speed * np.cos(first + rate * t)),
        float(speed * np.sin(first + rate * t)),
    )


def random_effects(random, outline, kind):
    center = tuple(np.asarray(outline).mean(axis=0))
    friction = pp.SupportFriction(
        support=random_support(random, outline), weight=random.uniform(0.5, 2)
    )
    offset = random.choice([0, 1]) * random.uniform(-0.3, 0.3, 2)
    aside = tuple((np.asarray(center) + offset).tolist())
    mass = pp.Inertia(
        mass=random.uniform(0.3, 2), gyration_radius=random.uniform(0.3, 1.2), center=aside
    )
    film = pp.Viscous(support=pp.Disc(0.6, center), coefficient=random.uniform(0.2, 1))
    angle = random.uniform(0, 2 * np.pi)
    load = pp.Load(force=(0.2 * np.cos(angle), 0.2 * np.sin(angle)), center=aside)
    return {
        "friction": (friction,), "both": (friction, mass), "inertia": (mass,), "viscous": (friction, film),
        "load": (friction, load), "all": (friction, mass, film, load), "film": (film,),
        "heavy": (mass, film),
    }[kind]  # fmt: skip


KINDS = ("friction", "both", "inertia", "viscous", "load", "all", "film", "heavy")


def random_flush_run(seed, kind=None):
    """A run that follows from the seed."""
    random = np.random.default_rng(seed)
    kind = kind or KINDS[seed % len(KINDS)]
    outline = OUTLINES[random.integers(len(OUTLINES))]
    if random.random() < 0.25:
        outline = polygon(int(random.integers(5, 9)))
    laws = [pp.Coulomb(0.0), pp.Coulomb(random.uniform(0.1, 1.0)), pp.Coulomb(random.uniform(0.1, 1.0)),
            pp.InfiniteFriction(), pp.InfiniteFriction(at_zero_normal="none")]  # fmt: skip
    law = laws[random.integers(len(laws))]
    duration = random.uniform(2.0, 5.0)
    tilt = random.uniform(0, 2 * np.pi)
    if random.random() < 0.2:  # a side on the fence from the start
        corners = np.asarray(outline)
        k = random.integers(len(corners))
        d = np.roll(corners, -1, axis=0)[k] - corners[k]
        tilt = -np.arctan2(d[1], d[0])
    velocity = random_velocity(random, duration)
    effects = random_effects(random, outline, kind)
    massive = kind in ("inertia", "both", "all", "heavy")
    twist = (
        tuple(random.choice([0, 1]) * random.uniform(-0.3, 0.3, 3)) if massive else (0.0, 0.0, 0.0)
    )
    gap = float(random.choice([0, 0, 0.1])) if massive else 0.0
    return FlushRun(outline, float(tilt), effects, law, velocity, float(duration), twist, gap)
