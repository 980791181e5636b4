"""The pressure with a given center that adds most to a load at a given rotation: a linear program.

The unknowns are the pressures of points of a finite set, to which those points are added at which the dual
solution is violated most, until none is (an exchange method). The results are a pressure on at most four
points, and the multiplier of a bound that `certificates` proves; nothing here needs to be exact.
Programs of three or four rows are solved from the basis of the one before. HiGHS, which scipy offers, gives
up on bases as degenerate as those of a center of pressure on the rim of the base.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.stability.base_region import Base, Ints

#: Points on each curve at first, and doublings of the distance from the nearest to the center of rotation.
POINTS, DOUBLINGS = 33, 20
#: Maximum number of exchanges, and the violation below which rounding may stall them.
EXCHANGES, STALLED = 25, 1e-9
#: Prices of a moment that is not balanced, the second where the first is too low, and of a torque. They
#: bound the multipliers, which are not unique for a center of pressure on the rim of the hull.
MOMENT_PRICES, TORQUE_PRICE = (30.0, 1e4), 100.0
#: Gain by which a column enters a basis; maximum number of pivots, and of those before
#: Bland's rule, which ends cycles.
GAINS, PIVOTS, BLAND = 1e-13, 200, 60
#: Smallest pivot, and largest error of the mass and the center of a pressure.
PIVOT, EXACT = 1e-10, 1e-12
#: Directions of the force at the center of rotation, at first.
FORCES = 8
#: Smallest pressure of a point, and smallest speed of one that is not at the center of rotation.
LIGHTEST, SLOWEST = 1e-12, 1e-13
#: Reductions by a factor of four of the interval in which a point is sought.
REDUCTIONS = 14


class Pressure(NamedTuple):
    """Pressures on points; the shares, shape (n,), add up to 1."""

    points: Array
    shares: Array


class Optimum(NamedTuple):
    """A pressure, the multiplier of its bound, its value, and whether it has the mass and the center."""

    pressure: Pressure
    multiplier: Array
    value: float
    exact: bool


@dataclass(eq=False)
class Candidates:
    """Points on the curves of a base, to which each program adds those that it needs."""

    base: Base
    number: Ints
    along: Array

    @classmethod
    def of(cls, base: Base) -> Candidates:
        """Points at equal distances on each curve, and those at which the center of rotation may arrive."""
        (number, along), (crossing, position) = spread_points(base), base.crossings()
        return cls(
            base,
            np.concatenate([number.ravel(), crossing]),
            np.concatenate([along.ravel(), position]),
        )

    def add(self, number: Ints, along: Array) -> None:
        """Keep points."""
        self.number = np.concatenate([self.number, number])
        self.along = np.concatenate([self.along, along])


class _Columns(NamedTuple):
    """Points and the unit forces there."""

    points: Array
    forces: Array

    def join(self, other: _Columns) -> _Columns:
        return _Columns(*(np.concatenate(parts) for parts in zip(self, other, strict=True)))


def largest(
    candidates: Candidates, eta: float, direction: Array, torque: float | None, enough: float
) -> Optimum:
    """The pressure with the largest component of the force along d, plus a multiple of its torque.

    Parameters
    ----------
    candidates : Candidates
    eta : float
        The rotation.
    direction : ndarray, shape (2,)
    torque : float or None
        Factor of the torque about the contact; if None, the torque has to vanish.
    enough : float
        Violation of the bound at which the exchange ends.
    """
    base = candidates.base
    near = _near_center(base, eta)
    columns = _columns_in_motion(
        base, eta, base.curves.points(candidates.number, candidates.along)[0]
    )
    columns = columns.join(_columns_in_motion(base, eta, base.curves.points(*near)[0]))
    if base.areas.contain(base.center[None])[0]:
        columns = columns.join(_columns_in_motion(base, eta, base.center[None]))
    middle = _center_column(base, eta)
    if middle is not None:
        angles = 2.0 * np.pi * np.arange(FORCES) / FORCES
        columns = columns.join(_Columns(
            np.tile(middle, (FORCES, 1)), np.column_stack([np.cos(angles), np.sin(angles)])
        ))  # fmt: skip
    for price in MOMENT_PRICES:
        program = _Program(base, direction, torque, price)
        program.extend(columns)
        optimum = _exchange_points(program, candidates, near, eta, middle, enough)
        if optimum.exact:
            break
    return optimum


def _exchange_points(
    program: _Program, candidates: Candidates, near: tuple[Ints, Array], eta: float,
    middle: Array | None, enough: float,
) -> Optimum:  # fmt: skip
    """The optimum of a program, to which the points are added that its bound leaves out."""
    base, direction = candidates.base, program.direction
    best, min_violation = program.solve(), np.inf
    for _ in range(EXCHANGES):
        optimum = program.solve()
        number, along, violation = _violations(base, near, eta, direction, optimum.multiplier)
        program.extend(_columns_in_motion(base, eta, base.curves.points(number, along)[0]))
        candidates.add(number, along)
        if middle is not None:
            vector = direction + optimum.multiplier[3] * np.array([-middle[1], middle[0]])
            size = float(np.hypot(*vector))
            off = size - float(optimum.multiplier[0] + optimum.multiplier[1:3] @ middle)
            if off > enough:
                violation = max(violation, off)
                program.extend(_Columns(middle[None], vector[None] / size))
        stalls = violation > min_violation / 2.0 and min_violation < STALLED
        if violation < min_violation:
            best, min_violation = optimum, violation
        if violation <= enough or stalls:
            break
    return best


def spread_points(base: Base) -> tuple[Ints, Array]:
    """Points at equal distances on each curve, as arrays of shape (curves, `POINTS`)."""
    count = len(base.curves.length)
    number = np.repeat(np.arange(count)[:, None], POINTS, axis=1)
    return number, base.curves.length[:, None] * np.linspace(0.0, 1.0, POINTS)


def _near_center(base: Base, eta: float) -> tuple[Ints, Array]:
    """Sorted points on each curve: at equal distances, and denser near the center of rotation."""
    number, along = spread_points(base)
    if eta:
        position, distance = base.curves.nearest(base.path / np.tan(eta))
        steps = np.maximum(distance, 1e-6)[:, None] * 2.0 ** np.arange(-2, DOUBLINGS - 2)
        close = np.concatenate(
            [position[:, None] - steps, position[:, None], position[:, None] + steps], axis=1
        )
        length, closed = base.curves.length[:, None], base.curves.radius[:, None] > 0.0
        around = np.mod(close, np.where(closed, length, 1.0))
        close = np.where(closed, around, np.clip(close, 0.0, length))
        along = np.concatenate([along, close], axis=1)
    along = np.sort(along, axis=1)
    return np.repeat(number[:, :1], along.shape[1], axis=1), along


def velocities(base: Base, eta: float, points: Array) -> Array:
    """Velocities of points at a rotation."""
    turned = np.stack([-points[..., 1], points[..., 0]], axis=-1)
    return np.asarray(np.cos(eta) * base.motion + np.sin(eta) * turned)


def _columns_in_motion(base: Base, eta: float, points: Array) -> _Columns:
    """The points that move, and their forces."""
    flat = points.reshape(-1, 2)
    v = velocities(base, eta, flat)
    speed = np.hypot(v[:, 0], v[:, 1])
    moves = speed > SLOWEST
    return _Columns(flat[moves], v[moves] / speed[moves, None])


def _center_column(base: Base, eta: float) -> Array | None:
    """The center of rotation if it can carry weight."""
    if not eta:
        return None
    center = base.path / np.tan(eta)
    _, distance = base.curves.nearest(center)
    return center if base.covers(eta) or (distance <= SLOWEST / abs(np.sin(eta))).any() else None


class _Program:
    """A linear program with three or four rows, solved by the simplex method from one basis to the next.

    Its first columns are prices: what is not balanced in the rows of mass, moments and torque.
    """

    def __init__(self, base: Base, direction: Array, torque: float | None, price: float) -> None:
        rows = 3 if torque is not None else 4
        self.direction, self.torque = direction, torque
        self.goal = np.array([1.0, *base.center, 0.0])[:rows]
        prices = np.array([price] * 3 + [TORQUE_PRICE])[:rows]
        signs = np.where(self.goal < 0.0, -1.0, 1.0)
        self.matrix = np.concatenate([np.diag(signs), -np.diag(signs)], axis=1)
        self.gains = -np.tile(prices, 2)
        self.points, self.basis = np.full((2 * rows, 2), np.nan), np.arange(rows)

    def extend(self, columns: _Columns) -> None:
        """Add columns."""
        points, forces = columns
        arms = points[:, 0] * forces[:, 1] - points[:, 1] * forces[:, 0]
        rows = [np.ones(len(points)), points[:, 0], points[:, 1], arms][: len(self.goal)]
        gains = forces @ self.direction + (0.0 if self.torque is None else self.torque) * arms
        self.matrix = np.concatenate([self.matrix, rows], axis=1)
        self.gains = np.concatenate([self.gains, gains])
        self.points = np.concatenate([self.points, points])

    def solve(self) -> Optimum:
        """Exchange columns of the basis until none gains; Bland's rule after many exchanges."""
        for pivot in range(PIVOTS):
            square = self.matrix[:, self.basis]
            held, dual = (
                np.linalg.solve(square, self.goal),
                np.linalg.solve(square.T, self.gains[self.basis]),
            )
            gain = self.gains - dual @ self.matrix
            gain[self.basis] = 0.0
            gains = gain > GAINS * (1.0 + np.abs(dual).max())
            if not gains.any():
                break
            enters = int(gain.argmax() if pivot < BLAND else gains.argmax())
            away = np.linalg.solve(square, self.matrix[:, enters])
            falls = np.flatnonzero(away > PIVOT)
            if not len(falls):
                break
            ratio = np.maximum(held[falls], 0.0) / away[falls]
            first = falls[ratio <= ratio.min() + 1e-15]
            rank = away[first] if pivot < BLAND else -self.basis[first]
            self.basis[first[rank.argmax()]] = enters
        multiplier = np.append(dual[:3], self.torque if self.torque is not None else -dual[3])
        carries = (held > LIGHTEST) & (self.basis >= 2 * len(self.goal))
        pressure = Pressure(self.points[self.basis[carries]], held[carries])
        rest = self.matrix[:3, self.basis[carries]] @ held[carries] - self.goal[:3]
        return Optimum(
            pressure, multiplier, float(dual @ self.goal), bool(np.abs(rest).max() <= EXACT)
        )


