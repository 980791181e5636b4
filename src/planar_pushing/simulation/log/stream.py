"""A log that grows on disk: each batch of records is appended and flushed.

A log is not written beside its place and moved there when complete, as datasets are: a run that is killed
leaves what it has logged so far, with the attribute `finished` at 0.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5netcdf
import h5py

from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.log import variables as log
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.errors import InvalidFile

PathLike = str | os.PathLike[str]
#: Instants in a chunk of the file.
CHUNK = 256


class Stream:
    """An open log; `append` writes a batch and flushes it."""

    def __init__(self, file: h5netcdf.File, disk: h5py.File, scene: Scene) -> None:
        self.file, self.disk, self.length, self.scene = file, disk, 0, scene
        self._flush()

    def append(self, rows: Any) -> None:
        """Write rows to the end of the log."""
        values = log.arrays(rows, self.scene)
        start, self.length = self.length, self.length + len(rows)
        self.file.resize_dimension("time", self.length)
        for name, value in values.items():
            stored = value.view("i1") if value.dtype == bool else value
            self.file.variables[name][start : self.length] = stored
        self._flush()

    def _flush(self) -> None:
        """What netCDF adds goes to the file, and the file to the disk."""
        self.file.flush()
        self.disk.flush()

    def end(self, stopped: str, time: float) -> None:
        """Note that the run has ended, when, and why before its time."""
        self.file.attrs.update(log.ending(stopped, time))


@contextmanager
def streaming(path: PathLike, problem: Problem, method: str) -> Iterator[Stream]:
    """Open a new log at `path`.

    Raises
    ------
    InvalidFile
        Where the file cannot be written.
    """
    target = Path(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        # netCDF readers want the order of creation kept.
        disk = h5py.File(target, "w", track_order=True)
    except OSError as error:
        raise InvalidFile(f"{path}: cannot be written ({error}); name another file") from None
    with disk, h5netcdf.File(disk, "r+") as file:
        _define(file, problem, method)
        yield Stream(file, disk, problem.scene)


def _define(file: h5netcdf.File, problem: Problem, method: str) -> None:
    coordinates = log.coordinates(problem.scene)
    file.dimensions = {"time": None} | {name: len(each) for name, each in coordinates.items()}
    file.attrs.update(log.attributes(problem, method) | {"finished": 0})
    time = file.create_variable("time", ("time",), "f8", chunks=(CHUNK,))
    time.attrs.update(log.variable_attributes("time"))
    for name, labels in coordinates.items():
        label = file.create_variable(name, (name,), h5py.string_dtype())
        label[:] = labels
        label.attrs.update(log.variable_attributes(name))
    for name, variable in log.VARIABLES.items():
        dims = "time", *variable.dims
        chunks = CHUNK, *(len(coordinates[dim]) for dim in variable.dims)
        # netCDF has no truth values: xarray stores them as bytes with this attribute, and so do we.
        truth = variable.dtype == "?"
        created = file.create_variable(name, dims, "i1" if truth else variable.dtype, chunks=chunks)
        created.attrs.update(log.variable_attributes(name) | ({"dtype": "bool"} if truth else {}))
