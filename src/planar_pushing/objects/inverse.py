"""The inverse question: which pushes give an object a twist."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.numerics.arrays import same
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.contacts import Contact, Stretch, stretches
from planar_pushing.objects.resistance import motion_at, require_friction, required_effects
from planar_pushing.objects.sides import Side, sides
from planar_pushing.objects.wrench_set import required_twist, wrench_set


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Push:
    """A contact on an object's outline through which a sticking push gives a twist.

    Attributes
    ----------
    point : ndarray, shape (2,)
        The contact, in the object's frame.
    normal : ndarray, shape (2,)
        Unit normal of its side, into the object.
    force : ndarray, shape (2,)
        Force of the pusher on the object; where the load of the twist leaves several, the one that needs
        the least friction.
    velocity : ndarray, shape (2,)
        Motion of the pusher, that of the object's point at the contact: a velocity, and with inertia an
        initial acceleration.
    friction_coefficient : float
        The least mu of the contact under which it sticks.
    ends : tuple of two Push, or empty
        Ends of an interval of contacts on the side, each of which gives the twist where the object turns
        about a foot. The push itself is then that of the least friction in the interval. An end at which
        the least friction is infinite is itself no contact.
    """

    point: Array
    normal: Array
    force: Array
    velocity: Array
    friction_coefficient: float
    ends: tuple[Push, ...] = ()

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def __repr__(self) -> str:
        vectors = (
            f"{name}={_pair(getattr(self, name))}"
            for name in ("point", "normal", "force", "velocity")
        )
        between = " to ".join(_pair(each.point) for each in self.ends)
        ends = f", ends at {between}" if self.ends else ""
        return f"Push({', '.join(vectors)}, friction_coefficient={self.friction_coefficient:.6g}{ends})"


def _pair(vector: Array) -> str:
    """A vector in text; adding 0 leaves no negative zeros."""
    x, y = vector + 0.0
    return f"({x:.6g}, {y:.6g})"


def pushes_for(effects: tuple[Effect, ...], twist: npt.ArrayLike, outline: Any) -> tuple[Push, ...]:
    """Every contact on an object's outline through which a sticking push gives a twist.

    Parameters
    ----------
    effects : tuple of SupportFriction, Viscous, Inertia and Load
        In the object's own frame; at least one that is no load. With inertia the twist is an initial
        acceleration from rest, and viscous friction is absent.
    twist : array_like, shape (3,)
        (v_x, v_y, omega) of the object's frame about its origin, omega in radians per unit of time.
    outline : array_like, shape (n, 2), or an object with `coords` or `exterior`
        Corners of a simple polygon, in order, in the object's frame.

    Returns
    -------
    tuple of Push
        By the friction that they need, the least first; empty where no contact gives the twist. A corner
        is a contact of each of its two sides, with the normal of each.

    Raises
    ------
    InvalidValue
        If the outline is not a simple polygon, the twist is not three finite numbers or is zero, or an
        effect is none of these, has arrays of parameters, or is a ring without a radius; where friction
        cannot hold a load without inertia.

    Notes
    -----
    The load of a twist is one wrench. A pusher's force acts along its line of action, which meets the
    outline in points; where it enters the object, with a component along the inward normal, is a contact.
    Where the object turns about a foot, that foot takes any force up to its share of the weight: the loads
    are the set of `wrench_set`, and the contacts fill intervals. A line of action along a side needs
    infinite friction, and counts as no contact.
    """
    motion, found = required_twist(twist), sides(outline)
    require_friction(required_effects(effects))
    loads = wrench_set(effects, motion)
    pushes = [_push(side, motion, stretch) for side in found for stretch in stretches(side, loads)]
    return tuple(sorted(pushes, key=lambda each: each.friction_coefficient))


def _push(side: Side, twist: Array, stretch: Stretch) -> Push:
    best, *ends = stretch
    several = ends[0].place < ends[1].place
    return _at(side, twist, best, (_at(side, twist, each) for each in ends if several))


def _at(side: Side, twist: Array, contact: Contact, ends: Iterable[Push] = ()) -> Push:
    point = side.start + contact.place * side.tangent
    if contact.place == side.length:
        point = side.end
    return Push(
        point=point,
        normal=side.normal,
        force=contact.along * side.tangent + contact.normal * side.normal,
        velocity=motion_at(twist, point),
        friction_coefficient=contact.friction,
        ends=tuple(ends),
    )
