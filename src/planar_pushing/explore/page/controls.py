"""The widgets of the page: what each shows of a state, and what a change of it means."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from bokeh.models import (
    CheckboxGroup,
    CustomJSTickFormatter,
    RadioButtonGroup,
    Select,
    Slider,
    Spinner,
)

from planar_pushing.explore.handles import magnitude_matters
from planar_pushing.explore.page.changes import (
    FRICTION,
    INERTIA,
    LAWS,
    OWN,
    center_of_mass,
    coefficient,
    kinds,
    law_name,
    number_of,
    simulated_again,
    size_of_push,
    support_name,
    with_coefficient,
    with_kinds,
    with_named_law,
    with_named_support,
    with_size_of_push,
)
from planar_pushing.explore.pictures.modes import axes_of, axis_of
from planar_pushing.explore.presets import gallery
from planar_pushing.explore.state import (
    MAGNITUDES,
    ROD_ANGLES,
    Start,
    State,
    effect,
    first_policy,
    pushed,
    simulated,
    with_rod,
    with_size,
)
from planar_pushing.study.datasets.base import words
from planar_pushing.terms.options import EffectKind, Policy, Shape

#: How the widget of a logarithm shows its number.
POWER = "return Number(Math.pow(10, tick).toPrecision(2)).toString()"


@dataclass(frozen=True, slots=True, kw_only=True)
class Control:
    """A widget: which of its properties holds the value, what that is of a state, and what a change does.

    `options` are other properties that follow the state.
    """

    widget: Any
    read: Callable[[State], Any]
    write: Callable[[State, Any], State]
    holds: str = "value"
    options: Callable[[State], dict[str, Any]] = lambda state: {}


def _is_off(kind: EffectKind) -> Callable[[State], dict[str, Any]]:
    return lambda state: {"disabled": effect(state, kind) is None}


def _room(value: Callable[[State], float], most: float) -> Callable[[State], dict[str, Any]]:
    """Ends of a slider that hold the value too."""
    return lambda state: {"end": max(most, float(value(state)))}


def _spinner(
    name: str, title: str, access: tuple[Any, Any], kind: EffectKind, **limits: Any
) -> Control:
    read, write = access
    widget = Spinner(
        name=name, title=title, step=0.1, width=80, sizing_mode="stretch_width", **limits
    )
    return Control(widget=widget, read=read, write=write, options=_is_off(kind))


def _slider(name: str, title: str, ends: tuple[float, float], step: float, **rest: Any) -> Slider:
    low, high = ends
    rest |= {"width": 100, "sizing_mode": "stretch_width"}
    return Slider(name=name, title=title, start=low, end=high, value=high, step=step, **rest)


def _select(name: str, title: str, options: list[Any]) -> Select:
    return Select(name=name, title=title, options=options, width=100, sizing_mode="stretch_width")


def _contact() -> dict[str, Control]:
    return {
        "law": Control(
            widget=_select("law", "Contact law", list(LAWS)),
            read=law_name, write=with_named_law,
        ),
        "friction": Control(
            widget=_slider("friction", "Coefficient of friction \u03bc", (0.0, 5.0), 0.01),
            read=coefficient, write=with_coefficient,
            options=lambda state: {
                "end": max(5.0, coefficient(state)),
                "disabled": law_name(state) != "Coulomb friction",
            },
        ),
        "shape": Control(
            widget=RadioButtonGroup(name="shape", labels=["Fence", "Finger"]),
            read=lambda state: list(Shape).index(state.shape), holds="active",
            write=lambda state, index: simulated(state, pusher_shape=list(Shape)[index].value),
        ),
    }  # fmt: skip


def _slider_controls() -> dict[str, Control]:
    names = {name: words(name) for name in gallery()}
    return {
        "support": Control(
            widget=_select("support", "Support", [*names.items(), (OWN, OWN)]),
            read=support_name, write=with_named_support,
            options=lambda state: {"disabled": effect(state, FRICTION) is None},
        ),
        "rod_length": Control(
            widget=_slider("rod_length", "Rod length", (0.0, 10.0), 0.01),
            read=lambda state: state.file.slider.rod_length,
            write=lambda state, value: with_rod(state, value, state.file.slider.rod_angle),
            options=_room(lambda state: state.file.slider.rod_length, 10.0),
        ),
        "rod_angle": Control(
            widget=_slider("rod_angle", "Rod angle (degrees)", ROD_ANGLES, 0.5),
            read=lambda state: state.file.slider.rod_angle,
            write=lambda state, value: with_rod(state, state.file.slider.rod_length, value),
        ),
        "size": Control(
            widget=_slider("size", "Size of the support", (0.1, 4.0), 0.01),
            read=lambda state: state.size, write=with_size, options=_room(lambda s: s.size, 4.0),
        ),
    }  # fmt: skip


def _effects() -> dict[str, Control]:
    weight, mass = number_of(FRICTION, "weight", 1.0), number_of(INERTIA, "mass", 1.0)
    gyration = number_of(INERTIA, "gyration_radius", 1.0)
    small = {"low": 0.001}
    return {
        "effects": Control(
            widget=CheckboxGroup(name="effects", labels=["Support friction", "Inertia"]),
            read=kinds, write=with_kinds, holds="active",
        ),
        "weight": _spinner("weight", "Friction W", weight, FRICTION, **small),
        "mass": _spinner("mass", "Mass m", mass, INERTIA, **small),
        "gyration": _spinner("gyration", "Radius of gyration", gyration, INERTIA, **small),
        "mass_x": _spinner("mass_x", "Centre of mass, x", center_of_mass(0), INERTIA),
        "mass_y": _spinner("mass_y", "Centre of mass, y", center_of_mass(1), INERTIA),
    }  # fmt: skip


def _push() -> dict[str, Control]:
    ends = float(np.log10(MAGNITUDES[0])), float(np.log10(MAGNITUDES[1]))
    return {
        "angle": Control(
            widget=_slider("angle", "Direction (degrees)", (-180.0, 180.0), 0.5),
            read=lambda state: state.angle,
            write=lambda state, value: pushed(state, value, state.magnitude),
        ),
        "magnitude": Control(
            widget=_slider(
                "magnitude", "Size, m a / W", ends, 0.01, format=CustomJSTickFormatter(code=POWER)
            ),
            read=size_of_push, write=with_size_of_push,
            options=lambda state: {"disabled": not magnitude_matters(state.scene)},
        ),
        "start": Control(
            widget=RadioButtonGroup(name="start", labels=["Moving at once", "From rest"]),
            read=lambda state: list(Start).index(state.start), holds="active",
            write=lambda state, index: replace(state, start=list(Start)[index], time=None),
            options=lambda state: {"disabled": not state.scene.stores_energy},
        ),
    }  # fmt: skip


def _views() -> dict[str, Control]:
    return {
        "across": Control(
            widget=_select("across", "Map over", ["friction"]),
            read=axis_of, write=lambda state, name: replace(state, across=name),
            options=lambda state: {"options": list(axes_of(state))},
        ),
        "duration": Control(
            widget=Spinner(
                name="duration", title="Duration", low=0.01, step=0.5, width=90,
                sizing_mode="stretch_width",
            ),
            read=lambda state: state.file.simulate.duration if state.file.simulate else 1.0,
            write=lambda state, value: simulated_again(state, duration=float(value)),
        ),
        "policy": Control(
            widget=_select(
                "policy", "Where several ways are consistent",
                [(each.value, each.value.replace("-", " ")) for each in Policy],
            ),
            read=first_policy,
            write=lambda state, value: simulated_again(state, on_ambiguity=value),
        ),
    }  # fmt: skip


def controls() -> dict[str, Control]:
    """All widgets that show a part of the state, by name."""
    return {**_contact(), **_slider_controls(), **_effects(), **_push(), **_views()}
