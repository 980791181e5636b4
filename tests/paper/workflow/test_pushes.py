"""The rule `pushes`: published logs are measured, the project's file is written, and two figures drawn."""

import json
import subprocess
import sys

import pytest
from report.pushes import measured_pushes
from workflow.test_workflow import jobs

from pulling_by_pushing.figures.studies import PUSHES

pytestmark = pytest.mark.slow

#: A stand-in for the measurement, which takes minutes: numbers that tell how large the log is.
MEASURE = """import json
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile


def measure(folder, seed=0, progress=False, splits=50, workers=1):
    size = len(Path(folder, "three_feet/patch.txt").read_text())
    if size > 9:
        raise InvalidFile("patch.txt: too long; allowed: less; cut it")
    found = json.loads(Path("made_up.json").read_text())
    found["patch"]["pushes"] = size
    return found
"""


def run(copy, *arguments, code=0):
    """Run Snakemake on the default studies; what it printed."""
    command = [sys.executable, "-m", "snakemake", *arguments, "--cores", "2"]
    done = subprocess.run(
        command, cwd=copy.root, env=copy.environment, capture_output=True, text=True, timeout=600,
        check=False,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == code, said
    return said


@pytest.fixture
def copy(fresh):
    """A copy of the project with a folder of logs, and with the stand-in."""
    source = fresh.root / "src/pulling_by_pushing/evidence/published.py"
    source.write_text(MEASURE, encoding="utf-8")
    (fresh.root / "tests/golden/sliders").mkdir(parents=True)
    text = json.dumps(measured_pushes())
    for name in ("made_up.json", "paper/measured_pushes.json"):
        (fresh.root / name).write_text(text, encoding="utf-8")
    for name in ("three_feet/patch.txt", "polygons/abs_hex.mat"):
        (fresh.root / "logs" / name).parent.mkdir(parents=True)
        (fresh.root / "logs" / name).write_text("x", encoding="utf-8")
    return fresh


def test_the_rule_rewrites_the_file_and_the_figures(copy):
    kept, data = copy.root / "paper/measured_pushes.json", ("--config", "data=logs")
    run(copy, "pushes", *data)
    assert json.loads(kept.read_text(encoding="utf-8"))["patch"]["pushes"] == 1
    figures = [copy.root / f"results/figures/{name}.png" for name in PUSHES]
    before = [path.read_bytes() for path in figures]
    assert "Nothing to be done" in run(copy, "pushes", "--dry-run", *data)
    (copy.root / "logs/three_feet/patch.txt").write_text("xxx", encoding="utf-8")
    said = run(copy, "pushes", *data)
    assert "measured_pushes" in said
    assert json.loads(kept.read_text(encoding="utf-8"))["patch"]["pushes"] == 3
    assert [path.read_bytes() for path in figures] == before  # a count is in the caption alone
    text = kept.read_text(encoding="utf-8")
    (copy.root / "logs/three_feet/patch.txt").write_text("x" * 10, encoding="utf-8")
    said = run(copy, "pushes", *data, code=1)
    assert "patch.txt: too long; allowed: less; cut it" in said
    assert kept.read_text(encoding="utf-8") == text


def test_a_folder_without_logs_stops_before_any_job(copy):
    said = run(copy, "pushes", "--config", "data=nowhere", code=1)
    assert "nowhere: no such folder; allowed: a folder with three_feet/*.txt and" in said
    said = run(copy, "pushes", code=1)
    assert "data: not given; allowed: a folder with three_feet/*.txt" in said
    for text in (said, run(copy, "--dry-run", "pushes", "--config", "data=", code=1)):
        assert "Traceback (most recent call last)" not in text


def test_the_default_build_draws_the_figures_and_measures_nothing(copy):
    assert jobs(run(copy, "--dry-run", "pushes_figures")) == {
        "figures_pushes_paper": 1,
        "pushes_figures": 1,
    }
