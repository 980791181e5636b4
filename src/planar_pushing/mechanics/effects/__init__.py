"""Effects, which resist or drive the motion: each is a convex potential of the slider's twist."""

from planar_pushing.mechanics.effects.base import Effect
from planar_pushing.mechanics.effects.inertia import Inertia
from planar_pushing.mechanics.effects.load import Load
from planar_pushing.mechanics.effects.support_friction import (
    RingFriction,
    SupportFriction,
    weight,
)
from planar_pushing.mechanics.effects.viscous import Viscous

__all__ = ["Effect", "Inertia", "Load", "RingFriction", "SupportFriction", "Viscous", "weight"]
