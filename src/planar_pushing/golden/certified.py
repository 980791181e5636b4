"""Certified values as datasets: nested lists of balls, integers or labels, with units by name."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

import numpy as np
import xarray as xr
from flint import __FLINT_VERSION__ as FLINT_VERSION
from flint import arb

from planar_pushing.golden.balls import PRECISION, pack, precise

#: An enclosure of zero below this size is one of a number that vanishes by symmetry.
NOTHING = 1e-40
#: Name: dims and values, nested lists of balls or integers.
Values = dict[str, tuple[tuple[str, ...], Any]]
MODES = "SEPARATE STICK SLIP_RIGHT SLIP_LEFT"
#: What flags mean, in the order of their values.
FLAGS = {"outcome": "INCONSISTENT UNIQUE AMBIGUOUS", "mode": MODES, "modes": MODES}
#: A name that ends in one of these words is an angle, unless a list below has it.
DEGREES = ("angle", "right", "left", "start", "stop")
RATIOS = {
    *("adhesive", "contact", "effect", "effects", "friction_coefficient", "inertia_share", "mode"),
    *("modes", "outcome", "panel", "sector_outside", "spin_ratio", "twist_component", "xy"),
}
LENGTHS = {
    *("center", "center_left", "center_right", "cone_center", "exact_center_x", "exact_center_y"),
    *("mapped_rod_length", "radius", "ring_center", "rod_length"),
}
FORCES = {
    *("force", "force_x", "force_y", "infinite_rod_x", "infinite_rod_y", "mapped_force_x"),
    *("mapped_force_y", "parallel_force"),
}
MOTIONS = {"contact_motion", "pusher_magnitude", "pusher_motion", "slip", "support_motion", "twist"}


def unit_of(name: str) -> str:
    """Unit of a golden variable or coordinate."""
    for unit, names in (("1", RATIOS), ("length", LENGTHS), ("force", FORCES), ("motion", MOTIONS)):
        if name in names:
            return unit
    if name == "support_force":
        return "force/radian"
    if name.rpartition("_")[2] in DEGREES:
        return "degree"
    raise KeyError(name)


def _packed(ball: arb) -> tuple[float, float, float]:
    """Midpoint and radius; a number that vanishes by symmetry is stored as zero and its radius."""
    if ball.is_finite() and ball.contains(0) and ball.abs_upper() < NOTHING:
        return 0.0, 0.0, float(ball.abs_upper()) * 2
    return pack(ball)


@precise
def certified(values: Values, coords: Mapping[str, Any], title: str) -> xr.Dataset:
    """Dataset of values with the midpoint, its low part and the radius of each ball."""
    dataset = xr.Dataset(coords=dict(coords))
    for name, (dims, nested) in values.items():
        array = np.array(nested, dtype=object)
        attrs = {"units": unit_of(name)}
        attrs |= {"flag_meanings": FLAGS[name]} if name in FLAGS else {}
        if not any(isinstance(each, arb) for each in array.ravel()):
            kind = np.int8 if all(isinstance(each, int) for each in array.ravel()) else float
            dataset[name] = (dims, array.astype(kind), attrs)
            continue
        packed = np.array([_packed(each) for each in array.ravel()]).reshape((*array.shape, 3))
        dataset[name] = (dims, packed[..., 0], attrs)
        dataset[f"{name}_low"] = (dims, packed[..., 1], attrs)
        dataset[f"{name}_radius"] = (dims, packed[..., 2], {"units": unit_of(name)})
    for axis in dataset.coords:
        dataset[axis].attrs["units"] = unit_of(str(axis))
    dataset.attrs = {
        "title": title,
        "method": "Arb elliptic integrals; roots enclosed by a change of sign between balls",
        "precision_bits": PRECISION,
        "python_flint": version("python-flint"),
        "flint": FLINT_VERSION,
    }
    return dataset
