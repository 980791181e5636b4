"""Numbers computed from published pushes: `paper/measured_pushes.json`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.compare import compare
from planar_pushing.pushes.fit.scores import REFERENCE
from planar_pushing.pushes.fit.statistics import split_statistics, statistics
from planar_pushing.pushes.formats.mit import read_mit
from planar_pushing.pushes.formats.three_feet import read_three_feet
from planar_pushing.pushes.identified import Identified, moments_of
from planar_pushing.pushes.identify import identify
from planar_pushing.pushes.logs.combine import of_object
from planar_pushing.pushes.logs.measured import Mask, Measured, measurements_of
from planar_pushing.pushes.models import feet_of
from planar_pushing.terms.errors import InvalidValue

#: Folders and extensions of the logs.
LOG_FILES = {"three_feet": "*.txt", "polygons": "*.mat"}
#: Sources of the logs.
SOURCES = {
    "three_feet": "J. Zhou, R. Paolini, J. A. Bagnell and M. T. Mason, ICRA 2016",
    "polygons": "K.-T. Yu, M. Bauza, N. Fazeli and A. Rodriguez, IROS 2016; as filtered by J. Zhou, Y. Hou "
    "and M. T. Mason",
}  # fmt: skip
COMMAND = "snakemake measured_pushes --config data=FOLDER"
#: The one measure that was named in advance: its ratio decides, and everything else describes.
PRIMARY = {
    "part": "three_feet",
    "quantity": "motion",
    "rivals": ["fitted_ellipsoid", "fitted_quartic"],
}
#: Numbers of splits into halves of pushes with forces, and of those of polygons, whose fits take longer.
SPLITS, POLYGON_SPLITS = 50, 1
#: Models with which the identified pressure is compared: fitted ones, and the feet themselves.
RIVALS = ("fitted_ellipsoid", "fitted_quartic", "known_feet")
IDENTIFIED = "identified"
#: Stored statistics; most have intervals.
STORED = ("median", "percentile_90", "ratio", "ratio_90")
#: Largest distance of the center of rotation from a foot, in mm, in pushes about that foot.
PIVOT_DISTANCE = 5.0
#: Largest distance of a wrench from the load set of a foot, relative to its magnitude, to count as in it.
LOAD_SET_TOLERANCE = 0.2


def measure(
    folder: Any, seed: int = 0, progress: bool = False, splits: int = SPLITS, workers: Any = 1
) -> dict[str, Any]:
    """Identify supports and compare models on the published logs of a folder.

    Parameters
    ----------
    folder : path
        Folder with `three_feet/*.txt`, `polygons/*.mat`, or both.
    seed : int
        Seed of the division into halves and of the resampling.
    progress : bool
        Whether to show progress bars.
    splits : int
        Number of divisions into halves of the logs with forces; polygons have one.
    workers : int or callable
        As in `compare`.

    Returns
    -------
    dict
        Numbers, texts, lists and None, as in JSON.

    Raises
    ------
    InvalidValue
        If the folder contains no logs.
    InvalidFile
        If a log cannot be read.
    """
    files = {name: sorted(Path(folder, name).glob(ending)) for name, ending in LOG_FILES.items()}
    if not any(files.values()):
        raise InvalidValue(
            "data", str(folder), "a folder with three_feet/*.txt or polygons/*.mat",
            "give the folder of the published logs",
        )  # fmt: skip
    numbers: dict[str, Any] = {
        "command": COMMAND, "seed": seed, "splits": splits, "polygon_splits": POLYGON_SPLITS,
        "primary": PRIMARY, "source": SOURCES,
    }  # fmt: skip
    options = {"seed": seed, "progress": progress, "workers": workers}
    if files["three_feet"]:
        pushes = read_three_feet(*files["three_feet"])
        footed = np.array([feet_of(of_object(pushes, name)) is not None for name in _names(pushes)])
        for key, members in (("three_feet", footed), ("patch", ~footed)):
            names = [
                name for name, is_member in zip(_names(pushes), members, strict=True) if is_member
            ]
            if names:
                numbers[key] = _with_forces(_of_objects(pushes, names), splits, options)
        if footed.any():
            numbers["about_a_foot"] = _about_a_foot(pushes)
    if files["polygons"]:
        numbers["polygons"] = _by_poses(read_mit(*files["polygons"]), options)
    return numbers


def _names(pushes: xr.Dataset) -> list[str]:
    return [str(name) for name in pushes["object"].values]


def _of_objects(pushes: xr.Dataset, names: list[str]) -> xr.Dataset:
    """Pushes of some of the objects."""
    return pushes.isel(
        push=np.flatnonzero(np.isin(pushes["pushed"].values.astype(str), names)),
        object=[_names(pushes).index(name) for name in names],
    )


def _with_forces(pushes: xr.Dataset, splits: int, options: Mapping[str, Any]) -> dict[str, Any]:
    """Identified supports and the comparison of models, for logs with forces."""
    comparison = compare(pushes, splits=splits, **options)
    seed, progress = options["seed"], options["progress"]
    return {
        "selection": "all pushes that touch the object",
        "pushes": pushes.sizes["push"],
        "length": float(comparison["length"].values[0]),
        "logs": {name: _log(of_object(pushes, name), seed, progress) for name in _names(pushes)},
        "comparison": _table(comparison),
        "against": _against(comparison),
    }


def _against(comparison: xr.Dataset) -> dict[str, Any]:
    """Ratios of the errors of the identified pressure to those of each rival that applies, by quantity."""
    every = np.ones(comparison.sizes["push"], dtype=bool)
    numbers: dict[str, Any] = {}
    for rival in [name for name in RIVALS if name in comparison["model"]]:
        entries = _part(comparison, every, rival).sel(model=IDENTIFIED)
        numbers[rival] = {
            str(quantity): {
                name: _values(entries[name].sel(quantity=quantity))
                for name in ("ratio", "ratio_interval", "ratio_90", "ratio_90_interval")
            } | _splits(comparison, str(quantity), rival)
            for quantity in comparison["quantity"].values
        }  # fmt: skip
    return numbers


def _splits(comparison: xr.Dataset, quantity: str, rival: str) -> dict[str, float]:
    """Fraction of the splits with a ratio of medians below one, and the smallest and the largest ratio."""
    errors = comparison["split_error"] if "split_error" in comparison else comparison["error"]
    medians = errors.sel(quantity=quantity).median("push")
    ratios = np.atleast_1d((medians.sel(model=IDENTIFIED) / medians.sel(model=rival)).values)
    return {
        "splits_below_one": float((ratios < 1.0).mean()),
        "smallest": float(ratios.min()),
        "largest": float(ratios.max()),
    }


def _by_poses(pushes: xr.Dataset, options: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers for logs without forces: for pushes that touch a side first, and for all pushes."""
    comparison = compare(pushes, splits=POLYGON_SPLITS, **options)
    corner, pushed = comparison["at_corner"].values, comparison["pushed"].values
    by_side = _table(_part(comparison, ~corner))
    return {
        "selection": "pushes that touch the object; comparison: of those that touch a side first",
        "pushes": pushes.sizes["push"],
        "corner_pushes": int(corner.sum()),
        "left_out": int(pushes.attrs.get("left_out", 0)),
        "length": dict(zip(_names(pushes), comparison["length"].values.tolist(), strict=True)),
        "comparison": by_side,
        "with_corners": _table(comparison),
        "objects": {
            name: _table(_part(comparison, (pushed == name) & ~corner))["pose"]
            for name in _names(pushes)
        },
    }


