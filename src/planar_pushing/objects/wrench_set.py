"""The set of loads at a twist: one wrench, plus the disc of forces of a foot at the center of rotation."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, inf
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects import Effect, Inertia
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.rows import extents
from planar_pushing.objects.resistance import (
    feet_of,
    motion_at,
    require_effects,
    resistance,
    supports_of,
)
from planar_pushing.terms.errors import InvalidValue, as_floats, require_number, require_positive
from planar_pushing.terms.numbers import Number, as_array

#: Distance within which the center of rotation is on a foot, relative to the numbers from which it is
#: computed: the rounding error of a twist transformed between frames.
ROUNDING = 1e-12
#: Maximum number of Newton steps for the secular equation; 3 to 9 suffice, by quadratic convergence from
#: below.
STEPS = 50


@dataclass(frozen=True, slots=True, kw_only=True)
class WrenchSet:
    """The wrenches that sustain a twist: ``offset + {(g, r x g): |g| <= radius}``.

    Attributes
    ----------
    offset : ndarray, shape (3,)
        (f_x, f_y, tau) about the origin of the object's frame: the load without the friction of the foot at
        the center of rotation.
    foot : ndarray, shape (2,), or None
        Position r of this foot; None if no foot is at the center of rotation, and the set is the single
        wrench `offset`.
    radius : float
        Maximum force of the foot, its share of the weight W; 0 without one.
    length : float
        Default length by which torques are divided to compare them with forces.
    """

    offset: Array
    foot: Array | None
    radius: float
    length: float

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def nearest(self, wrench: npt.ArrayLike, length: float | None = None) -> Array:
        """Wrench of the set that is nearest to a wrench.

        Parameters
        ----------
        wrench : array_like, shape S + (3,)
            (f_x, f_y, tau) about the origin of the object's frame.
        length : float, optional
            Length by which torques are divided; by default that of the set.

        Returns
        -------
        ndarray, shape S + (3,)

        Raises
        ------
        InvalidValue
            If a wrench is not three finite numbers, or the length is not positive.

        Notes
        -----
        The force g of the foot minimizes a convex quadratic function on a disc. It is the unconstrained
        minimum, or a point on the rim given by a root of the secular equation.
        """
        wrenches, unit = _wrenches(wrench), self._unit(length)
        if self.foot is None:
            return np.broadcast_to(self.offset, wrenches.shape).copy()
        x, y = self.foot
        away = (wrenches - self.offset) / [1.0, 1.0, unit]
        force = _nearest_in_disc(away, np.array([-y, x]) / unit, self.radius)
        torque = x * force[..., 1] - y * force[..., 0]
        return np.asarray(self.offset + np.concatenate([force, torque[..., None]], axis=-1))

    def distance(self, wrench: npt.ArrayLike, length: float | None = None) -> Array:
        """Distance of wrenches of shape S + (3,) from the set, shape S, in the unit of force.

        Parameters and errors are those of `nearest`; the distance is the norm of
        ``(df_x, df_y, dtau / length)``.
        """
        scale = [1.0, 1.0, self._unit(length)]
        difference = (_wrenches(wrench) - self.nearest(wrench, length)) / scale
        return np.asarray(np.linalg.norm(difference, axis=-1))

    def _unit(self, length: float | None) -> float:
        if length is None:
            return self.length
        return require_positive(
            "length", length, "give a length comparable to the size of the object"
        )


def _wrenches(value: npt.ArrayLike) -> Array:
    wrenches = as_array(value)
    if wrenches is None or wrenches.shape[-1:] != (3,) or not np.isfinite(wrenches).all():
        raise InvalidValue(
            "wrench", value, "finite numbers of shape S + (3,)", "give (f_x, f_y, tau)"
        )
    return wrenches


def _nearest_in_disc(away: Array, arm: Array, radius: float) -> Array:
    """The g that minimizes ``|a - g|^2 + (b - k . g)^2`` over ``|g| <= radius``, for rows (a, b)."""
    square = float(arm @ arm)
    along = arm / hypot(*arm) if square > 0.0 else np.array([1.0, 0.0])
    target = away[..., :2] + arm * away[..., 2:]
    # Along k and across it the Hessian is diagonal: 1 + k^2 and 1.
    parts = np.stack(
        [target @ along, along[0] * target[..., 1] - along[1] * target[..., 0]], axis=-1
    )
    stiff = np.array([1.0 + square, 1.0])
    shift = _multiplier(parts, stiff, radius)
    solution = parts / (stiff + shift[..., None])
    size = np.hypot(solution[..., 0], solution[..., 1])
    rim = np.where(shift > 0.0, radius / np.where(size > 0.0, size, 1.0), 1.0)
    solution = solution * rim[..., None]
    across = np.array([-along[1], along[0]])
    return np.asarray(solution[..., :1] * along + solution[..., 1:] * across)


def _multiplier(parts: Array, stiff: Array, radius: float) -> Array:
    """The root ``m >= 0`` of ``|parts / (stiff + m)| = radius``, or 0 if the minimum is inside the disc.

    Newton's method on ``1 / |.|``, which is concave: from below it never overshoots.
    """
    size = np.hypot(parts[..., 0], parts[..., 1])
    shift = np.maximum(size / radius - stiff.max(), 0.0)
    for _ in range(STEPS):
        scaled = parts / (stiff + shift[..., None])
        size = np.hypot(scaled[..., 0], scaled[..., 1])
        steep = (scaled**2 / (stiff + shift[..., None])).sum(axis=-1)
        outside = size > radius
        step = np.where(
            outside, size**2 * (size / radius - 1.0) / np.where(outside, steep, 1.0), 0.0
        )
        if np.all(step <= 4e-16 * shift):
            break
        shift = shift + step
    return np.asarray(shift)


def wrench_set(
    effects: tuple[Effect, ...], twist: npt.ArrayLike, *, tolerance: float = 0.0
) -> WrenchSet:
    """Every wrench that sustains a twist: the subdifferential of the effects' potential.

    Parameters
    ----------
    effects : tuple of SupportFriction, Viscous, Inertia and Load
        In the object's own frame; at least one other than a load. With inertia the twist is an initial
        acceleration from rest, and viscous friction is absent.
    twist : array_like, shape (3,)
        (v_x, v_y, omega) of the object's frame about its origin, omega in radians per unit of time.
    tolerance : float, optional
        Distance from a foot, in the unit of length, within which the center of rotation counts as on it:
        the error of a measured motion. By default the rounding error.

    Returns
    -------
    WrenchSet
        In the object's frame, with torques about its origin. If several feet are within the tolerance, the
        nearest determines the set.

    Raises
    ------
    InvalidValue
        If the twist is not three finite numbers or is zero, the tolerance is negative, or an effect is of
        another type, has arrays of parameters, or is a ring without a radius.

    Notes
    -----
    Each effect is a convex potential, and its gradient is the wrench. The potential of a foot has a kink at
    twists for which the foot is at rest: the foot then takes any force up to its share of the weight.
    """
    acting, motion = require_effects(effects), require_twist(twist)
    reach = require_number(
        "tolerance", tolerance, lambda x: 0 <= x < inf, "a finite number >= 0", "give a distance"
    )
    feet = feet_of(acting)
    resting = _feet_at_rest(feet, motion, reach)
    held = feet[resting]
    return WrenchSet(
        offset=resistance(acting, motion, feet[~resting]),
        foot=held[0, :2] if len(held) else None,
        radius=float(held[:, 2].sum()),
        length=float(_size(acting)),
    )


def require_twist(value: npt.ArrayLike) -> Array:
    """A twist as an array, or `InvalidValue`."""
    numbers = np.array(as_floats(value))
    if numbers.shape != (3,) or not np.isfinite(numbers).all() or not numbers.any():
        raise InvalidValue(
            "twist", value, "three finite numbers, not all zero",
            "give (v_x, v_y, omega) of the object's frame about its origin",
        )  # fmt: skip
    return numbers


def _feet_at_rest(feet: Array, twist: Array, tolerance: float) -> Any:
    """Mask of the feet at the center of rotation: the nearest foot, and all at the same place."""
    near = np.zeros(len(feet), dtype=bool)
    if twist[2] == 0.0 or not len(feet):
        return near
    motion = motion_at(twist / np.abs(twist).max(), feet[:, :2])
    speed, spin = np.hypot(motion[:, 0], motion[:, 1]), abs(twist[2]) / np.abs(twist).max()
    size = np.abs(feet[:, :2]).max()
    nearest = speed.argmin()
    if speed[nearest] > spin * max(tolerance, ROUNDING * size):
        return near
    offset = feet[:, :2] - feet[nearest, :2]
    return np.hypot(offset[:, 0], offset[:, 1]) <= ROUNDING * size


def _size(effects: tuple[Any, ...]) -> Number:
    """The largest extent of the supports, or the largest radius of gyration."""
    sizes = [extents(support) for support in supports_of(effects)]
    return max(
        sizes or [effect.gyration_radius for effect in effects if isinstance(effect, Inertia)]
    )
