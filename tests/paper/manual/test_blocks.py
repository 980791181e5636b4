"""Every block of code of the manual runs, in the order of its page, and prints what the page shows."""

import doctest
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from manual.pages import PAGES, blocks, name
from ruamel.yaml import YAML

from planar_pushing.commands import main
from planar_pushing.mechanics.outline import require_corners
from planar_pushing.scenes.contacts_files import load_contacts
from planar_pushing.scenes.files import load_scene
from pulling_by_pushing.study.study_file import load_study
from shown import FLAGS, Checker, agrees

pytestmark = pytest.mark.slow

PROJECT = Path(__file__).parents[3]
WITH_BLOCKS = [page for page in PAGES if blocks(page)]


def run_python(text, names, capsys):
    found = doctest.DocTestParser().get_doctest(text, names, "block", None, 0)
    assert found.examples, f"shows no >>>: {text}"
    runner = doctest.DocTestRunner(Checker(), optionflags=FLAGS, verbose=False)
    said = []
    runner.run(found, out=said.append, clear_globs=False)
    names.update(found.globs)
    assert not runner.failures, "".join(said)


def run_commands(text, names, capsys):
    for line, said in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", text, re.MULTILINE):
        program, *arguments = shlex.split(line)
        printed = PROGRAMS[program](arguments, capsys)
        if said:
            assert agrees(said, printed), f"{line}: {printed}"


def run_ours(arguments, capsys):
    if arguments[0] == "run":  # a page shows results that are there already
        return plan_jobs(["--config", f"study={arguments[1]}"], capsys)
    capsys.readouterr()
    status = main(arguments)
    printed = capsys.readouterr()
    assert status == 0, printed.err
    return printed.out


def plan_jobs(arguments, capsys):
    """Plan the jobs of Snakemake; none runs."""
    run = [sys.executable, "-m", "snakemake", *arguments, "--dry-run", "--quiet"]
    environment = os.environ | {"PYTHONPATH": str(PROJECT / "src")}
    done = subprocess.run(run, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return ""


def find_targets(arguments, capsys):
    """Whether the Makefile has these targets; it makes nothing."""
    known = re.findall(r"^([a-z-]+):", (PROJECT / "Makefile").read_text(encoding="utf-8"), re.M)
    assert {each for each in arguments if "=" not in each} <= set(known)
    return ""


PROGRAMS = {"planar-pushing": run_ours, "snakemake": plan_jobs, "make": find_targets}


def read_yaml(text, names, capsys):
    """A file, where the block begins with its name, or what is added to a file: `# in NAME`."""
    added, path = re.match(r"# (in )?(\S+\.ya?ml)\n", text).groups()
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    before = path.read_text(encoding="utf-8") if added else ""
    path.write_text(before + text, encoding="utf-8")
    content = YAML(typ="safe", pure=True).load(path)
    if isinstance(content, list):
        require_corners(content)
    elif "jobs" in content:
        check_schema(path)
    else:
        loads = {"contact": load_scene, "contacts": load_contacts}
        loads.get(next((key for key in loads if key in content), ""), load_study)(path)


def check_schema(path):
    """Whether GitHub takes the file for a workflow."""
    check = ["-m", "check_jsonschema", "--builtin-schema", "vendor.github-workflows", str(path)]
    done = subprocess.run([sys.executable, *check], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


KINDS = {
    "python": run_python, "{eval-rst}": run_python, "console": run_commands, "yaml": read_yaml,
}  # fmt: skip


@pytest.mark.parametrize("page", WITH_BLOCKS, ids=name)
def test_every_block_runs(page, folder, capsys):
    names = {}
    for kind, text in blocks(page):
        assert kind in KINDS, f"a block of kind {kind!r} is not run: {text}"
        KINDS[kind](text, names, capsys)
