"""Certified numbers of a scene: every solution of a push, its cones, and the friction on the ring."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from flint import arb, fmpq

from pulling_by_pushing.evidence.golden.cells.ring import motion_cone
from pulling_by_pushing.evidence.golden.cells.sliders import (
    BOTH,
    CENTERS,
    EDGES,
    FRICTION,
    INERTIA,
    Record,
    ring_slider,
    shares,
)
from pulling_by_pushing.evidence.golden.cells.solutions import solutions
from pulling_by_pushing.evidence.golden.numbers import center, motion_angle
from pulling_by_pushing.oracle.balls import (
    Direction,
    Number,
    at_degrees,
    cone_edge,
    cosine_sine,
    precise,
    rational,
    settle,
    terms,
)
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    contact_modes,
)
from pulling_by_pushing.oracle.motions import ray, unit_motion
from pulling_by_pushing.oracle.prove import Proved, Slider, State

CONE_SAMPLES = 181
SUPPORT_ANGLES = tuple(range(0, 360, 15))
EFFECT_NAMES = {"ring_friction": FRICTION, "inertia": INERTIA}
#: Variables of `solutions.columns` that a scene does not contain.
NOT_IN_SCENES = ("solutions", "force_end", "pivot", "continuum", "consistent", CENTERS)


def law_of(scene: Mapping[str, Any]) -> Law:
    """Contact law of the plain values of a scene file."""
    contact = scene["contact"]
    if contact["law"] == "coulomb":
        return Law(float(contact["friction_coefficient"]))
    if contact["law"] == "perfectly_rough":
        return PERFECTLY_ROUGH
    return INFINITE_FREE if contact["at_zero_normal"] == "free" else INFINITE_NONE


def study_of(scene: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """Values of a study and the label of the effects, of a scene of a ring."""
    effects = {effect["type"]: effect for effect in scene["effects"]}
    values = {"slider": {name: scene["slider"][name] for name in ("radius", "rod_angle")}}
    values |= {name: effects[kind] for kind, name in EFFECT_NAMES.items() if kind in effects}
    return values, "+".join(name for kind, name in EFFECT_NAMES.items() if kind in effects)


@precise
def scene_values(values: Mapping[str, Any]) -> Record:
    """Certified values of a scene under a push, from the plain values `scene` and `push` of their files."""
    scene, push = values["scene"], values["push"]
    study, effects = study_of(scene)
    length, radius = scene["slider"]["rod_length"], rational(scene["slider"]["radius"])
    slider, law, magnitude = (
        ring_slider(study, effects, length),
        law_of(scene),
        rational(push["pusher_magnitude"]),
    )
    degrees = _pusher_degrees(slider, effects, push)
    pusher = at_degrees(degrees)
    modes = contact_modes(slider, law, pusher, magnitude)
    columns = solutions(slider, modes, radius)
    motions = [mode.motion for mode in modes]
    weight = slider.body.weight / (2 * arb.pi())
    x, y = (magnitude * part for part in pusher.ball)
    return {
        **{name: scene["slider"][name] for name in ("rod_length", "rod_angle", "radius")},
        "pusher_magnitude": push["pusher_magnitude"],
        "pusher_angle": terms(arb(degrees)),
        "pusher_motion": [
            terms(x, pusher.roundings * magnitude),
            terms(y, pusher.roundings * magnitude),
        ],
        "ring_center": [terms(length * part, 2 * length) for part in slider.rod],
        "slip": [_slip(slider, motion, pusher, magnitude) for motion in motions],
        "adhesive": [
            _is_adhesive(force[1]) if isinstance(force[1], Number) else False
            for force in columns["force"]
        ],
        "support_motion": [_support(slider, motion, None) for motion in motions],
        "support_force": [_support(slider, motion, weight) for motion in motions],
        **{name: column for name, column in columns.items() if name not in NOT_IN_SCENES},
        **_cones(study, effects, length, law.friction_coefficient),
    }


def _is_adhesive(normal: Number) -> bool:
    """Whether a force pulls; one along the fence does not."""
    return not normal.ball.contains(0) and settle(normal) < 0


def _pusher_degrees(slider: Slider, effects: str, push: Mapping[str, Any]) -> fmpq:
    """Angle of the fence's motion: as given, or the double closest to the motion under a force."""
    if push["force_angle"] is None:
        return rational(push["pusher_angle"])
    force = at_degrees(push["force_angle"])
    motion = unit_motion(slider, force) if effects == BOTH else ray(slider, force)
    return rational(float(motion_angle(slider, force, motion).ball.mid()))


