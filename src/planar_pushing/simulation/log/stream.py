"""A log that grows on disk: each batch of records is appended and flushed.

A log is not written beside its place and moved there when complete, as datasets are: a run that is killed
leaves what it has logged so far, with the attribute `finished` at 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

import h5netcdf
import h5py

from planar_pushing.simulation.log import variables as log
from planar_pushing.simulation.log.disk import Disk, PathLike, new_file
from planar_pushing.simulation.log.interrupts import undisturbed
from planar_pushing.simulation.problem import Problem

#: Instants in a chunk of the file.
CHUNK = 256


class Stream:
    """An open log; `append` writes a batch and flushes it."""

    def __init__(self, file: h5netcdf.File, hdf: h5py.File, disk: Disk, problem: Problem) -> None:
        self.file, self.hdf, self.disk, self.length, self.problem = file, hdf, disk, 0, problem

    def append(self, rows: Any) -> None:
        """Write rows to the end of the log."""
        start, self.length = self.length, self.length + len(rows)
        with undisturbed():
            self.file.resize_dimension("time", self.length)
            for name, value in log.arrays(rows, self.problem).items():
                stored = value.view("i1") if value.dtype == bool else value
                self.file.variables[name][start : self.length] = stored
            # What netCDF adds goes to the file, and the file to the disk.
            self.file.flush()
            self.hdf.flush()
        self.disk.check()

    def end(self, stopped: str, time: float) -> None:
        """Note that the run has ended, when, and why before its time."""
        with undisturbed():
            self.file.attrs.update(log.ending(stopped, time))


@contextmanager
def streaming(path: PathLike, problem: Problem, method: str) -> Iterator[Stream]:
    """Open a new log at `path`.

    Raises
    ------
    InvalidFile
        Where the file cannot be written.
    """
    with ExitStack() as files:
        with undisturbed():
            disk = files.enter_context(new_file(path))
            # netCDF readers want the order of creation kept.
            hdf = files.enter_context(h5py.File(disk, "w", track_order=True))
            file = files.enter_context(h5netcdf.File(hdf, "r+"))
            _define(file, problem, method)
        try:
            yield Stream(file, hdf, disk, problem)
        finally:
            with undisturbed():
                files.close()


def _define(file: h5netcdf.File, problem: Problem, method: str) -> None:
    coordinates, table = log.coordinates(problem), log.table_of(problem.shape)
    units = problem.scene.units
    file.dimensions = {"time": None} | {name: len(each) for name, each in coordinates.items()}
    file.attrs.update(log.attributes(problem, method) | {"finished": 0})
    time = file.create_variable("time", ("time",), "f8", chunks=(CHUNK,))
    time.attrs.update(log.described(table, "time", units))
    for name, labels in coordinates.items():
        label = file.create_variable(name, (name,), h5py.string_dtype())
        label[:] = labels
        label.attrs.update(log.described(table, name, units))
    for name, (dims, dtype) in log.variables(problem).items():
        chunks = CHUNK, *(len(coordinates[dim]) for dim in dims)
        # netCDF has no truth values: xarray stores them as bytes with this attribute, and so do we.
        stored, truth = ("i1", {"dtype": "bool"}) if dtype == "?" else (dtype, {})
        created = file.create_variable(name, ("time", *dims), stored, chunks=chunks)
        created.attrs.update(log.described(table, name, units) | truth)
