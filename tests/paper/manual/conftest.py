"""Folders in which the blocks of a page run, and the manual as HTML."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from manual.pages import PAGES
from report.setting import PICTURE, set_up

from pulling_by_pushing.report.manual import build_manual
from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

#: The datasets that pages read, with the parts of their grids that suffice.
READ = {
    "data/motion_cones.nc": (PAPER_FILE, {}),
    "data/contact_modes.nc": (
        PAPER_FILE,
        {"contact": ["coulomb_1.4"], "rod_length": [2.0]},
    ),
    **{
        f"studies/my_study/data/{name}.nc": (
            "src/pulling_by_pushing/study/templates/my_study.yaml",
            {},
        )
        for name in ("limit_curves", "curves", "motion_cones", "contact_modes", "mode_maps")
    },
    "studies/sliders/data/support_cones.nc": (
        SLIDERS_FILE,
        {"rod_length": [2.0], "rod_angle": [45.0], "friction_coefficient": [0.25]},
    ),
}
#: What a page finds beside it, as in the project's folder.
BESIDE = ("Snakefile", "profiles", "workflow", "src", "tests", "pyproject.toml")
#: Lines of a file of which a page shows some.
LINES = 20
#: Cells that did not run have no language yet.
UNEXECUTED = ("-D", "nb_execution_mode=off", "-D", "suppress_warnings=myst-nb.lexer")


@pytest.fixture(scope="session")
def filled(tmp_path_factory):
    """Results with the datasets that pages read."""
    folder = tmp_path_factory.mktemp("results")
    for file, (study, part) in READ.items():
        name = Path(file).stem
        values = study_slice(load_study(study), name)
        values["grid"] |= part
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        build.dataset(folder / file, name=name, study=values, marks={})
    return folder


@pytest.fixture
def folder(filled, tmp_path, monkeypatch):
    """A folder like the project's, in which a page writes its own files."""
    _link(tmp_path, *BESIDE, "paper", "CITATION.cff")
    (tmp_path / "results").symlink_to(filled)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def _link(folder, *names):
    for name in names:
        (folder / name).symlink_to(Path(name).resolve())


@pytest.fixture(scope="session")
def html(tmp_path_factory):
    """The manual, its notebooks not executed."""
    return pages_as_html(tmp_path_factory.mktemp("manual"))


def pages_as_html(root):
    """The manual as HTML, from results of marked numbers and pictures; notebooks are not executed."""
    set_up(root)
    _link(root, *BESIDE)
    shutil.copy("results/README.md", root / "results")
    for name in ("impact", "pulling_with_inertia"):
        (root / f"results/figures/simulation_{name}.svg").write_text(PICTURE, encoding="utf-8")
    for page in PAGES:
        for name in re.findall(
            r"results/([\w/]+\.(?:svg|png|txt))", page.read_text(encoding="utf-8")
        ):
            shown = root / "results" / name
            shown.parent.mkdir(parents=True, exist_ok=True)
            shown.write_text(PICTURE + "\n" * LINES, encoding="utf-8")
    build_manual(root / "paper/manual", root / "html", *UNEXECUTED)
    return root / "html"
