"""What the evidence calls of the mechanics beside their public functions, in this one place.

Public functions, scenes and effects are imported where they are used.
"""

from __future__ import annotations

from planar_pushing.mechanics.candidates import COINCIDENCE, Candidates, candidates, contact_motion
from planar_pushing.mechanics.cones import edge_motions
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.effects.base import IsotropicEffect
from planar_pushing.mechanics.effects.ring_inverse import ring_spin_ratio
from planar_pushing.mechanics.effects.ring_profile import ring_profile
from planar_pushing.mechanics.planar import (
    LONGEST,
    Array,
    contact_motion_angle,
    direction,
    moment_arm,
)
from planar_pushing.mechanics.response import is_homogeneous, spin_ratio

__all__ = [
    "COINCIDENCE",
    "LONGEST",
    "Array",
    "Candidates",
    "IsotropicEffect",
    "candidates",
    "contact_motion",
    "contact_motion_angle",
    "direction",
    "edge_motions",
    "friction_coefficient",
    "is_homogeneous",
    "moment_arm",
    "ring_profile",
    "ring_spin_ratio",
    "spin_ratio",
]
