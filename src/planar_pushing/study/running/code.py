"""Digests of the code that a workflow job runs; a change of the code makes the job's results outdated.

Snakemake tracks a script but not its imports. Therefore each job has among its parameters a digest of the
packages that it runs. If its module is one of a family, such as the figures, the digest includes only this
member, so that a change to one figure redraws that figure alone.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import planar_pushing
from planar_pushing.study.catalog import DATASETS

ROOT = Path(planar_pushing.__path__[0])
#: Modules that scene files of objects need, and packages that every job runs: the terms, the mechanics with
#: their core, and the study without its datasets.
OBJECTS = (
    "objects.__init__",
    "objects.boundary",
    "objects.many",
    "objects.on_outline",
    "objects.scene_at",
)
LIBRARY = ("terms", "core", "mechanics", *OBJECTS, "study")
EVIDENCE = ("evidence.jobs", "evidence.writing")
#: The packages that each kind of job runs.
PACKAGES = {
    "dataset": LIBRARY,
    "simulation": (*LIBRARY, "simulation"),
    "figure": (*LIBRARY, "figures"),
    "golden": (*LIBRARY, *EVIDENCE, "oracle", "evidence.golden"),
    "claims": (*LIBRARY, *EVIDENCE, "oracle", "evidence.claims"),
    "hard_cases": (*LIBRARY, *EVIDENCE, "oracle", "evidence.hard_cases"),
    "costs": (*LIBRARY, *EVIDENCE, "simulation", "oracle", "evidence.costs"),
    "pushes": (*LIBRARY, *EVIDENCE, "objects", "simulation", "pushes", "evidence.measured"),
    "report": (
        *LIBRARY,
        "simulation",
        "figures",
        "oracle",
        "evidence.claims",
        "evidence.golden",
        "evidence.writing",
        "report",
    ),
    "manual": (".",),
}


def builder(dataset: str) -> str:
    """Name of the module that builds a dataset."""
    return f"study.datasets.{DATASETS[dataset].module}"


#: Members of families, which a job runs only if it names them: builders of datasets, and figures.
BUILDERS = frozenset(map(builder, DATASETS))
DRAWINGS = frozenset(
    f"figures.{path.stem}"
    for path in (ROOT / "figures").glob("*.py")
    if "\nFIGURE = " in path.read_text(encoding="utf-8")
)
MEMBERS = BUILDERS | DRAWINGS


@cache
def code_of(job: str, *members: str) -> str:
    """Digest of the packages that a kind of job runs and of the family members that it names."""
    whole = hashlib.sha256()
    for file in sorted({file for part in (*PACKAGES[job], *members) for file in files(part)}):
        whole.update(f"{file.relative_to(ROOT)}\0".encode() + file.read_bytes())
    return whole.hexdigest()


def files(part: str) -> Iterator[Path]:
    """Files of a module, or of a package without the family members in it."""
    place = ROOT.joinpath(*part.split("."))
    if not place.is_dir():
        yield place.with_suffix(".py")
        return
    others = {ROOT.joinpath(*name.split(".")) for name in MEMBERS - {part}}
    for file in place.rglob("*.*"):
        within = {file.with_suffix(""), *file.parents}
        if "__pycache__" not in file.parts and not within & others and file.is_file():
            yield file
