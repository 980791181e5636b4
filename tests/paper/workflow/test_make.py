"""The Makefile's set-up: one at a time, in an environment of its own, and from any shell."""

import os
import shutil
import subprocess
import sys
import time

import pytest
from workflow.conftest import PROJECT

pytestmark = pytest.mark.slow

#: A Python that installs nothing, and notes that it was asked to make an environment.
PYTHON = """#!/bin/sh
if [ "$1" = -E ]; then exec {python} "$@"; fi
sleep 0.3
echo "$@" >> log
mkdir -p .venv/bin
for each in python uv snakemake; do
    printf '#!/bin/sh\\nexit 0\\n' > .venv/bin/$each
    chmod +x .venv/bin/$each
done
"""


@pytest.fixture
def folder(tmp_path):
    for name in ("Makefile", "requirements.lock", "pyproject.toml"):
        shutil.copy(PROJECT / name, tmp_path / name)
    for name in ("joiner", "src/planar_pushing/core"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "python").write_text(PYTHON.format(python=sys.executable), encoding="utf-8")
    (tmp_path / "python").chmod(0o755)
    return tmp_path


def start(folder, *arguments, **variables):
    """Start make as a user does, who is not within another make."""
    ours = {name: value for name, value in os.environ.items() if "MAKE" not in name}
    return subprocess.Popen(
        ["make", "PYTHON=./python", *arguments], cwd=folder, env=ours | variables,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip


def make(folder, *arguments, code=0, **variables):
    run = start(folder, *arguments, **variables)
    said = run.communicate()[0]
    assert run.returncode == code, said
    return said


def test_of_two_at_once_the_second_waits_and_finds_it_made(folder):
    runs = [start(folder) for _ in range(2)]
    said = [run.communicate()[0] for run in runs]
    assert [run.returncode for run in runs] == [0, 0], said
    assert (folder / "log").read_text() == "-m venv --clear .venv\n"
    assert any("Another make is running in this folder; waiting for it" in each for each in said)


def test_what_is_made_is_not_made_again_but_for_other_packages_or_in_another_place(folder):
    make(folder)
    make(folder)
    assert (folder / "log").read_text().count("--clear") == 1
    with (folder / "requirements.lock").open("a") as lock:
        lock.write("# another package\n")
    make(folder)
    assert (folder / "log").read_text().count("--clear") == 2
    moved = folder.rename(folder.with_name("moved"))
    assert "Installing the locked packages" in make(moved)
    assert "Installing" not in make(moved)


#: A Snakemake that runs until a signal ends it, and notes both.
SNAKEMAKE = """#!/bin/sh
trap 'echo ended >> log; exit 143' TERM
echo started >> log
for i in $(seq 600); do sleep 0.1; done
"""


@pytest.mark.parametrize("target", ["all", "report", "manual", "golden"])
def test_a_signal_to_make_alone_ends_the_run_too(folder, target):
    make(folder)
    (folder / ".venv/bin/snakemake").write_text(SNAKEMAKE, encoding="utf-8")
    run = start(folder, target)
    while "started" not in (folder / "log").read_text():
        assert run.poll() is None
        time.sleep(0.01)
    run.terminate()
    run.communicate(timeout=60)
    assert run.returncode != 0
    assert (folder / "log").read_text().endswith("started\nended\n")


@pytest.mark.parametrize(
    "variables",
    [{"HOME": "/nonexistent"}, {"XDG_CACHE_HOME": "/proc/none"}, {"HOME": "/dev/null/home"}],
)
def test_settings_of_other_work_stay_out_and_a_home_that_is_not_ours_is_replaced(folder, variables):
    foreign = dict.fromkeys(
        ("PYTHONPATH", "MPLBACKEND", "SNAKEMAKE_PROFILE", "VIRTUAL_ENV", "PYTHONHOME"), "foreign"
    )
    show = ("--eval=show: ; @env", "show")
    said = make(folder, *show, **foreign | variables)
    found = dict(line.split("=", 1) for line in said.splitlines() if "=" in line)
    assert not foreign.keys() & found.keys()
    assert found["HOME"] == str(folder / ".snakemake/home")
    assert found["XDG_CACHE_HOME"] == f"{found['HOME']}/.cache"
    assert f"HOME={folder}\n" in make(folder, *show, HOME=str(folder), XDG_CACHE_HOME="")


def test_a_folder_with_a_space_is_refused_with_one_line_but_help_works(folder):
    spaced = folder / "a folder"
    spaced.mkdir()
    shutil.copy(PROJECT / "Makefile", spaced)
    said = make(spaced, code=2)
    assert "a folder: Snakemake cannot run in a path with a space; move the project" in said
    assert len(said.splitlines()) == 1
    assert "make test-all" in make(spaced, "help")


def test_a_python_that_is_too_old_is_refused_with_one_line(folder):
    (folder / "old").write_text("#!/bin/sh\necho False\n", encoding="utf-8")
    (folder / "old").chmod(0o755)
    said = make(folder, "PYTHON=./old", code=2)
    assert (
        "Python 3.11 to 3.14 is required, but ./old was found; set PYTHON=/path/to/python" in said
    )
    assert len(said.splitlines()) == 1


def test_the_lock_pins_uv_with_its_hash_and_names_no_index():
    lock = (PROJECT / "requirements.lock").read_text(encoding="utf-8")
    start = lock.index("\nuv==")
    assert "--hash=sha256:" in lock[start : lock.index("==", start + 6)]
    assert "http" not in lock
    assert [path.name for path in PROJECT.glob("*.lock")] == ["requirements.lock"]
