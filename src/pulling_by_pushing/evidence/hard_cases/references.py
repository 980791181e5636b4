"""References of hard cases from the oracle.

Inputs are exact rational numbers, or infinite; angles are radians. A reference is a number with the sum of
the magnitudes of its terms if it is a sum over the members of a support, such as feet, otherwise with 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from flint import arb, ctx, fmpq

from pulling_by_pushing.oracle.balls import (
    Direction,
    Number,
    Undecided,
    at_degrees,
    cross,
    dot,
    norm,
    rational,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.modes import Law, Mode, contact_modes
from pulling_by_pushing.oracle.motions import ray, stick, unit_motion
from pulling_by_pushing.oracle.prove import Proved, Slider, State
from pulling_by_pushing.oracle.shapes import SupportEntry, support
from pulling_by_pushing.oracle.support import Support, friction

#: A number of a motion, with the direction of the force.
Measure = Callable[[State, Direction], arb]
RING: SupportEntry = {"shape": "ring"}
#: Relative error, in bits, of the rational numbers of degrees that stand for radians.
BITS = 1024
QUARTER = math.pi / 2
#: Halvings of a bracket, down to 1 in 10^48 of it.
BISECTIONS = 160
ONE = fmpq(1)


def in_exact_degrees(radians: float | fmpq) -> fmpq:
    """An angle in degrees; exact for the doubles next to quarter turns, which the library takes as such."""
    quarters = round(float(radians) / QUARTER)
    if rational(quarters * QUARTER) == rational(radians):
        return fmpq(90 * quarters)
    with ctx.workprec(BITS):
        mantissa, exponent = (arb(rational(radians)) * 180 / arb.pi()).mid().man_exp()
        return fmpq(mantissa) * fmpq(2) ** int(exponent)


def direction(radians: fmpq) -> Direction:
    """Exact direction at an angle in radians."""
    return at_degrees(in_exact_degrees(radians))


def slider(
    length: fmpq,
    psi: fmpq,
    share: float | fmpq | None,
    rho: float | fmpq = ONE,
    entry: SupportEntry = RING,
) -> Slider:
    """A slider with friction and inertia in these shares of one unit; None for one unit of each."""
    mass = ONE if share is None else rational(share)
    weight = ONE if share is None else 1 - mass
    square, pieces = rational(rho) ** 2, support(entry)
    body = Body(length=length, support=pieces, weight=weight, mass=mass, gyration=square)
    return Slider(body, in_exact_degrees(psi))


# --- The ring -----------------------------------------------------------------------------------------


def ring_wrench(part: int, k: fmpq) -> Number:
    """Force (part 0) or torque (1) of the ring at a spin ratio."""
    return Number(friction(arb(k))[part], arb(0))


def ring_spin(arm: fmpq) -> Number:
    """Spin ratio under a force with a moment arm, the inverse of ``t(k) / f(k)``, by a change of sign."""
    low, high = arb(arm) / 5, arb(arm) * 4
    for _ in range(BISECTIONS):
        middle = ((low + high) / 2).mid()
        force, torque = friction(middle)
        excess = torque - arm * force
        if excess.contains(0):
            raise Undecided("a spin ratio next to the middle of a bracket")
        low, high = (low, middle) if excess > 0 else (middle, high)
    return Number(low.union(high), arb(0))


# --- Motions ------------------------------------------------------------------------------------------


def turn(state: State, force: Direction) -> arb:
    """Angle of the contact's motion, within a quarter turn of that of the force."""
    u, e = state.to_fence(state.u_x, state.u_y), force.ball
    return force.angle * arb.pi() / 180 + arb.atan2(cross(e, u), dot(e, u))


def spin(state: State, _force: Direction) -> arb:
    """Rotation times a unit length over the speed of the slider's center."""
    return state.omega / norm(state.u_x, state.u_y + state.omega * state.length)


def force_size(state: State, _force: Direction) -> arb:
    """Measure of a state: magnitude of its force."""
    return norm(state.f_x, state.f_y)


def under_force(measure: Measure, rod: Slider, force: Direction) -> Number:
    """A number of the motion under a force."""
    is_single = rod.body.weight == 0 or rod.body.mass == 0
    return _of(measure, rod, force, (ray if is_single else unit_motion)(rod, force))


def sticking_value(measure: Measure, rod: Slider, pusher: Direction, size: fmpq = ONE) -> Number:
    """A number of the sticking motion under a push."""
    return _of(measure, rod, pusher, stick(rod, pusher, size)[0])


def slipping_spins(rod: Slider, mu: fmpq, pusher: Direction, size: fmpq) -> list[Number]:
    """Spin ratios of the slips to the left, in ascending order."""
    modes = contact_modes(rod, Law(float(mu)), pusher, size)
    slips = [mode.motion for mode in modes if mode.mode is Mode.SLIP_LEFT and mode.motion]
    return sorted((_of(spin, rod, pusher, slip) for slip in slips), key=lambda k: float(k.ball))


def _of(measure: Measure, rod: Slider, angle: Direction, motion: Proved) -> Number:
    return motion.numbers(rod, lambda state: [measure(state, angle)])[0]._replace(rounding=arb(0))


# --- Rotations ----------------------------------------------------------------------------------------


def rotation(part: int, entry: SupportEntry, x: fmpq, y: fmpq) -> Number:
    """Mean distance (part 0), force (1) or torque about the origin (2) of a rotation about a center.

    The force of a foot at the center is the subgradient closest to zero.
    """

    def value(distance: arb, g_x: arb, g_y: arb) -> arb:
        return (distance, norm(g_x, g_y), distance - x * g_x - y * g_y)[part]

    terms = [member.dgh((arb(x), arb(y)))[:3] for member in _members(support(entry), (x, y))]
    sums = [sum(column, arb(0)) for column in zip(*terms, strict=True)]
    return Number(value(*sums), sum((abs(value(*term)) for term in terms), arb(0)))


def _members(pieces: Support, center: tuple[fmpq, fmpq]) -> list[Support]:
    """The feet that are not at the center, the circles and segments of a support, and its plate."""
    plate = tuple(line for line in pieces.lines if line.plate)
    return [
        *(Support(points=(point,)) for point in pieces.points if point.position != center),
        *(Support(circles=(circle,)) for circle in pieces.circles),
        *(Support(lines=(line,)) for line in pieces.lines if not line.plate),
        *([Support(lines=plate)] if plate else []),
    ]
