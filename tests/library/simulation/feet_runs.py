"""Runs with inertia, from a seed: feet by their layout and the pusher's motion, and boxes in SI units."""

from __future__ import annotations

import math
import multiprocessing
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import planar_pushing as pp

#: Newtons a kilogram.
GRAVITY = 9.80665
#: Gap of a slider that meets no pusher, in units of its size.
FAR = 50.0


@dataclass(frozen=True, kw_only=True)
class DrawnRun:
    """A scene, how it is pushed over time, and its length scale."""

    scene: Any
    pusher: Any
    duration: float
    size: float
    options: dict[str, Any] = field(default_factory=dict)

    def log(self, **options):
        """The log of the run."""
        given = {"samples": 5, "duration": self.duration} | self.options | options
        return pp.simulate(self.scene, self.pusher, **given)

    @property
    def weight(self):
        """Largest friction force of the support."""
        frictions = [each for each in self.scene.effects if isinstance(each, pp.SupportFriction)]
        return sum(float(np.max(each.weight)) for each in frictions)


@dataclass(frozen=True, kw_only=True)
class Body:
    """Scales of a slider on feet: in SI units, or all of order one."""

    size: float
    mass: float
    weight: float
    speed: float

    @property
    def time(self):
        """Time in which the pusher moves by the size."""
        return self.size / self.speed


def draw_body(random):
    """A body of 5 to 20 cm in SI units, or one of size and weight 1."""
    if random.random() < 0.5:
        return Body(size=1.0, mass=10 ** random.uniform(-1, 0.5), weight=1.0,
                    speed=10 ** random.uniform(-1, 0.3))  # fmt: skip
    mass = random.uniform(0.3, 3.0)
    return Body(size=random.uniform(0.05, 0.2), mass=mass, weight=random.uniform(0.2, 0.6) * mass * GRAVITY,
                speed=random.uniform(0.02, 0.4))  # fmt: skip


# --- Layouts of feet, of size 1 ------------------------------------------------------------------


def tripod(random):
    """Three equal feet on a circle, one of them often ahead or behind."""
    start = random.choice([0.0, math.pi, random.uniform(0.0, 2 * math.pi)])
    angles = start + np.array([0.0, 2 * math.pi / 3, -2 * math.pi / 3])
    return np.column_stack([np.cos(angles), np.sin(angles)]), np.ones(3)


def table(random):
    """Four equal feet at the corners of a rectangle, or of a square."""
    height = random.choice([1.0, random.uniform(0.3, 1.0)])
    return np.array([(1, height), (-1, height), (-1, -height), (1, -height)], float), np.ones(4)


def two_feet(random):
    angle = random.choice([0.0, math.pi / 2, random.uniform(0.0, math.pi)])
    end = np.array([math.cos(angle), math.sin(angle)])
    return np.array([end, -random.uniform(0.3, 1.0) * end]), random.choice(
        [np.ones(2), random.uniform(0.3, 2.0, 2)]
    )


def collinear(random):
    """Three feet on one line, which often goes through the center, and then often through the contact."""
    angle = random.choice([0.0, random.uniform(0.0, math.pi)])
    along, aside = (
        np.array([math.cos(angle), math.sin(angle)]),
        random.choice([0.0, random.uniform(-0.5, 0.5)]),
    )
    places = np.multiply.outer(random.uniform(-1.0, 1.0, 3), along) + aside * along[::-1] * (-1, 1)
    return places, random.choice([np.ones(3), random.uniform(0.3, 2.0, 3)])


def scattered(random):
    count = int(random.integers(3, 6))
    return random.uniform(-1.0, 1.0, (count, 2)), random.uniform(0.3, 2.0, count)


def many(random):
    count = int(random.choice([8, 20]))
    return random.uniform(-1.0, 1.0, (count, 2)), random.uniform(0.3, 2.0, count)


LAYOUTS = {each.__name__: each for each in (tripod, table, two_feet, collinear, scattered, many)}


# --- Motions of the pusher -----------------------------------------------------------------------


def heading(random, body, low=0.6, high=2.5):
    angle = random.choice([math.pi / 2, random.uniform(low, high)], p=[0.15, 0.85])
    return body.speed * math.cos(angle), body.speed * math.sin(angle)


def constant(random, body):
    return {"velocity": heading(random, body)}, 1.8 * body.time


def pieces(random, body):
    times = [0.0, *np.sort(random.uniform(0.2, 1.6, 3)) * body.time]
    return {"velocity": [(float(t), heading(random, body)) for t in times]}, 1.8 * body.time


def pause(random, body):
    velocities = heading(random, body), (0.0, 0.0), heading(random, body)
    times = (0.0, 0.6 * body.time, 1.2 * body.time)
    return {"velocity": [*zip(times, velocities, strict=True)]}, 1.8 * body.time


