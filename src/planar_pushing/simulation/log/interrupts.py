"""Defer Ctrl-C while a file is written."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def undisturbed() -> Iterator[None]:
    """Defer Ctrl-C until after the block, since HDF5 crashes if the Python file that it writes raises."""
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
