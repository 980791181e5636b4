"""An object whose limit surface is a convex quartic, the model of Zhou et al. (ICRA 2016), and its fit.

The limit surface is ``H(w) = 1`` with a form H of degree 4, and the object moves along the gradient of H.
With a symmetric tensor A, ``H = A(w, w, w, w)``, the gradient is ``4 A(w, w, w, .)``, and the Hessian is
``12 A(w, w, ., .)``. H is convex if ``A(w, w, z, z)`` is a sum of squares: if A as a matrix of pairs of
indices is positive semidefinite after one adds a matrix that does not change this polynomial. Every convex
H in three variables is of this kind (Ahmadi, Blekherman, and Parrilo 2024, arXiv:2404.14440).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations_with_replacement, permutations, product
from typing import NamedTuple

import clarabel
import numpy as np
from scipy import sparse

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.ellipsoid import torque_about
from planar_pushing.pushes.fit.fitted import unit
from planar_pushing.pushes.fit.friction import contact_friction
from planar_pushing.pushes.fit.limit_surface import LimitSurface
from planar_pushing.pushes.fit.scores import angles
from planar_pushing.pushes.logs.measured import Mask, Measured

#: Fewest pushes with forces: each gives three equations, for fifteen coefficients.
FEWEST = 5
#: Weights in cross-validation: of H = 1 and of small coefficients, relative to the directions of motion.
FORCE, PULL = (0.02, 0.1, 0.5, 2.5), (1e-5, 1e-4, 1e-3, 1e-2)
#: Parts of the pushes in cross-validation.
FOLDS = 4
#: H less this multiple of the fourth power of the magnitude is convex, too, so that the inverse is unique.
MARGIN = 1e-3
#: Smallest length that divides torques, relative to that of the object, if no push has a torque.
SMALL = 1e-3
#: Most steps of Newton's method, and the relative error of the power before the last one.
ROUNDS, PRECISION = 100, 1e-14
#: A step is halved if the function has a slope behind it of more than this part of the first slope.
PASSED = 0.1


def _symmetric(indices: tuple[int, ...]) -> Array:
    """Symmetric tensor of the monomial of these variables."""
    orders = set(permutations(indices))
    tensor = np.zeros((3, 3, 3, 3))
    for order in orders:
        tensor[order] = 1.0 / len(orders)
    return tensor


def _triangles(tensors: Array) -> Array:
    """Tensors as matrices of pairs of indices, in the solver's order of their triangles, shape (n, 45)."""
    column, row = np.tril_indices(9)
    entries = tensors.reshape(-1, 9, 9)[:, row, column]
    return np.asarray(entries * np.where(row == column, 1.0, np.sqrt(2.0)))


#: Symmetric tensors of the monomials of degree 4, shape (15, 3, 3, 3, 3).
MONOMIALS = np.array([_symmetric(k) for k in combinations_with_replacement(range(3), 4)])
#: Symmetric tensor of the fourth power of the magnitude.
PAIRS = np.einsum("ij,kl->ijkl", np.eye(3), np.eye(3))
ROUND = (PAIRS + PAIRS.transpose(0, 2, 1, 3) + PAIRS.transpose(0, 2, 3, 1)) / 3.0
#: Matrices of the products of components of w x w and z x z, which vanish, shape (9, 3, 3, 3, 3).
CROSS = np.cross(np.eye(3)[:, None], np.eye(3)).transpose(2, 0, 1)
VANISHING = np.einsum("pik,qjl->pqijkl", CROSS, CROSS).reshape(9, 3, 3, 3, 3)
#: Columns of the semidefinite constraint: coefficients of H, and of the matrices that vanish.
COLUMNS = _triangles(np.concatenate([MONOMIALS, VANISHING])).T


@dataclass(frozen=True, slots=True, eq=False)
class Quartic(LimitSurface):
    """An object whose limit surface is a quartic; `tensor` is A, shape (3, 3, 3, 3)."""

    tensor: Array

    @classmethod
    def about(cls, center: Array, length: float, tensor: Array) -> Quartic:
        """Quartic from a tensor for torques about a center, divided by a length."""
        moved = torque_about(center) / np.array([[1.0], [1.0], [length]])
        return cls(np.einsum("abcd,ai,bj,ck,dl->ijkl", tensor, moved, moved, moved, moved))

    def motions(self, wrenches: Array) -> Array:
        return self._derivatives(wrenches)[1]

    def _derivatives(self, wrenches: Array) -> tuple[Array, Array, Array]:
        """The function ``sqrt(H) / 2``, its gradient and its Hessian."""
        pairs = (wrenches[:, :, None] * wrenches[:, None]).reshape(-1, 9)
        square = (pairs @ self.tensor.reshape(9, 9)).reshape(-1, 3, 3)
        cube = (square @ wrenches[..., None])[..., 0]
        root = np.sqrt(np.maximum((cube * wrenches).sum(axis=1), 0.0))
        size = np.where(root > 0.0, root, 1.0)[:, None]
        motion = cube / size
        bend = 3.0 * square - 2.0 * motion[:, :, None] * motion[:, None]
        return root / 2.0, motion, bend / size[..., None]

    def forces(self, reach: Array, velocities: Array) -> Array:
        forces, moving = np.zeros(velocities.shape), velocities.any(axis=1)
        if moving.any():
            forces[moving] = self._forces(reach[moving], velocities[moving])
        return forces

    def _forces(self, reach: Array, velocities: Array) -> Array:
        """Minima of ``sqrt(H) / 2 - f . v``, which is convex in f, by Newton's method."""
        across = reach.transpose(0, 2, 1)

        def derivatives(force: Array) -> tuple[Array, Array, Array]:
            value, motion, bend = self._derivatives((force[:, None] @ reach)[:, 0])
            return value, velocities - (reach @ motion[..., None])[..., 0], reach @ bend @ across

        mobility = reach @ np.einsum("iikl->kl", self.tensor) @ across
        ray = np.linalg.solve(mobility, velocities[..., None])[..., 0]
        # Along a ray the function is quadratic, with its minimum at this multiple.
        force = ray * ((ray * velocities).sum(axis=1) / (2.0 * derivatives(ray)[0]))[:, None]
        step, gain, size = np.zeros(force.shape), np.zeros(len(force)), np.ones(len(force))
        near = np.zeros(len(force), dtype=bool)
        for _ in range(ROUNDS):
            trial = force + size[:, None] * step
            value, rest, bend = derivatives(trial)
            # A step that is too long passes the minimum along it.
            fits = (step * rest).sum(axis=1) >= -PASSED * gain
            force = np.where(fits[:, None], trial, force)
            following = np.linalg.solve(bend, rest[..., None])[..., 0]
            step = np.where(fits[:, None], following, step)
            gain = np.where(fits, (following * rest).sum(axis=1), gain)
            size = np.where(fits, 1.0, size / 2.0)
            near |= fits & (gain <= PRECISION * value)
            if near.all():
                break
        return np.asarray(force + size[:, None] * step)


