"""Motion centres of a scene, relative to the contact."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose


def center(ring: list[Doubled], force_angle: Doubled, k: Doubled, radius: float) -> list[Floats]:
    """The centre at -1/k along x', the force's direction less 90 degrees, from the ring centre.

    A translation is the limit k -> 0+: infinite where x' has such a part.
    """
    cosine, sine = cosine_sine(force_angle)
    still = k.high == 0
    away = -radius / choose(still, 1.0, k)
    found = []
    for middle, part in zip(ring, (sine, -cosine), strict=True):
        far = np.where(part.high == 0, 0.0, np.where(part.high < 0, np.inf, -np.inf))
        found.append(np.where(still, middle.high + far, (middle + away * part).value()))
    return found


def center_error(stored: Any, wanted: list[Floats], rounding: Any) -> tuple[Floats, Floats]:
    """Errors of centres, shape S + (2,), and what a relative rounding of k explains."""
    points = np.stack(np.broadcast_arrays(*wanted), axis=-1)
    same = stored == points
    with np.errstate(invalid="ignore"):
        gap = np.where(same, 0.0, np.abs(stored - points))
    size = np.abs(np.where(np.isfinite(points), points, 0.0)).max(axis=-1, keepdims=True)
    return gap, np.asarray(rounding)[..., None] * size
