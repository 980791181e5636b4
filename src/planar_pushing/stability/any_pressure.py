"""What holds for every pressure on a known base whose center of pressure is known."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.contact import ContactLaw, is_law
from planar_pushing.mechanics.plane import Array, Frame, Placement, direction
from planar_pushing.mechanics.supports import Points
from planar_pushing.stability.base_region import base_at
from planar_pushing.stability.force_bounds import EDGE, Forces
from planar_pushing.stability.linear_program import Candidates
from planar_pushing.stability.rotation_bounds import SPIN, End, rotation_end
from planar_pushing.terms.errors import InvalidValue, require_positive

#: Rounding errors of a rotation and of a force that are converted to the user's units.
ROUNDING = 1e-15


@dataclass(frozen=True, eq=False, repr=False)
class AnyPressure:
    """What every pressure with a given center allows at a contact that sticks and has a given velocity.

    Bounds are proved: what happens under any pressure lies between them. Some pressure attains the numbers
    whose names begin with `attained`, so that no bounds can be tighter than these. Forces are computed when
    they are first used, which takes half a second to ten seconds.

    Attributes
    ----------
    rotation : tuple of float
        Bounds (low, high) of the rotation omega of the object, radians per unit of time; infinite if all
        weight can rest on the contact.
    attained_rotation : tuple of float
        Usually within 1e-8 of the bounds, times the speed of the contact over the size of the base; farther
        from them if the contact is close to the center of pressure, or that center to the rim of the base.
    supports : tuple of two Points
        Pressures with the given center under which the object rotates at the low and at the high end of
        `attained_rotation`, as supports in the frame of the region.
    force : ndarray, shape (2 bounds, 2 components)
        Bounds of the components of the contact force on the object, in the frame of the region.
    attained_force : ndarray, shape (2, 2)
        Usually within 5e-4 of the bounds, times the weight.
    force_angle : AngleInterval
        Bounds of the direction of the contact force, in the frame of the region.
    attained_force_angle : AngleInterval
    """

    rotation: tuple[float, float]
    attained_rotation: tuple[float, float]
    supports: tuple[Points, Points]
    _forces: Forces
    _weight: float

    def __repr__(self) -> str:
        low, high = self.rotation
        return f"AnyPressure(rotation=({low:.6g}, {high:.6g}))"

    @property
    def force(self) -> Array:
        return self._force[0]

    @property
    def attained_force(self) -> Array:
        return self._force[1]

    @property
    def force_angle(self) -> AngleInterval:
        return self._angle[0]

    @property
    def attained_force_angle(self) -> AngleInterval:
        return self._angle[1]

    def sticks(self, normal: npt.ArrayLike, contact: ContactLaw) -> bool:
        """Whether the contact can stick under every pressure: the force is within the friction cone.

        Parameters
        ----------
        normal : (n_x, n_y)
            Normal of the fence or of the finger's side, into the object, in the frame of the region.
        contact : ContactLaw

        Returns
        -------
        bool
            True is proved. False means that the contact cannot stick under some pressure, or that the force
            comes within 1e-7 of the weight of the cone's edge.

        Raises
        ------
        InvalidValue
            If the normal is not a nonzero vector, or the contact is not a law.
        """
        edges = cone_sides(_fence(normal), contact)
        if edges is None:
            return True
        limit = ROUNDING if np.all(contact.force_angles.closed) else -EDGE
        return all(self._forces.keeps_within(outward, limit) for outward in edges)

    @cached_property
    def _force(self) -> tuple[Array, Array]:
        """Proved and attained bounds of the components."""
        axes = ((-1.0, 0.0), (0.0, -1.0)), ((1.0, 0.0), (0.0, 1.0))
        proved = [[self._forces.proved_maximum(np.array(axis)) for axis in side] for side in axes]
        attained = [
            [self._forces.attained_maximum(np.array(axis)) for axis in side] for side in axes
        ]
        signs = np.array([[-1.0], [1.0]])
        outward = np.array(proved) + ROUNDING
        return self._weight * signs * outward + 0.0, self._weight * signs * np.array(attained) + 0.0

    @cached_property
    def _angle(self) -> tuple[AngleInterval, AngleInterval]:
        """Proved and attained bounds of the direction."""
        u = self._forces.base.motion
        middle = math.atan2(u[1], u[0])
        (right, far_right), (left, far_left) = (
            self._forces.extreme_angle(side) for side in (-1, 1)
        )
        return (
            AngleInterval(middle - far_right, middle + far_left),
            AngleInterval(middle - right, middle + left),
        )


def any_pressure(
    region: Any,
    center_of_pressure: npt.ArrayLike,
    *,
    point: npt.ArrayLike,
    velocity: npt.ArrayLike,
    weight: float = 1.0,
) -> AnyPressure:
    """What holds for every pressure on a known base with a known center, at a contact that sticks.

    Parameters
    ----------
    region : sequence of pairs, an object with `coords` or `exterior`, or a support
        The base: an outline, whose inside may carry weight, or a support, any part of which may carry
        weight, whatever its own pressure is. For feet give `Points`.
    center_of_pressure : (x, y)
        In the frame of the region; for a slow push low above the table, the point below the center of mass.
    point : (x, y)
        The contact.
    velocity : (v_x, v_y)
        Velocity of the pusher, and of the object at the contact.
    weight : float, optional
        W, the friction of the whole base.

    Returns
    -------
    AnyPressure

    Raises
    ------
    InvalidValue
        If the region is neither an outline nor a support, a pair is not two finite numbers, the velocity is
        zero, the weight is not positive, or the center of pressure is outside of the region's convex hull.

    Notes
    -----
    At a given rotation the load is linear in the pressure, and extreme for a pressure on a few points. An
    affine function of the place that bounds the contribution of each point proves the bound for every
    pressure (E. Huang, A. Bhatia, B. Boots and M. T. Mason, "Exact bounds on the contact driven motion of a
    sliding object, with applications to robotic pulling", 2017). Only friction with the table resists the
    motion.
    """
    base = base_at(region, center_of_pressure, point, velocity)
    size = require_positive(
        "weight", weight, "give W, the friction coefficient times the normal force"
    )
    candidates = Candidates.of(base)
    ends = rotation_end(candidates, -1), rotation_end(candidates, 1)
    origin, rate = np.asarray(point, dtype=float), base.rate
    low_end, high_end = ends
    return AnyPressure(
        rotation=(_rotation(low_end.proved, rate, -1), _rotation(high_end.proved, rate, 1)),
        attained_rotation=(
            _rotation(low_end.attained, rate, 0),
            _rotation(high_end.attained, rate, 0),
        ),
        supports=(_feet(low_end, base.size, origin), _feet(high_end, base.size, origin)),
        _forces=Forces(candidates, ends),
        _weight=size,
    )


def _feet(end: End, size: float, origin: Array) -> Points:
    """The pressure of an end, in the frame of the region."""
    return Points(end.pressure.points * size + origin, end.pressure.shares)


def _rotation(eta: float, rate: float, outward: int) -> float:
    """The rotation omega, enlarged by its rounding error in a sense."""
    if abs(eta) >= SPIN:
        return math.copysign(math.inf, eta)
    omega = rate * math.tan(eta)
    return omega + outward * ROUNDING * (abs(omega) + rate)


def _fence(normal: npt.ArrayLike) -> Frame:
    """The fence frame at the origin."""
    return Placement((0.0, 0.0), normal).fence  # type: ignore[arg-type]


def cone_sides(fence: Frame, contact: ContactLaw) -> tuple[Array, Array] | None:
    """Outward normals of the two edges of a law's cone of forces; None if every force is in it."""
    if not is_law(contact):
        raise InvalidValue("contact", contact, "a contact law", "construct one, as in Coulomb(0.5)")
    cone = contact.force_angles
    if cone.span > 2.0 * math.pi - EDGE:
        return None
    right, left = direction(float(cone.right)), direction(float(cone.left))
    return fence.vector_out([right[1], -right[0]]), fence.vector_out([-left[1], left[0]])
