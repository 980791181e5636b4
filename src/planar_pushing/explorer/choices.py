"""Named choices on the page: contact laws, supports of the gallery, and kinds of effects."""

from __future__ import annotations

from typing import Any

from planar_pushing.explorer.presets import gallery
from planar_pushing.explorer.state import State, effect, with_effect, with_law, with_support
from planar_pushing.explorer.supports import name_in
from planar_pushing.terms.options import EffectKind

FRICTION, INERTIA = EffectKind.SUPPORT_FRICTION, EffectKind.INERTIA
#: Contact laws in the format of scene files, by their names on the page.
LAWS: dict[str, dict[str, Any]] = {
    "Coulomb friction": {"law": "coulomb"},
    "infinite friction": {"law": "infinite_friction", "at_zero_normal": "free"},
    "infinite friction, definition 2": {"law": "infinite_friction", "at_zero_normal": "none"},
    "perfectly rough": {"law": "perfectly_rough"},
}
OWN = "own support"


def law_name(state: State) -> str:
    """Name of the contact law on the page."""
    given = state.file.contact.model_dump().items()
    return next(name for name, law in LAWS.items() if law.items() <= given)


def coefficient(state: State) -> float:
    """Coefficient of friction; 1 if the law has none."""
    return float(getattr(state.scene.contact, "friction_coefficient", 1.0))


def with_named_law(state: State, name: str) -> State:
    """State with a contact law given by its name on the page."""
    own = {"friction_coefficient": coefficient(state)} if LAWS[name]["law"] == "coulomb" else {}
    return with_law(state, LAWS[name] | own)


def support_name(state: State) -> str:
    """Name of the support in the gallery."""
    entry = (effect(state, FRICTION) or {}).get("support")
    return name_in(gallery(), entry, state.size) or OWN


def with_named_support(state: State, name: str) -> State:
    """State with a support of the gallery."""
    if name == OWN:
        return state
    return with_support(state, None if name == "ring" else gallery()[name])


def kinds(state: State) -> list[EffectKind]:
    """Kinds of effects, support friction and inertia, that resist the motion."""
    return [kind for kind in (FRICTION, INERTIA) if effect(state, kind) is not None]


def with_kinds(state: State, active: list[EffectKind]) -> State:
    """State with these kinds of effects; new ones are added first because at least one must remain."""
    fresh: dict[EffectKind, dict[str, Any]] = {
        FRICTION: {"type": "ring_friction"},
        INERTIA: {"type": "inertia", "gyration_radius": state.size},
    }
    for kind in sorted((FRICTION, INERTIA), key=lambda kind: kind not in active):
        if kind not in active:
            state = with_effect(state, kind, None)
        elif effect(state, kind) is None:
            state = with_effect(state, kind, fresh[kind])
    return state
