"""Friction between finger and object from the forces of pushes with a slipping contact."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.measured import Measured

#: A contact slips if it moves by this many standard deviations of its position and this part of the path.
SURE, FRACTION = 3.0, 0.1


class Friction(NamedTuple):
    """Ratios of tangential to normal force for slipping and for sticking pushes."""

    slipping: Array
    sticking: Array

    @property
    def coefficient(self) -> float:
        """Median ratio of the slipping pushes; if none slips, the largest ratio of the sticking pushes."""
        if len(self.slipping):
            return float(np.median(self.slipping))
        return float(self.sticking.max(initial=0.0))


def contact_friction(pushes: Measured) -> Friction:
    """Friction ratios of pushes at a side with forces, divided by whether the contact slips."""
    chosen = pushes.part(pushes.has_force & ~pushes.at_corner)
    tangent = np.column_stack([chosen.normal[:, 1], -chosen.normal[:, 0]])
    travel = ((chosen.last_contacts - chosen.contact) * tangent).sum(axis=1)
    # A finger that sticks rolls along the side.
    slip = np.abs(travel + chosen.radius * chosen.rotation)
    distance = np.hypot(*chosen.finger.T)
    slips = (slip > SURE * chosen.noise[0]) & (slip > FRACTION * distance)
    along, into = ((chosen.force * axis).sum(axis=1) for axis in (tangent, chosen.normal))
    pushing = into > 0.0
    ratio = np.abs(along) / np.where(pushing, into, 1.0)
    return Friction(ratio[slips & pushing], ratio[~slips & pushing])
