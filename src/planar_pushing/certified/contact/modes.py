"""Contact modes: every consistent solution for a pusher motion from rest, by certified decisions.

The conditions are those of the case analysis of Sec. 2. A slip that coincides with sticking counts as
sticking, and a slip requires a motion. If the pusher moves along the fence and the motion under an edge
does too, the slips form a continuum from rest to sticking, and none of them is counted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache

from flint import arb, fmpq

from planar_pushing.certified.balls import Exact, cosine_sine, norm, precise, rational, sign
from planar_pushing.certified.contact import slips
from planar_pushing.certified.contact.sticking import Motion, Sticking, sticking
from planar_pushing.certified.line_of_force import (
    contact_motion,
    exact_contact_motion,
    is_steady,
    spin_ratio,
)
from planar_pushing.certified.setting import (
    FRICTION,
    INERTIA,
    Effects,
    Heading,
    Slider,
    direction,
    edge,
    heading,
    lean,
)


class Mode(IntEnum):
    """Contact modes in the order of the datasets."""

    SEPARATE = 0
    STICK = 1
    SLIP_RIGHT = 2
    SLIP_LEFT = 3


#: The slider at rest.
REST = Motion(arb(0), arb(0))

#: Edge of the friction cone on which the force of each slip lies: 1 is the right, -1 the left edge.
SLIPS = {Mode.SLIP_RIGHT: -1, Mode.SLIP_LEFT: 1}


@dataclass(frozen=True, slots=True)
class Law:
    """Contact law: width of the friction cone, whether its edges belong to it; an adhesive law has none."""

    friction_coefficient: float
    closed: bool = True
    adhesive: bool = False

    @property
    def slips(self) -> bool:
        """Whether the contact can slip under a force on an edge."""
        return self.closed and not self.adhesive


def coulomb(friction_coefficient: float) -> Law:
    """Coulomb's law with a finite coefficient."""
    return Law(friction_coefficient)


INFINITE_FREE = Law(math.inf)  # definition 1 of Sec. 5
INFINITE_NONE = Law(math.inf, closed=False)  # definition 2
PERFECTLY_ROUGH = Law(math.inf, adhesive=True)


@precise
def contact_modes(
    slider: Slider, effects: Effects, law: Law, magnitude: float, pusher_angle: float | fmpq
) -> dict[Mode, list[Motion]]:
    """Consistent motions of each mode, slowest first.

    Parameters
    ----------
    slider : Slider
    effects : Effects
    law : Law
    magnitude : float
        Magnitude of the pusher's motion, > 0, exact.
    pusher_angle : float or fmpq
        In degrees, exact.
    """
    size, pusher = rational(magnitude), heading(pusher_angle)
    found: dict[Mode, list[Motion]] = {mode: [] for mode in Mode}
    if sign(pusher.y) <= 0:
        found[Mode.SEPARATE] = [REST]
    stick = sticking(slider, effects, _sufficient(effects, size), rational(pusher_angle))
    if law.adhesive or _admits(law, stick):
        found[Mode.STICK] = [stick.motion]
    for mode, side in SLIPS.items() if law.slips else ():
        force = edge(law.friction_coefficient, side)
        spins = _slips(slider, effects, law.friction_coefficient, side, size, pusher)
        found[mode] = [Motion(spin, force.degrees) for spin in spins]
    return found


@precise
def speed(
    slider: Slider, law: Law, mode: Mode, motion: Motion, magnitude: fmpq, pusher: Heading
) -> arb:
    """Speed of the slider's center in a consistent motion, where the contact keeps up with the pusher."""
    force = direction(motion.force_angle)
    x, y = contact_motion(slider, force, motion.spin_ratio)
    if mode is Mode.STICK:
        return magnitude / norm(x, y)
    if pusher.y == 0:  # a slip along the fence, where the force determines the speed
        motions, _ = cover(slider, law.friction_coefficient, SLIPS[mode])
        return motions.speed(abs(motion.spin_ratio))
    return magnitude * pusher.y / y


def outcome(found: dict[Mode, list[Motion]]) -> int:
    """0 inconsistent, 1 unique, 2 ambiguous."""
    return min(2, sum(len(motions) for motions in found.values()))


@precise
def is_continuum(slider: Slider, effects: Effects, law: Law, pusher_angle: float | fmpq) -> bool:
    """Whether all slips from rest up to sticking are consistent, under forces on an edge.

    This is the case if the pusher moves along the fence and the contact does too under the force of an
    edge, at any speed.
    """
    pusher = heading(pusher_angle)
    if not law.slips or pusher.y != 0:
        return False
    return any(
        _keeps_to_fence(slider, effects, law.friction_coefficient, side, pusher) for side in (1, -1)
    )


