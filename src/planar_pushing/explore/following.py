"""What happens next: the push of a state followed over time, with every choice of the user."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.explore.python_lines import acceleration, settings
from planar_pushing.explore.state import Start, State, first_policy, simulated
from planar_pushing.explore.words import NUMBERS
from planar_pushing.figures.motion.timeline import Run, plotted, runs
from planar_pushing.figures.motion.trajectory import box
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate

#: Contact modes that the user can choose, by the policies that prefer them.
WAYS = {
    "stick": "sticks",
    "slip-right": "slips to the right",
    "slip-left": "slips to the left",
    "separate": "breaks",
}
#: What the contact does at an instant, by its mode.
DOES = {
    -1: "no motion is consistent",
    ContactMode.SEPARATE: "the contact is broken",
    ContactMode.STICK: "the contact sticks",
    ContactMode.SLIP_RIGHT: "the slider slips to the right",
    ContactMode.SLIP_LEFT: "the slider slips to the left",
}
#: Part of the duration after which a motion has gone on in the way that was taken.
SHORTLY = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """A log, and what is plotted of it."""

    log: xr.Dataset
    data: xr.Dataset
    times: Array
    runs: tuple[Run, ...]
    bounds: Array


def followed(state: State) -> Motion:
    """Simulate the push of a state."""
    log = simulate(state.scene, **_options(state))
    data = plotted(log)
    left, right, low, high = box(data)
    corners = np.array([(left, low), (right, high)])
    return Motion(log, data, data["time"].values, tuple(runs(data)), corners)


def _options(state: State) -> dict[str, Any]:
    """Arguments of the simulation of a state's push."""
    options = settings(state)
    if state.start == Start.ACCELERATION:
        x, y = acceleration(state)
        shape = options["pusher"].shape
        options["pusher"] = Pusher(velocity=lambda time: (x * time, y * time), shape=shape)
    return options


def row_at(motion: Motion, time: float) -> int:
    """Row of the log that holds at a time."""
    return int(
        np.clip(np.searchsorted(motion.times, time, side="right") - 1, 0, len(motion.times) - 1)
    )


def run_at(motion: Motion, time: float) -> Run:
    """The run of one mode that holds at a time."""
    row = row_at(motion, time)
    return next(each for each in reversed(motion.runs) if each.start <= row)


def said_at(motion: Motion, time: float) -> str:
    """What the contact does at a time, in a sentence."""
    row, data = row_at(motion, time), motion.data
    mode, count = (int(data[f"path_{name}"].values[row]) for name in ("mode", "solutions"))
    more = "" if count < 2 else f", one of {NUMBERS[count]} consistent ways"
    return f"At time {time:.3f} {DOES[mode]}{more}."


def ways_at(state: State, motion: Motion, time: float) -> tuple[str, ...]:
    """Contact modes that are consistent at a time, where there are several.

    The simulation says so: a policy that prefers a mode takes it wherever it is consistent.
    """
    if not run_at(motion, time).several:
        return ()
    return tuple(way for way in WAYS if _is_consistent(replace(state, time=time), way))


def _is_consistent(state: State, way: str) -> bool:
    """Whether the motion goes on in a way that is preferred from the state's time on."""
    options = _options(taken(state, way))
    shortly = (state.time or 0.0) + SHORTLY * options["duration"]
    log = simulate(state.scene, **options | {"duration": shortly, "samples": 2})
    mode = ContactMode(log["mode"].values[-1])
    return str(mode.name) == way.replace("-", "_").upper()


def taken(state: State, way: str) -> State:
    """The state in which a mode is chosen at its time; later choices are dropped."""
    section = state.file.simulate
    time = round(state.time or 0.0, 9)
    before = [each.model_dump() for each in section.policies if each.time < time] if section else []
    return _with_policies(state, [*before, {"time": time, "policy": way}])


def forgotten(state: State) -> State:
    """The state without choices of the user."""
    return _with_policies(state, first_policy(state))


def chosen(state: State) -> bool:
    """Whether the user chose a mode."""
    section = state.file.simulate
    return section is not None and len(section.policies) > 1


def _with_policies(state: State, policies: Any) -> State:
    """The state with other policies, followed at the same time."""
    return replace(simulated(state, on_ambiguity=policies), time=state.time)


def energies(motion: Motion) -> dict[str, Any]:
    """Work and where it went, over time."""
    log = motion.log
    return {
        "work": log["work"].values,
        "support friction": log["dissipated"].sum("effect").values,
        "contact friction": log["contact_dissipated"].values,
        "kinetic energy": log["kinetic_energy"].values,
    }
