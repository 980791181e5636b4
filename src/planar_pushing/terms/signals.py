"""SIGTERM, by which batch systems and `kill` end a process, ends a command as Ctrl-C does."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class Termination(KeyboardInterrupt):
    """The process was sent SIGTERM."""


@contextmanager
def termination_as_interrupt() -> Iterator[None]:
    """Raise `Termination` at SIGTERM within the block, so that files are closed and locks released.

    A SIGTERM that is ignored, or that another function handles, is left alone.
    """
    is_main = threading.current_thread() is threading.main_thread()  # only it receives signals
    if not is_main or signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL:
        yield
        return
    signal.signal(signal.SIGTERM, _terminate)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _terminate(*arguments: Any) -> None:
    raise Termination
