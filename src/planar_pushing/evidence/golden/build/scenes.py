"""Golden scenes: every solution of a pushing problem, its force, motion, center and friction."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified import cones, ring
from planar_pushing.certified.balls import cosine_sine, precise, rational, sign
from planar_pushing.certified.contact import modes
from planar_pushing.certified.contact.sticking import Motion
from planar_pushing.certified.line_of_force import (
    contact_motion,
    motion_angle,
    motion_degrees,
    spin_ratio,
)
from planar_pushing.certified.setting import Effects, Heading, Slider, direction, heading
from planar_pushing.evidence.golden.build.packing import Values

#: Plain values of a scene file and of its entry in the study.
Scene = tuple[Mapping[str, Any], Mapping[str, Any]]
CONE_SAMPLES = 181
SUPPORT_ANGLES = tuple(range(0, 360, 15))
LAWS = {"free": modes.INFINITE_FREE, "none": modes.INFINITE_NONE}


def law_of(contact: Mapping[str, Any]) -> modes.Law:
    """Law of the contact entry of a scene file."""
    if contact["law"] == "coulomb":
        return modes.coulomb(contact["friction_coefficient"])
    if contact["law"] == "perfectly_rough":
        return modes.PERFECTLY_ROUGH
    return LAWS[contact["at_zero_normal"]]


def slider_of(scene: Mapping[str, Any]) -> tuple[Slider, Effects]:
    """Slider and kinds of effects of a scene file."""
    found = {each["type"]: each for each in scene["effects"]}
    parameters = {"radius": scene["slider"]["radius"]}
    parameters |= {"weight": found["ring_friction"]["weight"]} if "ring_friction" in found else {}
    inertia = found.get("inertia", {})
    parameters |= {name: inertia[name] for name in ("mass", "gyration_radius") if name in inertia}
    slider = Slider.of(scene["slider"]["rod_length"], scene["slider"]["rod_angle"], **parameters)
    kinds = {"ring_friction": "support_friction", "inertia": "inertia"}
    return slider, Effects("+".join(kinds[kind] for kind in kinds if kind in found))


def pusher_degrees(slider: Slider, effects: Effects, push: Mapping[str, Any]) -> fmpq:
    """Angle of the fence's motion: given, or the double nearest to the slider's own under a force angle."""
    if push["force_angle"] is None:
        return rational(push["pusher_angle"])
    share = fmpq(1, 2) if effects is Effects.BOTH else effects.shares[0]
    return rational(float(motion_angle(slider, heading(push["force_angle"]), share).mid()))


@precise
def scene_values(scene: Mapping[str, Any], push: Mapping[str, Any]) -> Values:
    """Certified values of a scene under a push, both as plain values of their files."""
    slider, effects = slider_of(scene)
    law, size = law_of(scene["contact"]), rational(scene["slider"]["radius"])
    degrees = pusher_degrees(slider, effects, push)
    magnitude = rational(push["pusher_magnitude"])
    pusher = heading(degrees)
    found = modes.contact_modes(slider, effects, law, float(magnitude), degrees)
    moving = [(mode, motion) for mode, motions in found.items() for motion in motions]
    solutions = [
        _solution(slider, effects, mode, motion, magnitude, pusher) for mode, motion in moving
    ]
    c, s = cosine_sine(slider.rod_angle)
    ring_center = [slider.rod_length * size * c, slider.rod_length * size * s]
    vectors = ("solution", "xy")
    values: Values = {
        "pusher_angle": ((), arb(degrees)),
        "pusher_motion": (("xy",), [magnitude * pusher.x, magnitude * pusher.y]),
        "ring_center": (("xy",), ring_center),
        "outcome": ((), modes.outcome(found)),
        "mode": (("solution",), [int(mode) for mode, _ in moving]),
        "adhesive": (("solution",), [bool(each["force"][1] < 0) for each in solutions]),
        "force": (vectors, [each["force"] for each in solutions]),
        "contact_motion": (vectors, [each["contact_motion"] for each in solutions]),
        "slip": (("solution",), [each["slip"] for each in solutions]),
        "twist": (("solution", "twist_component"), [each["twist"] for each in solutions]),
        "spin_ratio": (("solution",), [motion.spin_ratio for _, motion in moving]),
        "center": (vectors, [_center(ring_center, size, motion) for _, motion in moving]),
    }
    values |= _support(slider, effects, values)
    return values | cone_values(slider, effects, law, size, push["cone_samples"])


def _solution(
    slider: Slider,
    effects: Effects,
    mode: modes.Mode,
    motion: Motion,
    magnitude: fmpq,
    pusher: Heading,
) -> dict[str, Any]:
    if mode is modes.Mode.SEPARATE:
        rest = [arb(0), arb(0)]
        slip = -magnitude * pusher.x
        return {"force": rest, "contact_motion": rest, "slip": slip, "twist": [*rest, arb(0)]}
    along, k = direction(motion.force_angle), motion.spin_ratio
    u = contact_motion(slider, along, k)
    sticks = mode is modes.Mode.STICK
    speed = magnitude / (u[0] ** 2 + u[1] ** 2).sqrt() if sticks else magnitude * pusher.y / u[1]
    force = arb(0)
    if effects is not Effects.INERTIA:
        force += slider.weight * ring.profile(abs(k))[0]
    if effects is not Effects.FRICTION:
        force += slider.mass * speed
    return {
        "force": [force * along.x, force * along.y],
        "contact_motion": [speed * u[0], speed * u[1]],
        "slip": arb(0) if sticks else speed * u[0] - magnitude * pusher.x,
        "twist": [speed * along.x, speed * along.y, speed * k],
    }


def _center(ring_center: list[arb], size: fmpq, motion: Motion) -> list[arb]:
    """Motion center relative to the contact; of a translation the limit k -> 0+ of a rotation."""
    along, k = direction(motion.force_angle), motion.spin_ratio
    across = -along.y, along.x
    if sign(k) != 0:
        return [c + size * part / k for c, part in zip(ring_center, across, strict=True)]
    far = [arb.pos_inf() * part.sgn() if part != 0 else part for part in across]
    return [c + part for c, part in zip(ring_center, far, strict=True)]


def _support(slider: Slider, effects: Effects, values: Values) -> Values:
    """Motion of points of the ring, and the friction on them where the support rubs."""
    weight = arb(0) if effects is Effects.INERTIA else slider.weight / (2 * arb.pi())
    motions, forces = [], []
    for v_x, v_y, spin in values["twist"][1]:
        rubs = not (v_x == 0 and v_y == 0 and spin == 0)
        points = [cosine_sine(fmpq(angle)) for angle in SUPPORT_ANGLES]
        motion = [[v_x - spin * y, v_y + spin * x] for x, y in points]
        speeds = [(a * a + b * b).sqrt() for a, b in motion]
        motions.append(motion)
        forces.append(
            [
                [-weight * a / speed, -weight * b / speed] if rubs else [arb(0), arb(0)]
                for (a, b), speed in zip(motion, speeds, strict=True)
            ]
        )
    dims = ("solution", "support_angle", "xy")
    return {"support_motion": (dims, motions), "support_force": (dims, forces)}


def cone_values(
    slider: Slider, effects: Effects, law: modes.Law, size: fmpq, numbers: Iterable[int]
) -> Values:
    """Friction cone and motion cone, and the motions under each effect at samples of the friction cone."""
    mu = law.friction_coefficient
    forces, motions = cones.friction_cone(mu), cones.motion_cone(slider, effects, mu)
    samples = [_sample(forces, mu, i) for i in numbers]
    c, s = cosine_sine(slider.rod_angle)
    ring_center = [slider.rod_length * size * c, slider.rod_length * size * s]
    angles, centers = [], []
    for share in effects.shares:
        spins = [spin_ratio(slider, force, share) for force in samples]
        pairs = list(zip(samples, spins, strict=True))
        angles.append([motion_degrees(slider, force, k) for force, k in pairs])
        centers.append([_center(ring_center, size, Motion(k, force.degrees)) for force, k in pairs])
    return {
        "friction_cone_right": ((), forces.right),
        "friction_cone_left": ((), forces.left),
        "motion_cone_right": ((), motions.right),
        "motion_cone_left": ((), motions.left),
        "cone_force_angle": (("cone_sample",), [force.degrees for force in samples]),
        "cone_motion_angle": (("effect", "cone_sample"), angles),
        "cone_center": (("effect", "cone_sample", "xy"), centers),
    }


def _sample(forces: cones.Cone, mu: float, index: int) -> Heading:
    """Force angle number `index` from the right to the left edge of the friction cone."""
    if math.isinf(mu):
        return heading(fmpq(180 * index, CONE_SAMPLES - 1))
    part = fmpq(index, CONE_SAMPLES - 1)
    return direction(forces.right + (forces.left - forces.right) * part)
