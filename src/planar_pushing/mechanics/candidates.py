"""Enumeration of the contact modes, elementwise over the pusher's motions (Secs. 2-5)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.mechanics.planar import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slipping import slip_motions

#: Motions closer than this, relative to the pusher's, are one motion: a slip that vanishes is a stick.
COINCIDENCE = 1e-12


Found = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidates:
    """Motions that one contact mode admits, for pusher motions of shape S.

    Attributes
    ----------
    mode : ContactMode
    consistent : ndarray of bool, shape S + (branches,)
    twist : ndarray, shape S + (branches, 3)
        (v_x, v_y, R omega) at the ring centre.
    force : ndarray, shape S + (branches, 2)
        Force of the pusher on the slider.
    """

    mode: ContactMode
    consistent: Found
    twist: Array
    force: Array

    @property
    def spin_ratio(self) -> Array:
        """Spin ratio k = R omega / v with v along the force, shape S + (branches,); 0 at rest."""
        speed = np.hypot(self.twist[..., 0], self.twist[..., 1])
        spin = self.twist[..., 2]
        with np.errstate(divide="ignore", over="ignore"):
            ratio = np.divide(
                spin, speed, out=np.asarray(np.copysign(np.inf, spin)), where=speed > 0
            )
        return np.where(spin == 0, 0.0, ratio)

    @property
    def force_angle(self) -> Array:
        """Force angle phi in (-pi, pi], shape S + (branches,)."""
        angle = np.arctan2(self.force[..., 1], self.force[..., 0])
        return np.where(angle <= -np.pi + RESOLUTION, np.pi, angle)


def contact_motion(scene: Scene, twist: Array) -> Array:
    """Contact motions, shape S + (2,), of twists (v_x, v_y, R omega) of shape S + (3,)."""
    arm = scene.slider.length_ratio * direction(scene.slider.rod_angle)
    turned = twist[..., 2:] * np.array([arm[1], -arm[0]])
    return np.asarray(twist[..., :2] + turned)


def _force(scene: Scene, twist: Array) -> Array:
    """Force that sustains each twist."""
    return np.asarray(
        np.sum([effect.wrench(twist) for effect in scene.scaled_effects], axis=0)[..., :2]
    )


def _separate(pusher: Array) -> Candidates:
    rest = np.zeros((*pusher.shape[:-1], 1, 3))
    return Candidates(
        mode=ContactMode.SEPARATE,
        consistent=pusher[..., 1:] <= 0,
        twist=rest,
        force=rest[..., :2],
    )


def _stick(scene: Scene, pusher: Array) -> Candidates:
    slider, speed = scene.slider, np.hypot(pusher[..., 0], pusher[..., 1])
    lean = slider.rod_angle - np.arctan2(pusher[..., 1], pusher[..., 0])
    moving = np.where(speed > 0, speed, 1.0)
    along_rod = response.sustained_twist(
        scene.scaled_effects, np.asarray(slider.length_ratio), lean, moving
    )
    e = direction(slider.rod_angle)
    axes = np.array([[e[0], e[1], 0.0], [e[1], -e[0], 0.0], [0.0, 0.0, 1.0]])
    twist = (along_rod @ axes)[..., None, :]
    force = _force(scene, twist)
    angle = np.arctan2(force[..., 1], force[..., 0])
    admitted = scene.contact.force_angles.contains(angle) & (speed > 0)[..., None]
    return Candidates(mode=ContactMode.STICK, consistent=admitted, twist=twist, force=force)


def _slip(scene: Scene, pusher: Array, mode: ContactMode) -> tuple[Candidates, Found]:
    """Motions under a force on an edge, and where one of them is the pusher's own: a stick."""
    side = 1 if mode is ContactMode.SLIP_RIGHT else -1
    angles, slider = scene.contact.force_angles, scene.slider
    edge = angles.left if mode is ContactMode.SLIP_RIGHT else angles.right
    speed, ratio, exists = slip_motions(
        scene.scaled_effects, slider.length_ratio, slider.rod_angle, edge, pusher[..., 1]
    )
    heading = np.broadcast_to(direction(edge), (*ratio.shape, 2))
    twist = speed[..., None] * np.concatenate([heading, ratio[..., None]], axis=-1)
    slip = side * (contact_motion(scene, twist)[..., 0] - pusher[..., :1])
    tolerance = COINCIDENCE * np.hypot(pusher[..., :1], pusher[..., 1:])
    found = Candidates(
        mode=mode,
        consistent=exists & (slip > tolerance),
        twist=twist,
        force=np.hypot(*np.moveaxis(_force(scene, twist), -1, 0))[..., None] * heading,
    )
    return found, np.asarray((exists & (np.abs(slip) <= tolerance)).any(axis=-1))


def candidates(scene: Scene, pusher_motion: npt.ArrayLike) -> tuple[Candidates, ...]:
    """Enumerate the contact modes for pusher motions of shape S + (2,), elementwise.

    At an edge of the motion cone stick and slip are one solution. Rounding moves the force and the
    motion of that edge apart by the cone's condition number, so there a stick counts where no slip does,
    and a slip that vanishes counts as the stick.
    """
    pusher = np.asarray(pusher_motion, dtype=float)
    stick = _stick(scene, pusher)
    if not scene.contact.slips:
        return _separate(pusher), stick
    right, left_edge = _slip(scene, pusher, ContactMode.SLIP_RIGHT)
    left, right_edge = _slip(scene, pusher, ContactMode.SLIP_LEFT)
    inside = replace(scene.contact.force_angles, closed=False).contains(stick.force_angle)
    slips = right.consistent.any(axis=-1) | left.consistent.any(axis=-1)
    at_edge = np.asarray(left_edge | right_edge)[..., None]
    moves = np.any(pusher != 0, axis=-1, keepdims=True)
    sticks = inside | (stick.consistent & ~np.asarray(slips)[..., None]) | at_edge
    return _separate(pusher), replace(stick, consistent=sticks & moves), right, left


def outcomes(found: tuple[Candidates, ...]) -> npt.NDArray[np.int8]:
    """Outcome (values of `Outcome`) for each pusher motion, shape S."""
    count = np.sum([each.consistent.sum(axis=-1) for each in found], axis=0)
    return np.asarray(np.minimum(count, Outcome.AMBIGUOUS), dtype=np.int8)
