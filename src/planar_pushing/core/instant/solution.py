"""A solution of a push, as a row of numbers in the frame of the contact."""

from __future__ import annotations

from math import fabs
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.directions import Direction
from planar_pushing.core.instant.force import ContactMotion
from planar_pushing.core.instant.slips import SLIPS
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.contact import Contact
from planar_pushing.core.supports.rows import Effects

#: Contact modes.
SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT = range(4)
#: Maximum number of solutions of one push: separate, stick, and the slips under each edge.
MOST_SOLUTIONS = 2 + 2 * SLIPS
#: Replaces the number of solutions if an iteration has not converged or there are more slips than fit.
UNSOLVED = -1


class Pair(Record):
    """Components of a vector along x and y."""

    x: float
    y: float


class Twist(Pair):
    """A twist: the velocity of a point, and the angular velocity."""

    spin: float


class Solution(Record):
    """A solution.

    Attributes
    ----------
    mode : int
    twist : Twist
        Of the slider's origin.
    motion, force, force_end : Pair
        Motion of the contact; the force, and the other end of its interval.
    pivot : int
        Number of the support point that is the pivot, -1 without one.
    continuum : bool
        Whether it is an end of a continuum.
    start_force, end_force : float
        For a side on the fence, the normal forces at its ends.
    """

    mode: int
    twist: Twist
    motion: Pair
    force: Pair
    force_end: Pair
    pivot: int
    continuum: bool
    start_force: float
    end_force: float


SOLUTION = size_of(Solution)


class Push(NamedTuple):
    """A push in the body frame: effects, contact, and the tangent of the pusher there.

    The normal is the tangent rotated by +90 degrees.
    """

    effects: Effects
    contact: Contact
    t_x: float
    t_y: float


def write_solution(push: Push, mode: int, motion: ContactMotion, solution: Solution) -> None:
    """Write a motion as a solution."""
    t_x, t_y = push.t_x, push.t_y
    solution.mode, solution.pivot = mode, motion.point
    solution.continuum = motion.continuum
    solution.twist.x = t_x * motion.v_x + t_y * motion.v_y
    solution.twist.y = t_x * motion.v_y - t_y * motion.v_x
    solution.twist.spin = motion.spin
    solution.motion.x = t_x * motion.u_x + t_y * motion.u_y
    solution.motion.y = t_x * motion.u_y - t_y * motion.u_x
    f_x, f_y = motion.f_x - motion.half_x, motion.f_y - motion.half_y
    solution.force.x, solution.force.y = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x
    f_x, f_y = motion.f_x + motion.half_x, motion.f_y + motion.half_y
    solution.force_end.x, solution.force_end.y = t_x * f_x + t_y * f_y, t_x * f_y - t_y * f_x


def write_on_edge(
    push: Push, mode: int, motion: ContactMotion, edge: Direction, solution: Solution
) -> None:
    """Write a motion whose force is along an edge, without the rounding errors of the body frame.

    An interval of forces is written from its smaller end; forces that would pull are not in it.
    """
    write_solution(push, mode, motion, solution)
    force, half = force_along(edge, motion), half_along(edge, motion)
    smaller, larger = force - half, force + half
    if smaller <= motion.noise_x + motion.noise_y:
        smaller = 0.0
    solution.force.x, solution.force.y = smaller * edge.x, smaller * edge.y
    solution.force_end.x, solution.force_end.y = larger * edge.x, larger * edge.y


def force_along(edge: Direction, motion: ContactMotion) -> float:
    """The force along an edge, negative against it."""
    return edge.along * motion.f_x - edge.across * motion.f_y


def half_along(edge: Direction, motion: ContactMotion) -> float:
    """Half of the interval of forces along an edge."""
    return fabs(edge.along * motion.half_x - edge.across * motion.half_y)


def copy_solution(target: Numbers, source: Numbers) -> None:
    """Overwrite a solution with another one."""
    for k in range(SOLUTION):
        target[k] = source[k]


def shrink_solution(solution: Solution, motion: float, force: float) -> None:
    """Scale the magnitudes of a motion and its force."""
    for k in range(3):
        solution.twist[k] = motion * solution.twist[k]
    for k in range(2):
        solution.motion[k] = motion * solution.motion[k]
        solution.force[k] = force * solution.force[k]
        solution.force_end[k] = force * solution.force_end[k]
