"""Identify a support from motions: least squares of final poses over weights and contact friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares, lsq_linear
from tqdm import tqdm

from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Points
from planar_pushing.pushes.fit.balance import ridge
from planar_pushing.pushes.fit.candidates import Family
from planar_pushing.pushes.fit.supported import BodyFrames, body_frames, simulate_measured
from planar_pushing.pushes.logs.measured import Index, Measured

#: Friction coefficients tried before the searches, and the range of the searches.
TRIED, FRICTION = np.geomspace(0.05, 1.2, 10), (0.01, 3.0)
#: Step of a finite difference, relative to the typical magnitude of a parameter: far above the tolerance
#: of a motion and far below significant amounts.
CHANGE = 1e-3
#: Typical magnitudes of an amount relative to its even share, and of the friction coefficient.
USUAL_AMOUNT, USUAL_FRICTION = 1.0, 0.2
#: Maximum number of derivatives in a search, and relative change of parameters or cost at which it ends.
EVALUATIONS, DONE = 15, 1e-4


class Linear(NamedTuple):
    """Residuals that are linear in the amounts, in standard deviations: ``matrix @ amounts - target``."""

    matrix: Array
    target: Array


@dataclass(frozen=True, slots=True, eq=False)
class MotionProblem:
    """Final poses of pushes as functions of the amounts of a family's columns and of contact friction.

    The parameters are the amounts relative to even shares, followed by the friction coefficient.
    """

    pushes: Measured
    family: Family
    frames: BodyFrames
    places: Array

    @classmethod
    def of(cls, pushes: Measured, family: Family) -> MotionProblem:
        frames = body_frames(pushes, pushes.center, pushes.size)
        offsets = family.places - frames.origin[:, None]
        x, y = offsets[..., 0], offsets[..., 1]
        a, b = frames.axis[:, :1], frames.axis[:, 1:]
        return cls(pushes, family, frames, np.stack([x * a + y * b, y * a - x * b], axis=-1))

    @property
    def even(self) -> Array:
        """Parameters of even amounts, without the friction coefficient."""
        return np.full(self.family.columns.shape[1], USUAL_AMOUNT)

    def residuals(self, parameters: Array) -> Array:
        """Errors of final poses, as lengths, for rows of parameters, shape (rows, n, 3)."""
        weights = parameters[:, :-1] @ self.family.columns.T
        supports = [
            Points(places[kept], row[kept])
            for row, kept in zip(weights, weights > 0.0, strict=True)
            for places in self.places
        ]
        friction = np.repeat(parameters[:, -1], len(self.pushes))
        poses = simulate_measured(self.pushes, self.frames, supports, friction, self.pushes.size)
        poses = poses.reshape(len(parameters), -1, 3)
        return np.asarray((poses - self.pushes.observed) * [1.0, 1.0, self.pushes.length])


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """Result of the best search.

    Attributes
    ----------
    amounts : ndarray, shape (c,)
        Amounts relative to even shares.
    friction : float
    residuals : ndarray, shape (n, 3)
        Errors of final poses as lengths.
    scale : float
        Error above which a residual counts less than its square.
    slopes : ndarray, shape (3 n, c + 1)
        Derivatives of the residuals.
    optimality : float
        Largest derivative of the cost with respect to a free parameter, relative to that at the start.
    """

    amounts: Array
    friction: float
    residuals: Array
    scale: float
    slopes: Array
    optimality: float


def fit_motions(
    problem: MotionProblem, linear: Linear | None = None, progress: bool = False
) -> Fitted:
    """Amounts and friction with simulated motions that end closest to the measured poses.

    Parameters
    ----------
    problem : MotionProblem
    linear : Linear, optional
        Additional residuals of pushes with forces, for amounts relative to even shares.
    progress : bool
        Whether to show a progress bar.

    Notes
    -----
    Bounded least squares by `scipy.optimize.least_squares`. Large residuals count in proportion to their
    magnitude, as ``2 (sqrt(1 + r^2) - 1)``. Several starting points are tried, and the best are refined.
    """
    starts, errors = _starts(problem)
    scale = max(1.5 * float(np.median(np.abs(errors))), problem.pushes.noise[0])
    with tqdm(
        total=len(starts) * EVALUATIONS, disable=not progress, unit="step", leave=False
    ) as bar:
        every = [_search(problem, linear, scale, start, bar.update) for start in starts]
    best = min(every, key=lambda result: float(result.cost))
    slopes, residuals = _slopes(problem, best.x)
    return Fitted(
        amounts=best.x[:-1], friction=float(best.x[-1]), residuals=residuals.reshape(-1, 3),
        scale=scale, slopes=slopes, optimality=float(best.optimality) / max(1.0, float(best.cost)),
    )  # fmt: skip


def resample(fitted: Fitted, linear: Linear | None, rows: Index) -> Array:
    """Parameters for the resampled pushes in `rows`, by one step from the best parameters."""
    count = len(fitted.amounts)
    errors = fitted.residuals.ravel() / fitted.scale
    # Large residuals count in proportion to their magnitude.
    weight = (1.0 + errors**2) ** -0.25
    index = (3 * rows[:, None] + np.arange(3)).ravel()
    slopes = (weight[:, None] * fitted.slopes / fitted.scale)[index]
    further, pull = _further(linear, np.append(fitted.amounts, fitted.friction), len(errors))
    step = lsq_linear(
        np.concatenate([slopes, pull]),
        -np.concatenate([(weight * errors)[index], further]),
        bounds=(_bounds(count)[0] - np.append(fitted.amounts, fitted.friction) - 1e-9, np.inf),
    )  # fmt: skip
    return np.asarray(np.append(fitted.amounts, fitted.friction) + step.x)


def _starts(problem: MotionProblem) -> tuple[list[Array], Array]:
    """Best starting points, from even amounts and amounts on the rim, and the errors of the best."""
    places = problem.family.columns.T @ problem.family.places
    away = np.hypot(*(places - problem.pushes.center).T)
    rim = np.where(away > np.median(away), 1.9, 0.1)
    tried = np.array([np.append(weights, mu) for weights in (problem.even, rim) for mu in TRIED])
    errors = problem.residuals(tried)
    ranks = np.abs(errors).mean(axis=(1, 2)).reshape(2, -1).argmin(axis=1)
    best = [len(TRIED) * k + int(rank) for k, rank in enumerate(ranks)]
    return [tried[k] for k in best], errors[
        min(best, key=lambda k: float(np.abs(errors[k]).mean()))
    ]


def _search(
    problem: MotionProblem, linear: Linear | None, scale: float, start: Array, tell: Any
) -> Any:
    number = 3 * len(problem.pushes)

    def errors(parameters: Array) -> Array:
        moved = problem.residuals(parameters[None])[0].ravel() / scale
        return np.append(moved, _further(linear, parameters, number)[0])

    def slopes(parameters: Array) -> Array:
        tell()
        return np.concatenate(
            [_slopes(problem, parameters)[0] / scale, _further(linear, parameters, number)[1]]
        )

    return least_squares(
        errors, start, slopes, bounds=_bounds(len(start) - 1), loss="soft_l1",
        x_scale=_usual(len(start) - 1), max_nfev=EVALUATIONS, xtol=DONE, ftol=DONE,
    )  # fmt: skip


def _slopes(problem: MotionProblem, parameters: Array) -> tuple[Array, Array]:
    """Derivatives of the residuals, shape (3 n, c + 1), and the residuals."""
    steps = CHANGE * _usual(len(parameters) - 1)
    rows = parameters + np.concatenate([np.zeros((1, len(steps))), np.diag(steps)])
    errors = problem.residuals(rows).reshape(len(rows), -1)
    return np.asarray(((errors[1:] - errors[0]) / steps[:, None]).T), errors[0]


def _further(linear: Linear | None, parameters: Array, number: int) -> tuple[Array, Array]:
    """Residuals of the pull toward even amounts and of pushes with forces, and their derivatives."""
    count = len(parameters) - 1
    pull = ridge(number, count)
    residuals = pull * (parameters[:-1] - USUAL_AMOUNT)
    slopes = pull * np.eye(count, count + 1)
    if linear is None:
        return residuals, slopes
    linear_errors = linear.matrix @ parameters[:-1] - linear.target
    return np.append(residuals, linear_errors), np.concatenate(
        [slopes, np.pad(linear.matrix, ((0, 0), (0, 1)))]
    )


def _bounds(count: int) -> tuple[Array, Array]:
    return (
        np.append(np.zeros(count), FRICTION[0]),
        np.append(np.full(count, np.inf), FRICTION[1]),
    )


def _usual(count: int) -> Array:
    return np.append(np.full(count, USUAL_AMOUNT), USUAL_FRICTION)
