"""Figures of a study: what they take from it, and why they cannot be drawn."""

from pathlib import Path

import pytest

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import (
    load_drawn_study,
    numbered,
    pictures,
    problems,
    settings,
)
from pulling_by_pushing.study.model import FigureEntry
from pulling_by_pushing.study.study_file import load_study

CONFIG = Path("workflow/config")
#: Studies of the project, and the one that `planar-pushing` writes for a user.
DEFAULT = [
    *sorted(CONFIG.glob("*.yaml")),
    Path("src/pulling_by_pushing/study/templates/my_study.yaml"),
]


@pytest.mark.parametrize("path", DEFAULT, ids=lambda path: path.stem)
def test_the_figures_of_every_study_of_the_project_can_be_drawn(path):
    study = load_drawn_study(path)
    assert list(problems(study)) == []
    assert set(study.figures) <= set(numbered())


def test_both_default_studies_draw_every_figure_with_a_number():
    paper, sliders = (load_study(CONFIG / f"{name}.yaml") for name in ("paper", "sliders"))
    assert [*paper.figures, *sliders.figures] == numbered()
    assert numbered() == [f"figure_{number:02}" for number in range(1, 20)]


def message(tmp_path, text):
    path = tmp_path / "study.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_drawn_study(path)
    assert "\n" not in str(caught.value)
    return str(caught.value).removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    ("name", "old", "new", "said"),
    [
        ("smoke", "  figure_07: {", "  figure_99: {",
         f"figures.figure_99: unknown; allowed: {', '.join(numbered())}; remove it"),
        ("smoke", "  figure_15: {}", "  hard_cases: {}",
         f"figures.hard_cases: unknown; allowed: {', '.join(numbered())}; remove it"),
        ("smoke", "  figure_12: {file", "  other: {file",
         "scenes.figure_12: missing; allowed: an entry, from which figures.figure_12 is drawn; add it"),
        ("smoke", "  figure_15: ../scenes/figure_15.yaml\n", "",
         "simulations.figure_15: missing; allowed: an entry, from which figures.figure_15 is drawn; "
         "add it"),
        ("sliders_smoke", "simulations:\n  tripod: ../scenes/tripod.yaml\n", "",
         "simulations.tripod: missing; allowed: an entry, from which figures.figure_19 is drawn; add it"),
        ("smoke", "  force_angle: {start: 0, stop: 360, step: 15}\n", "",
         "figures.figure_05: drawn from limit_curves; allowed: where the grid has "),
        ("smoke", "effects: [support_friction, inertia, support_friction+inertia]", "effects: [inertia]",
         "figures.figure_01: shows support_friction; allowed: where grid.effects lists it; remove it"),
        ("smoke", "effects: [support_friction, inertia, support_friction+inertia]",
         "effects: [support_friction, inertia]",
         "figures.figure_12: shows support_friction+inertia; allowed: where grid.effects lists it; "
         "remove it"),
        ("smoke", "  figure_07: {rod_length: [1, 2, 5]}\n", "  figure_07: {}\n",
         "figures.figure_07.rod_length: missing; allowed: values of the grid; add it"),
        ("smoke", "mapped_rod_length: 1, ", "",
         "figures.figure_10.mapped_rod_length: missing; allowed: values of the grid; add it"),
        ("smoke", "figure_13: {rod_length: 2, pusher_magnitude: 1}", "figure_13: {rod_length: 2}",
         "figures.figure_13.pusher_magnitude: missing; allowed: values of the grid; add it"),
        ("smoke", "figure_06: {rod_length: 2", "figure_06: {rod_length: 4",
         "figures.figure_06.rod_length: (4.0,) given; allowed: values of the grid, "
         "(0.0, 1.0, 2.0, 5.0); change it or add it to the grid"),
        ("smoke", "mapped_rod_length: 1", "mapped_rod_length: 3",
         "figures.figure_10.mapped_rod_length: (3.0,) given; allowed: values of the grid, "
         "(0.0, 1.0, 2.0, 5.0); change it or add it to the grid"),
        ("smoke", "rod_angle: [45, 90]", "rod_angle: [60, 90]",
         "grid.rod_angle: (60.0, 90.0) given; allowed: values that include 45.0, "
         "at which figures.figure_01 is drawn; add it, or remove the figure"),
        ("smoke", "[0, 1.5, 2, inf]", "[0, 1.5, 2]",
         "grid.friction_coefficient: (0.0, 1.5, 2.0) given; allowed: values that include inf, "
         "at which figures.figure_07 is drawn; add it, or remove the figure"),
        ("sliders_smoke", "rod_length: 2, ", "",
         "figures.figure_16.rod_length: missing; allowed: values of the grid; add it"),
        ("sliders_smoke", "rod_length: 2, ", "rod_length: 3, ",
         "grid.rod_length: (1.0, 2.0) given; allowed: values that include 3.0, "
         "at which figures.figure_18 is drawn; add it, or remove the figure"),
        ("sliders_smoke", "[0.25, 2, inf]", "[0.25, 2]",
         "grid.friction_coefficient: (0.25, 2.0) given; allowed: values that include inf, "
         "at which figures.figure_18 is drawn; add it, or remove the figure"),
    ],
)  # fmt: skip
def test_a_figure_that_cannot_be_drawn_is_one_line(tmp_path, name, old, new, said):
    text = (CONFIG / f"{name}.yaml").read_text(encoding="utf-8")
    assert old in text
    text = text.replace(old, new, 1).replace("../scenes", str(Path("workflow/scenes").resolve()))
    assert message(tmp_path, text).startswith(said)


@pytest.mark.parametrize("name", ["smoke", "sliders_smoke"])
def test_a_figure_that_is_not_listed_needs_nothing(name):
    study = load_study(CONFIG / f"{name}.yaml")
    bare = study.model_copy(update={"figures": {}, "scenes": {}, "simulations": {}})
    assert list(problems(bare)) == []
    assert pictures(Path("results"), bare) == {}


def test_a_figure_takes_the_rod_of_the_study_unless_it_has_its_own():
    study = load_study(CONFIG / "sliders_smoke.yaml")
    assert settings(study, "figure_17") == {"rod_length": 2.0, "rod_angle": 45.0}
    own = study.model_copy(update={"figures": {"figure_17": FigureEntry(rod_length=1.0)}})
    assert settings(own, "figure_17")["rod_length"] == 1.0
    assert list(problems(own)) == []
    given = settings(load_study(CONFIG / "smoke.yaml"), "figure_10")
    assert given == {"rod_length": (0.0, 1.0, 2.0, 5.0), "rod_angle": 45.0, "mapped_rod_length": 1.0,
                     "friction_coefficient": float("inf")}  # fmt: skip


def test_pictures_of_a_study_are_those_of_its_figures_and_their_variants():
    study = load_study(CONFIG / "smoke.yaml")
    found = pictures(Path("results"), study)
    assert set(found) == {name + end for name in study.figures for end in entry(name).variants}
    assert found["figure_06_column"] == Path("results/figures/figure_06_column.png")
    assert "figure_01_column" not in found
