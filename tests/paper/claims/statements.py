"""Statements of the paper about every slider, at given ones, asked of any mechanics.

A statement yields numbers that are positive where it holds. The ledger proves the statements in general.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise, product

from flint import arb, fmpq

from pulling_by_pushing.evidence.claims.numbers import force, motion, turn
from pulling_by_pushing.evidence.proofs.mechanics import BOTH, FRICTION, INERTIA, LAWS, Scene
from pulling_by_pushing.oracle.balls import cross, dot

#: Force angles, away from those along and across rods at multiples of 15 degrees; and nearness of numbers.
FORCES = [fmpq(angle) for angle in range(-168, 180, 17)]
NEAR = arb(10) ** -11
SIDES = {"slip-right": -1, "slip-left": 1}


def near(one, other):
    return NEAR - abs(one - other)


def holds(truth):
    return arb(1 if truth else -1)


def names(mechanics, scene, pusher_angle, magnitude=1.0):
    return [name for name, _ in mechanics.modes(scene, float(pusher_angle), magnitude)]


def motion_angle(mechanics, scene, degrees):
    return degrees + turn(mechanics, scene, fmpq(degrees))


def pushes(cone):
    """Directions of approach right of, inside and left of a cone, and the mode of each."""
    right, left = (float(edge.mid()) for edge in cone)
    options = [
        (right / 2, "slip-left"),
        ((right + left) / 2, "stick"),
        ((left + 180) / 2, "slip-right"),
    ]
    return [(angle, mode) for angle, mode in options if 0.5 < angle < 179.5 and
            (mode == "stick" or not right - 0.5 < angle < left + 0.5)]  # fmt: skip


# --- Sec. 3: forces and motions -------------------------------------------------------------------


def force_balances_motion(mechanics, scene):
    """Eq. (7) and Sec. 3.1: the force is along its line, without torque, and does positive work."""
    for degrees in FORCES:
        e = scene.in_rod_frame(degrees)
        f_x, f_y, torque = mechanics.wrench(scene, mechanics.motion(scene, degrees, fmpq(1)))
        yield from (dot(e, (f_x, f_y)), near(cross(e, (f_x, f_y)), 0), near(torque, 0))


def motion_turns_with_force(mechanics, scene):
    """Secs. 3.1 and 4."""
    angles = [motion_angle(mechanics, scene, degrees) for degrees in FORCES]
    yield from (after - before for before, after in pairwise(angles))


def motion_is_normal_to_the_curve(mechanics, scene):
    """Secs. 3 and 4: between two forces on the curve its chord turns from one tangent to the other."""
    sizes = [force(mechanics, scene, degrees) for degrees in FORCES]
    for (a, f), (b, g) in pairwise(zip(FORCES, sizes, strict=True)):
        (f_x, f_y), (g_x, g_y) = scene.in_rod_frame(a), scene.in_rod_frame(b)
        chord = g * g_x - f * f_x, g * g_y - f * f_y
        before, after = (mechanics.motion(scene, each, fmpq(1))[:2] for each in (a, b))
        yield from (-dot(chord, before), dot(chord, after))


def force_is_extreme_along_and_across_the_rod(mechanics, scene):
    """Sec. 3: and parallel to the motion at these angles only."""
    rod = fmpq(int(scene.rod_angle))
    most, least = (force(mechanics, scene, rod + angle) for angle in (0, 90))
    for degrees in FORCES:
        between = force(mechanics, scene, degrees)
        yield from (most - between, between - least, abs(turn(mechanics, scene, degrees)) - 1e-6)
    yield from (near(turn(mechanics, scene, rod + angle), 0) for angle in (0, 90, 180, 270))
    yield near(most, 1)


def center_passes_the_ring_as_the_line_does(mechanics, scene):
    """Sec. 4, the seven cases: k has the sign of the arm, and k - 1 that of the arm - 1."""
    for degrees in FORCES:
        arm = -scene.rod_length * scene.in_rod_frame(degrees)[1]
        spin = motion(mechanics, scene, degrees)[0]
        yield from (spin * arm, (abs(spin) - 1) * (abs(arm) - 1))


def centers_of_inertia_lie_on_a_line(mechanics, scene):
    """Fig. 9: the center is at rho^2 / l beyond the ring's center."""
    distance = scene.gyration_radius**2 / scene.rod_length
    for degrees in FORCES:
        _, u_y, omega = mechanics.motion(scene, degrees, fmpq(1))
        yield (
            near(-u_y / omega - scene.rod_length, distance)
            if not omega.contains(0)
            else holds(True)
        )


def forces_lie_on_an_ellipse(mechanics, scene):
    """Fig. 10: under inertia, with semi-axes in the ratio 1 / sqrt(1 + (l / rho)^2)."""
    square = 1 + arb(scene.rod_length / scene.gyration_radius) ** 2
    for degrees in FORCES:
        e, motion = scene.in_rod_frame(degrees), mechanics.motion(scene, degrees, fmpq(1))
        f_x, f_y, _ = mechanics.wrench(scene, motion)
        energy = dot(motion[:2], (f_x, f_y))
        yield near((f_x**2 + square * f_y**2) / energy, 1)
        yield near(cross(motion[:2], (e[0], square * e[1])) / energy, 0)


def rods_are_short_or_long(mechanics, scene):
    """Sec. 3: the limit curve tends to a circle and to a segment along the rod."""
    across, length = force(mechanics, scene, fmpq(135)), scene.rod_length
    yield across - (1 - fmpq(11, 10) * arb(length) ** 2) if length < 1 else 1 / arb(length) - across
    yield 1 - across


