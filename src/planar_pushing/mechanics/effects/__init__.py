"""Effects, which resist or drive the motion: each is a convex potential of the slider's twist."""

from __future__ import annotations

from typing import Any, ClassVar, Protocol

from planar_pushing.mechanics.effects.inertia import Inertia
from planar_pushing.mechanics.effects.load import Load
from planar_pushing.mechanics.effects.support_friction import (
    RingFriction,
    SupportFriction,
    weight,
)
from planar_pushing.mechanics.effects.viscous import Viscous
from planar_pushing.terms.options import EffectKind

#: Effects by their types in scene files.
EFFECTS: dict[str, Any] = {
    "ring_friction": RingFriction,
    "support_friction": SupportFriction,
    "inertia": Inertia,
    "viscous": Viscous,
    "load": Load,
}

__all__ = [
    "EFFECTS",
    "Effect",
    "Inertia",
    "Load",
    "RingFriction",
    "SupportFriction",
    "Viscous",
    "weight",
]


class Effect(Protocol):
    """An effect that resists or drives the slider's motion, in the form in which users list it."""

    #: What the effect is, by which logs and datasets sort their values.
    kind: ClassVar[EffectKind]

    @property
    def degree(self) -> int:
        """Degree of homogeneity of the potential."""
        ...
