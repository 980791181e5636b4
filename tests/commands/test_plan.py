"""`planar-pushing plan` says what a study takes."""

import json

import pytest

from planar_pushing.commands import main


@pytest.fixture(autouse=True)
def _rates(monkeypatch):
    monkeypatch.setattr("planar_pushing.study.plan.measured_rates", lambda *_: (1e-6, 5.0))


def test_the_plan_is_a_table(capsys):
    assert main(["plan", "workflow/config/smoke.yaml"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split()[:4] == ["dataset", "points", "chunks", "jobs"]
    assert lines[3].split()[:4] == ["contact_modes", "2,100", "1", "1"]
    assert lines[-1].startswith("together: 5 jobs, 0.004 CPU hours, ")
    assert len(set(map(len, lines[:-1]))) == 1


def test_the_plan_as_json(capsys):
    assert main(["plan", "workflow/config/smoke.yaml", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["datasets"]
    assert [each["dataset"] for each in found] == [
        "limit_curves", "motion_cones", "contact_modes", "acceleration_centers", "center_regions",
    ]  # fmt: skip
    assert found[2]["points"] == 2100


def test_the_plan_of_a_study_with_supports(capsys):
    assert main(["plan", "workflow/config/sliders_smoke.yaml", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["datasets"]
    assert [each["dataset"] for each in found] == ["supports", "support_cones", "support_modes"]


def test_a_study_that_is_not_there_is_named(capsys):
    assert main(["plan", "nowhere.yaml"]) == 2
    assert "planar-pushing plan: nowhere.yaml: no such file" in capsys.readouterr().err
