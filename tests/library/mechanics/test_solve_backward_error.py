"""Every solution meets the conditions of its mode, as backward error, over the whole domain.

A rounding of the inputs moves a force by up to (l / rho)^2 ulp. Solutions are therefore judged by their own
force and twist against the conditions of their mode, relative to |f| and to |v| + l |omega|.
"""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import BOTH, EVERY_EFFECT, INERTIA, make_scene

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction

#: Numbers of scenes: of every test run, and of the slow tests.
FEW, MANY = 5000, 15_000
TOLERANCE = 1e-12
SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT = pp.ContactMode
LAWS = ("Coulomb", "infinite friction", "definition 2", "perfectly rough")


def law_of(name, mu):
    if name == "Coulomb":
        return pp.Coulomb(mu)
    if name == "perfectly rough":
        return pp.PerfectlyRough()
    return pp.InfiniteFriction("none" if name == "definition 2" else "free")


def random_scenes(random, effects, law, count):
    """Scenes spread over the domain, its corners among them."""
    length = np.where(random.random(count) < 0.05, 0.0, 10 ** random.uniform(-3, 6, count))
    psi = random.uniform(1e-4, np.pi - 1e-4, count)
    psi[random.random(count) < 0.1] = np.pi / 2
    mu = np.where(random.random(count) < 0.1, 0.0, 10 ** random.uniform(-3, 9, count))
    found = [effect for effect in effects if isinstance(effect, pp.RingFriction)]
    if len(found) < len(effects):
        found.append(pp.Inertia(gyration_radius=10 ** random.uniform(-4, 4, count)))
    slider = pp.Slider(rod_length=length, rod_angle=psi)
    return pp.Scene(slider=slider, contact=law_of(law, mu), effects=tuple(found))


def random_pushes(random, scene):
    """Pushes of which half are within an ulp of a motion under an edge of the cone or inside it."""
    law, both = scene.law, len(scene.effects) == 2
    count = len(scene.slider.rod_length)
    inside = random.choice([0.0, 1.0, 0.5, 1e-9, *random.random(3)], count)
    phi = law.right + inside * (law.left - law.right)
    share = random.random(count) if both else None
    angle = pp.motion_angle(scene, phi, share)
    angle[np.abs(angle) < 1e-300] = 0.0
    kind = random.random(count)
    next_to = np.nextafter(angle, random.choice([-9.0, 9.0], count))
    angle = np.where((kind < 0.5) & (angle != 0.0), next_to, angle)
    angle = np.where(kind < 0.3, random.uniform(-np.pi, np.pi, count), angle)
    return angle, 10 ** random.uniform(-12, 12, count) if both else np.ones(count)


def cross(one, other):
    return one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]


def holds(where, condition):
    """Whether a condition holds where it must; the places at which it does not are shown."""
    wrong = where & ~condition
    assert not wrong.any(), np.argwhere(wrong)[:3]


def check(scene, angle, magnitude, found):
    """The conditions of every mode, for arrays of scenes with m = W = R = 1."""
    length = np.broadcast_to(scene.slider.rod_length, angle.shape)[:, None]
    rod = direction(np.broadcast_to(scene.slider.rod_angle, angle.shape))[:, None]
    pusher = (magnitude[:, None] * direction(angle))[:, None]
    with np.errstate(invalid="ignore"):
        check_motion(found, pusher, length, rod)
        check_wrench(scene, found, length, rod)
        if not np.any(scene.law.rough):
            check_force(scene, found, angle.shape)


def check_motion(found, pusher, length, rod):
    mode, twist, motion = found.mode, found.twist, found.contact_motion
    turn = length * twist[..., 2]
    scale = np.linalg.norm(twist[..., :2], axis=-1) + np.abs(turn)
    gap, separate = motion - pusher, mode == SEPARATE
    holds(separate, (pusher[..., 1] <= 0) & ~found.force.any(axis=-1) & ~twist.any(axis=-1))
    holds(mode == STICK, np.linalg.norm(gap, axis=-1) <= TOLERANCE * scale)
    holds(mode > STICK, np.abs(gap[..., 1]) <= TOLERANCE * scale)
    holds(mode == SLIP_RIGHT, gap[..., 0] > 0)
    holds(mode == SLIP_LEFT, gap[..., 0] < 0)
    own = twist[..., :2] + turn[..., None] * np.stack([rod[..., 1], -rod[..., 0]], axis=-1)
    holds(mode > SEPARATE, np.linalg.norm(motion - own, axis=-1) <= TOLERANCE * scale)


