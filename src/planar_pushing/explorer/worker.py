"""Computation in a separate thread that always takes the newest request."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import partial
from typing import Any

#: Seconds that the page's loop waits for a result; nearly all pictures are ready by then.
SOON = 0.02


class Worker:
    """Runs a function on the newest request and drops earlier requests that are waiting.

    `show` receives the request and the result, or the exception, in the page's loop.
    """

    def __init__(
        self, document: Any, compute: Callable[[Any], Any], show: Callable[[Any, Any], None]
    ) -> None:
        self.document, self.compute, self.show = document, compute, show
        self.pool = ThreadPoolExecutor(1)
        self.wanted: list[Any] = []
        self.since: float | None = None

    def ask(self, order: Any) -> None:
        """Request a result."""
        self.wanted = [order]
        self._go_on()

    @property
    def seconds(self) -> float:
        """Seconds since the current request began; 0 without one."""
        return 0.0 if self.since is None else time.monotonic() - self.since

    def _go_on(self) -> None:
        if self.since is None and self.wanted:
            order, self.since = self.wanted.pop(), time.monotonic()
            future = self.pool.submit(self.compute, order)
            if wait([future], SOON).done:
                self._finish(order, future)
            else:
                future.add_done_callback(partial(self._pass_on, order))

    def _pass_on(self, order: Any, future: Future[Any]) -> None:
        """Pass a result from the thread to the page's loop."""
        if not future.cancelled():
            self.document.add_next_tick_callback(partial(self._finish, order, future))

    def _finish(self, order: Any, future: Future[Any]) -> None:
        self.since = None
        self.show(order, future.exception() or future.result())
        self._go_on()

    def close(self) -> None:
        """Accept no more requests."""
        self.wanted = []
        self.pool.shutdown(wait=False, cancel_futures=True)
