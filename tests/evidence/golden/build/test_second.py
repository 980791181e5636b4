"""The second route of the golden data covers every variable and edge case, and tells a wrong number."""

from multiprocessing import get_context
from pathlib import Path

import pytest

from planar_pushing.certified import ring
from planar_pushing.certified.integrals import printed
from planar_pushing.evidence.golden import update
from planar_pushing.evidence.golden.build import second
from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.study.store import read_dataset
from planar_pushing.study.study_file import load_study

GOLDEN = Path("tests/golden")
FILE = "figure_07"


@pytest.fixture(scope="module")
def study():
    return update.plain(load_study("workflow/config/paper.yaml"))


@pytest.fixture(scope="module")
def integrals(study):
    """One file computed from the printed integrals, in a process of its own."""
    with get_context("spawn").Pool(1, ring.use, (printed,)) as pool:
        return pool.apply(second._build, ((study, FILE),))


def test_routes_agree(study, integrals):
    stored = read_dataset(GOLDEN / f"{FILE}.nc")
    found = second.agreement(study, integrals, stored)
    assert (found.compared, found.apart) == (8, ())


def test_a_number_off_by_its_radius_is_told(study, integrals):
    stored = read_dataset(GOLDEN / f"{FILE}.nc")
    stored["motion_cone_left_low"][2] += 1e-22
    assert second.agreement(study, integrals, stored).apart == ("motion_cone_left",)


def test_the_part_has_every_axis_and_at_least_a_thousand_numbers(study):
    part = second.thinned(study)
    for axis, values in part["grid"].items():
        assert values, axis
    assert set(part["contacts"]) == set(second.CONTACTS)
    checked = {path.stem: read_dataset(path).attrs[update.CHECKED] for path in GOLDEN.glob("*.nc")}
    assert min(checked.values()) > 0
    assert sum(checked.values()) >= 1000
    assert all(len(golden_variables(read_dataset(path))) for path in GOLDEN.glob("*.nc"))
