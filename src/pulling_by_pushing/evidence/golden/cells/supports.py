"""Certified numbers at one point of a grid of supports: the variables of a dataset by name."""

from __future__ import annotations

import math
from functools import reduce

from flint import arb, fmpq

from pulling_by_pushing.evidence.golden.cells.sliders import (
    CENTERS,
    EDGES,
    ONE,
    Record,
    StudyValues,
    ring_of,
    support_of,
    support_slider,
)
from pulling_by_pushing.evidence.golden.cells.solutions import solutions
from pulling_by_pushing.evidence.golden.numbers import (
    centers_of,
    larger,
    motion_angle,
    smaller,
)
from pulling_by_pushing.oracle.balls import (
    Number,
    at_degrees,
    cone_edge,
    in_degrees,
    norm,
    rational,
    rational_pair,
    settle,
    terms,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.modes import (
    Law,
    contact_modes,
    normal_motion,
)
from pulling_by_pushing.oracle.motions import (
    ray,
    stick,
)
from pulling_by_pushing.oracle.prove import Proved, Slider, State
from pulling_by_pushing.oracle.support import Support


def support_wrench(values: StudyValues, support: str, center_x: float, center_y: float) -> Record:
    """Mean distance, and the wrench about the origin for a counterclockwise rotation."""
    pieces, center = support_of(values, support), rational_pair((center_x, center_y))
    c = arb(center[0]), arb(center[1])
    foot = next((i for i, point in enumerate(pieces.points) if point.position == center), -1)
    distance, g_x, g_y, *_ = pieces.dgh(c, foot)
    return {
        "mean_distance": terms(distance, distance),
        "force_x": terms(g_y, 1),
        "force_y": terms(-g_x, 1),
        "torque": terms(distance - c[0] * g_x - c[1] * g_y, distance, c[0] * g_x, c[1] * g_y),
        CENTERS: [(pieces, c)],
    }


def support_numbers(values: StudyValues, support: str) -> Record:
    """Numbers of a support as a whole; the errors of its ellipsoid are stored as computed."""
    pieces = support_of(values, support)
    (x, y), extent = pieces.center, pieces.extent
    distance = pieces.dgh((arb(x), arb(y)))[0]
    last = 1 / (distance * distance)
    return {
        "center_of_pressure_x": terms(arb(x), extent),
        "center_of_pressure_y": terms(arb(y), extent),
        "extent": terms(extent),
        "integration_constant": terms(distance / extent),
        "ellipsoid": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, terms(last, last)]],
    }


def support_cone(
    values: StudyValues,
    support: str,
    rod_length: float,
    rod_angle: float,
    friction_coefficient: float,
) -> Record:
    """Edges of a motion cone, the feet about which they pivot, and the quantities derived from them."""
    slider = support_slider(support_of(values, support), rod_length, rod_angle)
    (right, left), motions = edges(slider, friction_coefficient)
    signs = [settle(*normal_motion(slider, motion)) for motion in motions]
    return {
        "motion_angle": [right, left],
        "pivot": [motion.pivot for motion in motions],
        "width": Number(left.ball - right.ball, left.rounding + right.rounding),
        "pulls": min(signs) < 0,
        "slips_while_pushing": max(signs) > 0,
        CENTERS: centers_of(slider, motions),
    }


def edges(slider: Slider, friction: float) -> tuple[list[Number], list[Proved]]:
    """Angles of the edges of a motion cone, right and left, and their motions."""
    forces = [cone_edge(friction, side) for _, side in EDGES]
    motions = [ray(slider, force) for force in forces]
    angles = [motion_angle(slider, force, m) for force, m in zip(forces, motions, strict=True)]
    return angles, motions


def support_solutions(
    values: StudyValues,
    support: str,
    rod_length: float,
    rod_angle: float,
    friction_coefficient: float,
    pusher_angle: float,
) -> Record:
    """Every consistent solution of a push."""
    pieces = support_of(values, support)
    slider = support_slider(pieces, rod_length, rod_angle)
    modes = contact_modes(slider, Law(friction_coefficient), at_degrees(pusher_angle), ONE)
    return solutions(slider, modes, pieces.extent)


def support_curve(values: StudyValues, support: str, force_angle: float) -> Record:
    """Point of the limit curve of a support, for the rod of the study."""
    size, motion, slider = _curve_point(values, support_of(values, support), force_angle)
    return {
        "force": size,
        "motion_angle": motion_angle(slider, at_degrees(force_angle), motion),
        "pivot": motion.pivot,
        CENTERS: centers_of(slider, [motion]),
    }


def ring_curve(values: StudyValues, force_angle: float) -> Record:
    """Point of the limit curve of the ring, for the rod of the study."""
    return {"ring_force": _curve_point(values, ring_of(values), force_angle)[0]}


def _curve_point(
    values: StudyValues, pieces: Support, force_angle: float
) -> tuple[Number, Proved, Slider]:
    rod = values["slider"]
    slider = support_slider(pieces, rod["rod_length"], rod["rod_angle"])
    motion = ray(slider, at_degrees(force_angle))
    return motion.numbers(slider, lambda s: [norm(s.f_x, s.f_y)])[0], motion, slider


def swept_rod(values: StudyValues, index: int) -> tuple[float, float]:
    """Length and angle of a rod: all lengths at the slider's angle precede all angles at its length."""
    rod, lengths, angles = (
        values["slider"],
        values["grid"]["rod_length"],
        values["grid"]["rod_angle"],
    )
    if index < len(lengths):
        return lengths[index], rod["rod_angle"]
    return rod["rod_length"], angles[index - len(lengths)]


def support_rod(values: StudyValues, support: str, rod: int) -> Record:
    """Cone of infinite friction of a support with a rod, and the friction that pulling needs."""
    slider = support_slider(support_of(values, support), *swept_rod(values, rod))
    angles, motions = edges(slider, math.inf)
    return {
        "motion_angle": angles,
        "pulling_friction_angle": pulling_friction_angle(slider),
        CENTERS: centers_of(slider, motions),
    }


def ring_rod(values: StudyValues, rod: int) -> Record:
    """A rod, and the same of the ring; with inertia alone, too."""
    length, angle = swept_rod(values, rod)
    slider = support_slider(ring_of(values), length, angle)
    body = Body(
        length=rational(length), mass=ONE, gyration=rational(values["slider"]["radius"]) ** 2
    )
    return {
        "rod_length": length,
        "rod_angle": angle,
        "ring_motion_angle": edges(slider, math.inf)[0],
        "ring_pulling_friction_angle": pulling_friction_angle(slider),
        "inertia_pulling_friction_angle": pulling_friction_angle(Slider(body, rational(angle))),
    }


def pulling_friction_angle(slider: Slider) -> Number:
    """Smallest angle of friction, degrees, at which the contact can pull; 90 if it never can.

    The friction cone must contain a force beyond those that sustain the motion along the fence, to the
    right or to the left.
    """
    sides = []
    for heading in (ONE, -ONE):
        ends = stick(slider, at_degrees(90 - 90 * heading), ONE)

        def above(state: State, heading: fmpq = heading) -> list[arb]:
            f_x, f_y = state.to_fence(state.f_x, state.f_y)
            return [in_degrees(arb.atan2(f_y, heading * f_x))]

        sides.append(reduce(smaller, (end.numbers(slider, above)[0] for end in ends)))
    steeper = reduce(larger, [*sides, Number(arb(0), arb(0))])
    angle = 90 - steeper.ball
    return Number(angle, steeper.rounding + 90 + abs(angle))
