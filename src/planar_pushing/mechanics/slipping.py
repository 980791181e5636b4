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


#: Centre speed, spin ratio, and whether there is such a motion; shape S + (branches,) each.
SlipMotions = tuple[Array, Array, npt.NDArray[np.bool_]]


@dataclass(frozen=True, slots=True)
class _Edge:
    """The line of force along an edge, for a moment arm >= 0; `lever` is k's part in ``n . u / v``."""

    effects: response.Effects
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
        kinds = (response.of_degree(self.effects, degree) for degree in (1, 2))
        torques = []
        for kind in kinds:
            force, torque = response.profile(kind, k)
            torques.append((torque - self.arm * force) / response.profile(kind, 0.0)[0])
        return torques[0], torques[1]

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
        kinds = (response.of_degree(self.effects, degree) for degree in (1, 2))
        slow, fast = (float(response.spin_ratio(kind, self.arm, None)) for kind in kinds)
        end = np.copysign(np.inf, self.advance(np.array(fast)))
        if abs(fast - slow) <= 1e-6 * slow or slow < response.VANISHING:
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
        kinks = [(kink - slow) / (fast - slow) for effect in self.effects for kink in effect.kinks]
        near = [kink + side * GRADING for kink in kinks for side in (-1, 1)]
        parts = np.unique(np.concatenate([GRADING, 1 - GRADING, *near]))
        inside = (parts >= GRADING[0]) & (parts <= 1 - GRADING[0])
        return np.asarray(slow + (fast - slow) * parts[inside])

    def _extremum(self, bracket: Array, sign: float) -> float:
        """Where the normal motion has its minimum (sign 1) or maximum (sign -1) in a bracket."""
        found = elementwise.find_minimum(lambda k: sign * self.normal_motion(k), tuple(bracket))
        return float(found.x)

    def roots(self, normal_motion: Array) -> SlipMotions:
        """Every motion with these normal parts."""
        ends, values = self.pieces()
        pieces = zip(ends[:-1], ends[1:], values[:-1], values[1:], strict=True)
        found = [self._root(normal_motion, *piece) for piece in pieces]
        k, reached = (np.stack(part, axis=-1) for part in zip(*found, strict=True))
        speed, moves = _speed(normal_motion[..., None], self.advance(k), self.speed(k))
        return speed, k, reached & moves

    def _root(
        self, normal_motion: Array, k1: float, k2: float, g1: float, g2: float
    ) -> tuple[Array, npt.NDArray[np.bool_]]:
        """Spin ratio on the monotone piece from (k1, g1) to (k2, g2), and whether it is reached."""

        def excess(k: Array, target: Array) -> Array:
            slow, fast = self.imbalance(k)
            return np.asarray(np.sign(g2 - g1) * (self.advance(k) * slow + target * fast))

        between = np.sign(g1 - normal_motion) * np.sign(g2 - normal_motion) < 0
        reached = between | (normal_motion == g2)
        low, high = np.array(min(k1, k2)), np.array(max(k1, k2))
        return response.root(excess, low, high, (normal_motion,)), reached


def _speed(
    normal_motion: Array, advance: Array, otherwise: Array
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Centre speed with this normal motion, and whether the slider moves at all."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        speed = np.where(advance == 0, otherwise, normal_motion / advance)
    moves = (speed > 0) & np.isfinite(speed)
    return np.where(moves, speed, 0.0), moves


def slip_motions(
    effects: response.Effects,
    rod_length: float,
    rod_angle: float,
    force_angle: float,
    normal_motion: npt.ArrayLike,
) -> SlipMotions:
    """Motions of the slider under a force at `force_angle` whose contact has this normal motion.

    Parameters
    ----------
    effects : sequence of effects, lengths scaled by the radius
    rod_length, rod_angle, force_angle : float
        Units of R, radians, radians.
    normal_motion : array_like, shape S
        ``n . u`` of the contact.

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
    edge = _Edge(effects, np.abs(arm), float(normal), float(lever))
    if response.is_homogeneous(effects):
        size = np.broadcast_to(response.spin_ratio(effects, edge.arm, None), (*target.shape, 1))
        speed, exists = _speed(target[..., None], edge.advance(size), np.zeros(size.shape))
    else:
        scale = response.translation_ratio(effects)
        speed, size, exists = edge.roots(target * scale)
        speed = speed / scale
    return speed, np.copysign(size, arm), exists
