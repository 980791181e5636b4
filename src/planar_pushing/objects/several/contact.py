"""A contact of an object with a pusher or a wall of its own, in the object's frame."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.contact import as_numbers, is_law
from planar_pushing.mechanics.kernels.arrays import is_labeled, same
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import RHO
from planar_pushing.mechanics.outline.places import places_with_normals
from planar_pushing.mechanics.slider import ALIGNED, inner_corners
from planar_pushing.objects.many import require_contacts
from planar_pushing.objects.on_outline import on_outline, side_on_fence
from planar_pushing.terms.declared import positive
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import as_numbers as plain_numbers
from planar_pushing.terms.numbers import remedy_for

#: Maximum number of contacts; a side counts as two.
MOST_CONTACTS = 4
GRIP_FORCE = positive("leave it out if the finger moves as given along its normal, too")


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact of an object with a finger or a wall, or of one of its sides with a palm.

    Parameters
    ----------
    point : (x, y), optional
        Position in the object's frame.
    normal : (n_x, n_y), optional
        Normal there, into the object, of any length. It can be omitted if the object has an outline and the
        contact is not at a corner. At an inner corner, a contact without a normal is two: one with the side
        before the corner and one with the side after it.
    law : ContactLaw, or array of laws
    velocity : (v_x, v_y), or array of shape S + (2,), optional
        Velocity of the pusher there, or its acceleration from rest, in the object's frame; by default that
        of a wall at rest. Each component can be an array.
    twist : (v_x, v_y, omega), or array of shape S + (3,), optional
        Instead of a velocity: the twist of a pusher that turns, omega in radians per unit of time. It is
        about the origin of the object's frame.
    side : int, optional
        Instead of a point: the number of a side of the outline, as in `scene_at`. A side is two contacts,
        at its ends, of one pusher.
    grip_force : float or array, optional
        Normal force of a finger of a gripper that is driven by force. It follows the object along the
        normal, so that only the component of its velocity along the tangent counts.

    Raises
    ------
    InvalidValue
        If there is no law, neither or both of point and side are given, or both of velocity and twist, or a
        number is not finite, or a grip force is not positive or that of a side.
    """

    point: Any = None
    normal: Any = None
    _: KW_ONLY
    law: Any = None
    velocity: Any = None
    twist: Any = None
    side: Any = None
    grip_force: Any = None

    def __post_init__(self) -> None:
        laws = [self.law] if is_law(self.law) else np.ravel(np.asarray(self.law, dtype=object))
        if not len(laws) or not all(map(is_law, laws)):
            raise InvalidValue(
                "law", self.law, "Coulomb, InfiniteFriction or PerfectlyRough",
                "construct one of these laws",
            )  # fmt: skip
        if (self.point is None) == (self.side is None):
            raise InvalidValue(
                "point", self.point, "either a point or a side",
                "give (x, y) of the contact, or the number of a side of the outline",
            )  # fmt: skip
        if self.side is not None and self.normal is not None:
            raise InvalidValue(
                "normal", self.normal, "none together with a side", "leave it out: the side has one"
            )
        if self.velocity is not None and self.twist is not None:
            raise InvalidValue(
                "twist", self.twist, "either a velocity or a twist", "leave out one of them"
            )
        if self.grip_force is not None:
            GRIP_FORCE.require("grip_force", self.grip_force)
            if self.side is not None:
                raise InvalidValue(
                    "grip_force", self.grip_force, "none together with a side",
                    "give the point at which the finger presses",
                )  # fmt: skip
        if self.point is not None:
            _require_single("point", self.point)
            if self.normal is not None:
                _require_single("normal", self.normal)
            require_contacts(self.point, self.normal)
        if self.twist is None:
            _ = components("velocity", (0.0, 0.0) if self.velocity is None else self.velocity, 2)
        else:
            _ = components("twist", self.twist, 3)

    def __eq__(self, other: object) -> Any:
        return same(self, other)


class PlacedContact(NamedTuple):
    """A contact at one point, in numbers.

    Attributes
    ----------
    point, normal : tuple of two floats
        In the object's frame; the normal is a unit vector.
    velocity : tuple of two numbers or arrays
        Of the pusher at the point.
    law : Any
        The law.
    grip_force : number or array, optional
        Normal force, if the finger is driven by force.
    """

    point: tuple[float, float]
    normal: tuple[float, float]
    velocity: tuple[Number, Number]
    law: Any
    grip_force: Number | None = None

    @property
    def numbers(self) -> Any:
        """The law in the form of the core."""
        return as_numbers(self.law)