def retreat(random, body):
    """Leaves, and returns in half of the runs."""
    back = (random.uniform(-0.3, 0.3) * body.speed, -body.speed)
    given = [(0.0, heading(random, body)), (0.6 * body.time, back)]
    if random.random() < 0.5:
        given.append((0.9 * body.time, heading(random, body)))
    return {"velocity": given}, 1.8 * body.time


def sines(random, body):
    """Leaves and returns, mostly; smooth."""
    a, b, c, d = random.uniform(0.0, 1.0, 4)
    speed, rate = body.speed, random.uniform(1.0, 6.0) / body.time

    def velocity(t):
        along = 1.5 * b * math.sin(rate * t + 2 * math.pi * a)
        return speed * along, 0.7 * speed * (c + math.sin(rate * (0.5 + d) * t + 1.0))

    return {"velocity": velocity}, 2.5 * body.time


def free(random, body):
    """Slides to rest without a pusher."""
    twist = body.speed * random.normal(size=3) / (1.0, 1.0, body.size)
    if random.random() < 0.3:
        twist[random.integers(3)] = 0.0
    speed = math.hypot(twist[0], twist[1], twist[2] * body.size)
    still = {"velocity": (0.0, 0.0), "twist": tuple(map(float, twist)), "gap": FAR * body.size}
    return still, 6 * speed * body.mass / body.weight + 0.01 * body.time


def thrown(random, body):
    """Slides onto a pusher that rests or advances."""
    twist = body.speed * random.uniform(-1.0, 1.0, 3) / (1.0, 1.0, body.size)
    twist[1] = -abs(twist[1]) - 0.3 * body.speed
    distance = 0.1 * min(body.size, body.mass * body.speed**2 / body.weight)
    velocity = (0.0, 0.0) if random.random() < 0.5 else heading(random, body)
    given = {"velocity": velocity, "twist": tuple(map(float, twist)), "gap": distance}
    return given, 1.2 * body.time


MOTIONS = {each.__name__: each for each in (constant, pieces, pause, retreat, sines, free, thrown)}


# --- Runs ----------------------------------------------------------------------------------------


def draw_law(random):
    """Mostly a coefficient of friction; sometimes none, or no limit."""
    usual = pp.Coulomb(float(random.uniform(0.05, 1.0)))
    special = (pp.Coulomb(0.0), pp.InfiniteFriction(), pp.PerfectlyRough())
    return special[int(random.integers(3))] if random.random() < 0.25 else usual


def draw_effects(random, body, places, shares):
    """Friction, a mass that is aside in half of the runs, and a load in a sixth."""
    center = body.size * random.uniform(-0.4, 0.4, 2) * (random.random() < 0.5)
    inertia = pp.Inertia(
        mass=body.mass, gyration_radius=body.size * random.uniform(0.3, 1.2),
        center=tuple(map(float, center)),
    )  # fmt: skip
    friction = pp.SupportFriction(support=pp.Points(body.size * places, shares), weight=body.weight)
    if random.random() >= 1 / 6:
        return friction, inertia
    angle, size = random.uniform(0.0, 2 * math.pi), random.uniform(0.1, 1.2) * body.weight
    return friction, inertia, pp.Load(force=(size * math.cos(angle), size * math.sin(angle)))


def feet_run(layout, motion, seed):
    """A run of a layout under a motion, which follows from the seed.

    Parameters
    ----------
    layout : str
        One of `LAYOUTS`.
    motion : str
        One of `MOTIONS`.
    seed : int

    Returns
    -------
    DrawnRun
        Under a fence, a finger that is a point, or a disc.
    """
    random = np.random.default_rng([*layout.encode(), *motion.encode(), seed])
    body = draw_body(random)
    places, shares = LAYOUTS[layout](random)
    effects = draw_effects(random, body, places, shares)
    psi = random.choice([math.pi / 2, random.uniform(0.6, 2.5)], p=[0.15, 0.85])
    slider = pp.Slider(rod_length=body.size * random.uniform(0.5, 2.0), rod_angle=float(psi))
    given, duration = MOTIONS[motion](random, body)
    radius = float(random.choice([0.0, body.size * 10 ** random.uniform(-1, 0.5)]))
    shape = {"shape": "finger", "radius": radius} if random.random() < 0.5 else {}
    pusher = pp.Pusher(velocity=given.pop("velocity"), **shape)
    scene = pp.Scene(slider=slider, contact=draw_law(random), effects=effects)
    return DrawnRun(scene=scene, pusher=pusher, duration=duration, size=body.size, options=given)


