"""What resists the motion: each effect is a convex potential of the slider's twist."""

from planar_pushing.mechanics.effects import (
    any_mass,
    any_support,
    base,
    inertia,
    support_friction,
)
from planar_pushing.mechanics.effects.base import Effect
from planar_pushing.mechanics.effects.inertia import Inertia
from planar_pushing.mechanics.effects.support_friction import RingFriction, SupportFriction

base.KINDS.update(
    {
        inertia.Mass: inertia,
        support_friction.RingSupport: support_friction,
        any_mass.MassAt: any_mass,
        any_support.Support: any_support,
        any_support.Supports: any_support,
    }
)

__all__ = ["Effect", "Inertia", "RingFriction", "SupportFriction"]
