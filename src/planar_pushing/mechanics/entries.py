"""Scenes and values as plain data: the content of scene files, and JSON for dataset attributes."""

from __future__ import annotations

import json
import math
from functools import cache
from importlib.metadata import version
from typing import Any

from planar_pushing.mechanics.contact import LAWS
from planar_pushing.mechanics.effects import EFFECTS, Inertia
from planar_pushing.mechanics.outline.entries import OUTLINE
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import SHAPES
from planar_pushing.mechanics.supports.base import SUPPORT, SUPPORTS
from planar_pushing.mechanics.supports.composite import MEMBERS
from planar_pushing.terms.declared import declarations_of
from planar_pushing.terms.errors import InvalidValue

#: Packages whose versions are recorded in datasets.
PACKAGES = ("planar-pushing", "numpy", "scipy", "xarray", "h5netcdf", "h5py")
#: Classes that a key of a file tells apart: the key and its word.
TAGS = {
    kind: {key: word}
    for key, kinds in (("law", LAWS), ("type", EFFECTS), ("shape", SHAPES))
    for word, kind in kinds.items()
}


def to_json(value: object) -> str:
    """JSON of plain values and models, with infinities as the word inf and sorted keys."""
    return json.dumps(plain(value), sort_keys=True, allow_nan=False)


def plain(value: object) -> object:
    """A value in JSON form; infinities, which JSON lacks, become the words inf and -inf."""
    if hasattr(value, "model_dump"):
        return plain(value.model_dump())
    if isinstance(value, dict):
        return {str(key): plain(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(part) for part in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


@cache
def versions() -> str:
    """Versions of the packages that produce a dataset, as JSON."""
    return to_json({name: version(name) for name in PACKAGES})


def scene_entry(scene: Scene, title: str = "") -> dict[str, Any]:
    """Content of a scene file for this scene.

    Raises
    ------
    InvalidValue
        If the scene has a contact law of the user's own, which files cannot describe.
    """
    if type(scene.contact) not in TAGS:
        raise InvalidValue(
            "contact", scene.contact, "Coulomb, InfiniteFriction and PerfectlyRough",
            "save a scene of one of these laws",
        )  # fmt: skip
    parts = {"slider": scene.slider, "placement": scene.placement, "contact": scene.contact}
    content = {name: entry(part) for name, part in parts.items() if part is not None}
    effects = {"effects": [_effect_entry(effect) for effect in scene.effects]}
    units = {} if scene.units is None else {"units": entry(scene.units)}
    return {"title": title} | content | effects | units


def _effect_entry(effect: Any) -> dict[str, Any]:
    """An effect in the body frame, where a mass without a center is at the origin."""
    content = entry(effect)
    if content.get("center") == [0.0, 0.0] and isinstance(effect, Inertia):
        del content["center"]
    return content


def entry(value: Any) -> dict[str, Any]:
    """A law, an effect, a support or another declared value in the form of scene files.

    A support of the user's own, which files cannot describe, is the name of its class and its pieces.
    """
    if hasattr(value, "pieces") and type(value) not in TAGS:
        return _pieces_of(value)
    kind: Any = type(value)
    content: dict[str, Any] = dict(TAGS.get(kind, {}))
    for name, (declaration, default) in declarations_of(kind).items():
        parameter = getattr(value, name)
        if declaration is OUTLINE and parameter is not None:
            parameter = value.outline_in_body()
        if parameter is None or parameter is default is False:
            continue
        if isinstance(default, tuple) and parameter == default:
            continue
        if declaration in (SUPPORT, SUPPORTS):
            content[name] = entry(parameter)
        elif declaration is MEMBERS:
            content[name] = [
                {"share": share, "support": entry(support)} for share, support in parameter
            ]
        else:
            content[name] = declaration.to_file(parameter)
    return content


def _pieces_of(support: Any) -> dict[str, Any]:
    """The class and the pieces of a support."""
    atoms, segments, rings, discs, plates = support.pieces()
    lines = {"atoms": atoms, "segments": segments, "rings": rings, "discs": discs}
    pieces = {kind: rows.tolist() for kind, rows in lines.items() if len(rows)}
    pieces |= {"plates": [edges.tolist() for edges in plates]} if plates else {}
    return {"shape": type(support).__name__, "pieces": pieces}
