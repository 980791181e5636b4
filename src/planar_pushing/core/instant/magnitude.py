"""The motions under forces of one direction and any magnitude.

With effects of several degrees, the direction of a motion changes with its magnitude. The motions are
ordered by their component along the line of force: the force increases with it, because Psi is convex.
"""

from __future__ import annotations

from math import atan2, copysign, exp, fabs, sinh, sqrt
from typing import NamedTuple

from planar_pushing.core.instant.directions import Direction, Rod
from planar_pushing.core.instant.force import (
    ContactMotion,
    mark_unsolved,
    motion_under_force,
    motions_under_force,
    replace_force,
    sticking_motion,
)
from planar_pushing.core.numbers import INFINITY, Numbers, zeros
from planar_pushing.core.supports.contact import Contact
from planar_pushing.core.supports.free import free_twist
from planar_pushing.core.supports.psi import psi
from planar_pushing.core.supports.resistance import kinetic_energy
from planar_pushing.core.supports.ring import ring_spin_ratio
from planar_pushing.core.supports.roots import (
    ITERATIONS,
    SECTIONS,
    Dip,
    best_number,
    is_narrow,
    narrow_bracket,
    narrow_dip,
    next_number,
    open_bracket,
    section_of,
)
from planar_pushing.core.supports.rows import (
    MASS,
    NO_POINT,
    RING,
    Effects,
    MassRow,
    Vector,
    column_of,
    is_steady,
    kind_of,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import RESOLUTION, RESOLVED, ROUNDING

#: Norms that fix the magnitude of the motion under a line of force: a unit component of the contact's
#: motion along the line, unit speed of the origin, the magnitude of the force, or the kinetic energy of a
#: unit translation.
UNIT_MOTION, UNIT_SPEED, FORCE_SIZE, UNIT_ENERGY = range(4)
#: Number of magnitudes at which the angle of the contact's motion is evaluated, on either side of the one
#: at which the effects have equal magnitudes. Their logarithms are hyperbolic sines of multiples of APART.
MAGNITUDES = 32
APART = 0.11
#: Logarithm of a component along the line of force at which inertia is negligible relative to friction.
LOWEST = -34.0
#: Number of steps between the two neighbors of a magnitude with an extreme angle.
FINER = 16
#: Offset that makes angles from the force positive.
POSITIVE = 2.0
#: Factor by which each step of the search for a bracket exceeds the last, and the largest magnitude of the
#: logarithm of the component along the line of force: beyond it, squares of motions overflow or underflow.
DOUBLING = 8.0
FARTHEST = 300.0


class ForceLine(NamedTuple):
    """A line of force at the contact, a norm of the motion under it, and the goal for this norm."""

    effects: Effects
    contact: Contact
    e_x: float
    e_y: float
    norm: int
    goal: float


def motion_of_size(line: ForceLine, z: float) -> ContactMotion:
    """The motion with a component exp(z) along the line of force."""
    return motion_under_force(line.effects, line.contact, line.e_x, line.e_y, exp(z))


def _excess(line: ForceLine, z: float) -> float:
    """Norm of the motion with a component exp(z) along the line of force, minus its goal."""
    motion = motion_of_size(line, z)
    if line.norm == UNIT_SPEED:
        return sqrt(motion.v_x * motion.v_x + motion.v_y * motion.v_y) - line.goal
    if line.norm == FORCE_SIZE:
        return sqrt(motion.f_x * motion.f_x + motion.f_y * motion.f_y) - line.goal
    return kinetic_energy(line.effects, motion.v_x, motion.v_y, motion.spin) - line.goal


def _motion_with_goal(line: ForceLine) -> ContactMotion:
    """The motion whose norm, which increases with z, equals the goal; not converged if there is none."""
    low, at_low, step = 0.0, _excess(line, 0.0), 1.0
    sense = -1.0 if at_low > 0.0 else 1.0
    high, at_high = low, at_low
    while at_low != 0.0 and (at_high > 0.0) == (at_low > 0.0):
        if fabs(high) == FARTHEST:
            return mark_unsolved(motion_of_size(line, high))
        low, at_low = high, at_high
        high = min(max(low + sense * step, -FARTHEST), FARTHEST)
        at_high, step = _excess(line, high), DOUBLING * step
    if at_low == 0.0:
        return motion_of_size(line, low)
    bracket = open_bracket(low, high, at_low, at_high, RESOLVED)
    for _ in range(ITERATIONS):
        z = next_number(bracket)
        bracket = narrow_bracket(bracket, z, _excess(line, z))
        if is_narrow(bracket):
            break
    return motion_of_size(line, best_number(bracket))


def _moves_freely(effects: Effects) -> bool:
    """Whether loads move the slider, because friction does not hold them."""
    twist = free_twist(effects, Vector(0.0, 0.0, 0.0))
    return twist.x != 0.0 or twist.y != 0.0 or twist.spin != 0.0


def _motion_of_force(line: ForceLine) -> ContactMotion:
    """The motion under a force together with loads that friction does not hold.

    The force counts as one more load, and the contact can move against it.
    """
    f_x, f_y, contact = line.goal * line.e_x, line.goal * line.e_y, line.contact
    twist = free_twist(line.effects, Vector(f_x, f_y, contact.x * f_y - contact.y * f_x))
    x, y = twist.x - twist.spin * contact.y, twist.y + twist.spin * contact.x
    root = psi(line.effects, contact, x, y, guess=twist.spin, point=NO_POINT, tolerance=ROUNDING)
    motion = replace_force(sticking_motion(x, y, root), f_x, f_y, half_x=0.0, half_y=0.0)
    moves: bool = twist.x != 0.0 or twist.y != 0.0 or twist.spin != 0.0
    return motion if moves else mark_unsolved(motion)


def motion_with_norm(
    effects: Effects, contact: Contact, force: Direction, norm: int, goal: float
) -> ContactMotion:
    """The motion under a force, of the magnitude that a norm fixes; not converged if the slider is held.

    With effects of one degree, a unit component of the contact's motion gives the same direction as a unit
    speed.
    """
    e_x, e_y = force.along, -force.across
    if norm == UNIT_SPEED:
        goal = 1.0
    elif norm == UNIT_ENERGY:
        goal = kinetic_energy(effects, 1.0, 0.0, 0.0)
    if norm == UNIT_MOTION or (norm == UNIT_SPEED and is_steady(effects)) or goal == 0.0:
        return motion_under_force(effects, contact, e_x, e_y, 1.0)
    line = ForceLine(effects, contact, e_x, e_y, norm, goal)
    if norm == FORCE_SIZE and _moves_freely(effects):
        return _motion_of_force(line)
    if norm == FORCE_SIZE and _excess(line, LOWEST) >= 0.0:
        return mark_unsolved(motion_of_size(line, LOWEST))
    return _motion_with_goal(line)


def is_ring_alone(effects: Effects) -> bool:
    """Whether the slider's own ring is the only effect."""
    return effects.length == 1 and kind_of(effects.data, 0) == RING


def motion_on_ring(rod: Rod, contact: Contact, force: Direction) -> ContactMotion:
    """The motion of a ring at unit speed, from the inverse of Eq. (7).

    The force, which is not computed, is along the center's motion.
    """
    ratio = ring_spin_ratio(rod.length * force.across)
    v_x, v_y, spin = force.along, -force.across, ratio
    if fabs(ratio) == INFINITY:
        v_x, v_y, spin = 0.0, 0.0, copysign(1.0, ratio)
    u_x, u_y = v_x - spin * contact.y, v_y + spin * contact.x
    return ContactMotion(
        u_x,
        u_y,
        v_x,
        v_y,
        spin,
        f_x=0.0,
        f_y=0.0,
        half_x=0.0,
        half_y=0.0,
        point=NO_POINT,
        continuum=False,
        noise_x=0.0,
        noise_y=0.0,
        converged=True,
    )


def ring_motion_angle(rod: Rod, force: Direction, spin_ratio: float) -> float:
    """Angle of the contact's motion, on the branch within 90 degrees of the force.

    The contact moves along ``f + k l (sin psi, -cos psi)`` (Eqs. 11-12 for inertia). Its deviation from
    `f` has a cosine proportional to ``1 + k l sin(psi - phi) >= 1``: the pusher never does negative work.
    """
    spin_lever = spin_ratio * rod.length
    if fabs(spin_lever) == INFINITY:
        sign = copysign(1.0, spin_lever)
        return force.angle - atan2(sign * force.along, sign * force.across)
    return force.angle - atan2(spin_lever * force.along, 1.0 + spin_lever * force.across)


def angle_from_force(motion: ContactMotion, e_x: float, e_y: float) -> float:
    """Angle from a line of force to the contact's motion, within 90 degrees."""
    return atan2(e_x * motion.u_y - e_y * motion.u_x, e_x * motion.u_x + e_y * motion.u_y)


class MotionAngles(NamedTuple):
    """Minimum and maximum angle of the contact's motion, and whether there are pivots or a continuum."""

    smallest: float
    largest: float
    pivots: bool
    continuum: bool
    converged: bool


def motion_angles(effects: Effects, rod: Rod, contact: Contact, force: Direction) -> MotionAngles:
    """`MotionAngles` under a force in one direction, over all magnitudes."""
    if is_ring_alone(effects):
        angle = ring_motion_angle(rod, force, ring_spin_ratio(rod.length * force.across))
        return MotionAngles(
            smallest=angle, largest=angle, pivots=False, continuum=False, converged=True
        )
    if is_steady(effects):
        return _angles_of_one_degree(effects, contact, force)
    slow = _angles_of_one_degree(scale_effects(effects, 1.0, 0.0), contact, force)
    fast = _angles_of_one_degree(scale_effects(effects, 0.0, 1.0), contact, force)
    # If the slow motions are a continuum, their limit is the one nearest to the fast motions.
    near = min(max(slow.smallest, fast.smallest), slow.largest)
    low, high = min(near, fast.smallest), max(near, fast.smallest)
    if not _is_isotropic(effects):
        line = ForceLine(
            effects, contact, e_x=force.along, e_y=-force.across, norm=UNIT_MOTION, goal=0.0
        )
        samples = zeros(2 * MAGNITUDES + 1)
        for i in range(2 * MAGNITUDES + 1):
            samples[i] = _angle_to(line, 1.0, _log_size(i)) - POSITIVE
        low = min(low, force.angle + _smallest_angle(line, 1.0, samples))
        for i in range(2 * MAGNITUDES + 1):
            samples[i] = -samples[i]
        high = max(high, force.angle - _smallest_angle(line, -1.0, samples))
    converged: bool = slow.converged and fast.converged
    return MotionAngles(
        smallest=low, largest=high, pivots=slow.pivots, continuum=False, converged=converged
    )


def _angles_of_one_degree(effects: Effects, contact: Contact, force: Direction) -> MotionAngles:
    """`MotionAngles` with effects of one degree."""
    e_x, e_y = force.along, -force.across
    ends = motions_under_force(effects, contact, e_x, e_y, 1.0)
    low, high = angle_from_force(ends.first, e_x, e_y), angle_from_force(ends.last, e_x, e_y)
    converged: bool = ends.first.converged and ends.last.converged
    return MotionAngles(
        smallest=force.angle + low,
        largest=force.angle + high,
        pivots=ends.first.point >= 0,
        continuum=ends.first.continuum,
        converged=converged,
    )


def _is_isotropic(effects: Effects) -> bool:
    """Whether the effects are the slider's ring and a mass at its center.

    The direction of the contact's motion then changes monotonically from slow to fast motions.
    """
    if effects.length != 2 or kind_of(effects.data, 0) != RING or kind_of(effects.data, 1) != MASS:
        return False
    body = MassRow(effects.row[column_of(effects.data, 1) :])
    return body.center_x == 0.0 and body.center_y == 0.0


def _angle_to(line: ForceLine, sense: float, z: float) -> float:
    """`POSITIVE` plus the angle from the force to the motion at z, counterclockwise for a sense of 1."""
    return POSITIVE + sense * angle_from_force(motion_of_size(line, z), line.e_x, line.e_y)


def _log_size(i: int) -> float:
    return sinh(float(i - MAGNITUDES) * APART)


def _smallest_angle(line: ForceLine, sense: float, samples: Numbers) -> float:
    """The minimum angle over all magnitudes, searched for in dips around samples and at both ends."""
    smallest = min(samples[0], samples[2 * MAGNITUDES])
    for i in range(1, 2 * MAGNITUDES):
        here, before, after = samples[i], samples[i - 1], samples[i + 1]
        level: bool = max(before, after) - here <= RESOLUTION
        if here <= before + RESOLUTION and here <= after + RESOLUTION and not level:
            smallest = min(
                smallest, _angle_in_dip(line, sense, _log_size(i - 1), _log_size(i + 1)) - POSITIVE
            )
    return smallest


def _angle_in_dip(line: ForceLine, sense: float, low: float, high: float) -> float:
    """The minimum angle in a dip, which can be narrow next to a plateau."""
    step = (high - low) / float(FINER)
    smallest, middle = INFINITY, low
    for i in range(1, FINER):
        angle = _angle_to(line, sense, low + float(i) * step)
        if angle < smallest:
            smallest, middle = angle, low + float(i) * step
    dip = Dip(middle - step, middle, middle + step, smallest)
    for _ in range(SECTIONS):
        z = section_of(dip)
        dip = narrow_dip(dip, z, _angle_to(line, sense, z))
        if dip.value < 0.0:
            break
    return dip.value
