"""Each figure is one module with its sources, data, caption and drawing; modules are found by name.

A module such as `figure_03` defines `FIGURE`, `select(sources, settings)` for the plotted numbers,
`caption(data)` and `draw(figure, data)`. The job of a figure first stores the numbers and then draws from
that file alone.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import Any, Protocol, cast

import xarray as xr

from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.store import open_dataset

#: Datasets by the names in `reads`.
Sources = Mapping[str, xr.Dataset]
STATICS = "Sec. 3: quasi-static pushing and pulling"
DYNAMICS = "Sec. 4: dynamic pushing and pulling"
FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """Description of a figure before it is drawn.

    Attributes
    ----------
    title : str
        Subject of the figure in a few words.
    reads : tuple of str
        Datasets from which it is drawn, as "dataset" or "dataset/group", or a file of the project.
    size : tuple of float
        Width and height, inches.
    column : tuple of float, optional
        Width and height of the one-column variant, if the figure is wider than a column.
    takes : tuple of str
        Names of values that its entry in the study provides.
    needs : str, optional
        Effects that the grid of the study must list.
    at : mapping
        Axis values at which it cuts its datasets, in addition to the rod angle of the study.
    section : str
        Section of the paper to which it belongs.
    promise : str
        Content announced by the paper's caption, in our words; empty for a figure that is not in the
        paper.
    """

    title: str
    reads: tuple[str, ...]
    size: tuple[float, float]
    column: tuple[float, float] | None = None
    takes: tuple[str, ...] = ()
    needs: str | None = None
    at: Mapping[str, float] = field(default_factory=dict)
    section: str = ""
    promise: str = ""

    @property
    def variants(self) -> dict[str, tuple[float, float]]:
        """Sizes by file-name suffix: of the figure, and of its one-column variant."""
        return {"": self.size} | ({"_column": self.column} if self.column else {})


#: Values that a study provides for a figure, by key.
Settings = Any


class Drawing(Protocol):
    """Module of a figure; a figure that plots a whole dataset needs no `select`."""

    FIGURE: Figure

    def select(self, sources: Sources, settings: Settings) -> xr.Dataset: ...

    def caption(self, data: xr.Dataset) -> str: ...

    def draw(self, figure: Any, data: xr.Dataset) -> None: ...


def figure_names() -> list[str]:
    """Names of all figures."""
    found = [path for path in Path(__file__).parent.glob("*.py") if _is_figure(path)]
    return sorted(path.stem for path in found)


def _is_figure(path: Path) -> bool:
    return re.search(r"^FIGURE = ", path.read_text(encoding="utf-8"), re.MULTILINE) is not None


def drawing(name: str) -> Drawing:
    """Module of a figure, such as "figure_08".

    Raises
    ------
    InvalidValue
        If there is no figure of this name.
    """
    known = figure_names()
    if name not in known:
        raise InvalidValue("figure", name, ", ".join(known), "name one of these figures")
    return cast(Drawing, import_module(f"pulling_by_pushing.figures.{name}"))


def entry(name: str) -> Figure:
    """Entry of a figure; errors as in `drawing`."""
    return drawing(name).FIGURE


def select(name: str, results: PathLike, settings: Settings) -> xr.Dataset:
    """Select the numbers that a figure plots from the datasets in a results folder.

    A figure without `select` plots its only dataset.
    """
    module = drawing(name)
    sources = {each: open_dataset(each, results) for each in module.FIGURE.reads}
    return module.select(sources, settings) if hasattr(module, "select") else sources.popitem()[1]


def full_caption(name: str, data: Any) -> str:
    """Caption as printed; a reconstruction names its figure in the paper; errors as in `drawing`."""
    module = drawing(name)
    if not module.FIGURE.promise:
        return module.caption(data)
    number = int(name.removeprefix("figure_"))
    return f"{module.caption(data)} After Fig. {number} of Lynch and Mason."
