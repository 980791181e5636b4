"""A scene and its push, from the attributes of its dataset."""

from __future__ import annotations

import json
import math
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import Doubled, doubled
from planar_pushing.evidence.golden.residual.motion import Line, Slider, edge
from planar_pushing.terms.options import EFFECT_TYPES, STUDIED, EffectKind


class Scene(NamedTuple):
    """Slider, effects, contact and push; lengths in units of R, angles in degrees.

    Attributes
    ----------
    radius : float
        The unit of the lengths.
    edges : dict
        Directions of the edges of the friction cone by the side, 1 for the right and -1 for the left one.
    force_angle : float, optional
        Force angle under which the fence moves as the slider does.
    """

    slider: Slider
    effects: str
    radius: float
    length: float
    rod_angle: float
    edges: dict[int, tuple[Doubled, Doubled]]
    pusher_angle: float | None
    force_angle: float | None
    magnitude: float

    def line(self, side: int) -> Line:
        """Line of force on an edge of the friction cone."""
        x, y = self.edges[side]
        cosine, sine = cosine_sine(radians(self.rod_angle))
        return Line(x * cosine + y * sine, x * sine - y * cosine)


def read(dataset: xr.Dataset) -> Scene:
    """The scene that a dataset holds."""
    given = json.loads(dataset.attrs["parameters"])
    slider, contact, push = given["scene"]["slider"], given["scene"]["contact"], given["push"]
    # A file may leave it out; the dataset, where it is compared exactly, does not.
    radius = float(dataset["radius"])
    found = {EFFECT_TYPES[each["type"]]: each for each in given["scene"]["effects"]}
    weight = sum(each.get("weight", 0.0) for each in given["scene"]["effects"])
    inertia = found.get(EffectKind.INERTIA, {"mass": 0.0, "gyration_radius": radius})
    return Scene(
        Slider(weight, inertia["mass"], (inertia["gyration_radius"] / radius) ** 2),
        "+".join(kind for kind in STUDIED if kind in found),
        radius, slider["rod_length"] / radius, slider["rod_angle"],
        {side: _edge(contact, side) for side in (1, -1)},
        push["pusher_angle"], push["force_angle"], push["pusher_magnitude"],
    )  # fmt: skip


def _edge(contact: dict[str, Any], side: int) -> tuple[Doubled, Doubled]:
    """Edge of the friction cone; a perfectly rough contact transmits every force."""
    if contact["law"] == "perfectly_rough":
        return doubled(0.0), doubled(-1.0)
    return edge(np.float64(contact.get("friction_coefficient", math.inf)), side)
