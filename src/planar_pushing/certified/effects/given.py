"""Scenes and laws from the plain values of a scene file, taken as exact."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from flint import fmpq

from planar_pushing.certified.balls import rational
from planar_pushing.certified.contact.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    coulomb,
)
from planar_pushing.certified.potential import direction
from planar_pushing.certified.potential.direction import Direction
from planar_pushing.certified.potential.resistance import (
    Effect,
    Friction,
    Inertia,
    Load,
    Scene,
    Viscous,
)
from planar_pushing.certified.supports.pressure.pieces import Pieces, Place, pieces

Entry = Mapping[str, Any]


def scene(entry: Entry) -> Scene:
    """Scene of a scene file's entry; rings without a radius have the radius of the slider.

    Angles in a scene file are in degrees.
    """
    slider = entry["slider"]
    radius = slider.get("radius") or 1.0
    effects = tuple(_effect(each, radius) for each in entry["effects"])
    rod = direction.degrees(rational(slider["rod_angle"]))
    return Scene(rational(slider["rod_length"]), rod, effects)


def law(entry: Entry) -> Law:
    """Contact law of a scene file's entry."""
    contact = entry["contact"]
    if contact["law"] == "coulomb":
        return coulomb(float(contact["friction_coefficient"]))
    if contact["law"] == "perfectly_rough":
        return PERFECTLY_ROUGH
    return INFINITE_FREE if contact["at_zero_normal"] == "free" else INFINITE_NONE


def heading(radians: float) -> Direction:
    """The direction at an angle in radians; exact if the angle is a rounded multiple of half a degree."""
    degrees = round(2 * math.degrees(radians)) / 2
    if math.radians(degrees) == radians:
        return direction.degrees(rational(degrees))
    return direction.radians(rational(radians))


def _effect(entry: Entry, radius: float) -> Effect:
    match entry["type"]:
        case "ring_friction":
            return Friction(pieces({"shape": "ring", "radius": radius}), rational(entry["weight"]))
        case "support_friction":
            return Friction(_support(entry, radius), rational(entry["weight"]))
        case "viscous":
            return Viscous(_support(entry, radius), rational(entry["coefficient"]))
        case "inertia":
            gyration = rational(entry["gyration_radius"]) ** 2
            center = _place(entry.get("center") or (0.0, 0.0))
            return Inertia(rational(entry["mass"]), gyration, center)
    place = entry.get("center")
    return Load(_place(entry["force"]), None if place is None else _place(place))


def _support(entry: Entry, radius: float) -> Pieces:
    shape = dict(entry["support"])
    if shape["shape"] == "ring" and shape.get("radius") is None:
        shape["radius"] = radius
    return pieces(shape)


def _place(given: Sequence[float]) -> tuple[fmpq, fmpq]:
    place: Place = rational(given[0]), rational(given[1])
    return place
