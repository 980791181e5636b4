"""What happens next: the push of a state followed over time, with every choice that was taken."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.explore.python_lines import acceleration, settings
from planar_pushing.explore.state import Start, State, first_policy, simulated
from planar_pushing.figures.motion.timeline import Run, plotted, runs
from planar_pushing.figures.motion.trajectory import box
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.solve import solve
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import Shape

#: Ways on that can be taken by hand, by the policies that prefer them.
WAYS = {
    "stick": "sticks",
    "slip-right": "slips to the right",
    "slip-left": "slips to the left",
    "separate": "breaks",
}


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
    options = settings(state)
    if state.start == Start.ACCELERATION:
        x, y = acceleration(state)
        shape = options["pusher"].shape
        options["pusher"] = Pusher(velocity=lambda time: (x * time, y * time), shape=shape)
    log = simulate(state.scene, **options)
    data = plotted(log)
    left, right, low, high = box(data)
    corners = np.array([(left, low), (right, high)])
    return Motion(log, data, data["time"].values, tuple(runs(data)), corners)


def row_at(motion: Motion, time: float) -> int:
    """Row of the log that holds at a time."""
    return int(
        np.clip(np.searchsorted(motion.times, time, side="right") - 1, 0, len(motion.times) - 1)
    )


def run_at(motion: Motion, time: float) -> Run:
    """The run of one mode that holds at a time."""
    row = row_at(motion, time)
    return next(each for each in reversed(motion.runs) if each.start <= row)


def ways_at(state: State, motion: Motion, time: float) -> tuple[str, ...]:
    """Ways on that are consistent at a time, where there are several.

    A slider with inertia is not at rest then, and a finger's side has turned: all ways are named, and one
    that is not consistent acts like the policy that keeps the contact.
    """
    if not run_at(motion, time).several:
        return ()
    scene = state.scene
    if scene.stores_energy or state.shape != Shape.FENCE or state.file.simulate is None:
        return tuple(WAYS)
    angle = np.deg2rad(motion.log["rod_angle"].values[row_at(motion, time)])
    push = next(each for each in reversed(state.file.simulate.pieces) if each.time <= time)
    there = replace(scene, slider=replace(scene.slider, rod_angle=float(angle)))
    modes = {str(each.mode.name) for each in solve(there, np.deg2rad(push.angle))}
    return tuple(way for way in WAYS if way.replace("-", "_").upper() in modes)


def taken(state: State, way: str) -> State:
    """The state in which a way is taken by hand at its time; choices behind it are void."""
    section = state.file.simulate
    time = round(state.time or 0.0, 9)
    before = [each.model_dump() for each in section.policies if each.time < time] if section else []
    return _with_policies(state, [*before, {"time": time, "policy": way}])


def forgotten(state: State) -> State:
    """The state without any choice by hand."""
    return _with_policies(state, first_policy(state))


def chosen(state: State) -> bool:
    """Whether a way was taken by hand."""
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
