"""Contact modes of swept scenes: every solution meets the conditions of its mode, as backward error."""

from __future__ import annotations

from dataclasses import fields, replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.evidence.hard_cases.sweep.adversarial import (
    LAWS,
    QUARTERS,
    Generator,
    mixed,
    powers,
    scenes,
)
from planar_pushing.mechanics.cones import motion_angle
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.solutions import SolutionArrays
from planar_pushing.mechanics.solve import solve
from planar_pushing.mechanics.wrench import wrench
from planar_pushing.terms.domain import SHARES
from planar_pushing.terms.options import EffectSet

Wrong = npt.NDArray[np.bool_]
#: Accuracy of a condition, relative to |f| for forces and to |v| + l |omega| for motions.
CLOSE = 1e-12
#: A slip is as fast as the pusher's normal motion: below this part of it, digits are lost to underflow,
#: and the slips are counted only.
FAINT = 1e-150
#: Which part of the way from the right to the left edge of the friction cone a force is.
PARTS = [0.0, 1e-9, 0.5, 1 - 1e-9, 1.0]
KINDS = list(product(EffectSet, LAWS))


class Pushes(NamedTuple):
    """Scenes, and the angle and magnitude of the pusher's motion in each."""

    scene: Scene
    angle: Array
    magnitude: Array


def _near_the_cone(rng: Generator, scene: Scene, size: int) -> Array:
    """Motion angles of forces in the friction cone: its edges, its middle and others."""
    right, left = scene.law.right, scene.law.left
    part = mixed(rng, PARTS, rng.random(size))
    share = mixed(rng, [0.0, 1.0], rng.random(size)) if len(scene.effects) > 1 else None
    return np.asarray(motion_angle(scene, right + part * (left - right), share))


def pushes(rng: Generator, names: EffectSet, contact: str, size: int) -> Pushes:
    """Many scenes, and for each a push: within a few ulp of a motion angle or of an axis, or anywhere."""
    scene = scenes(rng, names, contact, size)
    near, axis = _near_the_cone(rng, scene, size), rng.choice(QUARTERS, size)
    near += rng.integers(-3, 4, size) * np.spacing(near)
    tiny = rng.choice([-1.0, 1.0], size) * powers(rng, 1e-300, 0.1, size)
    other = [axis, axis + np.spacing(axis), axis + tiny, near + tiny, rng.uniform(-6.3, 6.3, size)]
    angle = np.where(rng.random(size) < 0.4, near, np.choose(rng.integers(5, size=size), other))
    ratio = mixed(rng, [0.0, *SHARES, 1.0], powers(rng, *SHARES, size))
    return Pushes(scene, angle, ratio * scene.weight / scene.inertia[0])


def _cross(one: Array, other: Array) -> Array:
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def _size(vectors: Array) -> Array:
    return np.hypot(vectors[:, 0], vectors[:, 1])


class Found(NamedTuple):
    """Solutions in a row: each with its push, the rod, the edges of its cone, and |v| + l |omega|."""

    push: npt.NDArray[np.intp]
    mode: npt.NDArray[np.int8]
    force: Array
    twist: Array
    motion: Array
    pusher: Array
    rod: Slider
    right: Array
    left: Array
    reach: Array


def gathered(given: Pushes, found: SolutionArrays) -> Found:
    """Solutions of many pushes in a row."""
    at = np.nonzero(found.consistent)
    push, shape = at[0], found.solutions.shape

    def of(values: npt.ArrayLike) -> Array:
        return np.asarray(np.broadcast_to(values, shape)[push])

    slider, law, twist = given.scene.slider, given.scene.law, found.twist[at]
    rod = Slider(
        rod_length=of(slider.rod_length), rod_angle=of(slider.rod_angle), radius=of(slider.radius)
    )
    return Found(
        push, found.mode[at], found.force[at], twist, found.contact_motion[at],
        of(given.magnitude)[:, None] * direction(of(given.angle)), rod,
        direction(of(law.right)), direction(of(law.left)),
        _size(twist) + rod.rod_length * np.abs(twist[:, 2]),
    )  # fmt: skip


