"""Consistent contact modes over effects, contact law, rod length and pusher motion (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.mechanics.contact import (
    ContactLaw,
    ContactMode,
    Coulomb,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.study import catalog
from planar_pushing.study.datasets.base import (
    angles_of,
    axis,
    friction_angle,
    law_axis,
    over_effects,
    parameters,
)
from planar_pushing.study.describe import describe
from planar_pushing.study.files.models import StudyFile

INNER = ("contact", "rod_length", "pusher_magnitude", "pusher_angle")
VALUES = ("spin_ratio", "force_angle", "spin_ratio_fast", "force_angle_fast")
#: What a value of a mode without a solution, or without a force, is.
COMMENT = "NaN where the mode is not consistent; 0 for SEPARATE, which has neither force nor motion"
Found = npt.NDArray[np.bool_]


def contacts(study: StudyFile) -> dict[str, tuple[str, ContactLaw]]:
    """Label: (type, law) along the contact axis; the label holds the coefficient of friction."""
    coefficients = study.grid.contact_friction_coefficient
    laws: list[tuple[str, ContactLaw]] = [
        *(("coulomb", Coulomb(mu)) for mu in coefficients),
        ("infinite_friction", InfiniteFriction()),
        ("infinite_friction", InfiniteFriction("none")),
        ("perfectly_rough", PerfectlyRough()),
    ]
    return dict(zip(catalog.contact_labels(coefficients), laws, strict=True))


def coefficient(law: ContactLaw) -> float:
    """Coefficient of friction of a law; perfect roughness is none of friction, and has NaN."""
    return np.nan if isinstance(law, PerfectlyRough) else friction_coefficient(law)


def _extremes(found: xr.Dataset, radius: float) -> dict[str, npt.NDArray[Any]]:
    """How many solutions each mode has, and spin ratio and force angle of its slowest and fastest motion.

    NaN where there is none; zero at rest, which has no force. Shape S + (modes,).
    """
    filled = found.isel(solution=slice(max(int(found.solutions.max()), 1)))
    filled = filled.transpose("xy", "twist_component", "solution", ...)
    # One after another in memory: they are read many times.
    mode, twist, force, spin_ratio = (
        np.ascontiguousarray(filled[name].values)
        for name in ("mode", "twist", "force", "spin_ratio")
    )
    speed = np.sqrt(twist[0] ** 2 + twist[1] ** 2 + (radius * twist[2]) ** 2)
    values = {"spin_ratio": spin_ratio, "force_angle": angles_of(np.moveaxis(force, 0, -1))}
    modes = [_of_mode(mode == int(each), speed, values) for each in ContactMode]
    rest = np.where(modes[ContactMode.SEPARATE]["consistent"] > 0, 0.0, np.nan)
    modes[ContactMode.SEPARATE] |= dict.fromkeys(VALUES, rest)
    return {name: np.stack([each[name] for each in modes], axis=-1) for name in modes[0]}


def _of_mode(here: Found, speed: Array, values: dict[str, Array]) -> dict[str, npt.NDArray[Any]]:
    """Number of a mode's solutions, and what its slowest and its fastest have."""
    slow, fast = np.where(here, speed, np.inf), np.where(here, speed, -np.inf)
    ends = {"": here & (slow == slow.min(axis=0)), "_fast": here & (fast == fast.max(axis=0))}
    picked = {
        name + end: _first(chosen, value)
        for end, chosen in ends.items()
        for name, value in values.items()
    }
    return {"consistent": here.sum(axis=0, dtype=np.int8)} | picked


def _first(chosen: Found, values: Array) -> Array:
    """The first chosen value along the first axis; NaN where none is."""
    found = np.full(values.shape[1:], np.nan)
    for here, value in zip(chosen[::-1], values[::-1], strict=True):
        np.copyto(found, value, where=here)
    return found


def build(study: StudyFile, contact: Collection[str] | None = None) -> xr.Dataset:
    """Build the dataset of a study, or its part with these labels along the axis `contact`."""
    laws = {
        label: law for label, law in contacts(study).items() if contact is None or label in contact
    }
    along = law_axis("contact", list(laws), [law for _, law in laws.values()])
    slider = study.ring(axis(study, "rod_length"))
    angle, magnitude = np.deg2rad(axis(study, "pusher_angle")), axis(study, "pusher_magnitude")

    def part(effects: tuple[Any, ...]) -> xr.Dataset:
        found = solve(Scene(slider=slider, contact=along, effects=effects), angle, magnitude)
        found = found.transpose(*INNER, ...)
        extremes = _extremes(found, slider.radius)
        variables: dict[str, Any] = {
            "consistent": ((*INNER, "mode"), extremes.pop("consistent")),
            "outcome": (INNER, found.outcome.values),
        }
        variables |= {name: ((*INNER, "mode"), value) for name, value in extremes.items()}
        return xr.Dataset(variables, {name: found[name] for name in INNER})

    coefficients = [coefficient(law) for _, law in laws.values()]
    dataset = over_effects(study, part).assign_coords(
        mode=[mode.name for mode in ContactMode],
        law=("contact", [kind for kind, _ in laws.values()]),
        friction_coefficient=("contact", coefficients),
        friction_angle=("contact", friction_angle(coefficients)),
    )
    described = describe(
        dataset,
        title="Consistent contact modes: none, one or several for each pusher motion",
        source="Secs. 2, 3.2, 4 and 5",
        parameters=parameters(study),
    )
    for name in VALUES:
        described[name].attrs["comment"] = COMMENT
    return described
