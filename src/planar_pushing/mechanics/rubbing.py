"""Motion of the support of a pushed slider over the plane, and the friction on it."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.places import places
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring

RING_ANGLES = np.arange(0.0, 360.0, 15.0)
#: A place slower than this, relative to the fastest place, is at the center of rotation.
STILL = 1e-12


def support_of(scene: Scene) -> Any:
    """Support of a scene with its dimensions; without one, the ring of the slider's radius."""
    resting = [
        each.support for each in (*scene.friction, *scene.effects) if hasattr(each, "support")
    ]
    support = resting[0] if resting else Ring()
    return Ring(scene.slider.radius) if support == Ring() else support


def ring_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """Motion of points of the ring and the friction force on them, which is zero without friction."""
    outward = scene.slider.radius * direction(np.deg2rad(RING_ANGLES))
    motion = _motion(outward, twists)
    dims = ("solution", "support_angle", "xy")
    return {
        "support_motion": (dims, motion),
        "support_force": (dims, -_weight(scene) / (2 * np.pi) * _heading(motion, 0.0)),
    }


def place_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """As `ring_friction`, for any support: sample places and the friction force that each represents."""
    slider = scene.slider
    rows = places(support_of(scene).pieces())
    x, y = direction(slider.rod_angle)
    arm = rows[:, :2] @ np.array([[x, y], [-y, x]])
    motion = _motion(arm, twists)
    dims = ("solution", "place", "xy")
    return {
        "place_position": (("place", "xy"), slider.rod_length * np.array([x, y]) + arm),
        "place_share": ("place", rows[:, 2]),
        "place_motion": (dims, motion),
        "place_force": (dims, -_weight(scene) * rows[:, 2:] * _heading(motion, STILL)),
    }


def _weight(scene: Scene) -> float:
    """Friction force in a translation."""
    return float(sum(each.weight for each in scene.friction))


def _motion(arm: Array, twists: Array) -> Array:
    """Velocities of points at given positions relative to the slider's center."""
    turned = np.stack([-arm[:, 1], arm[:, 0]], axis=-1)
    return np.asarray(twists[:, None, :2] + twists[:, None, 2:] * turned)


def _heading(motion: Array, still: float) -> Array:
    """Unit vectors along motions; zero for motions slower than `still` times the fastest."""
    speed = np.linalg.norm(motion, axis=-1, keepdims=True)
    moves = speed > still * speed.max(axis=1, keepdims=True, initial=0.0)
    return np.asarray(np.divide(motion, speed, out=np.zeros_like(motion), where=moves))
