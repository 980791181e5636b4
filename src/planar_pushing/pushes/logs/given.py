"""Values that a user gives with pushes: arrays of numbers, properties of the object, noise."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.schema import MEASURED_NOISE
from planar_pushing.terms.errors import InvalidValue, as_floats, require_number, require_positive
from planar_pushing.terms.numbers import required_array

#: Largest number of pushes or of resamples, limited by hours of computation.
MOST = 1e7


def numbers(name: str, given: Any) -> Array:
    """Return numbers as an array, or raise `InvalidValue`."""
    return required_array(name, given, "an array of numbers", "give floats")


def whole(name: str, given: Any, least: int, most: float = np.inf) -> int:
    """Return a whole number in a range, or raise `InvalidValue`."""
    allowed = f"a whole number >= {least}" + (f", at most {most:g}" if most < np.inf else "")
    return int(
        require_number(
            name, given, lambda x: least <= x <= most and math.isfinite(x) and x == int(x), allowed,
            "give one",
        )
    )  # fmt: skip


def not_negative(name: str, given: Any, remedy: str) -> float:
    """Return a finite number >= 0, or raise `InvalidValue`."""
    return require_number(name, given, lambda x: 0.0 <= x < np.inf, "a number >= 0", remedy)


def rows_of(name: str, given: Any, width: int, count: int | None = None) -> Array:
    """Return finite numbers of shape (n, width), or raise `InvalidValue`."""
    found = numbers(name, given)
    if (
        found.ndim != 2
        or found.shape[1] != width
        or count not in (None, len(found))
        or not len(found)
    ):
        allowed = f"shape ({'n' if count is None else count}, {width})"
        raise InvalidValue(name, f"shape {found.shape}", allowed, "give a row for each push")
    if not np.isfinite(found).all():
        row = int(np.argwhere(~np.isfinite(found))[0][0])
        raise InvalidValue(
            name, f"{found[row]} of push {row}", "finite numbers", "leave out what was not measured"
        )
    return found


def object_parts(feet: Any, loads: Any, center_of_mass: Any, mass: float | None) -> dict[str, Any]:
    """Given variables of the object."""
    found: dict[str, Any] = {}
    if feet is not None:
        found["feet"] = rows_of("feet", feet, 2)[None]
    if loads is not None:
        shares = numbers("foot_weights", loads)
        known = not np.isnan(shares).all()
        wrong = feet is None or shares.shape != found["feet"].shape[1:2]
        if wrong or (known and not ((shares >= 0.0).all() and shares.sum() > 0.0)):
            raise InvalidValue(
                "foot_weights", loads, "a number >= 0 for each foot", "give feet and loads"
            )
        found["foot_weight"] = (shares / shares.sum())[None]
    if center_of_mass is not None:
        found["center_of_mass"] = rows_of("center_of_mass", [center_of_mass], 2, 1)
    if mass is not None:
        found["mass"] = np.array([require_positive("mass", mass, "leave out an unknown mass")])
    return found


def noise_attributes(given: Any) -> dict[str, float]:
    """Attributes for the noise."""
    if given is None:
        return {}
    if len(as_floats(given)) != len(MEASURED_NOISE):
        raise InvalidValue(
            "noise", given, "three numbers: position, angle in degrees, force", "give all three"
        )
    return {
        name: not_negative(name, each, "give 0 for none")
        for name, each in zip(MEASURED_NOISE, given, strict=True)
    }


def required_units(given: Any) -> dict[str, str]:
    """Return the names of the units of lengths and forces by quantity, or raise `InvalidValue`."""
    names = list(given) if isinstance(given, (tuple, list)) else []
    if len(names) != 2 or not all(isinstance(each, str) and each for each in names):
        raise InvalidValue(
            "units", given, "the names of two units, such as (mm, N)", "give both as text"
        )
    return dict(zip(("length", "force"), names, strict=True))
