"""Figures of a study: what they take from it, and why they cannot be drawn."""

from itertools import chain
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures.figure import Figure, cuts_of, figure_names, select_values
from pulling_by_pushing.figures.studies import (
    NUMBERS,
    SECTIONS,
    cuts,
    load_drawn_study,
    pictures,
    problems,
    study_figures,
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
    assert set(study.figures) <= set(study_figures())


def test_both_default_studies_draw_every_figure_of_a_study():
    paper, sliders = (load_study(CONFIG / f"{name}.yaml") for name in ("paper", "sliders"))
    assert sorted([*paper.figures, *sliders.figures]) == sorted(study_figures())
    assert set(NUMBERS) == set(figure_names())
    assert sorted(chain.from_iterable(SECTIONS.values())) == sorted(NUMBERS)


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
         f"figures.figure_99: unknown; allowed: {', '.join(study_figures())}; did you mean figure_09?"),
        ("smoke", "  slip_over_time: {}", "  hard_cases: {}",
         f"figures.hard_cases: unknown; allowed: {', '.join(study_figures())}; remove it"),
        ("smoke", "  figure_12: {file", "  other: {file",
         "scenes.figure_12: missing; allowed: an entry, from which figures.figure_12 is drawn; add it"),
        ("smoke", "  slipping: ../scenes/slipping.yaml\n", "",
         "simulations.slipping: missing; allowed: an entry, from which figures.slip_over_time is drawn; "
         "add it"),
        ("sliders_smoke", "simulations:\n  tripod: ../scenes/tripod.yaml\n", "",
         "simulations.tripod: missing; allowed: an entry, from which figures.pivoting_tripod is drawn; "
         "add it"),
        ("sliders_smoke", "friction_for_pulling: {}", "friction_for_pulling: {support: [box, cone]}",
         "figures.friction_for_pulling.support: ('box', 'cone') given; allowed: values of supports, "
         "('ring', 'box', 'tripod'); change it or add it there"),
        ("smoke", "  force_angle: {start: 0, stop: 360, step: 15}\n", "",
         "figures.figure_12: drawn from acceleration_centers; allowed: where the study gives "),
        ("smoke", "  curves: {force_angle: {start: 0, stop: 360, step: 3}}\n", "",
         "figures.figure_05: drawn from curves; allowed: where the study gives effects, rod_length, "
         "force_angle, and lists it under fine_grids; remove it"),
        ("smoke", "effects: [support_friction, inertia, support_friction+inertia]", "effects: [inertia]",
         "grid.effects: ('inertia',) given; allowed: values that include 'support_friction', "
         "at which figures.figure_01 is drawn; add it, or remove the figure"),
        ("smoke", "effects: [support_friction, inertia, support_friction+inertia]",
         "effects: [support_friction, inertia]",
         "figures.figure_12: drawn from acceleration_centers; allowed: where the study gives rod_length, "
         "force_angle, inertia_share, and the effects support_friction+inertia; remove it"),
        ("smoke", "  figure_07: {rod_length: [1, 2, 5]}\n", "  figure_07: {}\n",
         "figures.figure_07.rod_length: missing; allowed: values of the grid; add it"),
        ("smoke", ", motion_cones: {rod_length: 1}", "",
         "figures.figure_10.motion_cones.rod_length: missing; allowed: values of the grid; add it"),
        ("smoke", "motion_cones: {rod_length: 1}", "motion_cones: {rod_length: 1}, scenes: {rod_length: 1}",
         "figures.figure_10.scenes: given; allowed: curves, motion_cones; remove it"),
        ("smoke", "figure_13: {rod_length: 2, pusher_magnitude: 1}", "figure_13: {rod_length: 2}",
         "figures.figure_13.pusher_magnitude: missing; allowed: values of the grid; add it"),
        ("smoke", "figure_06: {rod_length: 2", "figure_06: {rod_length: 4",
         "figures.figure_06.rod_length: (4.0,) given; allowed: values of grid.rod_length, "
         "(0.0, 1.0, 2.0, 5.0); change it or add it there"),
        ("smoke", "motion_cones: {rod_length: 1}", "motion_cones: {rod_length: 3}",
         "figures.figure_10.motion_cones.rod_length: (3.0,) given; allowed: values of grid.rod_length, "
         "(0.0, 1.0, 2.0, 5.0); change it or add it there"),
        ("smoke", "mode_maps: {rod_length: [2]", "mode_maps: {rod_length: [5]",
         "figures.figure_13.rod_length: (2.0,) given; allowed: values of fine_grids.mode_maps.rod_length, "
         "(5.0,); change it or add it there"),
        ("smoke", "rod_angle: [45, 90]", "rod_angle: [60, 90]",
         "grid.rod_angle: (60.0, 90.0) given; allowed: values that include 45.0, "
         "at which figures.figure_01 is drawn; add it, or remove the figure"),
        ("smoke", "[0, 1.5, 2, inf]", "[0, 1.5, 2]",
         "grid.friction_coefficient: (0.0, 1.5, 2.0) given; allowed: values that include inf, "
         "at which figures.figure_07 is drawn; add it, or remove the figure"),
        ("sliders_smoke", "rod_length: 2, ", "",
         "slider.rod_length: missing; allowed: a length > 0, for support_curves; add it"),
        ("sliders_smoke", "[0.25, 2, inf]", "[0.25, 2]",
         "grid.friction_coefficient: (0.25, 2.0) given; allowed: values that include inf, "
         "at which figures.slip_of_supports is drawn; add it, or remove the figure"),
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
    assert cuts(study, "friction_for_pulling") == {"rod_length": 2.0, "rod_angle": 45.0}
    own = study.model_copy(
        update={"figures": {"friction_for_pulling": FigureEntry(rod_length=1.0)}}
    )
    assert cuts(own, "friction_for_pulling")["rod_length"] == 1.0
    given = cuts(load_study(CONFIG / "smoke.yaml"), "figure_10")
    assert given == {"rod_length": (0.0, 1.0, 2.0, 5.0), "rod_angle": 45.0, "friction_coefficient": np.inf,
                     "motion_cones": {"rod_length": 1.0}}  # fmt: skip


def test_a_dataset_is_cut_at_one_or_several_values_or_at_its_own():
    figure = Figure(title="", reads=("one", "other"), size=(1.0, 1.0), cuts={"effects": "inertia"})
    given = {"rod_length": (1.0, 2.0), "rod_angle": 45.0, "other": {"rod_length": 1.0}}
    axes = {"rod_length": [0.0, 1.0, 2.0], "effects": ["inertia", "none"]}
    whole = xr.Dataset({"x": (("rod_length", "effects"), np.arange(6.0).reshape(3, 2))}, axes)
    one, other = (select_values(whole, cuts_of(figure, name, given)) for name in figure.reads)
    assert one.x.values.tolist() == [2.0, 4.0]
    assert other.x.item() == 2.0
    assert other.rod_length.item() == 1.0
    assert other.effects.item() == "inertia"


def test_pictures_of_a_study_are_those_of_its_figures():
    study = load_study(CONFIG / "smoke.yaml")
    expected = {name: Path(f"results/figures/{name}.png") for name in study.figures}
    assert pictures(Path("results"), study) == expected
