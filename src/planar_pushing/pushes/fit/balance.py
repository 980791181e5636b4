"""Identify a support from forces and motions by nonnegative least squares and cone programming.

At a measured twist, the friction at each place is its weight, directed against its velocity. The load is
therefore linear in the weights, which follow from measured wrenches by nonnegative least squares. A place
that moves less than the uncertainty of its motion carries any force up to its weight. The wrench is then
near a set, and the problem becomes a cone program, which is still convex.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import clarabel
import numpy as np
from scipy import sparse

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.candidates import Family
from planar_pushing.pushes.logs.measured import Index, Measured

#: Relative difference between the mean load of a typical push and the load at its mean twist.
MEAN = 0.01
#: A place that moves less than this many standard deviations of its motion can be at rest; this includes
#: 95 percent of the places at rest.
AT_REST = 2.45
#: Smallest standard deviation of the displacement, in sizes of the outline: rounding error of a simulation.
EXACT = 1e-5
#: Rounds of reweighting the residuals, after which amounts change by less than a tenth of their errors.
ROUNDS = 6
#: Pull toward even amounts, relative to all residuals: it fixes what no push determines.
RIDGE = 0.1
#: Residual of a push, in standard deviations, above which it counts in proportion to its magnitude.
LARGE = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Balance:
    """Least-squares problem for pushes with forces and a family of supports.

    Wrenches (f_x, f_y, tau / length) are about the centroid of the outline.

    Attributes
    ----------
    loads : ndarray, shape (n, 3, c)
        Wrench of each push per unit amount of each column, without places that can be at rest.
    wrenches : ndarray, shape (n, 3)
        Measured wrenches.
    pairs : ndarray of int, shape (m, 2)
        Pushes, and places that can be at rest in them.
    reaches : ndarray, shape (m, 3, 2)
        Wrenches of unit forces along x and y at the place of each pair.
    whitening : ndarray, shape (n, 3, 3)
        Maps residuals to standard deviations.
    columns : ndarray, shape (k, c)
        Weights of the family's places per unit amount.
    even : float
        Amount toward which all columns are pulled.
    pull : float
        Strength of this pull, in standard deviations of all residuals per unit amount.
    """

    loads: Array
    wrenches: Array
    pairs: Index
    reaches: Array
    whitening: Array
    columns: Array
    even: float
    pull: float

    def part(self, rows: Index) -> Balance:
        """The problem for a selection of the pushes, possibly with repetitions."""
        chosen = [np.flatnonzero(self.pairs[:, 0] == row) for row in rows]
        which = np.concatenate([*chosen, np.zeros(0, dtype=int)]).astype(int)
        push = np.repeat(np.arange(len(rows)), [len(rows) for rows in chosen])
        return Balance(
            self.loads[rows], self.wrenches[rows], np.column_stack([push, self.pairs[which, 1]]),
            self.reaches[which], self.whitening[rows], self.columns, self.even, self.pull,
        )  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Balanced:
    """The solution of a `Balance`.

    Attributes
    ----------
    amounts : ndarray, shape (c,)
        Amounts of the columns, >= 0.
    forces : ndarray, shape (m, 2)
        Forces of the places that can be at rest.
    residuals : ndarray, shape (n, 3)
        Weighted residuals.
    optimality : float
        Largest violation of the Karush-Kuhn-Tucker conditions, relative to the data; without a violation
        the amounts are optimal.
    """

    amounts: Array
    forces: Array
    residuals: Array
    optimality: float


def balance(pushes: Measured, family: Family, weights: Array) -> Balance:
    """Problem for pushes with forces, with residuals weighted for a support of these weights."""
    length, center = pushes.length, pushes.center
    places = family.places - center
    # Displacements of the places, and directions of their friction forces.
    x, y = places.T
    c_x, c_y, turn = pushes.centered_twists.T[..., None]
    v_x, v_y = c_x - turn * y, c_y + turn * x
    far = np.hypot(v_x, v_y)
    position, angle, force = pushes.noise
    position = max(position, EXACT * pushes.size)
    known = np.sqrt(position**2 + (angle**2) * (places**2).sum(axis=1))
    rests = far < AT_REST * known
    size = np.where(far > 0.0, far, 1.0)
    u_x, u_y = v_x / size, v_y / size
    unit = np.stack([u_x, u_y, (x * u_y - y * u_x) / length], axis=1)
    loads = np.where(rests[:, None], 0.0, unit) @ family.columns
    pairs = np.argwhere(rests & family.columns.any(axis=1))
    reaches = np.zeros((len(pairs), 3, 2))
    reaches[:, 0, 0] = reaches[:, 1, 1] = 1.0
    reaches[:, 2, 0], reaches[:, 2, 1] = -y[pairs[:, 1]] / length, x[pairs[:, 1]] / length
    # Change of friction with the twist: weight over speed, perpendicular to the velocity.
    across = np.stack([-u_y, u_x, (x * u_x + y * u_y) / length], axis=1)
    stiffness = np.where(rests, 0.0, weights / size)
    change = np.einsum("nak,nk,nbk->nab", across, stiffness, across)
    motion = np.diag([position**2, position**2, (angle * length) ** 2])
    newtons = np.hypot(*pushes.force.T)
    plain = force**2 + (max(pushes.repeatability, MEAN) * newtons) ** 2
    covariance = change @ motion @ change.transpose(0, 2, 1) + plain[:, None, None] * np.eye(3)
    covariance[:, 2, 2] += (position * newtons / length) ** 2
    wrenches = pushes.centered_wrenches / [1.0, 1.0, length]
    even = float(weights.sum()) / family.columns.shape[1]
    return Balance(
        loads, wrenches, pairs, reaches, np.linalg.inv(np.linalg.cholesky(covariance)), family.columns,
        even, ridge(3 * len(pushes), family.columns.shape[1]) / even,
    )  # fmt: skip


def ridge(residuals: int, columns: int) -> float:
    """Strength of the pull toward even amounts, in standard deviations per even amount."""
    return RIDGE * float(np.sqrt(residuals / columns))


def fit_balance(pushes: Measured, family: Family) -> tuple[Balance, Balanced, Array]:
    """Fit the amounts of a family's columns to pushes with forces by weighted least squares.

    Returns the problem, its solution, and the error of each push in standard deviations, shape (n,).
    """
    newtons = float(np.median(np.hypot(*pushes.force.T)))
    count = family.columns.shape[1]
    amounts = np.full(count, newtons / count)
    trust = np.ones(len(pushes))
    for _ in range(ROUNDS):
        problem = balance(pushes, family, family.columns @ amounts)
        problem = replace(problem, whitening=trust[:, None, None] * problem.whitening)
        balanced = solve_balance(problem)
        amounts = balanced.amounts
        error = np.sqrt((balanced.residuals**2).mean(axis=1)) / trust
        trust = np.minimum(1.0, np.sqrt(LARGE / np.maximum(error, LARGE)))
    return problem, balanced, error


def solve_balance(problem: Balance) -> Balanced:
    """Solve the cone program: least squares over amounts >= 0 and forces of places at rest."""
    number, _, count = problem.loads.shape
    pairs = len(problem.pairs)
    matrix = _matrix(problem)
    target = np.einsum("nab,nb->na", problem.whitening, problem.wrenches).ravel()
    rows, variables = 3 * number, count + 2 * pairs
    # The variables are amounts, forces and residuals.
    square = problem.pull**2
    weights = np.concatenate([np.full(count, square), np.zeros(2 * pairs), np.ones(rows)])
    slope = np.concatenate([np.full(count, -square * problem.even), np.zeros(2 * pairs + rows)])
    links = sparse.hstack([matrix, -sparse.eye(rows)])
    positive = sparse.hstack([-sparse.eye(count), sparse.csc_matrix((count, 2 * pairs + rows))])
    cones = _cones(problem, variables + rows)
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = 1e-10
    solver = clarabel.DefaultSolver(
        sparse.diags(weights).tocsc(), slope, sparse.vstack([links, positive, cones]).tocsc(),
        np.concatenate([target, np.zeros(count + 3 * pairs)]),
        [clarabel.ZeroConeT(rows), clarabel.NonnegativeConeT(count)]
        + [clarabel.SecondOrderConeT(3)] * pairs,
        settings,
    )  # fmt: skip
    solution = np.array(solver.solve().x)
    amounts = solution[:count]
    amounts = np.where(amounts > 1e-7 * max(amounts.max(), 0.0), amounts, 0.0)
    forces = solution[count:variables].reshape(-1, 2)
    residuals = (matrix @ np.append(amounts, forces.ravel()) - target).reshape(-1, 3)
    return Balanced(amounts, forces, residuals, _violation(problem, amounts, residuals, target))


def _matrix(problem: Balance) -> Any:
    """Whitened wrenches of amounts and of forces at rest, shape (3 n, c + 2 m)."""
    maps = np.einsum("nab,nbc->nac", problem.whitening, problem.loads)
    push = problem.pairs[:, 0]
    reaches = problem.whitening[push] @ problem.reaches
    rows = 3 * push[:, None, None] + np.arange(3)[:, None]
    columns = 2 * np.arange(len(push))[:, None, None] + np.arange(2)
    rows, columns = np.broadcast_arrays(rows, columns)
    forces = sparse.csc_matrix(
        (reaches.ravel(), (rows.ravel(), columns.ravel())), shape=(3 * len(problem.loads), 2 * len(push))
    )  # fmt: skip
    return sparse.hstack([sparse.csc_matrix(maps.reshape(-1, maps.shape[2])), forces]).tocsc()


def _cones(problem: Balance, variables: int) -> Any:
    """Rows of the cones, in which the weight of a place at rest bounds its force."""
    count, pairs = problem.columns.shape[1], len(problem.pairs)
    weights = problem.columns[problem.pairs[:, 1]]
    which, column = np.nonzero(weights)
    index = np.arange(pairs)
    rows = np.concatenate([3 * which, 3 * index + 1, 3 * index + 2])
    columns = np.concatenate([column, count + 2 * index, count + 2 * index + 1])
    values = -np.concatenate([weights[which, column], np.ones(2 * pairs)])
    return sparse.csc_matrix((values, (rows, columns)), shape=(3 * pairs, variables))


def _violation(problem: Balance, amounts: Array, residuals: Array, target: Array) -> float:
    """Largest violation of the optimality conditions, relative to that without any support.

    The derivative of half the sum of squares with respect to an amount must be nonnegative, and zero if the
    amount is positive. The force of a place at rest has the magnitude of its weight and opposes its own
    gradient.
    """

    def slopes(errors: Array) -> Array:
        whitened = np.einsum("nab,na->nb", problem.whitening, errors)
        push, candidate = problem.pairs.T
        pull = np.einsum("mab,ma->mb", problem.reaches, whitened[push])
        bounded = np.hypot(*pull.T) @ problem.columns[candidate] if len(push) else 0.0
        return np.asarray(np.einsum("nac,na->c", problem.loads, whitened) - bounded)

    gradient = slopes(residuals) + problem.pull**2 * (amounts - problem.even)
    before = slopes(-target.reshape(-1, 3))
    size = float(np.abs(before).max())
    violation = float(-gradient.min() / size)
    complementary = float(np.abs(amounts * gradient).max() / (size * max(amounts.max(), 1e-300)))
    return max(violation, complementary, 0.0)