def _violations(
    base: Base, sampled: tuple[Ints, Array], eta: float, direction: Array, multiplier: Array
) -> tuple[Ints, Array, float]:
    """Curves and arc lengths of local maxima of the violation, and the largest violation."""
    number, along = sampled

    def violation(number: Ints, along: Array) -> Array:
        points, _ = base.curves.points(number, along)
        v = velocities(base, eta, points)
        turned = np.stack([-points[..., 1], points[..., 0]], axis=-1)
        speed = np.maximum(np.hypot(v[..., 0], v[..., 1]), 1e-300)
        gain = ((direction + multiplier[3] * turned) * v).sum(axis=-1) / speed
        return np.asarray(gain - multiplier[0] - points @ multiplier[1:3])

    off = violation(number, along)
    before = np.pad(off[:, :-1], ((0, 0), (1, 0)), constant_values=-np.inf)
    behind = np.pad(off[:, 1:], ((0, 0), (0, 1)), constant_values=-np.inf)
    # A flat top counts once, at its end.
    top = (off >= before) & (off > behind) & (off > -1e-2)
    curve, index = np.nonzero(top)
    # The neighbors at other arc lengths: points may coincide, at ends for example.
    count = np.arange(along.shape[1])
    new = np.diff(along, axis=1) > 0.0
    first = np.maximum.accumulate(np.pad(np.where(new, count[1:], 0), ((0, 0), (1, 0))), axis=1)
    ends = np.pad(np.where(new, count[:-1], count[-1]), ((0, 0), (0, 1)), constant_values=count[-1])
    last = np.minimum.accumulate(ends[:, ::-1], axis=1)[:, ::-1]
    low = along[curve, np.maximum(first[curve, index] - 1, 0)]
    high = along[curve, np.minimum(last[curve, index] + 1, count[-1])]
    grid = np.linspace(0.0, 1.0, 9)
    for _ in range(REDUCTIONS):
        tries = low[:, None] + (high - low)[:, None] * grid
        best = violation(np.repeat(curve[:, None], 9, axis=1), tries).argmax(axis=1)
        rows = np.arange(len(curve))
        low, high = tries[rows, np.maximum(best - 1, 0)], tries[rows, np.minimum(best + 1, 8)]
    middle = (low + high) / 2.0
    ends = np.stack([low, middle, high], axis=1)
    values = violation(np.repeat(curve[:, None], 3, axis=1), ends)
    best, rows = values.argmax(axis=1), np.arange(len(curve))
    values, places = values[rows, best], ends[rows, best]
    new = values > GAINS
    return curve[new], places[new], float(values.max(initial=-np.inf))
