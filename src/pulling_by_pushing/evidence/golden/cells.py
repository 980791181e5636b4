"""Certified numbers at one point of a grid: the variables of a dataset by name.

Parameters and coordinates are plain values, taken as exact. A cell is a function of the plain values of
its study and of its coordinates. It returns numbers, integers or booleans, or lists of them.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from functools import lru_cache, reduce
from typing import Any

from flint import arb, fmpq

from pulling_by_pushing.evidence.golden.numbers import (
    center,
    centers_of,
    force_angle,
    motion_angle,
    spin_ratio,
)
from pulling_by_pushing.oracle import bounds
from pulling_by_pushing.oracle.balls import (
    Direction,
    Number,
    at_degrees,
    cone_edge,
    in_degrees,
    norm,
    place,
    rational,
    settle,
    terms,
)
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    Solution,
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
from pulling_by_pushing.oracle.prove import Proved, Slider, State
from pulling_by_pushing.oracle.shapes import support
from pulling_by_pushing.oracle.support import Support

#: Name of a variable: its value at a point. The entry CENTERS lists supports and centers of rotation.
Record = dict[str, Any]
#: Plain values of a study, or of the part of one from which a dataset is built.
Values = Mapping[str, Any]
CENTERS = ""
ZERO, ONE = fmpq(0), fmpq(1)
LAWS = {
    "infinite_friction_free": INFINITE_FREE,
    "infinite_friction_none": INFINITE_NONE,
    "perfectly_rough": PERFECTLY_ROUGH,
}
FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"
#: Edges of a cone with their sides.
EDGES = (("right", 1), ("left", -1))


# --- Sliders ------------------------------------------------------------------------------------------


def ring_slider(values: Values, effects: str, length: float, angle: float | None = None) -> Slider:
    """The ring of a study with a rod, and the effects of a label."""
    return _ring_slider(
        json.dumps([values["slider"], values.get(FRICTION), values.get(INERTIA)]),
        effects,
        length,
        angle,
    )


@lru_cache(1 << 12)
def _ring_slider(entry: str, effects: str, length: float, angle: float | None) -> Slider:
    slider, friction, inertia = json.loads(entry)
    parameters: dict[str, Any] = {
        "gyration": rational((inertia or {}).get("gyration_radius", slider["radius"])) ** 2
    }
    if effects != INERTIA:
        parameters |= {"support": ring_of({"slider": slider})}
        parameters |= {"weight": rational((friction or {}).get("weight", 1))}
    if effects != FRICTION:
        parameters |= {"mass": rational((inertia or {}).get("mass", 1))}
    body = Body(length=rational(length), **parameters)
    return Slider(body, rational(slider["rod_angle"] if angle is None else angle))


@lru_cache(64)
def _support(entry: str) -> Support:
    return support(json.loads(entry))


def support_of(values: Values, name: str) -> Support:
    """A support of a study."""
    return _support(json.dumps(values["supports"][name]))


def ring_of(values: Values) -> Support:
    """The ring of a study."""
    return _support(json.dumps({"shape": "ring", "radius": values["slider"]["radius"]}))


@lru_cache(1 << 10)
def support_slider(pieces: Support, length: float, angle: float) -> Slider:
    """A slider of unit weight on a support."""
    return Slider(Body(length=rational(length), support=pieces, weight=ONE), rational(angle))


def labeled_law(label: str) -> Law:
    """Contact law of a label on the axis `contact`."""
    return LAWS[label] if label in LAWS else Law(float(label.removeprefix("coulomb_")))


# --- Datasets of the ring -----------------------------------------------------------------------------


def limit_point_values(
    values: Values, effects: str, length: float, angle: float, force_angle: float
) -> Record:
    """Point of the limit curve at a force angle."""
    slider, force = ring_slider(values, effects, length, angle), at_degrees(force_angle)
    motion = ray(slider, force) if effects == FRICTION else limit_point(slider, force)
    size, x, y = motion.numbers(
        slider, lambda s: [norm(s.f_x, s.f_y), *_along(force, norm(s.f_x, s.f_y))]
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


def curve_point(values: Values, effects: str, length: float, force_angle: float) -> Record:
    """Point of the limit curve at the study's rod angle."""
    angle = values["slider"]["rod_angle"]
    record = limit_point_values(values, effects, length, angle, force_angle)
    return {name: each for name, each in record.items() if name != "spin_ratio"}


def _along(force: Direction, size: arb) -> list[arb]:
    return [size * part for part in force.ball]


