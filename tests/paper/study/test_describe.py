"""Attributes of datasets: units, names, flags and provenance."""

import json

import numpy as np
import xarray as xr
from study.conftest import OF_PAPER, OF_SLIDERS, SMOKE

import planar_pushing as pp
from planar_pushing.terms import quantities
from planar_pushing.terms.netcdf import read_attributes
from planar_pushing.terms.quantities import DATASET, unit_of
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.describe import add_study_attributes
from pulling_by_pushing.study.study_file import load_study


def test_every_variable_has_its_unit_and_name(every):
    for name, dataset in every:
        for key, variable in dataset.variables.items():
            described = unit_of(variable.attrs), variable.attrs["long_name"]
            assert described == DATASET[key], f"{name}: {key}"


def of_sliders(sliders):
    return {name: pp.open_dataset(name, sliders, study="sliders") for name in OF_SLIDERS}


def test_every_variable_of_a_study_of_sliders_has_its_unit_and_name(sliders):
    for name, dataset in of_sliders(sliders).items():
        for key, variable in dataset.variables.items():
            described = unit_of(variable.attrs), variable.attrs["long_name"]
            assert described == quantities.SLIDERS[key], f"{name}: {key}"
            units = variable.attrs.get("units")
            assert units in {"1", "degree"} or key in {"twist", "ellipsoid"}, f"{name}: {key}"


def test_a_study_of_sliders_names_itself_its_supports_and_the_paper(sliders):
    for name, dataset in of_sliders(sliders).items():
        assert dataset.attrs["study"] == "sliders_smoke", name
        assert "Sec" in dataset.attrs["source"]
        assert set(json.loads(dataset.attrs["parameters"])["supports"]) == {"ring", "box", "tripod"}
        assert json.loads(dataset.attrs["unit_notes"]) == quantities.SLIDERS_NOTES


def test_conventions_paper_licence_and_study(results, every):
    simulation = pp.open_dataset("simulations/slipping", results)
    whole = read_attributes(results / "data/scenes.nc")
    for attrs in (*(each.attrs for _, each in every), simulation.attrs, whole):
        assert attrs["Conventions"] == "CF-1.11"
        assert attrs["license"] == "MIT"
        assert "https://doi.org/10.1109/ROBOT.1993.292067" in attrs["references"]
        assert attrs["study"] == "smoke"
        assert attrs["study_digest"].startswith("sha256:")
        assert attrs["title"]


def test_a_parameter_is_no_axis(every):
    for name, dataset in every:
        if name in OF_PAPER:
            given = json.loads(dataset.attrs["parameters"])
            assert not set(given["slider"]) & set(dataset.dims), name
            assert ("rod_angle" in given["slider"]) != ("rod_angle" in dataset.dims), name


def test_angles_past_a_turn_say_that_they_are_unwrapped(every):
    for name, dataset in every:
        for key, variable in dataset.data_vars.items():
            if variable.attrs.get("units") == "degree" and np.abs(variable).max() > 360:
                assert "unwrapped" in variable.attrs["long_name"], f"{name}: {key}"


def test_groups_are_named_below_a_whole():
    built = add_study_attributes(
        {"one": xr.Dataset(), "two": xr.Dataset(attrs={"title": "own"})}, "x", {"study": "s"}
    )
    assert [built[name].attrs["title"] for name in ("/", "one", "two")] == ["x", "x: one", "own"]
    assert all(each.attrs["study"] == "s" for each in built.values())


def test_provenance(every):
    for name, dataset in every:
        assert set(dataset.attrs) >= {"title", "source", "parameters", "versions"}, name
        assert "Sec" in dataset.attrs["source"]
        assert json.loads(dataset.attrs["parameters"])
        assert "numpy" in json.loads(dataset.attrs["versions"])


def test_flags_follow_cf(results):
    outcome = pp.open_dataset("contact_modes", results).outcome
    assert list(outcome.attrs["flag_values"]) == [0, 1, 2]
    assert outcome.attrs["flag_values"].dtype == outcome.dtype
    assert outcome.attrs["flag_meanings"] == "INCONSISTENT UNIQUE AMBIGUOUS"


def test_parameters_that_are_no_axes_are_scalar_coordinates(every):
    study = load_study(SMOKE)
    groups = (study.slider, *study.parts.values())
    given = {name: value for group in groups for name, value in group if value is not None}
    for name, dataset in every:
        if name in OF_PAPER:
            scalars = {key: each.item() for key, each in dataset.coords.items() if not each.ndim}
            axes = DATASETS[name].dims
            assert scalars == {key: each for key, each in given.items() if key not in axes}, name


def test_a_dataset_has_the_order_and_the_title_of_its_declaration(every):
    for name, dataset in every:
        if name in OF_PAPER:
            entry = DATASETS[name]
            assert list(dataset.data_vars) == list(entry.variables)
            assert [each for each in dataset.coords if each in entry.dims] == list(entry.dims)
            assert dataset.attrs["title"].lower() == entry.about.lower()
