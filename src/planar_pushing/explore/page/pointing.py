"""What pointers and keys do: one handle at a time is held, and follows the pointer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from planar_pushing.explore import handles
from planar_pushing.explore.handles import Handle
from planar_pushing.explore.state import State
from planar_pushing.mechanics.plane import Array


class Pointed(Protocol):
    """What pointers and keys change."""

    @property
    def state(self) -> State:
        """The state that is shown."""

    @property
    def force(self) -> Array | None:
        """The force that is drawn."""

    @property
    def has_room(self) -> bool:
        """Whether a change would be drawn at once."""

    def change(self, make: Callable[[State], State]) -> None:
        """Change the state."""

    def select(self, handle: Handle) -> None:
        """Mark a handle as the one that the keys move."""


class Pointing:
    """The handle that is held, where it was moved to last, and the one that the keys move."""

    def __init__(self, on: Pointed) -> None:
        self.on = on
        self.selected = Handle.PUSHER
        self.held: Handle | None = None
        self.place: Any = None
        self.moves = 0

    def grab(self, place: Array) -> None:
        """Take the handle under a place of the picture."""
        if self.on.state.time is None:
            self._hold(handles.nearest(self.on.state, self.on.force, place))

    def aim(self, place: Array) -> None:
        """Take the line of force on the limit curve, and draw it to a place."""
        self._hold(Handle.LINE)
        self.drag(place)

    def drag(self, place: Array) -> None:
        """Note a move; it is followed as soon as there is room for its picture."""
        self.moves += 1
        self.place = place
        self.follow()

    def follow(self) -> None:
        """Follow the last move, if there is room for its picture."""
        if self.on.has_room:
            self._move()

    def drop(self) -> None:
        """Follow the last move, whether there is room or not, and let the handle go."""
        self._move()
        self.held = None

    def key(self, right: int, up: int, coarse: bool) -> None:
        """Move the handle that is selected by a step."""
        chosen, force = self.selected, self.on.force
        if self.on.state.time is None:
            self.on.change(lambda state: handles.nudged(state, chosen, force, right, up, coarse))

    def select(self, handle: Handle) -> None:
        """Let the keys move a handle."""
        self.selected = handle
        self.on.select(handle)

    def _hold(self, handle: Handle | None) -> None:
        if handle is not None and handle != self.held:
            self.select(handle)
        self.held = handle

    def _move(self) -> None:
        place, held, self.place = self.place, self.held, None
        if place is not None and held is not None and self.on.state.time is None:
            self.on.change(lambda state: handles.dragged(state, held, place))
