"""The command `query`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import xarray as xr

from planar_pushing.commands.arguments import Commands, command
from planar_pushing.study.catalog import DATASETS, EVIDENCE
from planar_pushing.study.query import select
from planar_pushing.study.store import open_dataset
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.quantities import unit_of


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print a part of a dataset: --axis-name value picks a value."
    sub = command(commands, "query", part, about)
    sub.usage = (
        "planar-pushing query DATASET [--AXIS VALUE ...] [--study NAME] [--results FOLDER] [--json]"
    )
    sub.add_argument("dataset", metavar="DATASET", help=", ".join([*DATASETS, *EVIDENCE]))
    sub.add_argument("--results", type=Path, default=Path("results"), help="folder of the results")
    sub.add_argument("--study", metavar="NAME", help="another study than the paper's, by its name")


def part(args: argparse.Namespace) -> dict[str, Any]:
    """Part of the dataset where its axes have the given values."""
    found = select(open_dataset(args.dataset, args.results, study=args.study), _pairs(args.where))
    return dict(found.to_dict()) if args.json else {"": _table(found)}


def _pairs(words: Sequence[str]) -> dict[str, str]:
    """Axis names and values from ``--axis-name value`` or ``--axis-name=value``."""
    split = (word.split("=", 1) if word.startswith("--") else [word] for word in words)
    parts = [part for pair in split for part in pair]
    names = [part[2:].replace("-", "_") for part in parts[::2] if part.startswith("--")]
    if 2 * len(names) != len(parts) or len(set(names)) < len(names):
        raise InvalidValue(
            "query",
            " ".join(words),
            "pairs such as --rod-length 2, each axis once",
            "name an axis, then its value",
        )
    return dict(zip(names, parts[1::2], strict=True))


def _table(found: xr.Dataset) -> str:
    """Chosen values in one line, then single values in lines, and a table for each set of axes."""
    marks = {}
    for name, variable in found.variables.items():
        unit = unit_of(variable.attrs)
        marks[name] = str(name) if unit == "1" else f"{name} [{unit}]"
    chosen = [name for name, coord in found.coords.items() if not coord.ndim]
    rest = found.drop_vars(chosen)
    singles = [name for name, variable in rest.data_vars.items() if not variable.ndim]
    width = max((len(marks[name]) for name in singles), default=0)
    blocks = [", ".join(f"{name}={found[name].item()}" for name in chosen)] if chosen else []
    if singles:
        blocks.append("\n".join(f"{marks[n]:<{width}}  {rest[n].item()}" for n in singles))
    for dims in dict.fromkeys(
        variable.dims for variable in rest.data_vars.values() if variable.ndim
    ):
        names = [name for name, variable in rest.data_vars.items() if variable.dims == dims]
        frame = rest[names].to_dataframe()[names]
        frame.columns = [marks[name] for name in names]
        blocks.append(frame.to_string(max_rows=40))
    return "\n".join(blocks)