#: Centers of rotation around the ring's center, off, on and inside the ring.
CENTERS = [(0.25, 0.125), (0.0, -0.75), (0.6, 0.8), (-1.0, 0.0), (1.5, -2.0), (30.0, 4.0)]


def lines_of_force_obey_the_seven_facts(mechanics, scene):
    """Sec. 4, of friction and of inertia: about each center, either way."""
    for (x, y), spin in product(CENTERS, (-1, 2)):
        motion = spin * y, -spin * x, spin
        lines = [mechanics.wrench(pure, motion) for pure in scene.pure]
        for *f, torque in lines:
            arm, size = torque / dot(f, f).sqrt(), arb(x) ** 2 + arb(y) ** 2
            yield near(dot(f, (x, y)) / size, 0)
            yield from (dot(f, motion[:2]), arm * spin)  # against friction; on the other side
            yield near(abs(arm), 1) if abs(size - 1) < NEAR else (abs(arm) - 1) * (1 - size)
        yield near(cross(lines[0][:2], lines[1][:2]) / dot(lines[1][:2], lines[1][:2]), 0)


# --- Secs. 3.1, 3.2 and 4: cones ------------------------------------------------------------------


def cone_of_infinite_friction_spans_180_degrees(mechanics, scene):
    right, left = mechanics.motion_cone(scene)
    yield from (near(left - right, 180), 90 - right, left - 90)


def cone_lies_within_90_degrees(mechanics, scene):
    cone, bounds = mechanics.motion_cone(scene), mechanics.friction_cone(scene)
    yield from (90 - abs(edge - bound) for edge, bound in zip(cone, bounds, strict=True))


def cone_of_both_is_the_hull(mechanics, scene):
    cones = [mechanics.motion_cone(pure) for pure in scene.pure]
    right, left = mechanics.motion_cone(scene)
    yield near(right, arb.min(*(cone[0] for cone in cones)))
    yield near(left, arb.max(*(cone[1] for cone in cones)))


def pushes_stick_inside_and_slip_outside(mechanics, scene):
    for pusher, mode in pushes(mechanics.motion_cone(scene)):
        yield holds(names(mechanics, scene, pusher) == [mode])


def normal_push_sticks(mechanics, scene):
    yield from (holds(names(mechanics, scene, 90, size) == ["stick"]) for size in (1e-3, 1.0, 1e3))


def pulls_have_three_solutions(mechanics, scene):
    right = float(mechanics.motion_cone(scene)[0].mid())
    if right < -0.5:
        solutions = sorted(names(mechanics, scene, right / 2))
        yield holds(solutions == ["separate", "slip-left", "stick"])


def slip_without_normal_force(mechanics, scene):
    """Figs. 8 and 12: just below 180 degrees, at every magnitude."""
    for pusher in (170, 179):
        for size in (1e-3, 1.0, 1e3):
            ((mode, angle),) = mechanics.modes(scene, pusher, size)
            yield from (holds(mode == "slip-right"), near(abs(angle), 180))


# --- Sec. 5: contact laws -------------------------------------------------------------------------

PUSHERS = [-172.5, -97.5, -37.5, -7.5, 7.5, 52.5, 97.5, 142.5, 172.5]


def laws_of_infinite_friction_compare(mechanics, scene):
    """Definition 2 never slips, and sticks where definition 1 does; a rough contact always sticks."""
    for pusher in PUSHERS:
        first, second, rough = (names(mechanics, replace(scene, law=law), pusher) for law in LAWS)
        free = [] if pusher > 0 else ["separate"]
        yield holds(second == [mode for mode in first if mode not in SIDES])
        yield holds(rough == [*free, "stick"])
        yield holds(("separate" in first) == bool(free))


SLIDERS = [
    Scene(rod_length=length, rod_angle=psi)
    for length, psi in ((0.5, 45.0), (2.0, 30.0), (5.0, 45.0))
]
EFFECTS = [
    [replace(scene, effects=effects) for scene in SLIDERS] for effects in (FRICTION, INERTIA, BOTH)
]
FRICTIONS, INERTIAS, BOTHS = EFFECTS
PURE, ALL = FRICTIONS + INERTIAS, FRICTIONS + INERTIAS + BOTHS
COULOMB = [replace(scene, law=mu) for scene in PURE for mu in (0.5, 2.0)]
#: Each statement with the scenes that it is about.
STATEMENTS = {
    force_balances_motion: PURE,
    motion_turns_with_force: PURE,
    motion_is_normal_to_the_curve: FRICTIONS,
    force_is_extreme_along_and_across_the_rod: FRICTIONS,
    center_passes_the_ring_as_the_line_does: ALL,
    centers_of_inertia_lie_on_a_line: [*INERTIAS, replace(INERTIAS[1], gyration_radius=0.5)],
    forces_lie_on_an_ellipse: [*INERTIAS, replace(INERTIAS[1], gyration_radius=3.0)],
    rods_are_short_or_long: [Scene(rod_length=length) for length in (0.01, 0.125, 8.0, 1000.0)],
    lines_of_force_obey_the_seven_facts: [Scene(effects=BOTH)],
    cone_of_infinite_friction_spans_180_degrees: PURE,
    cone_lies_within_90_degrees: PURE + COULOMB,
    cone_of_both_is_the_hull: BOTHS,
    pushes_stick_inside_and_slip_outside: PURE + COULOMB,
    normal_push_sticks: ALL,
    pulls_have_three_solutions: PURE + COULOMB,
    slip_without_normal_force: EFFECTS[0][1:] + EFFECTS[1][1:] + EFFECTS[2][1:],
    laws_of_infinite_friction_compare: ALL,
}
