"""Messages between page and server: sources of data that one of them sets and the other hears."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource, CustomJS

from planar_pushing.explore.page.canvas import Canvas

#: A picture comes in one message, as the content of elements by their names. The page says that it has
#: taken it, and paints it with its next image of the screen.
DRAW = """
for (const [name, content] of Object.entries(JSON.parse(picture.data.content[0]))) {
  document.getElementById(name).innerHTML = content
}
taken.data = {number: [picture.data.number[0]]}
"""
SAVE = """
const [name] = file.data.name
const bytes = Uint8Array.from(atob(file.data.content[0]), (c) => c.charCodeAt(0))
const link = document.createElement("a")
link.href = URL.createObjectURL(new Blob([bytes]))
link.download = name
link.click()
setTimeout(() => URL.revokeObjectURL(link.href), 1000)
"""
ADDRESS = """
history.replaceState(null, "", "?" + address.data.query[0])
"""
#: What is done with a place of a picture.
Drag = Callable[[Any], None]


class Channels:
    """The sources: they hold one number or text each."""

    def __init__(self) -> None:
        self.picture = _source("picture", number=[0], moves=[0], content=["{}"])
        self.file = _source("file", name=[], content=[])
        self.address = _source("address", query=[], number=[])
        self.taken = _source("taken", number=[0])
        self.sizes = _source("sizes", scene=[], curve=[])
        self.keys = _source("keys", right=[], up=[], coarse=[], number=[])
        self.pointers = {
            name: _source(f"{name} pointer", kind=[], x=[], y=[], number=[])
            for name in ("scene", "curve")
        }
        told = {"picture": self.picture, "taken": self.taken}
        self.picture.js_on_change("data", CustomJS(args=told, code=DRAW))
        self.file.js_on_change("data", CustomJS(args={"file": self.file}, code=SAVE))
        self.address.js_on_change("data", CustomJS(args={"address": self.address}, code=ADDRESS))

    @property
    def all(self) -> list[Any]:
        """Every source, for the document to find."""
        told = [self.picture, self.file, self.address, self.taken, self.sizes, self.keys]
        return [*told, *self.pointers.values()]

    @property
    def script(self) -> CustomJS:
        """What the page runs once it is there."""
        told = {"sizes": self.sizes, "keys": self.keys}
        told |= {f"{name}_pointer": each for name, each in self.pointers.items()}
        found: CustomJS = CustomJS.from_file(Path(__file__).with_name("page.js"), **told)
        return found


def _source(name: str, /, **data: Any) -> Any:
    return ColumnDataSource(data, name=name)


def on_pointer(source: Any, on: Canvas, grab: Drag, drag: Drag, drop: Callable[[], None]) -> None:
    """Hear what a pointer does on a picture."""

    def moved(name: str, old: Any, new: Any) -> None:
        (kind,) = new["kind"]
        place = on.sheet.place(np.array([new["x"][0], new["y"][0]], dtype=float))
        if kind == "drop":
            drop()
        else:
            (grab if kind == "grab" else drag)(place)

    source.on_change("data", moved)
