"""Contacts of pushes: the sides that a finger can push, and the resulting motions.

A finger that touches a side first pushes that side. At a corner it pushes one of the two sides, with the
normal of that side, or sticks to the corner, with a force between the two normals.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np

from planar_pushing.core.supports.chain import StretchRow
from planar_pushing.mechanics.kernels.arrays import Output, map_kernel
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.places import (
    chain_rows,
    depth_tolerance,
    places_with_normals,
)
from planar_pushing.mechanics.plane import Array
from planar_pushing.objects.boundary import nearest, sides_of
from planar_pushing.pushes.logs.measured import Index, Mask, Measured
from planar_pushing.terms.errors import SceneWarning, warn_user

#: A finger that leaves a side within this fraction of its path does not push it.
AT_ONCE = 1e-3
#: A finger goes on pushing another side if it ends there, within these standard deviations of a position
#: or this part of the object's size, and farther than that from the first side.
SURE, CLOSE = 3.0, 1e-3
#: Fraction of an object's pushes of which estimates are biased; fits discount fewer as outliers. In the
#: published pushes of polygons it is at most 0.005.
BIASED = 0.1
#: Smallest distance of a contact from the end of a side, as a fraction of the object's size.
INSIDE = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class Contacts:
    """Contacts of pushes: arrays over m contacts, in the object's frame before the push.

    Attributes
    ----------
    push : ndarray of int, shape (m,)
        Number of the push, in increasing order.
    point, normal : ndarray, shape (m, 2)
    start, end : ndarray, shape (m,)
        Ends of the side, or of the part of it on which the finger meets no other side, measured from the
        point along the tangent, which is the normal rotated by -90 degrees.
    path : ndarray, shape (m, parts, 2)
        Displacements of the finger's center over equal parts of its path.
    radius : ndarray, shape (m,)
        Radius of the finger.
    sticks : ndarray of bool, shape (m,)
        Whether the finger sticks to a corner.
    aligned : ndarray, shape (m,)
        Cosine of the angle between this normal and the finger's normal at first touch.
    """

    push: Index
    point: Array
    normal: Array
    start: Array
    end: Array
    path: Array
    radius: Array
    sticks: Mask
    aligned: Array

    @property
    def tangent(self) -> Array:
        """Unit tangents, along the x axis of the fence frame, shape (m, 2)."""
        return np.column_stack([self.normal[:, 1], -self.normal[:, 0]])


class Ends(NamedTuple):
    """Ends of motions: poses (x, y, angle), shape (..., contacts, 3), and the duration of the contact.

    `lasted` is the duration as a fraction of the finger's path, shape (..., contacts).
    """

    poses: Array
    lasted: Array


class Model(Protocol):
    """A model of support friction in the object's frame."""

    def ends(self, contacts: Contacts, friction: float) -> Ends:
        """Displacements of the object's frame by the pushes, for a contact friction coefficient."""

    def wrenches(self, twists: Array) -> Array:
        """Directions of the wrenches for twists of shape (n, 3)."""

    def motions(self, wrenches: Array) -> Array:
        """Directions of the twists for wrenches of shape (n, 3); NaN if there is no motion."""


def contacts_of(pushes: Measured) -> Contacts:
    """Contacts of pushes: one for a push at a side, three for a push at a corner."""
    sides, corner = sides_of(pushes.outline), pushes.at_corner
    touch = nearest(sides, pushes.contact)
    vertex = np.hypot(*np.moveaxis(pushes.contact[:, None] - sides.start, -1, 0)).argmin(axis=1)
    rows: list[tuple[int, int, float, bool]] = []
    for i in range(len(pushes)):
        if not corner[i]:
            rows.append((i, int(touch.side[i]), float(touch.position[i]), False))
            continue
        before, behind = (int(vertex[i]) - 1) % len(sides.length), int(vertex[i])
        rows += [
            (i, before, float(sides.length[before]), False),
            (i, behind, 0.0, False),
            (i, behind, 0.0, True),
        ]
    push, side, position, sticks = (np.array(column) for column in zip(*rows, strict=True))
    normal = np.where(sticks[:, None], pushes.normal[push], sides.normal[side])
    start = np.where(sticks, -np.inf, -np.maximum(position, INSIDE * sides.scale))
    end = np.where(sticks, np.inf, np.maximum(sides.length[side] - position, INSIDE * sides.scale))
    contacts = Contacts(
        push=push, point=pushes.contact[push], normal=normal, start=start, end=end,
        path=pushes.path[push], radius=np.where(sticks, 0.0, pushes.radius[push]), sticks=sticks,
        aligned=(normal * pushes.normal[push]).sum(axis=1),
    )  # fmt: skip
    return _within_reach(contacts, Outline(pushes.outline))


