"""Errors of fits that are kept in a folder."""

import numpy as np
import pytest
import xarray as xr
from pushes.written import TRIANGLE, feet

import planar_pushing as pp
from planar_pushing.pushes.halves import Task, divide, score_fold
from planar_pushing.pushes.logs.combine import of_object
from planar_pushing.pushes.models import MODELS
from pulling_by_pushing.evidence.folds import kept_errors, kept_map, task_digest

QUICK = ["known_feet", "uniform"]


@pytest.fixture(scope="module")
def pushes():
    return pp.simulate_pushes(feet(), TRIANGLE, 16, noise=(0.5, 0.3, 0.05), seed=6)


@pytest.fixture
def task(pushes):
    fold = divide(16, 1, seed=0)[0][0]
    fits = {name: MODELS[name] for name in QUICK}
    return Task(of_object(pushes, "object"), fold, fits, {"family": "points", "spacing": None})


def test_errors_are_computed_once(task, tmp_path):
    calls = []

    def score(given):
        calls.append(given)
        return score_fold(given)

    first, again = (kept_errors(score, tmp_path, "code", task) for _ in range(2))
    assert len(calls) == 1
    np.testing.assert_array_equal(first, again)
    np.testing.assert_array_equal(first, score_fold(task))
    kept_errors(score, tmp_path, "other code", task)
    assert len(calls) == 2


def test_the_digest_is_that_of_all_that_a_fit_depends_on(task):
    fold, pushes = task.fold, task.pushes
    moved = pushes.copy(deep=True)
    moved["rotation"].values[3] += 1e-12
    tasks = [
        task,
        task._replace(fold=fold._replace(fit=np.append(fold.fit, fold.fit[:1]))),
        task._replace(fold=fold._replace(fit=fold.score, score=fold.fit)),
        task._replace(fits={"uniform": MODELS["uniform"]}),
        task._replace(options=task.options | {"spacing": 20.0}),
        task._replace(pushes=moved),
        task._replace(pushes=pushes.assign_attrs(position_noise=3.0)),
    ]
    digests = [task_digest(each, "code") for each in tasks]
    assert len(set(digests)) == len(tasks)
    assert task_digest(task._replace(pushes=pushes.copy(deep=True)), "code") == digests[0]
    assert task_digest(task, "other code") not in digests


@pytest.mark.slow
def test_kept_errors_give_the_same_comparison(pushes, tmp_path):
    expected = pp.compare(pushes, QUICK, splits=2)
    for _ in range(2):
        with kept_map(2, tmp_path) as workers:
            found = pp.compare(pushes, QUICK, splits=2, workers=workers)
        xr.testing.assert_identical(found, expected)
        assert len(list(tmp_path.glob("*.npy"))) == 8
