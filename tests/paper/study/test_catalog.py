"""The declarations of datasets, names of datasets and labels of numbers."""

from importlib import import_module

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import planar_pushing as pp
from planar_pushing.terms.quantities import DATASET, SLIDERS
from pulling_by_pushing.study.catalog import (
    CONTACT_LAWS,
    DATASETS,
    build_command,
    contact_labels,
    dataset_file,
    dataset_names,
    number_label,
)
from pulling_by_pushing.study.model import SECTIONS, Grid
from pulling_by_pushing.study.quantities import MODELS


def test_axes_are_those_of_the_grid():
    named = {axis for entry in DATASETS.values() for axis in entry.axes}
    assert named - {"contact", "support"} == set(Grid.model_fields) - {
        "contact_friction_coefficient"
    }


@pytest.mark.parametrize("name", DATASETS)
def test_every_declaration_has_a_builder_and_words_for_its_names(name):
    entry = DATASETS[name]
    module = import_module(f"pulling_by_pushing.study.datasets.{entry.module}")
    assert callable(getattr(module, name))
    known = SLIDERS if "support" in entry.dims else MODELS if name in SECTIONS else DATASET
    assert {*entry.dims, *entry.inner, *entry.variables} - {"solution"} <= set(known)


def test_contact_laws_are_labeled_by_their_coefficients():
    found = contact_labels((1.4, 1.4000001, 2.0))
    assert found == ["coulomb_1.4", "coulomb_1.4000001", "coulomb_2", *CONTACT_LAWS]


def test_scenes_share_a_file_and_simulations_have_one_each():
    assert dataset_file("scenes/figure_08") == "data/scenes.nc"
    assert dataset_file("simulations/slipping") == "data/simulations/slipping.nc"


@pytest.mark.parametrize(
    ("name", "said"),
    [("contact_mode", "did you mean contact_modes?"), ("limit_curve/x", "did you mean limit_curves?"),
     ("motion_cone", "did you mean motion_cones?"), ("suport_modes", "did you mean support_modes?"),
     ("zzz", "name one of these datasets")],
)  # fmt: skip
def test_a_name_that_is_none_is_answered_with_the_closest(name, said):
    with pytest.raises(pp.InvalidValue, match=r"given; allowed: limit_curves, ") as caught:
        dataset_file(name)
    assert str(caught.value).endswith(said)


@pytest.mark.parametrize(("name", "said"), [
    ("accuracy/cone", "build it with make, in the project's folder"),
    ("supports", "build it with planar-pushing run, from a study that gives supports, center_x, center_y;"
     " make builds it for the study sliders"),
    ("center_regions", "build it with planar-pushing run, from a study that gives rod_length, rod_angle, "
     "force_angle, and the effects support_friction+inertia; make builds it for the study paper"),
    ("model_errors", "build it with planar-pushing run, from a study that gives model_errors; make builds "
     "it for the study paper"),
    ("simulations/mine", "build it with planar-pushing run, from a study that lists it under simulations; "
     "make builds it for the study paper"),
])  # fmt: skip
def test_what_is_not_there_is_built_by_a_command(name, said):
    assert build_command(name) == said


def test_every_name_that_is_listed_is_taken():
    for name in dataset_names():
        assert dataset_file(name)
    assert {"scenes", "accuracy", "accuracy_time"}.isdisjoint(dataset_names())


@pytest.mark.parametrize(
    ("number", "label"),
    [(1.4, "1.4"), (2, "2"), (1.4000001, "1.4000001"), (np.float64(0.3), "0.3"), (np.inf, "inf")],
)
def test_a_label_is_short(number, label):
    assert number_label(number) == label


@given(st.floats(0, 1e3), st.integers(1, 3))
def test_a_label_tells_neighbors_apart(number, steps):
    other = number
    for _ in range(steps):
        other = float(np.nextafter(other, np.inf))
    assert float(number_label(number)) == number
    assert number_label(number) != number_label(other)
