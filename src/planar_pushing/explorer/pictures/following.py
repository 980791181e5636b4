"""The motion over time: the simulated push of a state, with the choices of the user."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.drawing.motion import box
from planar_pushing.drawing.timeline import (
    Run,
    contact,
    is_at_first_contact,
    path_data,
    runs,
    side_on_fence,
)
from planar_pushing.drawing.words import NUMBERS
from planar_pushing.explorer.python_lines import acceleration, settings
from planar_pushing.explorer.state import (
    Start,
    State,
    first_policy,
    with_entries,
    with_simulation,
    without_display,
    wrap_angle,
)
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.solutions import Solution
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import Shape

#: Contact modes that the user can choose, by the policy that prefers each.
CHOICES = {
    "stick": "sticks",
    "slip-right": "slips to the right",
    "slip-left": "slips to the left",
    "separate": "breaks",
}
#: Behavior of the contact at an instant, by its mode.
DOES = {
    -1: "no motion is consistent",
    ContactMode.SEPARATE: "the contact is broken",
    ContactMode.STICK: "the contact sticks",
    ContactMode.SLIP_RIGHT: "the slider slips to the right",
    ContactMode.SLIP_LEFT: "the slider slips to the left",
}
#: The same of a side that lies on the fence.
FLUSH = {
    ContactMode.STICK: "the side is flush and sticks",
    ContactMode.SLIP_RIGHT: "the side slips to the right, flush",
    ContactMode.SLIP_LEFT: "the side slips to the left, flush",
}
#: Fraction of the duration after which the mode of a motion is compared with the chosen mode.
SHORTLY = 1e-6
#: A side on the fence whose rod turned by more, degrees, is another one.
SAME_SIDE = 1e-3
#: A larger gap, in units of the slider's size, means no contact.
CLOSED = 1e-6


class FollowedMotion(NamedTuple):
    """A log, its plotted data, its times, its runs of one mode, and the box around the motion."""

    log: xr.Dataset
    data: xr.Dataset
    times: Array
    runs: tuple[Run, ...]
    box: Array


def follow(state: State) -> FollowedMotion:
    """Simulate the push of a state."""
    return _simulate_push(without_display(state))


@lru_cache(maxsize=4)
def _simulate_push(state: State) -> FollowedMotion:
    log = quietly(simulate)(state.scene, **_options(state))
    data = path_data(log)
    return FollowedMotion(log, data, data["time"].values, tuple(runs(data)), box(data))


def _options(state: State) -> dict[str, Any]:
    """Arguments for simulating the push of a state."""
    options = settings(state)
    if state.start == Start.ACCELERATION:
        x, y = acceleration(state)
        pusher = options["pusher"]
        options["pusher"] = Pusher(
            velocity=lambda time: (x * time, y * time), shape=pusher.shape, radius=pusher.radius
        )
    return options


def row_at(motion: FollowedMotion, time: float) -> int:
    """Row of the log at a time."""
    return int(
        np.clip(np.searchsorted(motion.times, time, side="right") - 1, 0, len(motion.times) - 1)
    )


def push_at(state: State, motion: FollowedMotion, time: float) -> State | None:
    """Push at an instant as a state; None if the motion there is not that of a single push.

    There is none with inertia, because the motion depends on its past; with a finger, because the side has
    turned; with a broken contact; with a fence at rest; and with another contact than that of the state.
    """
    row, section = row_at(motion, time), state.file.simulate
    gap = float(motion.data["path_gap"].values[row])
    if section is None or state.shape != Shape.FENCE or state.scene.stores_energy:
        return None
    if not is_at_first_contact(motion.data, row):
        return None
    piece = [piece for piece in section.pieces if piece.time <= motion.times[row]][-1]
    angle = float(motion.data["path_rod_angle"].values[row])
    if state.flush and abs(angle - state.file.slider.rod_angle) > SAME_SIDE:
        return None
    if not piece.speed or gap > CLOSED * state.size or not 0.0 < angle < 180.0:
        return None
    slider = state.file.slider.model_dump(exclude_none=True) | {"rod_angle": angle}
    mode = int(motion.data["path_mode"].values[row])
    turned = with_entries(state, slider=slider)
    name = ContactMode(mode).name if mode >= 0 else ""
    return replace(turned, angle=wrap_angle(piece.angle), magnitude=piece.speed, shown=name)


def solution_at(state: State, motion: FollowedMotion, time: float) -> tuple[Solution, Array] | None:
    """The motion at a time as a solution, and the velocity of the contact minus its slip.

    None if no motion is consistent.
    """
    row, log = row_at(motion, time), motion.log
    if (mode := int(log["mode"].values[row])) < 0:
        return None
    twist, force, position = (log[name].values[row] for name in ("twist", "force", "position"))
    touch = contact(motion.data)[row]
    x, y = touch - position
    velocity = twist[:2] + twist[2] * np.array([-y, x])
    turned = np.deg2rad(log["rod_angle"].values[row] - log["rod_angle"].values[0])
    along = direction(turned if state.shape == Shape.FINGER else 0.0)
    slip = float(along @ (velocity - _pusher_velocity(state, motion.times[row])))
    solution = Solution(
        mode=ContactMode(mode), force=force, force_end=force, contact_motion=velocity, twist=twist,
        spin_ratio=float(log["spin_ratio"].values[row]),
        center=motion.data["path_center"].values[row] - touch, pivot=int(log["pivot"].values[row]),
        continuum=False, **_on_side(motion, row),
    )  # fmt: skip
    return solution, velocity - [slip, 0.0]


def _on_side(motion: FollowedMotion, row: int) -> dict[str, Any]:
    """Position of the force on a side that lies on the fence at a row, from the side's midpoint."""
    side = side_on_fence(motion.data, row)
    if side is None:
        return {}
    return {
        "flush": True,
        "force_position": float(contact(motion.data)[row, 0] - side[:, 0].mean()),
    }


