"""The Makefile's set-up: one at a time, in its own environment, and in no folder with a space."""

import os
import re
import shutil
import signal
import subprocess
import sys

import pytest

from workflow.conftest import PROJECT

LOCKS = ("library.lock", "results.lock", "chunks.lock", "requirements.lock")
#: A Python that sets up nothing, and notes that it was asked to.
PYTHON = """#!/bin/sh
if [ "$1" = workflow/alone.py ]; then exec {python} "$@"; fi
echo "set up" >> log
mkdir -p .venv/bin
printf '#!/bin/sh\\nsleep 0.3\\n' > .venv/bin/python
for each in planar-pushing snakemake; do cp .venv/bin/python .venv/bin/$each; done
chmod +x .venv/bin/*
"""


@pytest.fixture
def folder(tmp_path):
    for name in ("Makefile", *LOCKS, "pyproject.toml", "workflow/alone.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(PROJECT / name, tmp_path / name)
    for name in ("mechanics", "simulation"):
        (tmp_path / "src/planar_pushing" / name).mkdir(parents=True)
    (tmp_path / "python").write_text(PYTHON.format(python=sys.executable), encoding="utf-8")
    (tmp_path / "python").chmod(0o755)
    return tmp_path


def start(folder, *arguments, **variables):
    return subprocess.Popen(
        ["make", "PYTHON=./python", *arguments], cwd=folder, env=os.environ | variables,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip


def test_of_two_at_once_the_second_waits_and_finds_it_made(folder):
    runs = [start(folder, ".venv/compiled") for _ in range(2)]
    said = [run.communicate()[0] for run in runs]
    assert [run.returncode for run in runs] == [0, 0], said
    assert (folder / "log").read_text() == "set up\n"
    assert any("another make is setting up this folder; waiting for it" in each for each in said)


def test_ctrl_c_ends_the_setting_up_without_a_traceback(tmp_path):
    run = subprocess.Popen(
        [sys.executable, PROJECT / "workflow/alone.py", "sh", "-c", "echo started; exec sleep 60"],
        cwd=tmp_path, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    assert run.stdout.readline() == "started\n"
    run.send_signal(signal.SIGINT)
    assert run.communicate()[0] == ""
    assert run.returncode == 130


def test_what_python_has_elsewhere_and_a_home_that_is_not_ours_stay_out(folder):
    show = ("--eval=show: ; @env", "show")
    said = start(folder, *show, PYTHONPATH="/foreign", HOME="/nonexistent").communicate()[0]
    found = dict(line.split("=", 1) for line in said.splitlines() if "=" in line)
    assert "PYTHONPATH" not in found
    assert found["HOME"] == str(folder / ".snakemake/home")
    assert found["XDG_CACHE_HOME"].startswith(found["HOME"])
    mine = start(folder, *show, HOME=str(folder)).communicate()[0]
    assert f"HOME={folder}\n" in mine


def pins(name):
    """Versions by package; for which systems they are meant follows from who needs them."""
    lines = (PROJECT / name).read_text(encoding="utf-8").splitlines()
    return dict(re.split("==| ", line)[:2] for line in lines if re.match(r"[\w-]+==", line))


def test_what_a_part_needs_is_locked_as_everything_is():
    library, results, chunks, everything = map(pins, LOCKS)
    assert {"numba", "numpy", "xarray"} <= set(library)
    assert {"snakemake", "matplotlib", "bokeh", "python-flint"} <= set(results)
    assert "dask" in chunks
    assert not {"pytest", "sphinx", "distributed"} & set(chunks)
    # xarray imports dask wherever it is, in every job.
    assert "dask" not in results
    assert library.items() <= results.items() <= chunks.items() <= everything.items()


def test_chunks_tests_and_manual_have_packages_of_their_own(folder):
    for wanted, brought in (
        ("all", set()),
        ("STUDY=a.yaml", {"chunks"}),
        (".venv/tools", {"chunks", "tools"}),
    ):
        run = start(folder, wanted)
        assert run.communicate()[0]
        assert run.returncode == 0
        assert {path.name for path in (folder / ".venv").iterdir() if path.is_file()} == {
            "library", "ready", "compiled", *brought,
        }  # fmt: skip
    assert (folder / "log").read_text() == "set up\n"


def test_a_folder_with_a_space_is_refused_with_one_message(folder):
    spaced = folder / "a folder"
    spaced.mkdir()
    shutil.copy(PROJECT / "Makefile", spaced)
    run = start(spaced)
    said = run.communicate()[0]
    assert run.returncode == 2
    assert "a folder: Snakemake runs in no folder with a space; move the project" in said
    assert said.count("***") == 1
