"""The smallest study's results, computed once."""

import pytest

from evidence.golden.studies import write_results
from planar_pushing.study.provenance import provenance
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"


@pytest.fixture(scope="session")
def smoke():
    return load_study(SMOKE)


@pytest.fixture(scope="session")
def smoke_marks(smoke):
    return provenance(smoke, SMOKE)


@pytest.fixture(scope="session")
def smoke_results(tmp_path_factory):
    """The folder that the study fills, in one of all results."""
    return write_results(SMOKE, tmp_path_factory.mktemp("results") / "studies/smoke")
