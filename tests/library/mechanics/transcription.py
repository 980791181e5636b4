"""The conditions of every contact mode, checked for whole arrays of scenes.

Nothing of the package is used but the fields of its public dataclasses. A solution is judged by backward
error: its own force and twist have to meet the conditions of its mode for some twist within `TOLERANCE` of
its own, relative to |v| + (l + extent) |omega|. Near a foot the direction of friction depends on such
rounding by the ratio of that speed to the foot's, and a foot at rest carries any force up to its share.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from mechanics.friction_transcription import of_area, of_places, point_velocities
from mechanics.problems import cross, problem_of, size_of, turned, unit

import planar_pushing as pp

SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT = (int(mode) for mode in pp.ContactMode)
TOLERANCE = 1e-9
#: A foot slower than this, relative to the slider, is at the center of rotation.
AT_REST = 1e-9
#: Rounding of a twist relative to its speed: it turns the friction of a foot that barely moves.
ROUNDING = 1e-14
#: Motions that differ by less, relative to their speed, are one solution.
SAME = 1e-11


# --- Effects -------------------------------------------------------------------------------------


def gradient(problem, twist):
    """Force that sustains twists, and its torque about the contact, in the body frame; twists likewise.

    Force and torque are of everything but the atoms.
    """
    force, torque = np.zeros((len(twist), 2)), np.zeros(len(twist))
    for area in problem.pressure.areas if problem.pressure else ():
        pull, turn = of_area(twist, area)
        force, torque = force + problem.weight[:, None] * pull, torque + problem.weight * turn
    x, y = problem.mass_center.T
    own = twist[:, :2] + twist[:, 2:] * np.stack([-y, x], axis=-1)
    pull, spin = problem.mass[:, None] * own, problem.mass * problem.gyration**2 * twist[:, 2]
    force, torque = force + pull, torque + cross(problem.mass_center, pull) + spin
    force, torque = force - problem.load[:, :2], torque - problem.load[:, 2]
    return force, torque + problem.length * force[:, 1]


def speed_of(problem, twist):
    """The speed against which twists are judged."""
    return size_of(twist) + (problem.length + problem.extent) * np.abs(twist[:, 2])


def imbalance(problem, twist, force, rounding=ROUNDING):
    """Residual of force and torque over what rounding of the twist explains; right where at most 1.

    Parameters are in the fence's frame. The foot that is nearest to the center of rotation carries what is
    left, up to its share where it is at rest, and otherwise up to the rounding of its direction. Without
    `rounding` even a foot that barely moves has to leave no torque about the contact, as exact forces do.
    """
    body = np.column_stack([turned(twist[:, :2], -problem.psi), twist[:, 2]])
    lacks, torque = gradient(problem, body)
    lacks = lacks - turned(force, -problem.psi)
    speed = speed_of(problem, twist)
    slack = size_of(force) + problem.mass * speed + size_of(problem.load)
    if problem.pressure is not None:
        middle = size_of(point_velocities(body, problem.pressure.center[None])[:, 0])
        turn = problem.pressure.extent * np.abs(twist[:, 2])
        slack = slack + problem.weight * speed / np.maximum(middle + turn, 1e-300)
        lacks, torque, share, turns = _with_atoms(problem, body, speed, lacks, torque)
        slack = slack + share + rounding / TOLERANCE * turns
    allowed = TOLERANCE * slack
    arm = np.maximum(problem.length + problem.extent, 1e-300)
    return np.maximum(size_of(lacks), np.abs(torque) / arm) / np.maximum(allowed, 1e-300)


def _with_atoms(problem, body, speed, lacks, torque):
    """Residuals with the atoms, the nearest one's force chosen.

    Then the slack of the directions of the others, and how far a unit of rounding turns the nearest one's.
    """
    atoms = problem.pressure.atoms
    if not len(atoms):
        return lacks, torque, 0.0, 0.0
    moves = size_of(point_velocities(body, atoms[:, :2]))
    rows, nearest = np.arange(len(body)), np.argmin(moves, axis=1)
    rests = moves[rows, nearest] <= AT_REST * speed
    weights = problem.weight[:, None] * atoms[:, 2]
    active = weights.copy()
    active[rows[rests], nearest[rests]] = 0.0
    pull, own = of_places(body, atoms[:, :2], active)
    lacks, torque = lacks + pull, torque + own + problem.length * pull[:, 1]
    blur = speed[:, None] / np.maximum(moves, 1e-300)
    share = weights[rows, nearest]
    limit = share * np.where(rests, 1.0, np.minimum(TOLERANCE * blur[rows, nearest], 1.0))
    size = size_of(lacks)
    hinge = -lacks * np.minimum(1.0, limit / np.maximum(size, 1e-300))[:, None]
    place = atoms[nearest, :2] + np.stack([problem.length, 0 * problem.length], axis=-1)
    turns = share * np.minimum(blur[rows, nearest], 1.0 / ROUNDING)
    blur[rows, nearest] = 0.0
    share = (weights * blur).sum(axis=1)
    return lacks + hinge, torque + cross(place, hinge), share, turns


# --- Conditions ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Found:
    """Solutions as flat arrays, and to which problem each belongs."""

    place: Any
    mode: Any
    force: Any
    force_end: Any
    motion: Any
    twist: Any
    pivot: Any


def found_of(solutions):
    """Public `Solutions` of one problem or `SolutionArrays` of many."""
    if isinstance(solutions, pp.SolutionArrays):
        width = solutions.mode.shape[-1]
        mode = solutions.mode.reshape(-1, width)
        place, column = np.nonzero(mode >= 0)
        names = ("force", "force_end", "contact_motion", "twist", "pivot")
        tables = [getattr(solutions, name) for name in names]
        rows = [each.reshape(*mode.shape, *each.shape[solutions.mode.ndim :]) for each in tables]
        return Found(place, mode[place, column], *(each[place, column] for each in rows))
    each = list(solutions)
    stacks = [
        np.array([getattr(s, name) for s in each], dtype=float).reshape(len(each), size)
        for name, size in (("force", 2), ("force_end", 2), ("contact_motion", 2), ("twist", 3))
    ]
    mode, pivot = (np.array([getattr(s, n) for s in each], dtype=int) for n in ("mode", "pivot"))
    return Found(np.zeros(len(each), dtype=int), mode, *stacks, pivot)


def faults(scene, angle, magnitude, solutions):
    """What is wrong with the solutions of a scene or of an array of scenes; an empty list if nothing is."""
    problem, found = problem_of(scene, angle, magnitude), found_of(solutions)
    each = problem[found.place]
    with np.errstate(invalid="ignore", over="ignore"):
        wrong = {**of_numbers(each, found), **of_forces(each, found), "twice": twice(each, found)}
    shown = [
        f"{name}: problem {found.place[i]}, {pp.ContactMode(found.mode[i]).name}, "
        f"force {found.force[i]}, twist {found.twist[i]}, pusher {each.pusher[i]}"
        for name, where in wrong.items() for i in np.flatnonzero(where)
    ]  # fmt: skip
    missing = of_existence(problem, found)
    unsolved = np.ravel(solutions.status) == pp.Status.UNSOLVED
    missing["unsolved"] = np.broadcast_to(unsolved, len(problem))
    return shown + [
        f"{name}: problem {i}, pusher {problem.pusher[i]}"
        for name, where in missing.items() for i in np.flatnonzero(where)
    ]  # fmt: skip


def of_numbers(problem, found):
    """Finite numbers, and the conditions on the motion."""
    mode, motion, w = found.mode, found.motion, problem.pusher
    numbers = np.column_stack([found.force, found.force_end, motion, found.twist])
    omega, rod = found.twist[:, 2], problem.length
    c, s = unit(problem.psi)
    own = found.twist[:, :2] + (omega * rod)[:, None] * np.stack([s, -c], axis=-1)
    off = size_of(own - motion)
    slack, gap = TOLERANCE * speed_of(problem, found.twist), motion - w
    slip, rests = mode > STICK, mode == SEPARATE
    return {
        "not finite": ~np.isfinite(numbers).all(axis=-1),
        "contact motion is not that of the twist": off > slack,
        "separate with a force, or in the way of the pusher": rests
        & (found.force.any(axis=-1) | found.force_end.any(axis=-1) | (gap[:, 1] < -slack)),
        "separate that moves without a load": rests
        & ~problem.load.any(axis=-1)
        & (motion.any(axis=-1) | found.twist.any(axis=-1)),
        "separate that does not balance": rests
        & found.twist.any(axis=-1)
        & ~(imbalance(problem, found.twist, found.force) <= 1),
        "stick that does not follow the pusher": (mode == STICK) & (size_of(gap) > slack),
        "slip that leaves the fence": slip & (np.abs(gap[:, 1]) > slack),
        "slip to the wrong side": ((mode == SLIP_RIGHT) & (gap[:, 0] <= 0))
        | ((mode == SLIP_LEFT) & (gap[:, 0] >= 0)),
        "pivot that moves": _pivot_moves(problem, found),
    }


def _pivot_moves(problem, found):
    """Whether the foot that is named as the pivot is not at rest."""
    named = found.pivot >= 0
    if problem.pressure is None or not len(problem.pressure.atoms):
        return named
    body = np.column_stack([turned(found.twist[:, :2], -problem.psi), found.twist[:, 2]])
    moves = size_of(point_velocities(body, problem.pressure.atoms[:, :2]))
    own = moves[np.arange(len(moves)), np.maximum(found.pivot, 0)]
    return named & (own > AT_REST * speed_of(problem, found.twist))


def of_forces(problem, found):
    """Balance with the effects, the cone, and its edges along which slips are."""
    mode, moves, slip = found.mode, found.mode > SEPARATE, found.mode > STICK
    wrong = {"slip under a law that does not slip": slip & ~problem.slips}
    for name, force in (("force", found.force), ("other end's force", found.force_end)):
        size = size_of(force)
        inside = np.minimum(cross(problem.right, force), cross(force, problem.left))
        inside = np.minimum(inside, force[:, 1])
        edge = np.where((mode == SLIP_RIGHT)[:, None], problem.left, problem.right)
        wrong |= {
            f"{name} is zero": moves & (size == 0),
            f"{name} does not balance": moves & ~(imbalance(problem, found.twist, force) <= 1),
            f"{name} is outside of the cone": (mode == STICK)
            & ~problem.rough & ~(inside >= -TOLERANCE * size),
            f"{name} is not on the edge": slip & ~(np.abs(cross(edge, force)) <= TOLERANCE * size),
            f"{name} is against the edge": slip & ~(np.sum(edge * force, axis=-1) > 0),
        }  # fmt: skip
    return wrong


def twice(problem, found):
    """Whether a solution moves as the one before it, or an earlier one of the same problem, does."""
    wrong = np.zeros(len(found.place), dtype=bool)
    arm = (problem.length + problem.extent)[:, None]
    motion = np.column_stack([found.motion, arm * found.twist[:, 2:]])
    speed = speed_of(problem, found.twist)
    for back in range(1, 8):
        alike = found.place[back:] == found.place[:-back]
        near = np.linalg.norm(motion[back:] - motion[:-back], axis=-1) <= SAME * speed[back:]
        wrong[back:] |= alike & near
    return wrong & (found.mode != SEPARATE)


def of_existence(problem, found):
    """Solutions that have to be there.

    *Separation* is consistent wherever the pusher does not move into the slider, w_y <= 0.
    *A rough contact* sticks for every push, once.

    *A closed cone that slips* has a solution for every push. Where w_y <= 0 that is separation. Let
    w_y > 0, and let f(u_x) be the force at the contact motion (u_x, w_y), the gradient of the reduced
    potential: as that is convex, f_x rises with u_x, and the graph of f is connected, steps at kinks
    included. The power f . u is positive. At u_x -> -inf the motion is along -x, so f_x < 0 there, and
    f_x > 0 at +inf: somewhere f_x = 0, and there f_y w_y > 0, so f is along the normal, which every cone
    holds. If f(w) is in the cone, the slider sticks. If it is beyond the right edge with f_x > 0, then
    between w_x and the place where f is along the normal, at u_x < w_x, f turns within f_x >= 0 and is
    never zero, so it passes the edge: a slip to the left. With f_x < 0 a slip to the right mirrors this.

    *A pull that sticks*, w_y < 0 with f(w) inside of the cone, is followed by a slip. As f . w > 0 and
    f_y > 0, f_x w_x > 0: take w_x > 0. At u_x = 0 the power is f_y w_y > 0, so f_y < 0. On the way from w_x
    to 0, while f_y >= 0, f_x u_x >= f . u > 0: f leaves the cone with f_x > 0, through the right edge, at
    u_x < w_x. So there is a slip to the left, slower than the stick.

    *One effect, and a push with w_y > 0*: the angle of the motion rises with that of the force, so there is
    one solution; unless the support is on a line, where one force has an interval of motions.

    *With loads* and inertia, u and w are to be taken relative to the motion a without a pusher, where the
    force is zero: as the potential is convex, f . (u - a) >= 0. So a closed cone has a solution, too.
    """
    count = np.bincount(found.place, minlength=len(problem))
    has = {
        mode: np.bincount(found.place[found.mode == mode], minlength=len(problem))
        for mode in (SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT)
    }
    pulls = found.mode == STICK
    pulls &= (problem.pusher[:, 1] < -1e-6 * size_of(problem.pusher))[found.place]
    place, force = found.place[pulls], found.force[pulls]
    pull = problem[place]
    inside = np.minimum(cross(pull.right, force), cross(force, pull.left)) > 1e-6 * size_of(force)
    followed = np.where(force[:, 0] > 0, has[SLIP_LEFT][place], has[SLIP_RIGHT][place]) > 0
    lonely = np.zeros(len(problem), dtype=bool)
    lonely[place[pull.slips & inside & ~followed]] = True
    loaded, into = problem.load.any(axis=-1), problem.pusher[:, 1] > 0
    simple = ((problem.mass == 0) & ~_on_a_line(problem.pressure)) | (problem.weight == 0)
    at_rest = ~problem.pusher.any(axis=-1)
    return {
        "no separation": ~loaded & ~into & (has[SEPARATE] != 1),
        "no solution": problem.closed & (count == 0),
        "a rough contact that does not stick once": problem.rough & ~at_rest & (has[STICK] != 1),
        "two sticks": has[STICK] > 1,
        "a pull that sticks without a slip": ~loaded & lonely,
        "several solutions of one effect": ~loaded & into & simple & (count > 1),
    }


def _on_a_line(pressure):
    if pressure is None:
        return False
    places = [pressure.atoms[:, :2], *(each.rule[:, :2] for each in pressure.areas)]
    off = np.concatenate(places) - pressure.center
    return bool(np.linalg.svd(off, compute_uv=False)[-1] < 1e-6 * pressure.extent)
