"""Killed runs, full disks, and two builds.

Afterwards one plain run ends with the same bytes, and nothing is unlocked or deleted by hand.
"""

import os
import random
import re
import signal
import subprocess
import time

import pytest
from workflow.chunked import (
    ENVIRONMENT,
    RESULTS,
    STUDY,
    command,
    copy_workflow,
    files,
    snakemake,
)

pytestmark = pytest.mark.alone

CHUNKS = "chunks: {motion_cones: {rod_length: 2, friction_coefficient: 3}}\n"
TARGETS = [f"{RESULTS}/figures/figure_01.svg"]
#: `KILLS=20 make test-all` tries more.
KILLS = int(os.environ.get("KILLS", "6"))
#: Kilobytes of a disk that is full as the output of a rule is written.
DISKS = {"chunk": 40, "motion_cones": 170, "figures_quasi_static_split": 240}


def copy_with_a_figure(root):
    """The workflow on a study in chunks with a single figure, whose job needs one dataset."""
    copy_workflow(root, CHUNKS)
    study = root / STUDY
    figure = "figures:\n  figure_01: {rod_length: 2, friction_coefficient: 1.5}\n"
    text = re.sub(r"^figures:\n(  .*\n)+", figure, study.read_text("utf-8"), flags=re.MULTILINE)
    study.write_text(text, encoding="utf-8")
    return root


@pytest.fixture(scope="session")
def undisturbed(tmp_path_factory):
    """Files of a run that nothing disturbs, and how long it takes."""
    root = copy_with_a_figure(tmp_path_factory.mktemp("undisturbed"))
    start = time.monotonic()
    snakemake(root, *TARGETS)
    return files(root), time.monotonic() - start


def test_killed_runs_end_with_the_same_bytes(undisturbed, tmp_path):
    expected, seconds = undisturbed
    root = copy_with_a_figure(tmp_path)
    moments = random.Random(0)
    for _ in range(KILLS):
        run = subprocess.Popen(
            command("--cores", "2", *TARGETS), cwd=root, env=ENVIRONMENT, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        time.sleep(moments.uniform(0, 0.7 * seconds))
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
    snakemake(root, *TARGETS)
    assert files(root) == expected


def test_two_builds_of_the_papers_results_are_identical(built, fresh):
    fresh.snakemake()
    assert fresh.digests() == built.digests()


@pytest.fixture
def disk(tmp_path):
    """A folder that takes a number of kilobytes, which can grow."""
    if os.geteuid() != 0:
        pytest.skip("root alone mounts a small disk")
    folder = tmp_path / "results"
    folder.mkdir()

    def resize(size, *options):
        choice = ",".join([*options, f"size={size}k"])
        subprocess.run(["mount", "-t", "tmpfs", "-o", choice, "tmpfs", folder], check=True)

    resize(DISKS["chunk"])
    yield lambda size: resize(size, "remount")
    subprocess.run(["umount", folder], check=True)


def test_a_full_disk_ends_a_run_and_with_room_the_next_has_the_same_bytes(
    undisturbed, tmp_path, disk
):
    expected, _ = undisturbed
    root = copy_with_a_figure(tmp_path)
    for rule, size in DISKS.items():
        disk(size)
        said = snakemake(root, *TARGETS, code=1)
        assert "No space left on device" in said
        assert f"FAILED: {rule} (" in said
    disk(20_000)
    snakemake(root, *TARGETS)
    assert files(root) == expected
