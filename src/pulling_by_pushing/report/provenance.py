"""Identification of the code for the report: version, commit, license, platform and package versions."""

from __future__ import annotations

import platform
import subprocess
from importlib.metadata import metadata, version
from pathlib import Path
from typing import TYPE_CHECKING

from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.writing import csv_text, write_text
from pulling_by_pushing.study.provenance import whole_digest
from pulling_by_pushing.study.study_file import load_study

if TYPE_CHECKING:
    from pulling_by_pushing.report.results import Results

#: Packages with which the results and the report are produced.
PACKAGES = (
    "numpy",
    "scipy",
    "clarabel",
    "xarray",
    "h5netcdf",
    "h5py",
    "matplotlib",
    "pydantic",
    "snakemake",
    "typst",
)


def commit(folder: PathLike = ".") -> str:
    """Current commit of a folder and its date, with a remark if tracked files differ from it."""
    try:
        head = _git(folder, "log", "-1", "--format=%h of %cs", "--abbrev=12")
        changed = _git(folder, "status", "--porcelain", "--untracked-files=no")
    except (OSError, subprocess.CalledProcessError):
        return "unknown: not a clone of the repository"
    return f"{head}, with changes" if changed else head


def _git(folder: PathLike, *arguments: str) -> str:
    command = ["git", "-C", str(folder), *arguments]
    completed = subprocess.run(command, capture_output=True, text=True, check=True)
    return completed.stdout.strip()


def write_provenance(output: str, *, study: str, results: str, golden: str, state: str) -> None:
    """Write the table that identifies the code, the state of the repository, and the study."""
    from pulling_by_pushing.report.results import Results

    write_text(provenance_text(Results(Path(results), Path(golden)), study, state), output)


def provenance_text(results: Results, study: PathLike, state: str) -> str:
    """Table that identifies the code and the study; `state` is the commit from `commit`."""
    rows = [
        ("planar-pushing", version("planar-pushing")),
        ("commit", state),
        ("license", metadata("planar-pushing")["License-Expression"]),
        ("study", str(study)),
        ("SHA-256 of the study", whole_digest(load_study(Path(study)))[:16]),
        ("platform", f"{platform.system()}, {platform.machine()}"),
        ("Python", platform.python_version()),
    ]
    rows.append(("packages", ", ".join(f"{name} {version(name)}" for name in PACKAGES)))
    rows.append(("golden data", results.golden_marks()[0]["golden_versions"]))
    return csv_text([{"what": name, "value": value} for name, value in rows])
