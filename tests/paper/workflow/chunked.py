"""The workflow in a folder of its own, on a study in chunks; the sources are the project's, compiled."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from workflow.conftest import PROJECT

from pulling_by_pushing.study.store import read_dataset

STUDY = "workflow/config/split.yaml"
RESULTS = "results/studies/split"
ENVIRONMENT = os.environ | {"PYTHONPATH": str(PROJECT / "src"), "PYTHONDONTWRITEBYTECODE": "1"}


def copy_workflow(root: Path, *lines: str) -> Path:
    """Copy the workflow, with the smoke study and these lines as the study; the folder."""
    shutil.copytree(PROJECT / "workflow", root / "workflow", dirs_exist_ok=True)
    for name in ("Snakefile", "profiles"):
        shutil.copy(PROJECT / name, root / name, follow_symlinks=False)
    smoke = (PROJECT / "workflow/config/smoke.yaml").read_text(encoding="utf-8")
    (root / STUDY).write_text("".join([smoke, *lines]), encoding="utf-8")
    return root


def command(*arguments: str) -> list[str]:
    """A run of Snakemake on the study."""
    return [sys.executable, "-m", "snakemake", *arguments, "--config", f"study={STUDY}"]


def snakemake(root: Path, *arguments: str, code: int = 0) -> str:
    """Run Snakemake; what it said."""
    done = subprocess.run(
        command("--cores", "2", *arguments), cwd=root, env=ENVIRONMENT, capture_output=True,
        text=True, timeout=600, check=False,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == code, said
    return said


def files(root: Path) -> dict[str, bytes]:
    """Every chunk and figure, and the content of every dataset, which dask gathers in any order."""
    folder = root / RESULTS
    kinds = ("chunks/*/*.nc", "figures/*.*")
    paths = [path for kind in kinds for path in folder.glob(kind)]
    found = {str(path.relative_to(folder)): path.read_bytes() for path in sorted(paths)}
    datasets = {path.name: read_dataset(path) for path in sorted(folder.glob("data/*.nc"))}
    return found | {
        name: json.dumps(data.to_dict(), default=str, sort_keys=True).encode()
        for name, data in datasets.items()
    }
