"""Line of force <-> motion: the sum over a scene's effects, and its inverse.

Lengths are scaled by the slider's radius. A motion has the spin ratio `k` and the centre speed `v`;
effects of degree 1 (friction) and 2 (inertia) contribute ``v^(degree - 1)`` times their profiles, so
only ``s``, the ratio of the two forces in translation, tells a slow motion from a fast one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.planar import Array
from planar_pushing.mechanics.roots import bracketed_root

Effects = Sequence[IsotropicEffect]

#: A moment arm that turns the slider about its centre, and its inverse hardly at all, in doubles.
LARGE_ARM = 1e12
TINY = np.finfo(float).tiny


def of_degree(effects: Effects, degree: int) -> Effects:
    """The effects of one degree of homogeneity."""
    return tuple(effect for effect in effects if effect.degree == degree)


def is_homogeneous(effects: Effects) -> bool:
    """Whether the direction of the motion is independent of its magnitude."""
    return len({effect.degree for effect in effects}) == 1


def profile(effects: Effects, spin_ratio: npt.ArrayLike) -> tuple[Array, Array]:
    """Sum of the effects' forces and torques at unit centre speed."""
    parts = [effect.profile(spin_ratio) for effect in effects]
    return np.sum([force for force, _ in parts], axis=0), np.sum(
        [torque for _, torque in parts], axis=0
    )


@dataclass(frozen=True, slots=True)
class Resistance:
    """The effects in units of motion and of force, so that no size of either leaves the doubles.

    Attributes
    ----------
    kinds : tuple
        The effects of each degree, in units of their force in a translation of unit speed.
    weights : tuple of ndarray, shape S
        That force of each kind at the unit of motion, in units of the larger one.
    force : ndarray, shape S
        The larger force: W, or mass times the unit of motion.
    """

    kinds: tuple[Effects, ...]
    weights: tuple[Array, ...]
    force: Array

    @property
    def inertia_ratio(self) -> Array:
        """``s = m a / W`` of the unit of motion, within the doubles; both kinds must be there."""
        slow, fast = self.weights
        return np.asarray(np.maximum(fast, TINY) / np.maximum(slow, TINY))

    def wrench(self, twist: Array) -> Array:
        """Wrench of twists of shape S + (3,), both in these units."""
        parts = zip(self.kinds, self.weights, strict=True)
        each = [w[..., None] * effect.wrench(twist) for kind, w in parts for effect in kind]
        return np.asarray(np.sum(each, axis=0))

    def branches(self) -> Resistance:
        """The same with an axis for the branches of a solution behind S."""
        return replace(self, weights=tuple(weight[..., None] for weight in self.weights))

    def profile(self, spin_ratio: Array, speed: Array) -> tuple[Array, Array]:
        """Force and torque of motions with these spin ratios and centre speeds."""
        force, torque = np.zeros((2, *np.broadcast_shapes(spin_ratio.shape, speed.shape)))
        for kind, weight in zip(self.kinds, self.weights, strict=True):
            f, t = profile(kind, spin_ratio)
            growth = weight * speed ** (kind[0].degree - 1)
            force, torque = force + growth * f, torque + growth * t
        return force, torque


def resistance(effects: Effects, motion: npt.ArrayLike = 1.0) -> Resistance:
    """The effects in units of this motion (shape S, >= 0) and of the force that it meets.

    Raises
    ------
    InvalidValue
        Where the doubles do not hold that force.
    """
    kinds: list[Effects] = []
    forces: list[Array] = []
    size = np.asarray(motion, dtype=float)
    size = np.where(size > 0, size, 1.0)
    for degree in (1, 2):
        if kind := of_degree(effects, degree):
            strength = float(profile(kind, 0.0)[0])
            kinds.append(tuple(effect.scaled(1.0, strength) for effect in kind))  # type: ignore[misc]
            with np.errstate(over="ignore"):
                forces.append(strength * size ** (degree - 1))
    force = np.maximum.reduce(forces)
    if not np.all((force >= TINY) & np.isfinite(force)):
        raise InvalidValue(
            "pusher_magnitude", motion, "one whose force, mass times magnitude, is a normal double",
            "choose other units of motion, mass or force",
        )  # fmt: skip
    return Resistance(tuple(kinds), tuple(each / force for each in forces), force)


def root(
    function: Callable[..., Array], low: Array, high: Array, args: tuple[Any, ...] = ()
) -> Array:
    """Root of an increasing elementwise function in [low, high]; an end where none lies inside."""
    low, high, *spread = np.broadcast_arrays(low, high, *args)

    def inside(x: Array, low: Array, high: Array, *spread: Array) -> Array:
        # Next to an end that is small beside the other, steps round to the outside.
        return function(np.clip(x, low, high), *spread)

    return np.clip(bracketed_root(inside, low, high, (low, high, *spread)), low, high)


def _homogeneous_spin_ratio(effects: Effects, arm: Array) -> Array:
    """Spin ratio under effects of one degree; `arm` is a moment arm >= 0."""
    ends = np.stack([effect.spin_ratio(arm) for effect in effects])
    if len(effects) == 1:
        return np.asarray(ends[0])

    def excess(k: Array, h: Array) -> Array:
        force, torque = profile(effects, k)
        return torque - h * force

    return root(excess, ends.min(axis=0), ends.max(axis=0), (arm,))


