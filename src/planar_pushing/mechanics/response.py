"""Line of force <-> motion: the sum over a scene's effects, and its inverse.

Lengths are scaled by the slider's radius. A motion has the spin ratio `k` and the centre speed `v`;
effects of degree 1 (friction) and 2 (inertia) contribute ``v^(degree - 1)`` times their profiles, so
only ``s``, the ratio of the two forces in translation, tells a slow motion from a fast one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.optimize import elementwise

from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.planar import Array

Effects = Sequence[IsotropicEffect]

#: A rod shorter than this part of the radius turns the slider by less than the smallest double.
VANISHING = 1e-100
#: Roots are refined to a few ulp; a bracket cannot shrink below one.
TOLERANCES = {"xatol": 0.0, "xrtol": 4 * np.finfo(float).eps, "fatol": 0.0, "frtol": 0.0}


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


def translation_ratio(effects: Effects) -> float:
    """``s / v`` (m / W): force of inertia over force of friction in a translation of unit speed."""
    inertial, frictional = (profile(of_degree(effects, degree), 0.0)[0] for degree in (2, 1))
    return float(inertial / frictional)


def root(
    function: Callable[..., Array], low: Array, high: Array, args: tuple[Any, ...] = ()
) -> Array:
    """Root of an increasing elementwise function in [low, high]; an end where none lies inside."""
    low, high, *spread = np.broadcast_arrays(low, high, *args)
    found = elementwise.find_root(function, (low, high), args=tuple(spread), tolerances=TOLERANCES)
    end = np.where(function(low, *spread) > 0, low, high)
    return np.asarray(np.where(found.success, found.x, end))


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
    kinds = of_degree(effects, 1), of_degree(effects, 2)
    ends = np.stack([_homogeneous_spin_ratio(kind, arm) for kind in kinds])
    scales = [1 / profile(kind, 0.0)[0] for kind in kinds]

    def excess(k: Array, h: Array, slow: Array, fast: Array) -> Array:
        (f1, t1), (f2, t2) = (profile(kind, k) for kind in kinds)
        return slow * scales[0] * (t1 - h * f1) + fast * scales[1] * (t2 - h * f2)

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


def sustained_twist(effects: Effects, rod_length: Array, lean: Array, speed: Array) -> Array:
    """Twist that moves the contact as prescribed under a force through the contact.

    Parameters
    ----------
    rod_length : ndarray
        In units of R.
    lean : ndarray
        Rod angle minus the angle of the contact's motion, radians.
    speed : ndarray
        Magnitude of the contact's motion, > 0.

    Returns
    -------
    ndarray, shape S + (3,)
        Velocity of the centre along the rod, velocity along the rod's right-hand normal, R omega.

    Notes
    -----
    Of all twists with this contact motion it has the least potential, so the torque about the
    contact, the potential's slope, increases with the rotation. The root is sought in the part `y` of
    the contact's transverse motion that the rotation takes.
    """
    along, aside = speed * np.cos(lean), speed * np.sin(lean)

    def twist(y: Array, along: Array, aside: Array, length: Array) -> Array:
        spin = np.divide(y * aside, length, out=np.zeros(np.shape(y)), where=length > 0)
        return np.stack([along, (1 - y) * aside, spin], axis=-1)

    def torque_about_contact(y: Array, along: Array, aside: Array, length: Array) -> Array:
        wrench = np.sum([e.wrench(twist(y, along, aside, length)) for e in effects], axis=0)
        return np.asarray(np.copysign(1.0, aside) * (wrench[..., 2] - length * wrench[..., 1]))

    zero = np.zeros(np.broadcast_shapes(np.shape(along), np.shape(rod_length)))
    along, aside, length = (part + zero for part in (along, aside, rod_length))
    straight = (aside == 0) | (length < VANISHING)
    args = along, np.where(straight, 0.0, aside), np.where(straight, 1.0, length)
    y = np.where(straight, 0.0, root(torque_about_contact, zero, zero + 1, args))
    return twist(y, along, aside, length)
