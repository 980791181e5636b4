"""The command `compare`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import (
    Commands,
    add_pushes,
    chosen_pushes,
    command,
    require_ending,
    require_seed,
    table,
    text,
)

if TYPE_CHECKING:
    import xarray as xr

ENDINGS = (".nc", ".h5")
#: The model that is slow to fit.
SLOW = "identified"


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Compare models of supports with measured pushes. Each model is fitted to one half of the pushes "
        "of an object and scored on the other half, then vice versa. A ratio is the model's median error "
        "divided by that of an ellipsoid fitted to the same pushes, with its 95 percent interval. With one "
        "split into halves, the interval is that of these fits; with several, the numbers are means, and "
        "the intervals contain pushes, splits, and fits."
    )
    sub = command(commands, "compare", compare_models, about, "pushes.nc --identify")
    add_pushes(sub, several=True)
    sub.add_argument(
        "--identify", action="store_true",
        help="also compare the support that identify finds, which takes longer",
    )  # fmt: skip
    sub.add_argument(
        "--splits", type=int, default=1, metavar="NUMBER",
        help="random splits into halves, a whole number > 0; fifty or more to rely on (default: 1)",
    )  # fmt: skip
    sub.add_argument(
        "--workers", type=int, default=1, metavar="NUMBER",
        help="number of cores, a whole number > 0, or -1 for all (default: 1)",
    )  # fmt: skip
    sub.add_argument(
        "-o", "--output", type=Path, metavar="COMPARISON.nc",
        help=f"output dataset of the errors; its name ends in {' or '.join(ENDINGS)} (default: none)",
    )  # fmt: skip


def compare_models(args: argparse.Namespace) -> dict[str, Any]:
    """Score the models, write the dataset if requested, and report the errors of each model."""
    if args.output is not None:
        require_ending(args.output, ENDINGS)
    seed = require_seed(args.seed)
    pushes = chosen_pushes(args)
    from planar_pushing.pushes.compare import compare
    from planar_pushing.pushes.models import MODELS
    from planar_pushing.terms.netcdf import write_dataset

    models = [model for model in MODELS if args.identify or model != SLOW]
    scores = compare(
        pushes, models, splits=args.splits, workers=args.workers, seed=seed,
        progress=sys.stderr.isatty(),
    )  # fmt: skip
    written = {}
    if args.output is not None:
        write_dataset(scores, args.output)
        written = {"written": str(args.output)}
    entries = written | summary(scores)
    return entries if args.json else {"": lines(entries)}


def summary(scores: xr.Dataset) -> dict[str, Any]:
    """Statistics of each model for the quantities that were measured."""
    quantities = [str(label) for label in scores["quantity"].values]
    models = [str(label) for label in scores["model"].values]
    pairs = {
        quantity: {
            model: _statistics(scores.sel(quantity=quantity, model=model)) for model in models
        }
        for quantity in quantities
    }
    known = {
        quantity: {model: row for model, row in rows.items() if row["median"] == row["median"]}
        for quantity, rows in pairs.items()
    }
    return {
        "objects": [str(label) for label in scores["object"].values],
        "pushes": scores.sizes["push"],
        "seed": int(scores.attrs["seed"]),
        "splits": int(scores.attrs["splits"]),
        "reference": str(scores.attrs["reference"]),
        "units": {name: _unit(scores, name) for name in quantities if known[name]},
        "comparison": {name: rows for name, rows in known.items() if rows},
    }


def _statistics(one: xr.Dataset) -> dict[str, Any]:
    """Statistics of one quantity and model."""
    names = ("median", "percentile_90", "ratio", "ratio_90", "difference")
    return {name: float(one[name]) for name in names} | {
        f"{name}_interval": [float(end) for end in one[f"{name}_interval"].values] for name in names
    }


def _unit(scores: xr.Dataset, quantity: str) -> str:
    """Unit of the errors of a quantity."""
    return str(scores.attrs["pose_units"]) if quantity == "pose" else "degree"


def lines(entries: dict[str, Any]) -> str:
    """Format the numbers as lines, with a table for each quantity."""
    units, tables = entries["units"], entries["comparison"]
    rest = {name: entry for name, entry in entries.items() if name not in ("units", "comparison")}
    return "\n".join(
        [text(rest), *(_table(name, units[name], rows) for name, rows in tables.items())]
    )


def _table(quantity: str, unit: str, rows: dict[str, dict[str, Any]]) -> str:
    """Table with a row for each model."""
    return table([
        {
            f"{quantity} [{unit}]": model,
            "median": f"{row['median']:.3g}",
            "90 %": f"{row['percentile_90']:.3g}",
            "ratio": f"{row['ratio']:.3f}",
            "from": f"{row['ratio_interval'][0]:.3f}",
            "to": f"{row['ratio_interval'][1]:.3f}",
        }
        for model, row in rows.items()
    ])  # fmt: skip
