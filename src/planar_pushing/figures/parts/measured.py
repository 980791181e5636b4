"""Numbers on measured pushes, from the file that the rule `pushes` writes."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.figures.comparison import LOOKS
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile

#: The numbers, in the project's folder, and the rule that writes them anew.
PUSHES_FILE = "paper/measured_pushes.json"
REMEDY = "write it anew with snakemake pushes --config data=FOLDER"
#: Parts of the file.
PARTS = ("three_feet", "patch", "polygons", "about_a_foot")
#: Statistics of a model, and the sizes of their last axes.
STATISTICS = {"median": (), "percentile_90": (), "ratio": (), "ratio_interval": (2,)}


def read_pushes(path: PathLike) -> dict[str, Any]:
    """Read the numbers on measured pushes.

    Raises
    ------
    InvalidFile
        Where the file is missing, is not JSON, or lacks a part.
    """
    try:
        found = json.loads(Path(path).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InvalidFile(f"{path}: no such file; {REMEDY}") from None
    except json.JSONDecodeError as error:
        raise InvalidFile(f"{path}: is not JSON ({error}); {REMEDY}") from None
    lacking = [part for part in PARTS if not isinstance(found, dict) or part not in found]
    if lacking:
        raise InvalidFile(f"{path}: lacks {lacking[0]}; allowed: {', '.join(PARTS)}; {REMEDY}")
    return dict(found)


def statistics(comparison: Mapping[str, Mapping[str, Any]], unit: str) -> xr.Dataset:
    """A comparison of the file as `compare` returns it, with models in the order of `LOOKS`."""
    quantities, models = list(comparison), _in_order(comparison.values())
    found: dict[str, Any] = {}
    for name, rest in STATISTICS.items():
        every = np.full((len(quantities), len(models), *rest), np.nan)
        for i, quantity in enumerate(quantities):
            for j, model in enumerate(models):
                if model in comparison[quantity]:
                    every[i, j] = comparison[quantity][model][name]
        found[name] = ("quantity", "model", *(["bound"] if rest else [])), every
    return xr.Dataset(
        found,
        {"quantity": quantities, "model": models},
        {"pose_units": unit, "angle_units": "degree"},
    )


def _in_order(given: Iterable[Mapping[str, Any]]) -> list[str]:
    """Models that some quantity has, those with a look of their own first."""
    every = dict.fromkeys(name for each in given for name in each)
    return [name for name in LOOKS if name in every] + [name for name in every if name not in LOOKS]
