"""Friction between finger and object from the forces of pushes with a slipping contact."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from planar_pushing.mechanics.outline.chains import wrap
from planar_pushing.mechanics.outline.grown import travel_between, turn_at_corners
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.measured import Measured

#: A contact slips if it moves by this many standard deviations of its position and this part of the path.
SURE, FRACTION = 3.0, 0.1
#: Angle by which corners may turn the normal of a contact, in radians.
STRAIGHT = 0.02


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
    """Friction ratios of pushes at a side or an arc with forces, divided by whether the contact slips.

    The force is compared with the normal halfway between those of the first and of the last contact. A
    finger that goes around a corner has no such normal and is left out.
    """
    chosen = pushes.part(pushes.has_force & ~pushes.at_corner)
    first, last, outline = chosen.first_places, chosen.last_places, pushes.outline
    turn = wrap(last.beta - first.beta)
    # A finger that sticks rolls along the outline.
    slip = np.abs(travel_between(first, last, outline) + chosen.radius * (turn + chosen.rotation))
    distance = np.hypot(*chosen.finger.T)
    slips = (slip > SURE * chosen.noise[0]) & (slip > FRACTION * distance)
    middle = first.beta + turn / 2.0
    tangent = np.column_stack([np.cos(middle), np.sin(middle)])
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    along, into = ((chosen.force * axis).sum(axis=1) for axis in (tangent, normal))
    pushing = (into > 0.0) & (np.abs(turn_at_corners(first, last, outline)) < STRAIGHT)
    ratio = np.abs(along) / np.where(pushing, into, 1.0)
    return Friction(ratio[slips & pushing], ratio[~slips & pushing])
