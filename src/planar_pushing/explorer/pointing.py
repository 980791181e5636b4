"""Pointers and keys on the pictures; one handle at a time is held and follows the pointer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from planar_pushing.explorer.pictures import curve, handles, maps
from planar_pushing.explorer.pictures.pictures import LONG, TIME_BOX
from planar_pushing.explorer.state import Handle
from planar_pushing.explorer.view import sheet_of
from planar_pushing.mechanics.plane import Array

#: Boxes of the pictures with the same box for all states.
BOXES = {"curve": curve.BOX, "map": maps.BOX, "time": TIME_BOX}


class Pointing:
    """Converts events on the pictures into changes of the page's state; `held` is the picture of a drag."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.held = ""

    def hear(self, event: dict[str, Any]) -> None:
        """Handle an event: grab, drag, drop or cancel at a position in a picture, or an arrow key."""
        if self.page.state.several is not None:
            return
        if event["kind"] == "key":
            right, up = event["way"]
            self._key(right, up, event["coarse"])
        else:
            EVENTS[event["kind"]](self, event["picture"], self._position(event))

    def _position(self, event: dict[str, Any]) -> Array:
        """Position of a pointer in its picture."""
        name = event["picture"]
        box = BOXES.get(name, self.page.box)
        return sheet_of(self.page.sizes[name], box).to_scene((event["x"], event["y"]))

    def _key(self, right: int, up: int, coarse: bool) -> None:
        if self.page.state.time is None:
            force = self.page.force
            self.page.change(lambda state: handles.nudge_handle(state, force, right, up, coarse))

    def _grab(self, picture: str, position: Array) -> None:
        """Grab the handle at a position; on the limit curve this is the line of force.

        With a side on the fence there is neither a curve nor a map.
        """
        if self.page.state.flush and picture in ("curve", "map"):
            return
        handle: Handle | None = Handle.LINE
        if picture == "scene":
            handle = handles.nearest(self.page.state, self.page.force, position)
        if picture in ("map", "time"):
            self.held = picture
        elif handle is not None and self.page.state.time is None:
            self.held = picture
            self.page.change(lambda state: replace(state, handle=handle))
        if picture != "scene":
            self._drag(picture, position)

    def _drag(self, picture: str, position: Array) -> None:
        motion = self.page.view.motion
        if self.held in ("scene", "curve"):
            self.page.change(lambda state: handles.drag_handle(state, state.handle, position))
        elif self.held == "time" and motion is not None:
            end = float(motion.times[-1])
            time = float(np.clip(end * position[0] / LONG, 0.0, end))
            self.page.change(lambda state: replace(state, time=time))

    def _drop(self, picture: str, position: Array) -> None:
        if self.held == "map":
            self.page.change(lambda state: maps.state_at(self.page.subject, position))
        self._drag(picture, position)
        self.held = ""

    def _cancel(self, picture: str, position: Array) -> None:
        self.held = ""


EVENTS: dict[str, Callable[[Pointing, str, Array], None]] = {
    "grab": Pointing._grab,
    "drag": Pointing._drag,
    "drop": Pointing._drop,
    "cancel": Pointing._cancel,
}
