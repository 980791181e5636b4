"""The owner of a folder: one at a time, and gone with its process."""

import subprocess
import sys

import pytest

from planar_pushing.study.running import locks
from planar_pushing.study.running.locks import own_the_folder

HOLD = """
from planar_pushing.study.running.locks import own_the_folder
print(own_the_folder({folder!r}), flush=True)
input()
"""


@pytest.fixture(autouse=True)
def owned(monkeypatch):
    """The locks that a test holds, released after it; a process otherwise holds its locks until it ends."""
    held = {}
    monkeypatch.setattr(locks, "_HELD", held)
    yield
    for file in held.values():
        file.close()


def holder(folder):
    """A process that owns, or does not own, the folder until it is killed."""
    run = subprocess.Popen(
        [sys.executable, "-c", HOLD.format(folder=str(folder))],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    return run, run.stdout.readline().strip()


def end(run):
    run.kill()
    run.communicate()


def test_what_a_killed_run_left_is_cleared_and_a_living_one_is_left_alone(tmp_path):
    left = tmp_path / "locks/0.output.lock"
    left.parent.mkdir()
    first, owns = holder(tmp_path)
    assert owns == "True"
    left.write_text("results/paper.pdf")
    second, owns = holder(tmp_path)
    end(second)
    assert owns == "False"
    assert not own_the_folder(tmp_path)
    assert left.exists()
    end(first)
    assert own_the_folder(tmp_path)
    assert not left.exists()


def test_an_owner_stays_the_owner(tmp_path):
    assert own_the_folder(tmp_path / "here")
    (tmp_path / "here/locks").mkdir()
    (tmp_path / "here/locks/0.input.lock").write_text("")
    assert own_the_folder(tmp_path / "here")
    assert (tmp_path / "here/locks/0.input.lock").exists()