def fitted_quartic(pushes: Measured) -> tuple[Quartic, float] | None:
    """Convex quartic that fits pushes with forces best, and the contact friction; None if they are too few.

    Least squares over the fifteen coefficients of H: its gradient at each measured wrench is along the
    measured twist, H is 1 there, and the coefficients are small. The weights of these aims are those with
    the smallest mean error of motions and wrenches in cross-validation within these pushes.
    """
    part = pushes.part(pushes.has_directions)
    if len(part) < FEWEST:
        return None
    wrenches, twists = part.centered_wrenches, part.centered_twists
    force, torque = (np.sqrt((wrenches[:, k] ** 2).mean()) for k in ([0, 1], 2))
    # With this length, the coefficients of H are of about the same size.
    length = max(torque / force, SMALL * pushes.length)
    scale = np.array([1.0, 1.0, length])
    tensor = quartic_tensor(wrenches / scale, twists * scale)
    return Quartic.about(pushes.center, length, tensor), contact_friction(pushes).coefficient


def quartic_tensor(wrenches: Array, twists: Array) -> Array:
    """Tensor of the convex quartic that fits wrenches and twists, shape (n, 3) each, best.

    Equal pushes, as in a resample, are in the same part in cross-validation, if there are enough others.
    """
    equations = Equations.of(wrenches, twists)
    _, first = np.unique(np.column_stack([wrenches, twists]), axis=0, return_index=True)
    first, same = np.sort(first), (wrenches[:, None] == wrenches) & (twists[:, None] == twists)
    fold = np.searchsorted(first, same.all(axis=2).argmax(axis=1)) % FOLDS
    if len(first) < FOLDS:
        fold = np.arange(len(wrenches)) % FOLDS

    def error(weights: tuple[float, float]) -> float:
        parts = [
            equations.part(fold == k).errors(equations.part(fold != k).tensor(*weights))
            for k in range(FOLDS)
        ]
        return float(np.concatenate(parts).mean())

    return equations.tensor(*min(product(FORCE, PULL), key=error))


class Equations(NamedTuple):
    """Equations of the coefficients of H, for n pushes.

    Attributes
    ----------
    wrenches, twists : ndarray, shape (n, 3)
        Wrenches with a mean square of 1, and unit twists.
    values : ndarray, shape (n, 15)
        H at the wrenches, by coefficients.
    across : ndarray, shape (n, 15, 15)
        Square of the component of a quarter of the gradient across the twist.
    """

    wrenches: Array
    twists: Array
    values: Array
    across: Array

    @classmethod
    def of(cls, wrenches: Array, twists: Array) -> Equations:
        loads = wrenches / np.sqrt((wrenches**2).sum(axis=1).mean())
        ways = unit(twists)
        slopes = np.einsum("mijkl,ni,nj,nk->nml", MONOMIALS, loads, loads, loads)
        across = slopes - (slopes @ ways[..., None]) * ways[:, None]
        values = (slopes @ loads[..., None])[..., 0]
        return cls(loads, ways, values, across @ across.transpose(0, 2, 1))

    def part(self, rows: Mask) -> Equations:
        return Equations(*(array[rows] for array in self))

    def errors(self, tensor: Array) -> Array:
        """Angles between measured and predicted twists, and wrenches, in degrees."""
        model = Quartic(tensor)
        return np.concatenate([
            angles(model.motions(self.wrenches), self.twists),
            angles(model.wrenches(self.twists), self.wrenches),
        ])  # fmt: skip

    def tensor(self, force: float, pull: float) -> Array:
        """Tensor of the best convex form, by a semidefinite program."""
        count = len(self.values)
        square = (self.across.sum(axis=0) + force * self.values.T @ self.values) / count
        square += pull * np.diag((MONOMIALS**2).sum(axis=(1, 2, 3, 4)))
        more = (0, len(VANISHING))
        settings = clarabel.DefaultSettings()
        settings.verbose = False
        settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = 1e-10
        solver = clarabel.DefaultSolver(
            sparse.csc_matrix(np.triu(np.pad(square, more))),
            np.pad(-force * self.values.mean(axis=0), more), sparse.csc_matrix(-COLUMNS),
            -MARGIN * _triangles(ROUND)[0], [clarabel.PSDTriangleConeT(9)], settings,
        )  # fmt: skip
        coefficients = np.array(solver.solve().x)[: len(MONOMIALS)]
        return np.asarray(np.tensordot(coefficients, MONOMIALS, 1))
