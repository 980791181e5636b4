"""A file on disk for HDF5, whose failed writes are reported in Python.

HDF5 cannot give up a file that it cannot write, as on a full disk: it prints errors while objects are
destroyed, and crashes when the process ends. Here it never sees the failure; `check` raises it.
"""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import InvalidFile

PathLike = str | os.PathLike[str]


class Disk(io.FileIO):
    """A new file without a buffer of its own, which keeps the first failure to write."""

    def __init__(self, path: PathLike) -> None:
        super().__init__(path, "w+")
        self.failure: OSError | None = None

    def write(self, data: Any) -> int:
        rest = memoryview(data).cast("B")
        size = len(rest)
        try:
            while rest:
                rest = rest[super().write(rest) :]
        except OSError as error:
            self.failure = self.failure or error
        return size

    def truncate(self, size: int | None = None) -> int:
        try:
            return super().truncate(size)
        except OSError as error:
            self.failure = self.failure or error
            return size or 0

    def check(self) -> None:
        """Raise what has failed so far."""
        if self.failure:
            raise self.failure


@contextmanager
def new_file(path: PathLike) -> Iterator[Disk]:
    """A new file at `path`, in a folder that is made; removed again where it cannot be written.

    Raises
    ------
    InvalidFile
        Where the file cannot be written.
    """
    target = Path(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        disk = Disk(target)
    except OSError as error:
        raise _unwritable(path, error) from None
    try:
        with disk:
            yield disk
        disk.check()
    except Exception:  # whatever HDF5 makes of a file that lacks what was not written
        if disk.failure is None:
            raise
        target.unlink()
        raise _unwritable(path, disk.failure) from None


def _unwritable(path: PathLike, error: OSError) -> InvalidFile:
    reason = error.strerror or error
    return InvalidFile(f"{path}: cannot be written ({reason}); name another file")
