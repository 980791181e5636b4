"""A slice of a study holds what one dataset reads."""

import pytest

from planar_pushing.study.builders import build_dataset
from planar_pushing.study.slices import study_slice
from planar_pushing.study.study_file import load_study


def test_a_builder_reads_nothing_outside_its_slice():
    study = load_study("workflow/config/smoke.yaml")
    values = study_slice(study, "motion_cones")
    del values["grid"]["rod_angle"]
    with pytest.raises(AttributeError, match="rod_angle"):
        build_dataset("motion_cones", values)
