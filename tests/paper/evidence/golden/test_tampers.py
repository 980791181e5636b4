"""Random changes of stored results are seen: 999 of 1000 of a number by 1e-9 of itself, and others."""

import numpy as np
import pytest
from evidence.golden.goldens import dataset_name, golden, names, result

from pulling_by_pushing.evidence.golden.compare import compare, load_tolerances

CHANGE = 1e-9
#: Errors of methods, of rounding and of models, which are compared to their size.
ERRORS = ("accuracy", "hard_cases", "model_errors", "model_estimates")


@pytest.fixture(scope="module")
def pairs():
    tolerances = load_tolerances()
    return [
        (dataset_name(file), result(golden(file, group)), golden(file, group), tolerances)
        for file, group in names()
    ]


def is_seen(pair, changed):
    name, _, wanted, tolerances = pair
    return not all(each.passes for each in compare(name, changed, wanted, tolerances))


def test_what_is_unchanged_passes(pairs):
    for name, found, wanted, tolerances in pairs:
        checks = compare(name, found, wanted, tolerances)
        assert all(each.passes for each in checks), [each for each in checks if not each.passes]


@pytest.mark.parametrize("count", [200, pytest.param(1000, marks=pytest.mark.slow)])
def test_changes_of_numbers_are_seen(pairs, count):
    random = np.random.default_rng(13)
    places = [
        (pair, str(name))
        for pair in pairs
        if pair[0] not in ERRORS
        for name, each in pair[1].variables.items()
        if each.dtype.kind == "f" and (np.isfinite(each.values) & (each.values != 0)).any()
    ]
    seen = 0
    for _ in range(count):
        pair, name = places[random.integers(len(places))]
        values = pair[1][name].values.copy()
        at = random.choice(np.flatnonzero(np.isfinite(values) & (values != 0)))
        values.flat[at] *= 1 + CHANGE
        one = pair[1][[]].assign({name: (pair[1][name].dims, values, pair[1][name].attrs)})
        seen += is_seen((pair[0], None, pair[2][_alone(pair[2], name)], pair[3]), one)
    assert seen >= 0.999 * count


def _alone(wanted, name):
    """A variable of a golden file with its radii."""
    return [each for each in (name, f"{name}_radius") if each in wanted.variables]


@pytest.mark.parametrize("kind", ["f", "i", "b", "U"])
def test_changes_of_one_entry_are_seen(pairs, kind):
    random = np.random.default_rng(5)
    for pair in pairs:
        for name, each in pair[1].variables.items():
            if each.dtype.kind.replace("O", "U") != kind or not each.size:
                continue
            values = np.array(each.values)
            at = np.unravel_index(random.integers(each.size), each.shape)
            values[at] = {"f": np.nan, "i": 77, "b": not values[at], "U": "other"}[kind]
            if np.array_equal(values, each.values, equal_nan=kind == "f"):
                continue
            changed = pair[1].copy()
            changed[name] = (each.dims, values, each.attrs)
            assert is_seen(pair, changed), f"{pair[0]}: {name} at {at}"
            break


@pytest.mark.parametrize("file", ["contact_modes", "sliders/support_modes"])
@pytest.mark.parametrize("change", [-1, 1], ids=["missing", "extra"])
def test_a_missing_mode_and_an_extra_one_are_seen(file, change):
    wanted, tolerances = golden(file), load_tolerances()
    counts, modes = wanted["solutions"].values, wanted["mode"].values.copy()
    places = np.argwhere((counts > 0) & (counts < modes.shape[-1]))
    at = tuple(np.random.default_rng(3).choice(places))
    last = counts[at] - (change < 0)
    modes[(*at, last)] = -1 if change < 0 else 3
    variables = wanted[["mode", *(name for name in wanted.coords)]]
    changed = result(variables).assign(mode=(wanted["mode"].dims, modes, wanted["mode"].attrs))
    checks = compare(dataset_name(file), changed, variables, tolerances)
    assert [(check.variable, check.failed) for check in checks if not check.passes] == [("mode", 1)]
