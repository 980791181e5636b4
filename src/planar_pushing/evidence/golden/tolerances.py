"""The largest differences from golden values that are allowed: the file beside the golden data."""

from __future__ import annotations

from pathlib import Path

from pydantic import Field

from planar_pushing.study.files.fields import FileModel, NonNegative
from planar_pushing.study.files.scenes import load_model

#: Name of the file in a folder of golden data.
FILE = "tolerances.yaml"


class Tolerance(FileModel):
    """Largest difference from a golden value: units in the last place plus an amount in its unit."""

    ulp: NonNegative = 0.0
    absolute: NonNegative = 0.0


class TolerancesFile(FileModel):
    """Tolerances by variable; one that is not listed must agree exactly."""

    tolerances: dict[str, Tolerance] = Field(default_factory=dict)


def load_tolerances(golden: Path) -> dict[str, Tolerance]:
    """Tolerances of a folder of golden data, none where it has no such file; errors as in `load_scene`."""
    path = golden / FILE
    return load_model(path, TolerancesFile).tolerances if path.exists() else {}
