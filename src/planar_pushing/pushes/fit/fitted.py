"""Fit of an ellipsoid to pushes, as planners do."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import least_squares

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.friction import contact_friction
from planar_pushing.pushes.logs.measured import Measured

#: Friction coefficients at which searches start.
STARTS = (0.15, 0.4)
#: Errors above which they count in proportion: in directions, and in poses relative to the median error.
LARGE_ANGLE, LARGE = 0.2, 1.5
#: Step of a parameter, relative to it, or to 1, for a difference quotient.
STEP = float(np.sqrt(np.finfo(float).eps))
#: Ratio of spin torque to force times length of the initial ellipsoid, about that of a uniform pressure.
SPIN = 0.7


def fitted_ellipsoid(pushes: Measured) -> tuple[Ellipsoid, float]:
    """Ellipsoid that fits pushes best, and the contact friction.

    The ellipsoid is any ellipsoid about the origin, with three semi-axes and three directions; motions do
    not determine the common factor of the axes. With forces, the errors are those of the direction of
    motion under the measured wrench. Otherwise they are those of the final poses, and the friction is
    fitted too.
    """
    forced = pushes.has_directions
    if forced.any():
        known = contact_friction(pushes)
        return _from_forces(pushes.part(forced)), known.coefficient
    return _from_motions(pushes.part(~pushes.at_corner))


def _from_forces(pushes: Measured) -> Ellipsoid:
    scale = np.array([1.0, 1.0, pushes.length])
    motions = unit(pushes.centered_twists * scale)
    forces = unit(pushes.centered_wrenches / scale)

    def errors(parameters: Array) -> Array:
        return np.asarray(unit(forces @ _matrix(parameters)) - motions).ravel()

    result = least_squares(errors, np.zeros(5), loss="soft_l1", f_scale=LARGE_ANGLE)
    matrix = _matrix(result.x) / scale / scale[:, None]
    return Ellipsoid.about(pushes.center, matrix)


def _from_motions(pushes: Measured) -> tuple[Ellipsoid, float]:
    scale = np.array([1.0, 1.0, pushes.length])

    def model(parameters: Array) -> Ellipsoid:
        return Ellipsoid.about(pushes.center, _matrix(parameters[:5]) / scale / scale[:, None])

    def errors(parameters: Array) -> Array:
        poses = model(parameters).poses(pushes, float(np.exp(parameters[5])))
        return np.asarray((poses - pushes.observed) * scale).ravel()

    starts = [np.append(_round(), np.log(mu)) for mu in STARTS]
    # All pushes with the parameters, and with each one changed in turn: one call for a Jacobian.
    count = len(pushes)
    repeated = pushes.part(np.tile(np.arange(count), 1 + len(starts[0])))

    def jacobian(parameters: Array) -> Array:
        steps = np.where(parameters < 0.0, -1.0, 1.0) * STEP * np.maximum(np.abs(parameters), 1.0)
        every = parameters + np.vstack([np.zeros_like(steps), np.diag(steps)])
        matrices = np.stack([model(each).matrix for each in every])
        poses = Ellipsoid(np.repeat(matrices, count, axis=0)).poses(
            repeated, np.repeat(np.exp(every[:, 5]), count)
        )
        changes = poses.reshape(-1, count, 3)[1:] - poses[:count]
        return np.asarray((changes * scale).reshape(len(steps), -1).T / steps)

    large = LARGE * min(float(np.median(np.abs(errors(start)))) for start in starts)
    every: list[Any] = [
        least_squares(errors, start, jacobian, loss="soft_l1", f_scale=large) for start in starts
    ]
    best = min(every, key=lambda result: float(result.cost))
    return model(best.x), float(np.exp(best.x[5]))


def unit(vectors: Array) -> Array:
    """Vectors of length 1 along those of shape (n, d)."""
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _round() -> Array:
    """Parameters of the ellipsoid of a round, uniform pressure."""
    return np.array([0.0, 0.0, 0.0, 0.0, -np.log(SPIN)])


def _matrix(parameters: Array) -> Array:
    """Positive definite matrix from five numbers by a Cholesky factor with first entry 1."""
    low = np.zeros((3, 3))
    low[np.tril_indices(3)] = np.append(0.0, parameters)
    low[np.diag_indices(3)] = np.exp(np.diag(low))
    return low @ low.T
