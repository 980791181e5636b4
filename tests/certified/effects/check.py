"""Check of a solution found in floating point: one evaluation of the effects on balls around it.

The claim is that a solution exists for some twist and force within a tolerance of the stated ones.
Every condition of its mode is evaluated on balls of this radius; the claim is rejected if one condition
fails on the entire ball. A foot whose ball contains the center of rotation can carry any force up to
its share. The check does not decide whether a solution ends a continuum or whether one is missing:
`modes` enumerates all solutions.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import ctx, fmpq

from certified.effects.conditions import Claim, Conditions
from planar_pushing.certified.balls import Undecided, rational
from planar_pushing.certified.contact.modes import Law
from planar_pushing.certified.potential.direction import Direction
from planar_pushing.certified.potential.resistance import Scene, resistance

#: Working precision in bits.
PRECISION = 128
#: Tolerance of a claim, relative to the speed and to the force.
TOLERANCE = 1e-9
#: Fractions of the tolerance that are tried in turn if friction is undecided over the balls.
PARTS = (1.0, 2.0**-12, 2.0**-24)


@dataclass(frozen=True, slots=True)
class Verdict:
    """The conditions that a claim fails, and those that remain undecided.

    The claim holds, to within the tolerance, if both are empty.
    """

    fails: tuple[str, ...] = ()
    undecided: tuple[str, ...] = ()

    @property
    def holds(self) -> bool:
        """Whether every condition was evaluated and none fails."""
        return not self.fails and not self.undecided


def check(
    scene: Scene,
    law: Law,
    pusher: Direction,
    magnitude: fmpq,
    claim: Claim,
    *,
    tolerance: float = TOLERANCE,
) -> Verdict:
    """Check a claimed solution against the conditions of its mode.

    Parameters
    ----------
    scene, law, pusher, magnitude
        As in `modes`, but the magnitude can be zero.
    claim : Claim
    tolerance : float, optional
        Radius of the balls: of the force, relative to the force and a load; of the twist, relative to
        ``|v| + L |omega|``, where L is the length of the rod plus the extent of the slider.
    """
    numbers = claim.force, claim.force_end, claim.contact_motion, claim.twist
    if not all(math.isfinite(each) for given in numbers for each in given):
        return Verdict(("a number is not finite",))
    with ctx.workprec(PRECISION):
        return _check(scene, law, pusher, magnitude, claim, tolerance)


def _check(
    scene: Scene, law: Law, pusher: Direction, magnitude: fmpq, claim: Claim, tolerance: float
) -> Verdict:
    total, open_ = resistance(scene), []
    for part in PARTS:
        try:
            found = Conditions(total, law, pusher, magnitude, claim, rational(part * tolerance))
            fails = tuple(found.failures())
        except Undecided as error:
            open_.append(str(error))
            continue
        return Verdict((), tuple(open_)) if fails and open_ else Verdict(fails)
    return Verdict((), tuple(open_))
