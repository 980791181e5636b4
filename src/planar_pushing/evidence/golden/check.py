"""Check a results folder against a folder of golden data."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_pushing.evidence.golden.compare import Check, compare
from planar_pushing.study.files.models import Tolerance
from planar_pushing.study.store import read_dataset
from planar_pushing.terms.errors import InvalidFile


def golden_names(golden: Path) -> list[str]:
    """Names of the golden files in a folder.

    Raises
    ------
    InvalidFile
        Where the folder holds none: a check of nothing must not pass.
    """
    names = sorted(path.stem for path in golden.glob("*.nc"))
    if not names:
        raise InvalidFile(f"{golden}: holds no golden data; name the folder that does")
    return names


def result_of(name: str, results: Path) -> tuple[Path, str | None]:
    """File, and group in it, that a golden file certifies: a dataset, a scene or a figure."""
    stem, _, group = name.partition(".")
    if stem.startswith("figure_"):
        return results / "figures" / "data" / f"{stem}.nc", None
    return results / "data" / f"{stem}.nc", group or None


def check_results(results: Path, golden: Path, tolerances: Mapping[str, Tolerance]) -> list[Check]:
    """Compare every golden file with what it certifies."""
    checks = []
    for name in golden_names(golden):
        try:
            result = read_dataset(*result_of(name, results)).load()
        except InvalidFile as error:
            checks.append(Check(file=name, problem=f"cannot be compared: {error}"))
            continue
        checks += compare(name, result, read_dataset(golden / f"{name}.nc"), tolerances)
    return checks