def flush_feet_run(motion, seed):
    """A box on feet, whose side lies on the fence at first, or whose corner is pushed.

    Parameters
    ----------
    motion : str
        One of `MOTIONS`.
    seed : int
    """
    random = np.random.default_rng([*b"flush", *motion.encode(), seed])
    body = draw_body(random)
    places, shares = LAYOUTS[str(random.choice(["table", "tripod", "scattered"]))](random)
    width, height = body.size * random.uniform(1.2, 2.5, 2)
    box = pp.Polygon.rectangle(width, height)
    effects = draw_effects(random, body, 0.5 * places, shares)
    if random.random() < 0.5:
        contact = {"side": 0}
    else:
        angle = random.uniform(0.15, 0.85) * math.pi / 2
        contact = {"point": (-width / 2, -height / 2), "normal": (math.cos(angle), math.sin(angle))}
    law = pp.Coulomb(float(random.uniform(0.05, 1.0)))
    scene = pp.scene_at(effects=effects, contact=law, outline=box, **contact)
    given, duration = MOTIONS[motion](random, body)
    pusher = pp.Pusher(velocity=given.pop("velocity"))
    return DrawnRun(scene=scene, pusher=pusher, duration=duration, size=body.size, options=given)


# --- Boxes in SI units ---------------------------------------------------------------------------


def base(width, height):
    return pp.Polygon.rectangle(width, height)


def four_feet(width, height):
    return pp.Points([(0.45 * i * width, 0.45 * j * height) for i in (-1, 1) for j in (-1, 1)])


def ring(width, height):
    return pp.Ring(0.4 * min(width, height))


def disc(width, height):
    return pp.Disc(0.08 * min(width, height))


SUPPORTS = {each.__name__: each for each in (base, four_feet, ring, disc)}


def box_push(support, seed):
    """A box of 5 to 30 cm, pushed at a side by a finger or at a corner by a fence.

    Parameters
    ----------
    support : str
        One of `SUPPORTS`.
    seed : int

    Returns
    -------
    DrawnRun
        Of 1 to 50 cm/s and over 2 to 10 cm. Half of the pushers stop, and the box coasts to rest.
    """
    random = np.random.default_rng([*support.encode(), seed])
    width, height = random.uniform(0.05, 0.3, 2)
    mass, slides = math.exp(random.uniform(math.log(0.2), math.log(3.0))), random.uniform(0.1, 0.6)
    speed = math.exp(random.uniform(math.log(0.01), math.log(0.5)))
    angle, time = (
        math.pi / 2 + np.deg2rad(random.uniform(-50, 50)),
        random.uniform(0.02, 0.1) / speed,
    )
    velocity = speed * math.cos(angle), speed * math.sin(angle)
    effects = (
        pp.SupportFriction(
            support=SUPPORTS[support](width, height), weight=pp.weight(mass, slides)
        ),
        pp.Inertia(mass=mass, gyration_radius=math.hypot(width, height) / math.sqrt(12)),
    )
    inclination = random.uniform(0.15, 0.85) * math.pi / 2
    if random.random() < 0.5:
        shape, contact = "finger", ((random.uniform(-0.4, 0.4) * width, -height / 2),)
    else:
        corner = (-width / 2, -height / 2)
        shape, contact = "fence", (corner, (math.cos(inclination), math.sin(inclination)))
    law, box = pp.Coulomb(random.uniform(0.1, 0.8)), pp.Polygon.rectangle(width, height)
    scene = pp.scene_at(*contact, effects=effects, contact=law, outline=box)
    size, duration = math.hypot(width, height) / 2, time
    if random.random() < 0.5:
        velocity, duration = (
            [(0.0, velocity), (time, (0.0, 0.0))],
            time + 1.6 * speed / slides / GRAVITY,
        )
    pusher = pp.Pusher(velocity=velocity, shape=shape)
    return DrawnRun(scene=scene, pusher=pusher, duration=duration, size=size)


# --- Runs that may not end -----------------------------------------------------------------------


def cost(push):
    """Why a push ends early, and its evaluations.

    Parameters
    ----------
    push : (support, seed, rtol)
    """
    support, seed, rtol = push
    log = box_push(support, seed).log(rtol=rtol, samples=2)
    return log.attrs["stopped"], int(log.evaluations.max())


def send(pipe, function, items):
    for item in items:
        pipe.send(function(item))


def results_apart(function, items, seconds=60.0):
    """Results of a function in a process of its own, up to the first item that takes longer than allowed.

    A run that never ends then fails a test instead of holding up all the others.
    """
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=send, args=(sender, function, items), daemon=True)
    process.start()
    sender.close()
    results = []
    try:
        while len(results) < len(items) and receiver.poll(seconds):
            results.append(receiver.recv())
    finally:
        process.kill()
        process.join()
    return results
