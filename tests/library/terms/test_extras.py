"""Packages that the library needs, and those of its extras."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from planar_pushing.terms.errors import MissingExtra
from planar_pushing.terms.extras import EXTRAS, require_extra

PROJECT = tomllib.loads(Path("pyproject.toml").read_text(encoding="utf-8"))["project"]
#: Packages that are imported by another name than they are installed by.
INSTALLED = {
    "PIL": "pillow",
    "flint": "python-flint",
    "myst_nb": "myst-nb",
    "snakemake_executor_plugin_slurm": "snakemake-executor-plugin-slurm",
}

WITHOUT = """
import sys
for name in {names!r}:
    sys.modules[name] = None
{body}
"""


def run(names, body, *arguments):
    """Run Python as if some packages were not installed."""
    code = WITHOUT.format(names=list(names), body=body)
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=False
    )


def names_of(requirements):
    return {re.split(r"[\[<>=]", each)[0] for each in requirements}


@pytest.mark.parametrize("extra", EXTRAS)
def test_each_extra_brings_what_is_looked_for(extra):
    brought = names_of(PROJECT["optional-dependencies"][extra])
    assert {INSTALLED.get(name, name) for name in EXTRAS[extra]} <= brought


def test_every_extra_is_known():
    assert set(PROJECT["optional-dependencies"]) == {*EXTRAS, "test"}


def test_the_library_needs_no_extra():
    optional = set().union(*map(names_of, PROJECT["optional-dependencies"].values()))
    assert not names_of(PROJECT["dependencies"]) & optional


COMMANDS = """
from planar_pushing.commands import main
import planar_pushing as pp
import pulling_by_pushing.study.running.build
scene = pp.load_scene("workflow/scenes/figure_08.yaml")
pp.save_scene(scene, sys.argv[1] + "/scene.yaml")
for command in (
    ["solve", sys.argv[1] + "/scene.yaml", "--pusher-angle", "165", "--json"],
    ["cone", "workflow/scenes/figure_08.yaml"],
    ["simulate", "workflow/scenes/pulling.yaml", "-o", sys.argv[1] + "/log.nc"],
    ["query", "motion_cones", "--results", sys.argv[2], "--rod-length", "2"],
):
    assert main(command) == 0, command
"""


def test_the_library_runs_without_any_extra(tmp_path, cones):
    extras = [name for names in EXTRAS.values() for name in names]
    ended = run(extras, COMMANDS, str(tmp_path), cones)
    assert ended.returncode == 0, ended.stderr
    assert json.loads(ended.stdout[: ended.stdout.index("\n}\n") + 2])["outcome"] == "UNIQUE"


@pytest.mark.parametrize(("extra", "missing", "body"), [
    ("figures", "matplotlib", "import planar_pushing.drawing.draw"),
    ("figures", "PIL", "import planar_pushing.drawing.animate"),
    ("report", "typst", "import pulling_by_pushing.report.typeset"),
    ("manual", "furo", "from pulling_by_pushing.report.manual import build_manual as b; b('a', 'b')"),
    ("golden", "flint", "import pulling_by_pushing.oracle.support"),
    ("golden", "flint", "import pulling_by_pushing.evidence.proofs.verdicts"),
    ("chunks", "dask", "from pulling_by_pushing.study.chunks import open_chunks; open_chunks('a', {}, {})"),
])  # fmt: skip
def test_a_missing_extra_is_named_where_it_is_needed(extra, missing, body):
    ended = run([missing], body)
    said = (
        f"{missing}: not installed; install the extra {extra}: pip install '.[{extra}]' in the "
        "project's folder"
    )
    assert ended.returncode == 1
    assert ended.stderr.rstrip().endswith(f"MissingExtra: {said}")


def test_a_command_names_the_missing_extra_in_one_line(tmp_path):
    body = "from planar_pushing.commands import main; sys.exit(main(sys.argv[1:]))"
    scene = "workflow/scenes/figure_08.yaml"
    ended = run(["matplotlib"], body, "draw", scene, "-o", str(tmp_path / "scene.svg"))
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr == (
        "planar-pushing draw: matplotlib: not installed; install the extra figures: "
        "pip install '.[figures]' in the project's folder\n"
    )


def test_what_is_installed_is_not_missing(monkeypatch):
    for extra in EXTRAS:
        require_extra(extra)
    monkeypatch.setitem(EXTRAS, "figures", ("no_such_package", "matplotlib"))
    with pytest.raises(MissingExtra, match=r"^no_such_package: not installed"):
        require_extra("figures")