def _pusher_velocity(state: State, time: float) -> Array:
    if state.start == Start.ACCELERATION:
        return time * np.array(acceleration(state))
    pieces = settings(state)["pusher"].pieces
    return np.array([velocity for start, velocity in pieces if start <= time][-1])


def run_at(motion: FollowedMotion, time: float) -> Run:
    """Run of one mode at a time."""
    row = row_at(motion, time)
    return next(run for run in reversed(motion.runs) if run.start <= row)


def sentence_at(motion: FollowedMotion, time: float) -> str:
    """Sentence on the contact at a time."""
    row, data = row_at(motion, time), motion.data
    mode, count = (int(data[f"path_{name}"].values[row]) for name in ("mode", "solutions"))
    flush = "path_flush" in data and bool(data["path_flush"].values[row])
    does = (DOES | FLUSH if flush else DOES)[mode]
    more = "" if count < 2 else f", one of {NUMBERS[count]} consistent solutions"
    return f"At time {time:.3f} {does}{more}."


def choices_at(state: State, motion: FollowedMotion, time: float) -> tuple[str, ...]:
    """Consistent contact modes at a time; empty unless there are several.

    They are found by simulation: a policy that prefers a mode takes it whenever it is consistent.
    """
    if not run_at(motion, time).several:
        return ()
    return tuple(policy for policy in CHOICES if _is_consistent(replace(state, time=time), policy))


def _is_consistent(state: State, policy: str) -> bool:
    """Whether the motion continues in a mode that is preferred from the state's time onward."""
    options = _options(with_choice(state, policy))
    shortly = (state.time or 0.0) + SHORTLY * options["duration"]
    log = quietly(simulate)(state.scene, **options | {"duration": shortly, "samples": 2})
    mode = ContactMode(log["mode"].values[-1])
    return str(mode.name) == policy.replace("-", "_").upper()


def with_choice(state: State, policy: str) -> State:
    """State with a mode chosen at its time; later choices are discarded."""
    section = state.file.simulate
    time = round(state.time or 0.0, 9)
    before = (
        [choice.model_dump() for choice in section.policies if choice.time < time]
        if section
        else []
    )
    return _with_policies(state, [*before, {"time": time, "policy": policy}])


def without_choices(state: State) -> State:
    """State without choices of the user."""
    return _with_policies(state, first_policy(state))


def has_choices(state: State) -> bool:
    """Whether the user chose a mode."""
    section = state.file.simulate
    return section is not None and len(section.policies) > 1


def _with_policies(state: State, policies: Any) -> State:
    """State with other policies at the same time."""
    return replace(with_simulation(state, on_ambiguity=policies), time=state.time)


def energies(motion: FollowedMotion) -> dict[str, Any]:
    """Work and its distribution over time."""
    log = motion.log
    return {
        "work": log["work"].values,
        "support friction": log["dissipated"].sum("effect").values,
        "contact friction": log["contact_dissipated"].values,
        "kinetic energy": log["kinetic_energy"].values,
    }
