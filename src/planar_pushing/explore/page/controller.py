"""What joins the page to the state: events make new states, and every new state makes new pictures."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

from pydantic import ValidationError

from planar_pushing.explore.handles import Handle
from planar_pushing.explore.page.drawing import Order, Painter
from planar_pushing.explore.page.pointing import Pointing
from planar_pushing.explore.page.resting import Rest
from planar_pushing.explore.page.view import View
from planar_pushing.explore.pictures import modes, scene
from planar_pushing.explore.state import State
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import PlanarPushingError

LOG = logging.getLogger("planar_pushing")
#: Milliseconds between looks at the page.
LOOK = 100


class Controller:
    """Holds the state of one page."""

    def __init__(self, document: Any, view: View, state: State) -> None:
        self.document, self.view, self.state = document, view, state
        self.found: scene.Found | None = None
        self.quiet = self.stale = False
        self.listeners: list[Callable[[State], None]] = []
        self.pointing = Pointing(self)
        self.painter = Painter(document, view, self._show)
        self.rest = Rest(document, view, lambda: self.state, self._came_to_rest, self._draw_map)
        self._listen()

    def start(self) -> None:
        """Show the first state."""
        self.document.add_periodic_callback(self._look, LOOK)
        self.put(self.state)
        self.fit()

    def _begin(self) -> None:
        """Draw for a page that is new, or loaded again."""
        self.painter.start_again()
        self.put(self.state)

    # -- states ------------------------------------------------------------------------------

    def put(self, state: State) -> None:
        """Show another state; while a handle moves the widgets wait, which are slow to paint."""
        self.state, self.stale = state, True
        if self.pointing.held is None:
            self.show_widgets()
        for listener in self.listeners:
            listener(state)
        self.redraw()
        self.rest.later()

    def redraw(self) -> None:
        """Order the pictures of the state."""
        if self.state.time is None:
            self.painter.ask(Order(self.state, self.pointing.selected, self.pointing.moves))

    def move(self, state: State) -> None:
        """Take a state that differs in its time alone, which needs no pictures of the push."""
        self.state = state
        self.rest.later()

    def change(self, make: Callable[[State], State]) -> None:
        """Show the state that a change makes, or say why it is not allowed."""
        try:
            state = make(self.state)
            _ = state.scene
        except (PlanarPushingError, ValidationError) as error:
            self.view.say(_short(error))
            self.show_widgets()
            return
        self.view.say("")
        if state != self.state:
            self.put(state)

    def guarded(self, show: Callable[[], None]) -> None:
        """Change widgets without taking that for the user's doing."""
        self.quiet = True
        try:
            show()
        finally:
            self.quiet = False

    def show_widgets(self) -> None:
        """Let the widgets follow the state."""
        self.stale = False
        self.guarded(lambda: self.view.read(self.state, self.found))

    # -- events ------------------------------------------------------------------------------

    def _listen(self) -> None:
        for control in self.view.controls.values():
            control.widget.on_change(control.holds, partial(self._widget, control))
        self.view.on_drag(self.pointing.grab, self.pointing.drag, self.pointing.drop)
        self.view.on_curve(self.pointing.aim, self.pointing.drop)
        self.view.on_map(lambda angle, along: self.change(lambda s: modes.gone(s, angle, along)))
        self.view.on_keys(self.pointing.key)
        self.view.on_taken(self._taken)
        self.view.on_sizes(self.resend)
        self.view.on_ready(self.document, self._begin)
        self.view.on_choice(self._choose_handle, self._choose_solution)

    def _widget(self, control: Any, name: str, old: Any, new: Any) -> None:
        if not self.quiet and new is not None and new != control.read(self.state):
            self.change(lambda state: control.write(state, new))

    def _choose_handle(self, index: int) -> None:
        if not self.quiet:
            self.pointing.select(list(Handle)[index])
            self.redraw()

    def _choose_solution(self, name: str) -> None:
        if not self.quiet:
            self.change(lambda state: replace(state, shown=name))

    def select(self, handle: Handle) -> None:
        """Mark a handle as the one that the keys move."""
        self.guarded(lambda: self.view.select(list(Handle).index(handle)))

    # -- pictures ----------------------------------------------------------------------------

    @property
    def force(self) -> Array | None:
        """The force that is drawn."""
        return None if self.found is None else self.found.force

    @property
    def has_room(self) -> bool:
        """Whether a change would be drawn at once."""
        return self.painter.idle

    def _taken(self, number: int) -> None:
        self.painter.took(number)
        self.pointing.follow()

    def _show(self, order: Order, found: Any) -> None:
        if isinstance(found, BaseException):
            self.view.say(_short(found))
            LOG.debug("no picture", exc_info=found)
        elif self.state.time is None:
            self.found = found.found
            self.view.draw(found)
            self.painter.send(order.state, order.moves)
            self.stale = True
            self.pointing.follow()

    def send(self, columns: dict[str, Any], texts: dict[str, str]) -> None:
        """Show a picture of something else than the push."""
        self.view.show(columns, texts)
        self.resend()

    def resend(self) -> None:
        """Send what is shown, in its size of now."""
        self.painter.send(self.state, self.pointing.moves)

    def _draw_map(self, state: State, found: modes.Map) -> None:
        self.view.draw_map(state, found)
        self.resend()

    def _look(self) -> None:
        """Go on where a page is slow to answer, and show what may be late."""
        self.painter.worker.go_on()
        self.pointing.follow()
        if self.stale and self.rest.over:
            self.show_widgets()
        self.view.wait(self.painter.waits or self.rest.waits)

    def _came_to_rest(self) -> None:
        """Show all of the state; fit the frame, unless it would move under the pointer."""
        self.show_widgets()
        if self.pointing.held is None:
            self.fit()

    def fit(self) -> None:
        """Fit the frame to the slider."""
        if self.state.time is None:
            self.frame(scene.bounds(self.state))

    def frame(self, corners: Array) -> None:
        """Show a box of the plane."""
        if self.view.scene.fit(corners):
            self.resend()

    def close(self) -> None:
        """End the threads of a page that was closed."""
        self.painter.close()
        self.rest.close()


def _short(error: BaseException) -> str:
    """A message in one line."""
    if isinstance(error, ValidationError):
        first = error.errors()[0]
        key = ".".join(map(str, first["loc"]))
        return f"{key}: allowed: {first.get('ctx', {}).get('allowed', first['msg'])}"
    return " ".join(str(error).split())
