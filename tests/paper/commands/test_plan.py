"""`planar-pushing plan` says what a study takes."""

import json
import shutil

import pytest

from planar_pushing.commands import main


@pytest.fixture(autouse=True)
def _rates(monkeypatch):
    monkeypatch.setattr(
        "pulling_by_pushing.study.running.plan.measured_rates", lambda *_: (1e-6, 5.0)
    )


def test_the_plan_is_a_table(capsys):
    assert main(["plan", "workflow/config/smoke.yaml"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split()[:4] == ["dataset", "points", "chunks", "jobs"]
    assert lines[4].split()[:4] == ["contact_modes", "2,100", "1", "1"]
    assert lines[-2].startswith("together: 7 jobs, ")
    assert lines[-1] == "not counted: 7 scenes, 3 simulations, 16 figures"
    assert len(set(map(len, lines[:-2]))) == 1


def test_the_plan_as_json(capsys):
    assert main(["plan", "workflow/config/smoke.yaml", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["datasets"]
    assert [each["dataset"] for each in found] == [
        "limit_curves", "curves", "motion_cones", "contact_modes", "mode_maps",
        "acceleration_centers", "center_regions",
    ]  # fmt: skip
    assert found[3]["points"] == 2100


def test_the_plan_of_a_study_with_supports(capsys):
    assert main(["plan", "workflow/config/sliders_smoke.yaml", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    names = ["supports", "support_cones", "support_modes", "support_curves", "support_rods"]
    assert [each["dataset"] for each in found["datasets"]] == names
    assert found["not_counted"] == {"scenes": 0, "simulations": 1, "figures": 4}


#: One axis more for each dataset; the last study has none.
SUPPORTS = """title: Feet
slider: {rod_angle: 45}
supports:
  feet: {shape: points, positions: [[-1, -1], [1, -1], [0, 1]], weights: [1, 1, 2]}
"""
KINDS = {
    "grid: {center_x: [0, 1], center_y: [0]}": ["supports"],
    "grid: {rod_length: [1], rod_angle: [45], friction_coefficient: [0.5]}": ["support_cones"],
    "grid: {}\nscenes: {mine: {file: scene.yaml, pusher_angle: 90}}": [],
}


@pytest.mark.parametrize(("grid", "names"), KINDS.items())
def test_a_study_of_any_kind_has_a_plan(capsys, tmp_path, grid, names):
    effect = "support_friction: {weight: 1}\n" if "scenes" in grid else ""
    (tmp_path / "mine.yaml").write_text(f"{SUPPORTS}{effect}{grid}\n", encoding="utf-8")
    shutil.copy("workflow/scenes/figure_03.yaml", tmp_path / "scene.yaml")
    assert main(["plan", str(tmp_path / "mine.yaml")]) == 0
    lines = capsys.readouterr().out.splitlines()
    last = next(k for k, line in enumerate(lines) if line.startswith(f"together: {len(names)} job"))
    assert [line.split()[0] for line in lines[1:last]] == names
    assert (lines[-1] == "not counted: 1 scene") == ("scenes" in grid)


def test_a_study_that_is_not_there_is_named(capsys):
    assert main(["plan", "nowhere.yaml"]) == 2
    assert "planar-pushing plan: nowhere.yaml: no such file" in capsys.readouterr().err
