"""A file on disk for HDF5 that reports failed writes in Python.

If HDF5 cannot write a file, for example on a full disk, it prints errors while objects are destroyed and
crashes when the process ends. Here HDF5 never sees the failure; `check` raises it. Until then HDF5 also
reads back what it has written, and crashes if it reads anything else. Memory therefore holds the data that
the disk does not. It also crashes if that file is interrupted, so Ctrl-C and SIGTERM are deferred.
"""

from __future__ import annotations

import gc
import io
import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from planar_pushing.terms.locks import PathLike, regular_file, sole_writer, unwritable
from planar_pushing.terms.signals import interrupt_handlers


class Disk(io.FileIO):
    """An empty unbuffered file that stores its first write error, and from then on all data in memory."""

    def __init__(self, path: PathLike) -> None:
        super().__init__(path, "w+", opener=_open)
        self.failure: OSError | None = None
        #: Places and data of the writes since the failure.
        self.unwritten: list[tuple[int, bytes]] = []

    def write(self, data: Any) -> int:
        rest = memoryview(data).cast("B")
        size = len(rest)
        try:
            while rest and not self.failure:
                rest = rest[super().write(rest) :]
        except OSError as error:
            self.failure = error
        if rest:
            self.unwritten.append((self.tell(), bytes(rest)))
            self.seek(len(rest), io.SEEK_CUR)
        return size

    def readinto(self, buffer: Any) -> int:
        """Read what was written, whether it is on the disk or not; bytes beyond the end are zero."""
        position, view = self.tell(), memoryview(buffer).cast("B")
        count = super().readinto(view) or 0
        view[count:] = bytes(len(view) - count)
        for start, data in self.unwritten:
            low, high = max(start, position), min(start + len(data), position + len(view))
            if low < high:
                view[low - position : high - position] = data[low - start : high - start]
        self.seek(position + len(view))
        return len(view)

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
    """Open an empty file at `path`, whose folder is created; remove the file if it cannot be written.

    The file is written in place, so that others can read it in the meantime. If `path` is a link, its
    target is written.

    Raises
    ------
    InvalidFile
        If the file cannot be written or is not a regular one, or another process or thread is writing it.
    """
    target = regular_file(path)
    with sole_writer(target, path):
        try:
            disk = Disk(target)
        except OSError as error:
            raise unwritable(path, error) from None
        try:
            with disk:
                yield disk
            disk.check()
        except Exception:  # HDF5 can fail in any way on an incomplete file
            if disk.failure is None:
                raise
            target.unlink()
            raise unwritable(path, disk.failure) from None


def _open(path: str, flags: int) -> int:
    """Open a file, unless it has been replaced by a link since the links were resolved."""
    return os.open(path, flags | os.O_NOFOLLOW, 0o666)


class Pause:
    """Pause of the collection of garbage, which ends with the last of the blocks that asked for it."""

    def __init__(self) -> None:
        self.lock, self.blocks, self.enabled = threading.Lock(), 0, True

    def __enter__(self) -> None:
        with self.lock:
            if not self.blocks:
                self.enabled = gc.isenabled()
                gc.disable()
            self.blocks += 1

    def __exit__(self, *raised: object) -> None:
        with self.lock:
            self.blocks -= 1
            if not self.blocks and self.enabled:
                gc.enable()


PAUSE = Pause()


@contextmanager
def block_interrupts() -> Iterator[None]:
    """Defer Ctrl-C, SIGTERM and the collection of garbage until after the block.

    HDF5 crashes if the Python file that it writes raises, and if objects of HDF5 are destroyed while that
    file is called, which the collection of garbage can do at any time.
    """
    with _hold_interrupts(), PAUSE:
        yield


@contextmanager
def _hold_interrupts() -> Iterator[None]:
    """Hold back the signals that call a function in Python, which could raise."""
    held, handlers = list[Any](), interrupt_handlers()
    for number in handlers:
        signal.signal(number, lambda *arguments: held.append(arguments))
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        if held:
            first, frame = held[0]
            handlers[first](first, frame)
