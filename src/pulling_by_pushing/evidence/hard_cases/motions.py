"""Line 13 of the hard cases: motions over time, whose references are stored.

13. a slip that dies, a center of rotation that crosses a foot, a grazing contact, a mass that is a
    millionth of the friction, a thousand contact changes, and a side that rocks down onto the fence.

A reference takes up to minutes, so that `motion_references` computes it once, on the route that the case
names: the oracle's integrator, a quadrature, or an integrator in doubles. The oracle also knows the slip
that dies and the thousand changes, but takes too long for them.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate

LINE = 13
#: Relative tolerance of the runs: the tightest for which times are measured.
RTOL = 1e-12
#: File of the stored references.
FILE = "motions.json"
ORACLE, QUADRATURE, INTEGRATOR = "oracle", "quadrature", "integrator"
TRIPOD = ((1.0, 0.0), (-0.5, 0.8660254037844386), (-0.5, -0.8660254037844386))
#: Corners of the box that rocks, and the rod angle at which its side is on the fence, degrees.
BOX, FLUSH = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)), 135.0


@dataclass(frozen=True, slots=True, kw_only=True)
class HardMotion:
    """A motion of a slider of radius 1 and weight 1 on a fence; angles are in degrees.

    Attributes
    ----------
    name, route : str
        What is hard, and the route to the reference.
    length, angle : float
        Length and angle of the rod.
    mu : float
        Coefficient of friction.
    pusher, speed : float
        Direction and speed of the fence.
    duration : float
    pieces : int
        Number of equal times after each of which the fence moves in the mirror image of its direction.
    feet : tuple
        Feet that carry equal shares; without them the ring.
    mass : float, optional
        Mass, with a radius of gyration of 1.
    gap, sinking, spin : float
        Initial gap, speed toward the fence, and rate of rotation.
    box : bool
        Whether the slider is the box, with a corner on the fence.
    """

    name: str
    route: str
    length: float
    angle: float
    mu: float
    pusher: float
    duration: float
    speed: float = 1.0
    pieces: int = 1
    feet: tuple[tuple[float, float], ...] = ()
    mass: float | None = None
    gap: float = 0.0
    sinking: float = 0.0
    spin: float = 0.0
    box: bool = False


#: The motions.
MOTIONS = (
    HardMotion(
        name="slip that dies", route=QUADRATURE,
        length=2.0, angle=70.0, mu=0.3, pusher=120.0, duration=2.0,
    ),
    HardMotion(
        name="center that crosses a foot", route=QUADRATURE,
        length=2.0, angle=30.0, mu=2.0, pusher=110.0, duration=1.0, feet=TRIPOD,
    ),
    HardMotion(
        name="grazing contact", route=ORACLE, length=2.0, angle=45.0, mu=0.5, pusher=90.0, duration=1.0,
        speed=0.0, mass=1.0, gap=0.1, sinking=0.2, spin=float(np.rad2deg(1.0)),
    ),
    HardMotion(
        name="mass of a millionth", route=INTEGRATOR,
        length=2.0, angle=45.0, mu=0.5, pusher=110.0, duration=1.0, mass=1e-6,
    ),
    HardMotion(
        name="thousand contact changes", route=INTEGRATOR,
        length=2.0, angle=45.0, mu=0.3, pusher=150.0, duration=1.0, pieces=1000,
    ),
    HardMotion(
        name="side that rocks down", route=QUADRATURE,
        length=float(np.sqrt(2.0)), angle=115.0, mu=0.5, pusher=90.0, duration=2.0, box=True,
    ),
)  # fmt: skip


class Reference(NamedTuple):
    """A stored reference: its decimal digits, their number, its route, and its condition number."""

    value: str
    digits: int
    route: str
    condition: float


def scene_file(motion: HardMotion) -> SceneFile:
    """Scene file of a motion of a slider on its rod."""
    friction: dict[str, Any] = {"type": "ring_friction", "weight": 1.0}
    if motion.feet:
        points = {"shape": "points", "positions": motion.feet, "weights": [1.0] * len(motion.feet)}
        friction = {"type": "support_friction", "weight": 1.0, "support": points}
    inertia = {"type": "inertia", "mass": motion.mass, "gyration_radius": 1.0}
    return SceneFile.model_validate(
        {
            "slider": {"rod_length": motion.length, "rod_angle": motion.angle, "radius": 1.0},
            "contact": {"law": "coulomb", "friction_coefficient": motion.mu},
            "effects": [friction] if motion.mass is None else [friction, inertia],
            "simulate": _section(motion),
        }
    )


def _section(motion: HardMotion) -> dict[str, Any]:
    step = motion.duration / motion.pieces
    pusher = [
        {
            "time": i * step,
            "angle": 180.0 - motion.pusher if i % 2 else motion.pusher,
            "speed": motion.speed,
        }
        for i in range(motion.pieces)
    ]
    section = {"pusher": pusher, "duration": motion.duration, "rtol": RTOL, "samples": 2}
    if motion.mass is not None and motion.gap:
        twist = {"v_x": 0.0, "v_y": -motion.sinking, "omega": motion.spin}
        section |= {"initial_gap": motion.gap, "initial_twist": twist}
    return section


def run(motion: HardMotion) -> xr.Dataset:
    """Log of a motion, at its events and its end."""
    if not motion.box:
        return simulate_file(scene_file(motion))
    turn = np.deg2rad(FLUSH - motion.angle + 90.0)
    scene = scene_at(
        BOX[1], (np.cos(turn), np.sin(turn)), effects=(SupportFriction(support=Ring(1.0)),),
        contact=Coulomb(motion.mu), outline=BOX,
    )  # fmt: skip
    direction = np.deg2rad(motion.pusher)
    velocity = (motion.speed * np.cos(direction), motion.speed * np.sin(direction))
    return simulate(
        scene, Pusher(velocity=velocity), duration=motion.duration, rtol=RTOL, samples=2
    )


def results(motion: HardMotion) -> dict[str, float]:
    """Numbers of a motion by quantity.

    These are the last place of the center along the first line of the fence, and the last rod angle
    or, of the box, the time at which its side is on the fence.
    """
    log = run(motion)
    place = float(log["position"].values[-1, 0])
    if motion.box:
        return {
            "time": float(log["time"].values[np.argmax(log["flush"].values)]),
            "position": place,
        }
    return {"rod_angle": float(log["rod_angle"].values[-1]), "position": place}


def label(quantity: str, motion: HardMotion) -> str:
    """Label of a case."""
    return f"{quantity.replace('_', ' ')}, {motion.name}"


@cache
def stored_references() -> dict[str, Reference]:
    """The stored references by label."""
    text = (files("pulling_by_pushing.evidence.hard_cases") / FILE).read_text()
    return {name: Reference(**entry) for name, entry in json.loads(text).items()}


class Outcome(NamedTuple):
    """A case of a motion: label, quantity, result and reference."""

    label: str
    quantity: str
    result: float
    reference: Reference


def outcomes() -> Iterator[Outcome]:
    """Every case of the motions, with the library's result."""
    references = stored_references()
    for motion in MOTIONS:
        for quantity, result in results(motion).items():
            name = label(quantity, motion)
            yield Outcome(name, quantity, result, references[name])
