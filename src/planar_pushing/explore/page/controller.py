"""What joins the page to the state: events make new states, and every new state makes new pictures."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

from pydantic import ValidationError

from planar_pushing.explore import handles
from planar_pushing.explore.address import query
from planar_pushing.explore.page.view import View
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.pictures import curve, modes, scene
from planar_pushing.explore.python_lines import lines
from planar_pushing.explore.state import State
from planar_pushing.explore.words import outcome
from planar_pushing.terms.errors import PlanarPushingError

LOG = logging.getLogger("planar_pushing")
#: Milliseconds without a change after which the map, the address and the frame follow.
REST = 200
#: Seconds after which a page that did not say that it drew is sent the next picture all the same.
PATIENCE = 0.25
#: Looks at the page, ten a second, from one move of the map's cross to the next: the map is slow to paint.
CROSS = 3
#: Seconds after which the page says that something takes long.
LONG = 0.4


class Order(NamedTuple):
    """A picture that is wanted: of a state, with a handle selected, after a number of moves."""

    state: State
    selected: handles.Handle
    moves: int


class Pictures(NamedTuple):
    """What a state looks like."""

    found: scene.Found
    scene: dict[str, Any]
    curve: dict[str, Any]
    words: str


def pictures(order: Order) -> Pictures:
    """Solve, and make the columns of both pictures."""
    state = order.state
    found = scene.found(state)
    columns = scene.picture(state, found, order.selected)
    words = outcome(tuple(found.solutions), found.pusher, found.shown)
    return Pictures(found, columns, curve.picture(state, found), words)


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
        self.resting: Any = None
        self.watched = 0
        self.listeners: list[Callable[[State], None]] = []
        self.worker = Worker(document, pictures, self._show, lambda: self.drawn_all)
        self.mapper = Worker(document, self._map, self._keep_map)
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
        self._rest_later()

    # -- states ------------------------------------------------------------------------------

    def put(self, state: State) -> None:
        """Show another state."""
        self.state = state
        self._show_widgets()
        for listener in self.listeners:
            listener(state)
        self.redraw()
        self._rest_later()

    def redraw(self) -> None:
        """Order the pictures of the state."""
        self.asked_at = time.monotonic()
        if self.state.time is None:
            self.worker.ask(Order(self.state, self.selected, self.moves))

    def move(self, state: State) -> None:
        """Take a state that differs in its time alone, which needs no pictures of the push."""
        self.state = state
        self._rest_later()

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
        self._rest_later()

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
        self.view.wait(waits or self.mapper_waits())

    def mapper_waits(self) -> bool:
        """Whether the map takes unusually long, as it does while its code is compiled."""
        return self.mapper.busy and time.monotonic() - self.mapped_at > 1.5

    # -- rest --------------------------------------------------------------------------------

    mapped_at = 0.0

    def _rest_later(self) -> None:
        if self.resting is not None:
            with suppress(ValueError):  # it has run
                self.document.remove_timeout_callback(self.resting)
        self.resting = self.document.add_timeout_callback(self._rest, REST)

    def _rest(self) -> None:
        """The map, the address, the lines of Python and the frame of a state that has come to rest."""
        self.resting = None
        self.view.mark(self.state)
        self.view.rest(query(self.state), lines(self.state))
        if self.state.time is None:
            self.mapped_at = time.monotonic()
            self.mapper.ask(self.state)
            if self.dragged is None:
                self.fit()

    def fit(self) -> None:
        """Fit the frame to the slider."""
        if self.state.time is None:
            self.view.scene.fit(scene.bounds(self.state))

    def _map(self, state: State) -> None:
        """In the mapper's thread: a coarse map first."""
        for each in modes.maps(state):
            self.document.add_next_tick_callback(partial(self._show_map, state, each))
            if self.mapper.wanted:
                return

    def _show_map(self, state: State, found: modes.Map) -> None:
        self.view.draw_map(state, found)

    def _keep_map(self, state: State, found: Any) -> None:
        if isinstance(found, BaseException):
            LOG.debug("no map", exc_info=found)

    def close(self) -> None:
        """End the threads of a page that is gone."""
        self.worker.close()
        self.mapper.close()


def _short(error: BaseException) -> str:
    """A message in one line."""
    if isinstance(error, ValidationError):
        first = error.errors()[0]
        key = ".".join(map(str, first["loc"]))
        return f"{key}: allowed: {first.get('ctx', {}).get('allowed', first['msg'])}"
    return " ".join(str(error).split())
