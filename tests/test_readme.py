"""README shows what the program prints and draws, and its links lead to files."""

import doctest
import json
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import planar_pushing as pp
from planar_pushing.commands import main
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.figures import images, render
from pulling_by_pushing.figures.measured import PUSHES_FILE
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study
from shown import Checker

PATH = Path("README.md").resolve()
README = PATH.read_text(encoding="utf-8")
ANIMATION = PATH.parent / "paper/manual/pictures/pulling.gif"
MEASURED = PATH.parent / "tests/golden/images/measured_pressures.png"
#: Largest root mean square difference of two frames' color levels, 0 to 255: text moves a little.
TOLERANCE = 4.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the dataset that README queries and the scenes of the project."""
    root = tmp_path_factory.mktemp("readme")
    study = load_study("workflow/config/paper.yaml")
    cones = build_dataset("motion_cones", study_slice(study, "motion_cones"))
    write_dataset(cones, root / "results/data/motion_cones.nc")
    (root / "workflow").symlink_to(PATH.parent / "workflow")
    return root


def test_python(folder, monkeypatch):
    monkeypatch.chdir(folder)
    blocks = re.findall(r"```python\n(>>> .*?)```", README, re.DOTALL)
    assert len(blocks) == README.count("```python") == 2
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "README", "README.md", 0)
    runner = doctest.DocTestRunner(Checker(), optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test, clear_globs=False)
    assert (runner.tries, runner.failures) == (13, 0)
    (call,) = re.findall(r"`pp\.(draw\(.*?\))` draws", README)
    assert eval(f"pp.{call}", test.globs) is not None


def frames(path):
    """Every picture of an animation, as color levels."""
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


def test_the_measured_picture_is_that_of_the_report(tmp_path):
    assert MEASURED.relative_to(PATH.parent).as_posix() in README
    picture = tmp_path / "measured_pressures.png"
    render.figure(name="measured_pressures", results="results", png=picture)
    assert images.difference(picture, MEASURED) < TOLERANCE


def test_numbers_of_measured_pushes():
    found = json.loads(Path(PUSHES_FILE).read_text(encoding="utf-8"))
    feet, face = found["three_feet"], found["patch"]
    (each,) = {log["pushes"] for log in (feet["logs"] | face["logs"]).values()}
    assert f"{each} in each panel" in README
    assert f"the {feet['pushes']} pushes on three feet" in README
    motion = feet["comparison"]["motion"]
    models = ("identified", "fitted_ellipsoid", "fitted_quartic")
    numbers = [f"{motion[model]['median']:.1f}" for model in models]
    assert re.findall(r"(\d+\.\d) degrees", README) == numbers
    # The sentences on gains that are not significant.
    low, high = face["against_quartic"]["motion"]["ratio_interval"]
    assert low < 1.0 < high
    low, high = feet["comparison"]["wrench"]["identified"]["ratio_interval"]
    assert low < 1.0 < high


def test_links_lead_to_files():
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert ANIMATION.relative_to(PATH.parent).as_posix() in links
    for link in links:
        assert (PATH.parent / link).is_file(), link


def test_the_citation_names_the_last_release():
    changes = (PATH.parent / "CHANGELOG.md").read_text(encoding="utf-8")
    version, date = re.search(r"^## (\d\S*) \((\S+)\)$", changes, re.MULTILINE).groups()
    citation = (PATH.parent / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\nversion: {version}\ndate-released: {date}\n" in citation
    assert version == pp.__version__