def _keeps_to_fence(
    slider: Slider, effects: Effects, mu: float, side: int, pusher: Heading
) -> bool:
    force = edge(mu, side)
    if effects is Effects.BOTH and not is_steady(slider, force):
        motions, _ = cover(slider, mu, side)
        if not (motions.stays and motions.lever.is_zero()):
            return False
    share = effects.shares[0]
    motion = contact_motion(slider, force, spin_ratio(slider, force, share))
    exact = exact_contact_motion(slider, force, share)
    if exact is None and not motion[1].contains(0):
        return False
    along = sign(motion[1], None if exact is None else lambda: exact[1]) == 0
    return along and sign(motion[0]) == sign(pusher.x)


def _sufficient(effects: Effects, magnitude: fmpq) -> fmpq:
    """Magnitude on which the sticking motion depends; one effect alone is independent of scale."""
    return magnitude if effects is Effects.BOTH else fmpq(1)


def _admits(law: Law, stick: Sticking) -> bool:
    """Whether the force lies in the friction cone."""
    sides = [_side_of_edge(law.friction_coefficient, side, stick) for side in (1, -1)]
    if not law.closed:
        return min(sides) > 0
    # A cone that is a single direction excludes the opposite direction.
    return min(sides) >= 0 and (law.friction_coefficient > 0 or stick.force[1] > 0)


def _side_of_edge(friction_coefficient: float, side: int, stick: Sticking) -> int:
    """1 inside an edge of the friction cone, 0 on it, -1 outside it."""
    bound = edge(friction_coefficient, side)
    ball = bound.x * stick.force[1] - bound.y * stick.force[0]

    def exact() -> Exact:
        x, y = bound.exact()  # type: ignore[misc]
        return x * stick.exact[1] - y * stick.exact[0]  # type: ignore[index]

    return side * sign(ball, exact if stick.exact is not None else None)


def _slips(
    slider: Slider, effects: Effects, mu: float, side: int, magnitude: fmpq, pusher: Heading
) -> list[arb]:
    """Spin ratios of the motions under a force on an edge for which the contact slips, slowest first."""
    force = edge(mu, side)
    _, sine = lean(slider, force)
    if effects is not Effects.BOTH or is_steady(slider, force):
        return _steady_slips(slider, force, effects.shares[0], side, pusher)
    motions, parts = cover(slider, mu, side)
    found = []
    for size in slips.slip_spins(motions, parts, magnitude * pusher.y):
        spin = -size if sine < 0 else size
        if pusher.y == 0:
            speed = motions.speed(size) * contact_motion(slider, force, spin)[0]
            slip = sign(speed - magnitude * pusher.x)
        else:
            slip = sign(pusher.y) * _turn(slider, force, spin, FRICTION, pusher)
        if slip * side < 0:
            found.append(spin)
    return found


def _steady_slips(
    slider: Slider, force: Heading, share: fmpq, side: int, pusher: Heading
) -> list[arb]:
    """Slips in the direction of an edge of the motion cone; the same force sustains any speed there."""
    spin = spin_ratio(slider, force, share)
    motion, exact = contact_motion(slider, force, spin), exact_contact_motion(slider, force, share)
    towards = sign(motion[1], None if exact is None else lambda: exact[1])
    if towards == 0 or towards != sign(pusher.y):
        return []
    return [spin] if towards * _turn(slider, force, spin, share, pusher) * side < 0 else []


def _turn(slider: Slider, force: Heading, spin: arb, share: fmpq, pusher: Heading) -> int:
    """Sign of the rotation from the contact's motion to the pusher's; times n . u, the sign of the slip."""
    motion, known = contact_motion(slider, force, spin), exact_contact_motion(slider, force, share)

    def exact() -> Exact:
        x, y = pusher.exact()  # type: ignore[misc]
        return known[0] * y - known[1] * x  # type: ignore[index]

    ball = motion[0] * pusher.y - motion[1] * pusher.x
    return sign(ball, None if known is None or pusher.exact is None else exact)


@lru_cache(maxsize=1024)
@precise
def cover(
    slider: Slider, friction_coefficient: float, side: int
) -> tuple[slips.Edge, list[slips.Part]]:
    """Motions under a force on an edge that misses the ring center, in certified monotone parts."""
    force = edge(friction_coefficient, side)
    _, sine = lean(slider, force)
    exact = exact_contact_motion(slider, force, INERTIA)
    motion = contact_motion(slider, force, spin_ratio(slider, force, INERTIA))
    stays = sign(motion[1], lambda: exact[1]) == 0  # type: ignore[index]
    cosine, _ = cosine_sine(slider.rod_angle)
    found = slips.mirrored_edge(slider, force, sine, cosine, stays)
    return found, slips.parts(found)
