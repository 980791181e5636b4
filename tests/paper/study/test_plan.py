"""The plan of a study: exact counts, and rates that are measured."""

import pytest
from study.conftest import OF_PAPER, OF_SLIDERS

from pulling_by_pushing.study import chunks
from pulling_by_pushing.study.running.plan import START_SECONDS, measured_rates, study_plan
from pulling_by_pushing.study.slices import select_ranges, study_slice
from pulling_by_pushing.study.study_file import load_study

SMOKE = load_study("workflow/config/smoke.yaml")
SLIDERS = load_study("workflow/config/sliders_smoke.yaml")


@pytest.fixture
def plan(monkeypatch):
    """Plans at a rate of 3.6 s and a megabyte for each point."""
    monkeypatch.setattr(
        "pulling_by_pushing.study.running.plan.measured_rates", lambda *_: (3.6, 1e6)
    )

    def of(study=SMOKE, **changes):
        return {each.dataset: each for each in study_plan(study.model_copy(update=changes))}

    return of


def test_a_study_in_one_piece(plan):
    found = plan()
    assert tuple(found) == OF_PAPER
    modes = found["contact_modes"]
    assert (modes.points, modes.chunks, modes.jobs) == (3 * 7 * 4 * 25, 1, 1)
    assert modes.memory == chunks.MEMORY < 1000
    assert modes.disk == modes.points
    assert modes.cpu_hours == pytest.approx((modes.points * 3.6 + START_SECONDS) / 3600)


def test_a_study_with_supports_has_a_plan_too(plan):
    found = plan(SLIDERS)
    assert tuple(found) == OF_SLIDERS
    assert found["support_modes"].points == 3 * 2 * 2 * 3 * 9


def test_chunks_are_kept_and_gathered(plan):
    cuts = {"contact_modes": {"contact": 3, "pusher_angle": 10}}
    gathered = plan(chunks=cuts)["contact_modes"]
    kept = plan(chunks=cuts, gather={"contact_modes": False})["contact_modes"]
    assert gathered.chunks == kept.chunks == 9
    assert gathered.jobs == kept.jobs == 10
    assert gathered.disk == 2 * kept.disk == 2 * kept.points
    assert gathered.cpu_hours > kept.cpu_hours


def test_a_dataset_that_is_not_computed_has_no_plan(plan):
    grid = SMOKE.grid.model_copy(update={"effects": ("inertia",)})
    assert set(plan(grid=grid)) == {
        "limit_curves", "curves", "motion_cones", "contact_modes", "mode_maps"
    }  # fmt: skip


@pytest.mark.parametrize(("study", "name"), [(SMOKE, "contact_modes"), (SLIDERS, "support_cones")])
def test_rates_are_measured(study, name):
    values = study_slice(study, name)
    few = select_ranges(values, {next(iter(chunks.sizes(name, values))): slice(0, 1)})
    seconds, stored = measured_rates(name, few)
    assert 0 < seconds < 1
    assert 0 < stored < 10**5
