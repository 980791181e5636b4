"""Defer Ctrl-C and the collection of garbage while a file is written."""

from __future__ import annotations

import gc
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


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
def undisturbed() -> Iterator[None]:
    """Defer Ctrl-C and the collection of garbage until after the block.

    HDF5 crashes if the Python file that it writes raises, and if objects of HDF5 are destroyed while that
    file is called, which the collection of garbage can do at any time.
    """
    with PAUSE, _uninterrupted():
        yield


@contextmanager
def _uninterrupted() -> Iterator[None]:
    if threading.current_thread() is not threading.main_thread():  # only it receives signals
        yield
        return
    held: list[Any] = []
    before = signal.signal(signal.SIGINT, lambda *given: held.append(given))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.default_int_handler)
        if held and callable(before):
            before(*held[0])
