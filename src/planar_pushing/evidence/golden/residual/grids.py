"""What the grids share: coordinates along their dimensions, and a part for each set of effects."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.numbers import Floats
from planar_pushing.evidence.golden.residual.finding import Finding
from planar_pushing.evidence.golden.residual.motion import Slider
from planar_pushing.study.files.study_model import StudyFile

#: Findings of the part of a dataset with one set of effects.
Part = Callable[[xr.Dataset, str, Slider, StudyFile], Iterable[Finding]]


def slider_of(study: StudyFile) -> Slider:
    """The study's slider; 1 for a parameter of an effect that the study does not have."""
    friction, inertia = study.support_friction, study.inertia
    gyration = inertia.gyration_radius / study.slider.radius if inertia else 1.0
    return Slider(
        friction.weight if friction else 1.0, inertia.mass if inertia else 1.0, gyration**2
    )


def along(dataset: xr.Dataset, *dims: str) -> list[Floats]:
    """The coordinate along each dimension, in a shape that broadcasts over them."""
    return list(np.meshgrid(*(dataset[dim].values for dim in dims), indexing="ij", sparse=True))


def over_effects(part: Part, dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of the parts joined along the first dimension, `effects`."""
    found: dict[str, list[Finding]] = {}
    for effects in dataset["effects"].values:
        for each in part(dataset.sel(effects=effects), str(effects), slider_of(study), study):
            found.setdefault(each.variable, []).append(each)
    for name, parts in found.items():
        shape = dataset[name].shape[1:]
        yield Finding(name, *(_stacked(parts, place, shape) for place in (1, 2)))


def _stacked(found: list[Finding], place: int, shape: tuple[int, ...]) -> Any:
    return np.stack([np.broadcast_to(each[place], shape) for each in found])
