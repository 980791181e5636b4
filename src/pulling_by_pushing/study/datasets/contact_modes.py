"""Consistent solutions over effects, contact law, rod length and pusher motion (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import (
    ContactLaw,
    Coulomb,
    PerfectlyRough,
    friction_coefficient,
)
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import SOLUTIONS, solve
from pulling_by_pushing.study.datasets.base import (
    axis,
    friction_angle,
    labeled_radians,
    objects,
    over_effects,
)
from pulling_by_pushing.study.model import Part, labeled_law

#: Entries along `solution`, the same number for every set of effects; and the values of entries after the
#: last solution, where numbers are NaN.
SOLUTION_ENTRIES = np.arange(max(SOLUTIONS.values()))
FILL = {"mode": -1, "pivot": -1, "consistent": False, "continuum": False}


def coefficient(law: ContactLaw) -> float:
    """Friction coefficient of a law; NaN for perfect roughness, which is not a friction law."""
    return np.nan if isinstance(law, PerfectlyRough) else friction_coefficient(law)


def kind(law: ContactLaw) -> str:
    """Name of a law in scene files."""
    if isinstance(law, Coulomb):
        return "coulomb"
    return "perfectly_rough" if isinstance(law, PerfectlyRough) else "infinite_friction"


def contact_modes(part: Part) -> xr.Dataset:
    """Build the dataset for part of a study by `solve` on labeled arrays."""
    labels = part.grid["contact"]
    laws = list(map(labeled_law, labels))
    slider = part.ring(axis(part, "rod_length"))
    angle, magnitude = labeled_radians(axis(part, "pusher_angle")), axis(part, "pusher_magnitude")

    def solve_for(effects: tuple[Any, ...]) -> xr.Dataset:
        contact = objects("contact", labels, laws)
        scene = Scene(slider=slider, contact=contact, effects=effects)
        solutions = solve(scene, angle, magnitude)
        numbered = solutions.assign_coords(solution=np.arange(solutions.sizes["solution"]))
        return numbered.reindex(solution=SOLUTION_ENTRIES, fill_value=FILL).drop_vars("solution")

    return over_effects(part, solve_for).assign_coords(law_coordinates(laws))


def law_coordinates(laws: Sequence[ContactLaw]) -> dict[str, tuple[str, Any]]:
    """Coordinates along `contact`: type, friction coefficient and friction angle of each law."""
    coefficients = list(map(coefficient, laws))
    return {
        "law": ("contact", list(map(kind, laws))),
        "friction_coefficient": ("contact", coefficients),
        "friction_angle": ("contact", friction_angle(coefficients)),
    }
