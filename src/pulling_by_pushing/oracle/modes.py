"""Contact modes: every consistent solution for a pusher's motion from rest.

For effects of one degree the list is complete by convexity: the motion under each edge of the friction
cone is unique up to its scale, and so is the sticking motion. For the ring with friction and inertia the
slips are those of `complete`. A slip that coincides with sticking counts as sticking; slips that form a
continuum from rest to sticking are marked on the latter.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import (
    ZERO,
    Direction,
    Exact,
    Number,
    Undecided,
    cone_edge,
    cross,
    settle,
    sign,
)
from pulling_by_pushing.oracle.complete import ONLY_A_RING, path
from pulling_by_pushing.oracle.exact import exact_motion, is_tangent, ring_radius
from pulling_by_pushing.oracle.motions import ray, stick
from pulling_by_pushing.oracle.pivots import clip
from pulling_by_pushing.oracle.prove import (
    Proved,
    Slider,
    State,
    force_along,
    krawczyk,
    moves,
    torque,
    with_roundings,
)


class Mode(IntEnum):
    """Contact modes in the order of the datasets."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3


#: Directions along and across the fence.
FENCE, NORMAL = (fmpq(1), ZERO), (ZERO, fmpq(1))
#: Edge on which the force of a slip lies: 1 is the right edge, -1 the left one.
SLIPS = {Mode.SLIP_RIGHT: -1, Mode.SLIP_LEFT: 1}


@dataclass(frozen=True, slots=True)
class Law:
    """Contact law: friction coefficient, whether its cone is closed, and whether it is adhesive."""

    friction_coefficient: float
    closed: bool = True
    adhesive: bool = False

    @property
    def slips(self) -> bool:
        """Whether the contact can slip under a force on an edge."""
        return self.closed and not self.adhesive


#: The laws of infinite friction, definitions 1 and 2 of Sec. 5, and kinematic roughness.
INFINITE_FREE, INFINITE_NONE = Law(math.inf), Law(math.inf, closed=False)
PERFECTLY_ROUGH = Law(math.inf, adhesive=True)


@dataclass(frozen=True, slots=True)
class Solution:
    """A mode with its motion and force; None at rest. `end` is the other end of an interval of forces."""

    mode: Mode
    motion: Proved | None = None
    end: Proved | None = None
    continuum: bool = False


def contact_modes(slider: Slider, law: Law, pusher: Direction, size: fmpq) -> list[Solution]:
    """Every consistent solution, in the order of modes, slowest first.

    Raises
    ------
    Undecided
        If rounding decides on a mode, or no completeness is known for the effects.
    """
    return list(_solutions(slider, law, pusher, size))


def _solutions(slider: Slider, law: Law, pusher: Direction, size: fmpq) -> Iterator[Solution]:
    towards = pusher.along(NORMAL)
    if towards <= 0:
        yield Solution(Mode.SEPARATE)
    ends = stick(slider, pusher, size)
    admitted, on_edge = (ends, False) if law.adhesive else _admit(slider, law, *ends)
    along_fence = towards == 0 and law.slips
    continuum = along_fence and _is_continuum(slider, law, pusher, admitted is not None and on_edge)
    if admitted is not None:
        yield Solution(Mode.STICK, *admitted, continuum=continuum)
    if not law.slips or continuum:
        return
    for mode, side in SLIPS.items():
        force = cone_edge(law.friction_coefficient, side)
        if _is_steady(slider, force):
            yield from _steady_slips(slider, mode, force, pusher, size, towards)
        else:
            yield from _slips(slider, mode, force, pusher, size, towards)


def _is_steady(slider: Slider, force: Direction) -> bool:
    """Whether multiples of a motion keep the direction of their force: friction and inertia turn alike."""
    body, e = slider.body, force.about(slider.rod_angle)
    if body.weight == 0 or body.mass == 0:
        return True
    if ring_radius(body) is None:
        raise Undecided(ONLY_A_RING)
    return e.across((body.length, ZERO)) == 0 or is_tangent(body, e)


