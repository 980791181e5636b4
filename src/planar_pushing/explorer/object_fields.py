"""The fields of the object: its outline, the place of its contact, its support, and the unit of lengths."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import panel as pn

from planar_pushing.explorer.boundary import perimeter, place_at
from planar_pushing.explorer.field import Field, number, room, select, slide
from planar_pushing.explorer.lengths import METERS, factor, label, own_unit, shown_unit, units_of
from planar_pushing.explorer.objects import object_of, with_contact
from planar_pushing.explorer.own_outline import (
    BOX,
    CORNERS,
    DISC,
    FILE,
    KINDS,
    corners_text,
    kind_of,
    sides_of,
    with_box,
    with_corners,
    with_diameter,
    with_kind,
)
from planar_pushing.explorer.state import ROD_ANGLES, State, with_entries, with_rod, with_size
from planar_pushing.explorer.supports import support_name, support_names, with_named_support

#: The unit of a scene that names none.
NO_UNIT = "no unit"


def object_fields() -> dict[str, Field]:
    """Fields of the object by name."""
    return {
        **_outline_fields(),
        **_contact_field(),
        **_rod_fields(),
        **_support_fields(),
        **_unit_field(),
    }


def _outline_fields() -> dict[str, Field]:
    width, height, diameter = number("Width"), number("Height"), number("Diameter")
    corners = pn.widgets.TextAreaInput(
        label="Corners: x, y", rows=6, margin=(2, 6), sizing_mode="stretch_width",
        placeholder="x, y: one corner per line",
    )  # fmt: skip
    return {
        "outline": Field(
            select("Outline", list(KINDS)), kind_of, with_kind,
            lambda state: {"options": [*KINDS, *([FILE] if kind_of(state) == FILE else [])]},
        ),
        "width": Field(
            width, lambda state: sides_of(state)[0],
            lambda state, value: with_box(state, value, sides_of(state)[1]),
            lambda state: _entry_of_length(state, "Width", BOX),
        ),
        "height": Field(
            height, lambda state: sides_of(state)[1],
            lambda state, value: with_box(state, sides_of(state)[0], value),
            lambda state: _entry_of_length(state, "Height", BOX),
        ),
        "diameter": Field(
            diameter, lambda state: sides_of(state)[0], with_diameter,
            lambda state: _entry_of_length(state, "Diameter", DISC),
        ),
        "corners": Field(
            corners, corners_text, with_corners,
            lambda state: {
                "visible": kind_of(state) == CORNERS, "label": label("Corners: x, y", state),
            },
        ),
    }  # fmt: skip


def _entry_of_length(state: State, name: str, kind: str) -> dict[str, Any]:
    """Name of a field for a length of an outline of one kind; the field is hidden for others."""
    return {"visible": kind_of(state) == kind, "label": label(name, state)}


def _contact_field() -> dict[str, Field]:
    """Place of the contact, as its distance along the outline."""
    along = slide("Contact along the outline", 0.0, 1.0, 0.001)

    def read(state: State) -> float:
        movable = state.has_outline and not state.flush
        return object_of(state).place.length * factor(state) if movable else 0.0

    def write(state: State, value: float) -> State:
        return with_contact(state, place_at(object_of(state).outline, value / factor(state)))

    def more(state: State) -> dict[str, Any]:
        if not state.has_outline or state.flush:
            return {"visible": False}
        end = perimeter(object_of(state).outline) * factor(state)
        name = label("Contact along the outline", state)
        return {"visible": True, "end": end, "step": end / 1000, "label": name}

    return {"place": Field(along, read, write, more)}


def _rod_fields() -> dict[str, Field]:
    """Fields of a rod, for objects without an outline."""
    length = slide("Rod length", 0.0, 10.0, 0.01)
    return {
        "rod_length": Field(
            length,
            lambda state: state.file.slider.rod_length * factor(state),
            lambda state, value: with_rod(
                state, value / factor(state), state.file.slider.rod_angle
            ),
            lambda state: _slider_of_length(length, state, "Rod length"),
        ),
        "rod_angle": Field(
            slide("Rod angle (degrees)", *ROD_ANGLES, 0.5),
            lambda state: state.file.slider.rod_angle,
            lambda state, value: with_rod(state, state.file.slider.rod_length, value),
            lambda state: {"visible": not state.has_outline, "disabled": state.flush},
        ),
    }


def _slider_of_length(widget: Any, state: State, name: str) -> dict[str, Any]:
    """Range and name of a slider for a length of a scene without an outline."""
    length = factor(state) * max(state.file.slider.rod_length, state.size)
    return room(widget, length) | {
        "disabled": state.flush, "visible": not state.has_outline, "label": label(name, state),
    }  # fmt: skip


def _support_fields() -> dict[str, Field]:
    size = slide("Support size", 0.0, 5.0, 0.01)
    return {
        "support": Field(
            select("Support", {}), support_name, with_named_support,
            lambda state: {"options": support_names(state), "disabled": state.flush},
        ),
        "size": Field(
            size, lambda state: state.size * factor(state),
            lambda state, value: with_size(state, value / factor(state)),
            lambda state: _slider_of_length(size, state, "Support size"),
        ),
    }  # fmt: skip


def _unit_field() -> dict[str, Field]:
    def write(state: State, unit: str) -> State:
        if own_unit(state) or unit == NO_UNIT:
            return replace(state, unit="" if unit == NO_UNIT else unit)
        units = {"length": unit, "force": "N", "time": "s"}
        return replace(with_entries(state, units=units), unit="")

    def more(state: State) -> dict[str, Any]:
        units = units_of(state) if own_unit(state) else [NO_UNIT, *METERS]
        return {"options": units, "disabled": len(units) == 1}

    return {
        "unit": Field(
            select("Unit of lengths", []), lambda state: shown_unit(state) or NO_UNIT, write, more
        )
    }
