"""The questions of the checks to an implementation of the mechanics, and the answers of the oracle.

All numbers are balls, angles are in degrees, and motions and wrenches are in the frame of the rod, with the
torque about the contact. Floats with tolerances as radii are judged by the same checks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any, Protocol

from flint import arb, fmpq

from pulling_by_pushing.evidence.proofs.verdicts import Fails
from pulling_by_pushing.oracle.balls import (
    Direction,
    Exact,
    at_degrees,
    cone_edge,
    cosine_sine,
    cross,
    dot,
    in_degrees,
    rational,
    remember,
    sign,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.bounds import conservative_cone
from pulling_by_pushing.oracle.complete import path
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    contact_modes,
)
from pulling_by_pushing.oracle.motions import ray
from pulling_by_pushing.oracle.prove import Proved, Slider
from pulling_by_pushing.oracle.shapes import support
from pulling_by_pushing.oracle.support import friction

Pair = tuple[arb, arb]
Triple = tuple[arb, arb, arb]
FRICTION, INERTIA = "support_friction", "inertia"
BOTH = f"{FRICTION}+{INERTIA}"
ONE = fmpq(1)
#: Contact laws by name; a number is a coefficient of friction.
LAWS = {
    "definition-1": INFINITE_FREE,
    "definition-2": INFINITE_NONE,
    "perfectly-rough": PERFECTLY_ROUGH,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """A slider and its contact; W = m = 1, and angles in degrees.

    Attributes
    ----------
    law : float or str
        A coefficient of friction, or a name of `LAWS`.
    support : mapping
        An entry of a scene file; a ring has the radius 1 by default.
    effects : str
        ``support_friction``, ``inertia``, or both, joined by +.
    mass_along, mass_across : float
        Mass center in the frame of the rod, from the slider's center.
    """

    rod_length: float | fmpq = 0.0
    rod_angle: float = 45.0
    law: float | str = "definition-1"
    support: Mapping[str, Any] = field(default_factory=lambda: {"shape": "ring"}, hash=False)
    effects: str = FRICTION
    gyration_radius: float = 1.0
    mass_along: float = 0.0
    mass_across: float = 0.0

    def __post_init__(self) -> None:
        if not {*self.effects.split("+")} <= {FRICTION, INERTIA}:
            raise ValueError(f"effects {self.effects}, not {FRICTION}, {INERTIA} or {BOTH}")
        if isinstance(self.law, str) and self.law not in LAWS:
            raise ValueError(f"a law {self.law}, not a number or one of {', '.join(LAWS)}")

    @property
    def pure(self) -> list[Scene]:
        """The scene with each of its effects alone."""
        return [replace(self, effects=effect) for effect in self.effects.split("+")]

    def in_rod_frame(self, angle: fmpq | float) -> Pair:
        """Unit vector at an angle from the fence."""
        return cosine_sine(rational(angle) - rational(self.rod_angle))


class Mechanics(Protocol):
    """The questions that a check may ask."""

    def wrench(self, scene: Scene, motion: Sequence[Any], without: int = -1) -> Triple:
        """Force and torque that sustain a motion, without the friction of the foot of this index."""

    def motion(self, scene: Scene, force_angle: fmpq, power: fmpq) -> Triple:
        """Motion of the contact and rotation under a line of force, with the power of a unit force."""

    def friction_cone(self, scene: Scene) -> Pair:
        """Angles of the right and the left edge."""

    def motion_cone(self, scene: Scene) -> Pair:
        """Angles of the contact's motion at the edges; with both effects, bounds over all magnitudes."""

    def bound_of_the_cases(self, scene: Scene) -> Pair:
        """Edges that the seven cases of Sec. 4 allow under infinite friction."""

    def dip(self, scene: Scene) -> Triple:
        """Least normal motion under the right edge with both effects, the force there, and at its zero."""

    def modes(
        self, scene: Scene, pusher_angle: float, magnitude: float
    ) -> list[tuple[str, arb | None]]:
        """Every consistent contact mode, and the angle of its force."""


