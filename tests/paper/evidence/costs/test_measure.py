"""One sweep for errors and times: the same calls, timed in turns, on a machine that is described."""

import json
import platform

import numpy as np
import pytest
from evidence.costs.scenes import COUNTS, keep_scenes

from pulling_by_pushing.evidence.costs import measure
from pulling_by_pushing.evidence.costs.methods import METHODS


@pytest.fixture(scope="module", params=COUNTS)
def times(request):
    with pytest.MonkeyPatch.context() as patch:
        keep_scenes(patch, request.param)
        patch.setattr(measure, "REPEATS", 1)
        for quantity, methods in METHODS.items():
            few = tuple(each._replace(settings=each.settings[:1]) for each in methods)
            patch.setitem(METHODS, quantity, few)
        yield measure.accuracy(), measure.accuracy_time()


@pytest.mark.parametrize("quantity", METHODS)
def test_every_error_has_a_time(times, quantity):
    errors, seconds = (each[quantity] for each in times)
    error, time = errors[f"{quantity}_error"], seconds[f"{quantity}_seconds"]
    assert time.dims == (*error.dims, "repeat")
    assert time.shape == (*error.shape, 1)
    calls = seconds[f"{quantity}_call_seconds"]
    assert calls.dims == time.dims
    assert (calls > 0).all()
    one_by_one = np.isin(time.method, ["quad", "brentq on quad", "time-stepping"])
    assert (time[~one_by_one] > 0).all()
    assert np.isnan(time[one_by_one]).all()
    for name in errors.coords:
        assert np.array_equal(errors[name], seconds[name])
    assert set(errors.data_vars) == {f"{quantity}_error", "evaluations"}
    further = {"log_seconds"} if quantity == "motion" else set()
    assert set(seconds.data_vars) == {
        f"{quantity}_seconds", f"{quantity}_call_seconds"
    } | further  # fmt: skip


@pytest.mark.parametrize("quantity", METHODS)
def test_it_says_what_it_holds_and_where_it_was_measured(times, quantity):
    errors, seconds = (each[quantity] for each in times)
    for data in (errors, seconds):
        assert all({"units", "long_name"} <= set(each.attrs) for each in data.variables.values())
        assert {"title", "source"} <= set(data.attrs)
    assert seconds[f"{quantity}_seconds"].attrs["units"] == "s"
    assert "machine" not in errors.attrs
    machine = json.loads(seconds.attrs["machine"])
    assert {"processor", "cores", "system", "python", "numpy", "scipy"} <= set(machine)
    assert platform.node() not in machine.values()


def test_a_call_says_how_many_results_it_computes():
    """The time for a rule with many points is that of one wrench."""
    for name in METHODS:
        for call in measure.sweep(name):
            assert call.results >= 1
    for call in measure.sweep("cone"):
        edges = [single.args[:2] for single in call.calls]
        assert sorted(np.concatenate(edges, axis=1).T.tolist()) == sorted(
            np.stack(measure.edges(), axis=1).tolist()
        )
        # Both edges of one cone: they are mirror images about the normal.
        assert all(
            length[0] == length[1] and angle.sum() == pytest.approx(np.pi)
            for length, angle in edges
        )
    results = [call.results for call in measure.sweep("wrench")]
    assert max(results) == 2**13  # the coarsest rule
    assert results[-1] == 2**12


def test_calls_are_timed_in_turns_after_a_round_that_does_not_count():
    calls = []
    taken = measure.seconds([lambda: calls.append("a"), lambda: calls.append("b")], 5)
    assert taken.shape == (2, 5)
    assert (taken >= 0).all()
    assert calls == ["a", "b"] * 6
