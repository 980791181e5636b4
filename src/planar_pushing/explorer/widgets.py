"""The widgets of the page: how each reads a state and changes it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import panel as pn
from bokeh.models import CustomJSTickFormatter

from planar_pushing.explorer.field import Field, buttons, number, select, slide
from planar_pushing.explorer.lengths import factor, label
from planar_pushing.explorer.object_fields import object_fields
from planar_pushing.explorer.objects import object_of
from planar_pushing.explorer.pictures.handles import handle_of, handles_of
from planar_pushing.explorer.pictures.maps import AXES, axes_of, axis_of
from planar_pushing.explorer.state import (
    MAGNITUDES,
    ROUNDING,
    Start,
    State,
    effect,
    first_policy,
    with_effect,
    with_law,
    with_push,
    with_simulation,
)
from planar_pushing.explorer.supports import BASE, with_named_support
from planar_pushing.mechanics.force.cones import is_magnitude_open
from planar_pushing.terms.options import EffectKind, Policy, Shape

FRICTION, INERTIA = EffectKind.SUPPORT_FRICTION, EffectKind.INERTIA
#: Contact laws in the format of scene files, by their names on the page.
LAWS: dict[str, dict[str, Any]] = {
    "Coulomb friction": {"law": "coulomb"},
    "infinite friction": {"law": "infinite_friction", "at_zero_normal": "free"},
    "infinite friction, definition 2": {"law": "infinite_friction", "at_zero_normal": "none"},
    "perfectly rough": {"law": "perfectly_rough"},
}


def law_name(state: State) -> str:
    """Name of the contact law on the page."""
    entries = state.file.contact.model_dump().items()
    return next(name for name, law in LAWS.items() if law.items() <= entries)


def coefficient(state: State) -> float:
    """Coefficient of friction; 1 if the law has none."""
    return float(getattr(state.scene.contact, "friction_coefficient", 1.0))


def with_named_law(state: State, name: str) -> State:
    """State with a contact law given by its name on the page."""
    coulomb = LAWS[name]["law"] == "coulomb"
    parameters = {"friction_coefficient": coefficient(state)} if coulomb else {}
    return with_law(state, LAWS[name] | parameters)


def kinds(state: State) -> list[EffectKind]:
    """Kinds of effects, support friction and inertia, that resist the motion."""
    return [kind for kind in (FRICTION, INERTIA) if effect(state, kind) is not None]


def with_kinds(state: State, active: list[EffectKind]) -> State:
    """State with these kinds of effects; new ones are added first because at least one must remain.

    New friction is that of a ring, or of even pressure over the base of an object with an outline.
    """
    fresh: dict[EffectKind, dict[str, Any]] = {
        FRICTION: {"type": "ring_friction"},
        INERTIA: {"type": "inertia", "gyration_radius": state.size},
    }
    for kind in sorted((FRICTION, INERTIA), key=lambda kind: kind not in active):
        if kind not in active:
            state = with_effect(state, kind, None)
        elif effect(state, kind) is None:
            state = with_effect(state, kind, fresh[kind])
            if kind == FRICTION and state.has_outline:
                state = with_named_support(state, BASE)
    return state


#: Positions of the player over the duration, and milliseconds between positions.
FRAMES, INTERVAL = 180, 33
#: Formatter that shows a number instead of its logarithm.
POWER = "return Number(Math.pow(10, tick).toPrecision(2)).toString()"


def fields() -> dict[str, Field]:
    """All widgets that show a component of the state, by name."""
    return {**_push(), **_contact(), **object_fields(), **_effects(), **_views(), **_motion()}


def _radius(state: State, shape: str) -> dict[str, Any]:
    """Radius of the finger in the file; a fence has none."""
    section = state.file.simulate
    radius = section.pusher_radius if section else None
    return {"pusher_radius": radius if shape == Shape.FINGER else None}


# -- the push ----------------------------------------------------------------------------------------


def _push() -> dict[str, Field]:
    low, high = map(float, np.log10(MAGNITUDES))
    return {
        "angle": Field(
            slide("Direction (degrees)", -180.0, 180.0, 0.5),
            lambda state: state.angle,
            lambda state, value: with_push(state, value, state.magnitude),
        ),
        "magnitude": Field(
            slide("Magnitude, m a / W", low, high, 0.01, format=CustomJSTickFormatter(code=POWER)),
            AXES["magnitude"].coordinate_of,
            AXES["magnitude"].state_at,
            lambda state: {"visible": is_magnitude_open(state.scene)},
        ),
        "shape": Field(
            buttons({"Fence": Shape.FENCE, "Finger": Shape.FINGER}),
            lambda state: state.shape,
            lambda state, shape: with_simulation(
                state, pusher_shape=str(shape), **_radius(state, shape)
            ),
            lambda state: {"disabled": state.flush},
        ),
        "start": Field(
            buttons({"Moving at once": Start.VELOCITY, "From rest": Start.ACCELERATION}),
            lambda state: state.start,
            lambda state, start: replace(state, start=start, time=None),
            lambda state: {"disabled": not state.scene.stores_energy},
        ),
    }


# -- the contact ----------------------------------------------------------------------


def _contact() -> dict[str, Field]:
    friction = slide("Coefficient of friction \u03bc", 0.0, 5.0, 0.01)
    return {
        "law": Field(select("Contact law", list(LAWS)), law_name, with_named_law),
        "friction": Field(
            friction,
            coefficient,
            lambda state, value: with_law(
                state, {"law": "coulomb", "friction_coefficient": float(value)}
            ),
            lambda state: {
                "end": max(5.0, coefficient(state)),
                "disabled": law_name(state) != "Coulomb friction",
            },
        ),
    }


# -- the effects -------------------------------------------------------------------------------------


def _effects() -> dict[str, Field]:
    labels = {"Support friction": FRICTION, "Inertia": INERTIA}
    boxes = pn.widgets.CheckBoxGroup(label="Effects", options=labels, margin=(2, 6))
    return {
        "effects": Field(boxes, kinds, with_kinds),
        "weight": _part("Friction W", FRICTION, "weight"),
        "mass": _part("Mass m", INERTIA, "mass"),
        "gyration": _gyration("Gyration radius"),
        "mass_x": _center("Mass center, x", 0),
        "mass_y": _center("Mass center, y", 1),
    }


def _part(name: str, kind: EffectKind, key: str) -> Field:
    """Field for a number of an effect."""
    return Field(
        number(name),
        lambda state: float((effect(state, kind) or {}).get(key, 1.0)),
        lambda state, value: with_effect(state, kind, (effect(state, kind) or {}) | {key: value}),
        lambda state: {"disabled": effect(state, kind) is None},
    )


def _gyration(name: str) -> Field:
    """Field for the radius of gyration; by default it is that of a plate in the shape of the outline."""

    def read(state: State) -> float:
        masses = state.scene.masses
        return factor(state) * float(masses[0].gyration_radius if masses else 1.0)

    def write(state: State, value: Any) -> State:
        length = value if value is None else value / factor(state)
        entry = (effect(state, INERTIA) or {}) | {"gyration_radius": length}
        return with_effect(state, INERTIA, entry)

    return Field(
        number(name), read, write,
        lambda state: {"disabled": effect(state, INERTIA) is None, "label": label(name, state)},
    )  # fmt: skip


def _center(name: str, part: int) -> Field:
    """Field for a coordinate of the center of mass, in the object's frame if it has an outline."""

    def center(state: State) -> list[float]:
        point = np.array((effect(state, INERTIA) or {}).get("center", (0.0, 0.0)))
        if state.has_outline:
            point = object_of(state).body.point_out(point)
        point[np.abs(point) < ROUNDING * state.size] = 0.0
        return [float(f"{x:.9g}") for x in point.tolist()]

    def write(state: State, value: Any) -> State:
        length = value if value is None else value / factor(state)
        changed: Any = [length if index == part else old for index, old in enumerate(center(state))]
        if state.has_outline and value is not None:
            changed = object_of(state).body.point_in(changed).tolist()
        return with_effect(state, INERTIA, (effect(state, INERTIA) or {}) | {"center": changed})

    return Field(
        number(name), lambda state: center(state)[part] * factor(state), write,
        lambda state: {"disabled": effect(state, INERTIA) is None, "label": label(name, state)},
    )  # fmt: skip


