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
from planar_pushing.simulation.rows import ROW, records
from planar_pushing.terms.errors import InvalidFile

PathLike = str | os.PathLike[str]
#: Instants in a chunk of the file.
CHUNK = 256


class Stream:
    """An open log; `append` writes a batch and flushes it."""

    def __init__(self, file: h5netcdf.File, disk: h5py.File, scene: Scene) -> None:
        self.file, self.disk, self.length, self.scene = file, disk, 0, scene

    def append(self, rows: Any) -> None:
        """Write rows to the end of the log."""
        start, self.length = self.length, self.length + len(rows)
        self.file.resize_dimension("time", self.length)
        for name, value in log.arrays(rows, self.scene).items():
            self.file.variables[name][start : self.length] = value
        # What netCDF adds goes to the file, and the file to the disk.
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
    empty = log.dataset(problem, method, records(ROW, 0)).assign_attrs(finished=0)
    chunks = {
        name: {"chunksizes": (CHUNK, *variable.shape[1:])}
        for name, variable in empty.variables.items()
        if "time" in variable.dims
    }
    try:
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        empty.to_netcdf(path, engine="h5netcdf", unlimited_dims=["time"], encoding=chunks)
        disk = h5py.File(path, "r+")
    except OSError as error:
        raise InvalidFile(f"{path}: cannot be written ({error}); name another file") from None
    with disk, h5netcdf.File(disk, "r+") as file:
        yield Stream(file, disk, problem.scene)
