"""The widgets of the page: how each reads a state and changes it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import panel as pn
from bokeh.models import CustomJSTickFormatter

from planar_pushing.explorer.pictures.maps import AXES, axes_of, axis_of
from planar_pushing.explorer.presets import gallery
from planar_pushing.explorer.state import (
    MAGNITUDES,
    ROD_ANGLES,
    Handle,
    Start,
    State,
    effect,
    first_policy,
    name_in,
    with_effect,
    with_law,
    with_push,
    with_rod,
    with_simulation,
    with_size,
    with_support,
)
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
OWN_SUPPORT = "own support"


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


def support_name(state: State) -> str:
    """Name of the support in the gallery."""
    entry = (effect(state, FRICTION) or {}).get("support")
    return name_in(gallery(), entry, state.size) or OWN_SUPPORT


def with_named_support(state: State, name: str) -> State:
    """State with a support of the gallery."""
    if name == OWN_SUPPORT:
        return state
    return with_support(state, None if name == "ring" else gallery()[name])


def kinds(state: State) -> list[EffectKind]:
    """Kinds of effects, support friction and inertia, that resist the motion."""
    return [kind for kind in (FRICTION, INERTIA) if effect(state, kind) is not None]


def with_kinds(state: State, active: list[EffectKind]) -> State:
    """State with these kinds of effects; new ones are added first because at least one must remain."""
    fresh: dict[EffectKind, dict[str, Any]] = {
        FRICTION: {"type": "ring_friction"},
        INERTIA: {"type": "inertia", "gyration_radius": state.size},
    }
    for kind in sorted((FRICTION, INERTIA), key=lambda kind: kind not in active):
        if kind not in active:
            state = with_effect(state, kind, None)
        elif effect(state, kind) is None:
            state = with_effect(state, kind, fresh[kind])
    return state


#: Positions of the player over the duration, and milliseconds between positions.
FRAMES, INTERVAL = 180, 33
#: Formatter that shows a number instead of its logarithm.
POWER = "return Number(Math.pow(10, tick).toPrecision(2)).toString()"


class Field(NamedTuple):
    """A widget: its value for a state, the state after a change, and properties set by the state."""

    widget: Any
    read: Callable[[State], Any]
    write: Callable[[State, Any], State]
    more: Callable[[State], dict[str, Any]] = lambda state: {}


def fields() -> dict[str, Field]:
    """All widgets that show a component of the state, by name."""
    return {**_push(), **_contact(), **_slider(), **_effects(), **_views(), **_motion()}


def _slide(name: str, low: float, high: float, step: float, **rest: Any) -> pn.widgets.FloatSlider:
    return pn.widgets.FloatSlider(
        label=name,
        start=low,
        end=high,
        step=step,
        margin=(2, 6),
        sizing_mode="stretch_width",
        **rest,
    )


def _select(name: str, options: Any) -> pn.widgets.Select:
    return pn.widgets.Select(
        label=name, options=options, margin=(2, 6), sizing_mode="stretch_width"
    )


def _buttons(options: Any) -> pn.widgets.RadioButtonGroup:
    return pn.widgets.RadioButtonGroup(options=options, margin=(2, 6))


def _number(name: str) -> pn.widgets.FloatInput:
    return pn.widgets.FloatInput(
        label=name, step=0.1, margin=(2, 6), min_width=80, sizing_mode="stretch_width"
    )


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
            _slide("Direction (degrees)", -180.0, 180.0, 0.5),
            lambda state: state.angle,
            lambda state, value: with_push(state, value, state.magnitude),
        ),
        "magnitude": Field(
            _slide("Magnitude, m a / W", low, high, 0.01, format=CustomJSTickFormatter(code=POWER)),
            AXES["magnitude"].coordinate_of,
            AXES["magnitude"].state_at,
            lambda state: {"visible": is_magnitude_open(state.scene)},
        ),
        "shape": Field(
            _buttons({"Fence": Shape.FENCE, "Finger": Shape.FINGER}),
            lambda state: state.shape,
            lambda state, shape: with_simulation(
                state, pusher_shape=str(shape), **_radius(state, shape)
            ),
            lambda state: {"disabled": state.flush},
        ),
        "start": Field(
            _buttons({"Moving at once": Start.VELOCITY, "From rest": Start.ACCELERATION}),
            lambda state: state.start,
            lambda state, start: replace(state, start=start, time=None),
            lambda state: {"disabled": not state.scene.stores_energy},
        ),
    }


# -- the contact and the slider ----------------------------------------------------------------------


def _contact() -> dict[str, Field]:
    friction = _slide("Coefficient of friction \u03bc", 0.0, 5.0, 0.01)
    return {
        "law": Field(_select("Contact law", list(LAWS)), law_name, with_named_law),
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


def _slider() -> dict[str, Field]:
    """Fields of the slider; they are for a contact at one point, so a side on the fence disables them."""
    length, size = _slide("Rod length", 0.0, 10.0, 0.01), _slide("Support size", 0.0, 5.0, 0.01)
    return {
        "support": Field(
            _select("Support", []), support_name, with_named_support,
            lambda state: {
                "options": [*gallery(), *([OWN_SUPPORT] if support_name(state) == OWN_SUPPORT else [])],
                "disabled": state.flush,
            },
        ),
        "rod_length": Field(
            length,
            lambda state: state.file.slider.rod_length,
            lambda state, value: with_rod(state, value, state.file.slider.rod_angle),
            lambda state: _room(length, state),
        ),
        "rod_angle": Field(
            _slide("Rod angle (degrees)", *ROD_ANGLES, 0.5),
            lambda state: state.file.slider.rod_angle,
            lambda state, value: with_rod(state, state.file.slider.rod_length, value),
            lambda state: {"disabled": state.flush},
        ),
        "size": Field(
            size, lambda state: state.size, with_size, lambda state: _room(size, state)
        ),
    }  # fmt: skip


def _room(widget: Any, state: State) -> dict[str, Any]:
    """End of a slider for lengths; it changes only if the scene no longer fits or is far smaller."""
    length = max(state.file.slider.rod_length, state.size)
    if 0.05 * widget.end <= length <= widget.end:
        return {"disabled": state.flush}
    power = 10.0 ** np.floor(np.log10(2.5 * length))
    end = float(next(round_ * power for round_ in (1, 2, 5, 10) if round_ * power >= 2.5 * length))
    return {"end": end, "step": end / 1000, "disabled": state.flush}


# -- the effects -------------------------------------------------------------------------------------


def _effects() -> dict[str, Field]:
    labels = {"Support friction": FRICTION, "Inertia": INERTIA}
    boxes = pn.widgets.CheckBoxGroup(label="Effects", options=labels, margin=(2, 6))
    return {
        "effects": Field(boxes, kinds, with_kinds),
        "weight": _part("Friction W", FRICTION, "weight"),
        "mass": _part("Mass m", INERTIA, "mass"),
        "gyration": _part("Radius of gyration", INERTIA, "gyration_radius"),
        "mass_x": _center("Center of mass, x", 0),
        "mass_y": _center("Center of mass, y", 1),
    }


def _part(name: str, kind: EffectKind, key: str) -> Field:
    """Field for a number of an effect."""
    return Field(
        _number(name),
        lambda state: float((effect(state, kind) or {}).get(key, 1.0)),
        lambda state, value: with_effect(state, kind, (effect(state, kind) or {}) | {key: value}),
        lambda state: {"disabled": effect(state, kind) is None},
    )


def _center(name: str, part: int) -> Field:
    """Field for a coordinate of the center of mass."""

    def center(state: State) -> list[float]:
        return list((effect(state, INERTIA) or {}).get("center", (0.0, 0.0)))

    def write(state: State, value: Any) -> State:
        changed = [value if index == part else old for index, old in enumerate(center(state))]
        return with_effect(state, INERTIA, (effect(state, INERTIA) or {}) | {"center": changed})

    return Field(
        _number(name), lambda state: center(state)[part], write,
        lambda state: {"disabled": effect(state, INERTIA) is None},
    )  # fmt: skip


# -- the pictures and the motion over time -----------------------------------------------------------


def _views() -> dict[str, Field]:
    return {
        "across": Field(
            _select("Map over", []), axis_of, lambda state, name: replace(state, across=name),
            lambda state: {"options": axes_of(state), "disabled": state.flush},
        ),
        "handle": Field(
            _buttons({handle.capitalize(): handle for handle in Handle}),
            lambda state: state.handle,
            lambda state, handle: replace(state, handle=handle),
            lambda state: {"disabled": state.time is not None or state.flush},
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
            _number("Duration"),
            lambda state: state.duration,
            lambda state, value: _restart(state, duration=value),
        ),
        "policy": Field(
            _select("Where several modes are possible", policies),
            first_policy,
            lambda state, value: _restart(state, on_ambiguity=value),
        ),
    }


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