def place_contacts(contacts: Any, outline: Outline | None, drawing: Any) -> list[PlacedContact]:
    """The points of contacts on an object; a side is two of them, and an inner corner, too.

    Parameters
    ----------
    contacts : sequence of Contact
    outline : Outline, optional
    drawing : object
        The outline as given, which numbers the sides.

    Raises
    ------
    InvalidValue
        If there are no contacts or more than four, one is of another type, a contact is not on the outline,
        its normal is not that of the outline, or two contacts are the same.
    """
    kinds = list(contacts) if isinstance(contacts, (list, tuple)) else []
    if not kinds or not all(isinstance(contact, Contact) for contact in kinds):
        raise InvalidValue(
            "contacts", contacts, "a list of one to four Contact",
            "construct them, as in [pp.Contact((-1, 0), law=pp.Coulomb(0.5), velocity=(1, 0))]",
        )  # fmt: skip
    placed: list[PlacedContact] = []
    for contact in kinds:
        if contact.side is not None:
            placed += _ends_of_side(contact, outline, drawing)
        else:
            placed += _place(contact, outline)
    if len(placed) > MOST_CONTACTS:
        raise InvalidValue(
            "contacts", f"{len(placed)} points of contact", f"at most {MOST_CONTACTS}; a side is two",
            "leave out those that do not touch, or replace several on one side by the side",
        )  # fmt: skip
    size = 1.0 if outline is None else outline.size
    size = max([size, *(float(np.hypot(*one.point)) for one in placed)])
    for i, one in enumerate(placed):
        for other in placed[:i]:
            apart = np.hypot(one.point[0] - other.point[0], one.point[1] - other.point[1])
            turned = np.hypot(one.normal[0] - other.normal[0], one.normal[1] - other.normal[1])
            if apart <= 1e-9 * size and turned <= 1e-9:
                raise InvalidValue(
                    "contacts", f"two contacts at {one.point} with one normal", "different contacts",
                    "leave out one of them",
                )  # fmt: skip
    return placed


def _place(contact: Contact, outline: Outline | None) -> list[PlacedContact]:
    """A contact at a point; at an inner corner, without a normal, one with each side."""
    places = require_contacts(contact.point, contact.normal)
    if outline is None:
        if contact.normal is None:
            raise InvalidValue(
                "normal", None, "(n_x, n_y) without an outline", "give the inward normal"
            )
        placement = places.placement
    else:
        spot = None
        if contact.normal is not None:
            spot = places_with_normals(outline, places.points, places.normals)
            turned = np.hypot(*(spot.normal - places.normals).T)[0]
            on_side = np.isinf(outline.pieces[spot.piece[0], RHO])
            if not (on_side and turned <= ALIGNED and spot.gap[0] <= outline.tolerance):
                spot = None
        if spot is not None:
            (x, y), (n_x, n_y) = (spot.point[0] + 0.0).tolist(), (spot.normal[0] + 0.0).tolist()
            return [_with_velocity(contact, (x, y), (n_x, n_y))]
        placement, _ = on_outline(places, outline)
        x, y = map(float, placement.point)
        for corner in inner_corners(outline):
            if math.hypot(x - corner.x, y - corner.y) <= outline.tolerance:
                directions = corner.middle + corner.half, corner.middle - corner.half
                return [
                    _with_velocity(contact, (x, y), (-math.sin(beta), math.cos(beta)))
                    for beta in directions
                ]
    (x, y), (n_x, n_y) = placement.point, placement.normal
    return [_with_velocity(contact, (float(x), float(y)), (float(n_x), float(n_y)))]


def _ends_of_side(contact: Contact, outline: Outline | None, drawing: Any) -> list[PlacedContact]:
    """Both ends of a side, from its start."""
    if outline is None:
        raise InvalidValue(
            "outline", None, "the corners of the object, to number its sides", "give the outline"
        )
    placement, ends, _ = side_on_fence(contact.side, drawing)
    (x, y), (n_x, n_y) = placement.point, placement.normal
    return [
        _with_velocity(contact, (float(x + end * n_y), float(y - end * n_x)), (n_x, n_y))
        for end in ends
    ]


def _with_velocity(
    contact: Contact, point: tuple[float, float], normal: tuple[float, float]
) -> PlacedContact:
    """A placed contact with the velocity of its pusher."""
    if contact.twist is None:
        rest = (0.0, 0.0) if contact.velocity is None else contact.velocity
        x, y = components("velocity", rest, 2)
    else:
        v_x, v_y, omega = components("twist", contact.twist, 3)
        x, y = v_x - omega * point[1], v_y + omega * point[0]
    force = contact.grip_force
    if force is not None:
        force = GRIP_FORCE.require("grip_force", force)
    return PlacedContact(point, normal, (x, y), contact.law, force)


def _require_single(name: str, value: Any) -> None:
    """Refuse what is not two numbers: an array of points is no list of contacts."""
    if np.shape(value) != (2,):
        raise InvalidValue(
            name, value, "two finite numbers", "give a Contact for each point of contact"
        )


def components(name: str, value: Any, count: int) -> tuple[Number, ...]:
    """The components of a velocity or a twist: numbers, or arrays that can be labeled.

    Raises
    ------
    InvalidValue
        If the number of components differs, or a number is not finite.
    """
    words = {2: "(v_x, v_y), of numbers or arrays", 3: "(v_x, v_y, omega), of numbers or arrays"}
    allowed, remedy = words[count], "give finite components in the object's frame"
    parts: Sequence[Any]
    if isinstance(value, (tuple, list)) and len(value) == count:
        parts = value
    else:
        numbers = plain_numbers(value)
        if numbers is None or np.shape(numbers)[-1:] != (count,):
            raise InvalidValue(name, value, allowed, remedy_for(value, remedy))
        last = {numbers.dims[-1]: slice(None)} if is_labeled(numbers) else None
        parts = [
            numbers.isel(dict.fromkeys(last, i), drop=True) if last else numbers[..., i]
            for i in range(count)
        ]
    converted: list[Any] = [plain_numbers(part) for part in parts]
    if any(part is None or not np.isfinite(part).all() for part in converted):
        raise InvalidValue(name, value, allowed, remedy_for(value, remedy))
    return tuple(
        float(part) if not np.ndim(part) and not is_labeled(part) else part for part in converted
    )
