"""The figures of what accuracy costs: drawn from results/data/accuracy.nc alone."""

from __future__ import annotations

import importlib
from typing import Protocol, cast

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.render import PathLike, save
from planar_pushing.figures.style import paper_style
from planar_pushing.study.store import read_dataset


class AccuracyFigure(Protocol):
    """What a module accuracy_NAME provides."""

    SIZE: tuple[float, float]
    SOURCE: str

    def draw(self, figure: Figure, data: xr.Dataset) -> None: ...


def draw_accuracy(name: str, data: PathLike, pictures: list[str]) -> None:
    """Draw a figure and save it in each of the formats that the file names end in.

    Parameters
    ----------
    name : str
        "accuracy_wrench", "accuracy_cone" or "accuracy_study".
    data : path
        The measurements, results/data/accuracy.nc.
    pictures : list of str
        Files to write, svg, pdf or png.
    """
    module = cast(
        AccuracyFigure, importlib.import_module(f"planar_pushing.figures.evidence.{name}")
    )
    with paper_style():
        figure = Figure(figsize=module.SIZE)
        module.draw(figure, read_dataset(data, module.SOURCE))
        for path in pictures:
            save(figure, path)
