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
from planar_pushing.scenes.contacts_model import ContactsFile
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
    CONTACT = "contact"
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
    any, `handle` the handle that the keys move, and `unit` the unit in which lengths are shown, empty for
    that of the scene. A scene with several contacts is `several`; the file is then that of the first
    contact alone.
    """

    file: SceneFile
    angle: float = 90.0
    magnitude: float = 1.0
    start: Start = Start.VELOCITY
    shown: str = ""
    across: str = ""
    time: float | None = None
    handle: Handle = Handle.PUSHER
    unit: str = ""
    several: ContactsFile | None = None

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
    def has_outline(self) -> bool:
        """Whether the outline of the object is known, along which its contact moves."""
        return self.file.slider.outline is not None

    @property
    def finger_radius(self) -> float:
        """Radius of the finger; 0 for a point."""
        section = self.file.simulate
        return (section.pusher_radius or 0.0) if section else 0.0

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
        return State(file=file, angle=wrap_angle(first.angle), magnitude=speed)
    inert = build(file).stores_energy
    state = State(file=file, start=Start.ACCELERATION if inert else Start.VELOCITY)
    return with_push(state, 90.0 if angle is None else angle, magnitude)


def _along_fence(file: SceneFile) -> SceneFile:
    """File with waypoints and velocities in the world frame converted to velocities in the fence's."""
    section = file.simulate
    if section is None or (section.waypoints is None and section.pusher_frame == PusherFrame.FENCE):
        return file
    entries = {"pusher_angle": None, "pusher_speed": None, "waypoints": None, "pusher": file.pieces}
    section = section.model_copy(update=entries | {"pusher_frame": PusherFrame.FENCE.value})
    return file.model_copy(update={"simulate": section})


def wrap_angle(angle: float) -> float:
    """Equivalent direction in (-180, 180] degrees."""
    return 180.0 - (180.0 - angle) % 360.0


def without_display(state: State) -> State:
    """State without what is only shown: the time, the handle, the solution, the map, and the unit."""
    return replace(state, time=None, handle=Handle.PUSHER, shown="", across="", unit="")


def with_entries(state: State, **parts: Any) -> State:
    """State with changed entries of its file, back at the push and without choices over time."""
    content = state.file.model_dump(exclude_none=True)
    if "simulate" in content:
        content["simulate"] |= {"on_ambiguity": first_policy(state)}
    content |= parts
    file = SceneFile.model_validate({k: v for k, v in content.items() if v is not None})
    return replace(state, file=file, time=None)


def with_push(state: State, angle: float, magnitude: float) -> State:
    """State under another push, which has a constant direction."""
    angle, magnitude = wrap_angle(angle), float(magnitude)
    section = simulate_entries(state)
    section.pop("pusher", None)
    section |= {"pusher_angle": angle, "pusher_speed": magnitude}
    section |= {"on_ambiguity": first_policy(state)}
    section.setdefault("duration", duration(state, magnitude))
    return replace(with_entries(state, simulate=section), angle=angle, magnitude=magnitude)


def first_policy(state: State) -> str:
    """Policy before any choice of the user."""
    section = state.file.simulate
    return str(section.policies[0].policy if section else Policy.KEEP_CONTACT)


def duration(state: State, magnitude: float) -> float:
    """Time in which the pusher covers the distance to follow, to two digits."""
    slider = state.scene.slider
    distance = FOLLOWED * (slider.rod_length + 2.0 * state.size)
    velocity = state.start == Start.VELOCITY
    time = distance / magnitude if velocity else math.sqrt(2.0 * distance / magnitude)
    return float(f"{time:.2g}")


def simulate_entries(state: State) -> dict[str, Any]:
    """Entries of the section `simulate`."""
    section = state.file.simulate
    return section.model_dump(exclude_none=True) if section else {}


def with_simulation(state: State, **options: Any) -> State:
    """State with other options of the simulation."""
    section = simulate_entries(state)
    return with_entries(state, simulate=section | options)


