"""The entries of the figures."""

import pytest

from planar_pushing.study.figures import ALL, FIGURES, GALLERY, draws
from planar_pushing.study.figures.base import COLUMN_WIDTH, PAGE_WIDTH
from planar_pushing.study.study_file import load_study


@pytest.mark.parametrize("name", FIGURES | GALLERY)
def test_the_caption_and_the_size_suit_a_column_or_a_page(name):
    assert ALL[name].size[0] in (COLUMN_WIDTH, PAGE_WIDTH)
    assert ALL[name].caption.endswith(".")


def test_a_scene_needs_the_effects_of_the_figure_that_shows_it():
    study = load_study("workflow/config/smoke.yaml")
    grid = study.grid.model_copy(update={"effects": ("support_friction",)})
    rubs = study.model_copy(update={"grid": grid})
    names = ["figure_02", "figure_09a", "figure_12", "figure_13"]
    assert [draws(rubs, name) for name in names] == [True, False, False, True]
    assert all(draws(study, name) for name in names)


def test_a_figure_needs_the_axes_of_its_datasets():
    study = load_study("workflow/config/smoke.yaml")
    grid = study.grid.model_copy(update={"force_angle": ()})
    bare = study.model_copy(update={"grid": grid})
    assert [name for name in FIGURES if not draws(bare, name)] == ["figure_05", "figure_12"]


def test_a_study_without_simulations_does_not_draw_their_figures():
    study = load_study("workflow/config/smoke.yaml")
    bare = study.model_copy(update={"simulations": {"figure_15": "x"}})
    assert draws(study, "figure_14")
    assert [draws(bare, f"figure_{number}") for number in (13, 14, 15)] == [True, False, True]


def test_a_study_of_sliders_without_the_motion_of_the_tripod_does_not_draw_it():
    study = load_study("workflow/config/sliders_smoke.yaml")
    bare = study.model_copy(update={"simulations": {}})
    assert all(draws(study, name) for name in GALLERY)
    assert [name for name in GALLERY if not draws(bare, name)] == ["figure_19"]
    assert not any(draws(study, name) for name in ("figure_05", "figure_07", "figure_13"))
