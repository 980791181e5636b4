"""The command `query`."""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import Commands, command, missing_value, with_unit
from planar_pushing.terms.errors import InvalidValue, PlanarPushingError, require_name
from planar_pushing.terms.options import EffectSet
from planar_pushing.terms.quantities import unit_of
from pulling_by_pushing.study.catalog import DATASETS, dataset_names
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
    sub = command(commands, "query", query_dataset, about, example)
    sub.usage = (
        "planar-pushing query [DATASET] [--AXIS VALUE ...] [--axes] [--study NAME] "
        "[--results FOLDER] [--json]"
    )
    named = [name for name in dataset_names() if not name.endswith("/NAME")]
    axes = sorted({option(axis) for entry in DATASETS.values() for axis in entry.selectors})
    sub.words, sub.open = (*named, *axes), True
    sub.values = {
        "--effects": tuple(EffectSet), "--study": f"echo {PAPER}; ls results/studies 2>/dev/null",
    }  # fmt: skip
    sub.epilog = f"{_axes_of_datasets()}\n\n{sub.epilog}"
    sub.add_argument(
        "dataset", metavar="DATASET", nargs="?",
        help=f"{', '.join(dataset_names())}; NAME is a scene, a simulation, or a figure of the study",
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
    sub.set_defaults(options=sub.options)


def _axes_of_datasets() -> str:
    """Text with a line for each dataset that has axes."""
    lines = (
        f"  {name}: {' '.join(map(option, entry.selectors))}"
        for name, entry in DATASETS.items()
        if entry.selectors
    )
    return "\n".join(["axes:", *lines])


def option(axis: str) -> str:
    """Option that selects a value along an axis."""
    return f"--{axis.replace('_', '-')}"


def query_dataset(args: argparse.Namespace) -> dict[str, Any]:
    """Part of a dataset at the given axis values, its axes, or the list of datasets."""
    from pulling_by_pushing.study.query import axis_names, axis_text, select
    from pulling_by_pushing.study.store import open_dataset

    if args.dataset is None:
        return _listing(args)
    dataset = open_dataset(args.dataset, args.results, study=args.study)
    axes = list(map(option, axis_names(dataset)))
    for word in args.where:
        if word.startswith("--"):
            name, remedy = word.partition("=")[0], "name one of the dataset's axes"
            require_name("option", name, (*axes, *args.options), remedy)
    dataset = select(dataset, _pairs(args.where))
    if args.axes:
        return {option(name): axis_text(dataset.coords[name]) for name in axis_names(dataset)}
    return dict(dataset.to_dict()) if args.json else {"": _table(dataset)}


def _listing(args: argparse.Namespace) -> dict[str, Any]:
    """The datasets that are built, how to get the others, and the other studies."""
    from pulling_by_pushing.study.query import built_datasets, other_datasets
    from pulling_by_pushing.study.studies import built_studies

    if args.where:
        raise _no_dataset(args.where)
    if args.study is None and not (args.results / "data").is_dir():
        built = {}  # there may be other studies
    else:
        built = built_datasets(args.results, args.study)
    others, studies = other_datasets(built, args.results), built_studies(args.results)
    if args.json:
        return {"datasets": built, "not_built": others, "studies": studies}
    return {
        "": "\n".join(
            [*_title_lines(built, args.results), *_other_lines(others), *_studies(studies)]
        )
    }


def _no_dataset(words: Sequence[str]) -> PlanarPushingError:
    """Error for axes without a dataset, with the datasets that have them."""
    axes = {word.partition("=")[0] for word in words if word.startswith("--")}
    names = [name for name, entry in DATASETS.items() if axes <= set(map(option, entry.selectors))]
    remedy = "name a dataset first"
    if names:
        remedy = f"type for example planar-pushing query {names[0]} {shlex.join(words)}"
    return missing_value("dataset", ", ".join(names or dataset_names()), remedy)


def _title_lines(titles: dict[str, str], results: Path) -> list[str]:
    width = max(map(len, titles), default=0)
    lines = [f"{name:<{width}}  {title}" for name, title in titles.items()]
    return lines or [f"{results}: holds no datasets of the paper's study"]


def _other_lines(remedies: dict[str, str]) -> list[str]:
    """Lines that say how to get the datasets that are not built, those with one remedy in one line."""
    names: dict[str, list[str]] = {}
    for name, remedy in remedies.items():
        names.setdefault(remedy, []).append(name)
    lines = [f"  {', '.join(datasets)}: {remedy}" for remedy, datasets in names.items()]
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


def _table(dataset: xr.Dataset) -> str:
    """Text: the selected values in one line, a line per single value, and a table per set of axes."""
    marks = {}
    for name, variable in dataset.variables.items():
        marks[name] = with_unit(str(name), _unit(dataset, variable))
    scalars = [name for name, coord in dataset.coords.items() if not coord.ndim]
    rest = dataset.drop_vars(scalars).map(_in_words, keep_attrs=True)
    singles = [name for name, variable in rest.data_vars.items() if not variable.ndim]
    width = max((len(marks[name]) for name in singles), default=0)
    blocks = [", ".join(f"{name}={dataset[name].item()}" for name in scalars)] if scalars else []
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


def _unit(dataset: xr.Dataset, variable: xr.Variable) -> str:
    """Unit of a variable, or units of its components."""
    unit = unit_of(variable.attrs)
    components = dataset[unit] if unit in dataset.coords else None
    return unit if components is None else ", ".join(map(str, components.values.ravel()))


def _in_words(variable: xr.DataArray) -> xr.DataArray:
    """Replace flag values by their names, or by a dash if a value has no name."""
    import numpy as np

    attrs = variable.attrs
    if "flag_values" not in attrs:
        return variable
    words = dict(zip(attrs["flag_values"].tolist(), attrs["flag_meanings"].split(), strict=True))
    names = [words.get(value, "-") for value in variable.values.ravel().tolist()]
    array = np.array(names, dtype=object).reshape(variable.shape)
    return variable.copy(data=array)


def _frame(dataset: xr.Dataset, names: list[Hashable], dims: list[Hashable]) -> Any:
    """Values along the same axes, without the unused entries along `solution`."""
    frame = dataset[names].to_dataframe(dim_order=dims)[names]
    if "solution" not in dims or "consistent" not in dataset:
        return frame
    held = dataset[["consistent"]].broadcast_like(dataset[names]).to_dataframe(dim_order=dims)
    return frame[held["consistent"]]
