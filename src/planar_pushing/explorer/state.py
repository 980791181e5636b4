"""The state of the page, one immutable value, and the changes that the page makes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import Any

import numpy as np

from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.mechanics.force.rubbing import support_of
from planar_pushing.mechanics.scene import Scene
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.options import EffectKind, Policy, PusherFrame, Shape

#: Ranges of handles and widgets: magnitudes of a push in units of W / m, and rod angles in degrees.
MAGNITUDES = 0.01, 100.0
ROD_ANGLES = 1.0, 179.0
#: Smallest size of a support, in units of the sum of rod length and support size.
SMALLEST = 0.02
#: Default distance over which a push is followed, in units of the slider's length.
FOLLOWED = 0.8


class Handle(StrEnum):
    """The handles of the picture."""

    PUSHER = "pusher"
    ROD = "rod"
    SIZE = "size"
    LINE = "line of force"


class Start(StrEnum):
    """Start of the fence in a scene with inertia: already moving, or from rest."""

    VELOCITY = "velocity"
    ACCELERATION = "acceleration"


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """A scene file under a push, with the settings of the page; angles in degrees.

    The file always has the section `simulate`, and its first motion is the push. `shown` is the mode of the
    solution drawn in full, `across` the second axis of the map, `time` the instant that is followed, if
    any, and `handle` the handle that the keys move.
    """

    file: SceneFile
    angle: float = 90.0
    magnitude: float = 1.0
    start: Start = Start.VELOCITY
    shown: str = ""
    across: str = ""
    time: float | None = None
    handle: Handle = Handle.PUSHER

    @property
    def scene(self) -> Scene:
        return build(self.file)

    @property
    def shape(self) -> Shape:
        """Shape of the pusher: a fence or a finger."""
        return Shape(self.file.simulate.pusher_shape) if self.file.simulate else Shape.FENCE

    @property
    def flush(self) -> bool:
        """Whether a side of the slider lies on the fence."""
        return self.scene.slider.flush

    @property
    def finger_radius(self) -> float:
        """Radius of the finger; 0 for a point."""
        given = self.file.simulate
        return (given.pusher_radius or 0.0) if given else 0.0

    @property
    def duration(self) -> float:
        """Duration over which the push is followed."""
        return self.file.simulate.duration if self.file.simulate else 1.0

    @property
    def size(self) -> float:
        """Largest distance of the support from its center of pressure; the radius of a ring."""
        scene = self.scene
        if scene.isotropic or not scene.friction:
            return float(scene.slider.radius)
        return float(support_of(scene).extent)


@lru_cache(maxsize=64)
def build(file: SceneFile) -> Scene:
    """Scene of a file, cached because one picture needs it several times."""
    return file.build()


def state_of(file: SceneFile, angle: float | None = None, magnitude: float = 1.0) -> State:
    """Initial state of a scene file, under a given push or that of its section `simulate`."""
    file = _along_fence(file)
    if file.simulate is not None and angle is None:
        first = file.simulate.pieces[0]
        speed = first.speed or 1.0
        return State(file=file, angle=wrapped(first.angle), magnitude=speed)
    inert = build(file).stores_energy
    state = State(file=file, start=Start.ACCELERATION if inert else Start.VELOCITY)
    return pushed(state, 90.0 if angle is None else angle, magnitude)


def _along_fence(file: SceneFile) -> SceneFile:
    """File with waypoints and velocities in the world frame converted to velocities in the fence's."""
    given = file.simulate
    if given is None or (given.waypoints is None and given.pusher_frame == PusherFrame.FENCE):
        return file
    instead = {"pusher_angle": None, "pusher_speed": None, "waypoints": None, "pusher": file.pieces}
    own = given.model_copy(update=instead | {"pusher_frame": PusherFrame.FENCE.value})
    return file.model_copy(update={"simulate": own})


def wrapped(angle: float) -> float:
    """Equivalent direction in (-180, 180] degrees."""
    return 180.0 - (180.0 - angle) % 360.0


def changed(state: State, **parts: Any) -> State:
    """State with changed entries of its file, back at the push and without choices over time."""
    content = state.file.model_dump(exclude_none=True)
    if "simulate" in content:
        content["simulate"] |= {"on_ambiguity": first_policy(state)}
    content |= parts
    file = SceneFile.model_validate({k: v for k, v in content.items() if v is not None})
    return replace(state, file=file, time=None)


def pushed(state: State, angle: float, magnitude: float) -> State:
    """State under another push, which has a constant direction."""
    angle, magnitude = wrapped(angle), float(magnitude)
    given = state.file.simulate
    section = given.model_dump(exclude_none=True) if given else {}
    section.pop("pusher", None)
    section |= {"pusher_angle": angle, "pusher_speed": magnitude}
    section |= {"on_ambiguity": first_policy(state)}
    section.setdefault("duration", duration(state, magnitude))
    return replace(changed(state, simulate=section), angle=angle, magnitude=magnitude)


def first_policy(state: State) -> str:
    """Policy before any choice of the user."""
    section = state.file.simulate
    return str(section.policies[0].policy if section else Policy.KEEP_CONTACT)


def duration(state: State, magnitude: float) -> float:
    """Time in which the pusher covers the distance to follow, to two digits."""
    slider = state.scene.slider
    distance = FOLLOWED * (slider.rod_length + 2.0 * state.size)
    velocity = state.start == Start.VELOCITY
    found = distance / magnitude if velocity else math.sqrt(2.0 * distance / magnitude)
    return float(f"{found:.2g}")


