"""Computing beside the page: a thread that always takes the newest order, and keeps one at a time."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import partial
from typing import Any


class Worker:
    """Runs a function in a thread on the newest argument; those that came in between are dropped.

    `show` takes the argument and the result, or the exception, on the page's own loop. Nothing more is
    started until `ready` says that the page has room for it. The loop waits `soon` seconds for a result, so
    that one which is there by then is shown at once; it looks after other things where that takes longer.
    """

    def __init__(
        self,
        document: Any,
        compute: Callable[[Any], Any],
        show: Callable[[Any, Any], None],
        ready: Callable[[], bool] = lambda: True,
        soon: float = 0.0,
    ) -> None:
        self.document, self.compute, self.show, self.ready = document, compute, show, ready
        self.soon = soon
        self.pool = ThreadPoolExecutor(1)
        self.wanted: list[Any] = []
        self.busy = False

    def ask(self, argument: Any) -> None:
        """Order a result."""
        self.wanted = [argument]
        self.go_on()

    def go_on(self) -> None:
        """Start what is ordered, if nothing runs."""
        if self.busy or not self.wanted or not self.ready():
            return
        argument, self.busy = self.wanted.pop(), True
        future = self.pool.submit(self.compute, argument)
        if wait([future], self.soon).done:
            self._finish(argument, future)
        else:
            future.add_done_callback(partial(self._done, argument))

    def _done(self, argument: Any, future: Future[Any]) -> None:
        """In the worker's thread: hand the result to the page's loop."""
        if not future.cancelled():
            self.document.add_next_tick_callback(partial(self._finish, argument, future))

    def _finish(self, argument: Any, future: Future[Any]) -> None:
        self.busy = False
        self.show(argument, future.exception() or future.result())
        self.go_on()

    def close(self) -> None:
        """Take no more orders."""
        self.wanted = []
        self.pool.shutdown(wait=False, cancel_futures=True)