def shares(effects: str) -> list[str]:
    """The effects between which a motion lies, each alone."""
    return [FRICTION, INERTIA] if effects == BOTH else [effects]


def motion_cone(values: Values, effects: str, length: float, angle: float, mu: float) -> Record:
    """Friction cone, motion cone, and the quantities derived from them."""
    record: Record = {CENTERS: []}
    signs = []
    for name, side in EDGES:
        force = cone_edge(mu, side)
        both = ring_slider(values, effects, length, angle)
        limit = ray(both, force) if effects == FRICTION else limit_point(both, force)
        size = limit.numbers(both, lambda s: [norm(s.f_x, s.f_y)])[0]
        record |= {f"friction_cone_{name}": terms(force.angle, 90), f"limit_force_{name}": size}
        sliders = [ring_slider(values, effect, length, angle) for effect in shares(effects)]
        motions = [ray(slider, force) for slider in sliders]
        angles = [
            motion_angle(slider, force, m) for slider, m in zip(sliders, motions, strict=True)
        ]
        record[f"motion_cone_{name}"] = reduce(_least if side > 0 else _greatest, angles)
        record[CENTERS] += centers_of(sliders[0], motions[:1])
        signs.append(
            [settle(*normal_motion(slider, m)) for slider, m in zip(sliders, motions, strict=True)]
        )
    return record | {
        "pulls": any(min(side) < 0 for side in signs),
        "slips_while_pushing": any(min(side) > 0 for side in signs),
    }


def _least(a: Number, b: Number) -> Number:
    return Number(arb.min(a.ball, b.ball), arb.max(a.rounding, b.rounding))


def _greatest(a: Number, b: Number) -> Number:
    return Number(arb.max(a.ball, b.ball), arb.max(a.rounding, b.rounding))


def contact_laws(values: Values, label: str) -> Record:
    """Angle of friction of a contact law."""
    law = labeled_law(label)
    return {
        "friction_angle": friction_angle(math.nan if law.adhesive else law.friction_coefficient)
    }


def coefficients(values: Values, mu: float) -> Record:
    """Angle of friction of a coefficient."""
    return {"friction_angle": friction_angle(mu)}


def friction_angle(mu: float) -> Any:
    """Angle of friction of a coefficient, degrees."""
    if math.isnan(mu) or math.isinf(mu):
        return math.nan if math.isnan(mu) else 90.0
    return terms(in_degrees(arb(rational(mu)).atan()))


def ring_solutions(
    values: Values, effects: str, contact: str, length: float, magnitude: float, pusher_angle: float
) -> Record:
    """Every consistent solution of a push."""
    slider, pusher = ring_slider(values, effects, length), at_degrees(pusher_angle)
    modes = contact_modes(slider, labeled_law(contact), pusher, rational(magnitude))
    return solutions(slider, modes, rational(values["slider"]["radius"]))


def mode_set(
    values: Values, effects: str, contact: str, length: float, magnitude: float, pusher_angle: float
) -> Record:
    """Code of the set of consistent modes of a push."""
    slider, pusher = ring_slider(values, effects, length), at_degrees(pusher_angle)
    listed = contact_modes(slider, labeled_law(contact), pusher, rational(magnitude))
    motions = [each.motion for each in listed]
    return {
        "modes": sum({1 << each.mode for each in listed}),
        CENTERS: centers_of(slider, motions),
    }


def sticking_force(
    values: Values, effects: str, length: float, magnitude: float, pusher_angle: float
) -> Record:
    """Angle of the force under which the contact moves with the pusher."""
    slider, pusher = ring_slider(values, effects, length), at_degrees(pusher_angle)
    motion, _ = stick(slider, pusher, rational(magnitude))
    return {"sticking_force_angle": force_angle(slider, pusher, motion)}


def furthest_pull(
    values: Values, effects: str, contact: str, length: float, magnitude: float
) -> Record:
    """Pusher angle at which the sticking force is on the right edge of the friction cone."""
    law = labeled_law(contact)
    if law.adhesive:
        return {"furthest_pull": math.nan}
    slider, force = ring_slider(values, effects, length), cone_edge(law.friction_coefficient, 1)
    if effects == FRICTION:
        motion = ray(slider, force)
    else:
        motion = contact_motion(slider, force, rational(magnitude))
    return {"furthest_pull": motion_angle(slider, force, motion)}


