"""Scenes of the figures: all data for a picture of one pushing problem (Secs. 3 and 4)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.force.centers import motion_centers
from planar_pushing.mechanics.force.cones import (
    angle_under_force,
    friction_cone,
    motion_angle,
    motion_cone,
)
from planar_pushing.mechanics.force.rubbing import RING_ANGLES, place_friction, ring_friction
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solutions import Solutions
from planar_pushing.mechanics.solve import solve
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.numbers import in_radians
from planar_pushing.terms.options import EffectKind
from planar_pushing.terms.quantities import TWIST, TWIST_UNITS
from pulling_by_pushing.study.describe import describe, scene_scalars
from pulling_by_pushing.study.model import PushEntry

#: Samples of the friction cone, from its right to its left edge.
CONE_SAMPLES = 181


def pusher_angle(scene: Scene, push: PushEntry) -> float:
    """Angle of the fence's motion in degrees: the given one, or that of the contact under a force angle."""
    if push.force_angle is None:
        return float(push.pusher_angle or 0.0)
    return angle_under_force(scene, push.force_angle)


def _solutions(solutions: Solutions, pusher: Array) -> dict[str, Any]:
    vectors = ("solution", "xy")
    return {
        "mode": ("solution", np.array([s.mode for s in solutions], np.int8)),
        "adhesive": ("solution", np.array([s.adhesive for s in solutions], bool)),
        "force": (vectors, np.reshape([s.force for s in solutions], (-1, 2))),
        "contact_motion": (vectors, np.reshape([s.contact_motion for s in solutions], (-1, 2))),
        "slip": ("solution", np.array([s.contact_motion[0] - pusher[0] for s in solutions], float)),
        "twist": (
            ("solution", "twist_component"),
            np.reshape([s.twist for s in solutions], (-1, 3)),
        ),
        "spin_ratio": ("solution", np.array([s.spin_ratio for s in solutions], float)),
        "center": (vectors, np.reshape([s.center for s in solutions], (-1, 2))),
    }


def _pivots(solutions: Solutions) -> dict[str, Any]:
    """Support point about which each solution pivots, and the other end of the force range of a pivot."""
    ends = np.reshape([s.force_end for s in solutions], (-1, 2))
    return {
        "force_end": (("solution", "xy"), ends),
        "pivot": ("solution", np.array([s.pivot for s in solutions], np.int32)),
    }


def _kinds(scene: Scene) -> dict[str, tuple[Any, ...]]:
    """Effects that resist a push from rest, grouped by the name of their kind."""
    absent = {EffectKind.LOAD} | ({EffectKind.VISCOUS} if scene.stores_energy else set())
    groups = {
        kind: tuple(effect for effect in scene.effects if effect.kind == kind)
        for kind in EffectKind
        if kind not in absent
    }
    return {name: effects for name, effects in groups.items() if effects}


def _cones(scene: Scene) -> dict[str, Any]:
    """Friction cone, motion cone, and the motions under each effect along the friction cone."""
    forces, motions = friction_cone(scene), motion_cone(scene)
    phi = np.linspace(forces.right, forces.left, CONE_SAMPLES)
    kind_scenes = [replace(scene, effects=kind) for kind in _kinds(scene).values()]
    angles = np.stack([motion_angle(kind_scene, phi) for kind_scene in kind_scenes])
    centers = np.stack([motion_centers(kind_scene, phi) for kind_scene in kind_scenes])
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
    slider, angle = scene.slider, pusher_angle(scene, push)
    pusher = push.pusher_magnitude * direction(in_radians(angle))
    solutions = solve(scene, in_radians(angle), push.pusher_magnitude)
    values = _solutions(solutions, pusher)
    variables: dict[str, Any] = {
        "rod_length": slider.rod_length,
        "rod_angle": float(np.rad2deg(slider.rod_angle)),
        "radius": slider.radius,
        "ring_center": ("xy", slider.rod_length * direction(slider.rod_angle)),
        "pusher_angle": angle,
        "pusher_magnitude": push.pusher_magnitude,
        "pusher_motion": ("xy", pusher),
        "outcome": np.int8(solutions.outcome),
        "status": np.int8(solutions.status),
        **_cones(scene),
        **values,
    }
    coords: dict[str, Any] = {
        "xy": ["x", "y"],
        "effect": list(map(str, _kinds(scene))),
        "twist_component": list(TWIST),
        "twist_unit": ("twist_component", list(TWIST_UNITS)),
    }
    coords |= {name: value for name, value in scene_scalars(scene).items() if name not in variables}
    twists = values["twist"][1]
    if scene.isotropic:
        variables |= ring_friction(scene, twists)
        coords["support_angle"] = RING_ANGLES
    else:
        variables |= _pivots(solutions) | place_friction(scene, twists)
    return describe(
        xr.Dataset(variables, coords=coords),
        title=file.title,
        source="Secs. 3 and 4",
        parameters={
            "scene": _with_centers(file.model_dump(exclude_none=True)),
            "push": push.model_dump(exclude={"file"}, exclude_none=True),
        },
    )


def _with_centers(content: dict[str, Any]) -> dict[str, Any]:
    """A scene file with the center of a mass, by default that of the slider."""
    for effect in content["effects"]:
        if effect["type"] == EffectKind.INERTIA:
            effect.setdefault("center", [0.0, 0.0])
    return content


def scenes(pushes: Mapping[str, PushEntry]) -> dict[str, xr.Dataset]:
    """Build the datasets of scenes by name, one group of scenes.nc each."""
    return {name: scene_dataset(load_scene_file(push.file), push) for name, push in pushes.items()}
