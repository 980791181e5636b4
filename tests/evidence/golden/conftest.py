"""The smallest study's results, computed once."""

import pytest

from evidence.golden.studies import write_results
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"


@pytest.fixture(scope="session")
def smoke():
    return load_study(SMOKE)


@pytest.fixture(scope="session")
def smoke_results(smoke, tmp_path_factory):
    return write_results(smoke, tmp_path_factory.mktemp("smoke"))
