"""How the support of a pushed slider moves over the plane, and the friction that it meets there."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Ring
from planar_pushing.study.datasets.places import places

RING_ANGLES = np.arange(0.0, 360.0, 15.0)
#: A place that is slower than this, in units of the fastest, is where the slider turns about.
STILL = 1e-12


def support_of(scene: Scene) -> Any:
    """The support of a scene with its own sizes; without one the ring of the slider's radius."""
    resting = [
        each.support for each in (*scene.friction, *scene.effects) if hasattr(each, "support")
    ]
    support = resting[0] if resting else Ring()
    return Ring(scene.slider.radius) if support == Ring() else support


def ring_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """Motion of points of the ring and, where it rubs, the friction of the support on them."""
    outward = scene.slider.radius * direction(np.deg2rad(RING_ANGLES))
    motion = _motion(outward, twists)
    dims = ("solution", "support_angle", "xy")
    return {
        "support_motion": (dims, motion),
        "support_force": (dims, -_weight(scene) / (2 * np.pi) * _heading(motion, 0.0)),
    }


def place_friction(scene: Scene, twists: Array) -> dict[str, Any]:
    """The same for any support: places that stand for it, and the friction of what each stands for."""
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
    """Force of friction in a translation."""
    return float(sum(each.weight for each in scene.friction))


def _motion(arm: Array, twists: Array) -> Array:
    """Motion of points at arms from the slider's center."""
    turned = np.stack([-arm[:, 1], arm[:, 0]], axis=-1)
    return np.asarray(twists[:, None, :2] + twists[:, None, 2:] * turned)


def _heading(motion: Array, still: float) -> Array:
    """Directions of motions; zero for those that are slower than the fastest times `still`."""
    speed = np.linalg.norm(motion, axis=-1, keepdims=True)
    moves = speed > still * speed.max(axis=1, keepdims=True, initial=0.0)
    return np.asarray(np.divide(motion, speed, out=np.zeros_like(motion), where=moves))
