"""Contact modes with any effects: every consistent solution for a pusher motion from rest."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Exact, Undecided, rational, sign
from planar_pushing.certified.contact.modes import SLIPS, Law, Mode
from planar_pushing.certified.effects.rest import free_normal, is_held
from planar_pushing.certified.effects.slips import Slip, slips
from planar_pushing.certified.effects.steady import steady_foot, steady_slips
from planar_pushing.certified.effects.under import Moved, is_straight, under
from planar_pushing.certified.effects.way import Way, line
from planar_pushing.certified.potential import collinear
from planar_pushing.certified.potential import direction as directions
from planar_pushing.certified.potential.direction import Direction, relative, returned
from planar_pushing.certified.potential.precision import COARSE, decided
from planar_pushing.certified.potential.push import Push
from planar_pushing.certified.potential.resistance import Resistance, Scene, resistance
from planar_pushing.certified.potential.sticking import NOTHING, Stuck, is_across, stick
from planar_pushing.certified.supports.pressure.moments import Vector

ONE = fmpq(1)
FENCE, NORMAL = directions.degrees(fmpq(0)), directions.degrees(fmpq(90))


@dataclass(frozen=True, slots=True)
class Solution:
    """A consistent solution, in the frame of the fence.

    Attributes
    ----------
    mode : Mode
    motion : tuple of arb
        Motion of the contact; NaN if the slider leaves the pusher, where it is not computed.
    spin : arb
        Rotation.
    force : tuple of arb
        Force of the pusher; for a sticking pivot, the middle of the interval of forces.
    free : tuple of arb
        Half of that interval, otherwise zero.
    pivot : int
        Index of the support's point that is the center of rotation, -1 if there is none.
    continuum : bool
        Whether every slip from rest up to this solution is a solution too.
    """

    mode: Mode
    motion: Vector
    spin: arb
    force: Vector
    free: Vector = NOTHING
    pivot: int = -1
    continuum: bool = False


def edge(law: Law, side: int) -> Direction:
    """Edge of the friction cone, 1 for the right and -1 for the left one."""
    if law.friction_coefficient == math.inf:
        return directions.degrees(fmpq(90 - 90 * side))
    return directions.along(side * rational(law.friction_coefficient), fmpq(1))


def modes(
    scene: Scene, law: Law, pusher: Direction, size: fmpq, precisions: Sequence[int] = COARSE
) -> list[Solution]:
    """Every consistent solution, ordered by mode, and within a mode by distance from sticking.

    Parameters
    ----------
    scene : Scene
    law : Law
    pusher : Direction
        Direction of the pusher's motion, in the frame of the fence.
    size : fmpq
        Magnitude of the pusher's motion, > 0.
    precisions : sequence of int
        In bits, tried in turn.

    Raises
    ------
    Undecided
        If a coincidence is not decided at any precision, for example a force on an edge that is not
        known to be exactly there, or if a load moves the slider against friction alone.
    """

    def found() -> list[Solution]:
        return list(_solutions(_Problem(resistance(scene), scene, law, pusher, size)))

    return decided(found, precisions)


class _Problem(NamedTuple):
    total: Resistance
    scene: Scene
    law: Law
    pusher: Direction
    size: fmpq

    @property
    def moves(self) -> int:
        """Sign of the pusher's normal motion."""
        exact = self.pusher.exact
        return sign(self.pusher.ball()[1], None if exact is None else lambda: exact[1])

    @property
    def normal(self) -> arb | fmpq:
        """The pusher's normal motion, an exact zero along the fence."""
        return self.pusher.ball()[1] * self.size if self.moves else fmpq(0)

    @property
    def push(self) -> Push:
        """The pusher's motion in the body frame."""
        return self.total.push(relative(self.pusher, self.scene.rod))

    @property
    def way(self) -> Way:
        """Contact motions with the pusher's normal component."""
        toward, normal = (
            self.total.push(relative(each, self.scene.rod)) for each in (FENCE, NORMAL)
        )
        return Way(self.total, line(normal, self.normal), toward)

    @property
    def is_even(self) -> bool:
        """Whether all forces are along the fence, by symmetry, while the contact moves along it."""
        return self.moves == 0 and is_across(self.push) and self.total.is_even()


@lru_cache(maxsize=1 << 12)
def _stuck(scene: Scene, pusher: Direction, size: fmpq, precision: int) -> Stuck:
    """The sticking motion, which different laws share."""
    total = resistance(scene)
    return stick(total, total.push(relative(pusher, scene.rod)), size)


@lru_cache(maxsize=1 << 12)
def _loaded(scene: Scene, friction_coefficient: float, side: int, precision: int) -> Moved:
    """The motion under the force of an edge of the friction cone, which different pushers share."""
    total, bound = resistance(scene), edge(Law(friction_coefficient), side)
    return under(total, total.push(relative(bound, scene.rod)), ONE)


def _solutions(problem: _Problem) -> Iterator[Solution]:
    law, total = problem.law, problem.total
    yield from _separate(problem)
    push = problem.push
    stuck = _stuck(problem.scene, problem.pusher, problem.size, ctx.prec)
    admitted, on_edge = _admits(problem, stuck)
    # Slips from rest up to sticking, all under forces on an edge.
    along = problem.moves == 0 and (total.is_steady or problem.is_even)
    continuum = admitted and on_edge and along and law.slips
    if law.adhesive or admitted:
        motion = returned((push.x * problem.size, push.y * problem.size), total.rod)
        force, free = (returned(each, total.rod) for each in (stuck.force, stuck.free))
        yield Solution(Mode.STICK, motion, stuck.spin, force, free, stuck.pivot, continuum)
    if law.slips and not (problem.moves == 0 and total.is_steady) and not continuum:
        for mode, side in SLIPS.items():
            yield from _slips(problem, mode, side)


