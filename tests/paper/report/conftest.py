"""Folders from which the report can be set."""

from __future__ import annotations

from pathlib import Path

import pytest
from report.setting import Setting, set_up


@pytest.fixture(scope="session")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Setting:
    """A folder that no test changes."""
    return set_up(tmp_path_factory.mktemp("report"))


@pytest.fixture
def setting(tmp_path: Path) -> Setting:
    """A folder of the test's own."""
    return set_up(tmp_path / "report")
