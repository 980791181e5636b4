"""Pointers and keys on the pictures; one handle at a time is held and follows the pointer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from planar_pushing.explorer.pictures import curve, handles, maps
from planar_pushing.explorer.pictures.layout import Held, nearest_spot, place_handles
from planar_pushing.explorer.pictures.pictures import LONG, TIME_BOX
from planar_pushing.explorer.state import Handle, State
from planar_pushing.explorer.view import sheet_of
from planar_pushing.mechanics.plane import Array

#: Boxes of the pictures with the same box for all states.
BOXES = {"curve": curve.BOX, "map": maps.BOX, "time": TIME_BOX}


class Pointing:
    """Converts events on the pictures into changes of the page's state.

    `held` is the picture of a drag, `grabbed` the state in which it began, and `grip` its handle.
    """

    def __init__(self, page: Any) -> None:
        self.page = page
        self.held = ""
        self.grabbed: State | None = None
        self.grip: Held | None = None

    def hear(self, event: dict[str, Any]) -> None:
        """Handle an event: grab, drag, drop or cancel at a position in a picture, or an arrow key."""
        if self.page.state.several is not None:
            return
        if event["kind"] == "key":
            right, up = event["way"]
            self._key(right, up, event["coarse"])
        else:
            pixel = np.array([event["x"], event["y"]], dtype=float)
            EVENTS[event["kind"]](self, event["picture"], pixel)

    def _position(self, picture: str, pixel: Array) -> Array:
        """Position of a pointer in its picture."""
        box = BOXES.get(picture, self.page.box)
        return sheet_of(self.page.sizes[picture], box).to_scene(pixel)

    def _key(self, right: int, up: int, coarse: bool) -> None:
        if self.page.state.time is None:
            force = self.page.force
            self.page.change(
                lambda state: handles.nudge_handle(state, force, right, up, coarse), source="key"
            )

    def _grab(self, picture: str, pixel: Array) -> None:
        """Grab the handle at a position; on the limit curve this is the line of force.

        With a side on the fence there is neither a curve nor a map.
        """
        state = self.page.state
        if state.flush and picture in ("curve", "map"):
            return
        handle: Handle | None = Handle.LINE
        if picture == "scene":
            sheet = sheet_of(self.page.sizes[picture], self.page.box)
            spots = place_handles(handles.handle_positions(state, self.page.force), sheet)
            handle = nearest_spot(spots, pixel)
        if picture in ("map", "time"):
            self.held = picture
        elif handle is not None and state.time is None:
            self.held = picture
            self.grip = Held(handle, spots[handle].offset) if picture == "scene" else None
            self.page.change(lambda state: replace(state, handle=handle))
            self.grabbed = self.page.state
        if picture != "scene":
            self._drag(picture, pixel)

    def _drag(self, picture: str, pixel: Array) -> None:
        motion = self.page.view.motion
        if self.held in ("scene", "curve") and self.grabbed is not None:
            state = self.grabbed
            offset = (0.0, 0.0) if self.grip is None else self.grip.offset
            position = self._position(picture, pixel - offset)
            self.page.change(
                lambda _: handles.drag_handle(state, state.handle, position), source="drag"
            )
        elif self.held == "time" and motion is not None:
            end = float(motion.times[-1])
            time = float(np.clip(end * self._position(picture, pixel)[0] / LONG, 0.0, end))
            self.page.change(lambda state: replace(state, time=time))

    def _drop(self, picture: str, pixel: Array) -> None:
        if self.held == "map":
            position = self._position(picture, pixel)
            self.page.change(lambda state: maps.state_at(self.page.subject, position))
        self._drag(picture, pixel)
        self._cancel(picture, pixel)

    def _cancel(self, picture: str, pixel: Array) -> None:
        grip = self.grip
        self.held, self.grabbed, self.grip = "", None, None
        self.page.history.rest()
        if grip is not None and (grip.handle == Handle.CONTACT or any(grip.offset)):
            self.page.turn_upright()  # the object and the handle return to their own places


EVENTS: dict[str, Callable[[Pointing, str, Array], None]] = {
    "grab": Pointing._grab,
    "drag": Pointing._drag,
    "drop": Pointing._drop,
    "cancel": Pointing._cancel,
}