def _admit(
    slider: Slider, law: Law, low: Proved, high: Proved
) -> tuple[tuple[Proved, Proved] | None, bool]:
    """The forces of a sticking motion that lie in the cone, and whether one lies on an edge."""
    if low.pivot >= 0:
        return _admit_pivot(slider, law.friction_coefficient, low, high)
    on_edge = False
    for side in (1, -1):
        edge = cone_edge(law.friction_coefficient, side)
        force, edge_exact = low.exact, edge.exact
        exact = (
            None
            if force is None or edge_exact is None
            else lambda f=force, k=edge_exact: cross(k, f)
        )
        depth = settle(_depth(slider, edge, side, low), exact)
        if depth < 0 or (depth == 0 and not law.closed):
            return None, False
        on_edge = on_edge or depth == 0
    if law.friction_coefficient == 0 and settle(_normal_force(slider, low)) < 0:
        return None, False  # opposite to the only direction
    return (low, high), on_edge


def _admit_pivot(
    slider: Slider, friction_coefficient: float, low: Proved, high: Proved
) -> tuple[tuple[Proved, Proved] | None, bool]:
    """The part of an interval of forces that lies in the cone; for mu = 0 and infinity it has one side."""
    ends, on_edge, single = [low, high], False, friction_coefficient in (0.0, math.inf)
    for side in (1,) if single else (1, -1):
        edge = cone_edge(friction_coefficient, side)
        depths = [settle(_depth(slider, edge, side, end)) for end in ends]
        outside = min(depths) > 0 if friction_coefficient == 0 else False
        if max(depths) <= 0 or outside:
            return None, False
        bound = edge.about(slider.rod_angle)
        for i, depth in enumerate(depths):
            if depth < 0 or friction_coefficient == 0:
                ends[i], on_edge = clip(ends[i], slider.body, bound), True
    if friction_coefficient == 0 and settle(_normal_force(slider, ends[0])) < 0:
        return None, False
    return (ends[0], ends[1]), on_edge


def _depth(slider: Slider, edge: Direction, side: int, end: Proved) -> Number:
    """Component of a force toward the inside of an edge of the cone."""
    x, y = edge.ball

    def depth(state: State) -> list[arb]:
        return [side * cross((x, y), state.to_fence(state.f_x, state.f_y))]

    number = end.numbers(slider, depth)[0]
    size = abs(end.force[0]) + abs(end.force[1])
    return Number(number.ball, number.rounding + edge.roundings * size)


def _normal_force(slider: Slider, end: Proved) -> Number:
    return end.numbers(slider, lambda state: [state.to_fence(state.f_x, state.f_y)[1]])[0]


def _is_continuum(slider: Slider, law: Law, pusher: Direction, on_edge: bool) -> bool:
    """Whether the pusher moves along the fence and all slips from rest up to sticking are consistent."""
    body = slider.body
    if body.weight == 0 or body.mass == 0:
        return on_edge
    return any(
        _keeps_to_fence(slider, cone_edge(law.friction_coefficient, side), pusher)
        for side in (1, -1)
    )


def _keeps_to_fence(slider: Slider, force: Direction, pusher: Direction) -> bool:
    """Whether the contact moves with the pusher along the fence under a force, at any speed."""
    if not _is_steady(slider, force):
        motions = path(slider, force)
        if not (motions.stays and motions.lever.is_zero()):
            return False
        towards = force.ball[0]
        return sign(towards) == pusher.along(FENCE)
    motion = ray(slider, force)
    normal, exact = normal_motion(slider, motion)
    if settle(normal, exact) != 0:
        return False
    return sign(motion.numbers(slider, lambda s: s.to_fence(s.u_x, s.u_y))[0].ball) == pusher.sign(
        lambda x, _: x
    )


def normal_motion(slider: Slider, motion: Proved) -> tuple[Number, Any]:
    """Normal motion of the contact, and its exact multiple or None."""
    world = motion.exact
    number = motion.numbers(slider, lambda state: [state.to_fence(state.u_x, state.u_y)[1]])[0]
    return number, None if world is None else lambda: world[1]


