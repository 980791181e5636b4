"""A figure is one module: what it reads, selects, says and draws. They are found by their names.

A module `figure_03` holds `FIGURE`, `select(sources, settings)` for the numbers that it plots,
`caption(data)` and `draw(figure, data)`. The job of a figure stores the numbers first, and draws from that
file alone.
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

#: Widths of a journal's column and page, inches.
COLUMN, PAGE = 3.4, 7.0
#: Datasets by the names in `reads`.
Sources = Mapping[str, xr.Dataset]
STATICS = "Sec. 3: quasi-static pushing and pulling"
DYNAMICS = "Sec. 4: dynamic pushing and pulling"
FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """Entry of a figure: all that is known before it is drawn.

    Attributes
    ----------
    title : str
        What it shows, in a few words.
    reads : tuple of str
        Datasets that it is drawn from, as "dataset" or "dataset/group", or a file of the project.
    size : tuple of float
        Width and height, inches.
    column : tuple of float, optional
        The same of the variant for one column, of a figure that is wider than a column.
    takes : tuple of str
        Values that its entry in the study gives.
    needs : str, optional
        Effects that the grid of the study has to list.
    at : mapping
        Values of axes at which it cuts its datasets, beside the rod angle of the study.
    section : str
        Section of the paper in which it stands.
    promise : str
        What the paper's caption promises, in our words; empty for a figure of ours.
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
        """Sizes by the end of the name of a file: the figure, and its variant for one column."""
        return {"": self.size} | ({"_column": self.column} if self.column else {})


#: Values that a study gives a figure, by the names of their keys.
Settings = Any


class Drawing(Protocol):
    """Module of a figure; one that plots a whole dataset needs no `select`."""

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
        Where there is no figure of this name.
    """
    known = figure_names()
    if name not in known:
        raise InvalidValue("figure", name, ", ".join(known), "name one of these figures")
    return cast(Drawing, import_module(f"planar_pushing.figures.{name}"))


def entry(name: str) -> Figure:
    """Entry of a figure; errors as in `drawing`."""
    return drawing(name).FIGURE
