"""Quantities that models predict, the reference among the models, and angles between vectors."""

from __future__ import annotations

import numpy as np

from planar_pushing.mechanics.plane import Array

#: Predicted quantities, and the reference model.
QUANTITIES, REFERENCE = ("wrench", "motion", "pose"), "fitted_ellipsoid"


def angles(a: Array, b: Array) -> Array:
    """Angles between vectors of shape (n, 3) in degrees, accurate for small angles."""
    across = np.linalg.norm(np.cross(a, b), axis=1)
    return np.asarray(np.rad2deg(np.arctan2(across, (a * b).sum(axis=1))))
