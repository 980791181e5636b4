"""Lines of Python that compute what the page shows."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

from planar_pushing.explorer.state import Start, State
from planar_pushing.mechanics.outline.entries import outline_of_entry
from planar_pushing.scenes.simulate import arguments


def lines(state: State) -> str:
    """Program for the scene, its solutions and, if the file describes it, the motion over time."""
    return "\n".join([*_scene(state), *_solve(state), *_simulate(state)]) + "\n"


def _scene(state: State) -> Iterator[str]:
    slider = state.file.slider
    parts = [f"rod_length={slider.rod_length!r}", f"rod_angle=np.deg2rad({slider.rod_angle!r})"]
    parts += [f"radius={slider.radius!r}"] if slider.radius is not None else []
    parts += [f"side={code(slider.side)}"] if slider.side is not None else []
    parts += ["flush=True"] if slider.flush else []
    parts += [f"outline={outline_code(slider.outline)}"] if slider.outline is not None else []
    yield "import numpy as np"
    yield "import planar_pushing as pp"
    yield ""
    yield "scene = pp.Scene("
    yield f"    slider=pp.Slider({', '.join(parts)}),"
    yield f"    contact={code(state.scene.contact)},"
    yield f"    effects={code(state.scene.effects)},"
    for name in ("placement", "units"):
        if getattr(state.scene, name) is not None:
            yield f"    {name}={code(getattr(state.scene, name))},"
    yield ")"


def outline_code(entry: Any) -> str:
    """An outline in a file's form as an expression."""
    if not isinstance(entry, dict):
        return code(entry)
    return re.sub(r"\b(Outline|Disc)\b", r"pp.\1", repr(outline_of_entry(entry)))


def _solve(state: State) -> Iterator[str]:
    yield f"solutions = pp.solve(scene, np.deg2rad({state.angle!r}), {state.magnitude!r})"
    yield "print(solutions)"


def _simulate(state: State) -> Iterator[str]:
    """Lines for the pusher and for the motion over time with all choices made."""
    options = settings(state)
    pusher = options.pop("pusher")
    yield ""
    if state.start == Start.ACCELERATION:
        x, y = acceleration(state)
        yield "def velocity(time):"
        yield f"    return {x!r} * time, {y!r} * time"
        yield ""
        yield f"pusher = pp.Pusher(velocity=velocity, {_kind(pusher)})"
    else:
        pieces = [(time, tuple(velocity)) for time, velocity in pusher.pieces]
        yield f"pusher = pp.Pusher(velocity={code(pieces)}, {_kind(pusher)})"
    yield "log = pp.simulate("
    yield "    scene, pusher=pusher,"
    yield from (f"    {name}={code(value)}," for name, value in options.items())
    yield ")"


def _kind(pusher: Any) -> str:
    """Arguments for the shape of the pusher and for the radius of a finger."""
    radius = f", radius={pusher.radius!r}" if pusher.radius else ""
    return f"shape={str(pusher.shape)!r}{radius}"


def settings(state: State) -> dict[str, Any]:
    """Keyword arguments of `simulate` for the push that the page follows."""
    section = state.file.simulate
    options = arguments(section) if section else {}
    return {name: value for name, value in options.items() if value is not None}


def acceleration(state: State) -> tuple[float, float]:
    """Acceleration of a pusher that starts from rest."""
    angle = math.radians(state.angle)
    return state.magnitude * math.cos(angle), state.magnitude * math.sin(angle)


def code(value: Any) -> str:
    """A value as Python code with the public names of the package."""
    if is_dataclass(value) and not isinstance(value, type):
        names = [field.name for field in fields(value)]
        inner = ", ".join(f"{name}={code(getattr(value, name))}" for name in names)
        return f"pp.{type(value).__name__}({inner})"
    if isinstance(value, (tuple, list)):
        inner = ", ".join(map(code, value))
        inner += "," if isinstance(value, tuple) and len(value) == 1 else ""
        return f"({inner})" if isinstance(value, tuple) else f"[{inner}]"
    if isinstance(value, float) and not math.isfinite(value):
        return "-np.inf" if value < 0 else "np.inf"
    return repr(str(value)) if isinstance(value, str) else repr(value)
