"""Certified numbers at one point of a grid of the paper's ring: the variables of a dataset by name."""

from __future__ import annotations

import math
from functools import reduce

from flint import arb

from pulling_by_pushing.evidence.golden.cells.contacts import labeled_law
from pulling_by_pushing.evidence.golden.cells.sliders import (
    BOTH,
    CENTERS,
    EDGES,
    FRICTION,
    Record,
    StudyValues,
    ring_slider,
    shares,
    slider_at_share,
)
from pulling_by_pushing.evidence.golden.cells.solutions import solutions
from pulling_by_pushing.evidence.golden.numbers import (
    center,
    centers_of,
    force_angle,
    larger,
    motion_angle,
    smaller,
    spin_ratio,
)
from pulling_by_pushing.oracle import bounds
from pulling_by_pushing.oracle.balls import (
    Direction,
    Number,
    at_degrees,
    cone_edge,
    norm,
    rational,
    settle,
    terms,
)
from pulling_by_pushing.oracle.modes import (
    contact_modes,
    normal_motion,
)
from pulling_by_pushing.oracle.motions import (
    contact_motion,
    limit_point,
    ray,
    stick,
    unit_motion,
)


def limit_point_values(
    values: StudyValues, effects: str, rod_length: float, rod_angle: float, force_angle: float
) -> Record:
    """Point of the limit curve at a force angle."""
    slider, force = ring_slider(values, effects, rod_length, rod_angle), at_degrees(force_angle)
    motion = ray(slider, force) if effects == FRICTION else limit_point(slider, force)
    size, x, y = motion.numbers(
        slider, lambda s: [norm(s.f_x, s.f_y), *_components(force, norm(s.f_x, s.f_y))]
    )
    turn = abs(size.ball) * force.roundings
    return {
        "force": size,
        "force_x": Number(x.ball, x.rounding + turn),
        "force_y": Number(y.ball, y.rounding + turn),
        "spin_ratio": spin_ratio(slider, motion, rational(values["slider"]["radius"])),
        "motion_angle": motion_angle(slider, force, motion),
        CENTERS: centers_of(slider, [motion]),
    }


def curve_point(values: StudyValues, effects: str, rod_length: float, force_angle: float) -> Record:
    """Point of the limit curve at the study's rod angle."""
    angle = values["slider"]["rod_angle"]
    record = limit_point_values(values, effects, rod_length, angle, force_angle)
    return {name: number for name, number in record.items() if name != "spin_ratio"}


def _components(force: Direction, size: arb) -> list[arb]:
    return [size * part for part in force.ball]


def motion_cone(
    values: StudyValues,
    effects: str,
    rod_length: float,
    rod_angle: float,
    friction_coefficient: float,
) -> Record:
    """Friction cone, motion cone, and the quantities derived from them."""
    record: Record = {CENTERS: []}
    signs = []
    for name, side in EDGES:
        force = cone_edge(friction_coefficient, side)
        slider_of_all = ring_slider(values, effects, rod_length, rod_angle)
        limit = (
            ray(slider_of_all, force) if effects == FRICTION else limit_point(slider_of_all, force)
        )
        size = limit.numbers(slider_of_all, lambda s: [norm(s.f_x, s.f_y)])[0]
        record |= {f"friction_cone_{name}": terms(force.angle, 90), f"limit_force_{name}": size}
        sliders = [ring_slider(values, effect, rod_length, rod_angle) for effect in shares(effects)]
        motions = [ray(slider, force) for slider in sliders]
        angles = [
            motion_angle(slider, force, m) for slider, m in zip(sliders, motions, strict=True)
        ]
        record[f"motion_cone_{name}"] = reduce(smaller if side > 0 else larger, angles)
        record[CENTERS] += centers_of(sliders[0], motions[:1])
        signs.append(
            [settle(*normal_motion(slider, m)) for slider, m in zip(sliders, motions, strict=True)]
        )
    return record | {
        "pulls": any(min(side) < 0 for side in signs),
        "slips_while_pushing": any(min(side) > 0 for side in signs),
    }


