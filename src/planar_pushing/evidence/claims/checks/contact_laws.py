"""Secs. 2 and 5: Coulomb's law, the two definitions of infinite friction, perfect roughness."""

from __future__ import annotations

from itertools import product

from planar_pushing.certified.balls import rational
from planar_pushing.certified.contact.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Mode,
    contact_modes,
)
from planar_pushing.certified.line_of_force import contact_motion, spin_ratio
from planar_pushing.certified.setting import FRICTION, Effects, Slider, edge, heading
from planar_pushing.evidence.claims.proofs.examples import METHOD, found_modes, modes_are
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    equal,
    facts,
    inequality,
    on_grid,
    together,
)

#: Grid of the statements about every push: rod lengths in R, pusher angles in degrees.
_LENGTHS = (0.5, 2.0, 5.0)
_ANGLES = tuple(range(-175, 181, 5))


@check
def sliding_friction_opposes_slip(
    rod_length: float, friction_coefficient: float, pusher_angle: float, side: float
) -> Evidence:
    """Slip under the force on an edge (1 right, -1 left) is against the force along the fence."""
    slider, pusher = Slider.of(rod_length), heading(pusher_angle)
    force = edge(friction_coefficient, int(side))
    motion = contact_motion(slider, force, spin_ratio(slider, force, FRICTION))
    slip = motion[0] / motion[1] * pusher.y - pusher.x
    return inequality(-slip * force.x, "slip at equal normal motion, times f_x per force")


@check
def slip_has_no_normal_force(
    rod_length: float, pusher_angle: float, force_angle: float
) -> Evidence:
    """Definition 1: the slipping contact transmits a force along the fence, exactly."""
    slider = Slider.of(rod_length)
    found = contact_modes(slider, Effects.FRICTION, INFINITE_FREE, 1.0, pusher_angle)
    slips = found[Mode.SLIP_RIGHT]
    if len(slips) != 1:
        return facts({"one slip to the right": False}, METHOD)
    return equal(slips[0].force_angle, force_angle, METHOD, unit="degree")


@check
def ends_of_the_interval(right: float, left: float) -> Evidence:
    """Without a rod the force is along the motion: at both ends definition 1 sticks, 2 does not."""
    found = {}
    for angle in (right, left):
        first, second = (
            found_modes(0.0, Effects.FRICTION, law, angle) for law in (INFINITE_FREE, INFINITE_NONE)
        )
        found[f"closed at {angle:g}"] = first == {Mode.SEPARATE: 1, Mode.STICK: 1}
        found[f"open at {angle:g}"] = second == {Mode.SEPARATE: 1}
    return facts(found, METHOD)


@check
def definitions_agree_on_sticking() -> Evidence:
    """Where definition 1 prevents sticking so does definition 2, on a grid of pushes."""
    wrong, points = [], 0
    for effects, length, angle in product(Effects, _LENGTHS, _ANGLES):
        first, second = (
            found_modes(length, effects, law, angle) for law in (INFINITE_FREE, INFINITE_NONE)
        )
        points += 1
        if Mode.STICK in second and Mode.STICK not in first:
            wrong.append(f"{effects}, l = {length:g}, {angle}")
    return on_grid(wrong, points, METHOD)


@check
def definition_2_has_no_solution(rod_length: float, pusher_angle: float) -> Evidence:
    """A slipping example: no mode is consistent, for each kind of analysis."""
    return together(
        *(modes_are((), rod_length, each, INFINITE_NONE, pusher_angle) for each in Effects)
    )


@check
def rough_contact_needs_adhesion(rod_length: float, pusher_angle: float) -> Evidence:
    """The force of the perfectly rough contact points away from the slider."""
    slider = Slider.of(rod_length)
    found = contact_modes(slider, Effects.FRICTION, PERFECTLY_ROUGH, 1.0, pusher_angle)
    angle = found[Mode.STICK][0].force_angle
    normal = (angle / 180).sin_pi()
    return inequality(
        -normal, "normal part of the unit force of the sticking contact", value=normal
    )


@check
def neither_definition_is_perfectly_rough(rod_length: float, pusher_angle: float) -> Evidence:
    """Definition 1 slips, definition 2 has no solution, the rough contact sticks."""
    laws = (
        ((Mode.SLIP_RIGHT,), INFINITE_FREE),
        ((), INFINITE_NONE),
        ((Mode.STICK,), PERFECTLY_ROUGH),
    )
    return together(
        *(modes_are(each, rod_length, Effects.FRICTION, law, pusher_angle) for each, law in laws)
    )


@check
def no_solution_beyond_edge(rod_length: float, pusher_angle: float) -> Evidence:
    """Definition 2: from this angle up to 180 degrees nothing is consistent."""
    slider, force = Slider.of(rod_length), edge(float("inf"), -1)
    motion = contact_motion(slider, force, spin_ratio(slider, force, FRICTION))
    pusher = heading(rational(pusher_angle))
    outside = motion[0] * pusher.y - motion[1] * pusher.x
    method = "turn from the left edge of the velocity cone to the pusher's direction"
    none = modes_are((), rod_length, Effects.FRICTION, INFINITE_NONE, pusher_angle)
    return together(inequality(outside, method), none)
