"""Motion centers relative to the contact, on the normal of the line of force through the ring center."""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.certified.doubled.angles import cosine_sine
from planar_pushing.certified.doubled.numbers import Doubled, Floats, choose


def distance(k: Doubled, radius: float) -> Doubled:
    """Distance -R/k of a center from the ring center along x'; of a translation the limit k -> 0+."""
    still = k.high == 0
    return choose(still, -np.inf, -radius / choose(still, 1.0, k))


def center(ring: list[Doubled], force_angle: Doubled, away: Doubled) -> list[Floats]:
    """The center at a distance along x', the force's direction less 90 degrees, from the ring center.

    At infinity it is finite along the axis to which x' is normal.
    """
    cosine, sine = cosine_sine(force_angle)
    endless = np.isinf(away.high)
    near, found = choose(endless, 0.0, away), []
    for middle, part in zip(ring, (sine, -cosine), strict=True):
        far = np.where(part.high == 0, 0.0, np.copysign(np.inf, part.high * np.sign(away.high)))
        found.append(np.where(endless, middle.high + far, (middle + near * part).value()))
    return found


def center_error(stored: Any, wanted: list[Floats], rounding: Any) -> tuple[Floats, Floats]:
    """Errors of centers, shape S + (2,), and what a relative rounding of k explains."""
    points = np.stack(np.broadcast_arrays(*wanted), axis=-1)
    size = np.abs(np.where(np.isfinite(points), points, 0.0)).max(axis=-1, keepdims=True)
    return gap(stored, points), np.asarray(rounding)[..., None] * size


def gap(stored: Any, wanted: Any) -> Floats:
    """Differences of numbers; none where both are the same infinity."""
    same = stored == wanted
    with np.errstate(invalid="ignore"):
        return np.asarray(np.where(same, 0.0, np.abs(stored - wanted)))