def ring_solutions(
    values: StudyValues,
    effects: str,
    contact: str,
    rod_length: float,
    pusher_magnitude: float,
    pusher_angle: float,
) -> Record:
    """Every consistent solution of a push."""
    slider, pusher = ring_slider(values, effects, rod_length), at_degrees(pusher_angle)
    modes = contact_modes(slider, labeled_law(contact), pusher, rational(pusher_magnitude))
    return solutions(slider, modes, rational(values["slider"]["radius"]))


def mode_set(
    values: StudyValues,
    effects: str,
    contact: str,
    rod_length: float,
    pusher_magnitude: float,
    pusher_angle: float,
) -> Record:
    """Code of the set of consistent modes of a push."""
    slider, pusher = ring_slider(values, effects, rod_length), at_degrees(pusher_angle)
    solutions_of_push = contact_modes(
        slider, labeled_law(contact), pusher, rational(pusher_magnitude)
    )
    motions = [solution.motion for solution in solutions_of_push]
    return {
        "modes": sum({1 << solution.mode for solution in solutions_of_push}),
        CENTERS: centers_of(slider, motions),
    }


def sticking_force(
    values: StudyValues,
    effects: str,
    rod_length: float,
    pusher_magnitude: float,
    pusher_angle: float,
) -> Record:
    """Angle of the force under which the contact moves with the pusher."""
    slider, pusher = ring_slider(values, effects, rod_length), at_degrees(pusher_angle)
    motion, _ = stick(slider, pusher, rational(pusher_magnitude))
    return {"sticking_force_angle": force_angle(slider, pusher, motion)}


def furthest_pull(
    values: StudyValues, effects: str, contact: str, rod_length: float, pusher_magnitude: float
) -> Record:
    """Pusher angle at which the sticking force is on the right edge of the friction cone."""
    law = labeled_law(contact)
    if law.adhesive:
        return {"furthest_pull": math.nan}
    slider, force = ring_slider(values, effects, rod_length), cone_edge(law.friction_coefficient, 1)
    if effects == FRICTION:
        motion = ray(slider, force)
    else:
        motion = contact_motion(slider, force, rational(pusher_magnitude))
    return {"furthest_pull": motion_angle(slider, force, motion)}


def acceleration_center(
    values: StudyValues, rod_length: float, force_angle: float, inertia_share: float
) -> Record:
    """Acceleration center relative to the contact, and motion, at a share of inertia."""
    slider, force = (
        slider_at_share(values, rod_length, None, inertia_share),
        at_degrees(force_angle),
    )
    motion = unit_motion(slider, force)
    x, y = center(slider, motion)
    angle = motion_angle(slider, force, motion)
    return {
        "center_x": x,
        "center_y": y,
        "motion_angle": angle,
        CENTERS: centers_of(slider, [motion]),
    }


def region_ends(
    values: StudyValues, rod_length: float, rod_angle: float, force_angle: float
) -> Record:
    """Ends of both regions of centers under one line of force, relative to the contact (Sec. 4).

    The ends of the exact region are friction alone and inertia alone.
    """
    force, record, centers = at_degrees(force_angle), Record(), []
    for share in (0.0, 1.0):
        slider = slider_at_share(values, rod_length, rod_angle, share)
        motion = unit_motion(slider, force)
        centers.append(center(slider, motion))
        record.setdefault(CENTERS, []).extend(centers_of(slider, [motion]))
    limits = bounds.region_ends(slider, force, rational(values["slider"]["radius"]))
    for i, x in enumerate("xy"):
        record[f"bound_{x}"] = [end[i] for end in limits]
        record[f"exact_{x}"] = [end[i] for end in centers]
    return record


def acceleration_cones(values: StudyValues, rod_length: float) -> Record:
    """The paper's bound and the exact cone under infinite friction."""
    slider = ring_slider(values, BOTH, rod_length)
    bound = bounds.conservative_cone(slider, rational(values["slider"]["radius"]))
    exact = motion_cone(values, BOTH, rod_length, values["slider"]["rod_angle"], math.inf)
    return {f"conservative_cone_{name}": bound[i] for i, (name, _) in enumerate(EDGES)} | {
        f"exact_cone_{name}": exact[f"motion_cone_{name}"] for name, _ in EDGES
    }
