"""Random and degenerate scenes with several contacts, solved by the package and by complementarity."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from objects.several.complementarity import Problem, roots

import planar_pushing as pp

LETTERS = "SKRL"
#: Feet of degenerate scenes, and the sides of a square of side 2 with the coordinate that is left open.
FEET = {
    "corners": [(1, 1), (-1, 1), (-1, -1), (1, -1)],
    "with middle": [(1, 1), (-1, 1), (-1, -1), (1, -1), (0, 0)],
    "three": [(-1, -1), (1, -1), (0, 1)],
    "line": [(0, -0.5), (0, 0), (0, 0.5)],
}
SIDES = [((-1, None), (1, 0)), ((1, None), (-1, 0)), ((None, -1), (0, 1)), ((None, 1), (0, -1))]
#: Friction that stands for infinite friction, with the error it causes, and smoothings of feet with theirs.
LARGE, BLUNT, SMOOTH = 2e3, 6e-3, ((1e-7, 2e-4), (1e-5, 5e-3), (1e-3, 3e-2))


class Contacts(NamedTuple):
    """A scene: its effects and contacts, and the same for complementarity."""

    effects: list
    contacts: list
    problem: Problem

    def solve(self):
        return pp.solve_contacts(self.contacts, effects=self.effects)


def scene_of(feet, shares, contacts, mass=0.0):
    """A scene on feet with contacts (point, normal, velocity, friction) and a mass aside."""
    feet, shares = np.asarray(feet, float), np.asarray(shares, float)
    points, normals, velocities, friction = (
        np.array([contact[k] for contact in contacts], float) for k in range(4)
    )
    (c_x, c_y), gyration = (0.1, -0.05), float(np.sqrt(feet.var(axis=0).sum()))
    effects = [pp.SupportFriction(support=pp.Points(feet.tolist(), shares.tolist()))]
    if mass:
        effects.append(pp.Inertia(mass=mass, gyration_radius=gyration, center=(c_x, c_y)))
    square = gyration**2 + c_x**2 + c_y**2
    inertia = mass * np.array([[1.0, 0.0, -c_y], [0.0, 1.0, c_x], [-c_y, c_x, square]])
    laws = [pp.InfiniteFriction() if np.isinf(mu) else pp.Coulomb(mu) for mu in friction]
    made = [
        pp.Contact(point, normal, law=law, velocity=velocity)
        for point, normal, velocity, law in zip(points, normals, velocities, laws, strict=True)
    ]
    normals = normals / np.hypot(*normals.T)[:, None]
    friction = np.minimum(friction, LARGE)
    shares = shares / shares.sum()
    return Contacts(
        effects, made, Problem(feet, shares, inertia, points, normals, velocities, friction)
    )


def random_scene(seed, count=2):
    """Fingers and walls at a random convex polygon on three to six feet; a quarter have inertia."""
    rng = np.random.default_rng(seed)
    feet = rng.uniform(-0.5, 0.5, (rng.integers(3, 7), 2))
    shares = rng.dirichlet(np.full(len(feet), 3.0))
    corners = rng.integers(3, 7)
    turn = np.sort(rng.uniform(0.0, 2.0 * np.pi, corners))
    while np.diff(np.r_[turn, turn[0] + 2.0 * np.pi]).max() > 2.8:
        turn = np.sort(rng.uniform(0.0, 2.0 * np.pi, corners))
    outline = np.column_stack([np.cos(turn), np.sin(turn)]) * (1.2, rng.uniform(0.4, 1.3))
    kind, contacts = rng.integers(0, 3), []
    for i in range(count):
        side = rng.integers(0, corners)
        along = outline[(side + 1) % corners] - outline[side]
        point = outline[side] + rng.uniform(0.05, 0.95) * along
        normal = np.array([-along[1], along[0]]) / np.hypot(*along)
        angle = rng.uniform(0.0, 2.0 * np.pi)
        velocity = np.array([np.cos(angle), np.sin(angle)]) * rng.uniform(0.2, 1.5)
        if velocity @ normal < 0.0 and rng.random() < 0.6:
            velocity = -velocity
        if i and kind < 2:
            velocity = contacts[0][2] if kind else np.zeros(2)
        contacts.append((point, normal, velocity, rng.choice([0.0, 0.1, 0.3, 0.6, 1.0, 2.0])))
    mass = float(rng.uniform(0.2, 3.0)) if rng.random() < 0.25 else 0.0
    return scene_of(feet, shares, contacts, mass)


def degenerate_scene(seed):
    """Two contacts at round places of a square on symmetric feet, moved at right angles."""
    rng = np.random.default_rng(seed)
    while True:
        feet = FEET[list(FEET)[rng.integers(0, len(FEET))]]
        together, kind, contacts = rng.random() < 0.25, rng.random(), []
        first = SIDES[0]
        for i in range(2):
            place, normal = SIDES[rng.integers(0, 4)]
            if i and together:
                place, normal = first
            first = place, normal
            x, y = (rng.choice([-1.0, -0.5, 0.0, 0.0, 0.5, 1.0]) if z is None else z for z in place)
            angle = np.deg2rad(rng.choice([-90, 0, 45, 90, 90, 135, 180]))
            n_x, n_y = normal
            velocity = np.array([
                n_y * np.cos(angle) + n_x * np.sin(angle), n_y * np.sin(angle) - n_x * np.cos(angle),
            ])  # fmt: skip
            velocity = np.round(velocity / np.abs(velocity).max(), 12)
            if i and kind < 0.8:
                velocity = contacts[0][2] if kind >= 0.5 else np.zeros(2)
            contacts.append(((x, y), normal, velocity, rng.choice([0.0, 0.5, 1.0, np.inf])))
        if contacts[0][:2] != contacts[1][:2]:
            return scene_of(feet, np.ones(len(feet)), contacts)


def modes_of(solution):
    """The modes of a solution, one letter for each contact."""
    return "".join(LETTERS[mode] for mode in solution.modes)


def compare(scene, seed, starts):
    """Solutions that complementarity does not meet, and its roots that are no solution.

    A root between both ends of a continuum, or between its one end and rest, is of the continuum.
    """
    answer, bluntest = scene.solve(), 0.0
    if (scene.problem.friction == LARGE).any():
        bluntest = BLUNT
    twists = [solution.twist for solution in answer]
    unmet, extra = list(range(len(twists))), []
    for k, (smooth, error) in enumerate(SMOOTH):
        error = max(error, bluntest)
        if k and not unmet:
            break
        near = [twists[j] for j in unmet]
        met = roots(scene.problem, starts=starts, smooth=smooth, seed=seed + k, near=near)
        unmet = [j for j in unmet if not any(is_same(z[:3], twists[j], error) for z in met)]
        if k == 0:
            extra = [z[:3] for z in met if not any(is_same(z[:3], t, error) for t in twists)]
    unmet = [j for j in unmet if not needs_infinite_friction(scene, answer[j])]
    ends = [solution.twist for solution in answer if solution.continuum]
    ends = [*ends, np.zeros(3)] if len(ends) == 1 else ends
    extra = [z for z in extra if not is_between(z, ends)]
    return answer, [(modes_of(answer[j]), twists[j].tolist()) for j in unmet], extra


def needs_infinite_friction(scene, solution):
    """Whether a force is along the tangent of its contact, as no finite friction permits."""
    across = (scene.problem.normals * solution.forces).sum(axis=1)
    sizes = np.hypot(*solution.forces.T)
    return bool(
        np.any((scene.problem.friction == LARGE) & (sizes > 0.0) & (across <= 1e-9 * sizes))
    )


def is_same(one, other, error):
    """Whether two twists are the same within an error."""
    return np.abs(one - other).max() <= error * (1.0 + np.abs(other).max())


def is_between(twist, ends, error=2e-3):
    """Whether a twist is on the line between the ends of a continuum."""
    if len(ends) != 2:
        return False
    start, step = ends[0], ends[1] - ends[0]
    part = (twist - start) @ step / (step @ step)
    near = np.abs(start + part * step - twist).max() <= error * (1.0 + np.abs(twist).max())
    return bool(-error <= part <= 1.0 + error and near)
