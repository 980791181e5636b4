"""Comparisons over several divisions of pushes into halves, and intervals from resampled pushes."""

from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import xarray as xr
from pushes.test_quartic import random_pairs
from pushes.written import TRIANGLE, feet

import planar_pushing as pp
from planar_pushing.pushes.fit.quartic import quartic_tensor
from planar_pushing.pushes.fit.statistics import split_statistics, statistics
from planar_pushing.pushes.halves import FEWEST, divide, divide_resamples, process_pool

NOISE = (0.5, 0.3, 0.05)
QUICK = ["known_feet", "uniform"]
SPLITS = 3


@pytest.fixture(scope="module")
def pushes():
    return pp.simulate_pushes(feet(), TRIANGLE, 24, noise=NOISE, seed=6)


@pytest.fixture(scope="module")
def several(pushes):
    return pp.compare(pushes, QUICK, splits=SPLITS, seed=3)


# -- divisions ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [8, 9, 50])
def test_a_division_fits_and_scores_each_push_once(count):
    divisions = divide(count, 20, seed=1)
    for one, other in divisions:
        assert sorted([*one.fit, *one.score]) == list(range(count))
        assert one.fit.tolist() == other.score.tolist()
        assert one.score.tolist() == other.fit.tolist()
        assert abs(len(one.fit) - len(other.fit)) <= 1
    assert len({tuple(one.fit) for one, _ in divisions}) > 10


def test_a_push_that_is_drawn_twice_is_in_one_half():
    usable = np.arange(30) % 5 > 0
    drawn = np.zeros(30)
    for one, other in divide_resamples(usable, 200, [7]):
        assert not set(one.fit) & set(other.fit)
        assert one.score.tolist() == sorted(set(other.fit))
        assert other.score.tolist() == sorted(set(one.fit))
        assert len(one.fit) + len(other.fit) == 30
        assert all(usable[np.unique(half.fit)].sum() >= FEWEST for half in (one, other))
        drawn += np.bincount([*one.fit, *other.fit], minlength=30)
    # Each push is drawn once per resample on average, with a standard deviation of about 1 / sqrt(200).
    assert drawn / 200 == pytest.approx(1.0, abs=0.35)


def test_a_half_has_enough_different_pushes():
    """Of eight pushes, most draws have fewer than twice four different ones."""
    for folds in divide_resamples(np.ones(8, dtype=bool), 5, [0]):
        assert [len(fold.score) for fold in folds] == [4, 4]


# -- statistics --------------------------------------------------------------------------------------


def made_up(model, reference, draws=None):
    """Errors over (split, quantity, model, push) with those of two models, shape (splits, pushes)."""
    rows = np.stack([model, reference], axis=1)[:, None]
    if draws is not None:
        rows = np.where(draws[:, None, None] > 0, rows, np.nan)
    coords = {"quantity": ["motion"], "model": ["mine", "fitted_ellipsoid"]}
    return xr.DataArray(rows, coords, ("split", "quantity", "model", "push"))


def test_a_value_is_the_mean_over_splits_of_that_of_one_split():
    random = np.random.default_rng(2)
    errors = made_up(*random.uniform(1, 3, size=(2, 6, 40)))
    found = split_statistics(errors, errors, np.ones((6, 40), dtype=int))
    each = [statistics(one, resamples=2) for one in errors]
    for name in ("median", "percentile_90", "ratio", "ratio_90", "difference"):
        expected = np.mean([one[name].values for one in each], axis=0)
        assert found[name].values == pytest.approx(expected), name
    assert found["error"].values == pytest.approx(errors.values.mean(axis=0))


def test_a_push_counts_as_often_as_it_was_drawn():
    """Resampled errors with counts are those of the repeated pushes."""
    random = np.random.default_rng(3)
    model, reference = random.uniform(1, 3, size=(2, 40, 30))
    counts = np.array([np.bincount(random.integers(30, size=30), minlength=30) for _ in range(40)])
    found = split_statistics(made_up(model, reference), made_up(model, reference, counts), counts)
    mean = float(found["ratio"].sel(quantity="motion", model="mine"))
    ratios = [
        np.median(np.repeat(a, n)) / np.median(np.repeat(b, n))
        for a, b, n in zip(model, reference, counts, strict=True)
    ]
    centered = np.sort(np.array(ratios) * mean / np.mean(ratios))
    ends = found["ratio_interval"].sel(quantity="motion", model="mine").values
    # The 2.5th percentile of 40 results lies between the two smallest.
    assert centered[0] <= ends[0] <= centered[1]
    assert centered[-2] <= ends[1] <= centered[-1]
    reference_row = found.sel(quantity="motion", model="fitted_ellipsoid")
    assert reference_row["ratio_interval"].values.tolist() == [1.0, 1.0]


@pytest.mark.parametrize("shift", [0.0, 0.4])
def test_worse_fits_of_resamples_do_not_move_an_interval(shift):
    """A factor that all resamples share, for example of fits to fewer different pushes, drops out."""
    random = np.random.default_rng(4)
    model, reference = random.uniform(1, 3, size=(2, 50, 30))
    counts = np.ones((50, 30), dtype=int)
    plain = made_up(model, reference)
    found = split_statistics(plain, made_up(model * (1.0 + shift), reference), counts)
    same = split_statistics(plain, made_up(model, reference), counts)
    for name in ("ratio_interval", "median_interval", "ratio_90_interval"):
        np.testing.assert_allclose(found[name], same[name], err_msg=name)


