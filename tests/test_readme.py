"""What README shows is what the program prints and draws, and what it links to is there."""

import doctest
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_pushing.commands import main
from planar_pushing.study.build import build_dataset
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study
from shown import Checker

PATH = Path("README.md").resolve()
README = PATH.read_text(encoding="utf-8")
ANIMATION = PATH.parent / "paper/manual/pictures/pulling.gif"
#: Largest root mean square difference of two frames' colour levels, 0 to 255: text moves a little.
TOLERANCE = 4.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the dataset that README queries, its scene file, and the scenes of the project."""
    root = tmp_path_factory.mktemp("readme")
    study = load_study("workflow/config/paper.yaml")
    cones = build_dataset("motion_cones", study_slice(study, "motion_cones"))
    write_dataset(cones, root / "results/data/motion_cones.nc")
    scene = re.search(r"```yaml\n# scene.yaml\n(.*?)```", README, re.DOTALL)
    (root / "scene.yaml").write_text(scene[1], encoding="utf-8")
    (root / "workflow").symlink_to(PATH.parent / "workflow")
    return root


def test_python_query(folder, monkeypatch):
    monkeypatch.chdir(folder)
    (block,) = re.findall(r"```python\n(>>> .*?)```", README, re.DOTALL)
    test = doctest.DocTestParser().get_doctest(block, {}, "README", "README.md", 0)
    runner = doctest.DocTestRunner(Checker(), optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test)
    assert (runner.tries, runner.failures) == (4, 0)


def test_shell_query(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    ((command, said),) = re.findall(r"^\$ planar-pushing (.*)\n((?:.+\n)*)", README, re.MULTILINE)
    assert main(command.split()) == 0
    assert capsys.readouterr().out == said.removesuffix("```\n")


def test_python_call_finds_what_the_shell_does(folder, monkeypatch):
    monkeypatch.chdir(folder)
    import planar_pushing as pp

    (call,) = re.findall(r"In Python it is `(.*)`", README)
    (solution,) = eval(call, {"pp": pp, "np": np})
    assert f"force: {solution.force[0]:.12g}" in README


def frames(path):
    """Every picture of an animation, as colour levels."""
    with Image.open(path) as image:
        for number in range(image.n_frames):
            image.seek(number)
            yield np.asarray(image.convert("RGB"), dtype=float)


def test_commands_make_the_animation(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    commands = re.findall(r"^planar-pushing ((?:simulate|animate) .*)$", README, re.MULTILINE)
    assert len(commands) == 2
    assert [main(command.split()) for command in commands] == [0, 0]
    capsys.readouterr()
    for new, stored in zip(frames("pulling.gif"), frames(ANIMATION), strict=True):
        assert new.shape == stored.shape
        assert np.sqrt(np.mean((new - stored) ** 2)) < TOLERANCE


def test_links_lead_to_files():
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert ANIMATION.relative_to(PATH.parent).as_posix() in links
    for link in links:
        assert (PATH.parent / link).is_file(), link
