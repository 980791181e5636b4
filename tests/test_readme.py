"""What README shows is what the program prints."""

import doctest
import re
from pathlib import Path

import pytest

from planar_pushing.commands import main
from planar_pushing.report import costs
from planar_pushing.study.builders import build_dataset
from planar_pushing.study.slices import study_slice
from planar_pushing.study.storage.store import read_dataset, write_dataset
from planar_pushing.study.study_file import load_study

README = Path("README.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the datasets that README queries, and its scene file."""
    root = tmp_path_factory.mktemp("readme")
    study = load_study("workflow/config/paper.yaml")
    cones = build_dataset("motion_cones", study_slice(study, "motion_cones"))
    write_dataset(cones, root / "results/data/motion_cones.nc")
    values = study_slice(study, "contact_modes")
    values["grid"] |= {"contact_friction_coefficient": [1.4], "rod_length": [2.0]}
    modes = build_dataset("contact_modes", values)
    write_dataset(modes, root / "results/data/contact_modes.nc")
    scene = re.search(r"```yaml\n# scene.yaml\n(.*?)```", README, re.DOTALL)
    (root / "scene.yaml").write_text(scene[1], encoding="utf-8")
    return root


def test_python_queries(folder, monkeypatch):
    monkeypatch.chdir(folder)
    blocks = re.findall(r"```python\n(>>> .*?)```", README, re.DOTALL)
    assert len(blocks) == 7
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "README", "README.md", 0)
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    runner.run(test)
    assert (runner.tries, runner.failures) == (30, 0)


def test_shell_queries(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    shown = re.findall(r"^\$ planar-pushing (.*)\n((?:.+\n)*)", README, re.MULTILINE)
    assert len(shown) == 2
    for command, said in shown:
        assert main(command.split()) == 0
        assert capsys.readouterr().out == said.removesuffix("```\n")


def test_python_scene(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    code = re.search(r"```python\n(import numpy.*?)```", README, re.DOTALL)
    exec(compile(code[1], "README.md", "exec"), {})
    assert capsys.readouterr().out.startswith("SLIP_RIGHT [-0.278")


def test_errors_of_the_models_are_those_of_the_report():
    """Both give the numbers of the certified comparison, with the same digits."""
    cone = read_dataset("tests/evidence/costs/golden_accuracy.nc", "cone")
    ellipsoid, quartic = (costs.cone_error(cone, name) for name in ("ellipsoid", "convex quartic"))
    rim = {name: float(cone.rim_error.sel(model=name)) for name in ("ellipsoid", "quartic")}
    for said in (
        f"{quartic:.2f} degrees and an ellipsoid by up to {ellipsoid:.1f}",
        f"{rim['quartic']:.2f} and {rim['ellipsoid']:.2f} degrees",
    ):
        assert said in README.replace("\n", " ")