def _picked(effect: Any, push: npt.NDArray[np.intp], size: int) -> Effect:
    """The effect of each solution's scene."""
    picked: dict[str, Any] = {}
    for name in (field.name for field in fields(effect)):
        value = getattr(effect, name)
        if name == "center":
            picked[name] = tuple(np.broadcast_to(x, size)[push] for x in value)
        else:
            picked[name] = np.broadcast_to(value, size)[push]
    return replace(effect, **picked)  # type: ignore[no-any-return]


def out_of_balance(given: Pushes, each: Found) -> Wrong:
    """Solutions whose force, torque or contact motion is not that of their twist, or takes power."""
    effects = [_picked(effect, each.push, given.angle.size) for effect in given.scene.effects]
    needed = np.sum([wrench(effect, each.twist, each.rod) for effect in effects], axis=0)
    lever = each.rod.rod_length[:, None] * direction(each.rod.rod_angle)
    force, torque = _size(each.force), _cross(each.force, lever)
    moved = each.twist[:, :2] + each.twist[:, 2:] * lever[:, ::-1] * [1.0, -1.0]
    wrong = ~(_size(needed[:, :2] - each.force) <= CLOSE * force)
    turning = np.abs(needed[:, 2]) + each.rod.rod_length * force
    wrong |= ~(np.abs(needed[:, 2] - torque) <= CLOSE * turning)
    wrong |= ~(_size(moved - each.motion) <= CLOSE * each.reach)
    power = (each.force * each.motion).sum(axis=1)
    return np.asarray(wrong | ~(power >= -CLOSE * force * each.reach))


def against_its_mode(given: Pushes, each: Found) -> Wrong:
    """Solutions whose motion, or force in the contact law, is not what their mode says."""
    gap, limit = each.motion - each.pusher, CLOSE * _size(each.force)
    from_right, from_left = _cross(each.right, each.force), _cross(each.force, each.left)
    inside = (np.minimum(from_right, from_left) >= -limit) & (each.force[:, 1] >= -limit)
    keeps = np.abs(gap[:, 1]) <= CLOSE * each.reach
    right = {
        ContactMode.SEPARATE: (each.pusher[:, 1] <= 0) & (each.reach == 0) & (limit == 0),
        ContactMode.STICK: (_size(gap) <= CLOSE * each.reach) & (inside | given.scene.law.rough),
        ContactMode.SLIP_RIGHT: keeps & (gap[:, 0] > 0) & inside & (from_left <= limit),
        ContactMode.SLIP_LEFT: keeps & (gap[:, 0] < 0) & inside & (from_right <= limit),
    }
    return np.asarray(~np.choose(each.mode, [right[mode] for mode in ContactMode]))


def broken(given: Pushes, each: Found) -> Wrong:
    """Solutions that break a condition, of those whose digits have not underflowed."""
    rise = np.abs(direction(given.angle)[each.push, 1])
    faint = (each.mode > ContactMode.STICK) & (rise > 0) & (rise < FAINT)
    return np.asarray((out_of_balance(given, each) | against_its_mode(given, each)) & ~faint)


def miscounted(given: Pushes, found: SolutionArrays) -> Wrong:
    """Pushes with too few or too many solutions."""
    pushing = (direction(given.angle)[:, 1] > 0) & (given.magnitude > 0)
    wrong = (found.mode == ContactMode.SEPARATE).any(axis=-1) == pushing
    if given.scene.contact.force_angles.closed:
        wrong |= found.solutions < 1
    if len(given.scene.effects) == 1:
        wrong |= pushing & (found.solutions > 1)
    return np.asarray(wrong)


def wrong(given: Pushes, found: SolutionArrays) -> Wrong:
    """Pushes of which a solution breaks a condition, or of which the number of solutions is wrong."""
    told, each = miscounted(given, found), gathered(given, found)
    told[each.push[broken(given, each)]] = True
    return told


def checked(rng: Generator, kind: int, size: int) -> Wrong:
    """Solve and check many pushes of one set of effects and one law."""
    given = pushes(rng, *KINDS[kind % len(KINDS)], size)
    return wrong(given, solve(*given))
