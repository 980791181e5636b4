"""Scenes over time by name, degenerate ones first, and their images in a mirror and in other units."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

import planar_pushing as pp
from planar_pushing.simulation.early_end import quietly

METHODS = ("event-driven", "time-stepping")
#: Steps of the time-stepping method in a run of the table.
STEPS = 64
RIGHT_ANGLE = math.pi / 2


@dataclass(frozen=True, kw_only=True)
class Case:
    """A scene, how it is pushed over time, and what its log must be.

    Attributes
    ----------
    methods : tuple of str
        Methods that are tested.
    order : bool
        Whether steps of half the length have half the error; otherwise it only becomes small.
    limit : bool
        Whether modes are at the limit of being possible, so that rounding decides how many are.
    stopped : str
        Why the run ends before its duration.
    """

    scene: pp.Scene
    velocity: Any = (0.0, 1.0)
    duration: float = 1.0
    shape: str = "fence"
    radius: float = 0.0
    gap: float = 0.0
    twist: tuple[float, float, float] = (0.0, 0.0, 0.0)
    policy: Any = "keep-contact"
    breakpoints: tuple[float, ...] = ()
    methods: tuple[str, ...] = METHODS
    order: bool = True
    limit: bool = False
    stopped: str = ""

    @property
    def pusher(self):
        return pp.Pusher(
            velocity=self.velocity, breakpoints=self.breakpoints, shape=self.shape, radius=self.radius
        )  # fmt: skip

    def log(self, method=METHODS[0], samples=9, finer=1, **options):
        """The log of the run by a method; its steps may be so many times finer."""
        steps = {"step": self.duration / STEPS / finer} if method == METHODS[1] else {}
        given = {"gap": self.gap, "twist": self.twist, "on_ambiguity": self.policy}
        return quietly(pp.simulate)(
            self.scene, pusher=self.pusher, duration=self.duration, method=method, samples=samples,
            **given | steps | options,
        )  # fmt: skip

    def at(self, log, samples=9):
        """The last rows of a log at the instants of its samples, as far as the log goes."""
        times = np.linspace(0.0, self.duration, samples)
        times = times[times <= log.time.values[-1]]
        return log.isel(time=np.searchsorted(log.time.values, times, side="right") - 1)


def scene(*effects, mu=0.4, length=2.0, psi=1.2, **slider):
    """A scene; `mu` is a coefficient or a law."""
    law = pp.Coulomb(mu) if isinstance(mu, float) else mu
    rod = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0, **slider)
    return pp.Scene(slider=rod, contact=law, effects=effects or (pp.RingFriction(),))


def feet(*places, loads=None, weight=1.0):
    """Friction of points."""
    support = pp.Points(places, np.ones(len(places)) if loads is None else loads)
    return pp.SupportFriction(support=support, weight=weight)


def friction(support, weight=1.0):
    return pp.SupportFriction(support=support, weight=weight)


SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
BOX = friction(pp.Polygon(SQUARE))
TRIPOD = feet((1.0, 0.0), (-0.5, math.sqrt(0.75)), (-0.5, -math.sqrt(0.75)))
UNEVEN = feet((1.0, 0.0), (-0.5, 0.9), (-0.4, -0.8), loads=(0.2, 0.5, 0.3))
RING, HEAVY = pp.RingFriction(), pp.Inertia(mass=0.7, gyration_radius=0.9)
ASIDE = pp.Inertia(mass=0.7, gyration_radius=0.9, center=(0.2, 0.1))
LIGHT = pp.Inertia(mass=0.3, gyration_radius=0.7)
FILM = pp.Viscous(support=pp.Disc(0.8, (0.1, 0.2)), coefficient=0.6)
PULL = pp.Load(force=(0.2, -0.1), center=(0.3, 0.2))
FREE, ROUGH = pp.InfiniteFriction(), pp.PerfectlyRough()
PULLED = scene(mu=2.0, psi=math.pi / 4)
PULLS = [(0, (1.0, 0.2)), (0.5, (1.0, -0.2))]
NO_EDGE = pp.InfiniteFriction(at_zero_normal="none")
#: A push to the left on the table, a slip to the left; then one to the right.
STARTS_AND_STOPS = [
    (0, (0.5, 1.0)), (0.25, (0.0, 0.0)), (0.5, (0.0, 1.0)), (0.75, (0.3, -1.0)), (0.85, (0.0, 2.0)),
]  # fmt: skip
LEFT, RIGHT, JERK = (0.3, 1.0), (-0.3, 1.0), [(0, (0.1, 1.0)), (0.3, (0.9, 0.5))]
#: A square with a step down at the right of its lower side.
NOTCHED = ((-1.0, -1.0), (0.6, -1.0), (0.6, -1.3), (1.0, -1.3), (1.0, 1.0), (-1.0, 1.0))
STOPS = "the slider's center comes down to the fence"
FINGER_MEETS = "the finger touches the object at two places"
SIDE_ENDS = "the finger comes to the end of the side"


def smooth(t):
    """A velocity that starts from zero and turns."""
    return 0.4 * math.sin(3 * t), 0.2 + math.sin(t)


def starts(t):
    return 0.3 * t, t * (1.0 + t)


def returns(t):
    return 0.3 * math.sin(2 * t), 0.1 + 0.5 * math.cos(3 * t)


def jumps(t):
    return (0.3, 1.0) if t < 0.4 else (-0.2, 0.7)


def turned(places, angle):
    """Places turned by an angle; exactly where that is a right one."""
    c, s = (
        (0.0, math.copysign(1.0, angle))
        if abs(angle) == RIGHT_ANGLE
        else (math.cos(angle), math.sin(angle))
    )
    return tuple((c * x - s * y, s * x + c * y) for x, y in places)


def box(point=(0.3, -1.0), *effects, mu=FREE, corners=SQUARE, outlined=False, **slider):
    """An object whose center is the origin of its frame, in which its lower side is level, pushed there."""
    psi = math.atan2(-point[1], -point[0])
    own = turned(corners, -psi)
    outline = {"outline": own} if outlined else {}
    support = friction(pp.Polygon(own))
    return scene(
        *(effects or (support,)), mu=mu, length=math.hypot(*point), psi=psi, **outline, **slider
    )


DEGENERATE = {
    "ring through its center": Case(scene=scene(psi=RIGHT_ANGLE)),
    "heavy ring through its center": Case(scene=scene(RING, HEAVY, psi=RIGHT_ANGLE)),
    "mass through its center": Case(scene=scene(HEAVY, psi=RIGHT_ANGLE), limit=True),
    "square through its center": Case(scene=scene(BOX, psi=RIGHT_ANGLE)),
    "rod along the motion": Case(scene=scene(psi=math.pi / 4, mu=2.0), velocity=(1.0, 1.0)),
    "motion on the edge of the cone": Case(scene=scene(length=0.0, mu=1.0), velocity=(-1.0, 1.0)),
    "fence along itself": Case(scene=scene(), velocity=(1.0, 0.0)),
    "fence along a mass": Case(scene=scene(RING, HEAVY), velocity=(-1.0, 0.0)),
    "fence at rest": Case(scene=scene(), velocity=(0.0, 0.0)),
    "fence at rest at a moving slider": Case(
        scene=scene(RING, HEAVY), velocity=(0.0, 0.0), twist=(0.3, 0.2, 0.4)
    ),
    "fence that leaves": Case(scene=scene(), velocity=(0.2, -1.0)),
    "feet with a pivot": Case(
        scene=scene(TRIPOD, psi=2.0, mu=0.2), velocity=(-0.2, 1.0), duration=2.0
    ),
    "pivot on the other side": Case(scene=scene(TRIPOD, mu=0.3), velocity=LEFT, duration=2.5),
    "two feet": Case(scene=scene(feet((-1.0, 0.0), (1.0, 0.0)), mu=0.3), velocity=LEFT),
    "two feet along the fence": Case(scene=scene(feet((0.0, -1.0), (0.0, 1.0)), psi=RIGHT_ANGLE)),
    "bar on its own line end": Case(
        scene=scene(feet((-1.0, 0.0), (1.0, 0.0)), length=1.0, psi=RIGHT_ANGLE)
    ),
    "tilted bar on its own line end": Case(
        scene=scene(feet((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0)), length=1.0), velocity=LEFT
    ),
    "bar pushed along its line": Case(
        scene=scene(feet((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0)), psi=math.pi / 4, mu=2.0),
        velocity=(1.0, 1.0),
    ),
    "center of pressure at the contact": Case(
        scene=scene(feet((0.0, -0.7), (0.0, 0.2), (0.0, 0.5)), length=0.0, psi=RIGHT_ANGLE)
    ),
    "contact at the center": Case(scene=scene(length=0.0), velocity=(0.5, 1.0)),
    "contact at the center of a mass": Case(scene=scene(RING, HEAVY, length=0.0), velocity=LEFT),
    "foot under the contact": Case(
        scene=scene(feet((-2.0, 0.0), (0.5, 0.5), (0.5, -0.5))), velocity=RIGHT
    ),
    "infinite friction": Case(scene=scene(mu=FREE, length=5.0), velocity=(-0.9, 0.3), duration=3.0),
    "heavy under infinite friction": Case(scene=scene(RING, HEAVY, mu=FREE), velocity=RIGHT),
    "zero friction": Case(scene=scene(mu=0.0), velocity=LEFT),
    "mass without friction": Case(scene=scene(HEAVY, mu=0.0), velocity=LEFT, order=False),
    "cone without its edge": Case(scene=scene(mu=NO_EDGE), velocity=LEFT),
    "edge without a force": Case(
        scene=scene(mu=NO_EDGE, length=5.0, psi=math.pi / 4), velocity=(-0.97, 0.26),
        stopped="no contact mode is consistent",
    ),
    "rough": Case(scene=scene(mu=ROUGH), velocity=(0.5, -0.3)),
    "heavy and rough": Case(scene=scene(RING, HEAVY, mu=ROUGH), velocity=(0.5, -0.3)),
}  # fmt: skip
MOVING = {
    "sticks, then slips": Case(scene=scene(), velocity=LEFT),
    "turns back": Case(scene=scene(mu=0.1), velocity=[(0, (0.5, 0.9)), (0.5, (-0.9, 0.7))]),
    "pulled": Case(scene=PULLED, velocity=PULLS, order=False),
    "let go": Case(scene=PULLED, velocity=PULLS, policy="separate"),
    "stays as it is": Case(scene=PULLED, velocity=PULLS, policy="stay-in-mode", order=False),
    "policies in turn": Case(
        scene=PULLED, velocity=PULLS, policy=[(0, "slip-left"), (0.55, "stick"), (0.8, "separate")]
    ),
    "leaves, stands and comes back": Case(
        scene=scene(), velocity=[(0, (0.0, -1.0)), (0.3, (0.2, 0.0)), (0.5, (0.2, 1.0))], duration=1.2,
        order=False,
    ),
    "starts, stops and turns": Case(scene=scene(), velocity=STARTS_AND_STOPS),
    "gap": Case(scene=scene(), velocity=(0.1, 0.7), gap=0.25, order=False),
    "comes down": Case(
        scene=scene(mu=2.0, psi=0.35), velocity=(0.2, 1.0), stopped=STOPS
    ),
    "function of time": Case(scene=scene(mu=0.6), velocity=smooth),
    "function with a breakpoint": Case(scene=scene(mu=0.6), velocity=jumps, breakpoints=(0.4,)),
    "square": Case(scene=scene(BOX), velocity=LEFT),
    "uneven feet": Case(scene=scene(UNEVEN, psi=1.0), velocity=JERK),
    "composite": Case(
        scene=scene(friction(pp.Composite(
            [(1.0, pp.Disc(0.5, (0.3, 0.2))), (0.5, pp.Points([(-0.6, 0.1)], [1]))]
        )), mu=0.2),
        velocity=(0.6, 1.0),
    ),
    "viscous with a load": Case(
        scene=scene(BOX, FILM, PULL, mu=0.3, length=1.0), velocity=(-0.8, 1.0)
    ),
    "load under infinite friction": Case(
        scene=scene(UNEVEN, PULL, mu=FREE, psi=1.74), velocity=(-0.23, 1.5)
    ),
    "load and a slip": Case(scene=scene(RING, PULL, mu=0.2, psi=0.8), velocity=(0.9, 0.6)),
    "retreats and pulls": Case(scene=scene(mu=4.0, psi=0.8), velocity=(0.9, -0.2)),
    "zero friction aside": Case(scene=scene(mu=0.0, psi=RIGHT_ANGLE), velocity=(0.4, 1.0)),
    "slips to the right": Case(
        scene=scene(mu=2.0, psi=math.pi / 4), velocity=(-0.985, 0.174), duration=3.0
    ),
    "turns far": Case(scene=scene(mu=0.5, length=1.0, psi=1.4), velocity=(0.94, 0.342), duration=2.0),
    "viscous": Case(scene=scene(FILM, mu=0.2), velocity=(0.6, 1.0)),
    "viscous and dry": Case(scene=scene(RING, FILM, mu=0.2), velocity=JERK),
    "load that friction holds": Case(scene=scene(RING, PULL, mu=0.2), velocity=LEFT),
    "two supports": Case(
        scene=scene(pp.RingFriction(weight=0.4), UNEVEN, mu=0.1), velocity=LEFT
    ),
}  # fmt: skip
INERTIAL = {
    "flight": Case(
        scene=scene(HEAVY), velocity=(0.0, -5.0), twist=(0.3, 0.2, -0.7), gap=5.0, duration=2.0
    ),
    "flight with friction stops": Case(
        scene=scene(RING, HEAVY), velocity=(0.0, -5.0), twist=(0.3, 0.2, -0.7), duration=3.0
    ),
    "translation stops": Case(
        scene=scene(RING, HEAVY), velocity=(0.0, -5.0), twist=(0.6, 0.8, 0.0), duration=2.0
    ),
    "impact": Case(
        scene=scene(HEAVY, mu=0.3), velocity=(0.0, 0.0), twist=(0.3, -1.0, 0.2), gap=0.4, order=False
    ),
    "impact with friction": Case(
        scene=scene(RING, ASIDE, mu=0.3), velocity=(0.1, 0.1), twist=(0.3, -1.0, 0.2), gap=0.3
    ),
    "start from rest": Case(scene=scene(RING, HEAVY), velocity=starts),
    "start of a mass": Case(scene=scene(ASIDE), velocity=starts, order=False),
    "jerk from rest": Case(scene=scene(RING, HEAVY), velocity=JERK, order=False),
    "fence that stops": Case(
        scene=scene(RING, HEAVY), velocity=[(0, (0.5, 0.8)), (0.5, (0.0, 0.0))], duration=2.5
    ),
    "mass starts, stops and turns": Case(scene=scene(HEAVY), velocity=STARTS_AND_STOPS, order=False),
    "starts, stops and turns with inertia": Case(
        scene=scene(RING, HEAVY), velocity=STARTS_AND_STOPS, order=False
    ),
    "feet with inertia": Case(scene=scene(UNEVEN, ASIDE, mu=0.2), velocity=LEFT),
    "square with inertia": Case(scene=scene(BOX, ASIDE), velocity=JERK),
    "feet that pivot and rest": Case(
        scene=scene(TRIPOD, pp.Inertia(), length=1.0, psi=RIGHT_ANGLE, mu=0.5),
        velocity=(0.0, -1.0), twist=(0.2, 0.1, 1.0), duration=1.5,
    ),
    "film and inertia": Case(scene=scene(FILM, ASIDE), velocity=JERK),
    "falls": Case(
        scene=scene(HEAVY, pp.Load(force=(0.4, 0.6))), velocity=(0.0, -9.0), twist=(0.1, 0.0, 0.3)
    ),
    "load and inertia": Case(scene=scene(RING, HEAVY, PULL), velocity=LEFT),
    "everything": Case(
        scene=scene(pp.RingFriction(weight=0.4), UNEVEN, FILM, ASIDE, HEAVY, PULL), velocity=JERK,
        order=False,
    ),
}  # fmt: skip
FINGERS = {
    "point": Case(scene=scene(mu=0.1), velocity=LEFT, shape="finger"),
    "point through the center": Case(scene=scene(BOX, psi=RIGHT_ANGLE), shape="finger"),
    "disc": Case(scene=scene(mu=0.1), velocity=JERK, shape="finger", radius=0.4),
    "disc through the center": Case(scene=box((0.0, -1.0)), shape="finger", radius=0.3, limit=True),
    "disc that rolls": Case(scene=box(), shape="finger", radius=0.5),
    "disc under a rough box": Case(scene=box(mu=ROUGH), velocity=RIGHT, shape="finger", radius=0.2),
    "wide disc": Case(scene=box(), shape="finger", radius=50.0, order=False),
    "point at feet with inertia": Case(
        scene=scene(UNEVEN, ASIDE, mu=0.2), velocity=JERK, shape="finger", order=False),
    "disc and inertia": Case(
        scene=scene(RING, HEAVY, mu=0.2), velocity=JERK, shape="finger", radius=0.4
    ),
    "disc at feet with inertia": Case(
        scene=scene(UNEVEN, ASIDE, mu=0.2), velocity=starts, shape="finger", radius=0.4
    ),
    "mass flies onto a disc": Case(
        scene=scene(HEAVY, psi=RIGHT_ANGLE), velocity=(0.0, 0.0), twist=(0.3, -0.6, 0.7), gap=0.4,
        shape="finger", radius=0.4, order=False,
    ),
    "parted": Case(
        scene=scene(UNEVEN, mu=0.3, side=(-1.0, 0.1)), velocity=JERK, shape="finger", order=False
    ),
    "point that pulls": Case(scene=scene(mu=ROUGH), velocity=(0.9, -0.3), shape="finger"),
    "point under a rough mass": Case(
        scene=scene(RING, HEAVY, mu=ROUGH), velocity=JERK, shape="finger", order=False
    ),
    "disc that parts from a mass": Case(
        scene=scene(RING, HEAVY, mu=0.1, side=(-1.0, 0.2)), velocity=(0.4, 1.0), shape="finger",
        radius=0.3, duration=0.7, order=False,
    ),
    "everything under a disc": Case(
        scene=scene(RING, UNEVEN, FILM, ASIDE, PULL, mu=0.2), velocity=JERK, shape="finger", radius=0.2,
        order=False,
    ),
}  # fmt: skip
#: Pushers that leave the slider, which comes to rest, and meet it again where they left it, or elsewhere.
RETURNING = {
    f"pusher returns to {name}": Case(
        scene=scene(*effects, length=1.0, psi=1.3), velocity=returns, duration=3.0, order=False, **shape
    )
    for name, effects, shape in (
        ("a ring", (RING,), {}),
        ("a light ring", (RING, LIGHT), {}),
        ("a square", (BOX,), {}),
        ("a light square", (BOX, LIGHT), {}),
        ("feet", (UNEVEN,), {}),
        ("light feet", (UNEVEN, LIGHT), {}),
        ("a very light tripod", (TRIPOD, pp.Inertia(mass=0.1, gyration_radius=0.7)), {}),
        ("a heavy tripod aside", (TRIPOD, ASIDE), {}),
        ("a pulled tripod", (TRIPOD, PULL, LIGHT), {}),
        ("light feet, as a disc", (UNEVEN, LIGHT), {"shape": "finger", "radius": 0.4}),
        ("a ring, as a point", (RING,), {"shape": "finger"}),
    )
}  # fmt: skip
TILTED = turned(SQUARE, 0.3)
OUTLINED = {
    "flush side": Case(
        scene=box((0.0, -1.0), outlined=True), velocity=[(0, (0.0, 1.0)), (0.5, (0.0, 0.5))]
    ),
    "corner comes down": Case(
        scene=box(TILTED[0], RING, mu=2.0, corners=TILTED, outlined=True),
    ),
    "finger at the end of its side": Case(
        scene=box((0.3, -1.0), mu=0.1, outlined=True, side=(-1.3, 0.7)), velocity=(0.5, 1.0),
        shape="finger", duration=2.0, order=False,  # the contact ends within a step
    ),
    "disc in a notch": Case(
        scene=box((0.3, -1.0), mu=0.1, corners=NOTCHED, outlined=True, side=(-1.3, 0.3)),
        velocity=(0.9, 0.2), shape="finger", radius=0.2, duration=0.6,
        order=False,  # the second place is met within a step
    ),
}  # fmt: skip
SCENES = DEGENERATE | MOVING | INERTIAL | FINGERS | RETURNING | OUTLINED


# --- Images of a scene ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Image:
    """A mirror at the normal through the contact, and other units of length, force and time.

    Attributes
    ----------
    flip : {1, -1}
        -1 for the mirror.
    """

    flip: float = 1.0
    length: float = 1.0
    force: float = 1.0
    time: float = 1.0

    def place(self, place):
        """A place or a vector in units of length, in the frame of the fence or of the body."""
        x, y = place
        return self.length * x, self.flip * self.length * y

    def along(self, vector, unit):
        """A vector in the frame of the fence."""
        x, y = vector
        return self.flip * unit * x, unit * y

    def velocity(self, velocity):
        return self.along(velocity, self.length / self.time)

    def motion(self, given):
        """A velocity over time in any of its forms."""
        if callable(given):
            return lambda t: self.velocity(given(t / self.time))
        if isinstance(given, list):
            return [(self.time * t, self.velocity(v)) for t, v in given]
        return self.velocity(given)

    def policy(self, given):
        if isinstance(given, str):
            sides = {"slip-left": "slip-right", "slip-right": "slip-left"}
            return sides.get(given, given) if self.flip < 0 else given
        return [(self.time * t, self.policy(each)) for t, each in given]

    def support(self, support):
        match support:
            case pp.Points():
                return pp.Points([*map(self.place, support.positions)], support.weights)
            case pp.Polygon():
                return pp.Polygon([*map(self.place, support.vertices)])
            case pp.Disc():
                return pp.Disc(self.length * support.radius, self.place(support.center))
            case pp.Composite():
                return pp.Composite([(w, self.support(each)) for w, each in support.members])
        raise TypeError(support)

    def effect(self, effect):
        match effect:
            case pp.RingFriction():
                return pp.RingFriction(weight=self.force * effect.weight)
            case pp.SupportFriction():
                return friction(self.support(effect.support), self.force * effect.weight)
            case pp.Inertia():
                return pp.Inertia(
                    mass=self.force * self.time**2 / self.length * effect.mass,
                    gyration_radius=self.length * effect.gyration_radius,
                    center=self.place(effect.center),
                )
            case pp.Viscous():
                unit = self.force * self.time / self.length
                return pp.Viscous(
                    support=self.support(effect.support), coefficient=unit * effect.coefficient
                )
            case pp.Load():
                center = None if effect.center is None else self.place(effect.center)
                return pp.Load(force=self.along(effect.force, self.force), center=center)
        raise TypeError(effect)

    def slider(self, slider):
        ends = sorted(self.flip * self.length * end for end in slider.side)
        outline = (
            None if slider.outline is None else [*map(self.place, slider.outline_in_body().corners)]
        )
        psi = slider.rod_angle if self.flip > 0 else math.pi - slider.rod_angle
        return pp.Slider(
            rod_length=self.length * slider.rod_length, rod_angle=psi, side=tuple(ends),
            radius=self.length * slider.radius, outline=outline,
        )  # fmt: skip

    def of(self, case):
        """The image of a case."""
        scene = pp.Scene(
            slider=self.slider(case.scene.slider), contact=case.scene.contact,
            effects=tuple(map(self.effect, case.scene.effects)),
        )  # fmt: skip
        x, y, omega = case.twist
        return replace(
            case, scene=scene, velocity=self.motion(case.velocity), duration=self.time * case.duration,
            radius=self.length * case.radius, gap=self.length * case.gap, policy=self.policy(case.policy),
            twist=(*self.velocity((x, y)), self.flip * omega / self.time),
            breakpoints=tuple(self.time * each for each in case.breakpoints),
        )  # fmt: skip

    def log(self, log):
        """What the log of the image must be."""
        speed, energy = self.length / self.time, self.force * self.length
        turn = np.array([self.flip, 1.0])
        units = {
            "time": self.time, "impulse": self.force * self.time * turn,
            "position": self.length * turn, "pusher": self.length * turn,
            "slip": self.flip * self.length, "gap": self.length, "force": self.force * turn,
            "twist": np.array([self.flip * speed, speed, self.flip / self.time]),
            "contact_position": self.flip * self.length,
        } | dict.fromkeys(ENERGIES, energy)  # fmt: skip
        found = {name: log[name].values * unit for name, unit in units.items() if name in log}
        found["rod_angle"] = log.rod_angle.values if self.flip > 0 else 180 - log.rod_angle.values
        modes = log["mode"].values
        swapped = {pp.ContactMode.SLIP_LEFT: pp.ContactMode.SLIP_RIGHT,
                   pp.ContactMode.SLIP_RIGHT: pp.ContactMode.SLIP_LEFT}  # fmt: skip
        found["mode"] = np.array([swapped.get(m, m) if self.flip < 0 else m for m in modes])
        return found | {
            name: log[name].values for name in ("pivot", "solutions", "outcome", "adhesive")
        }


ENERGIES = ("dissipated", "contact_dissipated", "work", "load_work", "kinetic_energy")
