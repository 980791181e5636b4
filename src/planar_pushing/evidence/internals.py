"""What the evidence calls of the mechanics beside their public functions, in this one place.

Public functions, scenes and effects are imported where they are used.
"""

from __future__ import annotations

from planar_pushing.mechanics.candidates import COINCIDENCE as COINCIDENCE
from planar_pushing.mechanics.candidates import Candidates as Candidates
from planar_pushing.mechanics.candidates import candidates as candidates
from planar_pushing.mechanics.candidates import contact_motion as contact_motion
from planar_pushing.mechanics.cones import edge_motions as edge_motions
from planar_pushing.mechanics.contact.laws import friction_coefficient as friction_coefficient
from planar_pushing.mechanics.effects.base import IsotropicEffect as IsotropicEffect
from planar_pushing.mechanics.effects.ring_inverse import ring_spin_ratio as ring_spin_ratio
from planar_pushing.mechanics.effects.ring_profile import ring_profile as ring_profile
from planar_pushing.mechanics.plane import LONGEST as LONGEST
from planar_pushing.mechanics.plane import Array as Array
from planar_pushing.mechanics.plane import contact_motion_angle as contact_motion_angle
from planar_pushing.mechanics.plane import direction as direction
from planar_pushing.mechanics.plane import moment_arm as moment_arm
from planar_pushing.mechanics.response import is_homogeneous as is_homogeneous
from planar_pushing.mechanics.response import spin_ratio as spin_ratio
