"""An installed package, away from the project's folder: with all extras, and with none and no compiler."""

import os
import shutil
import subprocess
import sys
import zipfile
from importlib.metadata import distributions, packages_distributions
from pathlib import Path

import pytest
from commands.test_run import TINY
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from workflow.conftest import PROJECT

pytestmark = pytest.mark.slow
#: Answers of the library, from a process that can import only some of the packages.
LIBRARY = """
import sys
for name in {missing}:
    sys.modules.setdefault(name, None)
import planar_pushing as pp
feet = pp.SupportFriction(support=pp.Points([(-1, -1), (1, -1), (0, 1)]))
slider = pp.Slider(rod_length=2.0, rod_angle=1.0, radius=1.5)
pusher = pp.Pusher(velocity=(0.3, 1.0))
for effects in ((pp.RingFriction(),), (feet, pp.Inertia()), (feet, pp.Load(force=(0.1, -0.2)))):
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
    print(pp.solve(scene, 1.0).to_json())
    print(pp.motion_cone(scene), pp.can_pull(scene), pp.slips_while_pushing(scene))
    for options in ({{}}, {{"method": "time-stepping", "step": 0.02}}):
        log = pp.simulate(scene, pusher=pusher, duration=0.5, **options)
        print(log.rod_angle.values.tolist(), log.force.values.tolist(), log.evaluations.values[-1])
    print(pp.simulate_batch(scene, pusher=pusher, duration=0.5).rod_angle.item())
"""


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
    return folder / "site"


def needed(site):
    """The distributions that an installation without extras brings."""
    found, rest = set(), {"planar-pushing"}
    while rest:
        found |= rest
        parts = [next(distributions(name=each, path=[str(site), *sys.path])) for each in rest]
        wanted = [Requirement(line) for part in parts for line in part.requires or ()]
        active = [each for each in wanted if not each.marker or each.marker.evaluate({"extra": ""})]
        rest = {canonicalize_name(each.name) for each in active} - found
    return found


def answers(site):
    """What the library says without the packages that it does not require, and its warnings."""
    kept = needed(site)
    missing = [
        name
        for name, owners in packages_distributions().items()
        if not kept & set(map(canonicalize_name, owners))
    ]
    ran = subprocess.run(
        [sys.executable, "-c", LIBRARY.format(missing=missing)],
        env=os.environ | {"PYTHONPATH": str(site)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    return ran.stdout, ran.stderr


def test_without_extras_and_without_a_compiler_the_library_gives_the_same_answers(
    installed, tmp_path
):
    plain = tmp_path / "site"
    shutil.copytree(installed, plain, ignore=shutil.ignore_patterns("_compiled.*"))
    said, warned = answers(plain)
    assert "PlainCoreWarning: the core runs as plain Python" in warned
    assert answers(installed) == (said, "")


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
    assert str(installed / "pulling_by_pushing/workflow/profiles/default") in said
    assert "148.610391" in command("query", "motion_cones", "--study", "tiny")
    assert "passed" in command("check", "--study", "tiny.yaml", "--points", "2")


def test_the_study_that_init_writes_asks_for_no_file_of_the_project(command, tmp_path):
    said = command("init", "mine")
    assert "to build it: planar-pushing run mine/my_study.yaml" in said
    planned = command("run", "mine/my_study.yaml", "--dry-run")
    assert "claims" not in planned
    assert Path(tmp_path / "results").exists() is False
