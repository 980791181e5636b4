"""Select, store, draw and save a figure: first its data, then the pictures from that file alone."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from types import SimpleNamespace
from typing import Any

from matplotlib.figure import Figure

from planar_pushing.drawing.canvas.saving import save, save_drawn
from planar_pushing.drawing.canvas.style import paper_style
from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.figures.figure import drawing, select
from pulling_by_pushing.study.describe import of_study
from pulling_by_pushing.study.store import read_dataset

PathLike = str | os.PathLike[str]


def picture(name: str, data: Any, variant: str = "") -> Figure:
    """Figure drawn from its data; call it and save the figure within `paper_style`."""
    found = drawing(name)
    figure = Figure(figsize=found.FIGURE.variants[variant])
    found.draw(figure, data)
    return figure


def _draw(name: str, data: Any, paths: Iterable[PathLike], variant: str = "") -> None:
    with paper_style():
        figure = picture(name, data, variant)
        for path in paths:
            save(figure, path)


def figure(
    *, name: str, results: str, settings: Mapping[str, object], marks: Mapping[str, str],
    data: PathLike, **paths: PathLike,
) -> None:  # fmt: skip
    """Write the numbers that a figure plots, then its pictures from that file.

    Parameters
    ----------
    name : str
        Name of the figure, such as "figure_01".
    results : str
        Folder that contains data/*.nc.
    settings : mapping
        Values of the study for this figure.
    marks : mapping
        Attributes that identify the study, as returned by `provenance`.
    data : path
        File for the numbers.
    paths : paths
        Pictures to save; the ending of a name determines the format.
    """
    write_dataset(of_study(select(name, results, SimpleNamespace(**settings)), name, marks), data)
    _draw(name, read_dataset(data), paths.values())


def file_figure(source: PathLike, *, name: str, variant: str = "", **paths: PathLike) -> None:
    """Draw a figure or a variant of it from the file of its numbers."""
    _draw(name, read_dataset(source), paths.values(), variant)


def evidence_figure(*, name: str, results: PathLike, **paths: PathLike) -> None:
    """Draw a figure on the computation itself from its datasets in a results folder."""
    _draw(name, select(name, results, None), paths.values())


def pushes_figure(source: PathLike, *, name: str, variant: str = "", **paths: PathLike) -> None:
    """Draw a figure on measured pushes, or a variant of it, from the file of its numbers."""
    from pulling_by_pushing.figures.parts.measured import read_pushes

    _draw(name, read_pushes(source), paths.values(), variant)


def simulation_figure(source: PathLike, **paths: PathLike) -> None:
    """Draw a simulation from its log."""
    from planar_pushing.drawing.draw import LOG, plot_log

    log = read_dataset(source)
    save_drawn(lambda figure: plot_log(log, figure), LOG, paths.values())
