"""SIGTERM, by which batch systems and `kill` end a process, ends a command as Ctrl-C does."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
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


def interrupt_handlers() -> dict[signal.Signals, Callable[[int, FrameType | None], Any]]:
    """Functions that Ctrl-C and SIGTERM call, which can raise; none outside of the main thread."""
    if threading.current_thread() is not threading.main_thread():  # only it receives signals
        return {}
    handlers = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    return {number: handler for number, handler in handlers.items() if callable(handler)}


@contextmanager
def interrupts_raise_after(stop: Callable[[], object]) -> Iterator[None]:
    """Raise what Ctrl-C or SIGTERM raises only after the block, and call a function at once, to end it.

    While threads are started or waited for, an exception at any moment could leave a lock of theirs locked
    for ever. A handler that raises nothing changes nothing. A second exception is raised at once.
    """
    handlers, raised = interrupt_handlers(), list[BaseException]()

    def hear(number: int, frame: FrameType | None) -> None:
        try:
            handlers[signal.Signals(number)](number, frame)
        except BaseException as error:
            if raised:
                raise
            raised.append(error)
            stop()

    for number in handlers:
        signal.signal(number, hear)
    try:
        yield
    finally:
        for number in reversed(handlers):
            signal.signal(number, handlers[number])
        if raised:
            raise raised[0]


def _terminate(*arguments: Any) -> None:
    raise Termination
