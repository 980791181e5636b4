"""Numbers that figures plot: variables with units, separate axes, and values for captions."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.quantities import DATASET, attributes, described
from pulling_by_pushing.figures.figure import Sources
from pulling_by_pushing.study.describe import parameters_of

#: Attributes of a source that describe its parameters.
ORIGIN = ("scene", "parameters", "pusher")
#: Symbols of quantities in captions, and the sign after their values.
SYMBOLS = {
    "rod_length": ("l", ""),
    "mapped_rod_length": ("l", ""),
    "rod_angle": ("ψ", "°"),
    "friction_coefficient": ("μ", ""),
    "pusher_angle": ("θₚ", "°"),
    "pusher_magnitude": ("|aₚ|", ""),
    "force_angle": ("φ", "°"),
    "radius": ("R", ""),
    "weight": ("W", ""),
    "mass": ("m", ""),
    "gyration_radius": ("ρ", ""),
}


def labeled(name: str, values: Iterable[float]) -> xr.DataArray:
    """Values along a separate axis."""
    array = np.array(list(values), dtype=float)
    return xr.DataArray(array, dims=name, coords={name: array})


def attributed(dataset: xr.Dataset) -> xr.Dataset:
    """Give variables the units and names that they have in the datasets of a study."""
    for name in dataset.variables.keys() & DATASET.keys():
        dataset[name].attrs = attributes(DATASET, str(name))
    return dataset


def named(dims: Iterable[str] | str, values: object, units: str, long_name: str) -> xr.Variable:
    """Make a variable with a unit and a name."""
    axes = dims if isinstance(dims, str) else tuple(dims)
    return xr.Variable(axes, np.asarray(values), described(units, long_name))


def titled(dataset: xr.Dataset, title: str, sources: Sources) -> xr.Dataset:
    """Give the plotted numbers a title and the provenance of their datasets."""
    every = list(sources.values())
    origins = dict.fromkeys(str(each.attrs["source"]) for each in every)
    known = {key: each.attrs[key] for each in every for key in ORIGIN if key in each.attrs}
    dataset.attrs = {"title": title, "source": "; ".join(origins)} | known
    return dataset


def scene_of(dataset: xr.Dataset, effects: str, rod_length: float | xr.DataArray) -> Scene:
    """Slider of a dataset over the grid with one or several rod lengths, under infinite friction."""
    part = parameters_of(dataset)
    return Scene(
        slider=part.ring(rod_length), contact=InfiniteFriction(), effects=part.effects(effects)
    )


def rod_angle(dataset: xr.Dataset) -> float:
    """Rod angle of the study, degrees, at which a dataset over rod angles is cut."""
    return float(parameters_of(dataset).slider.rod_angle)


def radius(dataset: xr.Dataset) -> xr.Variable:
    """Radius of the ring for which a dataset over the grid was computed."""
    return named((), parameters_of(dataset).slider.radius, "length", "radius of the ring")


def crosses(data: xr.Dataset, rod_length: float) -> bool:
    """Whether a ring on a rod of this length crosses the fence, which then passes above the ring."""
    height = float(rod_length) * np.sin(np.deg2rad(float(data["rod_angle"])))
    return bool(height < float(data["radius"]))


def several(given: Any) -> tuple[float, ...]:
    """Values of an entry, which can be a single value."""
    return given if isinstance(given, tuple) else (given,)


# -- captions ----------------------------------------------------------------------------------------


def physics(data: xr.Dataset) -> dict[str, Any]:
    """Quantities on which a figure depends: those of its sources, and its own variables."""
    found: dict[str, Any] = {}
    for text in (data.attrs[key] for key in ORIGIN[:2] if key in data.attrs):
        given = json.loads(text)
        entry = given.get("scene", given)
        found |= given.get("figures", {}) | dict(entry.get("slider", {}))
        found |= entry.get("contact", {})
        for part in (
            *entry.get("effects", []),
            *(v for v in entry.values() if isinstance(v, dict)),
        ):
            found |= {
                name: part[name] for name in ("weight", "mass", "gyration_radius") if name in part
            }
    if found.get("law") in ("infinite_friction", "perfectly_rough"):
        found["friction_coefficient"] = np.inf
    own = {str(name): data[name].values for name in data.variables if str(name) in SYMBOLS}
    return found | own


def values(data: xr.Dataset, *names: str) -> str:
    """Values of quantities for a caption, such as "l = 3, ψ = 45°"."""
    found = physics(data)
    return ", ".join(
        f"{SYMBOLS[name][0]} = {_text(found[name], SYMBOLS[name][1])}" for name in names
    )


def _text(given: Any, sign: str) -> str:
    every = [f"{number(float(each))}{sign}" for each in np.atleast_1d(np.asarray(given, float))]
    return every[0] if len(every) == 1 else f"{', '.join(every[:-1])} and {every[-1]}"


def number(value: float, digits: int = 6) -> str:
    """Number as text, with signs for infinity and minus."""
    if np.isinf(value):
        return "∞" if value > 0 else "−∞"
    return f"{value:.{digits}g}".replace("-", "−")


def mathematical(value: float) -> str:
    """Number as mathematical text of a label, with a sign for infinity."""
    return r"\infty" if np.isinf(value) else f"{value:g}"


def degrees(angle: float) -> str:
    """Angle as mathematical text, to a tenth of a degree."""
    return rf"${angle:.1f}^\circ$"
