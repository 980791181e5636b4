"""A file on disk for HDF5 that reports failed writes in Python.

If HDF5 cannot write a file, for example on a full disk, it prints errors while objects are destroyed and
crashes when the process ends. Here HDF5 never sees the failure; `check` raises it.
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
    """A new unbuffered file that stores its first write error."""

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
        """Raise the stored error, if any."""
        if self.failure:
            raise self.failure


@contextmanager
def new_file(path: PathLike) -> Iterator[Disk]:
    """Open a new file at `path`, whose folder is created; remove the file if it cannot be written.

    Raises
    ------
    InvalidFile
        If the file cannot be written.
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
    except Exception:  # HDF5 can fail in any way on an incomplete file
        if disk.failure is None:
            raise
        target.unlink()
        raise _unwritable(path, disk.failure) from None


def _unwritable(path: PathLike, error: OSError) -> InvalidFile:
    reason = error.strerror or error
    return InvalidFile(f"{path}: cannot be written ({reason}); name another file")
