"""Pushes that touch the object, their first touches, and the finger's paths after these."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import starts_of
from planar_pushing.objects.first_touch import Touch, first_touch
from planar_pushing.pushes.logs.path import Path, after_touch
from planar_pushing.pushes.logs.possible import push_numbers
from planar_pushing.terms.errors import InvalidValue

#: Overlap attributed to rounding, in sizes of the outline.
ROUNDING = 1e-9


def touching_pushes(
    outline: Outline, path: Path, radius: float, tolerance: float, skip_missed: bool
) -> tuple[npt.NDArray[np.intp], Touch, list[Path]]:
    """Numbers of the pushes that touch the object, all first touches, and the paths after them.

    A push that begins deeper in the object than the tolerance counts as one that does not touch it.
    """
    touch, leg = _first(outline, path, radius, tolerance)
    depth = touch.overlap
    inside = depth > tolerance + ROUNDING * outline.size
    deep = np.flatnonzero(inside)
    if len(deep) and (not skip_missed or inside.all()):
        raise InvalidValue(
            "finger_start",
            f"a finger that begins {depth[deep[0]]:.4g} deep in the object, in pushes {push_numbers(deep)}",
            f"an overlap of at most {tolerance:.4g}",
            "check poses, frame, radius and units, or raise the tolerance",
        )  # fmt: skip
    rows = np.flatnonzero(np.isfinite(touch.fraction) & ~inside)
    after = [after_touch(path, int(row), int(leg[row]), float(touch.fraction[row])) for row in rows]
    forward = [
        one.points[-1] @ touch.normal[row] > 0.0 for row, one in zip(rows, after, strict=True)
    ]
    pushing = [k for k, ahead in enumerate(forward) if ahead]
    missed = np.setdiff1d(np.arange(len(leg)), rows[pushing])
    if len(missed) and (not skip_missed or len(missed) == len(leg)):
        raise InvalidValue(
            "pushes", f"{len(missed)} of {len(leg)} that do not touch the object: {push_numbers(missed)}",
            "pushes that touch it", "leave them out, or set skip_missed where some touch",
        )  # fmt: skip
    return rows[pushing], touch, [after[k] for k in pushing]


def _first(
    outline: Outline, path: Path, radius: float, tolerance: float
) -> tuple[Touch, npt.NDArray[np.intp]]:
    """First touch along the legs of each path, and its leg, with the overlap at the start."""
    start, motion = path.points[:, :-1], np.diff(path.points, axis=1)
    known = np.isfinite(motion).all(axis=2, keepdims=True)
    # A missing leg is replaced by a stationary finger at the outline, which is not a touch.
    every = first_touch(
        outline,
        np.where(known, start, starts_of(outline.pieces)[0]),
        np.where(known, motion, 0.0),
        radius,
        tolerance=tolerance,
    )
    leg = np.isfinite(every.fraction).argmax(axis=1)
    rows = np.arange(len(leg))
    return Touch(
        contact=every.contact[rows, leg], normal=every.normal[rows, leg], side=every.side[rows, leg],
        corner=every.corner[rows, leg], fraction=every.fraction[rows, leg], overlap=every.overlap[:, 0],
    ), leg  # fmt: skip
