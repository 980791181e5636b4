"""Slips counted by brute force: along the fence, how often the force passes an edge of the cone.

The rotation that leaves no torque about the contact is bracketed, since the torque rises with it.
"""

from __future__ import annotations

import numpy as np
from mechanics.friction_transcription import of_places
from mechanics.problems import cross, turned
from mechanics.transcription import gradient
from scipy.optimize.elementwise import find_root

#: Width of the bracket at the end, relative to the rotation.
ROUNDING = {"xatol": 0.0, "xrtol": 1e-15, "fatol": 0.0, "frtol": 0.0}
#: Distances from the pusher's motion over its magnitude, and from the free motion over the normal part
#: between them.
FROM_PUSHER, FROM_REST = np.logspace(-8, 4, 240), np.logspace(-3, 4, 120)


def torque_at(problem, motion, spin):
    """Force and torque about the contact of all effects, in the body frame, by the contact's motion."""
    twist = np.column_stack([motion[:, 0], motion[:, 1] + problem.length * spin, spin])
    force, torque = gradient(problem, twist)
    if problem.pressure is not None and len(problem.pressure.atoms):
        atoms = problem.pressure.atoms
        weights = problem.weight[:, None] * atoms[:, 2]
        pull, own = of_places(twist, atoms[:, :2], weights)
        force, torque = force + pull, torque + own + problem.length * pull[:, 1]
    return force, torque


def _secant(below, above):
    """Part of the way between two torques at which the line between them is zero."""
    apart = np.where(above > below, above - below, 1.0)
    return np.where(above > below, -below / apart, 0.5)


def force_at(problem, motion):
    """Force of the pusher at motions of the contact, in the fence's frame; on a kink, between its sides."""
    body = turned(motion, -problem.psi)
    size = np.hypot(*motion.T) / np.maximum(problem.length + problem.extent, 1e-300) + 1e-300

    def torque(spin, row):
        rows = row.astype(int)
        return torque_at(problem[rows], body[rows], spin)[1]

    rows = np.arange(len(body), dtype=float)
    ends = []
    for sense in (-1.0, 1.0):
        end, short = sense * size, rows
        for _ in range(200):
            near = short.astype(int)
            short = short[sense * torque(end[near], short) < 0]
            if not len(short):
                break
            end[short.astype(int)] *= 4.0
        ends.append(end)
    with np.errstate(invalid="ignore"):  # of a step that it then does not take
        low, high = find_root(torque, ends, args=(rows,), tolerances=ROUNDING).bracket
    (one, below), (other, above) = torque_at(problem, body, low), torque_at(problem, body, high)
    part = _secant(below, above)
    return turned(one + np.clip(part, 0, 1)[:, None] * (other - one), problem.psi)


def places_of(pusher, free, sense):
    """Motions along the fence on one side of the pusher's, outwards, shape (n, places)."""
    size, normal = np.hypot(*pusher.T)[:, None], np.abs(pusher[:, 1:] - free[:, 1:])
    size = np.maximum(size, np.hypot(*free.T)[:, None])
    near = pusher[:, :1] + sense * size * FROM_PUSHER
    rest = free[:, :1] + np.concatenate([normal * FROM_REST, -normal * FROM_REST], axis=1)
    beyond = sense * (rest - pusher[:, :1]) > 1e-8 * size
    rest = np.where(beyond, rest, near[:, :1])
    return sense * np.sort(sense * np.concatenate([near, rest], axis=1), axis=1)


def slips_by_scan(problem, sense, free=None):
    """How many slips there are to the right (sense 1, on the left edge) or to the left (-1).

    `free` is the motion of the contact under the loads alone, by default zero.
    """
    x = places_of(problem.pusher, np.zeros((len(problem), 2)) if free is None else free, sense)
    count = x.shape[1]
    edge = np.repeat(problem.left if sense > 0 else problem.right, count, axis=0)
    motion = np.column_stack([x.ravel(), np.repeat(problem.pusher[:, 1], count)])
    force = force_at(problem[np.repeat(np.arange(len(problem)), count)], motion)
    across = cross(edge, force).reshape(x.shape)
    along = np.sum(edge * force, axis=-1).reshape(x.shape)
    passes = (across[:, 1:] > 0) != (across[:, :-1] > 0)
    part = across[:, :-1] / np.where(passes, across[:, :-1] - across[:, 1:], 1.0)
    noise = 1e-12 * np.hypot(*problem.load[:, :2].T)[:, None]
    passes &= along[:, :-1] + part * (along[:, 1:] - along[:, :-1]) > noise
    return np.where(problem.slips, passes.sum(axis=1), 0)