def _steady_slips(
    slider: Slider, mode: Mode, force: Direction, pusher: Direction, size: fmpq, towards: int
) -> Iterator[Solution]:
    """The slip under an edge whose force sustains a motion at any speed."""
    motion, side = ray(slider, force), SLIPS[mode]
    normal, exact = normal_motion(slider, motion)
    if not towards or settle(normal, exact) != towards:
        return
    world, pusher_exact = motion.exact, pusher.exact
    exact = None if world is None or pusher_exact is None else lambda: cross(world, pusher_exact)
    w = pusher.ball
    turn = motion.numbers(slider, lambda s: [cross(s.to_fence(s.u_x, s.u_y), w)])[0]
    speed = abs(motion.q[0]) + abs(motion.q[1])
    turn = Number(turn.ball, turn.rounding + pusher.roundings * speed)
    if settle(turn, exact) * towards * side < 0:
        yield Solution(mode, *(_at_speed(slider, force, pusher, size, motion),) * 2)


def _at_speed(
    slider: Slider, force: Direction, pusher: Direction, size: fmpq, motion: Proved
) -> Proved:
    """The multiple of a motion under an edge that keeps the contact on the fence, with its force."""
    body, e = slider.body, force.about(slider.rod_angle)
    cosine, sine = slider.rod
    normal = motion.q[0] * sine + motion.q[1] * cosine
    factor = size * pusher.ball[1] / normal
    q = [factor * part for part in motion.q]
    level = moves((sine, cosine, 0), size * pusher.ball[1], pusher.roundings + e.roundings)
    if motion.pivot < 0 and not is_tangent(body, e):
        equations = [torque, force_along(e.ball, e.roundings), level]
        return with_roundings(body, equations, q, body.wrench(q), motion.exact)
    # The same motion at another speed: shifts of the motion scale, and those of friction do not.
    force_x, force_y = motion.force
    linear = [sum((a * b for a, b in zip(row, q, strict=True)), arb(0)) for row in body.matrix[:2]]
    first = [
        sum((a * b for a, b in zip(row, motion.q, strict=True)), arb(0)) for row in body.matrix[:2]
    ]
    total_force = force_x + linear[0] - first[0], force_y + linear[1] - first[1]
    shifts = [[*(factor * part for part in shift[:3]), *shift[3:]] for shift in motion.shifts]
    shifts.append([*(pusher.roundings * abs(part) for part in q), arb(0), arb(0)])
    return Proved(q, total_force, shifts, motion.pivot, motion.exact)


def _slips(
    slider: Slider, mode: Mode, force: Direction, pusher: Direction, size: fmpq, towards: int
) -> Iterator[Solution]:
    """Slips of a ring with friction and inertia under an edge, each next to a guess of its spin ratio."""
    body, e, side = slider.body, force.about(slider.rod_angle), SLIPS[mode]
    motions, (x, y), (cosine, sine) = path(slider, force), e.ball, slider.rod
    level = size * pusher.ball[1] if towards else fmpq(0)
    spins = motions.spins(arb(level)) if towards else motions.spins_along_fence()
    radius, rotations = ring_radius(body), list[arb]()
    assert radius is not None
    for k in spins:
        speed = level / motions.advance(k) if towards else motions.speed(k)
        turn = motions.side * speed * k / radius
        guess = [speed * x, speed * y - turn * body.length, turn]
        equations = [
            torque,
            force_along(e.ball, e.roundings),
            moves((sine, cosine, 0), level, pusher.roundings + e.roundings),
        ]
        q, wrench = krawczyk(body, equations, guess)
        if any(q[2].overlaps(other) for other in rotations):
            raise Undecided("two slips under an edge cannot be distinguished")
        rotations.append(q[2])
        motion = with_roundings(body, equations, q, wrench)
        if not wrench.value[0] * x + wrench.value[1] * y > 0:
            raise Undecided("a slip under a force opposite to an edge")
        w, exact = size * pusher.ball[0], exact_motion(body, e)
        zero_slip = (
            None if exact is None or pusher.exact is None else _coincide(exact, pusher.exact)
        )
        pace = motion.numbers(slider, lambda s: [s.to_fence(s.u_x, s.u_y)[0]])[0]
        slip = Number(pace.ball - w, pace.rounding + pusher.roundings * abs(w))
        if settle(slip, zero_slip) * side < 0:
            yield Solution(mode, motion, motion)


def _coincide(motion: tuple[Exact, Exact], pusher: tuple[Exact, Exact]) -> Callable[[], Exact]:
    """A number that vanishes if a motion is along that of the pusher."""
    return lambda: cross(motion, pusher)