# -- the pictures and the motion over time -----------------------------------------------------------


def _views() -> dict[str, Field]:
    return {
        "across": Field(
            select("Map over", []), axis_of, lambda state, name: replace(state, across=name),
            lambda state: {"options": axes_of(state), "disabled": state.flush},
        ),
        "handle": Field(
            buttons({}),
            handle_of,
            lambda state, handle: replace(state, handle=handle),
            lambda state: {
                "options": {handle.capitalize(): handle for handle in handles_of(state)},
                "disabled": state.time is not None or state.flush,
            },
        ),
    }  # fmt: skip


def _motion() -> dict[str, Field]:
    toggle = pn.widgets.Toggle(color="primary", margin=(2, 6))
    player = pn.widgets.Player(
        label="Time", start=0, end=FRAMES, interval=INTERVAL, loop_policy="once", margin=(2, 6),
        show_loop_controls=False, visible_buttons=["first", "previous", "pause", "play", "next"],
        height=70, sizing_mode="stretch_width", scale_buttons=0.9, min_width=240, width=None,
    )  # fmt: skip
    policies = {policy.value.replace("-", " "): policy.value for policy in Policy}
    return {
        "follow": Field(
            toggle,
            lambda state: state.time is not None,
            lambda state, active: replace(state, time=0.0 if active else None),
            lambda state: {
                "label": "Follow over time" if state.time is None else "Back to the push"
            },
        ),
        "time": Field(
            player,
            lambda state: round(FRAMES * (state.time or 0.0) / state.duration),
            lambda state, frame: replace(state, time=frame / FRAMES * state.duration),
            lambda state: {"visible": state.time is not None},
        ),
        "duration": Field(
            number("Duration"),
            lambda state: state.duration,
            lambda state, value: _restart(state, duration=value),
            lambda state: {"label": _duration_name(state)},
        ),
        "policy": Field(
            select("Where several modes are possible", policies),
            first_policy,
            lambda state, value: _restart(state, on_ambiguity=value),
        ),
    }


def _duration_name(state: State) -> str:
    """Name of the duration with its unit, if the scene has one."""
    units = state.file.units
    return "Duration" if units is None else f"Duration ({units.time})"


def _restart(state: State, **options: Any) -> State:
    """State with other options; if it was followed over time, it is followed again."""
    return replace(with_simulation(state, **options), time=None if state.time is None else 0.0)


def alike(one: Any, other: Any) -> bool:
    """Whether two values of a widget are equal up to rounding."""
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= 1e-9 * max(abs(one), abs(other))
    return bool(one == other)


def update(widget: Any, wanted: dict[str, Any]) -> None:
    """Set the changed properties of a widget."""
    changes = {
        name: value for name, value in wanted.items() if not alike(getattr(widget, name), value)
    }
    if changes:
        widget.param.update(**changes)
