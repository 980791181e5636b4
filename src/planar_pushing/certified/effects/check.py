"""Check of a solution that was found in floats: one evaluation of the effects on balls around it.

The claim is a solution for some twist and force within a tolerance of those that are stated. Every
condition of its mode is evaluated on balls of this radius; one that fails on all of the balls refuses the
claim. A foot whose ball holds the center of rotation may carry any force up to its share. The check does
not tell whether a solution ends a continuum, nor whether one is missing: `modes` enumerates.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import ctx, fmpq

from planar_pushing.certified.balls import Undecided, rational
from planar_pushing.certified.contact.modes import Law
from planar_pushing.certified.effects.conditions import Claim, Conditions
from planar_pushing.certified.potential.direction import Direction
from planar_pushing.certified.potential.resistance import Scene, resistance

#: Working precision in bits.
PRECISION = 128
#: Tolerance of a claim, relative to the speed and to the force.
TOLERANCE = 1e-9
#: Parts of the tolerance that are tried in turn where the balls leave friction open.
PARTS = (1.0, 2.0**-12, 2.0**-24)


@dataclass(frozen=True, slots=True)
class Verdict:
    """The conditions that a claim fails, and those that stay open.

    It holds, to the tolerance, where there is neither.
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
    scene : Scene
    law : Law
    pusher : Direction
        Of the pusher's motion, fence's frame.
    magnitude : fmpq
        Of the pusher's motion, >= 0.
    claim : Claim
    tolerance : float, optional
        Radius of the balls: of the force relative to it and to a load, of the twist relative to
        ``|v| + L |omega|``, L the length of the rod and the extent of the slider.
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
