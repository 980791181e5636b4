"""A scene's effects, exact, and their sum about the contact: one friction, one mass, one load.

The load of a scene is in the frame of the fence, everything else in the body frame.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from flint import arb, fmpq

from planar_pushing.certified.balls import Exact, settle
from planar_pushing.certified.potential.direction import Direction, exact_turned, turned
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.supports.pressure.mirror import is_mirrored
from planar_pushing.certified.supports.pressure.moments import Vector
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place, together

ORIGIN: Place = (fmpq(0), fmpq(0))


@dataclass(frozen=True, slots=True)
class Friction:
    """Coulomb friction of a support; the force in a translation is `weight`."""

    support: Pieces
    weight: fmpq


@dataclass(frozen=True, slots=True)
class Inertia:
    """A mass at a place, and the square of its radius of gyration."""

    mass: fmpq
    gyration: fmpq
    center: Place = ORIGIN


@dataclass(frozen=True, slots=True)
class Viscous:
    """Viscous friction of a support; the force in a translation is `coefficient` times the velocity."""

    support: Pieces
    coefficient: fmpq


@dataclass(frozen=True, slots=True)
class Load:
    """A force in the frame of the fence at a place of the body, by default the mass center."""

    force: Place
    place: Place | None = None


Effect = Friction | Inertia | Viscous | Load


@dataclass(frozen=True, slots=True)
class Scene:
    """Rod length, rod direction relative to the fence, and the effects that resist the motion."""

    length: fmpq
    rod: Direction
    effects: tuple[Effect, ...]


@dataclass(frozen=True, slots=True)
class Resistance:
    """The sum of effects about the contact, body frame, at one precision.

    Attributes
    ----------
    length : fmpq
        The contact is at (-length, 0).
    rod : tuple of arb
        Unit vector of the rod in the frame of the fence.
    support : Pieces
        Has no pieces if there is no friction.
    weight : fmpq
    mass : fmpq
        Mass, or coefficient of viscous friction; the moments likewise.
    first : tuple of fmpq
        First moment of the mass about the contact.
    second : fmpq
        Second moment of the mass about the contact.
    load : tuple of arb
        Force, and torque about the contact.
    """

    length: fmpq
    rod: Vector
    support: Pieces
    weight: fmpq
    mass: fmpq
    first: Place
    second: fmpq
    load: tuple[arb, arb, arb]

    @property
    def pressure(self) -> Place:
        """Center of pressure relative to the contact."""
        x, y = self.support.center
        return x + self.length, y

    def push(self, direction: Direction) -> Push:
        """A line through the contact along a direction of the body frame."""
        return Push(self.support, self.length, *direction.ball(), direction.exact)

    def foot(self, i: int) -> Place:
        """A point of the support relative to the contact."""
        x, y = self.support.points[i].place
        return x + self.length, y

    @property
    def is_steady(self) -> bool:
        """Whether multiples of a motion share one direction of the force: all effects are of one degree."""
        return all(each.is_zero() for each in self.load) and not (self.weight and self.mass)

    def is_even(self) -> bool:
        """Whether the slider is symmetric about the rod: force and motion across the rod are parallel."""
        even = not self.first[1] and self.load[0].is_zero() and self.load[2].is_zero()
        return bool(even and is_mirrored(self.support))


def resistance(scene: Scene) -> Resistance:
    """The sum of a scene's effects, at the precision in use."""
    support, weight = _friction(scene)
    masses = [(each.mass, each.center, each.gyration) for each in _inertias(scene)]
    if not masses:  # no viscous force acts on an acceleration from rest
        masses = [
            (each.coefficient, each.support.center, each.support.spread)
            for each in scene.effects
            if isinstance(each, Viscous)
        ]
    mass, first, second = fmpq(0), ORIGIN, fmpq(0)
    for own, (x, y), gyration in masses:
        arm = x + scene.length
        mass, first = mass + own, (first[0] + own * arm, first[1] + own * y)
        second += own * (gyration + arm * arm + y * y)
    return Resistance(
        scene.length, scene.rod.ball(), support, weight, mass, first, second, _load(scene)
    )


def _friction(scene: Scene) -> tuple[Pieces, fmpq]:
    frictions = [each for each in scene.effects if isinstance(each, Friction)]
    weight = sum((each.weight for each in frictions), fmpq(0))
    if len(frictions) == 1:
        return frictions[0].support, weight
    return together([(each.support, each.weight / weight) for each in frictions]), weight


def _inertias(scene: Scene) -> list[Inertia]:
    return [each for each in scene.effects if isinstance(each, Inertia)]


def _load(scene: Scene) -> tuple[arb, arb, arb]:
    x, y, torque = arb(0), arb(0), arb(0)
    for force, place in _loads(scene):
        known: tuple[Exact, Exact] | None = None
        if scene.rod.exact is not None:
            known = exact_turned(force, scene.rod.exact)
        own = turned((arb(force[0]), arb(force[1])), scene.rod.ball(), known)
        arm = place[0] + scene.length, place[1]
        moment = arm[0] * own[1] - arm[1] * own[0]
        if known is not None:
            exact = arm[0] * known[1] - arm[1] * known[0]
            moment = settle(moment, lambda exact=exact: exact)  # type: ignore[misc]
        x, y, torque = x + own[0], y + own[1], torque + moment
    return x, y, torque


def _loads(scene: Scene) -> Iterable[tuple[Place, Place]]:
    """Nonzero forces and their points of application."""
    center = _mass_center(scene)
    for each in scene.effects:
        if isinstance(each, Load) and any(each.force):
            yield each.force, center if each.place is None else each.place


def _mass_center(scene: Scene) -> Place:
    inertias = _inertias(scene)
    mass = sum((each.mass for each in inertias), fmpq(0))
    if not mass:
        return ORIGIN
    x, y = (sum((each.mass * each.center[i] for each in inertias), fmpq(0)) / mass for i in (0, 1))
    return x, y
