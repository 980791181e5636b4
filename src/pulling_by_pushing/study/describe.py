"""Attributes of datasets: units and names of their variables, title, source and provenance."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactLaw, friction_coefficient
from planar_pushing.mechanics.entries import to_json, versions
from planar_pushing.mechanics.kernels.arrays import flag_attributes
from planar_pushing.mechanics.scene import Scene
from planar_pushing.scenes.fields import FileModel
from planar_pushing.terms.options import BEHIND, FLAGS
from planar_pushing.terms.quantities import (
    DATASET,
    GLOBAL,
    NOTES,
    PAPER,
    SLIDERS,
    SLIDERS_NOTES,
    Quantities,
    attributes,
)
from pulling_by_pushing.study.catalog import DATASETS, EVIDENCE
from pulling_by_pushing.study.model import Part
from pulling_by_pushing.study.quantities import MODELS


def describe(
    dataset: xr.Dataset,
    *,
    title: str,
    source: str,
    parameters: object,
    quantities: Quantities = DATASET,
    notes: Mapping[str, str] = NOTES,
) -> xr.Dataset:
    """Add units and names to the variables, and title, source and provenance to the dataset."""
    for name, variable in dataset.variables.items():
        variable.attrs = dict(attributes(quantities, str(name)))
        flags = FLAGS.get(str(name))
        if flags and variable.dtype.kind == "i":
            variable.attrs |= flag_attributes(flags, variable.dtype)
            if "solution" in variable.dims and "solutions" in dataset:
                variable.attrs["comment"] = BEHIND
        if name == "modes":
            masks = np.array([1 << mode for mode in FLAGS["mode"].values()], variable.dtype)
            variable.attrs |= {"flag_masks": masks, "flag_meanings": " ".join(FLAGS["mode"])}
    dataset.attrs = {
        "title": title,
        "source": f"{PAPER}, {source}",
        **GLOBAL,
        "parameters": to_json(parameters),
        "unit_notes": to_json(dict(notes)),
        "versions": versions(),
    }
    return dataset


def apply_declaration(dataset: xr.Dataset, name: str, part: Part | FileModel) -> xr.Dataset:
    """Order a dataset as declared, and add the attributes that its declaration defines."""
    entry = DATASETS[name]
    order = [*entry.dims, *entry.inner]
    ordered = dataset[list(entry.variables)].transpose(*order, missing_dims="ignore")
    coords = sorted(map(str, ordered.coords), key=lambda coord: (_position(order, coord), coord))
    variables = {
        variable: ordered[variable].variable for variable in entry.variables
    }  # without coordinates
    ordered = xr.Dataset(variables, {coord: ordered.coords[coord].variable for coord in coords})
    title = f"{entry.about[0].upper()}{entry.about[1:]}"
    if not isinstance(part, Part):
        parameters = part.model_dump(exclude_none=True)
        return describe(ordered, title=title, source=entry.source, parameters=parameters,
                        quantities=MODELS, notes={})  # fmt: skip
    support = "support" in entry.dims
    if entry.rod or not support:
        ordered = ordered.assign_coords(_scalars(part, (*entry.dims, *coords)))
    return describe(
        ordered,
        title=title,
        source=entry.source,
        parameters=_parameters(part, entry.dims),
        quantities=SLIDERS if support else DATASET,
        notes=SLIDERS_NOTES if support else NOTES,
    )


def _position(order: list[str], name: str) -> int:
    return order.index(name) if name in order else len(order)


def _parameters(part: Part, dims: tuple[str, ...]) -> dict[str, object]:
    """Parameters of a study that are not axes."""
    if "support" in dims:
        entries = part.supports.items()
        return {"supports": {name: entry.model_dump(exclude_none=True) for name, entry in entries}}
    slider = part.slider.model_dump(exclude_none=True, exclude=set(dims))
    return {"slider": slider, **part.parts}


def _scalars(part: Part, dims: tuple[str, ...]) -> dict[str, float]:
    """Scalar coordinates: the parameters of slider and effects that are not axes."""
    groups = (part.slider, *part.parts.values())
    values = {name: value for group in groups for name, value in group}
    return {name: value for name, value in values.items() if value is not None and name not in dims}


def scene_scalars(scene: Scene) -> dict[str, float]:
    """Parameters of a scene, which its log and its dataset have as scalars."""
    slider = scene.slider
    scalars = {"rod_length": float(slider.rod_length), "radius": float(slider.radius)}
    scalars["friction_coefficient"] = friction_coefficient(cast(ContactLaw, scene.contact))
    for effect in scene.effects:
        for name in ("weight", "mass", "gyration_radius"):
            if hasattr(effect, name):
                scalars[name] = float(getattr(effect, name))
    return scalars


def add_study_attributes(
    built: xr.Dataset | dict[str, xr.Dataset], name: str, study: Mapping[str, str]
) -> xr.Dataset | dict[str, xr.Dataset]:
    """Name the study and the conventions in a dataset, or in each group and their root.

    Parameters
    ----------
    built : xarray.Dataset or dict of them
        A dataset, or one for each group.
    name : str
        Name of the dataset, which provides the title for a dataset without one.
    study : mapping
        Attributes from `provenance` that name the study.
    """
    marks: dict[str, Any] = {**GLOBAL, **study}
    title = DATASETS[name].about if name in DATASETS else EVIDENCE.get(name, name)
    if isinstance(built, xr.Dataset):
        return built.assign_attrs({"title": title} | built.attrs | marks)
    groups = {
        part: dataset.assign_attrs({"title": f"{title}: {part}"} | dataset.attrs | marks)
        for part, dataset in built.items()
    }
    return {"/": xr.Dataset(attrs={"title": title} | marks)} | groups
