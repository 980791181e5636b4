"""An installed package, away from the project's folder: its wheel has what `planar-pushing run` needs."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from commands.test_run import TINY
from planar_pushing.simulation import machine_code
from workflow.conftest import PROJECT

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """A folder into which the wheel is unpacked, as its installation does."""
    pytest.importorskip("hatchling")
    folder = tmp_path_factory.mktemp("installed")
    build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory"]
    subprocess.run([*build, str(folder / "dist")], cwd=PROJECT, check=True, capture_output=True)
    (wheel,) = (folder / "dist").glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder / "site")
    compiled = folder / "site" / machine_code.folder().relative_to(PROJECT / "src")
    compiled.parent.mkdir(parents=True)
    compiled.symlink_to(machine_code.folder())  # what is compiled serves every place
    return folder / "site"


@pytest.fixture
def command(installed, tmp_path):
    """Run a command of the installed package in a folder of one's own."""

    def call(*arguments, code=0):
        done = subprocess.run(
            [sys.executable, "-m", "planar_pushing", *arguments], cwd=tmp_path,
            env=os.environ | {"PYTHONPATH": str(installed)},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout + done.stderr

    return call


def test_a_study_is_built_read_and_certified(command, tmp_path, installed):
    (tmp_path / "tiny.yaml").write_text(TINY, encoding="utf-8")
    said = command("run", "tiny.yaml", "--cores", "1")
    assert str(installed / "planar_pushing/workflow/profiles/default") in said
    assert "148.610391" in command("query", "motion_cones", "--study", "tiny")
    assert "passed" in command("check", "--study", "tiny.yaml", "--points", "2")


def test_the_study_that_init_writes_asks_for_no_file_of_the_project(command, tmp_path):
    said = command("init", "mine")
    assert "to build it: planar-pushing run mine/my_study.yaml" in said
    planned = command("run", "mine/my_study.yaml", "--dry-run")
    assert "claims" not in planned
    assert Path(tmp_path / "results").exists() is False
