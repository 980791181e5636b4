"""Numbers on measured pushes from the file that the rule `pushes` writes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import PathLike

#: File of the numbers in the project's folder, and the rule that rewrites it.
PUSHES_FILE = "paper/measured_pushes.json"
REMEDY = "write it again with snakemake pushes --config data=FOLDER"
#: Required sections of the file.
PARTS = ("three_feet", "patch", "polygons", "about_a_foot")


def read_pushes(path: PathLike) -> dict[str, Any]:
    """Read the numbers on measured pushes.

    Raises
    ------
    InvalidFile
        If the file is missing, is not JSON, or lacks a section.
    """
    try:
        numbers = json.loads(Path(path).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InvalidFile(f"{path}: no such file; {REMEDY}") from None
    except json.JSONDecodeError as error:
        raise InvalidFile(f"{path}: is not JSON ({error}); {REMEDY}") from None
    missing = [part for part in PARTS if not isinstance(numbers, dict) or part not in numbers]
    if missing:
        raise InvalidFile(f"{path}: lacks {missing[0]}; allowed: {', '.join(PARTS)}; {REMEDY}")
    return dict(numbers)
