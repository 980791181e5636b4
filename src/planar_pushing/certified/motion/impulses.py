"""The contact of a slider with inertia: forces and impulses of the contact modes, as balls.

A force f at the contact accelerates it by ``f / m + (rod x f) J rod / (m rho^2)``, where rod is the
vector from the contact to the center of mass. An impulse changes its velocity in the same way. Support
friction is finite and has no part in an impact, which is inelastic.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided, norm, rational, sign
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion.choices import chosen, friction_edges
from planar_pushing.certified.motion.instants import ZERO, File, Vector

#: Sense of a slip along the fence.
SENSE = {Mode.SLIP_RIGHT: 1, Mode.SLIP_LEFT: -1}


@dataclass(frozen=True, slots=True)
class Body:
    """A slider with inertia whose center of mass is its center, R = 1.

    Attributes
    ----------
    length, mass, moment : fmpq
        Length of the rod; m; m rho^2.
    right, left : tuple of arb
        Edges of the friction cone.
    """

    length: fmpq
    mass: fmpq
    moment: fmpq
    right: Vector
    left: Vector

    def edge(self, mode: Mode) -> Vector:
        """The edge of the friction cone on which the force of a slip lies."""
        return self.left if mode is Mode.SLIP_RIGHT else self.right


def body(file: File) -> Body:
    """The body of a scene file."""
    slider, inertia = file["slider"], [e for e in file["effects"] if e["type"] == "inertia"]
    if slider["radius"] != 1 or len(inertia) != 1 or any(inertia[0].get("center") or ()):
        raise Undecided("certified motion requires one mass at the slider's center, with R = 1")
    mass = rational(inertia[0]["mass"])
    moment = mass * rational(inertia[0]["gyration_radius"]) ** 2
    right, left = ((angle.cos(), angle.sin()) for angle in friction_edges(file))
    return Body(rational(slider["rod_length"]), mass, moment, right, left)


def torque(rod: Vector, force: Vector) -> arb:
    """Torque about the center of a force at the contact."""
    return rod[1] * force[0] - rod[0] * force[1]


def response(of: Body, rod: Vector, force: Vector) -> Vector:
    """Acceleration of the contact under a force there."""
    turn = torque(rod, force) / of.moment
    return force[0] / of.mass + turn * rod[1], force[1] / of.mass - turn * rod[0]


def force(of: Body, rod: Vector, mode: Mode, free: Vector) -> Vector:
    """Force of a mode, given the acceleration that the contact would have relative to the fence without it.

    The same function gives the impulse of a mode, given the velocity before the impact.
    """
    if mode is Mode.SEPARATE:
        return ZERO
    if mode is Mode.STICK:
        return _stopping(of, rod, free)
    edge = of.edge(mode)
    size = -free[1] / response(of, rod, edge)[1]
    return size * edge[0], size * edge[1]


def _stopping(of: Body, rod: Vector, free: Vector) -> Vector:
    """The force that cancels a motion: the effective mass is m along the rod, and smaller across it."""
    reach = norm(*rod)
    x, y = rod[0] / reach, rod[1] / reach
    along = -of.mass * (free[0] * x + free[1] * y)
    aside = -(free[0] * y - free[1] * x) / (1 / of.mass + reach * reach / of.moment)
    return along * x + aside * y, along * y - aside * x


def consistent(of: Body, rod: Vector, slip: arb, free: Vector) -> list[Mode]:
    """Modes in which a motion on the fence can continue, for accelerations or for an impact.

    Parameters
    ----------
    of : Body
    rod : tuple of arb
    slip : arb
        Velocity of the contact along the fence; an exact zero at an impact, which allows either sense.
    free : tuple of arb
        Acceleration of the contact relative to the fence without a force, or velocity before an impact.
    """
    found = [Mode.SEPARATE] if sign(free[1]) >= 0 else []
    if slip.is_zero() and admits(of, force(of, rod, Mode.STICK, free)):
        found.append(Mode.STICK)
    for mode, sense in SENSE.items():
        if slip.is_zero() or sign(slip) == sense:
            f = force(of, rod, mode, free)
            after = slip if not slip.is_zero() else free[0] + response(of, rod, f)[0]
            edge = of.edge(mode)
            if sign(f[0] * edge[0] + f[1] * edge[1]) > 0 and sign(after) == sense:
                found.append(mode)
    return found


@dataclass(frozen=True, slots=True)
class Impact:
    """Mode and impulse of an impact, the velocity of slip after it, and the energy lost."""

    mode: Mode
    impulse: Vector
    slip: arb
    lost: arb


def impact(of: Body, rod: Vector, before: Vector, policy: str) -> Impact:
    """The impact that a policy selects, given the velocity of the contact relative to the fence."""
    mode = chosen(consistent(of, rod, arb(0), before), policy)
    p = force(of, rod, mode, before)
    change = response(of, rod, p)
    slip = arb(0) if mode is Mode.STICK else before[0] + change[0]
    rise = before[1] if mode is Mode.SEPARATE else arb(0)
    lost = -(p[0] * (before[0] + slip) + p[1] * (before[1] + rise)) / 2
    return Impact(mode, p, slip, lost)


def admits(of: Body, f: Vector) -> bool:
    """Whether a force lies inside the friction cone.

    Raises
    ------
    Undecided
        If it is too close to an edge.
    """
    sides = (edge[0] * f[1] - edge[1] * f[0] for edge in (of.right, of.left))
    past, short = map(sign, sides)
    return past > 0 > short