def check_wrench(scene, found, length, rod):
    """The effects' wrench is the pusher's."""
    moves, force = found.mode > SEPARATE, found.force
    size = np.linalg.norm(force, axis=-1)
    wrench = sum(pp.wrench(each, np.nan_to_num(found.twist)) for each in unit_effects(scene))
    torque, lever = wrench[..., 2], length * cross(force, rod)
    holds(moves, np.isfinite(found.twist).all(axis=-1) & (size > 0))
    holds(moves, np.linalg.norm(wrench[..., :2] - force, axis=-1) <= TOLERANCE * size)
    holds(moves, np.abs(torque - lever) <= TOLERANCE * (np.abs(torque) + length * size))


def check_force(scene, found, shape):
    """In the law's cone, on its edge while slipping."""
    edges = [direction(np.broadcast_to(edge, shape))[:, None] for edge in scene.law[:2]]
    mode, force, size = found.mode, found.force, np.linalg.norm(found.force, axis=-1)
    right, left = cross(edges[0], force), -cross(edges[1], force)
    holds(mode == STICK, np.minimum(right, left) >= -TOLERANCE * size)
    holds(mode > SEPARATE, force[..., 1] >= -TOLERANCE * size)
    holds(mode == SLIP_LEFT, np.abs(right) <= TOLERANCE * size)
    holds(mode == SLIP_RIGHT, np.abs(left) <= TOLERANCE * size)


def unit_effects(scene):
    """The effects, an array of radii along the first axis of the solutions."""
    for effect in scene.effects:
        if isinstance(effect, pp.Inertia):
            radii = np.atleast_1d(effect.gyration_radius)[:, None]
            yield pp.Inertia(gyration_radius=radii)
        else:
            yield effect


@pytest.mark.parametrize("count", [FEW, pytest.param(MANY, marks=pytest.mark.slow)])
@pytest.mark.parametrize("law", LAWS)
@EVERY_EFFECT
def test_every_solution_meets_the_conditions_of_its_mode(effects, law, count):
    random = np.random.default_rng([len(effects), LAWS.index(law), effects == INERTIA])
    scene = random_scenes(random, effects, law, count)
    angle, magnitude = random_pushes(random, scene)
    found = pp.solve(scene, angle, magnitude)
    check(scene, angle, magnitude, found)
    if law != "perfectly rough":
        return
    assert np.all((found.mode == STICK).sum(axis=-1) == 1)


@EVERY_EFFECT
def test_pushing_into_the_slider_always_moves_it(effects):
    """Under a closed law."""
    random = np.random.default_rng(7)
    scene = random_scenes(random, effects, "Coulomb", MANY)
    angle = random.uniform(1e-6, np.pi - 1e-6, MANY)
    found = pp.solve(scene, angle, 10 ** random.uniform(-12, 12, MANY))
    assert np.all(found.solutions >= 1)
    if effects != BOTH:
        assert np.all(found.solutions == 1)


@pytest.mark.parametrize("turn", [-1, 0, 1])
def test_a_force_stays_in_the_cone_where_rounding_moves_it_by_radians(turn):
    """rho / l = 1e-9: an ulp of the pusher's direction turns the sticking force by 200 rad."""
    scene = make_scene(1e6, 0.5, [pp.Inertia(gyration_radius=1e-3)], psi=1.386)
    pusher = pp.motion_angle(scene, np.array([np.pi / 2]))
    pusher = np.nextafter(pusher, pusher + turn)
    found = pp.solve(scene, pusher)
    check(scene, pusher, np.ones(1), found)
    assert found.solutions[0] >= 1
