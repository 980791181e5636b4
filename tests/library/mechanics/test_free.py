"""The motion of a slider that loads move and nothing pushes, against the transcription.

A load at the contact is balanced as a pusher's force there would be.
"""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.checked import TABLE
from mechanics.degenerate import SQUARE, regular
from mechanics.problems import problem_of
from mechanics.transcription import gradient, imbalance

import planar_pushing as pp

COUNT, LENGTH = 200, 0.8
SUPPORTS = {
    "table": TABLE,
    "tripod": pp.Points(regular(3), [1, 1, 1]),
    "feet on a line": pp.Points([(0, 0), (1, 0), (-1, 0)], [2, 1, 1]),
    "ring": pp.Ring(1.0),
    "square": pp.Polygon(SQUARE),
}


def loaded(support, force, masses, psi):
    """A scene with a load at the contact, and the problem without it."""
    slider = pp.Slider(rod_length=LENGTH, rod_angle=psi, radius=1.0)
    effects = pp.SupportFriction(support=support), masses
    load = pp.Load(force=tuple(force.T), center=(-LENGTH, 0.0))
    whole, rest = (
        pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=each)
        for each in ((*effects, load), effects)
    )
    return whole, problem_of(rest, np.full(len(force), -np.pi / 2))


@pytest.mark.parametrize("support", SUPPORTS.values(), ids=SUPPORTS)
def test_free_motion_balances_the_load_or_friction_holds_it(support):
    random = np.random.default_rng(1)
    force = random.choice([-1.0, 0.0, 1.0], (COUNT, 2)) * 2.0 ** random.integers(-2, 3, (COUNT, 1))
    force[::2] = random.normal(size=(COUNT // 2, 2))
    psi = np.where(np.arange(COUNT) % 3, random.uniform(0.1, 3.0, COUNT), np.pi / 2)
    masses = pp.Inertia(mass=10 ** random.uniform(-2, 2, COUNT), gyration_radius=0.7)
    scene, problem = loaded(support, force, masses, psi)
    found = pp.solve(scene, -np.pi / 2, 1e4)
    assert np.all(found.mode[:, 0] == pp.ContactMode.SEPARATE)
    twist = found.twist[:, 0]
    moves = np.any(twist != 0.0, axis=1)
    assert 0.1 < moves.mean() < 1.0
    assert imbalance(problem[moves], twist[moves], force[moves]).max() <= 1.0
    rests = problem[~moves]
    for _ in range(100):
        trial = random.normal(size=(len(rests), 3)) * [1e-9, 1e-9, 1e-9]
        assert np.all(
            power_of(rests, trial) >= 0.99999999 * contact_power(rests, force[~moves], trial)
        )


def power_of(problem, twist):
    """What friction takes, and inertia at twists so slow that it takes nothing beside."""
    force, torque = gradient(problem, twist)
    power = np.sum(force * twist[:, :2], axis=1) + (torque - LENGTH * force[:, 1]) * twist[:, 2]
    atoms = problem.pressure.atoms
    for x, y, share in atoms:
        v = twist[:, :2] + twist[:, 2:] * np.array([-y, x])
        power = power + problem.weight * share * np.hypot(*v.T)
    return power


def contact_power(problem, force, twist):
    """Power of a force at the contact, in the fence's frame, at a twist in the body frame."""
    c, s = np.cos(problem.psi), np.sin(problem.psi)
    u_x, u_y = twist[:, 0], twist[:, 1] - LENGTH * twist[:, 2]
    return force[:, 0] * (c * u_x - s * u_y) + force[:, 1] * (s * u_x + c * u_y)


def at(distance):
    """A load's place beside the foot, at a distance from its line of force."""
    return distance * np.cos(1.0), -distance * np.sin(1.0)


@pytest.mark.parametrize(
    "loads",
    [
        [pp.Load(force=(0.0, 0.4), center=at(2.5))],
        [pp.Load(force=(0.0, 2.0**-40), center=at(2.0**40))],
        [pp.Load(force=(0.0, 1.0), center=at(1.0)), pp.Load(force=(0.0, -1.0))],
    ],
    ids=["force", "nearly a couple", "couple"],
)
def test_a_torque_turns_a_slider_about_its_foot(loads):
    """The heavy foot holds what little the others leave: I omega = torque - 0.5 W."""
    feet = pp.Points([(0, 0), (1, 0), (-1, 0)], [2, 1, 1])
    slider = pp.Slider(rod_length=LENGTH, rod_angle=1.0, radius=1.0)
    effects = pp.SupportFriction(support=feet), pp.Inertia(), *loads
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
    free = pp.solve(scene, -np.pi / 2, 10.0)[0]
    assert free.twist == pytest.approx([0.0, 0.0, 0.5], abs=1e-13)


@pytest.mark.parametrize("width", [0.1, 0.01, 1e-3])
@pytest.mark.parametrize(
    ("force", "lever"), [((0.4, 1.7), 0.1), ((2.0, -0.3), -0.2), ((0.3, 0.2), 6.0)]
)
def test_the_free_motion_of_a_thin_rim_balances_the_load(width, force, lever):
    """Friction by Gauss's rule along the radius and equal angles around the rim, off the motion center."""
    mass, gyration, offset = 0.8, 0.5, 0.3
    effects = (
        pp.SupportFriction(support=pp.Annulus(1.0 - width, 1.0), weight=1.0),
        pp.Inertia(mass=mass, gyration_radius=gyration, center=(0, offset)),
        pp.Load(force=force, center=(lever, 0)),
    )
    scene = pp.scene_at((0, -1), (0, 1), effects=effects, contact=pp.Coulomb(0.5))
    x, y, spin = pp.solve(scene, -np.pi / 2, 100.0)[0].twist
    nodes, weights = np.polynomial.legendre.leggauss(8)
    radius = 1.0 - width / 2 + nodes[:, None] * width / 2
    angle = np.arange(4096) * (2 * np.pi / 4096)
    share = weights[:, None] * radius / np.sum(weights[:, None] * radius * np.ones(4096))
    p_x, p_y = radius * np.cos(angle), radius * np.sin(angle)
    v_x, v_y = x - spin * p_y, y + spin * p_x
    speed = np.hypot(v_x, v_y)
    assert speed.min() > 0.02 * speed.max()
    f_x, f_y = np.sum(share * v_x / speed), np.sum(share * v_y / speed)
    torque = np.sum(share * (p_x * v_y - p_y * v_x) / speed)
    m_x = mass * (x - spin * offset)
    total = (f_x + m_x, f_y + mass * y, torque + mass * gyration**2 * spin - offset * m_x)
    assert total == pytest.approx((*force, lever * force[1]), abs=2e-15 / width + 2e-14)
