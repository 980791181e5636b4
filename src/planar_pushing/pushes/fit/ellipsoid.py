"""An object with an ellipsoidal limit surface, the model that planners fit.

The limit surface is ``w . A w = 1``, and the object moves along ``A w`` under a wrench w.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.limit_surface import LimitSurface


@dataclass(frozen=True, slots=True, eq=False)
class Ellipsoid(LimitSurface):
    """An object with an ellipsoidal limit surface.

    Attributes
    ----------
    matrix : ndarray, shape (3, 3) or (n, 3, 3)
        A, for all pushes or for each of them.
    """

    matrix: Array

    @classmethod
    def about(cls, center: Array, matrix: Array) -> Ellipsoid:
        """Ellipsoid from a matrix for torques about a center."""
        moved = torque_about(center)
        return cls(moved.T @ matrix @ moved)

    def motions(self, wrenches: Array) -> Array:
        if self.matrix.ndim == 3:
            return np.asarray((wrenches[:, None] @ self.matrix)[:, 0])
        return wrenches @ self.matrix

    def forces(self, reach: Array, velocities: Array) -> Array:
        mobility = reach @ (self.matrix @ reach.transpose(0, 2, 1))
        return np.asarray(np.linalg.solve(mobility, velocities[..., None])[..., 0], dtype=float)


def torque_about(center: Array) -> Array:
    """Matrix that converts wrenches about the origin to wrenches about a center."""
    x, y = center
    return np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [y, -x, 1.0]])
