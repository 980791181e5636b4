"""Slipping contact: motions with a given normal part under a force on an edge of the friction cone.

With effects of one kind, the motion under such a force has a fixed direction and any magnitude. With
friction and inertia it turns as it grows: the spin ratio runs from its friction to its inertia value,
the normal part need not be monotone (Painleve), and one normal motion may belong to several magnitudes.
The curve is therefore cut at its extrema, and each monotone piece searched for its one root.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.planar import Array, direction, moment_arm
from planar_pushing.mechanics.roots import bracketed_minimum

#: Where a range of spin ratios is looked at: in even steps, as parts of it, and next to its ends at
#: distances that grow by a factor, from a part of the end's own size.
EVEN = np.linspace(2e-3, 1 - 2e-3, 240)
GROWTH, CLOSEST = 10.0**0.25, 1e-7
#: Spin ratios closer than this, relative to their size, leave rounding little room between them.
NARROW = 1e-6

SMALLEST = np.finfo(float).smallest_subnormal
#: Below this spin ratio what is left of the torques in doubles is too coarse to look at.
VANISHING = 1e-290

#: Centre speed, spin ratio, and whether there is such a motion; shape S + (branches,) each.
SlipMotions = tuple[Array, Array, npt.NDArray[np.bool_]]


@dataclass(frozen=True, slots=True)
class _Edges:
    """Lines of force along edges, for moment arms >= 0; `lever` is k's part in ``n . u / v``."""

    kinds: tuple[response.Effects, ...]
    arm: Array
    normal: Array
    lever: Array

    def advance(self, k: Array) -> Array:
        """``n . u / v``, zero where nothing but rounding is left of it."""
        advance = self.normal - self.lever * k
        noise = RESOLUTION * (np.abs(self.normal) + np.abs(self.lever * k))
        return np.where(np.abs(advance) <= noise, 0.0, advance)

    def imbalance(self, k: Array) -> tuple[Array, Array]:
        """Torque about the contact that each kind leaves, in units of its force in translation."""
        (f1, t1), (f2, t2) = (response.profile(kind, k) for kind in self.kinds)
        return t1 - self.arm * f1, t2 - self.arm * f2

    def speed(self, k: Array) -> Array:
        """Centre speed ``s`` (in units of W / m) at which the torques cancel."""
        slow, fast = self.imbalance(k)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(-slow / fast)

    def normal_motion(self, k: Array) -> Array:
        """``n . u`` (in units of W / m) at which the torques cancel."""
        return self.speed(k) * self.advance(k)

    def pieces(self) -> list[tuple[Array, Array]]:
        """Spin ratios and normal motions at the ends of each edge's monotone pieces, friction end first."""
        arm = self.arm.ravel()
        slow, fast = (response.spin_ratio(kind, arm, None).tolist() for kind in self.kinds)
        lines = list(self)
        nodes = [line._nodes(*ends) for line, *ends in zip(lines, slow, fast, strict=True)]
        sizes = [each.size for each in nodes]
        owner = np.repeat(np.arange(arm.size), sizes)
        owners = (each.ravel()[owner] for each in (self.arm, self.normal, self.lever))
        values = _Edges(self.kinds, *owners).normal_motion(np.concatenate(nodes))
        parts = np.split(values, np.cumsum(sizes)[:-1])
        cuts = zip(lines, slow, fast, nodes, parts, strict=True)
        return [line._cut(*each) for line, *each in cuts]

    def _cut(self, slow: float, fast: float, nodes: Array, values: Array) -> tuple[Array, Array]:
        """Pieces of one edge, whose normal motion has these values at its nodes."""
        advance = self.advance(np.array(fast))
        end = np.copysign(np.inf, advance)
        if nodes.size and advance == 0:  # then n . u stays finite as the motion grows
            fast, end = nodes[-1], values[-1]
        nodes = np.concatenate([[slow], nodes, [fast]])
        values = np.concatenate([[0.0], values, [end]])
        rise = np.diff(values)
        steps = np.flatnonzero(np.abs(rise) > RESOLUTION * np.abs(values[:-1]))  # none on a plateau
        rises = np.sign(rise[steps])
        turns = np.flatnonzero(np.diff(rises))
        spans = zip(nodes[steps[turns]], nodes[steps[turns + 1] + 1], rises[turns], strict=True)
        peaks = [self._extremum(low, high, -up) for low, high, up in spans]
        ends = np.array([slow, *peaks, fast])
        return ends, np.array([0.0, *self.normal_motion(ends[1:-1]), end])

    def _nodes(self, slow: float, fast: float) -> Array:
        """Spin ratios at which an edge is looked at for extrema, between its ends, kinks and turn."""
        low, high = sorted((slow, fast))
        if low < VANISHING:
            return np.empty(0)
        kinks = [kink for kind in self.kinds for effect in kind for kink in effect.kinks]
        along_fence = float(self.normal / self.lever) if self.lever else np.inf
        marks = [low, *sorted(k for k in {*kinks, along_fence} if low < k < high), high]
        nodes = np.concatenate([marks[1:-1], *(_graded(*pair) for pair in pairwise(marks))])
        return np.sort(nodes)[:: 1 if slow < fast else -1]

    def _extremum(self, low: float, high: float, sign: float) -> float:
        """Where the normal motion has its minimum (sign 1) or maximum (sign -1) between two nodes."""
        return bracketed_minimum(lambda k: sign * self.normal_motion(k), low, high)

    def roots(self, resisting: response.Resistance, normal_motion: Array) -> SlipMotions:
        """Every motion with these normal parts, in units of `resisting`, of edges of shape (n, 1, ...)."""
        cuts = self.pieces()
        pieces = [(i, j) for i, (ends, _) in enumerate(cuts) for j in range(len(ends) - 1)]
        edge, branch = np.array(pieces).T
        ends = np.array([[*cuts[i][0][j : j + 2], *cuts[i][1][j : j + 2]] for i, j in pieces]).T
        lines = _Edges(self.kinds, self.arm[edge], self.normal[edge], self.lever[edge])
        k, reached = lines._root(resisting, normal_motion, *ends.reshape(4, *lines.arm.shape))
        with np.errstate(over="ignore"):  # where it is used it is finite
            otherwise = lines.speed(k) / resisting.inertia_ratio
        speed, moves = _speed(normal_motion, lines.advance(k), otherwise)
        shape = len(cuts), *normal_motion.shape, branch.max() + 1
        speeds, ratios, exists = np.zeros(shape), np.zeros(shape), np.zeros(shape, bool)
        speeds[edge, ..., branch], ratios[edge, ..., branch] = speed, k
        exists[edge, ..., branch] = reached & moves
        return speeds, ratios, exists

    def __iter__(self) -> Iterator[_Edges]:
        for each in zip(self.arm.ravel(), self.normal.ravel(), self.lever.ravel(), strict=True):
            yield _Edges(self.kinds, *map(np.asarray, each))

    def _root(
        self,
        resisting: response.Resistance,
        normal_motion: Array,
        k1: Array,
        k2: Array,
        g1: Array,
        g2: Array,
    ) -> tuple[Array, npt.NDArray[np.bool_]]:
        """Spin ratios on monotone pieces from (k1, g1) to (k2, g2), and whether they are reached."""

        def excess(k: Array, target: Array, slow: Array, fast: Array, *edge: Array) -> Array:
            line = _Edges(self.kinds, *edge[:3])
            x, y = line.imbalance(k)
            return np.asarray(edge[3] * (slow * line.advance(k) * x + fast * target * y))

        # Not rounded to 0: its sign decides.
        size = np.maximum(np.abs(normal_motion) * resisting.inertia_ratio, SMALLEST)
        level = np.where(normal_motion == 0, 0.0, np.copysign(size, normal_motion))
        between = np.sign(g1 - level) * np.sign(g2 - level) < 0
        edge = self.arm, self.normal, self.lever, np.sign(g2 - g1)
        args = (normal_motion, *resisting.weights, *edge)
        found = response.root(excess, np.minimum(k1, k2), np.maximum(k1, k2), args)
        return found, between | (level == g2)


