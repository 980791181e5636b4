"""The tests of Ctrl-C pass where whoever started them ignores it."""

import subprocess
import sys
from pathlib import Path

import pytest

from signals import uninterruptible

TESTS = Path(__file__).parent
#: The tests of the workflow are started by themselves.
FILES = [
    path
    for path in TESTS.rglob("test_*.py")
    if path != Path(__file__)
    and "def test_ctrl_c" in path.read_text(encoding="utf-8")
    and "workflow" not in path.relative_to(TESTS).parts
]


@pytest.mark.slow
def test_they_pass_in_the_background():
    assert len(FILES) >= 2
    found = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-k", "ctrl_c", *FILES],
        cwd=TESTS.parent, capture_output=True, text=True, check=False, preexec_fn=uninterruptible,
    )  # fmt: skip
    assert found.returncode == 0, found.stdout[-3000:]
