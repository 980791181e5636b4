"""Results on measured pushes, from a folder of published logs."""

from __future__ import annotations

import hashlib
import math
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.writing import json_text, write_text

#: Patterns of the logs in the folder.
PATTERNS = ("three_feet/*.txt", "polygons/*.mat")
#: Number of significant digits that are kept; differences between machines are far smaller.
SIGNIFICANT_DIGITS = 4


def logs(folder: PathLike) -> list[Path]:
    """Logs in a folder, in order.

    Raises
    ------
    InvalidFile
        If there is no such folder, or it lacks the logs of one of the experiments.
    """
    allowed = f"a folder with {' and '.join(PATTERNS)}"
    if not Path(folder).is_dir():
        raise InvalidFile(f"{folder}: no such folder; allowed: {allowed}; give another path")
    logs_by_pattern = [sorted(Path(folder).glob(pattern)) for pattern in PATTERNS]
    for pattern, files in zip(PATTERNS, logs_by_pattern, strict=True):
        if not files:
            raise InvalidFile(f"{folder}: contains no {pattern}; allowed: {allowed}; add the logs")
    return [file for files in logs_by_pattern for file in files]


def fingerprints(folder: PathLike) -> str:
    """A line for each log, with its digest and its name in the folder; raises the errors of `logs`."""
    lines = [
        f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.relative_to(folder).as_posix()}\n"
        for file in logs(folder)
    ]
    return "".join(lines)


def round_numbers(content: Any) -> Any:
    """Content with four significant digits, sorted keys, and null instead of NaN."""
    if isinstance(content, Mapping):
        return {str(key): round_numbers(content[key]) for key in sorted(content, key=str)}
    if isinstance(content, (list, tuple)):
        return [round_numbers(value) for value in content]
    if isinstance(content, float):
        return float(f"{content:.{SIGNIFICANT_DIGITS}g}") if math.isfinite(content) else None
    return content


def measure(json: PathLike, files: PathLike, *, folder: PathLike) -> None:
    """Measure published logs, and write the numbers and the digests of the logs.

    Parameters
    ----------
    json : path
        The numbers, paper/measured_pushes.json; unchanged if a log cannot be read.
    files : path
        Digests of the logs.
    folder : path
        With three_feet/*.txt and polygons/*.mat.

    Raises
    ------
    InvalidFile
        As in `logs`, and if a log cannot be read.

    Notes
    -----
    The fits run on all cores. The errors of each are kept, so that an evaluation that was interrupted goes
    on where it ended.
    """
    from pulling_by_pushing.evidence.folds import kept_map
    from pulling_by_pushing.evidence.published import measure as measured

    digests = fingerprints(folder)
    with kept_map(len(os.sched_getaffinity(0))) as workers:
        numbers = round_numbers(measured(folder, progress=sys.stderr.isatty(), workers=workers))
    write_text(json_text(numbers), json)
    write_text(digests, files)