def simulated(state: State, **options: Any) -> State:
    """State with other options of the simulation."""
    given = state.file.simulate
    section = given.model_dump(exclude_none=True) if given else {}
    return changed(state, simulate=section | options)


def with_rod(state: State, length: float, angle: float) -> State:
    """State with another rod."""
    angle = float(np.clip(angle, *ROD_ANGLES))
    rod = {"rod_length": max(float(length), 0.0), "rod_angle": angle}
    return changed(state, slider=_own_slider(state) | rod, placement=None)


def _own_slider(state: State) -> dict[str, Any]:
    """Slider without its outline, because its contact is no longer on the outline.

    A side that lies on the fence becomes a contact at the rod's end.
    """
    outline = {"outline", "flush", "side"} if state.flush else {"outline"}
    slider: dict[str, Any] = state.file.slider.model_dump(exclude_none=True, exclude=outline)
    return slider


def with_size(state: State, size: float) -> State:
    """State with a support of another size."""
    factor = max(size, SMALLEST * (state.size + state.file.slider.rod_length)) / state.size
    slider = _own_slider(state)
    if state.scene.isotropic or not state.scene.friction or "radius" in slider:
        slider["radius"] = factor * float(state.scene.slider.radius)
    effects = [_with_scaled_support(each, factor) for each in entries(state)]
    return changed(state, slider=slider, effects=effects, placement=None)


def _with_scaled_support(effect: dict[str, Any], factor: float) -> dict[str, Any]:
    if "support" not in effect:
        return effect
    return effect | {"support": scaled(effect["support"], factor)}


def with_law(state: State, law: dict[str, Any]) -> State:
    """State with another contact law, in the format of scene files."""
    return changed(state, contact=law)


def entries(state: State) -> list[dict[str, Any]]:
    """Effects in the format of scene files."""
    return [each.model_dump(exclude_none=True) for each in state.file.effects]


def effect(state: State, kind: EffectKind) -> dict[str, Any] | None:
    """First effect of a kind; None if there is none."""
    found = [each for each in entries(state) if EFFECTS[each["type"]].kind == kind]
    return found[0] if found else None


def with_effect(state: State, kind: EffectKind, entry: dict[str, Any] | None) -> State:
    """State with another effect of a kind, or without such an effect."""
    others = [each for each in entries(state) if EFFECTS[each["type"]].kind != kind]
    effects = [entry, *others] if kind == EffectKind.SUPPORT_FRICTION else [*others, entry]
    found = changed(state, effects=[each for each in effects if each is not None])
    start = Start.ACCELERATION if found.scene.stores_energy else Start.VELOCITY
    same = found.scene.stores_energy == state.scene.stores_energy
    return found if same else replace(found, start=start)


def with_support(state: State, support: dict[str, Any] | None) -> State:
    """State with another support of the same size; None is a ring with the slider's radius."""
    given = effect(state, EffectKind.SUPPORT_FRICTION) or {"weight": 1.0}
    slider = _own_slider(state)
    if support is None:
        friction = {"type": "ring_friction", "weight": given["weight"]}
        slider["radius"] = state.size
    else:
        own = scaled(support, state.size)
        friction = {"type": "support_friction", "weight": given["weight"], "support": own}
        slider.pop("radius", None)
    return with_effect(
        changed(state, slider=slider, placement=None), EffectKind.SUPPORT_FRICTION, friction
    )


#: Keys of a support with lengths as values.
LENGTHS = frozenset(
    (
        "radius",
        "inner",
        "outer",
        "center",
        "start",
        "end",
        "positions",
        "vertices",
        "holes",
        "x",
        "y",
    )
)
#: Relative tolerance for equal sizes.
ROUNDING = 1e-9


def scaled(entry: dict[str, Any], factor: float) -> dict[str, Any]:
    """Support enlarged by a factor."""
    found = {key: _times(each, factor) if key in LENGTHS else each for key, each in entry.items()}
    if "members" in entry:
        found["members"] = [
            {**each, "support": scaled(each["support"], factor)} for each in entry["members"]
        ]
    return found


def _times(given: Any, factor: float) -> Any:
    if isinstance(given, (list, tuple)):
        return [_times(each, factor) for each in given]
    return given * factor


def name_in(gallery: dict[str, Any], entry: dict[str, Any] | None, size: float) -> str:
    """Name of a support in the gallery, which has supports of size 1; empty if it is not there."""
    if entry is None:
        return "ring"
    own = scaled(entry, 1.0 / size)
    return next((name for name, each in gallery.items() if _alike(own, each)), "")


def _alike(one: Any, other: Any) -> bool:
    """Whether two supports are equal up to rounding."""
    if isinstance(one, dict):
        kept = {key for key, each in one.items() if not _is_origin(key, each)}
        kin = {key for key, each in other.items() if not _is_origin(key, each)}
        return kept == kin and all(_alike(one[key], other[key]) for key in kept)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(_alike, one, other))
    if isinstance(one, str):
        return bool(one == other)
    return bool(np.isclose(one, other, rtol=ROUNDING, atol=ROUNDING))


def _is_origin(key: str, given: Any) -> bool:
    """Whether a key only states the default, that the support is centered at the origin."""
    return key == "center" and not any(given)
