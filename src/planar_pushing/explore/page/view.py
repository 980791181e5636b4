"""The page's models in one place: it shows what it is told, and tells what was done to it."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np
from bokeh.events import Tap
from bokeh.models import (
    Button,
    ColumnDataSource,
    CustomJS,
    Div,
    RadioButtonGroup,
    Select,
)

from planar_pushing.explore.handles import Handle
from planar_pushing.explore.page.canvas import ASPECT, Canvas, MapCanvas
from planar_pushing.explore.page.channels import ADDRESS, DRAW, SAVE, Drag, on_pointer, pointer
from planar_pushing.explore.page.controls import controls
from planar_pushing.explore.page.tables import legend, solutions
from planar_pushing.explore.pictures.modes import AXES, Map
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
        self.scene = Canvas("scene", sizing_mode="scale_width", aspect_ratio=ASPECT)
        self.curve = Canvas("curve", sizing_mode="scale_width", aspect_ratio=1.0)
        self.curve.fit(np.array([(-1.5, -1.5), (1.5, 1.5)]), 1.0)
        self.map = MapCanvas()
        self.controls = controls()
        self.words = Div(name="words", sizing_mode="stretch_width")
        self.status = Div(name="status", sizing_mode="stretch_width")
        self.table = Div(name="solutions", sizing_mode="stretch_width")
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
        self.known: dict[str, Any] = {}
        self.said, self.rests = "", 0
        self._channels()

    def _channels(self) -> None:
        """Sources by which page and server speak: they hold one number or text each."""
        self.ticks = ColumnDataSource({"number": [0], "moves": [0], "picture": [""]}, name="beat")
        self.drawn = ColumnDataSource({"number": [0]}, name="drawn")
        self.keys = ColumnDataSource(
            {"right": [], "up": [], "coarse": [], "number": []}, name="keys"
        )
        self.file = ColumnDataSource({"name": [], "content": []}, name="file")
        self.address = ColumnDataSource({"query": [], "number": []}, name="address")
        self.pointer, self.curve_pointer = pointer("scene"), pointer("curve")
        # No glyph refers to them: the document finds them here.
        heard = [self.drawn, self.keys, self.pointer, self.curve_pointer]
        self.scene.figure.tags = [self.ticks, self.file, self.address, *heard]
        texts = [self.words, self.table]
        targets = [*self.scene.sources.values(), *self.curve.sources.values(), *texts]
        for each in targets:  # the page fills them itself, and has nothing to report
            each.syncable = False
        js = {"drawn": self.drawn, "beat": self.ticks, "targets": targets}
        self.ticks.js_on_change("data", CustomJS(args=js, code=DRAW))
        self.file.js_on_change("data", CustomJS(args={"file": self.file}, code=SAVE))
        self.address.js_on_change("data", CustomJS(args={"address": self.address}, code=ADDRESS))

    @property
    def roots(self) -> list[Any]:
        """Everything that the template places, by its name."""
        shown = [self.scene.figure, self.curve.figure, self.map.figure, self.words, self.status]
        shown += [self.table, self.legend, self.python, self.preset, self.handle, self.solution]
        shown += [each.widget for each in self.controls.values()]
        shown += [*self.saves.values(), self.close]
        return shown

    # -- what is told ------------------------------------------------------------------------

    def on_ready(self, document: Any, ready: Callable[[], None]) -> None:
        """The page is there, and has nothing drawn."""

        def fresh(event: Any) -> None:
            self.known = {}
            ready()

        document.on_event("document_ready", fresh)

    def on_drag(self, grab: Drag, drag: Drag, drop: Callable[[], None]) -> None:
        """Drags on the picture, by mouse, pen or finger."""
        on_pointer(self.pointer, grab, drag, drop)

    def on_curve(self, aim: Drag, drop: Callable[[], None]) -> None:
        """Drags on the limit curve, which aim the force."""
        on_pointer(self.curve_pointer, aim, aim, drop)

    def on_map(self, go: Callable[[float, float], None]) -> None:
        """Clicks on the map."""
        self.map.figure.on_event(Tap, lambda event: go(event.y, event.x))

    def on_keys(self, key: Callable[[int, int, bool], None]) -> None:
        """Arrow keys on the picture."""

        def pressed(name: str, old: Any, new: Any) -> None:
            if new["right"]:
                key(int(new["right"][0]), int(new["up"][0]), bool(new["coarse"][0]))

        self.keys.on_change("data", pressed)

    def on_drawn(self, drew: Callable[[int], None]) -> None:
        """The number of the picture that the page has drawn."""
        self.drawn.on_change("data", lambda name, old, new: drew(int(new["number"][0])))

    def on_choice(self, handle: Callable[[int], None], solution: Callable[[str], None]) -> None:
        """The handle that the keys move, and the solution that is drawn in full."""
        self.handle.on_change("active", lambda name, old, new: handle(new))
        self.solution.on_change("active", lambda name, old, new: solution(self.modes[new]))

    # -- what is shown -----------------------------------------------------------------------

    def read(self, state: State) -> None:
        """Let the widgets show a state."""
        for control in self.controls.values():
            wanted = control.options(state) | {control.holds: control.read(state)}
            fresh = {k: each for k, each in wanted.items() if getattr(control.widget, k) != each}
            if fresh:
                control.widget.update(**fresh)

    def draw(self, found: Any, number: int, moves: int) -> None:
        """Show pictures and words."""
        columns = self.scene.named(found.scene) | self.curve.named(found.curve)
        texts = {"words": heading(found.words), "solutions": solutions(found.found)}
        self.send(columns, texts, number, moves)
        self.modes = [each.mode.name for each in found.found.solutions]
        labels = [name.replace("_", " ").capitalize() for name in self.modes] or ["None"]
        self.solution.update(
            labels=labels, active=max(found.found.shown, 0), disabled=len(labels) < 2
        )

    def send(self, columns: dict[str, Any], texts: dict[str, str], number: int, moves: int) -> None:
        """Send a picture, its number and that of the moves that it answers; what is known is left out."""
        fresh = {name: each for name, each in columns.items() if self.known.get(name) != each}
        said = {name: each for name, each in texts.items() if self.known.get(name) != each}
        self.known |= fresh | said
        picture = json.dumps({"columns": fresh, "texts": said})
        self.ticks.data = {"number": [number], "moves": [moves], "picture": [picture]}

    def mark(self, state: State) -> None:
        """Move the cross on the map: less often than the rest, as the whole map is painted anew."""
        axis = AXES[self.controls["across"].read(state)]
        place = {"x": [axis.here(state)], "y": [state.angle]}
        if self.map.cross.data != place:
            self.map.cross.data = place

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
        self.address.data = {"query": [query], "number": [self.rests]}
        text = lines.replace("&", "&amp;").replace("<", "&lt;")
        self.python.text = f"<pre>{text}</pre>"

    def say(self, text: str) -> None:
        """Say what went wrong, or nothing."""
        self.said = text
        self.wait(False)

    def wait(self, waits: bool) -> None:
        """Say that something takes long, or what was said before."""
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
        self.file.data = {"name": [name], "content": [content]}


def heading(words: str) -> str:
    """The sentence above the picture, read aloud where it changes."""
    return f'<h2 aria-live="polite">{words}</h2>'


def _capital(word: str) -> str:
    return str(word)[0].upper() + str(word)[1:]
