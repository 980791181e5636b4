"""What the page draws on: the pictures, the map of contact modes, modes and energies over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from bokeh.models import (
    ColumnDataSource,
    FixedTicker,
    Legend,
    LegendItem,
    LinearColorMapper,
    Range1d,
    Span,
)
from bokeh.plotting import figure

from planar_pushing.explore.pictures.columns import Marks
from planar_pushing.explore.pictures.modes import AXES, Map, look
from planar_pushing.explore.pictures.svg import Sheet, markup, sheet
from planar_pushing.figures.style import DARK, GUIDE, LIGHT
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array

#: Codes of the sets of modes.
CODES = 1 << len(ContactMode)
#: Room around the map, pixels: more than its labels take, so that its place does not depend on them.
BORDERS = {"left": 76, "right": 12, "top": 8, "bottom": 56}
FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif"
#: Colors of the energies. Their brightness differs too, for pictures in gray.
ENERGIES = {
    "work": DARK,
    "support friction": "#D55E00",
    "contact friction": "#CC79A7",
    "kinetic energy": "#56B4E9",
}


class Canvas:
    """A picture on the page: what it holds, the box of the plane that it shows, and its size in pixels."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.corners: Array = np.array([(-1.5, -1.5), (1.5, 1.5)])
        self.size = 700.0, 500.0
        self.columns = Marks().columns

    def fit(self, corners: Array) -> bool:
        """Show another box; whether it is another one."""
        old, self.corners = self.corners, corners
        return not np.array_equal(old, corners)

    @property
    def sheet(self) -> Sheet:
        """Where the picture is on the screen."""
        return sheet(self.corners, *self.size)

    @property
    def drawn(self) -> dict[str, str]:
        """The picture as SVG, by its name."""
        return {self.name: markup(self.columns, self.sheet)}


class MapCanvas:
    """The contact-mode map, with a cross at the present place."""

    def __init__(self) -> None:
        self.figure = figure(
            name="map", toolbar_location=None, tools="", sizing_mode="stretch_width", height=300,
            x_range=Range1d(0, 1), y_range=Range1d(-180, 180),
            **{f"min_border_{side}": width for side, width in BORDERS.items()},
            outline_line_color=GUIDE, border_fill_color=None, lod_threshold=None,
        )  # fmt: skip
        self.source = ColumnDataSource(
            {key: [] for key in ("image", "x", "y", "dw", "dh")}, name="map image"
        )
        palette = [look(code)[1] for code in range(CODES)]
        mapper = LinearColorMapper(palette=palette, low=-0.5, high=CODES - 0.5)
        self.figure.image("image", "x", "y", "dw", "dh", color_mapper=mapper, source=self.source)
        self.figure.grid.visible = False
        self.ticks = FixedTicker(ticks=[])
        self.figure.xaxis.ticker = self.ticks
        self.figure.yaxis.axis_label = "direction of the push (degrees)"
        self.figure.yaxis.ticker = FixedTicker(ticks=list(range(-180, 181, 60)))
        styled(self.figure)

    def show(self, found: Map, ticks: dict[float, str]) -> None:
        """Draw a map."""
        left, right = found.left, found.right
        self.figure.x_range.update(start=left, end=right)
        self.ticks.ticks = list(
            ticks
        )  # another ticker would have the document look through all models
        self.figure.xaxis.major_label_overrides = dict(ticks)
        self.figure.xaxis.axis_label = AXES[found.axis].title
        self.source.data = {
            "image": [found.codes], "x": [left], "y": [-180], "dw": [right - left], "dh": [360],
        }  # fmt: skip

    def cross(self, along: float, angle: float) -> str:
        """A cross at a place of the map, over its figure: it is moved without painting the map anew."""
        within = self.figure.x_range
        left = (along - within.start) / (within.end - within.start)
        wide, high = BORDERS["left"] + BORDERS["right"], BORDERS["top"] + BORDERS["bottom"]
        x = f"calc({BORDERS['left']}px + {left:.4f} * (100% - {wide}px))"
        y = f"calc({BORDERS['top']}px + {0.5 - angle / 360.0:.4f} * (100% - {high}px))"
        strokes = "".join(
            f'<path d="M{-half} 0H{half}M0 {-half}V{half}" stroke="{color}" stroke-width="{width}"/>'
            for half, color, width in ((9, "white", 6.0), (8, DARK, 2.4))
        )
        return f'<svg style="left: {x}; top: {y}">{strokes}</svg>'


class TimeCanvas:
    """Modes and energies over time, with a line at the present instant."""

    def __init__(self) -> None:
        shared = Range1d(0, 1)
        options: dict[str, Any] = {
            "toolbar_location": None, "tools": "", "sizing_mode": "stretch_width", "min_border": 4,
            "x_range": shared, "outline_line_color": None, "border_fill_color": None,
            "min_border_left": 62,
        }  # fmt: skip
        self.bar = figure(name="modes", height=58, y_range=Range1d(0, 1), **options)
        self.energy = figure(name="energy", height=190, **options)
        self.modes = ColumnDataSource(
            {key: [] for key in ("left", "right", "fill", "hatch")}, name="mode columns"
        )
        self.energies = ColumnDataSource({"time": [], **{name: [] for name in ENERGIES}})
        self.bar.quad(
            "left", "right", 1, 0, fill_color="fill", line_color="white", hatch_pattern="hatch",
            hatch_color="white", hatch_alpha=0.8, source=self.modes,
        )  # fmt: skip
        lines = {
            name: self.energy.line("time", name, color=color, line_width=2, source=self.energies)
            for name, color in ENERGIES.items()
        }
        self.energy.add_layout(_legend(lines), "above")
        self.now = [Span(dimension="height", line_width=2, line_color=DARK) for _ in range(2)]
        self.bar.add_layout(self.now[0])
        self.energy.add_layout(self.now[1])
        self._style()

    def _style(self) -> None:
        self.bar.axis.visible = False
        self.bar.grid.visible = False
        self.energy.xaxis.axis_label = "time"
        self.energy.yaxis.axis_label = "energy"
        self.energy.grid.grid_line_color = LIGHT
        self.energy.grid.grid_line_alpha = 0.4
        styled(self.energy)

    def show(self, modes: dict[str, Any], times: Array, energies: dict[str, Any]) -> None:
        """Draw the modes and energies of a motion."""
        self.modes.data = modes
        self.energies.data = {"time": times, **energies}
        self.bar.x_range.update(start=float(times[0]), end=float(times[-1]))

    def mark(self, time: float) -> None:
        """Move the line of the present instant."""
        for each in self.now:
            each.location = float(np.float64(time))


def _legend(lines: dict[str, Any]) -> Legend:
    """Names of lines, in rows above a figure."""
    return Legend(
        items=[LegendItem(label=name, renderers=[line]) for name, line in lines.items()],
        ncols=2, location="left", border_line_color=None, label_text_font=FONT,
        label_text_font_size="12px", spacing=0, padding=2, margin=0, background_fill_color=None,
    )  # fmt: skip


def styled(on: Any) -> None:
    """Letters and ticks of axes."""
    for axis in on.axis:
        axis.update(
            axis_label_text_font=FONT, axis_label_text_font_style="normal",
            axis_label_text_font_size="13px", major_label_text_font=FONT,
            major_label_text_font_size="12px", axis_line_color=GUIDE, major_tick_line_color=GUIDE,
            minor_tick_line_color=None, axis_label_text_color=DARK, major_label_text_color=DARK,
        )  # fmt: skip
