"""The plan of a study: what is counted is exact, and what is measured is there."""

import pytest
from planar_pushing.study.grids import effort

from planar_pushing.study.catalog import SPLIT
from planar_pushing.study.plan import Rates, study_plan
from planar_pushing.study.study_file import load_study

SMOKE = load_study("workflow/config/smoke.yaml")


@pytest.fixture
def plan(monkeypatch):
    rates = Rates(computed=3.6, copied=0.36, stored=1e6)
    monkeypatch.setattr("planar_pushing.study.plan.measured_rates", lambda *_: rates)

    def of(**changes):
        return {each.dataset: each for each in study_plan(SMOKE.model_copy(update=changes))}

    return of


def test_a_study_in_one_piece(plan):
    found = plan()
    assert list(found) == list(SPLIT)
    modes = found["contact_modes"]
    assert (modes.points, modes.chunks, modes.jobs) == (3 * 7 * 4 * 25, 1, 1)
    assert modes.disk == modes.points
    assert modes.cpu_hours == pytest.approx(modes.points / 1e3, rel=1e-2)


def test_chunks_are_kept_and_gathered(plan):
    chunks = {"contact_modes": {"contact": 3, "pusher_angle": 10}}
    gathered = plan(chunks=chunks)["contact_modes"]
    kept = plan(chunks=chunks, gather={"contact_modes": False})["contact_modes"]
    assert gathered.chunks == kept.chunks == 9
    assert gathered.jobs == kept.jobs == 10
    assert gathered.disk == 2 * kept.disk == 2 * kept.points
    assert gathered.cpu_hours > kept.cpu_hours


def test_what_a_study_does_not_compute_has_no_plan(plan):
    grid = SMOKE.grid.model_copy(update={"effects": ("inertia",)})
    assert "center_regions" not in plan(grid=grid)


def test_rates_are_measured():
    few = SMOKE.grid.model_copy(update={"effects": ("inertia",)})
    modes = study_plan(SMOKE.model_copy(update={"grid": few}))[2]
    assert modes.dataset == "contact_modes"
    assert modes.cpu_hours > 0
    assert modes.disk > 0


def test_a_job_asks_for_more_as_it_grows_and_stays_below_a_gigabyte():
    assert effort.threads(1) == 1
    assert effort.threads(2**40) == effort.MOST_THREADS
    assert effort.memory(2**40, 64) < 1000
    assert effort.minutes(10**8) > effort.minutes(1) >= 10
