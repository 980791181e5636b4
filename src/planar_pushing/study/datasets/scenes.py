"""Scenes of the figures: everything that a picture of one pushing problem shows (Secs. 3 and 4)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.centers import motion_centers
from planar_pushing.mechanics.cones import friction_cone, motion_angle, motion_cone
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solutions import Solutions
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.describe import describe
from planar_pushing.study.files.models import PushEntry, StudyFile
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EFFECT_DEGREES

#: Samples of the friction cone, from its right to its left edge.
CONE_SAMPLES = 181
SUPPORT_ANGLES = np.arange(0.0, 360.0, 15.0)


def pusher_angle(scene: Scene, push: PushEntry) -> float:
    """Angle of the fence's motion, degrees: given, or the slider's own under a force angle.

    With friction and inertia the slider's motion is that of equal shares.
    """
    if push.force_angle is None:
        return float(push.pusher_angle or 0.0)
    share = None if len(scene.kinds) == 1 else 0.5
    return float(np.rad2deg(motion_angle(scene, np.deg2rad(push.force_angle), share)))


def _solutions(scene: Scene, solutions: Solutions, pusher: Array) -> dict[str, Any]:
    radius = scene.slider.radius
    vectors = ("solution", "xy")
    return {
        "mode": ("solution", np.array([each.mode for each in solutions], np.int8)),
        "adhesive": ("solution", np.array([each.adhesive for each in solutions], bool)),
        "force": (vectors, np.reshape([each.force for each in solutions], (-1, 2))),
        "contact_motion": (vectors, np.reshape([s.contact_motion for s in solutions], (-1, 2))),
        "slip": ("solution", np.array([s.contact_motion[0] - pusher[0] for s in solutions], float)),
        "twist": (
            ("solution", "twist_component"),
            np.reshape([each.twist * [1, 1, radius] for each in solutions], (-1, 3)),
        ),
        "spin_ratio": ("solution", np.array([each.spin_ratio for each in solutions], float)),
        "center": (vectors, np.reshape([each.center for each in solutions], (-1, 2))),
    }


def _support(scene: Scene, twists: Array) -> dict[str, Any]:
    """Motion of points of the ring and, where it rubs, the friction of the support on them."""
    outward = direction(np.deg2rad(SUPPORT_ANGLES))
    turned = np.stack([-outward[:, 1], outward[:, 0]], axis=-1)
    motion = twists[:, None, :2] + twists[:, None, 2:] * turned
    weight = sum(each.weight for each in scene.friction)
    speed = np.linalg.norm(motion, axis=-1, keepdims=True)
    heading = np.divide(motion, speed, out=np.zeros_like(motion), where=speed > 0)
    dims = ("solution", "support_angle", "xy")
    return {
        "support_motion": (dims, motion),
        "support_force": (dims, -weight / (2 * np.pi) * heading),
    }


def _kinds(scene: Scene) -> dict[str, tuple[Any, ...]]:
    """The effects of each kind, by its name."""
    found = {
        name: tuple(each for each in scene.effects if each.degree == degree)
        for degree, name in EFFECT_DEGREES.items()
    }
    return {name: effects for name, effects in found.items() if effects}


def _cones(scene: Scene) -> dict[str, Any]:
    """Friction cone and motion cone, and the motions under each effect along the friction cone."""
    forces, motions = friction_cone(scene), motion_cone(scene)
    phi = np.linspace(forces.right, forces.left, CONE_SAMPLES)
    alone = [replace(scene, effects=kind) for kind in _kinds(scene).values()]
    angles = np.stack([motion_angle(each, phi) for each in alone])
    centers = np.stack([motion_centers(each, phi) for each in alone])
    return {
        "friction_cone_right": np.rad2deg(forces.right),
        "friction_cone_left": np.rad2deg(forces.left),
        "motion_cone_right": np.rad2deg(motions.right),
        "motion_cone_left": np.rad2deg(motions.left),
        "cone_force_angle": ("cone_sample", np.rad2deg(phi)),
        "cone_motion_angle": (("effect", "cone_sample"), np.rad2deg(angles)),
        "cone_center": (("effect", "cone_sample", "xy"), centers),
    }


def scene_dataset(file: SceneFile, push: PushEntry) -> xr.Dataset:
    """One pushing problem: geometry, cones, the fence's motion and every consistent solution."""
    scene = file.build()
    if not scene.isotropic:
        raise InvalidValue(
            "effects", "a support that is no ring, or a centre of mass off its centre",
            "pictures of rings", "use solve, cone and simulate, which take any support",
        )  # fmt: skip
    slider, angle = scene.slider, pusher_angle(scene, push)
    pusher = push.pusher_magnitude * direction(np.deg2rad(angle))
    solutions = solve(scene, np.deg2rad(angle), push.pusher_magnitude)
    values = _solutions(scene, solutions, pusher)
    variables: dict[str, Any] = {
        "rod_length": slider.rod_length,
        "rod_angle": float(np.rad2deg(slider.rod_angle)),
        "radius": slider.radius,
        "ring_center": ("xy", slider.rod_length * direction(slider.rod_angle)),
        "pusher_angle": angle,
        "pusher_magnitude": push.pusher_magnitude,
        "pusher_motion": ("xy", pusher),
        "outcome": np.int8(solutions.outcome),
        **_cones(scene),
        **values,
        **_support(scene, values["twist"][1]),
    }
    coords = {
        "xy": ["x", "y"],
        "effect": list(map(str, _kinds(scene))),
        "twist_component": ["v_x", "v_y", "R omega"],
        "support_angle": SUPPORT_ANGLES,
    }
    return describe(
        xr.Dataset(variables, coords=coords),
        title=file.title,
        source="Secs. 3 and 4",
        parameters={"scene": file, "push": push.model_dump(exclude={"file"})},
    )


def build(study: StudyFile) -> dict[str, xr.Dataset]:
    """Build the datasets of a study's scenes by name, one group of scenes.nc each."""
    return {
        name: scene_dataset(load_scene_file(push.file), push) for name, push in study.scenes.items()
    }
