"""Conditions of every solution of many pushes, as backward error, and the number of solutions."""

from dataclasses import fields, replace
from typing import Any, NamedTuple

import numpy as np
from evidence.hard_cases.adversarial import QUARTERS, mixed, powers, scenes

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction
from planar_pushing.terms.domain import SHARES

SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT = pp.ContactMode
#: Accuracy of a condition, relative to |f| for forces and to |v| + l |omega| for motions.
CLOSE = 1e-12
#: A slip is as fast as the pusher's normal motion: below this part of it, digits are lost to underflow,
#: and the slips are counted only.
FAINT = 1e-150
#: Places of a force on the way from the right to the left edge of the friction cone.
PARTS = [0.0, 1e-9, 0.5, 1 - 1e-9, 1.0]


class Pushes(NamedTuple):
    """Scenes, and the angle and magnitude of the pusher's motion in each."""

    scene: Any
    angle: Any
    magnitude: Any


def pushes(rng, effects, law, size):
    """Many scenes, and for each a push: within a few ulp of a motion angle or of an axis, or anywhere."""
    scene = scenes(rng, effects, law, size)
    right, left = scene.law.right, scene.law.left
    force = right + mixed(rng, PARTS, rng.random(size)) * (left - right)
    share = mixed(rng, [0.0, 1.0], rng.random(size)) if len(scene.effects) > 1 else None
    near, axis = pp.motion_angle(scene, force, share), rng.choice(QUARTERS, size)
    near += rng.integers(-3, 4, size) * np.spacing(near)
    tiny = rng.choice([-1.0, 1.0], size) * powers(rng, 1e-300, 0.1, size)
    other = [axis, axis + np.spacing(axis), axis + tiny, near + tiny, rng.uniform(-6.3, 6.3, size)]
    angle = np.where(rng.random(size) < 0.4, near, np.choose(rng.integers(5, size=size), other))
    ratio = mixed(rng, [0.0, *SHARES, 1.0], powers(rng, *SHARES, size))
    return Pushes(scene, angle, ratio * scene.weight / scene.inertia[0])


def cross(one, other):
    return one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]


def norm(vectors):
    return np.hypot(vectors[:, 0], vectors[:, 1])


class Found(NamedTuple):
    """Solutions in a row: each with its push, its slider, the edges of its cone, and |v| + l |omega|."""

    push: Any
    mode: Any
    force: Any
    twist: Any
    motion: Any
    pusher: Any
    slider: Any
    right: Any
    left: Any
    reach: Any


def gathered(given, found):
    """Solutions of many pushes in a row."""
    at = np.nonzero(found.consistent)
    push, slider, law, twist = at[0], given.scene.slider, given.scene.law, found.twist[at]

    def of(values):
        return np.broadcast_to(values, found.solutions.shape)[push]

    own = pp.Slider(
        rod_length=of(slider.rod_length), rod_angle=of(slider.rod_angle), radius=of(slider.radius)
    )
    return Found(
        push, found.mode[at], found.force[at], twist, found.contact_motion[at],
        of(given.magnitude)[:, None] * direction(of(given.angle)), own,
        direction(of(law.right)), direction(of(law.left)),
        norm(twist) + own.rod_length * np.abs(twist[:, 2]),
    )  # fmt: skip


def picked(effect, push, size):
    """The effect of each solution's scene."""

    def of(value):
        return (
            tuple(map(of, value))
            if isinstance(value, tuple)
            else np.broadcast_to(value, size)[push]
        )

    return replace(effect, **{each.name: of(getattr(effect, each.name)) for each in fields(effect)})


def out_of_balance(given, each):
    """Solutions whose force, torque or contact motion is not that of their twist, or takes power."""
    effects = [picked(effect, each.push, given.angle.size) for effect in given.scene.effects]
    needed = sum(pp.wrench(effect, each.twist, each.slider) for effect in effects)
    lever = each.slider.rod_length[:, None] * direction(each.slider.rod_angle)
    force, torque = norm(each.force), cross(each.force, lever)
    moved = each.twist[:, :2] + each.twist[:, 2:] * lever[:, ::-1] * [1.0, -1.0]
    turning = np.abs(needed[:, 2]) + each.slider.rod_length * force
    right = norm(needed[:, :2] - each.force) <= CLOSE * force
    right &= np.abs(needed[:, 2] - torque) <= CLOSE * turning
    right &= norm(moved - each.motion) <= CLOSE * each.reach
    return ~(right & ((each.force * each.motion).sum(axis=1) >= -CLOSE * force * each.reach))


def against_its_mode(given, each):
    """Solutions whose motion, or force in the contact law, is not what their mode says."""
    gap, limit = each.motion - each.pusher, CLOSE * norm(each.force)
    from_right, from_left = cross(each.right, each.force), cross(each.force, each.left)
    inside = (np.minimum(from_right, from_left) >= -limit) & (each.force[:, 1] >= -limit)
    keeps = np.abs(gap[:, 1]) <= CLOSE * each.reach
    right = {
        SEPARATE: (each.pusher[:, 1] <= 0) & (each.reach == 0) & (limit == 0),
        STICK: (norm(gap) <= CLOSE * each.reach) & (inside | given.scene.law.rough),
        SLIP_RIGHT: keeps & (gap[:, 0] > 0) & inside & (from_left <= limit),
        SLIP_LEFT: keeps & (gap[:, 0] < 0) & inside & (from_right <= limit),
    }
    return ~np.choose(each.mode, [right[mode] for mode in pp.ContactMode])


def broken(given, each):
    """Solutions that break a condition, of those whose digits have not underflowed."""
    rise = np.abs(direction(given.angle)[each.push, 1])
    faint = (each.mode > STICK) & (rise > 0) & (rise < FAINT)
    return (out_of_balance(given, each) | against_its_mode(given, each)) & ~faint


def miscounted(given, found):
    """Pushes with too few or too many solutions."""
    pushing = (direction(given.angle)[:, 1] > 0) & (given.magnitude > 0)
    wrong = (found.mode == SEPARATE).any(axis=-1) == pushing
    if given.scene.contact.force_angles.closed:
        wrong |= found.solutions < 1
    if len(given.scene.effects) == 1:
        wrong |= pushing & (found.solutions > 1)
    return wrong


def wrong(given, found):
    """Pushes of which a solution breaks a condition, or of which the number of solutions is wrong."""
    told, each = miscounted(given, found), gathered(given, found)
    told[each.push[broken(given, each)]] = True
    return told