def _slip(slider: Slider, motion: Proved | None, pusher: Direction, magnitude: fmpq) -> Number:
    w = magnitude * pusher.ball[0]
    if motion is None:
        return terms(-w, pusher.roundings * magnitude)
    slip = motion.numbers(slider, lambda state: [state.to_fence(state.u_x, state.u_y)[0] - w])[0]
    return Number(slip.ball, slip.rounding + pusher.roundings * magnitude)


def _support(slider: Slider, motion: Proved | None, weight: Any) -> list[list[Any]]:
    """Motion of points of the ring, or the friction on them if there is a weight."""
    if motion is None:
        return [[0.0, 0.0] for _ in SUPPORT_ANGLES]
    radius = slider.body.support.extent if slider.body.support is not None else arb(1)
    places = [cosine_sine(fmpq(angle)) for angle in SUPPORT_ANGLES]

    def points(state: State) -> Iterable[arb]:
        v_x, v_y = state.to_fence(state.u_x, state.u_y + state.omega * state.length)
        for x, y in places:
            a, b = v_x - state.omega * radius * y, v_y + state.omega * radius * x
            scale = 1 if weight is None else -weight / (a * a + b * b).sqrt()
            yield from (scale * a, scale * b)

    numbers = [
        number if weight is None or weight != 0 else 0.0
        for number in motion.numbers(slider, points)
    ]
    return [list(pair) for pair in zip(numbers[::2], numbers[1::2], strict=True)]


def _cones(study: dict[str, Any], effects: str, length: float, mu: float) -> Record:
    """Friction cone and motion cone, and the motions under each effect at samples of the friction cone."""
    cone = motion_cone(study, effects, length, study["slider"]["rod_angle"], mu)
    record = {
        name: cone[name]
        for kind in ("friction", "motion")
        for name in [f"{kind}_cone_{s}" for s, _ in EDGES]
    }
    forces = [
        _sample(record["friction_cone_right"].ball, record["friction_cone_left"].ball, mu, i)
        for i in range(CONE_SAMPLES)
    ]
    angles, centers = [], []
    for effect in shares(effects):
        slider = ring_slider(study, effect, length)
        motions = [ray(slider, force) for force in forces]
        angles.append([motion_angle(slider, f, m) for f, m in zip(forces, motions, strict=True)])
        centers.append([center(slider, motion) for motion in motions])
    return record | {
        "cone_force_angle": [terms(force.angle, 180) for force in forces],
        "cone_motion_angle": angles,
        "cone_center": centers,
    }


def _sample(right: arb, left: arb, mu: float, index: int) -> Direction:
    """The force angle with this index, from the right to the left edge of the friction cone."""
    part = fmpq(index, CONE_SAMPLES - 1)
    if math.isinf(mu):
        return at_degrees(180 * part)
    for side, edge_index in ((1, 0), (-1, CONE_SAMPLES - 1)):
        if index == edge_index:
            return cone_edge(mu, side)
    return Direction(vector=_rational_direction(right + (left - right) * part))


def _rational_direction(degrees: arb) -> tuple[fmpq, fmpq]:
    """A rational vector whose angle differs from a given one by less than the precision."""
    turn = degrees / 180
    return (turn.cos_pi().mid().fmpq(), turn.sin_pi().mid().fmpq())
