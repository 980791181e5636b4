"""What runs elsewhere: workflows of GitHub, and no container that lacks this package."""

import re
import tomllib
from pathlib import Path

import pytest
from ruamel.yaml import YAML

FOLDER = Path(".github/workflows")
PROJECT = tomllib.loads(Path("pyproject.toml").read_text(encoding="utf-8"))["project"]


def workflow(name):
    return YAML(typ="safe", pure=True).load((FOLDER / name).read_text(encoding="utf-8"))


def commands(job):
    return [step["run"] for step in job["steps"] if "run" in step]


def kept(job):
    return [
        step["with"]["path"] for step in job["steps"] if "upload-artifact" in step.get("uses", "")
    ]


def test_linux_runs_everything_with_every_python():
    job = workflow("ci.yml")["jobs"]["linux"]
    versions = job["strategy"]["matrix"]["python"]
    assert versions == ["3.11", "3.12", "3.13", "3.14"]
    assert PROJECT["requires-python"] == f">={versions[0]}"
    assert job["steps"][1]["with"]["python-version"] == "${{ matrix.python }}"
    assert commands(job) == [".ci/run"]
    assert kept(job) == ["results"]


def test_macos_runs_the_tests():
    job = workflow("ci.yml")["jobs"]["macos"]
    assert job["runs-on"].startswith("macos")
    assert commands(job) == ["make test"]


def test_forks_call_the_check():
    check = workflow("check.yml")
    assert set(check["on"]) == {"workflow_call"}
    assert commands(check["jobs"]["check"]) == ["make", '.venv/bin/planar-pushing check "$RESULTS"']


@pytest.mark.parametrize("path", list(FOLDER.glob("*.yml")), ids=str)
def test_no_workflow_may_write_to_the_repository(path):
    found = workflow(path.name)
    assert found["permissions"] == {"contents": "read"}
    assert all(job["timeout-minutes"] <= 90 for job in found["jobs"].values())


@pytest.mark.parametrize(
    "path", [Path("Snakefile"), *Path("workflow/rules").glob("*.smk")], ids=str
)
def test_no_rule_names_a_container(path):
    assert not re.search(r"^\s*container", path.read_text(encoding="utf-8"), re.MULTILINE)
