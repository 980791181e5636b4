"""Contacts that stick while an object turns about a foot: their inner force, by linear programs."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
PLACES = np.array([(-1, 0.25), (1, 0.3), (0.5, -1), (0.4, 1), (-1, -0.5), (1, 0.5), (0, -1)])
NORMALS = np.array([(1, 0), (-1, 0), (0, 1), (0, -1), (1, 0), (-1, 0), (0, 1)])
#: Sides of the polygon around the disc of a foot's forces.
SIDES = 720


def turned(vectors):
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def torque(points, forces):
    return points[..., 0] * forces[..., 1] - points[..., 1] * forces[..., 0]


def inner_range(feet, weights, spin, places, normals, frictions):
    """Ends of the inner force of contacts that all stick, with any force at the first foot."""
    speeds = spin * turned(feet[1:] - feet[0])
    forces = -weights[1:, None] * speeds / np.hypot(*speeds.T)[:, None]
    given = np.append(forces.sum(axis=0), torque(feet[1:], forces).sum())
    edges = (
        normals[:, None]
        + frictions[:, None, None] * np.array([-1, 1])[:, None] * turned(normals)[:, None]
    )
    edges, points = edges.reshape(-1, 2), np.repeat(places, 2, axis=0)
    units = np.concatenate([np.column_stack([edges, torque(points, edges)]).T,
                            np.array([[1, 0], [0, 1], [-feet[0, 1], feet[0, 0]]])], axis=1)  # fmt: skip
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    disc = np.zeros((SIDES, units.shape[1]))
    disc[:, -2], disc[:, -1] = np.cos(angles), np.sin(angles)
    line = (places[-1] - places[0]) / np.hypot(*(places[-1] - places[0]))
    goal = np.zeros(units.shape[1])
    goal[:2], goal[-4:-2] = edges[:2] @ line / 2, -edges[-2:] @ line / 2
    bounds = [(0, None)] * (units.shape[1] - 2) + [(None, None)] * 2
    ends = []
    for sign in (1, -1):
        found = linprog(sign * goal, disc, np.full(SIDES, weights[0]), units, -given, bounds)
        if found.status == 2:
            return None
        ends.append(-sign * np.inf if found.status == 3 else sign * found.fun)
    return ends


def test_the_inner_force_of_contacts_that_stick_about_a_foot():
    compared, bounded = 0, 0
    for seed in range(120):
        rng = np.random.default_rng(seed)
        number = rng.integers(2, 5)
        feet = rng.permutation([(-0.5, -0.5), (0.5, 0.25), (0, 0.5), (0.25, -0.25), (-0.5, 0.5)])[
            :number
        ]
        weights, spin = rng.uniform(0.05, 1.0, size=number), rng.choice([1.0, -1.0])
        chosen = rng.choice(len(PLACES), size=rng.integers(2, 5), replace=False)
        frictions = rng.choice([0.3, 1.0], size=len(chosen))
        places, normals = PLACES[chosen], NORMALS[chosen]
        velocities = spin * turned(places - feet[0])
        contacts = [
            pp.Contact(tuple(place), law=pp.Coulomb(mu), velocity=tuple(velocity))
            for place, mu, velocity in zip(places, frictions, velocities, strict=True)
        ]
        support = pp.Points(feet, weights)
        effects = [pp.SupportFriction(support=support, weight=float(weights.sum()))]
        solutions = pp.solve_contacts(contacts, effects=effects, outline=SQUARE)
        stuck = [one for one in solutions if set(one.modes) == {pp.ContactMode.STICK}]
        wanted = inner_range(feet, weights, spin, places, normals, frictions)
        if wanted is None:
            assert not stuck
            continue
        (one,) = stuck
        assert one.inner_force == pytest.approx(wanted, rel=1e-4, abs=1e-4)
        compared, bounded = compared + 1, bounded + np.isfinite(wanted).all()
    assert compared > 20
    assert bounded > 5
