"""Sources of the report: the datasets, the golden verdict and the claims in a results folder."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import read_attributes
from planar_pushing.terms.options import EffectSet
from pulling_by_pushing.figures.measured import PUSHES_FILE, read_pushes
from pulling_by_pushing.study.store import open_dataset, read_dataset

#: Names of the sets of effects in the datasets.
EFFECTS: tuple[str, ...] = tuple(map(str, EffectSet))
FRICTION, INERTIA, BOTH = EFFECTS
#: Datasets about the computation itself; the name of a group follows a slash.
MEASURED = ("accuracy", "accuracy_time", "effects", "hard_cases")


#: The study of sliders; the names of its datasets follow this name and a slash.
SLIDERS = "sliders"


@cache
def open_once(name: str, folder: Path) -> xr.Dataset:
    """Dataset of a results folder, named as in `Results.dataset`; read once."""
    kind, _, part = name.partition("/")
    if kind == SLIDERS:
        return open_dataset(part, folder, study=SLIDERS)
    if kind in MEASURED:
        return read_dataset(folder / "data" / f"{kind}.nc", part or None)
    return open_dataset(name, folder)


@cache
def _marks(golden: Path) -> list[dict[str, Any]]:
    paths = sorted(golden.rglob("*.nc"))
    if not paths:
        raise InvalidFile(f"{golden}: holds no golden data; give the folder of the golden data")
    return [read_attributes(path) for path in paths]


@dataclass(frozen=True, slots=True)
class Results:
    """A results folder of the pipeline, and the golden data against which it was checked.

    `measured` is the file with the numbers on measured pushes.
    """

    folder: Path
    golden: Path
    measured: Path = Path(PUSHES_FILE)

    def dataset(self, name: str) -> xr.Dataset:
        """Dataset named as in `open_dataset`, or one of `MEASURED`; read once.

        Names are, for example, "accuracy/cone" for a group, and "sliders/supports" for a dataset of the
        study of sliders. Errors as in `open_dataset`.
        """
        return open_once(name, self.folder)

    def golden_marks(self) -> list[dict[str, Any]]:
        """Attributes of every golden file: method, precision, versions and counts.

        Raises
        ------
        InvalidFile
            If there are no golden data.
        """
        return _marks(self.golden)

    @property
    def verdicts(self) -> list[dict[str, Any]]:
        """Golden verdicts of the paper's study and the study of sliders: counts and all comparisons.

        Raises
        ------
        InvalidFile
            If a golden check has not been run, or its file is not JSON.
        """
        folders = (self.folder, self.folder / "studies" / SLIDERS)
        return [_json(folder / "tables/golden_verdict.json") for folder in folders]

    @property
    def claims(self) -> dict[str, Any]:
        """Counts and claims of the ledger; errors as in `verdicts`."""
        return _json(self._table("claims.json"))

    def check(self, claim: str, name: str) -> dict[str, Any]:
        """One check of a claim of the ledger.

        Raises
        ------
        InvalidFile
            If the ledger has no claim with this name, or the claim has no such check.
        """
        checks = {entry["id"]: entry["checks"] for entry in self.claims["claims"]}
        named = {entry["name"]: entry for entry in self._one(checks, claim, "claim")}
        evidence: dict[str, Any] = self._one(named, name, f"{claim}: check")
        return evidence

    @property
    def pushes(self) -> dict[str, Any]:
        """The numbers on measured pushes; errors as in `read_pushes`."""
        return read_pushes(self.measured)

    def _one(self, options: dict[str, Any], name: str, kind: str) -> Any:
        if name not in options:
            path, allowed = self._table("claims.json"), ", ".join(options)
            raise InvalidFile(f"{path}: no {kind} {name!r}; allowed: {allowed}; name one")
        return options[name]

    def _table(self, name: str) -> Path:
        return self.folder / "tables" / name


def _json(path: Path) -> dict[str, Any]:
    try:
        content: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InvalidFile(f"{path}: no such table; build it with make or snakemake") from None
    except json.JSONDecodeError as error:
        raise InvalidFile(f"{path}: is not JSON ({error}); delete it and build it again") from None
    return content