def with_rod(state: State, length: float, angle: float) -> State:
    """State with another rod."""
    angle = float(np.clip(angle, *ROD_ANGLES))
    rod = {"rod_length": max(float(length), 0.0), "rod_angle": angle}
    return with_entries(state, slider=_own_slider(state) | rod, placement=None)


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
    effects = [_with_scaled_support(effect, factor) for effect in entries(state)]
    return with_entries(state, slider=slider, effects=effects, placement=None)


def _with_scaled_support(effect: dict[str, Any], factor: float) -> dict[str, Any]:
    if "support" not in effect:
        return effect
    return effect | {"support": scale_support(effect["support"], factor)}


def with_law(state: State, law: dict[str, Any]) -> State:
    """State with another contact law, in the format of scene files."""
    return with_entries(state, contact=law)


def entries(state: State) -> list[dict[str, Any]]:
    """Effects in the format of scene files."""
    return [effect.model_dump(exclude_none=True) for effect in state.file.effects]


def effect(state: State, kind: EffectKind) -> dict[str, Any] | None:
    """First effect of a kind; None if there is none."""
    matches = (entry for entry in entries(state) if EFFECTS[entry["type"]].kind == kind)
    return next(matches, None)


def with_effect(state: State, kind: EffectKind, entry: dict[str, Any] | None) -> State:
    """State with another effect of a kind, or without such an effect."""
    others = [other for other in entries(state) if EFFECTS[other["type"]].kind != kind]
    effects = [entry, *others] if kind == EffectKind.SUPPORT_FRICTION else [*others, entry]
    changed = with_entries(state, effects=[effect for effect in effects if effect is not None])
    start = Start.ACCELERATION if changed.scene.stores_energy else Start.VELOCITY
    same = changed.scene.stores_energy == state.scene.stores_energy
    return changed if same else replace(changed, start=start)


def with_support(state: State, support: dict[str, Any] | None) -> State:
    """State with another support of the same size; None is a ring with the slider's radius."""
    current = effect(state, EffectKind.SUPPORT_FRICTION) or {"weight": 1.0}
    slider = _own_slider(state)
    if support is None:
        friction = {"type": "ring_friction", "weight": current["weight"]}
        slider["radius"] = state.size
    else:
        friction = {
            "type": "support_friction",
            "weight": current["weight"],
            "support": scale_support(support, state.size),
        }
        slider.pop("radius", None)
    return with_effect(
        with_entries(state, slider=slider, placement=None), EffectKind.SUPPORT_FRICTION, friction
    )


#: Keys of a support with lengths as values.
LENGTHS = frozenset(
    (
        "radius",
        "inner",
        "outer",
        "center",
        "origin",
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


def scale_support(entry: dict[str, Any], factor: float) -> dict[str, Any]:
    """Support enlarged by a factor."""
    enlarged = {
        key: _scale(value, factor) if key in LENGTHS else value for key, value in entry.items()
    }
    if "members" in entry:
        enlarged["members"] = [
            {**member, "support": scale_support(member["support"], factor)}
            for member in entry["members"]
        ]
    return enlarged


def _scale(lengths: Any, factor: float) -> Any:
    if isinstance(lengths, (list, tuple)):
        return [_scale(length, factor) for length in lengths]
    return lengths * factor


def name_in(gallery: dict[str, Any], entry: dict[str, Any] | None, size: float) -> str:
    """Name of a support in the gallery, which has supports of size 1; empty if it is not there."""
    if entry is None:
        return "ring"
    unit = scale_support(entry, 1.0 / size)
    return next((name for name, support in gallery.items() if _alike(unit, support)), "")


def _alike(one: Any, other: Any) -> bool:
    """Whether two supports are equal up to rounding."""
    if isinstance(one, dict):
        keys, other_keys = _keys_beyond_origin(one), _keys_beyond_origin(other)
        return keys == other_keys and all(_alike(one[key], other[key]) for key in keys)
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(map(_alike, one, other))
    if isinstance(one, str):
        return bool(one == other)
    return bool(np.isclose(one, other, rtol=ROUNDING, atol=ROUNDING))


def _keys_beyond_origin(entry: dict[str, Any]) -> set[str]:
    """Keys of a support, without a center at the origin, which is the default."""
    return {key for key, value in entry.items() if key != "center" or any(value)}
