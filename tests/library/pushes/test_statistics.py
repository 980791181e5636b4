"""Statistics of errors, against loops."""

import numpy as np
import pytest
import xarray as xr

from planar_pushing.pushes.fit.scores import QUANTITIES, REFERENCE
from planar_pushing.pushes.fit.statistics import VARIABLES, statistics

MODELS = ["good", "none", REFERENCE]


def errors(count=41):
    """Two thirds of the reference's errors with noise; a model without errors; missing ones."""
    random = np.random.default_rng(0)
    values = random.lognormal(size=(3, 3, count))
    values[:, 0] = values[:, 2] * random.uniform(0.4, 0.9, size=(3, count))
    values[:, 1] = np.nan
    values[1, 2, :20] = np.nan
    values[0, 0, 30:] = np.nan
    return xr.DataArray(
        values, dims=("quantity", "model", "push"), coords={"quantity": list(QUANTITIES), "model": MODELS}
    )  # fmt: skip


def test_statistics_of_the_pushes_that_both_have():
    error = errors()
    found = statistics(error, resamples=50)
    for quantity in QUANTITIES:
        own = error.sel(quantity=quantity, model="good").values
        other = error.sel(quantity=quantity, model=REFERENCE).values
        pairs = [(a, b) for a, b in zip(own, other, strict=True) if a == a and b == b]
        assert len(pairs) == {"wrench": 30, "motion": 21, "pose": 41}[quantity]
        a, b = (sorted(each) for each in zip(*pairs, strict=True))

        def quantile(values, q):
            place = q * (len(values) - 1)
            k = int(place)
            return values[k] + (place - k) * (values[min(k + 1, len(values) - 1)] - values[k])

        here = found.sel(quantity=quantity, model="good")
        assert float(here["median"]) == pytest.approx(quantile(a, 0.5))
        assert float(here["percentile_90"]) == pytest.approx(quantile(a, 0.9))
        assert float(here["ratio"]) == pytest.approx(quantile(a, 0.5) / quantile(b, 0.5))
        differences = sorted(x - y for x, y in pairs)
        assert float(here["difference"]) == pytest.approx(quantile(differences, 0.5))
    assert found["error"].equals(error)


def test_the_reference_beside_itself_and_a_model_without_errors():
    found = statistics(errors(), resamples=50)
    own = found.sel(model=REFERENCE)
    assert (own["ratio"] == 1.0).all()
    assert (own["ratio_interval"] == 1.0).all()
    assert (own["difference"] == 0.0).all()
    for name in VARIABLES:
        assert np.isnan(found[name].sel(model="none")).all()
        assert np.isnan(found[f"{name}_interval"].sel(model="none")).all()


def test_intervals_hold_their_statistic_and_shrink():
    few = statistics(errors(40), resamples=400)
    many = statistics(errors(640), resamples=400)
    for name in VARIABLES:
        for found in (few, many):
            low, high = found[f"{name}_interval"].sel(model="good").values.T
            value = found[name].sel(model="good").values
            assert (low <= value).all(), name
            assert (value <= high).all(), name
        ends = [
            each[f"{name}_interval"].sel(model="good", quantity="pose").values
            for each in (few, many)
        ]
        widths = np.ptp(ends, axis=1)
        assert widths[1] < 0.6 * widths[0], name
    assert few["bound"].values.tolist() == ["low", "high"]


def test_pushes_are_drawn_evenly():
    """Of 7 of 10 pushes each comes equally often: the spread of a median is that of plain draws."""
    values = np.full((1, 1, 10), np.nan)
    values[0, 0, :7] = np.arange(1.0, 8.0)
    error = xr.DataArray(
        values, dims=("quantity", "model", "push"), coords={"quantity": ["pose"], "model": [REFERENCE]}
    )  # fmt: skip
    found = statistics(error, resamples=20000, seed=1)
    random = np.random.default_rng(5)
    plain = np.median(random.integers(1, 8, size=(20000, 7)), axis=1)
    assert float(found["median"][0, 0]) == 4.0
    assert (
        found["median_interval"][0, 0].values.tolist() == np.percentile(plain, [2.5, 97.5]).tolist()
    )
    highs = np.percentile(random.integers(1, 8, size=(20000, 7)), 90.0, axis=1)
    interval = found["percentile_90_interval"][0, 0].values
    assert interval == pytest.approx(np.percentile(highs, [2.5, 97.5]), abs=0.41)


def test_a_seed_makes_the_intervals_again():
    one, again, other = (statistics(errors(), resamples=30, seed=k) for k in (2, 2, 3))
    assert one.identical(again)
    assert not one["median_interval"].equals(other["median_interval"])
    assert one["median"].equals(other["median"])
