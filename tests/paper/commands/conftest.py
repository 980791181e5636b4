"""The command line in this process, and results that it queries."""

import shutil

import pytest

from command_line import refused as refused
from command_line import run as run
from smoke import smoke_results


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """A folder of results with two datasets of the smoke study."""
    folder = tmp_path_factory.mktemp("results")
    (folder / "data").mkdir()
    for name in ("motion_cones", "contact_modes"):
        shutil.copy(smoke_results(tmp_path_factory) / f"data/{name}.nc", folder / "data")
    return str(folder)
