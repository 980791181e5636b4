"""Sliders and supports of a study, with exact parameters, and what the cells of a grid have in common.

Parameters and coordinates are plain values, taken as exact. A cell is a function of the plain values of
its study and of its coordinates. It returns numbers, integers or booleans, or lists of them.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from flint import fmpq

from pulling_by_pushing.oracle.balls import rational
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.prove import Slider
from pulling_by_pushing.oracle.shapes import support
from pulling_by_pushing.oracle.support import Support

#: Name of a variable: its value at a point. The entry CENTERS lists supports and centers of rotation.
Record = dict[str, Any]
#: Plain values of a study, or of the part of one from which a dataset is built.
StudyValues = Mapping[str, Any]
CENTERS = ""
ONE = fmpq(1)
FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"
#: Edges of a cone with their sides.
EDGES = (("right", 1), ("left", -1))


def ring_slider(
    values: StudyValues, effects: str, length: float, angle: float | None = None
) -> Slider:
    """The ring of a study with a rod, and the effects of a label."""
    return _ring_slider(
        json.dumps([values["slider"], values.get(FRICTION), values.get(INERTIA)]),
        effects,
        length,
        angle,
    )


@lru_cache(1 << 12)
def _ring_slider(entry: str, effects: str, length: float, angle: float | None) -> Slider:
    slider, friction, inertia = json.loads(entry)
    parameters: dict[str, Any] = {
        "gyration": rational((inertia or {}).get("gyration_radius", slider["radius"])) ** 2
    }
    if effects != INERTIA:
        parameters |= {"support": ring_of({"slider": slider})}
        parameters |= {"weight": rational((friction or {}).get("weight", 1))}
    if effects != FRICTION:
        parameters |= {"mass": rational((inertia or {}).get("mass", 1))}
    body = Body(length=rational(length), **parameters)
    return Slider(body, rational(slider["rod_angle"] if angle is None else angle))


@lru_cache(64)
def _support(entry: str) -> Support:
    return support(json.loads(entry))


def support_of(values: StudyValues, name: str) -> Support:
    """Exact pieces of the support with this name; the same object for the same entry."""
    return _support(json.dumps(values["supports"][name]))


def ring_of(values: StudyValues) -> Support:
    """Exact ring with the radius of the study's slider."""
    return _support(json.dumps({"shape": "ring", "radius": values["slider"]["radius"]}))


@lru_cache(1 << 10)
def support_slider(pieces: Support, length: float, angle: float) -> Slider:
    """Slider of unit weight on a support, with a rod at an angle in degrees."""
    return Slider(Body(length=rational(length), support=pieces, weight=ONE), rational(angle))


def shares(effects: str) -> list[str]:
    """The effects between which a motion lies, each alone."""
    return [FRICTION, INERTIA] if effects == BOTH else [effects]


def slider_at_share(
    values: StudyValues, length: float, angle: float | None, share: float
) -> Slider:
    """The ring of a study with a share of inertia in all resistance; the rest is friction."""
    return _shared_slider(json.dumps([values["slider"], values[INERTIA]]), length, angle, share)


@lru_cache(1 << 10)
def _shared_slider(entry: str, length: float, angle: float | None, share: float) -> Slider:
    slider, inertia = json.loads(entry)
    part = rational(share)
    body = Body(
        length=rational(length),
        support=ring_of({"slider": slider}),
        weight=1 - part,
        mass=part,
        gyration=rational(inertia["gyration_radius"]) ** 2,
    )
    return Slider(body, rational(slider["rod_angle"] if angle is None else angle))