#: Entries of a solution; `columns` converts them to lists along `solution`.
ENTRIES = (
    "mode", "force", "force_end", "twist", "contact_motion", "spin_ratio", "center", "pivot", "continuum",
)  # fmt: skip
NONE, CONSISTENT, PIVOTS, CONTINUUM = range(4)


def solutions(slider: Slider, modes: Sequence[Solution], size: fmpq | arb) -> Record:
    """The variables of the solutions of a push; `size` is the length of the spin ratio."""
    record = columns([solution(slider, mode, size) for mode in modes])
    return record | {CENTERS: centers_of(slider, [mode.motion for mode in modes])}


def solution(slider: Slider, mode: Solution, size: fmpq | arb) -> Record:
    """The variables of a solution."""
    entry: Record = {"mode": int(mode.mode), "continuum": mode.continuum}
    if mode.motion is None or mode.end is None:
        rest = {"force": [0.0, 0.0], "force_end": [0.0, 0.0], "contact_motion": [0.0, 0.0]}
        still = {
            "twist": [0.0, 0.0, 0.0],
            "spin_ratio": 0.0,
            "center": [math.nan, math.nan],
            "pivot": -1,
        }
        return entry | rest | still

    def parts(state: State) -> list[arb]:
        v = state.turned(state.u_x, state.u_y + state.omega * state.length)
        force, u = state.turned(state.f_x, state.f_y), state.turned(state.u_x, state.u_y)
        return [*force, *u, *v, state.omega]

    numbers = mode.motion.numbers(slider, parts)
    end = numbers if mode.end is mode.motion else mode.end.numbers(slider, parts)
    return entry | {
        "force": numbers[:2],
        "force_end": end[:2],
        "contact_motion": numbers[2:4],
        "twist": numbers[4:],
        "spin_ratio": spin_ratio(slider, mode.motion, size),
        "center": center(slider, mode.motion),
        "pivot": mode.motion.pivot,
    }


def columns(listed: Sequence[Record]) -> Record:
    """Convert the solutions of a push to its variables, which are lists along `solution`."""
    status = CONSISTENT if listed else NONE
    if any(entry["continuum"] for entry in listed):
        status = CONTINUUM
    elif any(entry["pivot"] >= 0 for entry in listed):
        status = PIVOTS
    counts = {"solutions": len(listed), "status": status, "outcome": min(len(listed), 2)}
    entries = {name: [entry[name] for entry in listed] for name in ENTRIES}
    return counts | entries | {"consistent": [True] * len(listed)}


def acceleration_center(values: Values, length: float, force_angle: float, share: float) -> Record:
    """Acceleration center relative to the contact, and motion, at a share of inertia."""
    slider, force = _slider_at_share(values, length, None, share), at_degrees(force_angle)
    motion = unit_motion(slider, force)
    x, y = center(slider, motion)
    angle = motion_angle(slider, force, motion)
    return {
        "center_x": x,
        "center_y": y,
        "motion_angle": angle,
        CENTERS: centers_of(slider, [motion]),
    }


def _slider_at_share(values: Values, length: float, angle: float | None, share: float) -> Slider:
    return _shared_slider(json.dumps([values["slider"], values[INERTIA]]), length, angle, share)


@lru_cache(1 << 10)
def _shared_slider(entry: str, length: float, angle: float | None, share: float) -> Slider:
    slider, inertia = json.loads(entry)
    part = rational(share)
    body = Body(
        length=rational(length),
        support=ring_of({"slider": slider}),
        weight=1 - part,
        mass=part,
        gyration=rational(inertia["gyration_radius"]) ** 2,
    )
    return Slider(body, rational(slider["rod_angle"] if angle is None else angle))


def region_ends(values: Values, length: float, angle: float, force_angle: float) -> Record:
    """Ends of both regions of centers under one line of force, relative to the contact (Sec. 4).

    The ends of the exact region are friction alone and inertia alone.
    """
    force, record, centers = at_degrees(force_angle), Record(), []
    for share in (0.0, 1.0):
        slider = _slider_at_share(values, length, angle, share)
        motion = unit_motion(slider, force)
        centers.append(center(slider, motion))
        record.setdefault(CENTERS, []).extend(centers_of(slider, [motion]))
    limits = bounds.region_ends(slider, force, rational(values["slider"]["radius"]))
    for i, x in enumerate("xy"):
        record[f"bound_{x}"] = [end[i] for end in limits]
        record[f"exact_{x}"] = [end[i] for end in centers]
    return record


