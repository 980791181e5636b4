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
        help="dataset of pushes: of save_pushes, or of planar-pushing convert",
    )  # fmt: skip
    default = "all of the dataset" if several else "the only one of the dataset"
    sub.add_argument(
        "--object", metavar="NAME", help=f"object whose pushes are taken (default: {default})"
    )
    sub.add_argument(
        "--seed", type=int, default=0, metavar="NUMBER",
        help="seed of every random choice, a whole number >= 0 (default: 0)",
    )  # fmt: skip


def require_seed(seed: int) -> int:
    """A seed, or `InvalidValue`."""
    allowed = "a whole number >= 0"
    return int(require_number("seed", seed, lambda x: 0 <= x < math.inf, allowed, "give another"))


def require_ending(output: Path, endings: Sequence[str]) -> None:
    """Refuse an output whose name does not end as a file of its kind."""
    if output.suffix.lower() not in endings:
        allowed = f"a name ending in {' or '.join(endings)}"
        raise InvalidValue("output", str(output), allowed, "rename the file")


def chosen_pushes(args: argparse.Namespace) -> xr.Dataset:
    """The pushes of the file, or those of one object of it."""
    from planar_pushing.pushes.combine import of_object
    from planar_pushing.pushes.files import load_pushes

    pushes = load_pushes(args.pushes)
    return pushes if args.object is None else of_object(pushes, args.object)


def columns(rows: Sequence[Sequence[str]]) -> str:
    """Lines of a table: the first column to the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])] for row in rows)
    return "\n".join("  ".join(line).rstrip() for line in lines)