def _part(comparison: xr.Dataset, rows: Mask, model: str = REFERENCE) -> xr.Dataset:
    """Statistics of some of the pushes, relative to a model."""
    part = comparison.isel(push=np.flatnonzero(rows))
    if "split_error" in part:
        draws = part["draws"].values
        return split_statistics(part["split_error"], part["resampled_error"], draws, model)
    return statistics(part["error"], part.attrs["resamples"], part.attrs["seed"], model)


def _table(comparison: xr.Dataset) -> dict[str, Any]:
    """Statistics by quantity and model, without missing values."""
    table: dict[str, Any] = {}
    for quantity in map(str, comparison["quantity"].values):
        for model in map(str, comparison["model"].values):
            entry = comparison.sel(quantity=quantity, model=model)
            if np.isfinite(entry["median"]):
                table.setdefault(quantity, {})[model] = {
                    key: _values(entry[key])
                    for name in STORED
                    for key in (name, f"{name}_interval")
                }
    return table


def _values(array: xr.DataArray) -> Any:
    """A number, or the numbers of an interval."""
    return array.values.tolist()


def _log(pushes: xr.Dataset, seed: int, progress: bool) -> dict[str, Any]:
    """Support identified from all pushes of a log, and the true one if it is known."""
    identified, true = identify(pushes, seed=seed, progress=progress), feet_of(pushes)
    measurements = measurements_of(pushes)
    numbers: dict[str, Any] = {
        "pushes": len(measurements),
        "outline": measurements.outline.vertices().tolist(),
        "support": _weighted_points(identified.support),
        "feet": _weighted_points(identified.feet),
        "contact_friction": identified.contact_friction,
        "center_of_pressure": identified.center_of_pressure.tolist(),
        "spin_torque": identified.spin_torque,
        "weight": identified.weight if measurements.has_force.any() else None,
        "intervals": _intervals(identified),
        "optimality": identified.optimality,
        "true_feet": None,
        "true_spin_torque": None,
    }
    if true is not None:
        positions, loads = np.array(true.positions), np.array(true.weights)
        numbers |= {
            "true_feet": _weighted_points(true),
            "true_center_of_pressure": list(true.center_of_pressure),
            "true_spin_torque": moments_of(positions, loads)[1],
        }
    return numbers


