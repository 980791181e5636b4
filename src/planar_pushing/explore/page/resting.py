"""What follows a state that has come to rest: the map, the address, the lines of Python."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import Any

from planar_pushing.explore.address import query
from planar_pushing.explore.page.view import View
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.pictures import modes
from planar_pushing.explore.python_lines import lines
from planar_pushing.explore.state import State

LOG = logging.getLogger("planar_pushing")
#: Milliseconds without a change that are rest, and seconds that are unusually long for a map.
REST, LONG = 200, 1.5


class Rest:
    """Waits for rest, and then orders what takes longer than a picture."""

    def __init__(
        self,
        document: Any,
        view: View,
        state: Callable[[], State],
        done: Callable[[], None],
        draw_map: Callable[[State, modes.Map], None],
    ) -> None:
        self.document, self.view, self.state = document, view, state
        self.done, self.draw_map = done, draw_map
        self.mapper = Worker(document, self._map, self._failed)
        self.waiting: Any = None
        self.asked_at = 0.0

    def later(self) -> None:
        """Wait again: something has changed."""
        if self.waiting is not None:
            with suppress(ValueError):  # it has run
                self.document.remove_timeout_callback(self.waiting)
        self.waiting = self.document.add_timeout_callback(self._rest, REST)

    @property
    def over(self) -> bool:
        """Whether nothing has changed for a while."""
        return self.waiting is None

    @property
    def waits(self) -> bool:
        """Whether the map takes unusually long, as it does while its code is compiled."""
        return self.mapper.busy and time.monotonic() - self.asked_at > LONG

    def _rest(self) -> None:
        self.waiting, state = None, self.state()
        self.view.rest(query(state), lines(state))
        self.done()
        if state.time is None:
            self.asked_at = time.monotonic()
            self.mapper.ask(state)

    def _map(self, state: State) -> None:
        """In the mapper's thread: a coarse map first."""
        for each in modes.maps(state):
            self.document.add_next_tick_callback(partial(self.draw_map, state, each))
            if self.mapper.wanted:
                return

    def _failed(self, state: State, found: Any) -> None:
        if isinstance(found, BaseException):
            LOG.debug("no map", exc_info=found)

    def close(self) -> None:
        """End the thread."""
        self.waiting = None
        self.mapper.close()
