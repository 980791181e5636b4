"""Values that a user gives with pushes: arrays of numbers, properties of the object, noise."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.schema import MEASURED_NOISE
from planar_pushing.terms.errors import InvalidValue, as_floats, require_number, require_positive
from planar_pushing.terms.numbers import require_array

#: Largest number of pushes or of resamples, limited by hours of computation.
MOST = 1e7


def numbers(name: str, value: Any) -> Array:
    """Return numbers as an array, or raise `InvalidValue`."""
    return require_array(name, value, "an array of numbers", "give floats")


def whole_number(name: str, value: Any, minimum: int, maximum: float = np.inf) -> int:
    """Return a whole number in a range, or raise `InvalidValue`."""
    allowed = f"a whole number >= {minimum}" + (
        f", at most {maximum:g}" if maximum < np.inf else ""
    )
    return int(
        require_number(
            name, value, lambda x: minimum <= x <= maximum and math.isfinite(x) and x == int(x), allowed,
            "give one",
        )
    )  # fmt: skip


def not_negative(name: str, value: Any, remedy: str) -> float:
    """Return a finite number >= 0, or raise `InvalidValue`."""
    return require_number(name, value, lambda x: 0.0 <= x < np.inf, "a number >= 0", remedy)


def rows_of(name: str, value: Any, width: int, count: int | None = None) -> Array:
    """Return finite numbers of shape (n, width), or raise `InvalidValue`."""
    rows = numbers(name, value)
    if rows.ndim != 2 or rows.shape[1] != width or count not in (None, len(rows)) or not len(rows):
        allowed = f"shape ({'n' if count is None else count}, {width})"
        raise InvalidValue(name, f"shape {rows.shape}", allowed, "give a row for each push")
    if not np.isfinite(rows).all():
        row = int(np.argwhere(~np.isfinite(rows))[0][0])
        raise InvalidValue(
            name, f"{rows[row]} of push {row}", "finite numbers", "leave out what was not measured"
        )
    return rows


def object_parts(feet: Any, loads: Any, center_of_mass: Any, mass: float | None) -> dict[str, Any]:
    """Given variables of the object."""
    parts: dict[str, Any] = {}
    if feet is not None:
        parts["feet"] = rows_of("feet", feet, 2)[None]
    if loads is not None:
        shares = numbers("foot_weights", loads)
        known = not np.isnan(shares).all()
        wrong = feet is None or shares.shape != parts["feet"].shape[1:2]
        if wrong or (known and not ((shares >= 0.0).all() and shares.sum() > 0.0)):
            raise InvalidValue(
                "foot_weights", loads, "a number >= 0 for each foot", "give feet and loads"
            )
        parts["foot_weight"] = (shares / shares.sum())[None]
    if center_of_mass is not None:
        parts["center_of_mass"] = rows_of("center_of_mass", [center_of_mass], 2, 1)
    if mass is not None:
        parts["mass"] = np.array([require_positive("mass", mass, "leave out an unknown mass")])
    return parts


def noise_attributes(value: Any) -> dict[str, float]:
    """Attributes for the noise."""
    if value is None:
        return {}
    if len(as_floats(value)) != len(MEASURED_NOISE):
        raise InvalidValue(
            "noise", value, "three numbers: position, angle in degrees, force", "give all three"
        )
    return {
        name: not_negative(name, sigma, "give 0 for none")
        for name, sigma in zip(MEASURED_NOISE, value, strict=True)
    }


def require_units(value: Any) -> dict[str, str]:
    """Return the names of the units of lengths and forces by quantity, or raise `InvalidValue`."""
    names = list(value) if isinstance(value, (tuple, list)) else []
    if len(names) != 2 or not all(isinstance(name, str) and name for name in names):
        raise InvalidValue(
            "units", value, "the names of two units, such as (mm, N)", "give both as text"
        )
    return dict(zip(("length", "force"), names, strict=True))
