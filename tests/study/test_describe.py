"""What a dataset says of itself: units, names, flags and provenance."""

import json

import planar_pushing as pp
from planar_pushing.study.catalog import DIMS
from planar_pushing.study.store import group_names
from planar_pushing.terms.quantities import DATASET


def every(results):
    for name in DIMS:
        yield name, pp.open_dataset(name, results)
    for group in group_names(results / "data/scenes.nc"):
        yield f"scenes/{group}", pp.open_dataset(f"scenes/{group}", results)


def test_every_variable_has_its_unit_and_name(results):
    for name, dataset in every(results):
        for key, variable in dataset.variables.items():
            described = variable.attrs["units"], variable.attrs["long_name"]
            assert described == DATASET[key], f"{name}: {key}"


def test_provenance(results):
    for name, dataset in every(results):
        assert set(dataset.attrs) >= {"title", "source", "parameters", "versions"}, name
        assert "Sec" in dataset.attrs["source"]
        assert json.loads(dataset.attrs["parameters"])
        assert "numpy" in json.loads(dataset.attrs["versions"])


def test_flags_follow_cf(results):
    outcome = pp.open_dataset("contact_modes", results).outcome
    assert list(outcome.attrs["flag_values"]) == [0, 1, 2]
    assert outcome.attrs["flag_meanings"] == "INCONSISTENT UNIQUE AMBIGUOUS"