class Oracle:
    """The answers in ball arithmetic."""

    def wrench(self, scene: Scene, motion: Sequence[Any], without: int = -1) -> Triple:
        force_x, force_y, torque = (
            _slider(scene).body.wrench([arb(q) for q in motion], without).value
        )
        return force_x, force_y, torque

    def motion(self, scene: Scene, force_angle: fmpq, power: fmpq) -> Triple:
        motion = _motion(scene, at_degrees(force_angle), power)
        exact = _in_rods_frame(motion.exact, rational(scene.rod_angle))
        u_x, u_y = (_without_zero(*pair) for pair in zip(motion.q, exact, strict=False))
        return power * u_x, power * u_y, power * motion.q[2]

    def friction_cone(self, scene: Scene) -> Pair:
        right, left = _edges(scene)
        return right.angle, left.angle

    def motion_cone(self, scene: Scene) -> Pair:
        rights, lefts = ([_angle(pure, edge) for pure in scene.pure] for edge in _edges(scene))
        return reduce(arb.min, rights), reduce(arb.max, lefts)

    def bound_of_the_cases(self, scene: Scene) -> Pair:
        right, left = conservative_cone(_slider(scene), ONE)
        return right.ball, left.ball

    def dip(self, scene: Scene) -> Triple:
        motions = path(_slider(scene), _edges(scene)[0])
        gaps = [part.low.union(part.high) for part in motions.parts if part.slope_sign == 0]
        if [part.slope_sign for part in motions.parts] not in ([-1, 0, 1], [1, 0, -1]):
            raise Fails("the normal motion does not fall and rise once")
        bottom, back = gaps[0], motions.normal / motions.lever
        forces = [profile(k)[0] + motions.speed(k) for k in (bottom, back)]  # W f + m v
        return motions.normal_motion(bottom), forces[0], forces[1]

    def modes(
        self, scene: Scene, pusher_angle: float, magnitude: float
    ) -> list[tuple[str, arb | None]]:
        pusher, size = at_degrees(pusher_angle), rational(magnitude)
        modes = []
        for solution in contact_modes(_slider(scene), _law(scene), pusher, size):
            name, motion = solution.mode.name.lower().replace("_", "-"), solution.motion
            modes.append((name, None if motion is None else _force_angle(scene, motion, name)))
        return modes


def profile(k: arb) -> Pair:
    """Force f and torque t of the ring at a spin ratio k >= 0; f decreases with k and t increases."""
    if k.is_exact():
        return friction(k)
    (f_high, t_low), (f_low, t_high) = friction(k.lower()), friction(k.upper())
    return f_high.union(f_low), t_low.union(t_high)


@remember(1 << 10)  # so that its motions are remembered, too
def _slider(scene: Scene, power: fmpq = ONE) -> Slider:
    """The slider with a mass that is `power` times that of the scene."""
    has_friction, has_mass = (effect in scene.effects.split("+") for effect in (FRICTION, INERTIA))
    body = Body(
        length=rational(scene.rod_length),
        support=support(scene.support),
        weight=fmpq(int(has_friction)),
        mass=power * int(has_mass),
        gyration=rational(scene.gyration_radius) ** 2,
        mass_center=(rational(scene.mass_along), rational(scene.mass_across)),
    )
    return Slider(body, rational(scene.rod_angle))


def _law(scene: Scene) -> Law:
    return LAWS[scene.law] if isinstance(scene.law, str) else Law(scene.law)


def _edges(scene: Scene) -> tuple[Direction, Direction]:
    coefficient = _law(scene).friction_coefficient
    return cone_edge(coefficient, 1), cone_edge(coefficient, -1)


def _motion(scene: Scene, force: Direction, power: fmpq = ONE) -> Proved:
    """The motion over the power: a mass in proportion to it requires the same force."""
    return ray(_slider(scene, power), force)


def _angle(scene: Scene, force: Direction) -> arb:
    """Angle of the contact's motion, within 90 degrees of that of the force; zero is exact."""
    rod = rational(scene.rod_angle)
    motion, e = _motion(scene, force), force.about(rod).ball
    u = motion.q[:2]
    angle = force.angle + in_degrees((cross(e, u) / dot(e, u)).atan())
    return _without_zero(angle, None if motion.exact is None else motion.exact[1])


def _in_rods_frame(
    exact: tuple[Exact, Exact] | None, rod_angle: fmpq
) -> tuple[Exact | None, Exact | None]:
    """An exact vector of the fence's frame in the frame of the rod."""
    rod = at_degrees(rod_angle).exact
    if exact is None or rod is None:
        return None, None
    (x, y), (c, s) = exact, rod
    return x * c + y * s, y * c - x * s


def _without_zero(ball: arb, exact: Exact | None) -> arb:
    """An exact zero if an exact multiple of the number vanishes."""
    if exact is None or not ball.contains(0) or sign(ball, lambda: exact):
        return ball
    return arb(0)


def _force_angle(scene: Scene, motion: Proved, mode: str) -> arb:
    """Angle of the force: exactly that of an edge in a slip."""
    right, left = _edges(scene)
    if mode != "stick":
        return (left if mode == "slip-right" else right).angle
    (x, y), (cosine, sine) = motion.force, cosine_sine(rational(scene.rod_angle))
    return in_degrees(arb.atan2(x * sine + y * cosine, x * cosine - y * sine))
