"""The page's models in one place: it shows what it is told, and tells what was done to it."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from bokeh.events import Tap
from bokeh.models import (
    Button,
    Div,
    RadioButtonGroup,
    Select,
)

from planar_pushing.explore.handles import Handle
from planar_pushing.explore.page.canvas import Canvas, MapCanvas
from planar_pushing.explore.page.channels import Channels, Drag, on_pointer
from planar_pushing.explore.page.controls import controls
from planar_pushing.explore.page.tables import legend, solutions
from planar_pushing.explore.pictures.modes import AXES, Map
from planar_pushing.explore.pictures.scene import Found
from planar_pushing.explore.presets import presets
from planar_pushing.explore.state import State

#: Buttons that save a file, and the files.
SAVES = {
    "scene.yaml": "Scene (YAML)",
    "scene.svg": "Picture (SVG)",
    "log.nc": "Log (netCDF)",
    "scene.py": "Python",
}


class View:
    """Figures, widgets and texts of the page."""

    def __init__(self) -> None:
        self.scene, self.curve = Canvas("scene"), Canvas("curve")
        self.map = MapCanvas()
        self.controls = controls()
        self.status = Div(name="status", sizing_mode="stretch_width")
        self.legend = Div(name="legend", sizing_mode="stretch_width")
        self.python = Div(name="python", sizing_mode="stretch_width")
        self.preset = Select(
            name="preset", options=[("", "Start from \u2026"), *presets().items()], value="",
            width=120, sizing_mode="stretch_width",
        )  # fmt: skip
        self.handle = RadioButtonGroup(name="handle", labels=[_capital(each) for each in Handle])
        self.solution = RadioButtonGroup(name="solution", labels=["stick"])
        self.saves = {name: Button(name=name, label=word) for name, word in SAVES.items()}
        self.close = Button(name="close", label="Close", button_type="danger")
        self.modes: list[str] = []
        self.texts: dict[str, str] = {}
        self.known: dict[str, str] = {}
        self.said, self.rests = "", 0
        self.channels = Channels()
        # No glyph refers to the channels: the document finds them here.
        self.map.figure.tags = self.channels.all

    @property
    def roots(self) -> list[Any]:
        """Everything that the template places, by its name."""
        shown = [self.map.figure, self.status, self.legend, self.python]
        shown += [self.preset, self.handle, self.solution]
        shown += [each.widget for each in self.controls.values()]
        shown += [*self.saves.values(), self.close]
        return shown

    # -- what is told ------------------------------------------------------------------------

    def on_ready(self, document: Any, ready: Callable[[], None]) -> None:
        """The page is loaded, with nothing drawn."""

        def fresh(event: Any) -> None:
            self.known = {}
            ready()

        document.on_event("document_ready", fresh)
        document.js_on_event("document_ready", self.channels.script)

    def on_drag(self, grab: Drag, drag: Drag, drop: Callable[[], None]) -> None:
        """Drags on the picture, by mouse, pen or finger."""
        on_pointer(self.channels.pointers["scene"], self.scene, grab, drag, drop)

    def on_curve(self, aim: Drag, drop: Callable[[], None]) -> None:
        """Drags on the limit curve, which aim the force."""
        on_pointer(self.channels.pointers["curve"], self.curve, aim, aim, drop)

    def on_map(self, go: Callable[[float, float], None]) -> None:
        """Clicks on the map."""
        self.map.figure.on_event(Tap, lambda event: go(event.y, event.x))

    def on_keys(self, key: Callable[[int, int, bool], None]) -> None:
        """Arrow keys on the picture."""

        def pressed(name: str, old: Any, new: Any) -> None:
            if new["right"]:
                key(int(new["right"][0]), int(new["up"][0]), bool(new["coarse"][0]))

        self.channels.keys.on_change("data", pressed)

    def on_taken(self, took: Callable[[int], None]) -> None:
        """The number of the picture that the page has taken."""
        self.channels.taken.on_change("data", lambda name, old, new: took(int(new["number"][0])))

    def on_sizes(self, resized: Callable[[], None]) -> None:
        """The pictures have another size."""

        def heard(name: str, old: Any, new: Any) -> None:
            for canvas in (self.scene, self.curve):
                width, height = new[canvas.name]
                canvas.size = float(width), float(height)
            resized()

        self.channels.sizes.on_change("data", heard)

    def on_choice(self, handle: Callable[[int], None], solution: Callable[[str], None]) -> None:
        """The handle that the keys move, and the solution that is drawn in full."""
        self.handle.on_change("active", lambda name, old, new: handle(new))
        self.solution.on_change("active", lambda name, old, new: solution(self.modes[new]))

    # -- what is shown -----------------------------------------------------------------------

    def read(self, state: State, found: Found | None) -> None:
        """Let the widgets show a state, and its solutions."""
        for control in self.controls.values():
            wanted = control.options(state) | {control.holds: control.read(state)}
            fresh = {k: each for k, each in wanted.items() if getattr(control.widget, k) != each}
            if fresh:
                control.widget.update(**fresh)
        if found is not None and state.time is None:
            self._offer(found)

    def _offer(self, found: Found) -> None:
        """Offer each solution to be drawn in full."""
        self.modes = [each.mode.name for each in found.solutions]
        labels = [name.replace("_", " ").capitalize() for name in self.modes] or ["None"]
        self.solution.update(labels=labels, active=max(found.shown, 0), disabled=len(labels) < 2)

    def draw(self, found: Any) -> None:
        """Show the pictures of a push."""
        self.curve.columns = found.curve
        self.show(found.scene, {"words": found.words, "solutions": solutions(found.found)})

    def show(self, columns: dict[str, Any], texts: dict[str, str]) -> None:
        """Show a picture and texts."""
        self.scene.columns = columns
        self.texts |= texts

    def send(self, state: State, number: int, moves: int) -> None:
        """Send what is new of what is shown, with its number and that of the moves that it answers."""
        cross = {"cross": self.map.cross(self._across(state), state.angle)}
        shown = self.scene.drawn | self.curve.drawn | cross | self.texts
        fresh = {name: each for name, each in shown.items() if self.known.get(name) != each}
        self.known = shown
        self.channels.picture.data = {
            "number": [number], "moves": [moves], "content": [json.dumps(fresh)],
        }  # fmt: skip

    def _across(self, state: State) -> float:
        """Place of a state across its map."""
        return AXES[self.controls["across"].read(state)].here(state)

    def draw_map(self, state: State, found: Map) -> None:
        """Show a map and its legend."""
        self.map.show(found, AXES[found.axis].ticks(state))
        self.legend.text = legend(found)

    def select(self, handle: int) -> None:
        """Mark the handle that the keys move."""
        self.handle.active = handle

    def rest(self, query: str, lines: str) -> None:
        """The address and the lines of Python."""
        self.rests += 1  # so that a page that was loaded again hears it too
        self.channels.address.data = {"query": [query], "number": [self.rests]}
        text = lines.replace("&", "&amp;").replace("<", "&lt;")
        self.python.text = f"<pre>{text}</pre>"

    def say(self, text: str) -> None:
        """Say what went wrong, or nothing."""
        self.said = text
        self.wait(False)

    def wait(self, waits: bool) -> None:
        """Say that a computation takes long, or restore the message before."""
        text = (
            "Compiling this kind of slider, once: up to half a minute \u2026"
            if waits
            else self.said
        )
        shown = f'<p role="status">{text}</p>' if text else ""
        if self.status.text != shown:
            self.status.text = shown

    def save(self, name: str, content: str) -> None:
        """Hand a file, in base64, to the browser."""
        self.channels.file.data = {"name": [name], "content": [content]}


def _capital(word: str) -> str:
    return str(word)[0].upper() + str(word)[1:]
