"""A log that grows on disk: each batch of records is appended and flushed.

Unlike a dataset, a log is not written to a temporary file that is moved into place when complete. A killed
run therefore leaves its log up to that time, with the attribute `finished` equal to 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager

import h5netcdf
import h5py

from planar_pushing.simulation import log
from planar_pushing.simulation.fields import arrays, logged_fields
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.storage.disk import Disk, block_interrupts, new_file
from planar_pushing.terms.locks import PathLike
from planar_pushing.terms.numbers import Array

#: Number of instants in a chunk of the file.
CHUNK = 256


class Stream:
    """An open log; `append` writes a batch of rows and flushes it."""

    def __init__(
        self, file: h5netcdf.File, hdf: h5py.File, disk: Disk, problem: Problem, method: str
    ) -> None:
        self.file, self.hdf, self.disk, self.length, self.problem = file, hdf, disk, 0, problem
        self.fields = logged_fields(problem, method)

    def append(self, rows: Array) -> None:
        """Write rows, in the units of the scene, to the end of the log."""
        start, self.length = self.length, self.length + len(rows)
        with block_interrupts():
            self.file.resize_dimension("time", self.length)
            for name, value in arrays(rows, self.problem, self.fields).items():
                stored = value.view("i1") if value.dtype == bool else value
                self.file.variables[name][start : self.length] = stored
            # Flush netCDF to HDF5, and HDF5 to the disk.
            self.file.flush()
            self.hdf.flush()
        self.disk.check()

    def end(self, stopped: str, time: float) -> None:
        """Store that the run has ended, the time, and the reason for an early end."""
        with block_interrupts():
            self.file.attrs.update(log.attributes_at_end(stopped, time))


@contextmanager
def streaming(path: PathLike, problem: Problem, method: str) -> Iterator[Stream]:
    """Open a new log at `path`.

    Raises
    ------
    InvalidFile
        If the file cannot be written.
    """
    with ExitStack() as files:
        with block_interrupts():
            disk = files.enter_context(new_file(path))
            # netCDF readers require the creation order.
            hdf = files.enter_context(h5py.File(disk, "w", track_order=True))
            file = files.enter_context(h5netcdf.File(hdf, "r+"))
            _define(file, problem, method)
        try:
            yield Stream(file, hdf, disk, problem, method)
        finally:
            with block_interrupts():
                files.close()


def _define(file: h5netcdf.File, problem: Problem, method: str) -> None:
    coordinates = log.coordinates(problem)
    sizes = {dim: len(labels) for dim, labels in coordinates.values()}
    file.dimensions = {"time": None} | sizes
    file.attrs.update(log.attributes_at_start(problem, method))
    time, *fields = logged_fields(problem, method)
    created = file.create_variable(time.name, ("time",), time.dtype, chunks=(CHUNK,))
    created.attrs.update(log.field_attributes(problem, time.name))
    for name, (dim, labels) in coordinates.items():
        label = file.create_variable(name, (dim,), h5py.string_dtype())
        label[:] = labels
        label.attrs.update(log.field_attributes(problem, name))
    for name, _, dims, dtype, *_ in fields:
        chunks = CHUNK, *(sizes[dim] for dim in dims)
        # netCDF has no booleans; xarray stores them as bytes with this attribute, and so do we.
        stored, truth = ("i1", {"dtype": "bool"}) if dtype == "?" else (dtype, {})
        created = file.create_variable(name, ("time", *dims), stored, chunks=chunks)
        along = [label for label, (dim, _) in coordinates.items() if label != dim and dim in dims]
        named = {"coordinates": " ".join(along)} if along else {}
        created.attrs.update(log.field_attributes(problem, name) | truth | named)
