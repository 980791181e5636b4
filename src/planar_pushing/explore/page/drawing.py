"""What is drawn of a state, made in a worker's thread, and sent as fast as the page takes it."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, NamedTuple

from planar_pushing.explore.handles import Handle
from planar_pushing.explore.page.view import View
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.pictures import curve, scene
from planar_pushing.explore.state import State
from planar_pushing.explore.words import outcome

#: Pictures that may be on their way: while the page takes one, the next one is made.
AHEAD = 2
#: Seconds after which a page that did not say that it took a picture is sent the next one all the same.
PATIENCE = 0.25
#: Seconds that the page's loop waits for a picture: longer than nearly all take.
SOON = 0.02
#: Seconds after which a picture takes long.
LONG = 0.4


class Order(NamedTuple):
    """A picture that is wanted: of a state, with a handle selected, after a number of moves."""

    state: State
    selected: Handle
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


class Painter:
    """Has pictures made, and sends them as fast as the page takes them."""

    def __init__(self, document: Any, view: View, show: Callable[[Order, Any], None]) -> None:
        self.view = view
        self.worker = Worker(document, pictures, show, lambda: self.has_room, SOON)
        self.sent = self.taken = 0
        self.sent_at = self.asked_at = 0.0

    @property
    def has_room(self) -> bool:
        """Whether the page keeps up with what is sent, or takes too long to say so."""
        return self.sent - self.taken < AHEAD or time.monotonic() - self.sent_at > PATIENCE

    @property
    def idle(self) -> bool:
        """Whether a new order would be followed at once."""
        return not self.worker.busy and self.has_room

    @property
    def waits(self) -> bool:
        """Whether a picture takes long, as it does while its code is compiled."""
        return self.worker.busy and time.monotonic() - self.asked_at > LONG

    def ask(self, order: Order) -> None:
        """Order a picture."""
        self.asked_at = time.monotonic()
        self.worker.ask(order)

    def send(self, state: State, moves: int) -> None:
        """Send what the view shows of a state, which answers a number of moves."""
        self.sent, self.sent_at = self.sent + 1, time.monotonic()
        self.view.send(state, self.sent, moves)

    def took(self, number: int) -> None:
        """The page has taken a picture."""
        self.taken = max(self.taken, number)
        self.worker.go_on()

    def start_again(self) -> None:
        """A page that is new has nothing to take."""
        self.taken = self.sent

    def close(self) -> None:
        """End the thread."""
        self.worker.close()
