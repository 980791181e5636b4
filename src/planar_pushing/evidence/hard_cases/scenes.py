"""Scenes for the hard cases in one line."""

from __future__ import annotations

import math

from planar_pushing.mechanics.contact import ContactLaw, Coulomb, InfiniteFriction
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.scene import Scene, Slider


def make_scene(
    length: float,
    psi: float,
    *,
    share: float = 0.5,
    mu: float = math.inf,
    rho: float = 1.0,
    weight: float = 1.0,
    mass: float = 1.0,
) -> Scene:
    """Scene with R = 1 whose effects leave the share of inertia open where it is inside (0, 1)."""
    contact: ContactLaw = InfiniteFriction() if math.isinf(mu) else Coulomb(mu)
    friction, inertia = RingFriction(weight=weight), Inertia(mass=mass, gyration_radius=rho)
    ends: dict[float, tuple[Effect, ...]] = {0.0: (friction,), 1.0: (inertia,)}
    return Scene(
        slider=Slider(rod_length=length, rod_angle=psi),
        contact=contact,
        effects=ends.get(share, (friction, inertia)),
    )
