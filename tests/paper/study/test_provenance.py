"""The digest of a result is that of the values that it is computed from."""

import shutil
from pathlib import Path

import pytest
from study.conftest import OF_PAPER

from pulling_by_pushing.study.provenance import provenance
from pulling_by_pushing.study.study_file import load_study

CONFIG = "workflow/config"
COSTS = {"effects"}
FIGURES = load_study(f"{CONFIG}/smoke.yaml").figures
MODELS = {"model_errors", "model_estimates"}
RESULTS = [
    *OF_PAPER, "scenes", *MODELS, "simulations/slipping", *(FIGURES.keys() - MODELS), *COSTS, "hard_cases",
]  # fmt: skip


@pytest.fixture
def digests(tmp_path):
    """The digest of every result of the smoke study, after a change of one of its files."""
    shutil.copytree("workflow", tmp_path / "workflow")

    def changed(file, old, new):
        path, study = tmp_path / "workflow" / file, tmp_path / CONFIG / "smoke.yaml"
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")
        marks = provenance(load_study(study), study)
        path.write_text(text, encoding="utf-8")
        return {name: marks(name)["study_digest"] for name in RESULTS}

    return changed


@pytest.mark.parametrize(
    ("file", "old", "new", "stale"),
    [
        ("config/smoke.yaml", "title:", "# a comment\ntitle:", set()),
        ("config/smoke.yaml", "[0, 1.5, 2, inf]", "\n    - 0\n    - 1.50\n    - 2\n    - .inf", set()),
        ("scenes/slipping.yaml", "title:", "# a comment\ntitle:", set()),
        ("config/smoke.yaml", "step: 0.5}", "step: 0.25}", {"acceleration_centers", *COSTS}),
        ("config/smoke.yaml", "[0, 1.5, 2, inf]", "[0, 1.5, 2, 3, inf]", {"motion_cones", *COSTS}),
        ("config/smoke.yaml", "figure_12: {rod_length: 5}", "figure_12: {rod_length: 2}", set()),
        ("config/smoke.yaml", "stop: 360, step: 3}", "stop: 360, step: 5}", {"curves", *COSTS}),
        ("config/smoke.yaml", "distance: 0.08", "distance: 0.09", {"model_errors"}),
        ("config/smoke.yaml", "seed: 1", "seed: 2", {"model_estimates"}),
        ("config/smoke.yaml", "force_angle: 54", "force_angle: 55", {"scenes"}),
        ("scenes/figure_02.yaml", "rod_length: 3", "rod_length: 4", {"scenes"}),
        ("scenes/figure_11.yaml", ", gyration_radius: 1}", "}", set()),
        ("scenes/figure_11.yaml", "gyration_radius: 1}", "gyration_radius: 2}", {"scenes"}),
        ("scenes/slipping.yaml", "samples: 97", "samples: 11", {"simulations/slipping"}),
    ],
)  # fmt: skip
def test_a_change_is_in_the_digests_of_what_reads_it(digests, file, old, new, stale):
    before = digests("config/smoke.yaml", "title:", "title:")
    after = digests(file, old, new)
    assert {name for name in RESULTS if before[name] != after[name]} == stale


def test_a_study_of_sliders_too(tmp_path):
    file = Path(shutil.copytree("workflow", tmp_path / "workflow")) / "config/sliders_smoke.yaml"
    names = ("supports", "support_cones", "simulations/tripod", "friction_for_pulling")

    def digests():
        marks = provenance(load_study(file), file)
        return [marks(name)["study_digest"] for name in names]

    before = digests()
    text = file.read_text(encoding="utf-8")
    file.write_text(
        text.replace("friction_coefficient: [", "friction_coefficient: [0.125, "), encoding="utf-8"
    )
    changed = [new != old for new, old in zip(digests(), before, strict=True)]
    assert changed == [False, True, False, False]
