"""Results of the smoke studies, built once for all processes of a test run; none may be changed."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.model import StudyFile
from pulling_by_pushing.study.provenance import Marks, provenance
from pulling_by_pushing.study.running import build
from pulling_by_pushing.study.running.simulations import simulations
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"
SLIDERS_SMOKE = "workflow/config/sliders_smoke.yaml"


def build_once(factory: pytest.TempPathFactory, name: str, build: Callable[[Path], object]) -> Path:
    """Folder that a function fills; the processes of a run share it, and the first one fills it."""
    shared = os.environ.get("PYTEST_XDIST_WORKER") is not None
    base = factory.getbasetemp()
    folder = (base.parent if shared else base) / f"once_{name}"
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            started = folder.with_suffix(".started")
            started.mkdir(exist_ok=True)
            build(started)
            started.rename(folder)
    return folder


def smoke_results(factory: pytest.TempPathFactory) -> Path:
    """Results of the smoke study, with those of the smoke study of sliders in studies/sliders."""

    def both(folder: Path) -> None:
        build_study(SMOKE, folder)
        build_study(SLIDERS_SMOKE, folder / "studies/sliders")

    return build_once(factory, "smoke", both)


def build_study(file: str, folder: Path) -> tuple[StudyFile, Marks]:
    """Build the datasets and the logs of a study in a folder."""
    study = load_study(file)
    marks = provenance(study, file)
    (folder / "data/simulations").mkdir(parents=True)
    for name in DATASETS:
        if computes(study, name):
            path, values = folder / f"data/{name}.nc", study_slice(study, name)
            build.dataset(path, name=name, study=values, marks=marks(name))
    simulations(
        [folder / f"data/simulations/{name}.nc" for name in study.simulations],
        scenes=study.simulations,
        marks=[marks(f"simulations/{name}") for name in study.simulations],
    )
    return study, marks