def acceleration_cones(values: Values, length: float) -> Record:
    """The paper's bound and the exact cone under infinite friction."""
    slider = ring_slider(values, BOTH, length)
    bound = bounds.conservative_cone(slider, rational(values["slider"]["radius"]))
    exact = motion_cone(values, BOTH, length, values["slider"]["rod_angle"], math.inf)
    return {f"conservative_cone_{name}": bound[i] for i, (name, _) in enumerate(EDGES)} | {
        f"exact_cone_{name}": exact[f"motion_cone_{name}"] for name, _ in EDGES
    }


# --- Datasets of any support --------------------------------------------------------------------------


def support_wrench(values: Values, name: str, x: float, y: float) -> Record:
    """Mean distance, and the wrench about the origin for a counterclockwise rotation."""
    pieces, at = support_of(values, name), place((x, y))
    c = arb(at[0]), arb(at[1])
    foot = next((i for i, point in enumerate(pieces.points) if point.place == at), -1)
    distance, g_x, g_y, *_ = pieces.dgh(c, foot)
    return {
        "mean_distance": terms(distance, distance),
        "force_x": terms(g_y, 1),
        "force_y": terms(-g_x, 1),
        "torque": terms(distance - c[0] * g_x - c[1] * g_y, distance, c[0] * g_x, c[1] * g_y),
        CENTERS: [(pieces, c)],
    }


def support_numbers(values: Values, name: str) -> Record:
    """Numbers of a support as a whole; the errors of its ellipsoid are stored as computed."""
    pieces = support_of(values, name)
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


def support_cone(values: Values, name: str, length: float, angle: float, friction: float) -> Record:
    """Edges of a motion cone, the feet about which they pivot, and the quantities derived from them."""
    slider = support_slider(support_of(values, name), length, angle)
    (right, left), motions = edges(slider, friction)
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
    values: Values, name: str, length: float, angle: float, friction: float, pusher: float
) -> Record:
    """Every consistent solution of a push."""
    pieces = support_of(values, name)
    slider = support_slider(pieces, length, angle)
    modes = contact_modes(slider, Law(friction), at_degrees(pusher), ONE)
    return solutions(slider, modes, pieces.extent)


def support_curve(values: Values, name: str, force_angle: float) -> Record:
    """Point of the limit curve of a support, for the rod of the study."""
    size, motion, slider = _curve_point(values, support_of(values, name), force_angle)
    return {
        "force": size,
        "motion_angle": motion_angle(slider, at_degrees(force_angle), motion),
        "pivot": motion.pivot,
        CENTERS: centers_of(slider, [motion]),
    }


def ring_curve(values: Values, force_angle: float) -> Record:
    """Point of the limit curve of the ring, for the rod of the study."""
    return {"ring_force": _curve_point(values, ring_of(values), force_angle)[0]}


def _curve_point(
    values: Values, pieces: Support, force_angle: float
) -> tuple[Number, Proved, Slider]:
    rod = values["slider"]
    slider = support_slider(pieces, rod["rod_length"], rod["rod_angle"])
    motion = ray(slider, at_degrees(force_angle))
    return motion.numbers(slider, lambda s: [norm(s.f_x, s.f_y)])[0], motion, slider


def swept_rod(values: Values, index: int) -> tuple[float, float]:
    """Length and angle of a rod: all lengths at the slider's angle precede all angles at its length."""
    rod, lengths, angles = (
        values["slider"],
        values["grid"]["rod_length"],
        values["grid"]["rod_angle"],
    )
    if index < len(lengths):
        return lengths[index], rod["rod_angle"]
    return rod["rod_length"], angles[index - len(lengths)]


def support_rod(values: Values, name: str, index: int) -> Record:
    """Cone of infinite friction of a support with a rod, and the friction that pulling needs."""
    slider = support_slider(support_of(values, name), *swept_rod(values, index))
    angles, motions = edges(slider, math.inf)
    return {
        "motion_angle": angles,
        "pulling_friction_angle": pulling_friction_angle(slider),
        CENTERS: centers_of(slider, motions),
    }


def ring_rod(values: Values, index: int) -> Record:
    """A rod, and the same of the ring; with inertia alone, too."""
    length, angle = swept_rod(values, index)
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
            f_x, f_y = state.turned(state.f_x, state.f_y)
            return [in_degrees(arb.atan2(f_y, heading * f_x))]

        sides.append(reduce(_least, (end.numbers(slider, above)[0] for end in ends)))
    steeper = reduce(_greatest, [*sides, Number(arb(0), arb(0))])
    angle = 90 - steeper.ball
    return Number(angle, steeper.rounding + 90 + abs(angle))