@pytest.mark.parametrize("seed", [5, pytest.param(6, marks=pytest.mark.slow)])
def test_the_interval_contains_the_known_ratio_in_most_experiments(seed):
    """Errors of two models with a known ratio of medians, of pushes drawn from their population."""
    random, hits, experiments = np.random.default_rng(seed), 0, 40
    for _ in range(experiments):
        pool = random.exponential(size=(2, 60)) * np.array([[0.8], [1.0]])
        counts = np.array(
            [np.bincount(row, minlength=60) for row in random.integers(60, size=(50, 60))]
        )
        plain, again = (made_up(*np.repeat(pool[:, None], 50, axis=1)) for _ in range(2))
        found = split_statistics(plain, again.where(counts[:, None, None] > 0), counts)
        low, high = found["ratio_interval"].sel(quantity="motion", model="mine").values
        hits += low <= 0.8 <= high
    assert 0.86 <= hits / experiments <= 0.995


# -- comparisons -------------------------------------------------------------------------------------


def test_the_dataset(several, pushes):
    count = pushes.sizes["push"]
    assert dict(several.sizes) == {
        "quantity": 3, "model": 3, "push": count, "bound": 2, "object": 1, "split": SPLITS,
    }  # fmt: skip
    assert several.attrs["splits"] == SPLITS
    assert "resamples" not in several.attrs
    assert np.isfinite(several["split_error"]).all()
    assert several["draws"].sum("push").values.tolist() == [count] * SPLITS
    drawn = (several["draws"] > 0).broadcast_like(several["resampled_error"])
    assert (np.isfinite(several["resampled_error"]) == drawn).all()
    for name in ("split_error", "median", "difference_interval"):
        assert several[name].attrs["component_units"] == "error_unit"
    assert several["ratio_90_interval"].attrs["units"] == "1"


def test_the_first_split_is_the_single_one(several, pushes):
    alone = pp.compare(pushes, QUICK, seed=3)
    assert several["split_error"][0].values == pytest.approx(alone["error"].values, rel=1e-12)
    assert (several["split_error"][1] != several["split_error"][0]).any()
    # The true feet are the better model in every split; only the contact friction is fitted to them.
    ratio = several["ratio"].sel(quantity="motion", model="known_feet")
    assert float(several["ratio_interval"].sel(quantity="motion", model="known_feet")[1]) < 1.0
    assert float(ratio) < 0.7


def test_fits_to_resampled_pushes_are_those_to_the_repeated_pushes(several, pushes):
    """The known feet are not fitted, so their wrenches and motions are those of any other fit."""
    known = several.sel(model="known_feet", quantity=["wrench", "motion"])
    again, error = known["resampled_error"], known["error"]
    np.testing.assert_allclose(again, error.broadcast_like(again).where(known["draws"] > 0))
    fitted = several.sel(model="fitted_ellipsoid", quantity="motion")
    assert (np.abs(fitted["resampled_error"] - fitted["error"]) > 1e-3).any()


def test_workers_change_nothing(several, pushes):
    with ThreadPoolExecutor(2) as pool:
        threads = pp.compare(pushes, QUICK, splits=SPLITS, seed=3, workers=pool.map)
    xr.testing.assert_identical(threads, several)


@pytest.mark.slow
def test_processes_change_nothing(several, pushes):
    xr.testing.assert_identical(
        pp.compare(pushes, QUICK, splits=SPLITS, seed=3, workers=2), several
    )


def test_resamples_of_objects_are_independent(pushes):
    one = pushes.isel(push=slice(16))
    other = one.assign_coords(object=["other"]).assign(
        pushed=("push", ["other"] * 16, one["pushed"].attrs)
    )
    found = pp.compare(pp.concat_pushes([one, other]), ["known_feet"], splits=2)
    draws = found["draws"].values
    assert draws[:, :16].sum(axis=1).tolist() == draws[:, 16:].sum(axis=1).tolist() == [16, 16]
    assert (draws[:, :16] != draws[:, 16:]).any()
    errors = found["split_error"].values
    assert errors[..., :16] == pytest.approx(errors[..., 16:], rel=1e-12)


def test_repeated_pushes_are_in_one_part_of_cross_validation():
    """Otherwise an error of cross-validation would be one of a fit to the same pushes."""
    wrenches, twists = random_pairs(12, seed=2)
    order = np.random.default_rng(0).permutation(12)
    twice = np.repeat(order, 2)
    once = quartic_tensor(wrenches[order], twists[order])
    assert quartic_tensor(wrenches[twice], twists[twice]) == pytest.approx(once, abs=1e-6)


@pytest.mark.parametrize(("options", "said"), [
    ({"splits": 0}, "splits: 0 given; allowed: a whole number >= 1"),
    ({"splits": 2.5}, "splits: 2.5 given; allowed: a whole number >= 1"),
    ({"workers": 0}, "workers: 0 given; allowed: a whole number >= 1"),
    ({"workers": -2}, "workers: -2 given; allowed: a whole number >= 1"),
])  # fmt: skip
def test_wrong_options(pushes, options, said):
    with pytest.raises(pp.InvalidValue) as error:
        pp.compare(pushes, QUICK, **options)
    assert str(error.value).startswith(said)


def test_too_few_pushes_to_resample(pushes):
    with pytest.raises(pp.InvalidValue, match=r"15 pushes of object .* at least 16"):
        pp.compare(pushes.isel(push=slice(15)), QUICK, splits=2)


def test_an_interrupted_pool_ends_its_processes():
    """SIGTERM reaches the first process alone."""
    start = time.monotonic()

    def work(pool):
        task = pool.submit(time.sleep, 120)
        while not task.running():
            time.sleep(0.05)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt), process_pool(1) as pool:
        work(pool)
    assert time.monotonic() - start < 60
