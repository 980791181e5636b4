"""The inverse problem: the pushes that give an object a desired twist."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import OutlineArc, OutlineSide, sides_and_arcs
from planar_pushing.objects.contacts import Contact, Stretch, stretches, stretches_on_arc
from planar_pushing.objects.resistance import motion_at, require_effects, require_friction
from planar_pushing.objects.wrench_set import require_twist, wrench_set

#: Distance between the points and normals of one contact on two pieces that join smoothly.
SAME = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Push:
    """A contact on an object's outline through which a sticking push gives a twist.

    Attributes
    ----------
    point : ndarray, shape (2,)
        The contact, in the object's frame.
    normal : ndarray, shape (2,)
        Unit normal of its side or arc, into the object.
    force : ndarray, shape (2,)
        Force of the pusher on the object; if several are possible, the one that needs the least friction.
    velocity : ndarray, shape (2,)
        Motion of the pusher, equal to that of the object at the contact: a velocity, or with inertia an
        initial acceleration.
    friction_coefficient : float
        Minimum mu for which the contact sticks.
    ends : tuple of two Push, or empty
        Ends of an interval of contacts on the side or arc, all of which give the twist because the object
        turns about a foot. The push itself is then the one of least friction in the interval. An end with
        infinite minimum friction is not itself a contact.
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
        between = " to ".join(_pair(push.point) for push in self.ends)
        ends = f", ends at {between}" if self.ends else ""
        return f"Push({', '.join(vectors)}, friction_coefficient={self.friction_coefficient:.6g}{ends})"


def _pair(vector: Array) -> str:
    """A vector as text; adding 0 removes negative zeros."""
    x, y = vector + 0.0
    return f"({x:.6g}, {y:.6g})"


def pushes_for(effects: tuple[Effect, ...], twist: npt.ArrayLike, outline: Any) -> tuple[Push, ...]:
    """Every contact on an object's outline through which a sticking push gives a twist.

    Parameters
    ----------
    effects : tuple of SupportFriction, Viscous, Inertia and Load
        In the object's own frame; at least one other than a load. With inertia the twist is an initial
        acceleration from rest, and viscous friction is absent. Masses without a center or a radius of
        gyration are completed from the outline, as in `scene_at`.
    twist : array_like, shape (3,)
        (v_x, v_y, omega) of the object's frame about its origin, omega in radians per unit of time.
    outline : array_like, shape (n, 2), Polygon, Disc, Outline, or an object with `coords` or `exterior`
        Corners of a simple polygon, in order, or an outline with arcs and holes, in the object's frame.

    Returns
    -------
    tuple of Push
        In order of increasing minimum friction; empty if no contact gives the twist. A corner is a contact
        of both of its sides, with the normal of each. At an inner corner, where a pusher touches both,
        `scene_at` and `solve` tell which pushes of a point give a twist.

    Raises
    ------
    InvalidValue
        If the outline is not one, the twist is not three finite numbers or is zero, or an
        effect is of another type, has arrays of parameters, or is a ring without a radius; or if friction
        cannot hold a load without inertia.

    Notes
    -----
    The load of a twist is one wrench, and its line of action meets the outline at points. A point at which
    the force has a component along the inward normal is a contact. If the object turns about a foot, that
    foot takes any force up to its share of the weight: the loads are then the set of `wrench_set`, and the
    contacts fill intervals. A line of action along a side needs infinite friction and does not count as a
    contact.

    On a side all of this is in closed form. A line of action meets an arc in closed form, too. The ends of
    an interval on an arc are roots of polynomials of fourth degree. Its contact of least friction is found
    by a search that begins with 65 places, so its place is exact to about 1e-8 radians.
    """
    whole = require_outline(outline)
    motion, parts = require_twist(twist), sides_and_arcs(whole)
    acting = require_effects(effects, whole)
    require_friction(acting)
    loads = wrench_set(acting, motion)
    pushes: list[Push] = []
    for part in parts:
        for stretch in (
            stretches_on_arc(part, loads)
            if isinstance(part, OutlineArc)
            else stretches(part, loads)
        ):
            _add(pushes, _push(part, motion, stretch))
    return tuple(sorted(pushes, key=lambda push: push.friction_coefficient))


def _add(pushes: list[Push], push: Push) -> None:
    """Add a push, unless it is the same contact where a side and an arc join smoothly."""
    size = 1.0 + np.hypot(*push.point)
    for other in pushes:
        apart = np.hypot(*(other.point - push.point)) / size + np.hypot(
            *(other.normal - push.normal)
        )
        if not push.ends and not other.ends and apart < SAME:
            return
    pushes.append(push)


def _push(part: OutlineSide | OutlineArc, twist: Array, stretch: Stretch) -> Push:
    best, *ends = stretch
    several = ends[0].position != ends[1].position
    return _push_at(part, twist, best, (_push_at(part, twist, end) for end in ends if several))


def _push_at(
    part: OutlineSide | OutlineArc, twist: Array, contact: Contact, ends: Iterable[Push] = ()
) -> Push:
    point, tangent, normal = part.frame(contact.position)
    return Push(
        point=point,
        normal=normal,
        force=contact.along * tangent + contact.normal * normal,
        velocity=motion_at(twist, point),
        friction_coefficient=contact.friction,
        ends=tuple(ends),
    )
