"""A slice of a study holds the values that one dataset reads, and a part of it fewer of them."""

import pytest
from study.conftest import OF_PAPER, OF_SLIDERS

from pulling_by_pushing.study.catalog import CONTACT_LAWS, DATASETS
from pulling_by_pushing.study.model import SECTIONS
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import (
    computes,
    part_of,
    points,
    result_names,
    select_ranges,
    sizes,
    study_slice,
)
from pulling_by_pushing.study.store import open_dataset
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/smoke.yaml")
SLIDERS = load_study("workflow/config/sliders_smoke.yaml")


def test_a_study_computes_the_datasets_whose_axes_it_has():
    assert [name for name in DATASETS if computes(STUDY, name)] == [*OF_PAPER, "scenes", *SECTIONS]
    assert [name for name in DATASETS if computes(SLIDERS, name)] == [*OF_SLIDERS]


def test_centers_need_both_effects():
    grid = STUDY.grid.model_copy(update={"effects": ("inertia", "support_friction")})
    apart = STUDY.model_copy(update={"grid": grid})
    found = [name for name in OF_PAPER if computes(apart, name)]
    assert found == ["limit_curves", "curves", "motion_cones", "contact_modes", "mode_maps"]


def test_a_slice_holds_the_supports_and_the_axes():
    values = study_slice(SLIDERS, "supports")
    assert set(values["grid"]) == {"support", "center_x", "center_y"}
    assert part_of(values).gallery() == SLIDERS.gallery()
    del values["grid"]["center_y"]
    with pytest.raises(KeyError, match="center_y"):
        build_dataset("supports", values)


def test_a_builder_reads_nothing_outside_its_slice():
    values = study_slice(STUDY, "motion_cones")
    del values["grid"]["rod_angle"]
    with pytest.raises(KeyError, match="rod_angle"):
        build_dataset("motion_cones", values)


def test_datasets_of_pushes_hold_the_forces_of_a_fence():
    whole = study_slice(STUDY, "limit_curves")["grid"]["force_angle"]
    half = study_slice(STUDY, "acceleration_centers")["grid"]["force_angle"]
    assert (whole[0], whole[-1], half[0], half[-1]) == (0, 360, 0, 180)


def test_a_part_has_the_values_of_its_ranges_alone():
    values = study_slice(STUDY, "contact_modes")
    found = select_ranges(values, {"contact": slice(3, 6), "pusher_angle": slice(1, 3)})
    assert found["grid"]["pusher_angle"] == values["grid"]["pusher_angle"][1:3]
    assert found["grid"]["contact"] == ["coulomb_2", *CONTACT_LAWS[:2]]
    assert sizes("contact_modes", found)["contact"] == 3
    again = select_ranges(found, {"contact": slice(1, 2)})
    assert again["grid"]["contact"] == [CONTACT_LAWS[0]]
    assert points("contact_modes", again) == points("contact_modes", found) / 3


def test_a_part_has_the_supports_of_its_range_alone():
    found = select_ranges(study_slice(SLIDERS, "support_modes"), {"support": slice(1, 2)})
    assert list(found["supports"]) == found["grid"]["support"] == ["box"]
    assert list(part_of(found).gallery()) == ["box"]


def test_the_whole_is_no_part():
    values = study_slice(STUDY, "motion_cones")
    assert select_ranges(values, {}) == values
    assert sizes("scenes", study_slice(STUDY, "scenes")) == {}


@pytest.mark.parametrize("name", [*OF_PAPER, *OF_SLIDERS])
def test_sizes_are_those_of_the_dataset(sliders, name):
    study, folder = (SLIDERS, "sliders") if name in OF_SLIDERS else (STUDY, None)
    found = open_dataset(name, sliders, study=folder)
    expected = sizes(name, study_slice(study, name))
    assert {dim: found.sizes[dim] for dim in DATASETS[name].dims} == expected


@pytest.mark.parametrize("axis", ["effects", "rod_length"])
def test_evaluations_of_effects_need_a_slider_and_effects(axis):
    """A study of scenes alone has the other results about the computation itself."""
    grid = STUDY.grid.model_copy(update={axis: ()})
    names, fewer = (
        result_names(study) for study in (STUDY, STUDY.model_copy(update={"grid": grid}))
    )
    assert {"effects", "hard_cases", "accuracy"} <= set(names)
    assert {"hard_cases", "accuracy"} <= set(fewer)
    assert "effects" not in fewer
