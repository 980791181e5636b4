"""Code shared by figures of sliders: supports of a dataset, the reference ring, and scenes."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any, cast

import numpy as np
import xarray as xr
from pydantic import TypeAdapter

from planar_pushing.mechanics.contact import ContactLaw, ContactMode, PerfectlyRough
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.solve import solve
from planar_pushing.mechanics.supports import Composite, Points, Ring, Segment
from planar_pushing.scenes.support_model import SupportEntry
from pulling_by_pushing.figures.figure import Settings
from pulling_by_pushing.figures.parts.data import named
from pulling_by_pushing.study.datasets.base import support_axis

SECTION = "Ours, any slider"


def supports(dataset: xr.Dataset) -> dict[str, Any]:
    """Supports described by a dataset, by name."""
    entry: TypeAdapter[Any] = TypeAdapter(SupportEntry)
    texts = dict(zip(dataset.support.values, dataset.description.values, strict=True))
    return {
        str(name): entry.validate_python(json.loads(str(text))).build()
        for name, text in texts.items()
    }


def ring_beside(found: dict[str, Any]) -> Ring:
    """Reference ring, the paper's support, with the largest extent of the given supports."""
    return Ring(max(float(each.extent) for each in found.values()))


def is_area(support: Any) -> bool:
    """Whether a support presses on an area, not only on points and lines."""
    if isinstance(support, Composite):
        return any(is_area(member) for _, member in support.members)
    return not isinstance(support, (Ring, Points, Segment))


def families(found: dict[str, Any]) -> tuple[list[str], list[str]]:
    """Names of the supports on areas, and of those on points and lines, without the ring."""
    ring = ring_beside(found)
    others = [name for name, support in found.items() if support != ring]
    areas = [name for name in others if is_area(found[name])]
    return areas, [name for name in others if name not in areas]


def scene(found: dict[str, Any], length: Any, angle: Any, contact: ContactLaw) -> Scene:
    """Scenes of supports with rods of these lengths and angles in degrees."""
    return Scene(
        slider=Slider(rod_length=length, rod_angle=np.deg2rad(angle)),
        contact=contact,
        effects=(SupportFriction(support=support_axis(found)),),
    )


def limit_forces(scenes: Scene, angles: Array) -> tuple[Array, Array]:
    """Limit curves at force angles in degrees: forces, shape (support, angle, xy), and pivots."""
    phi = xr.DataArray(np.deg2rad(angles), dims="force_angle")
    curve = limit_curve(scenes, phi).transpose("support", "force_angle")
    pivot = sustaining(scenes, curve.motion_angle)[2].transpose("support", "force_angle")
    return curve.magnitude.values[..., None] * direction(phi.values), pivot.values.astype(np.int16)


def flat_parts(pivots: Array) -> list[tuple[int, slice]]:
    """Number of the support point, and slice of the curve, for every flat."""
    starts = np.flatnonzero(np.diff(pivots, prepend=-2))
    ends = [*starts[1:], len(pivots)]
    return [
        (int(pivots[start]), slice(int(start), int(stop)))
        for start, stop in zip(starts, ends, strict=True)
        if pivots[start] >= 0
    ]


def sustaining(scenes: Scene, motion: Any) -> tuple[xr.DataArray, xr.DataArray, xr.DataArray]:
    """Smallest and largest angle from a motion to the forces that sustain it, and its pivot.

    The two angles differ if the slider pivots. A perfectly rough contact sticks in every motion.
    """
    angle = xr.DataArray(motion)
    heading = xr.DataArray(direction(angle.values), dims=(*angle.dims, "xy"))
    found = solve(replace(scenes, contact=PerfectlyRough()), angle)
    sticks = found["mode"] == int(ContactMode.STICK)
    ends = [_between(heading, found[name]).where(sticks) for name in ("force", "force_end")]
    both, every = xr.concat(ends, "end"), ("end", "solution")
    return both.min(every), both.max(every), found.pivot.max("solution")


def _between(heading: xr.DataArray, force: xr.DataArray) -> xr.DataArray:
    """Angle from a heading to a force, radians in (-pi, pi]."""
    (c, s), (x, y) = ([each.isel(xy=i, drop=True) for i in (0, 1)] for each in (heading, force))
    return cast(xr.DataArray, np.arctan2(c * y - s * x, c * x + s * y))


def described_supports(grid: xr.Dataset, rod: Settings) -> xr.Dataset:
    """Variables of a figure that describe the supports, and the rod unless it is an axis."""
    data = grid[["extent"]]
    text = "rod length, from the contact to the slider's center"
    data["rod_length"] = named((), rod.rod_length, "length", text)
    data["rod_angle"] = named((), rod.rod_angle, "degree", "rod angle")
    data["ring_extent"] = named(
        (), ring_beside(supports(grid)).extent, "length", "radius of the ring beside the supports"
    )
    return data
