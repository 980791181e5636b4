"""Scenes and values as plain data: the content of scene files, and JSON for dataset attributes."""

from __future__ import annotations

import json
import math
from dataclasses import fields
from functools import cache
from importlib.metadata import version
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import Coulomb, InfiniteFriction, PerfectlyRough
from planar_pushing.mechanics.effects import (
    Inertia,
    Load,
    RingFriction,
    SupportFriction,
    Viscous,
)
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import SHAPES, Composite
from planar_pushing.terms.errors import InvalidValue

#: Packages whose versions are recorded in datasets.
PACKAGES = ("planar-pushing", "numpy", "scipy", "xarray", "h5netcdf", "h5py")


def to_json(value: object) -> str:
    """JSON of plain values and models, with infinities as the word inf and sorted keys."""
    return json.dumps(plain(value), sort_keys=True, allow_nan=False)


def plain(value: object) -> object:
    """A value in JSON form; infinities, which JSON lacks, become the words inf and -inf."""
    if hasattr(value, "model_dump"):
        return plain(value.model_dump())
    if isinstance(value, dict):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


@cache
def versions() -> str:
    """Versions of the packages that produce a dataset, as JSON."""
    return to_json({name: version(name) for name in PACKAGES})


def scene_entry(scene: Scene, title: str = "") -> dict[str, Any]:
    """Content of a scene file for this scene; errors as in `save_scene`."""
    slider = scene.slider
    return {
        "title": title,
        "slider": {
            "rod_length": float(slider.rod_length),
            "rod_angle": _degrees(slider.rod_angle),
            "radius": float(slider.radius),
            **_side_entry(slider.side),
            **({} if slider.outline is None else {"outline": list(map(list, slider.outline))}),
        },
        **_place_entry(scene),
        "contact": _contact_entry(scene),
        "effects": [_effect_entry(effect) for effect in scene.effects],
    }


def _place_entry(scene: Scene) -> dict[str, Any]:
    """Placement and units of a scene, if it has them."""
    section: dict[str, Any] = {}
    if scene.placement is not None:
        point, normal = scene.placement.point, scene.placement.normal
        section["placement"] = {"point": list(point), "normal": list(normal)}
    if scene.units is not None:
        section["units"] = {
            each.name: getattr(scene.units, each.name) for each in fields(scene.units)
        }
    return section


def _side_entry(side: tuple[Any, Any]) -> dict[str, list[float]]:
    """The side of a slider, if it has an end."""
    ends = [float(end) for end in side]
    return {"side": ends} if any(map(math.isfinite, ends)) else {}


def _degrees(radians: float) -> float:
    """Shortest number of degrees that `np.deg2rad` converts back to the same radians."""
    degrees = float(np.rad2deg(radians))
    short = [float(f"{degrees:.{digits}g}") for digits in range(1, 18)]
    beside = [float(np.nextafter(degrees, end)) for end in (0.0, 180.0)]
    return next((each for each in short + beside if np.deg2rad(each) == radians), degrees)


def _contact_entry(scene: Scene) -> dict[str, Any]:
    match scene.contact:
        case Coulomb(friction_coefficient=mu):
            return {"law": "coulomb", "friction_coefficient": float(mu)}
        case InfiniteFriction(at_zero_normal=kind):
            return {"law": "infinite_friction", "at_zero_normal": kind}
        case PerfectlyRough():
            return {"law": "perfectly_rough"}
    allowed = "Coulomb, InfiniteFriction and PerfectlyRough"
    raise InvalidValue("contact", scene.contact, allowed, "save a scene of one of these laws")


def _effect_entry(effect: object) -> dict[str, Any]:
    match effect:
        case RingFriction(weight=weight):
            return {"type": "ring_friction", "weight": float(weight)}
        case SupportFriction(support=support, weight=weight):
            support = support_entry(support)
            return {"type": "support_friction", "weight": float(weight), "support": support}
        case Inertia(mass=mass, gyration_radius=radius, center=(x, y)):
            entry = {"type": "inertia", "mass": float(mass), "gyration_radius": float(radius)}
            return entry | ({"center": [float(x), float(y)]} if x or y else {})
        case Viscous(support=support, coefficient=coefficient):
            support = support_entry(support)
            return {"type": "viscous", "coefficient": float(coefficient), "support": support}
        case Load(force=force, center=center):
            entry = {"type": "load", "force": [float(each) for each in force]}
            own = {} if center is None else {"center": [float(each) for each in center]}
            return entry | own
    allowed = "SupportFriction, RingFriction, Inertia, Viscous and Load"
    raise InvalidValue("effects", effect, allowed, "save a scene of these effects")


def is_in_files(support: Any) -> bool:
    """Whether a scene file can describe a support: all but supports of user-defined kinds."""
    members = getattr(support, "members", ()) if type(support) is Composite else ()
    return type(support) in SHAPES.values() and all(is_in_files(one) for _, one in members)


def support_entry(support: Any) -> dict[str, Any]:
    """A support in the form of scene files: its shape and the parameters of the shape.

    One of a user-defined kind, which files cannot describe, is the name of its class and its pieces.
    """
    names = {kind: shape for shape, kind in SHAPES.items()}
    if type(support) not in names:
        atoms, segments, rings, discs, plates = support.pieces()
        lines = {"atoms": atoms, "segments": segments, "rings": rings, "discs": discs}
        pieces = {kind: rows.tolist() for kind, rows in lines.items() if len(rows)}
        pieces |= {"plates": [edges.tolist() for edges in plates]} if plates else {}
        return {"shape": type(support).__name__, "pieces": pieces}
    entry: dict[str, Any] = {"shape": names[type(support)]}
    for each in fields(support):
        value = getattr(support, each.name)
        if each.name == "members":
            value = [{"share": share, "support": support_entry(one)} for share, one in value]
        if value not in (None, ()):
            entry[each.name] = value
    return entry
