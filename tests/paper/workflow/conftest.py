"""A copy of the project in an empty folder, in which the workflow runs on the smoke study."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from pulling_by_pushing.study.studies import study_folder
from smoke import build_once

PROJECT = Path(__file__).parents[3]
PARTS = (
    "CITATION.cff",
    "Snakefile",
    "profiles",
    "workflow",
    "src",
    "paper",
    "pyproject.toml",
    "README.md",
    "LICENSE",
)


@dataclass(frozen=True)
class Copy:
    """The project's copy at `root`."""

    root: Path
    study: str = "workflow/config/smoke.yaml"

    @property
    def results(self) -> Path:
        """Folder that the study fills."""
        return study_folder(Path(self.study).stem, self.root / "results")

    def command(self, *arguments: str) -> list[str]:
        run = [sys.executable, "-m", "snakemake", *arguments, "--cores", "2"]
        return [*run, "--config", f"study={self.study}"]

    @property
    def environment(self) -> dict[str, str]:
        """That of a user; every job reads the bytecode that the first one has written."""
        given = os.environ | {"PYTHONPATH": str(self.root / "src")}
        return {name: value for name, value in given.items() if name != "PYTHONDONTWRITEBYTECODE"}

    def snakemake(self, *arguments: str, code: int = 0) -> str:
        """Run Snakemake on the smoke study; what it printed."""
        done = subprocess.run(
            self.command(*arguments),
            cwd=self.root,
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=600,
            check=False,
        )
        said = done.stdout + done.stderr
        assert done.returncode == code, said
        return said

    def dry(self, *arguments: str, code: int = 0) -> str:
        """Make a dry run of whatever the arguments choose, the paper's study by default."""
        run = [sys.executable, "-m", "snakemake", "--dry-run", "--cores", "1", *arguments]
        done = subprocess.run(
            run, cwd=self.root, env=self.environment, capture_output=True, text=True, check=False
        )
        said = done.stdout + done.stderr
        assert done.returncode == code, said
        return said

    def digests(self) -> dict[str, str]:
        """Digest of every artefact; logs and benchmarks hold times and are none."""
        results = self.results
        files = (path for path in results.rglob("*") if path.is_file())
        names = {path.relative_to(results): path for path in files}
        return {
            str(name): hashlib.sha256(path.read_bytes()).hexdigest()
            for name, path in sorted(names.items())
            if name.parts[0] not in ("logs", "benchmarks", "README.md")
        }


def copy_project(root: Path) -> Copy:
    for part in PARTS:
        source, target = PROJECT / part, root / part
        if source.is_dir() and not source.is_symlink():
            shutil.copytree(
                source, target, ignore=shutil.ignore_patterns("__pycache__", ".*_cache")
            )
        else:
            shutil.copy(source, target, follow_symlinks=False)
    return Copy(root)


def once(factory: pytest.TempPathFactory, name: str, *targets: str) -> Copy:
    """A copy in which targets are built, by default everything; processes of a run share the build."""
    original = build_once(factory, name, lambda folder: copy_project(folder).snakemake(*targets))
    root = factory.mktemp(name) / "copy"
    shutil.copytree(original, root, symlinks=True)
    return Copy(root)


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """A copy in which everything is built; a test that changes it must put it back."""
    return once(tmp_path_factory, "built")


#: Files of a dataset, of a figure of this dataset and another, and of a log, which stand for all others
#: where a build takes too long.
FEW_FILES = (
    "data/motion_cones.nc",
    "data/simulations/slipping.nc",
    "figures/figure_13.svg",
)


@pytest.fixture(scope="session")
def partly_built(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """A copy in which `FEW_FILES` are built; a test that changes it must put it back."""
    return once(tmp_path_factory, "partly_built", *few_targets())


def few_targets() -> list[str]:
    """`FEW_FILES` as targets of Snakemake."""
    return [f"results/studies/smoke/{name}" for name in FEW_FILES]


@pytest.fixture
def fresh(tmp_path: Path) -> Copy:
    """A copy in which nothing is built."""
    return copy_project(tmp_path)
