"""Equations of a ring with friction and inertia whose contact sticks to the fence or slips on it.

Lengths are in units of R = 1. The state contains the rotation and the velocity of the contact relative
to the fence, which is zero while the contact sticks. Numbers are midpoints of balls.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import Undecided, norm
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.motion import impulses
from planar_pushing.certified.motion.extrapolation import Scheme, State, advance
from planar_pushing.certified.motion.impulses import Body
from planar_pushing.certified.motion.instants import Vector, center_motion, rod_of

#: Unit steps in the logarithm of the rotation after which a motion has decayed to zero to all digits.
DECAYS = 80


class Now(NamedTuple):
    """Rod angle, rotation, rate of slip, slip, energies and time."""

    angle: arb
    spin: arb
    rate: arb
    slip: arb
    work: arb
    rubbed: arb
    lost: arb
    time: arb


class Forces(NamedTuple):
    """Forces and accelerations at an instant.

    Attributes
    ----------
    rod, velocity : tuple of arb
        Vector from the contact to the center; velocity of the center.
    free : tuple of arb
        Acceleration of the contact relative to the fence without the force of the fence.
    force : tuple of arb
        Force of the fence.
    turn, along : arb
        Accelerations of the rotation and of the slip.
    power : arb
        Power that support friction dissipates.
    """

    rod: Vector
    velocity: Vector
    free: Vector
    force: Vector
    turn: arb
    along: arb
    power: arb


@dataclass(frozen=True, slots=True)
class Phase:
    """One mode under a constant velocity of the fence."""

    of: Body
    weight: fmpq
    fence: Vector
    mode: Mode

    def forces(self, now: Now) -> Forces:
        """Forces and accelerations of the mode."""
        of, rod = self.of, rod_of(self.of.length, now.angle)
        velocity = center_motion(rod, (self.fence[0] + now.rate, self.fence[1]), now.spin)
        speed = norm(*velocity)
        force, torque = (self.weight * each for each in ring.profile((abs(now.spin) / speed).mid()))
        torque, (x, y) = torque * now.spin.sgn(), (force * each / speed for each in velocity)
        turn, pull = -torque / of.moment, now.spin * now.spin
        free = (
            turn * rod[1] + pull * rod[0] - x / of.mass,
            pull * rod[1] - turn * rod[0] - y / of.mass,
        )
        f = impulses.force(of, rod, self.mode, free)
        along = arb(0) if self.mode is Mode.STICK else free[0] + impulses.response(of, rod, f)[0]
        turn += impulses.torque(rod, f) / of.moment
        return Forces(rod, velocity, free, f, turn, along, force * speed + torque * now.spin)

    def by_time(self, state: State) -> State:
        """Derivative of the state by time."""
        now = Now(*state)
        found = self.forces(now)
        (x, y), (w_x, w_y) = found.force, self.fence
        work = x * w_x + y * w_y
        return Now(
            now.spin, found.turn, found.along, now.rate, work, found.power, -x * now.rate, arb(1)
        )

    def by_decay(self, state: State) -> State:
        """Derivative by the falling logarithm of the rotation, for a state with its rate over the rotation.

        This ratio, and with it the direction of the motion, converges while the motion decays.
        """
        of_spin = Now(*state)
        now = of_spin._replace(rate=of_spin.rate * of_spin.spin)
        rates = Now(*self.by_time(now))
        if not rates.spin * now.spin < 0:
            raise Undecided("the rotation does not decrease while the motion decays")
        pace = -now.spin / rates.spin
        found = Now(*(each * pace for each in rates))
        return found._replace(rate=of_spin.rate - rates.rate / rates.spin)

    def rest(self, now: Now, scheme: Scheme) -> Now:
        """State in which a motion on a fence at rest has decayed."""
        state: State = now._replace(rate=now.rate / now.spin)
        for _ in range(DECAYS):
            state = advance(self.by_decay, state, arb(1), scheme)
        last = Now(*state)
        left = Now(*self.by_decay(state)).time
        return last._replace(spin=arb(0), rate=arb(0), time=last.time + left)

    def modes(self, now: Now) -> list[Mode]:
        """Consistent modes.

        Raises
        ------
        Undecided
            If the mode of the phase is not one of them.
        """
        found = self.forces(now)
        modes = impulses.consistent(self.of, found.rod, now.rate, found.free)
        if self.mode not in modes:
            raise Undecided(f"the mode {self.mode.name} ends")
        return modes
