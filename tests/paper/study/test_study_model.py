"""The model of a study: axes, lists that hold ranges, supports and effects together."""

import numpy as np
import pytest

from planar_pushing import Coulomb, InfiniteFriction, PerfectlyRough
from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.model import Grid, StudyFile, labeled_law
from pulling_by_pushing.study.slices import computes
from pulling_by_pushing.study.study_file import load_study

RING = {"shape": "ring", "radius": 1}
BOTH = {"slider": {"rod_angle": 45, "rod_length": 2}, "support_friction": {"weight": 1}}


def test_the_study_of_the_paper_holds_the_grid_of_the_paper():
    grid = load_study("workflow/config/paper.yaml").grid
    assert {0, 0.25, 0.5, 1, 2, 3, 5, 10} <= set(grid.rod_length)
    assert {15, 45, 90, 165} <= set(grid.rod_angle)
    assert {0, 0.25, 0.5, 1, 1.5, 2, 5, 10, 100, np.inf} <= set(grid.friction_coefficient)
    assert (np.diff(grid.force_angle) == 3).all()
    assert grid.pusher_angle == tuple(sorted({*range(-180, 181, 5), -179, -1}))
    assert grid.pusher_magnitude == (0.1, 1, 2, 10)
    assert (grid.inertia_share[0], grid.inertia_share[-1]) == (0, 1)


def test_the_study_of_the_paper_has_eighteen_laws():
    laws = load_study("workflow/config/paper.yaml").values("contact")
    assert len(laws) == 18
    assert list(map(labeled_law, laws[-4:])) == [
        Coulomb(100.0), InfiniteFriction(), InfiniteFriction("none"), PerfectlyRough(),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("given", "values"),
    [
        ([{"start": -10, "stop": 10, "step": 5}, -9, 7], (-10, -9, -5, 0, 5, 7, 10)),
        ([3, {"start": 0, "stop": 1, "step": 0.5}], (0, 0.5, 1, 3)),
        ([{"start": 0, "stop": 2, "step": 1}, {"start": 1, "stop": 3, "step": 1}], (0, 1, 2, 3)),
        ([{"start": 0, "stop": 2, "step": 1}, 1], (0, 1, 2)),
        ({"start": 0, "stop": 0.3, "step": 0.1}, (0, 0.1, 0.2, 0.3)),
    ],
)
def test_an_axis_is_a_list_or_a_range_or_a_list_that_holds_ranges(given, values):
    assert Grid(pusher_angle=given).pusher_angle == values


@pytest.mark.parametrize(
    "given",
    [[3, 2], [1, 1], [{"start": 0, "stop": 1}], [{"start": 0, "stop": 1, "step": 1}, "x"],
     [{"start": 0, "stop": 1, "step": 1}, float("nan")], {"start": 0, "stop": 1, "step": 0.7}],
)  # fmt: skip
def test_an_axis_that_does_not_increase_or_holds_other_things_is_refused(given):
    with pytest.raises(ValueError, match="a list of increasing numbers, or"):
        Grid(pusher_angle=given)


def test_a_study_may_hold_supports_and_effects_together():
    grid = {
        "effects": ["support_friction"], "rod_length": [1, 2], "rod_angle": [45],
        "friction_coefficient": [0.5, "inf"], "pusher_angle": [0, 90],
    }  # fmt: skip
    given = {"title": "Both", "supports": {"ring": RING}, "grid": grid}
    study = StudyFile.model_validate(BOTH | given)
    found = [name for name in DATASETS if computes(study, name)]
    assert found == ["motion_cones", "support_cones", "support_modes"]
    assert study.values("support") == ("ring",)


def test_a_study_that_computes_nothing_is_refused(tmp_path):
    path = tmp_path / "nothing.yaml"
    path.write_text("title: Nothing\nslider: {rod_angle: 45}\ngrid: {rod_length: [1]}\n")
    with pytest.raises(InvalidFile) as caught:
        load_study(path)
    assert str(caught.value) == (
        f"{path}: grid: no dataset has all its axes; allowed: all axes of at least one; add axes"
    )
