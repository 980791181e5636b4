"""Arguments and text of the commands that read measured pushes."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from planar_pushing.terms.errors import InvalidValue, require_number

if TYPE_CHECKING:
    import xarray as xr


def add_pushes(sub: argparse.ArgumentParser, several: bool) -> None:
    """Add the dataset of pushes, the name of an object, and the seed."""
    sub.add_argument(
        "pushes", type=Path, metavar="PUSHES.nc",
        help="dataset of pushes written by save_pushes or planar-pushing convert",
    )  # fmt: skip
    default = "all objects of the dataset" if several else "the only object of the dataset"
    sub.add_argument(
        "--object", metavar="NAME", help=f"object whose pushes are used (default: {default})"
    )
    sub.add_argument(
        "--seed", type=int, default=0, metavar="NUMBER",
        help="seed of all random choices, a whole number >= 0 (default: 0)",
    )  # fmt: skip


def require_seed(seed: int) -> int:
    """Return a valid seed, or raise `InvalidValue`."""
    allowed = "a whole number >= 0"
    return int(require_number("seed", seed, lambda x: 0 <= x < math.inf, allowed, "give another"))


def require_ending(output: Path, endings: Sequence[str]) -> None:
    """Reject an output file name without one of the allowed endings."""
    if output.suffix.lower() not in endings:
        allowed = f"a name ending in {' or '.join(endings)}"
        raise InvalidValue("output", str(output), allowed, "rename the file")


def chosen_pushes(args: argparse.Namespace) -> xr.Dataset:
    """Pushes of the file, or of one of its objects."""
    from planar_pushing.pushes.files import load_pushes
    from planar_pushing.pushes.logs.combine import of_object

    pushes = load_pushes(args.pushes)
    return pushes if args.object is None else of_object(pushes, args.object)


def columns(rows: Sequence[Sequence[str]]) -> str:
    """Lines of a table with the first column left-aligned and the others right-aligned."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])] for row in rows)
    return "\n".join("  ".join(line).rstrip() for line in lines)
