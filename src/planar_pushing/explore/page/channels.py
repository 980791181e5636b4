"""How page and server speak: what the page does with a message, and what it tells of a pointer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource

#: A picture comes in one message: columns and texts by the names of what shows them. The page says when it
#: is drawn.
DRAW = """
const shown = new Map(targets.map((each) => [each.name, each]))
const picture = JSON.parse(beat.data.picture[0])
for (const [name, data] of Object.entries(picture.columns)) shown.get(name).data = data
for (const [name, text] of Object.entries(picture.texts)) shown.get(name).text = text
const number = beat.data.number[0]
requestAnimationFrame(() => { drawn.data = {number: [number]} })
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


def on_pointer(source: Any, grab: Drag, drag: Drag, drop: Callable[[], None]) -> None:
    """Hear what a pointer does on a figure."""

    def moved(name: str, old: Any, new: Any) -> None:
        (kind,) = new["kind"]
        place = np.array([new["x"][0], new["y"][0]], dtype=float)
        if kind == "drop":
            drop()
        else:
            (grab if kind == "grab" else drag)(place)

    source.on_change("data", moved)


def pointer(name: str) -> Any:
    """Source by which the page tells what a pointer does on a figure, and where."""
    return ColumnDataSource({"kind": [], "x": [], "y": [], "number": []}, name=f"{name} pointer")
