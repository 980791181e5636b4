"""Select, store, draw and save a figure: its data first, then the picture from that file alone."""

from __future__ import annotations

import os
import pkgutil
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Protocol, cast

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.settings import Settings, Sources
from planar_pushing.figures.style import paper_style
from planar_pushing.study.describe import of_study
from planar_pushing.study.figures import ALL
from planar_pushing.study.files.replacing import replacing
from planar_pushing.study.store import open_dataset, read_dataset, write_dataset
from planar_pushing.terms.errors import InvalidValue

PathLike = str | os.PathLike[str]
Draw = Callable[[Figure, xr.Dataset], object]

#: How each format is saved: without metadata that would tell when and by which program version.
SAVING: dict[str, dict[str, Any]] = {
    "svg": {"metadata": {"Date": None, "Creator": "planar-pushing"}},
    "pdf": {"metadata": {"CreationDate": None, "Creator": "planar-pushing", "Producer": None}},
    "png": {"metadata": {"Software": None}},
}


#: What a picture outside of a study is marked with.
NO_MARKS: dict[str, str] = {}


class Drawing(Protocol):
    """What draws a figure; one of a single dataset needs no `select`."""

    def select(self, sources: Sources, settings: Settings) -> xr.Dataset: ...

    def draw(self, figure: Figure, data: xr.Dataset) -> None: ...


def drawing(name: str) -> Drawing:
    """Drawing of a figure, such as "figure_08".

    Its entry names the module, and a job's digest starts from the same entry: a job depends on the
    module of its own figure alone.

    Raises
    ------
    InvalidValue
        Where there is no figure of this name.
    """
    if name not in ALL:
        raise InvalidValue("figure", name, ", ".join(ALL), "name one of these figures")
    return cast(Drawing, pkgutil.resolve_name(f"planar_pushing.{ALL[name].drawing}"))


def select(name: str, results: PathLike, settings: Settings) -> xr.Dataset:
    """Numbers that a figure plots, read from the datasets in a results folder."""
    found = drawing(name)
    sources = {source: open_dataset(source, results) for source in ALL[name].datasets}
    return found.select(sources, settings)


def picture(name: str, data: xr.Dataset) -> Figure:
    """Figure drawn from its data; call it, and save the figure, within `paper_style`."""
    found = drawing(name)
    figure = Figure(figsize=ALL[name].size)
    found.draw(figure, data)
    return figure


def save(figure: Figure, path: PathLike) -> None:
    """Save a picture, whole or not at all; the bytes depend on the picture alone.

    Raises
    ------
    InvalidValue
        Where the file name does not end in .svg, .pdf or .png.
    """
    kind = Path(path).suffix.lstrip(".").lower()
    if kind not in SAVING:
        allowed = ", ".join(f".{each}" for each in SAVING)
        raise InvalidValue("output", str(path), f"a name ending in {allowed}", "rename the file")
    with replacing(path) as temporary:
        figure.savefig(temporary, format=kind, **SAVING[kind])


def draw_to_files(
    draw: Draw, size: tuple[float, float], data: xr.Dataset, paths: Iterable[PathLike]
) -> None:
    """Draw a picture of a size in inches, and save it under each name; errors as in `save`."""
    with paper_style():
        figure = Figure(figsize=size)
        draw(figure, data)
        for path in paths:
            save(figure, path)


def render_file(name: str, data: PathLike, paths: Iterable[PathLike]) -> None:
    """Draw a figure of one dataset from its file, and save it under each name."""
    (source,) = ALL[name].datasets
    found = read_dataset(data, source.partition("/")[2] or None)
    draw_to_files(drawing(name).draw, ALL[name].size, found, paths)


def render(
    name: str,
    results: PathLike,
    settings: Settings,
    *,
    marks: Mapping[str, str] = NO_MARKS,
    data: PathLike,
    svg: PathLike,
    pdf: PathLike,
    png: PathLike,
) -> None:
    """Write a figure's data and its picture in three formats.

    Parameters
    ----------
    name : str
        "figure_01" to "figure_20".
    results : path
        The folder that holds data/*.nc.
    settings : Settings
        The study's values for this figure.
    marks : mapping
        Attributes that name the study, as `provenance` gives them.
    data, svg, pdf, png : path
        Files to write. The picture is drawn from what `data` holds once it is written.
    """
    write_dataset(of_study(select(name, results, settings), name, marks), data)
    draw_to_files(drawing(name).draw, ALL[name].size, read_dataset(data), (svg, pdf, png))