def _weighted_points(points: Any) -> list[list[float]]:
    """Positions of points and their fractions of the weight."""
    loads = np.array(points.weights)
    rows: list[list[float]] = np.column_stack([points.positions, loads / loads.sum()]).tolist()
    return rows


def _intervals(identified: Identified) -> dict[str, list[float]]:
    """Both ends of each resampled interval that is finite."""
    return {
        name: list(ends) for name, ends in identified.intervals.items() if np.isfinite(ends).all()
    }


def _about_a_foot(pushes: xr.Dataset) -> dict[str, Any]:
    """How often the wrench of a push is in a foot's load set, for pushes about the foot and for all."""
    about_foot, about_in_set, count, all_in_set = 0, 0, 0, 0
    for name in _names(pushes):
        log = of_object(pushes, name)
        feet = feet_of(log)
        if feet is None:
            continue
        measurements = measurements_of(log)
        positions, shares = np.array(feet.positions), np.array(feet.weights) / sum(feet.weights)
        in_sets = _in_load_sets(
            measurements, positions, shares, identify(log, known=feet, resamples=1).weight
        )
        is_about = _pivots(measurements, positions) < PIVOT_DISTANCE
        about_foot, about_in_set = (
            about_foot + int(is_about.any(axis=1).sum()),
            about_in_set + int((is_about & in_sets).any(axis=1).sum()),
        )
        count, all_in_set = count + is_about.size, all_in_set + int(in_sets.sum())
    return {
        "distance": PIVOT_DISTANCE,
        "tolerance": LOAD_SET_TOLERANCE,
        "pushes": about_foot,
        "in_load_set": about_in_set / max(about_foot, 1),
        "of_random_pushes": all_in_set / max(count, 1),
    }


def _pivots(pushes: Measured, positions: Array) -> Array:
    """Distance of the center of rotation of each push from each place, shape (n, k)."""
    v_x, v_y, turn = pushes.twists.T[..., None]
    x, y = positions.T
    speed = np.hypot(v_x - turn * y, v_y + turn * x)
    return np.asarray(speed / np.maximum(np.abs(turn), 1e-300))


def _in_load_sets(pushes: Measured, positions: Array, shares: Array, weight: float) -> Mask:
    """Whether the wrench of each push is near the load set of a rotation about each place, shape (n, k).

    The rotation determines the forces at the other feet; the force at the foot is any up to its share.
    """
    scale = np.array([1.0, 1.0, pushes.length])
    wrenches = pushes.wrenches / scale
    inside = np.zeros((len(pushes), len(positions)), dtype=bool)
    for k, (x, y) in enumerate(positions):
        sense = np.sign(pushes.rotation)
        from_foot = np.delete(positions, k, axis=0) - [x, y]
        distances = np.hypot(*from_foot.T)
        u_x, u_y = -from_foot[:, 1] / distances, from_foot[:, 0] / distances
        arm = np.delete(positions, k, axis=0)
        loads = np.stack([u_x, u_y, arm[:, 0] * u_y - arm[:, 1] * u_x])
        other_friction = weight * (loads @ np.delete(shares, k)) / scale
        left = wrenches - sense[:, None] * other_friction
        # Force at the foot by least squares, bounded by its share, and the remainder of the wrench.
        reach = np.array([[1.0, 0.0], [0.0, 1.0], [-y / pushes.length, x / pushes.length]])
        force = left @ np.linalg.pinv(reach).T
        size = np.hypot(*force.T)
        force *= np.minimum(1.0, weight * shares[k] / np.maximum(size, 1e-300))[:, None]
        distance = np.linalg.norm(left - force @ reach.T, axis=1)
        inside[:, k] = distance < LOAD_SET_TOLERANCE * np.linalg.norm(wrenches, axis=1)
    return inside
