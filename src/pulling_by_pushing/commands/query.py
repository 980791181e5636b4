"""The command `query`."""

from __future__ import annotations

import argparse
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EffectSet
from planar_pushing.terms.quantities import unit_of
from pulling_by_pushing.study.catalog import DATASETS, opened
from pulling_by_pushing.study.studies import PAPER

if TYPE_CHECKING:
    import xarray as xr


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Print part of a dataset. --AXIS VALUE selects a value along an axis; angles are in degrees. "
        "Without DATASET, list the datasets that are built and the commands that build the others."
    )
    example = "motion_cones --effects inertia --rod-length 2"
    sub = command(commands, "query", part, about, example)
    sub.usage = (
        "planar-pushing query [DATASET] [--AXIS VALUE ...] [--axes] [--study NAME] "
        "[--results FOLDER] [--json]"
    )
    named = [name for name in opened() if not name.endswith("/NAME")]
    axes = sorted({option(axis) for entry in DATASETS.values() for axis in entry.dims})
    sub.words = (*named, *axes)
    sub.values = {
        "--effects": tuple(EffectSet), "--study": (PAPER, "$(ls results/studies 2>/dev/null)"),
    }  # fmt: skip
    sub.epilog = f"{_axes_of_datasets()}\n\n{sub.epilog}"
    sub.add_argument(
        "dataset", metavar="DATASET", nargs="?",
        help=f"{', '.join(opened())}; NAME is a scene, a simulation, or a figure of the study",
    )  # fmt: skip
    sub.add_argument(
        "--axes", action="store_true", help="list the axes of the dataset and their values instead"
    )
    sub.add_argument(
        "--results", type=Path, default=Path("results"), metavar="FOLDER",
        help="results folder that the pipeline has written (default: results)",
    )  # fmt: skip
    sub.add_argument(
        "--study", metavar="NAME", help="another study, by its name (default: the paper's)"
    )


def _axes_of_datasets() -> str:
    """Text with a line for each dataset that has axes."""
    lines = (
        f"  {name}: {' '.join(map(option, entry.dims))}"
        for name, entry in DATASETS.items()
        if entry.dims
    )
    return "\n".join(["axes:", *lines])


def option(axis: str) -> str:
    """Option that selects a value along an axis."""
    return f"--{axis.replace('_', '-')}"


def part(args: argparse.Namespace) -> dict[str, Any]:
    """Part of a dataset at the given axis values, its axes, or the list of datasets."""
    from pulling_by_pushing.study.query import axis_names, listed, select
    from pulling_by_pushing.study.store import open_dataset

    if args.dataset is None:
        return _listing(args)
    found = open_dataset(args.dataset, args.results, study=args.study)
    found = select(found, _pairs(args.where))
    if args.axes:
        return {option(name): listed(found.coords[name]) for name in axis_names(found)}
    return dict(found.to_dict()) if args.json else {"": _table(found)}


def _listing(args: argparse.Namespace) -> dict[str, Any]:
    """The datasets that are built, the commands that build the others, and the other studies."""
    from pulling_by_pushing.study.query import built_datasets, other_datasets
    from pulling_by_pushing.study.studies import built_studies

    if args.where:
        words = " ".join(args.where)
        raise InvalidValue("query", words, "a dataset, then its axes", "name a dataset first")
    if args.study is None and not (args.results / "data").is_dir():
        built = {}  # there may be other studies
    else:
        built = built_datasets(args.results, args.study)
    others, studies = other_datasets(built), built_studies(args.results)
    if args.json:
        return {"datasets": built, "not_built": others, "studies": studies}
    return {"": "\n".join([*_built(built, args.results), *_others(others), *_studies(studies)])}


def _built(titles: dict[str, str], results: Path) -> list[str]:
    width = max(map(len, titles), default=0)
    lines = [f"{name:<{width}}  {title}" for name, title in titles.items()]
    return lines or [f"{results}: holds no datasets of the paper's study"]


def _others(ways: dict[str, str]) -> list[str]:
    """Lines for the commands, each with the datasets that it builds."""
    names: dict[str, list[str]] = {}
    for name, way in ways.items():
        names.setdefault(way, []).append(name)
    lines = [f"  {', '.join(each)}: {way}" for way, each in names.items()]
    return ["not built here:", *lines] if lines else []


def _studies(names: list[str]) -> list[str]:
    return [f"other studies, for --study: {', '.join(names)}"] if names else []


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
    """Text: the selected values in one line, a line per single value, and a table per set of axes."""
    marks = {}
    for name, variable in found.variables.items():
        unit = _unit(found, variable)
        marks[name] = str(name) if unit == "1" else f"{name} [{unit}]"
    chosen = [name for name, coord in found.coords.items() if not coord.ndim]
    rest = found.drop_vars(chosen).map(_in_words, keep_attrs=True)
    singles = [name for name, variable in rest.data_vars.items() if not variable.ndim]
    width = max((len(marks[name]) for name in singles), default=0)
    blocks = [", ".join(f"{name}={found[name].item()}" for name in chosen)] if chosen else []
    if singles:
        blocks.append("\n".join(f"{marks[n]:<{width}}  {rest[n].item()}" for n in singles))
    for dims in dict.fromkeys(
        variable.dims for variable in rest.data_vars.values() if variable.ndim
    ):
        names = [name for name, variable in rest.data_vars.items() if variable.dims == dims]
        frame = _frame(rest, names, list(dims))
        frame.columns = [marks[name] for name in names]
        blocks.append(frame.to_string(max_rows=40, na_rep="none"))
    return "\n".join(blocks)


def _unit(found: xr.Dataset, variable: xr.Variable) -> str:
    """Unit of a variable, or units of its components."""
    unit = unit_of(variable.attrs)
    components = found[unit] if unit in found.coords else None
    return unit if components is None else ", ".join(map(str, components.values.ravel()))


def _in_words(variable: xr.DataArray) -> xr.DataArray:
    """Replace flag values by their names, or by a dash if a value has no name."""
    import numpy as np

    attrs = variable.attrs
    if "flag_values" not in attrs:
        return variable
    words = dict(zip(attrs["flag_values"].tolist(), attrs["flag_meanings"].split(), strict=True))
    listed = [words.get(each, "-") for each in variable.values.ravel().tolist()]
    array = np.array(listed, dtype=object).reshape(variable.shape)
    return variable.copy(data=array)


def _frame(found: xr.Dataset, names: list[Hashable], dims: list[Hashable]) -> Any:
    """Values along the same axes, without the unused entries along `solution`."""
    frame = found[names].to_dataframe(dim_order=dims)[names]
    if "solution" not in dims or "consistent" not in found:
        return frame
    held = found[["consistent"]].broadcast_like(found[names]).to_dataframe(dim_order=dims)
    return frame[held["consistent"]]
