"""Slipping contact: motions with a given normal part under a force on an edge of the friction cone.

With effects of one kind, the motion under such a force has a fixed direction and any magnitude. With
friction and inertia it turns as it grows: the spin ratio runs from its friction to its inertia value,
the normal part need not be monotone (Painleve), and one normal motion may belong to several magnitudes.
The curve is therefore cut at its extrema, and each monotone piece searched for its one root.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.optimize import elementwise

from planar_pushing.mechanics import response
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.planar import Array, direction, moment_arm

#: Steps towards the ends of the range of spin ratios and towards a kink, as parts of the range.
GRADING = np.concatenate([10.0 ** -np.arange(7, 2, -0.5), np.linspace(2e-3, 0.5, 120)])

SMALLEST = np.finfo(float).smallest_subnormal
#: Below this spin ratio a motion is a translation to the last place, whatever its speed.
VANISHING = 1e-100

#: Centre speed, spin ratio, and whether there is such a motion; shape S + (branches,) each.
SlipMotions = tuple[Array, Array, npt.NDArray[np.bool_]]


@dataclass(frozen=True, slots=True)
class _Edge:
    """The line of force along an edge, for a moment arm >= 0; `lever` is k's part in ``n . u / v``."""

    kinds: tuple[response.Effects, ...]
    arm: Array
    normal: float
    lever: float

    def advance(self, k: Array) -> Array:
        """``n . u / v``, zero where nothing but rounding is left of it."""
        advance = self.normal - self.lever * k
        noise = RESOLUTION * (abs(self.normal) + np.abs(self.lever * k))
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

    def pieces(self) -> tuple[Array, Array]:
        """Spin ratios and normal motions at the ends of the monotone pieces, friction end first."""
        slow, fast = (float(response.spin_ratio(kind, self.arm, None)) for kind in self.kinds)
        end = np.copysign(np.inf, self.advance(np.array(fast)))
        if abs(fast - slow) <= 1e-6 * slow or slow < VANISHING:
            return np.array([slow, fast]), np.array([0.0, end])
        nodes = self._nodes(slow, fast)
        values = self.normal_motion(nodes)
        if self.advance(np.array(fast)) == 0:  # then n . u stays finite as the motion grows
            fast, end = nodes[-1], values[-1]
        rise = np.sign(np.diff(values))
        turns = np.nonzero(rise[1:] * rise[:-1] < 0)[0]
        peaks = [self._extremum(nodes[i : i + 3], -rise[i]) for i in turns]
        ends = np.array([slow, *peaks, fast])
        return ends, np.array([0.0, *self.normal_motion(ends[1:-1]), end])

    def _nodes(self, slow: float, fast: float) -> Array:
        kinks = [kink for kind in self.kinds for effect in kind for kink in effect.kinks]
        places = [(kink - slow) / (fast - slow) for kink in kinks]
        near = [place + side * GRADING for place in places for side in (-1, 1)]
        parts = np.unique(np.concatenate([GRADING, 1 - GRADING, *near]))
        inside = (parts >= GRADING[0]) & (parts <= 1 - GRADING[0])
        return np.asarray(slow + (fast - slow) * parts[inside])

    def _extremum(self, bracket: Array, sign: float) -> float:
        """Where the normal motion has its minimum (sign 1) or maximum (sign -1) in a bracket."""
        found = elementwise.find_minimum(lambda k: sign * self.normal_motion(k), tuple(bracket))
        return float(found.x)

    def roots(self, resisting: response.Resistance, normal_motion: Array) -> SlipMotions:
        """Every motion with these normal parts, in units of `resisting`."""
        ends, values = self.pieces()
        pieces = zip(ends[:-1], ends[1:], values[:-1], values[1:], strict=True)
        found = [self._root(resisting, normal_motion, *piece) for piece in pieces]
        k, reached = (np.stack(part, axis=-1) for part in zip(*found, strict=True))
        speed, moves = _speed(
            normal_motion[..., None],
            self.advance(k),
            self.speed(k) / resisting.inertia_ratio[..., None],
        )
        return speed, k, reached & moves

    def _root(
        self,
        resisting: response.Resistance,
        normal_motion: Array,
        k1: float,
        k2: float,
        g1: float,
        g2: float,
    ) -> tuple[Array, npt.NDArray[np.bool_]]:
        """Spin ratio on the monotone piece from (k1, g1) to (k2, g2), and whether it is reached."""

        def excess(k: Array, target: Array, slow: Array, fast: Array) -> Array:
            x, y = self.imbalance(k)
            return np.asarray(np.sign(g2 - g1) * (slow * self.advance(k) * x + fast * target * y))

        # Not rounded to 0: its sign decides.
        size = np.maximum(np.abs(normal_motion) * resisting.inertia_ratio, SMALLEST)
        level = np.where(normal_motion == 0, 0.0, np.copysign(size, normal_motion))
        between = np.sign(g1 - level) * np.sign(g2 - level) < 0
        reached = between | (level == g2)
        low, high = np.array(min(k1, k2)), np.array(max(k1, k2))
        args = (normal_motion, *resisting.weights)
        return response.root(excess, low, high, args), reached


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
    force_angle: float,
    normal_motion: npt.ArrayLike,
) -> SlipMotions:
    """Motions of the slider under a force at `force_angle` whose contact has this normal motion.

    Parameters
    ----------
    resisting : Resistance
        Weights of shape S, lengths scaled by the radius.
    rod_length, rod_angle, force_angle : float
        Units of R, radians, radians.
    normal_motion : array_like, shape S
        ``n . u`` of the contact, in units of `resisting`.

    Returns
    -------
    speed, spin_ratio, exists : ndarray, shape S + (branches,)
        A motion that does not exist has speed 0.
    """
    target = np.asarray(normal_motion, dtype=float)
    arm = moment_arm(rod_length, rod_angle, force_angle)
    normal, lever = (
        direction(force_angle)[1],
        np.copysign(rod_length, arm) * direction(rod_angle)[0],
    )
    edge = _Edge(resisting.kinds, np.abs(arm), float(normal), float(lever))
    if len(resisting.kinds) == 1:
        size = np.broadcast_to(
            response.spin_ratio(resisting.kinds[0], edge.arm, None), (*target.shape, 1)
        )
        speed, exists = _speed(target[..., None], edge.advance(size), np.zeros(size.shape))
    else:
        speed, size, exists = edge.roots(resisting, target)
    return speed, np.copysign(size, arm), exists
