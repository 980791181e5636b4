"""Ctrl-C, held back while a file is written."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def undisturbed() -> Iterator[None]:
    """Let Ctrl-C come after the block: HDF5 crashes where the Python file that it writes raises."""
    if threading.current_thread() is not threading.main_thread():  # which alone hears signals
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
