"""A slice of a study holds what one dataset reads."""

import pytest

from planar_pushing.study.build import build_dataset
from planar_pushing.study.slices import sliced_study, study_slice
from planar_pushing.study.study_file import load_study


def test_a_slice_of_a_study_of_sliders_holds_its_supports_and_its_axes():
    study = load_study("workflow/config/sliders_smoke.yaml")
    values = study_slice(study, "supports")
    assert set(values) == {"supports", "grid"}
    assert set(values["grid"]) == {"center_x", "center_y"}
    assert sliced_study(values).gallery() == study.gallery()
    del values["grid"]["center_y"]
    with pytest.raises(AttributeError, match="center_y"):
        build_dataset("supports", values)


def test_a_builder_reads_nothing_outside_its_slice():
    study = load_study("workflow/config/smoke.yaml")
    values = study_slice(study, "motion_cones")
    del values["grid"]["rod_angle"]
    with pytest.raises(AttributeError, match="rod_angle"):
        build_dataset("motion_cones", values)