def balanced_spin_ratio(effects: Effects, arm: Array, slow: Array, fast: Array) -> Array:
    """Spin ratio of both kinds of effects with weights `slow` and `fast`, for a moment arm >= 0.

    Solves ``h (f + s) = t + s rho^2 k`` with ``s = fast / slow``: k runs from the friction value to
    the inertia value over the open segment between them.
    """
    kinds = resistance(effects).kinds
    ends = np.stack([_homogeneous_spin_ratio(kind, arm) for kind in kinds])

    def excess(k: Array, h: Array, slow: Array, fast: Array) -> Array:
        (f1, t1), (f2, t2) = (profile(kind, k) for kind in kinds)
        return slow * (t1 - h * f1) + fast * (t2 - h * f2)

    return root(excess, ends.min(axis=0), ends.max(axis=0), (arm, slow, fast))


def require_share(effects: Effects, inertia_share: npt.ArrayLike | None) -> Array | None:
    """The share of inertia where the effects leave it open, None where they settle it."""
    if is_homogeneous(effects):
        if inertia_share is not None:
            raise InvalidValue(
                "inertia_share", inertia_share, "None for a scene whose effects are of one kind",
                "leave the argument out",
            )  # fmt: skip
        return None
    if inertia_share is None:
        raise InvalidValue(
            "inertia_share", inertia_share, "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W; motion_cone and solve need none",
        )  # fmt: skip
    share = np.asarray(inertia_share, dtype=float)
    if not np.all((share >= 0) & (share <= 1)):
        raise InvalidValue("inertia_share", inertia_share, "numbers in [0, 1]", "give s / (1 + s)")
    return share


def spin_ratio(effects: Effects, arm: npt.ArrayLike, inertia_share: npt.ArrayLike | None) -> Array:
    """Spin ratio for each moment arm (in units of R), broadcast against `inertia_share`."""
    share = require_share(effects, inertia_share)
    arm = np.asarray(arm, dtype=float)
    if share is None:
        size = _homogeneous_spin_ratio(effects, np.abs(arm))
    else:
        size = balanced_spin_ratio(effects, np.abs(arm), 1 - share, share)
    return np.asarray(np.copysign(size, arm))


def spin_ratio_of(twist: Array) -> Array:
    """Spin ratio of twists of shape S + (3,), shape S; 0 at rest."""
    speed, spin = np.hypot(twist[..., 0], twist[..., 1]), twist[..., 2]
    whirl = np.asarray(np.copysign(np.inf, spin))
    with np.errstate(divide="ignore", over="ignore"):
        ratio = np.divide(spin, speed, out=whirl, where=speed > 0)
    return np.where(spin == 0, 0.0, ratio)


def _leverages(effects: Effects) -> list[float]:
    """Moment arm per spin ratio of each effect, for the smallest and for the largest arms."""
    arms = np.array([1 / LARGE_ARM, LARGE_ARM])
    return [float(q) for effect in effects for q in arms / effect.spin_ratio(arms)]


def sustained_twist(
    resisting: Resistance, rod_length: float, along: Array, aside: Array
) -> tuple[Array, Array]:
    """Twist that moves the contact by one unit under a force through the contact.

    Parameters
    ----------
    resisting : Resistance
        Weights of shape S.
    rod_length : float
        In units of R.
    along, aside : ndarray, shape S
        Parts of the contact's unit motion along the rod and along its right-hand normal.

    Returns
    -------
    twist : ndarray, shape S + (3,)
        Velocity of the centre along the rod, velocity along the rod's right-hand normal, R omega.
    carried : ndarray, shape S
        Part of `aside` that the centre takes, in (0, 1]; the rotation takes the rest.

    Notes
    -----
    Of all twists with this contact motion it has the least potential, so the torque about the
    contact, the potential's slope, increases with the rotation. The root is sought in the moment arm
    per spin ratio, which has narrow bounds whatever the length of the rod (for inertia it is rho^2),
    and from which neither part of the motion across the rod is a difference.
    """
    ends = [q for kind in resisting.kinds for q in _leverages(kind)]
    along, aside, *weights = np.broadcast_arrays(along, aside, *resisting.weights)

    def twist(leverage: Array, along: Array, aside: Array) -> Array:
        part = aside / (rod_length**2 + leverage)
        return np.stack([along, leverage * part, rod_length * part], axis=-1)

    def torque_about_contact(q: Array, along: Array, aside: Array, *weights: Array) -> Array:
        wrench = replace(resisting, weights=weights).wrench(twist(q, along, aside))
        return np.asarray(np.copysign(1.0, aside) * (rod_length * wrench[..., 1] - wrench[..., 2]))

    low, high = np.array(min(ends) / 2), np.array(max(ends) * 2)
    leverage = root(torque_about_contact, low, high, (along, aside, *weights))
    return twist(leverage, along, aside), leverage / (rod_length**2 + leverage)
