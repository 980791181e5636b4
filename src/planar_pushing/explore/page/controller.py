"""What joins the page to the state: events make new states, and every new state makes new pictures."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

from pydantic import ValidationError

from planar_pushing.explore import handles
from planar_pushing.explore.page.drawing import Order, pictures
from planar_pushing.explore.page.resting import Rest
from planar_pushing.explore.page.view import View
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.pictures import modes, scene
from planar_pushing.explore.state import State
from planar_pushing.terms.errors import PlanarPushingError

LOG = logging.getLogger("planar_pushing")
#: Seconds after which a page that did not say that it drew is sent the next picture all the same.
PATIENCE = 0.25
#: Looks at the page, ten a second, from one move of the map's cross to the next: the map is slow to paint.
CROSS = 3
#: Seconds after which the page says that something takes long.
LONG = 0.4


class Controller:
    """Holds the state of one page."""

    def __init__(self, document: Any, view: View, state: State) -> None:
        self.document, self.view, self.state = document, view, state
        self.selected = handles.Handle.PUSHER
        self.dragged: handles.Handle | None = None
        self.force: Any = None
        self.place: Any = None
        self.moves = self.sent = self.drawn = 0
        self.sent_at = self.asked_at = 0.0
        self.quiet = False
        self.watched = 0
        self.listeners: list[Callable[[State], None]] = []
        self.worker = Worker(document, pictures, self._show, lambda: self.drawn_all)
        self.rest = Rest(document, view, lambda: self.state, self._came_to_rest)
        self._listen()

    def start(self) -> None:
        """Show the first state."""
        self.document.add_periodic_callback(self._watch, 100)
        self.put(self.state)
        self.fit()

    def _begin(self) -> None:
        """Draw for a page that is new, or loaded again."""
        self.drawn = self.sent
        for listener in self.listeners:
            listener(self.state)
        self.redraw()
        self.rest.later()

    # -- states ------------------------------------------------------------------------------

    def put(self, state: State) -> None:
        """Show another state."""
        self.state = state
        self._show_widgets()
        for listener in self.listeners:
            listener(state)
        self.redraw()
        self.rest.later()

    def redraw(self) -> None:
        """Order the pictures of the state."""
        self.asked_at = time.monotonic()
        if self.state.time is None:
            self.worker.ask(Order(self.state, self.selected, self.moves))

    def move(self, state: State) -> None:
        """Take a state that differs in its time alone, which needs no pictures of the push."""
        self.state = state
        self.rest.later()

    def change(self, make: Callable[[State], State]) -> None:
        """Put the state that a change makes; one that is not allowed is said."""
        try:
            state = make(self.state)
            _ = state.scene
        except (PlanarPushingError, ValidationError) as error:
            self.view.say(_short(error))
            self._show_widgets()
            return
        self.view.say("")
        if state != self.state:
            self.put(state)

    def _show_widgets(self) -> None:
        self.quiet = True
        try:
            self.view.read(self.state)
        finally:
            self.quiet = False

    # -- events ------------------------------------------------------------------------------

    def _listen(self) -> None:
        for control in self.view.controls.values():
            control.widget.on_change(control.holds, partial(self._widget, control))
        self.view.on_drag(self._grab, self._drag, self._drop)
        self.view.on_curve(self._aim, self._drop)
        self.view.on_map(self._go)
        self.view.on_keys(self._key)
        self.view.on_drawn(self._drew)
        self.view.on_ready(self.document, self._begin)
        self.view.on_choice(self._choose_handle, self._choose_solution)

    def _widget(self, control: Any, name: str, old: Any, new: Any) -> None:
        if not self.quiet and new is not None and new != control.read(self.state):
            self.change(lambda state: control.write(state, new))

    def _grab(self, place: Any) -> None:
        if self.state.time is None:
            self.dragged = handles.nearest(self.state, self.force, place)
            if self.dragged is not None:
                self._select(self.dragged)

    def _aim(self, place: Any) -> None:
        """Hold the line of force on the limit curve."""
        if self.dragged != handles.Handle.LINE:
            self.dragged = handles.Handle.LINE
            self._select(self.dragged)
        self._drag(place)

    def _drag(self, place: Any) -> None:
        """Note a move; it is followed as soon as the picture before it is drawn."""
        self.moves += 1
        self.place = place
        self._follow()

    def _follow(self) -> None:
        """Follow the last move, if there is room for its picture."""
        if self.place is None or self.worker.busy or not self.drawn_all:
            return
        place, held, self.place = self.place, self.dragged, None
        if held is not None and self.state.time is None:
            self.change(lambda state: handles.dragged(state, held, place))

    def _drop(self) -> None:
        """Follow the last move, whether there is room or not."""
        place, held, self.place, self.dragged = self.place, self.dragged, None, None
        if place is not None and held is not None and self.state.time is None:
            self.change(lambda state: handles.dragged(state, held, place))
        self.rest.later()

    def _go(self, angle: float, along: float) -> None:
        self.change(lambda state: modes.gone(state, angle, along))

    def _key(self, right: int, up: int, coarse: bool) -> None:
        if self.state.time is None:
            self.change(
                lambda state: handles.nudged(state, self.selected, self.force, right, up, coarse)
            )

    def _choose_handle(self, index: int) -> None:
        if not self.quiet:
            self._select(list(handles.Handle)[index])
            self.redraw()

    def _select(self, handle: handles.Handle) -> None:
        self.selected = handle
        self.quiet = True
        self.view.select(list(handles.Handle).index(handle))
        self.quiet = False

    def _choose_solution(self, name: str) -> None:
        if not self.quiet:
            self.change(lambda state: replace(state, shown=name))

    # -- pictures ----------------------------------------------------------------------------

    @property
    def drawn_all(self) -> bool:
        """Whether the page drew what was sent, or takes too long to say so."""
        return self.drawn >= self.sent or time.monotonic() - self.sent_at > PATIENCE

    def _drew(self, number: int) -> None:
        self.drawn = max(self.drawn, number)
        self.worker.go_on()
        self._follow()

    def _show(self, order: Order, found: Any) -> None:
        if isinstance(found, BaseException):
            self.view.say(_short(found))
            LOG.debug("no picture", exc_info=found)
            return
        if self.state.time is not None:
            return
        self.force = found.found.force
        self.sent, self.sent_at = self.sent + 1, time.monotonic()
        self.quiet = True
        self.view.draw(found, self.sent, order.moves)
        self.quiet = False

    def send(self, columns: dict[str, Any], texts: dict[str, str]) -> None:
        """Send a picture that is none of the push."""
        self.sent, self.sent_at = self.sent + 1, time.monotonic()
        self.view.send(columns, texts, self.sent, self.moves)

    def _watch(self) -> None:
        """Go on where a page is slow to answer, and say what takes long."""
        self.worker.go_on()
        self._follow()
        self.watched += 1
        if self.watched % CROSS == 0:
            self.view.mark(self.state)
        waits = self.worker.busy and time.monotonic() - self.asked_at > LONG
        self.view.wait(waits or self.rest.waits)

    def _came_to_rest(self) -> None:
        """Fit the frame, unless it would move under the pointer."""
        if self.dragged is None:
            self.fit()

    def fit(self) -> None:
        """Fit the frame to the slider."""
        if self.state.time is None:
            self.view.scene.fit(scene.bounds(self.state))

    def close(self) -> None:
        """End the threads of a page that is gone."""
        self.worker.close()
        self.rest.close()


def _short(error: BaseException) -> str:
    """A message in one line."""
    if isinstance(error, ValidationError):
        first = error.errors()[0]
        key = ".".join(map(str, first["loc"]))
        return f"{key}: allowed: {first.get('ctx', {}).get('allowed', first['msg'])}"
    return " ".join(str(error).split())