def _separate(problem: _Problem) -> Iterator[Solution]:
    """Separation: the slider moves freely, and the pusher does not catch up."""
    if is_held(problem.total):
        if problem.moves <= 0:
            yield Solution(Mode.SEPARATE, NOTHING, arb(0), NOTHING)
        return
    if problem.total.mass == 0:
        raise Undecided("the load moves the slider against friction alone")
    normal = relative(NORMAL, problem.scene.rod)
    if sign(free_normal(problem.total, normal, problem.normal)) <= 0:
        unknown = arb.nan(), arb.nan()
        yield Solution(Mode.SEPARATE, unknown, arb.nan(), NOTHING)


def _admits(problem: _Problem, stuck: Stuck) -> tuple[bool, bool]:
    """Whether a force of a sticking motion lies in the cone, and whether one lies on an edge."""
    law, low, high = problem.law, arb(-1), arb(1)
    force, free = (returned(each, problem.total.rod) for each in (stuck.force, stuck.free))
    exact = problem.pusher.exact if stuck.straight else None
    inside = []
    for side in (1, -1):
        bound = edge(law, side)
        depth, change = (side * _cross(bound.ball(), each) for each in (force, free))
        if stuck.pivot < 0:
            inside.append(sign(depth, _exact_depth(bound, side, exact)))
        elif sign(change) > 0:
            low = arb.max(low, -depth / change)
        else:
            high = arb.min(high, -depth / change)
    if stuck.pivot >= 0:
        return sign(high - low) > 0, low > -1 or high < 1
    if min(inside) < 0 or (min(inside) == 0 and not law.closed):
        return False, False
    return law.friction_coefficient > 0 or sign(force[1]) > 0, min(inside) == 0


def _cross(a: tuple[Exact, Exact], b: tuple[Exact, Exact]) -> Exact:
    return a[0] * b[1] - a[1] * b[0]


def _exact_depth(
    bound: Direction, side: int, exact: tuple[Exact, Exact] | None
) -> Callable[[], Exact] | None:
    if exact is None or bound.exact is None:
        return None
    known = bound.exact
    return lambda: side * _cross(known, exact)


def _slips(problem: _Problem, mode: Mode, side: int) -> Iterator[Solution]:
    """Slips of a mode, with the force on the edge of one side and the slip toward the other side."""
    total, way = problem.total, problem.way
    loaded = relative(edge(problem.law, side), problem.scene.rod).ball()
    stick_place = problem.pusher.ball()[0] * problem.size
    found: Iterable[Slip]
    foot = steady_foot(way)
    if problem.moves and total.is_steady:
        found = _ray(problem, side)
    elif foot >= 0:
        found = steady_slips(way, loaded, stick_place, -side, foot, problem.is_even)
    elif problem.is_even:
        found = ()
    else:
        found = slips(way, loaded, stick_place, -side)
    for each in found:
        motion, force = (returned(vector, total.rod) for vector in (each.motion, each.force))
        yield Solution(mode, motion, each.spin, force, NOTHING, each.pivot, continuum=foot >= 0)


def _across_rod(problem: _Problem, found: Moved) -> tuple[Exact, Exact] | None:
    """A positive multiple of the motion of a contact that rotates about a foot on the rod's line."""
    rod = problem.scene.rod.exact
    if rod is None or found.pivot < 0:
        return None
    x, y = problem.total.foot(found.pivot)
    if y:
        return None
    turn = -sign(found.spin) if x > 0 else sign(found.spin)
    return -turn * rod[1], turn * rod[0]


def _ray(problem: _Problem, side: int) -> Iterator[Slip]:
    """The slip of effects of one degree: a force on an edge sustains any multiple of a motion."""
    total, bound = problem.total, edge(problem.law, side)
    push = total.push(relative(bound, problem.scene.rod))
    straight = is_straight(total, push, ONE)
    if straight and total.weight != 0 and collinear.crossed(push) is not None:
        raise Undecided("a corner: one force allows an interval of motions")
    found = _loaded(problem.scene, problem.law.friction_coefficient, side, ctx.prec)
    parallel = straight or (is_across(push) and total.is_even())
    exact = bound.exact if parallel else _across_rod(problem, found)
    motion = bound.ball() if parallel else returned(found.motion, total.rod)
    if sign(motion[1], None if exact is None else lambda: exact[1]) != problem.moves:
        return
    over = sign(_cross(motion, problem.pusher.ball()), _exact_depth(problem.pusher, -1, exact))
    if over * problem.moves * side >= 0:
        return
    scale = problem.normal / (motion[1] if parallel else returned(found.motion, total.rod)[1])
    if parallel:
        scale = scale * (motion[0] ** 2 + motion[1] ** 2)
    x, y = (each * scale for each in found.motion)
    size = found.force * (scale if total.weight == 0 else 1)
    yield Slip(arb(0), (x, y), found.spin * scale, (size * push.x, size * push.y), found.pivot)
