"""The command line in this process, and a log."""

import pytest

from command_line import refused as refused
from command_line import run as run
from planar_pushing.commands import main


@pytest.fixture(scope="session")
def log(tmp_path_factory):
    path = tmp_path_factory.mktemp("log") / "log.nc"
    assert main(["simulate", "workflow/scenes/pulling.yaml", "-o", str(path)]) == 0
    return path
