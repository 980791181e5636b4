"""What a study says of its datasets without computing them: variables, labels, axes and attributes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import xarray as xr

from planar_pushing.evidence.golden.rules import RESIDUALS, RULES, Rule
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import AXES, SLIDERS_AXES
from planar_pushing.study.describe import of_study
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.sliders_model import Study
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.terms.options import Method

#: The axis of which a builder chooses a part itself: a single value might be outside.
WHOLE = "force_angle"
#: Relative difference between values that are computed anew on another machine.
ANEW = 1e-12


@dataclass(frozen=True, slots=True, kw_only=True)
class Expectation:
    """What a dataset must be.

    Attributes
    ----------
    structure : xarray.Dataset
        Its variables, dimensions, types and attributes; its values where a rule compares them.
    axes : dict of DataArray
        Coordinates of which the structure has a part only.
    rules : dict of Rule
        By variable.
    residuals : callable
        Puts the values into their equations.
    slack : dict of float
        Relative differences that values compared exactly may have all the same.
    """

    structure: xr.Dataset
    axes: dict[str, xr.DataArray] = field(default_factory=dict)
    rules: dict[str, Rule]
    residuals: Callable[[xr.Dataset], Any] = lambda _: ()
    slack: dict[str, float] = field(default_factory=dict)

    @property
    def coords(self) -> dict[str, xr.DataArray]:
        """Every coordinate, whole."""
        return {str(name): each for name, each in self.structure.coords.items()} | self.axes


#: Expectations of the groups of a file; a file without groups has one without a name.
Groups = dict[str, Expectation]


def _expectation(family: str, study: Study, **parts: Any) -> Expectation:
    def residuals(dataset: xr.Dataset) -> Any:
        return RESIDUALS[family](dataset, study)

    return Expectation(rules=RULES[family], residuals=residuals, **parts)


def grid_expectation(name: str, study: Study) -> Expectation:
    """Expectation of a dataset over a grid, built axis by axis with one value of all others."""
    values = study_slice(study, name)
    axes: dict[str, xr.DataArray] = {}
    for axis in (AXES | SLIDERS_AXES)[name]:
        built: Any = build_dataset(name, values | {"grid": _narrowed(values["grid"], axis)})
        for key, each in built.coords.items():
            axes[str(key)] = max(axes.get(str(key), each), each, key=lambda coord: coord.size)
    return _expectation(name, study, structure=built, axes=axes)


def _narrowed(grid: dict[str, list[Any]], axis: str) -> dict[str, list[Any]]:
    """The grid with one value of every other axis."""
    return {key: each if key in (axis, WHOLE) else each[:1] for key, each in grid.items()}


def scene_expectations(study: StudyFile) -> dict[str, Expectation]:
    """Expectation of each scene, by name; the equations are those of a ring, others are computed anew."""
    built: Any = build_dataset("scenes", study_slice(study, "scenes"))
    rings = {
        name for name, push in study.scenes.items() if load_scene_file(push.file).build().isotropic
    }
    return {
        name: _expectation("scenes", study, structure=each)
        if name in rings
        else derived_expectation(each)
        for name, each in built.items()
    }


def simulation_expectation(name: str, study: Study) -> Expectation:
    """Expectation of a simulation, from a run of its scene.

    Time stepping meets the force law on average over a step alone, and the equations are those of a
    ring about the center of mass under a fence: other logs are computed anew.
    """
    file = load_scene_file(study.simulations[name])
    log = simulate_file(file)
    fence = "pusher_shape" not in log.attrs
    if log.attrs["method"] == Method.TIME_STEPPING or not (fence and file.build().isotropic):
        return derived_expectation(log)
    # Events are located to the tolerance of the run, by arithmetic that may differ in its last bits.
    return _expectation("simulations", study, structure=log, slack={"time": log.attrs["rtol"]})


def derived_expectation(dataset: xr.Dataset) -> Expectation:
    """Expectation of a dataset that is computed anew."""
    names = [str(name) for name in dataset.data_vars]
    floats = [name for name in names if dataset[name].dtype.kind == "f"]
    return Expectation(
        structure=dataset,
        rules=dict.fromkeys(names, Rule.DERIVED),
        slack=dict.fromkeys(floats, ANEW),
    )


def in_study(found: Groups, title: str, marks: Mapping[str, str]) -> Groups:
    """The expectations with what every file, and every group in it, says of its study."""
    structures = {name: each.structure for name, each in found.items()}
    built = of_study(structures.get("", structures), title, marks)
    if isinstance(built, xr.Dataset):
        return {"": replace(found[""], structure=built)}
    above = {"": derived_expectation(built.pop("/"))}
    return above | {name: replace(found[name], structure=each) for name, each in built.items()}
