"""Certified solutions of a push, as lists along `solution`."""

from __future__ import annotations

import math
from collections.abc import Sequence

from flint import arb, fmpq

from pulling_by_pushing.evidence.golden.cells.sliders import CENTERS, Record
from pulling_by_pushing.evidence.golden.numbers import (
    center,
    centers_of,
    spin_ratio,
)
from pulling_by_pushing.oracle.modes import (
    Solution,
)
from pulling_by_pushing.oracle.prove import Slider, State

#: Entries of a solution; `columns` converts them to lists along `solution`.
ENTRIES = (
    "mode", "force", "force_end", "twist", "contact_motion", "spin_ratio", "center", "pivot", "continuum",
)  # fmt: skip
NONE, CONSISTENT, PIVOTS, CONTINUUM = range(4)


def solutions(slider: Slider, modes: Sequence[Solution], size: fmpq | arb) -> Record:
    """The variables of the solutions of a push; `size` is the length of the spin ratio."""
    record = columns([solution(slider, mode, size) for mode in modes])
    return record | {CENTERS: centers_of(slider, [mode.motion for mode in modes])}


def solution(slider: Slider, mode: Solution, size: fmpq | arb) -> Record:
    """Values of one solution by the names of `ENTRIES`; those of rest without a motion."""
    entry: Record = {"mode": int(mode.mode), "continuum": mode.continuum}
    if mode.motion is None or mode.end is None:
        rest = {"force": [0.0, 0.0], "force_end": [0.0, 0.0], "contact_motion": [0.0, 0.0]}
        at_rest = {
            "twist": [0.0, 0.0, 0.0],
            "spin_ratio": 0.0,
            "center": [math.nan, math.nan],
            "pivot": -1,
        }
        return entry | rest | at_rest

    def parts(state: State) -> list[arb]:
        v = state.to_fence(state.u_x, state.u_y + state.omega * state.length)
        force, u = state.to_fence(state.f_x, state.f_y), state.to_fence(state.u_x, state.u_y)
        return [*force, *u, *v, state.omega]

    numbers = mode.motion.numbers(slider, parts)
    end = numbers if mode.end is mode.motion else mode.end.numbers(slider, parts)
    return entry | {
        "force": numbers[:2],
        "force_end": end[:2],
        "contact_motion": numbers[2:4],
        "twist": numbers[4:],
        "spin_ratio": spin_ratio(slider, mode.motion, size),
        "center": center(slider, mode.motion),
        "pivot": mode.motion.pivot,
    }


def columns(records: Sequence[Record]) -> Record:
    """Convert the solutions of a push to its variables, which are lists along `solution`."""
    status = CONSISTENT if records else NONE
    if any(entry["continuum"] for entry in records):
        status = CONTINUUM
    elif any(entry["pivot"] >= 0 for entry in records):
        status = PIVOTS
    counts = {"solutions": len(records), "status": status, "outcome": min(len(records), 2)}
    entries = {name: [entry[name] for entry in records] for name in ENTRIES}
    return counts | entries | {"consistent": [True] * len(records)}
