"""What the widgets read from a state, and what a change of one makes of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from planar_pushing.explore.handles import unit_of_magnitude
from planar_pushing.explore.presets import gallery
from planar_pushing.explore.state import (
    State,
    effect,
    pushed,
    simulated,
    with_effect,
    with_law,
    with_support,
)
from planar_pushing.explore.supports import name_in
from planar_pushing.terms.options import EffectKind

FRICTION, INERTIA = EffectKind.SUPPORT_FRICTION, EffectKind.INERTIA
#: Laws by their names on the page, as scene files have them.
LAWS: dict[str, dict[str, Any]] = {
    "Coulomb friction": {"law": "coulomb"},
    "infinite friction": {"law": "infinite_friction", "at_zero_normal": "free"},
    "infinite friction, definition 2": {"law": "infinite_friction", "at_zero_normal": "none"},
    "perfectly rough": {"law": "perfectly_rough"},
}
#: The coefficient that the law takes up where there was none.
COEFFICIENT = 1.0
OWN = "own support"


def law_name(state: State) -> str:
    """Name of the law on the page."""
    given = state.file.contact.model_dump()
    return next(
        name for name, law in LAWS.items() if all(given.get(k) == v for k, v in law.items())
    )


def coefficient(state: State) -> float:
    """The coefficient of friction, or the default of Coulomb's law where the scene has none."""
    return float(getattr(state.scene.contact, "friction_coefficient", COEFFICIENT))


def with_named_law(state: State, name: str) -> State:
    """The state with a law by its name on the page."""
    law = dict(LAWS[name])
    if law["law"] == "coulomb":
        law["friction_coefficient"] = coefficient(state)
    return with_law(state, law)


def with_coefficient(state: State, given: float) -> State:
    """The state with Coulomb's law of this coefficient."""
    return with_law(state, {"law": "coulomb", "friction_coefficient": float(given)})


def support_name(state: State) -> str:
    """Name of the support in the gallery."""
    entry = (effect(state, FRICTION) or {}).get("support")
    return name_in(gallery(), entry, state.size) or OWN


def with_named_support(state: State, name: str) -> State:
    """The state with a support of the gallery."""
    if name == OWN:
        return state
    return with_support(state, None if name == "ring" else gallery()[name])


def kinds(state: State) -> list[int]:
    """Which of the effects resist the motion."""
    return [i for i, kind in enumerate((FRICTION, INERTIA)) if effect(state, kind) is not None]


def with_kinds(state: State, active: list[int]) -> State:
    """The state with these effects; the last effect cannot be removed."""
    fresh: dict[EffectKind, dict[str, Any]] = {
        FRICTION: {"type": "ring_friction"},
        INERTIA: {"type": "inertia", "gyration_radius": state.size},
    }
    found = state
    for index, kind in enumerate((FRICTION, INERTIA)):
        if index in active and effect(found, kind) is None:
            found = with_effect(found, kind, fresh[kind])
    for index, kind in enumerate((FRICTION, INERTIA)):
        if index not in active:
            found = with_effect(found, kind, None)
    return found


def number_of(kind: EffectKind, key: str, default: float) -> tuple[Any, Any]:
    """How a number of an effect is read, and changed."""

    def read(state: State) -> float:
        return float((effect(state, kind) or {}).get(key, default))

    def write(state: State, value: Any) -> State:
        entry = effect(state, kind)
        return with_effect(state, kind, entry | {key: float(value)}) if entry and value else state

    return read, write


def center_of_mass(part: int) -> tuple[Any, Any]:
    """How a coordinate of the center of mass is read, and changed."""

    def read(state: State) -> float:
        return float((effect(state, INERTIA) or {}).get("center", (0.0, 0.0))[part])

    def write(state: State, value: Any) -> State:
        entry = effect(state, INERTIA)
        if entry is None or value is None:
            return state
        center = list(entry.get("center", (0.0, 0.0)))
        center[part] = float(value)
        return with_effect(state, INERTIA, entry | {"center": center})

    return read, write


def size_of_push(state: State) -> float:
    """Logarithm of the push in units of W / m."""
    return float(np.log10(state.magnitude / unit_of_magnitude(state.scene)))


def with_size_of_push(state: State, value: float) -> State:
    """The state with another size of its push."""
    return pushed(state, state.angle, unit_of_magnitude(state.scene) * 10.0**value)


def simulated_again(state: State, **options: Any) -> State:
    """The state with other options, followed anew where it was followed."""
    return replace(simulated(state, **options), time=None if state.time is None else 0.0)
