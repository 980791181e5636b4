"""A field of the page: a widget, the part of the state that it shows, and the change that it makes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import panel as pn

from planar_pushing.explorer.state import State


class Field(NamedTuple):
    """A widget: its value for a state, the state after a change, and properties set by the state."""

    widget: Any
    read: Callable[[State], Any]
    write: Callable[[State, Any], State]
    more: Callable[[State], dict[str, Any]] = lambda state: {}


def slide(name: str, low: float, high: float, step: float, **rest: Any) -> pn.widgets.FloatSlider:
    """A slider for a number."""
    return pn.widgets.FloatSlider(
        label=name,
        start=low,
        end=high,
        step=step,
        margin=(2, 6),
        sizing_mode="stretch_width",
        **rest,
    )


def select(name: str, options: Any) -> pn.widgets.Select:
    """A list to choose from."""
    return pn.widgets.Select(
        label=name, options=options, margin=(2, 6), sizing_mode="stretch_width"
    )


def buttons(options: Any) -> pn.widgets.RadioButtonGroup:
    """Buttons, one of which is pressed."""
    return pn.widgets.RadioButtonGroup(options=options, margin=(2, 6))


def number(name: str) -> pn.widgets.FloatInput:
    """A field for a number."""
    return pn.widgets.FloatInput(
        label=name, step=0.1, margin=(2, 6), min_width=80, sizing_mode="stretch_width"
    )


def room(widget: Any, length: float) -> dict[str, Any]:
    """End of a slider for lengths; it changes only if a length no longer fits or is far smaller."""
    if 0.05 * widget.end <= length <= widget.end:
        return {}
    power = 10.0 ** np.floor(np.log10(2.5 * length))
    end = float(next(round_ * power for round_ in (1, 2, 5, 10) if round_ * power >= 2.5 * length))
    return {"end": end, "step": end / 1000}