def _graded(low: float, high: float) -> Array:
    """Spin ratios between two marks; one where the marks are too close to tell more apart."""
    width = high - low
    if width <= NARROW * low:
        return np.array([low + width / 2])
    even = low + width * EVEN
    near = [_growing(CLOSEST * end, EVEN[0] * width) for end in (low, high)]
    return np.concatenate([low + near[0], even, high - near[1]])


def _growing(first: float, last: float) -> Array:
    """Numbers from first to below last that grow by `GROWTH`; none where first is not below."""
    steps = np.log(last / first) / np.log(GROWTH)
    return np.asarray(first * GROWTH ** np.arange(max(0.0, steps)))


def _speed(
    normal_motion: Array, advance: Array, otherwise: Array
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Centre speed with this normal motion, and whether the slider moves at all."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        speed = np.where(advance == 0, otherwise, normal_motion / advance)
    # By the signs: a speed below the smallest double still is a motion.
    moves = np.where(advance == 0, otherwise > 0, np.sign(normal_motion) * np.sign(advance) > 0)
    moves &= np.isfinite(speed)
    return np.where(moves, speed, 0.0), moves


def slip_motions(
    resisting: response.Resistance,
    rod_length: float,
    rod_angle: float,
    force_angle: npt.ArrayLike,
    normal_motion: npt.ArrayLike,
) -> SlipMotions:
    """Motions of the slider under forces at `force_angle` whose contact has this normal motion.

    Parameters
    ----------
    resisting : Resistance
        Weights of shape S, lengths scaled by the radius.
    rod_length, rod_angle : float
        Units of R, radians.
    force_angle : array_like, shape E
        Radians.
    normal_motion : array_like, shape S
        ``n . u`` of the contact, in units of `resisting`.

    Returns
    -------
    speed, spin_ratio, exists : ndarray, shape E + S + (branches,)
        A motion that does not exist has speed 0.
    """
    target = np.asarray(normal_motion, dtype=float)
    angle = np.reshape(force_angle, (-1, *(1 for _ in target.shape)))
    arm = moment_arm(rod_length, rod_angle, angle)
    lever = np.copysign(rod_length, arm) * direction(rod_angle)[0]
    edges = _Edges(resisting.kinds, np.abs(arm), direction(angle)[..., 1], lever)
    if len(resisting.kinds) == 1:
        ratio = response.spin_ratio(resisting.kinds[0], edges.arm, None)
        found = _speed(target, edges.advance(ratio), np.zeros(ratio.shape))
        speed, exists = (each[..., None] for each in found)
        size = np.broadcast_to(ratio[..., None], speed.shape)
    else:
        speed, size, exists = edges.roots(resisting, target)
    shape = *np.shape(force_angle), *speed.shape[1:]
    ratio = np.copysign(size, arm[..., None])
    return speed.reshape(shape), ratio.reshape(shape), exists.reshape(shape)