def _within_reach(contacts: Contacts, outline: Outline) -> Contacts:
    """Contacts whose sides end where the finger meets another side or corner."""
    inside, unit, chain = INSIDE * outline.size, depth_tolerance(outline), chain_rows(outline)
    places = places_with_normals(outline, contacts.point, contacts.normal)
    columns = row_of(
        StretchRow, piece=places.piece, radius=contacts.radius / unit,
        place=places.position / unit, count=len(chain), first=0,
    )  # fmt: skip
    outputs = [Output("low"), Output("high")]
    stretch = map_kernel("stretches_of_pieces", chain.ravel(), columns, outputs)
    low, high = (unit * end - places.position for end in stretch)
    return replace(
        contacts,
        start=np.maximum(contacts.start, np.minimum(low, -inside)),
        end=np.minimum(contacts.end, np.maximum(high, inside)),
    )


def goes_around_corners(pushes: Measured) -> Mask:
    """Whether the finger of each push goes on pushing beyond the side that it touched first, shape (n,).

    Contacts end with this side, after which the object rests in the model. A finger that has left the
    object behind at the end, or pushes a corner, does not count.
    """
    sides = sides_of(pushes.outline)
    side, last = nearest(sides, pushes.contact).side, pushes.last_contacts
    along = ((last - sides.start[side]) * sides.tangent[side]).sum(axis=1)
    on_side = np.clip(along, 0.0, sides.length[side])[:, None] * sides.tangent[side]
    beyond = np.hypot(*(last - sides.start[side] - on_side).T)
    slack = max(SURE * pushes.noise[0], CLOSE * sides.scale)
    return np.asarray(~pushes.at_corner & (pushes.last_gaps < slack) & (beyond > slack))


def warn_of_corners(objects: Mapping[str, Measured]) -> None:
    """Warn once if fingers go around corners in too many of the pushes of some objects."""
    biased = {}
    for name, pushes in objects.items():
        count = int(goes_around_corners(pushes).sum())
        if count > BIASED * len(pushes):
            biased[name] = f"{count} of {len(pushes)} pushes of {name}"
    if biased:
        message = (
            f"pushes: in {', '.join(biased.values())}, the finger leaves the side that it touched "
            "first and pushes the next one; the models take such a push to end at the corner, so "
            "estimates may be biased; use an object with long sides, an outline with few corners, "
            "or shorter pushes"
        )
        warn_user(SceneWarning(message))


def final_poses(model: Model, pushes: Measured, friction: float) -> Array:
    """Displacement and rotation of the object's frame by each push, shape (n, 3).

    At a corner, the finger pushes the side with the longer contact; if they are equal, the side with the
    normal closer to the finger's. If the finger leaves both sides at once, it sticks to the corner.
    """
    contacts = contacts_of(pushes)
    ends = model.ends(contacts, friction)
    return choose(contacts, ends)


def choose(contacts: Contacts, ends: Ends) -> Array:
    """Motion of each push, from one of its contacts."""
    # Durations are compared up to rounding error.
    lasted = np.round(np.where(contacts.sticks, AT_ONCE, ends.lasted) / AT_ONCE)
    order = np.lexsort([-contacts.aligned, -lasted, contacts.push])
    _, first = np.unique(contacts.push[order], return_index=True)
    return np.asarray(ends.poses[order[first]])
