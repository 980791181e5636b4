"""Where Newton's method starts: below the potential of a rotation about any point of the support.

The potential has a kink at each of them, and a method that only falls would stay at one. Started below, it
never comes there.
"""

from __future__ import annotations

import math

from flint import arb, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.supports.pressure.moments import moments
from planar_pushing.certified.supports.pressure.pieces import Point
from planar_pushing.certified.supports.problem import Motion, Problem

#: Square of the radius of gyration that stands for a support in a first guess, in its extents.
ROUGH = fmpq(61, 100)
#: Halvings of a step away from a point.
HALVINGS = 40


def start(problem: Problem) -> Motion:
    """The motion of least potential among a first guess and those beside the points."""
    beside = (_beside(problem, point) for point in problem.support.points)
    found = [_guess(problem), *(each for each in beside if each is not None)]
    return min(found, key=lambda at: float(problem.evaluate(at).power))


def _guess(problem: Problem) -> Motion:
    """The motion as if the support were a mass."""
    x, y = (arb(each) for each in problem.support.center)
    r_x, r_y = -problem.length - x, -y
    arm = r_x * problem.t[1] - r_y * problem.t[0]
    extent = problem.support.extent
    spin = arm / (ROUGH * extent * extent + arm * arm)
    return Motion((spin * (r_x * problem.t[0] + r_y * problem.t[1])).mid(), spin.mid())


def _beside(problem: Problem, point: Point) -> Motion | None:
    """The motion of least potential on the way of steepest descent from a rotation about a point.

    Its own velocity v costs the point its share times |v|, and the rest of the support falls by e . v.
    """
    (t_x, t_y), c = problem.t, (arb(point.place[0]), arb(point.place[1]))
    r_x, r_y = c[0] + problem.length, c[1]
    arm = t_x * r_y - t_y * r_x
    if arm.contains(0):
        return None
    at = Motion((-(t_x * r_x + t_y * r_y) / arm).mid(), (1 / arm).mid())
    sense = 1 if at.spin > 0 else -1
    rest = moments(problem.support, c)
    one, other = (sense * each for each in problem.equations(rest, c))
    # v = a n + omega J r, so that e . n and e . J r are the slopes, and the way is along v = -e.
    e_x, e_y = (r_x * one - t_x * other) / arm, (r_y * one - t_y * other) / arm
    step = Motion(-(r_x * e_x + r_y * e_y) / arm, (t_x * e_x + t_y * e_y) / arm)
    return _lowest(problem, at, step)


def _lowest(problem: Problem, at: Motion, step: Motion) -> Motion | None:
    """The motion of least potential, which is convex along the way."""
    found, least = None, math.inf
    for i in range(HALVINGS):
        tried = at.after(step, arb(2) ** (4 - i))
        try:
            power = float(problem.evaluate(tried).power)
        except Undecided:
            continue
        if power >= least:
            break
        found, least = tried, power
    return found
