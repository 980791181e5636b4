"""The command `run` builds a study with the workflow that the package has."""

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from snakemake.cli import parse_config

from pulling_by_pushing.commands.run import config_path, snakefile

TINY = """title: Two rods
slider: {rod_angle: 45}
support_friction: {weight: 1}
grid:
  effects: [support_friction]
  rod_length: [1, 2]
  rod_angle: [45]
  friction_coefficient: [0.5, inf]
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder of a user's own, with a tiny study."""
    place = tmp_path / "a folder"
    place.mkdir()
    (place / "tiny.yaml").write_text(TINY, encoding="utf-8")
    monkeypatch.chdir(place)
    return place


@pytest.fixture
def called(monkeypatch):
    """The calls of Snakemake, of which none is made; what each exits with."""
    calls, codes = [], [0]

    def fake(words, **options):
        calls.append((words, options))
        return subprocess.CompletedProcess(words, codes[0])

    monkeypatch.setattr(subprocess, "run", fake)
    return calls, codes


def test_snakemake_is_called_with_the_workflow_of_the_package(run, folder, called, monkeypatch):
    monkeypatch.setenv("SNAKEMAKE_PROFILE", "elsewhere")
    code, out, _ = run("run", "tiny.yaml", "--cores", "1", "--results", "my results", "--dry-run")
    ((words, options),) = called[0]
    assert code == 0
    assert words[:3] == [sys.executable, "-m", "snakemake"]
    assert words[words.index("--snakefile") + 1] == str(snakefile())
    assert words[-6:] == [
        "--cores", "1", "--dry-run", "--config", "study=tiny.yaml", "results=my results"
    ]  # fmt: skip
    assert "SNAKEMAKE_PROFILE" not in options["env"]
    assert out == ("results: my results/studies/tiny\nbuilt: nothing (dry run)\n")


def test_what_comes_next_is_a_command_that_works(run, folder, called):
    assert run("run", "tiny.yaml")[1].splitlines()[1] == (
        "to list its datasets: planar-pushing query --study tiny"
    )
    _, out, _ = run("run", "tiny.yaml", "--results", "my results")
    assert out.endswith("planar-pushing query --study tiny --results 'my results'\n")


def test_a_job_that_fails_is_said(run, folder, called):
    called[1][0] = 1
    code, out, _ = run("run", "tiny.yaml")
    assert code == 1
    assert out == "results: results/studies/tiny\nbuilt: incomplete; see the lines above\n"


@pytest.mark.parametrize(("number", "code", "said"), [
    (signal.SIGINT, 130, "planar-pushing: interrupted\n"),
    (signal.SIGTERM, 143, "planar-pushing: terminated\n"),
])  # fmt: skip
def test_ctrl_c_is_snakemakes_and_ends_the_command(run, folder, monkeypatch, number, code, said):
    def interrupted(words, **options):
        os.kill(os.getpid(), number)
        return subprocess.CompletedProcess(words, 1)

    before = signal.getsignal(number)
    monkeypatch.setattr(subprocess, "run", interrupted)
    assert run("run", "tiny.yaml") == (code, "", said)
    assert signal.getsignal(number) is before


def test_sigterm_is_passed_on_to_snakemake(run, folder, monkeypatch):
    """The terminal sends Ctrl-C to all processes of a command, and nobody sends them SIGTERM."""
    real = subprocess.run

    def asleep(words, **options):
        timer = threading.Timer(0.5, os.kill, [os.getpid(), signal.SIGTERM])
        timer.start()
        ended = real([sys.executable, "-c", "import time; time.sleep(60)"], check=False)
        assert ended.returncode == -signal.SIGTERM
        return ended

    monkeypatch.setattr(subprocess, "run", asleep)
    assert run("run", "tiny.yaml") == (143, "", "planar-pushing: terminated\n")


@pytest.mark.parametrize(("arguments", "said"), [
    (["nowhere.yaml"], "nowhere.yaml: no such file"),
    (["tiny.yaml", "--cores", "0"], "cores: 0 given; allowed: a whole number >= 1; leave it out"),
    (["tiny.yaml", "--results", "{x}"], "results: '{x}' given; allowed: the path of a folder"),
    (["my study.yaml"], "my study.yaml: 'my study' names the study; allowed: names of letters"),
    (["paper.yaml"], "paper.yaml: 'paper' names the paper's study, workflow/config/paper.yaml in"),
    (["bad.yaml"], "bad.yaml: figures.figure_99: unknown; allowed: figure_01"),
], ids=str)  # fmt: skip
def test_wrong_input_is_one_line_and_starts_nothing(refused, folder, called, arguments, said):
    (folder / "bad.yaml").write_text(f"{TINY}figures: {{figure_99: {{}}}}\n", encoding="utf-8")
    refused(["run", *arguments], said)
    assert not called[0]


@pytest.mark.parametrize(("missing", "extra"), [
    ("snakemake", "workflow"), ("matplotlib", "figures"), ("dask", "chunks"),
])  # fmt: skip
def test_an_extra_that_is_missing_is_named(refused, folder, called, monkeypatch, missing, extra):
    chunks = "chunks: {motion_cones: {rod_length: 1}}\n"
    (folder / "tiny.yaml").write_text(TINY + chunks, encoding="utf-8")
    monkeypatch.setattr(
        "planar_pushing.terms.extras.find_spec", lambda name: None if name == missing else name
    )
    said = (
        f"{missing}: not installed; install the extra {extra}: pip install '.[{extra}]' in the "
        "project's folder"
    )
    refused(["run", "tiny.yaml"], said)
    assert not called[0]


def test_a_study_is_built_in_any_folder(run, folder):
    """By Snakemake itself; a second run finds everything built."""
    assert run("run", "tiny.yaml", "--cores", "1")[0] == 0
    built = Path("results/studies/tiny/data/motion_cones.nc")
    before = built.stat().st_mtime_ns
    assert run("run", "tiny.yaml", "--cores", "1")[0] == 0
    assert built.stat().st_mtime_ns == before
    asked = ["--effects", "support_friction", "--rod-length", "2", "--friction-coefficient", "inf"]
    code, out, _ = run("query", "motion_cones", "--study", "tiny", *asked)
    assert code == 0
    assert "148.610391" in out


@pytest.mark.parametrize(
    "path", ["results", "my results", "2026", "1e3", "-7", "nan", "True", "it's/a.yaml"]
)
def test_snakemake_reads_paths_as_text(path):
    (read,) = parse_config([f"results={config_path(Path(path))}"]).values()
    assert isinstance(read, str)
    assert Path(read) == Path(path)
