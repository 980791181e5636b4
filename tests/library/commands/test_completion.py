"""The command `completion`: what a shell completes with the script."""

import shutil
import subprocess

import pytest

from planar_pushing.commands.completion import SHELLS

BASH = shutil.which("bash")
TRIED = """
COMP_WORDS=({words})
COMP_CWORD={last}
_shtab_planar_pushing
echo "${{COMPREPLY[@]}}"
"""


@pytest.fixture
def completed(run):
    """Words that bash completes at the end of some words."""
    _, script, _ = run("completion", "bash")

    def call(*words):
        quoted = " ".join(f"'{word}'" for word in words)
        body = script + TRIED.format(words=quoted, last=len(words) - 1)
        done = subprocess.run([BASH, "-c", body], capture_output=True, text=True, check=True)
        return done.stdout.split()

    return call


@pytest.mark.skipif(BASH is None, reason="needs bash")
@pytest.mark.parametrize(("words", "expected"), [
    (["s"], ["solve", "simulate", "schema"]),
    (["--v"], ["--version"]),
    (["simulate", "scene.yaml", "--on-ambiguity", "s"],
     ["separate", "stay-in-mode", "stick", "slip-right", "slip-left"]),
    (["query", "motion_cones", "--rod"], ["--rod-angle", "--rod-length"]),
    (["query", "mot"], ["motion_cones"]),
    (["query", "acc"], ["acceleration_centers", "accuracy/cone", "accuracy/motion", "accuracy/wrench",
     "accuracy_time/cone", "accuracy_time/motion", "accuracy_time/wrench"]),
    (["query", "scen"], []),
    (["query", "motion_cones", "--effects", "in"], ["inertia"]),
    (["identify", "pushes.nc", "--family", ""], ["points", "uniform_and_corners", "ellipse", "map"]),
    (["query", "motion_cones", "--rod-length", ""], []),
    (["run", "study.yaml", "--"], ["--help", "--json", "--results", "--cores", "--dry-run"]),
    (["solve", "scene"], []),
], ids=str)  # fmt: skip
def test_bash(completed, words, expected):
    assert completed("planar-pushing", *words) == expected


@pytest.mark.skipif(BASH is None, reason="needs bash")
def test_studies_that_are_built_are_offered(completed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    asked = ("planar-pushing", "query", "motion_cones", "--study", "")
    assert completed(*asked) == ["paper"]
    for name in ("mine", "yours"):
        (tmp_path / "results/studies" / name).mkdir(parents=True)
    assert completed(*asked) == ["paper", "mine", "yours"]


#: Commands that read a script from standard input and check it.
CHECKS = {"zsh": ["zsh", "-n"], "fish": ["fish", "--no-execute"], "tcsh": ["tcsh", "-f", "-n"]}


@pytest.mark.parametrize("shell", SHELLS)
def test_a_script_names_what_it_completes(run, shell):
    _, script, _ = run("completion", shell)
    if shell in CHECKS and shutil.which(shell):
        subprocess.run(CHECKS[shell], input=script, text=True, check=True)
    words = (
        "planar-pushing",
        "simulate",
        "on-ambiguity",
        "stay-in-mode",
        "rod-length",
        "ls results",
    )
    assert all(word in script for word in words)


def test_another_shell(refused):
    refused(
        ["completion", "ksh"],
        f"shell: 'ksh' given; allowed: {', '.join(SHELLS)}; did you mean zsh?",
    )
