"""The pictures as Bokeh's figures: one glyph for each kind of mark, filled from its columns."""

from __future__ import annotations

from typing import Any

import numpy as np
from bokeh.core.properties import value
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

from planar_pushing.explore.pictures.columns import COLUMNS
from planar_pushing.explore.pictures.modes import AXES, Map, look
from planar_pushing.figures.style import DARK, GREY, GUIDE, LIGHT
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array

#: Width over height of the picture of a scene, and room around what it holds.
ASPECT, MARGIN = 1.45, 1.05
#: Codes of the sets of modes.
CODES = 1 << len(ContactMode)
FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif"
#: Colours of the energies, told apart in grey as well.
ENERGIES = {
    "work": DARK,
    "support friction": "#D55E00",
    "contact friction": "#CC79A7",
    "kinetic energy": "#56B4E9",
}


def plain_figure(name: str, **options: Any) -> Any:
    """A figure without frame, axes and tools."""
    found = figure(
        name=name, toolbar_location=None, tools="", outline_line_color=None, min_border=0,
        x_range=Range1d(-1, 1), y_range=Range1d(-1, 1), background_fill_color="white",
        border_fill_color="white", output_backend="canvas", lod_threshold=None, **options,
    )  # fmt: skip
    found.axis.visible = False
    found.grid.visible = False
    return found


class Canvas:
    """A figure that draws marks."""

    def __init__(self, name: str, **options: Any) -> None:
        self.figure = plain_figure(name, **options)
        self.sources = {
            kind: ColumnDataSource({column: [] for column in columns}, name=f"{name} {kind}")
            for kind, columns in COLUMNS.items()
        }
        self._glyphs(self.figure, self.sources)

    @staticmethod
    def _glyphs(on: Any, sources: dict[str, Any]) -> None:
        on.multi_polygons(
            "xs", "ys", fill_color="fill", fill_alpha="alpha", line_color="line",
            line_width="width", source=sources["areas"],
        )  # fmt: skip
        on.multi_line(
            "xs", "ys", line_color="color", line_width="width", line_dash="dash",
            line_alpha="alpha", line_join="round", source=sources["lines"],
        )  # fmt: skip
        on.patches(
            "xs", "ys", fill_color="fill", fill_alpha="alpha", line_color="line",
            line_alpha="alpha", source=sources["heads"],
        )  # fmt: skip
        on.scatter(
            "x", "y", size="size", fill_color="fill", line_color="line", line_width=1.6,
            marker="marker", source=sources["dots"],
        )  # fmt: skip
        on.scatter(
            "x", "y", size="size", fill_color=GREY, fill_alpha="alpha", line_color=GREY,
            line_alpha=0.75, line_width=1.2, source=sources["handles"],
        )  # fmt: skip
        for width, color in (
            (4.0, "white"),
            (0.0, "color"),
        ):  # white behind letters keeps them legible
            on.text(
                "x", "y", text="text", text_color="color", x_offset="dx", y_offset="dy",
                text_font=value(FONT), text_font_size="17px", text_font_style="bold",
                text_align="center", text_baseline="middle", source=sources["labels"],
                text_outline_color=color if width else None, text_outline_width=width,
            )  # fmt: skip

    def named(self, columns: dict[str, Any]) -> dict[str, Any]:
        """Columns by the names of the sources that they fill."""
        return {str(self.sources[kind].name): given for kind, given in columns.items()}

    def fit(self, corners: Array, aspect: float = ASPECT) -> None:
        """Show a box, in the middle, to one scale in both directions."""
        (left, low), (right, high) = corners
        half = MARGIN * max((right - left) / aspect, high - low) / 2
        x, y = (left + right) / 2, (low + high) / 2
        self.figure.x_range.update(start=float(x - half * aspect), end=float(x + half * aspect))
        self.figure.y_range.update(start=float(y - half), end=float(y + half))


class MapCanvas:
    """The contact-mode map, with a cross at the present place."""

    def __init__(self) -> None:
        self.figure = figure(
            name="map", toolbar_location=None, tools="", min_border=4, sizing_mode="stretch_width",
            height=300, x_range=Range1d(0, 1), y_range=Range1d(-180, 180),
            outline_line_color=GUIDE, border_fill_color=None, lod_threshold=None,
        )  # fmt: skip
        self.source = ColumnDataSource(
            {key: [] for key in ("image", "x", "y", "dw", "dh")}, name="map image"
        )
        self.cross = ColumnDataSource({"x": [], "y": []}, name="map cross")
        palette = [look(code)[1] for code in range(CODES)]
        mapper = LinearColorMapper(palette=palette, low=-0.5, high=CODES - 0.5)
        self.figure.image("image", "x", "y", "dw", "dh", color_mapper=mapper, source=self.source)
        for size, color, width in ((18, "white", 6.0), (16, DARK, 2.4)):
            self.figure.scatter(
                "x", "y", marker="cross", size=size, line_color=color, line_width=width,
                source=self.cross,
            )  # fmt: skip
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
