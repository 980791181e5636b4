"""What the workflow's jobs on figures call."""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace

from planar_pushing.figures.motion import simulation
from planar_pushing.figures.render import PathLike, render, render_file


def figure(
    *,
    name: str,
    results: str,
    settings: Mapping[str, object],
    marks: Mapping[str, str],
    **paths: PathLike,
) -> None:
    """Write the numbers that a figure plots, and the picture in three formats; paths as in `render`."""
    render(name, results, SimpleNamespace(**settings), marks=marks, **paths)


def file_figure(source: PathLike, *, name: str, **paths: PathLike) -> None:
    """Draw a figure from the file of its one dataset."""
    render_file(name, source, paths.values())


def simulation_figure(source: PathLike, **paths: PathLike) -> None:
    """Draw a simulation from its log."""
    simulation.render(source, list(paths.values()))
