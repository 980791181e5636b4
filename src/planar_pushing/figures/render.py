"""Select, store, draw and save a figure: its data first, then the picture from that file alone."""

from __future__ import annotations

import importlib
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, cast

import xarray as xr
from matplotlib.figure import Figure

from planar_pushing.figures.catalog import FIGURES
from planar_pushing.figures.settings import Settings
from planar_pushing.figures.style import COLUMN_WIDTH, paper_style
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.study.replacing import replacing
from planar_pushing.study.store import open_dataset, read_dataset, write_dataset

if TYPE_CHECKING:  # a job that draws a figure validates no file
    from planar_pushing.study.models import PushEntry
    from planar_pushing.study.scene_model import SceneFile

PathLike = str | os.PathLike[str]
SCENE_SIZE = (COLUMN_WIDTH, COLUMN_WIDTH)

#: How each format is saved: without metadata that would tell when and by which program version, and a PNG
#: lightly compressed, in a third less time for a fifth more bytes.
SAVING: dict[str, dict[str, Any]] = {
    "svg": {"metadata": {"Date": None, "Creator": "planar-pushing"}},
    "pdf": {"metadata": {"CreationDate": None, "Creator": "planar-pushing", "Producer": None}},
    "png": {"metadata": {"Software": None}, "pil_kwargs": {"compress_level": 1}},
}


class FigureModule(Protocol):
    """What a module figure_NN provides."""

    SIZE: tuple[float, float]

    def select(self, sources: Mapping[str, xr.Dataset], settings: Settings) -> xr.Dataset: ...

    def draw(self, figure: Figure, data: xr.Dataset) -> None: ...


def figure_module(name: str) -> FigureModule:
    """Import the module of a figure by name, such as "figure_08".

    Raises
    ------
    InvalidValue
        Where there is no figure of this name.
    """
    if name not in FIGURES:
        raise InvalidValue("figure", name, ", ".join(FIGURES), "name one of these figures")
    return cast(FigureModule, importlib.import_module(f"planar_pushing.figures.paper.{name}"))


def select(name: str, results: PathLike, settings: Settings) -> xr.Dataset:
    """Numbers that a figure plots, read from the datasets in a results folder."""
    module = figure_module(name)
    sources = {source: open_dataset(source, results) for source in FIGURES[name]}
    return module.select(sources, settings)


def picture(name: str, data: xr.Dataset) -> Figure:
    """Figure drawn from its data; call it, and save the figure, within `paper_style`."""
    module = figure_module(name)
    figure = Figure(figsize=module.SIZE)
    module.draw(figure, data)
    return figure


def render_scene(file: SceneFile, push: PushEntry, path: PathLike) -> None:
    """Draw a scene file under a push, and save it as svg, pdf or png by the end of its name."""
    # Imported by name: the figures of the paper do not depend on how a scene's dataset is built.
    scenes = importlib.import_module("planar_pushing.study.datasets.scenes")
    scene = importlib.import_module("planar_pushing.figures.parts.scene")
    with paper_style():
        figure = Figure(figsize=SCENE_SIZE)
        scene.draw_scene(figure, scenes.scene_dataset(file, push))
        save(figure, path)


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


def render(
    name: str,
    results: PathLike,
    settings: Settings,
    *,
    data: PathLike,
    svg: PathLike,
    pdf: PathLike,
    png: PathLike,
) -> None:
    """Write a figure's data and its picture in three formats.

    Parameters
    ----------
    name : str
        "figure_01" to "figure_15".
    results : path
        The folder that holds data/*.nc.
    settings : Settings
        The study's values for this figure.
    data, svg, pdf, png : path
        Files to write. The picture is drawn from what `data` holds once it is written.
    """
    write_dataset(select(name, results, settings), data)
    with paper_style():
        figure = picture(name, read_dataset(data))
        for path in (svg, pdf, png):
            save(figure, path)
