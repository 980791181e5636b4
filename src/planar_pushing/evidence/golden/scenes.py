"""Certified numbers of a scene: every solution of a push, its cones, and the friction on the ring."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified import cones
from planar_pushing.certified.balls import cosine_sine, precise, rational
from planar_pushing.certified.contact import modes
from planar_pushing.certified.contact.sticking import Motion
from planar_pushing.certified.effects.given import law as law_of
from planar_pushing.certified.line_of_force import motion_angle, motion_degrees, spin_ratio
from planar_pushing.certified.setting import Effects, Heading, Slider, direction, heading
from planar_pushing.evidence.golden.cells import (
    Record,
    center,
    columns,
    leave_out_centers,
    solution,
)

CONE_SAMPLES = 181
SUPPORT_ANGLES = tuple(range(0, 360, 15))
KINDS = {"ring_friction": "support_friction", "inertia": "inertia"}
#: Variables of `columns` that a scene does not contain.
ELSEWHERE = ("solutions", "force_end", "pivot", "continuum", "consistent")


def slider_of(scene: Mapping[str, Any]) -> tuple[Slider, Effects]:
    """Slider and effects of the plain values of a scene file; a ring with friction, inertia or both."""
    found = {each["type"]: each for each in scene["effects"]}
    parameters = {"radius": scene["slider"]["radius"]}
    parameters |= {"weight": found["ring_friction"]["weight"]} if "ring_friction" in found else {}
    inertia = found.get("inertia", {})
    parameters |= {name: inertia[name] for name in ("mass", "gyration_radius") if name in inertia}
    own = Slider.of(scene["slider"]["rod_length"], scene["slider"]["rod_angle"], **parameters)
    return own, Effects("+".join(KINDS[kind] for kind in KINDS if kind in found))


def pusher_degrees(own: Slider, effects: Effects, push: Mapping[str, Any]) -> fmpq:
    """Angle of the fence's motion: as given, or the double closest to the motion under a force."""
    if push["force_angle"] is None:
        return rational(push["pusher_angle"])
    share = fmpq(1, 2) if effects is Effects.BOTH else effects.shares[0]
    return rational(float(motion_angle(own, heading(push["force_angle"]), share).mid()))


@precise
def scene_values(values: Mapping[str, Any]) -> Record:
    """Certified values of a scene under a push, from the plain values `scene` and `push` of their files."""
    scene, push = values["scene"], values["push"]
    own, effects = slider_of(scene)
    law, size = law_of(scene), rational(scene["slider"]["radius"])
    degrees, magnitude = pusher_degrees(own, effects, push), rational(push["pusher_magnitude"])
    pusher = heading(degrees)
    found = modes.contact_modes(own, effects, law, float(magnitude), degrees)
    continuum = modes.is_continuum(own, effects, law, degrees)
    listed = [
        solution(own, effects, law, mode, motion, magnitude, pusher)
        | {"center": center(own, size, motion), "pivot": -1, "force_end": []}
        | {"continuum": continuum and mode is modes.Mode.STICK}
        for mode, motions in found.items()
        for motion in motions
    ]
    leave_out_centers(listed)
    rubbing = [_support(own, effects, each["twist"]) for each in listed]
    for each in listed:
        v_x, v_y, spin = each["twist"]
        each["twist"] = [v_x, v_y, spin / size]
    c, s = cosine_sine(own.rod_angle)
    given: Record = {
        **{name: scene["slider"][name] for name in ("rod_length", "rod_angle", "radius")},
        "pusher_magnitude": push["pusher_magnitude"],
        "pusher_angle": arb(degrees),
        "pusher_motion": [magnitude * pusher.x, magnitude * pusher.y],
        "ring_center": [own.rod_length * size * c, own.rod_length * size * s],
        "slip": [each["slip"] for each in listed],
        "adhesive": [bool(each["force"][1] < 0) for each in listed],
        "support_motion": [motion for motion, _ in rubbing],
        "support_force": [force for _, force in rubbing],
    }
    own_columns = {name: each for name, each in columns(listed).items() if name not in ELSEWHERE}
    return given | own_columns | _cones(own, effects, law, size)


def _support(own: Slider, effects: Effects, twist: list[arb]) -> tuple[Any, Any]:
    """Motion of points of the ring, and the friction on them if there is support friction."""
    weight = arb(0) if effects is Effects.INERTIA else own.weight / (2 * arb.pi())
    v_x, v_y, spin = twist
    points = [cosine_sine(fmpq(angle)) for angle in SUPPORT_ANGLES]
    motion = [[v_x - spin * y, v_y + spin * x] for x, y in points]
    if v_x == 0 and v_y == 0 and spin == 0:
        return motion, [[arb(0), arb(0)] for _ in motion]
    speeds = [(a * a + b * b).sqrt() for a, b in motion]
    return motion, [
        [-weight * a / speed, -weight * b / speed]
        for (a, b), speed in zip(motion, speeds, strict=True)
    ]


def _cones(own: Slider, effects: Effects, law: modes.Law, size: fmpq) -> Record:
    """Friction cone and motion cone, and the motions under each effect at samples of the friction cone."""
    mu = law.friction_coefficient
    forces, motions = cones.friction_cone(mu), cones.motion_cone(own, effects, mu)
    samples = [_sample(forces, mu, i) for i in range(CONE_SAMPLES)]
    angles, centers = [], []
    for share in effects.shares:
        pairs = [(force, spin_ratio(own, force, share)) for force in samples]
        angles.append([motion_degrees(own, force, k) for force, k in pairs])
        centers.append([center(own, size, Motion(k, force.degrees)) for force, k in pairs])
    return {
        "friction_cone_right": forces.right,
        "friction_cone_left": forces.left,
        "motion_cone_right": motions.right,
        "motion_cone_left": motions.left,
        "cone_force_angle": [force.degrees for force in samples],
        "cone_motion_angle": angles,
        "cone_center": centers,
    }


def _sample(forces: cones.Cone, mu: float, index: int) -> Heading:
    """The force angle with this index, from the right to the left edge of the friction cone."""
    if math.isinf(mu):
        return heading(fmpq(180 * index, CONE_SAMPLES - 1))
    part = fmpq(index, CONE_SAMPLES - 1)
    return direction(forces.right + (forces.left - forces.right) * part)
