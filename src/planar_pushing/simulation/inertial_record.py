"""The record of a slider with inertia."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from planar_pushing.simulation.mode import Entry, Mode, State
from planar_pushing.simulation.record import NO_MODE, Record, spin_ratio

if TYPE_CHECKING:
    from planar_pushing.simulation.inertial import Inertial


def record(
    system: Inertial, time: float, state: State, mode: Mode | None, solutions: int
) -> Record:
    """What is logged of a slider with inertia."""
    now = system.instant(time, state, (0.0, 0.0, 0.0))
    along, gap, psi, fence_x, fence_y, slip, contact, work = state[: len(Entry)]
    dissipated, spin = state[len(Entry) : system.at], state[system.at + 2]
    reach = system.setting.length * system.setting.radius
    rubbing = iter(dissipated)
    effects = system.problem.scene.effects
    evaluations = {1: system.support.evaluations if system.support else 0, 2: system.instants}
    return Record(
        time=time,
        position=(
            fence_x + along + reach * math.cos(psi),
            fence_y + gap + reach * math.sin(psi),
        ),
        rod_angle=psi,
        twist=(*now.velocity, spin),
        fence=(fence_x, fence_y),
        slip=slip,
        gap=gap,
        force=mode.force(time, state) if mode else (0.0, 0.0),
        mode=NO_MODE if mode is None else int(mode.kind),
        solutions=solutions,
        spin_ratio=spin_ratio(spin, math.hypot(*now.velocity)),
        dissipated=tuple(next(rubbing) if e.degree == 1 else 0.0 for e in effects),
        contact_dissipated=contact,
        work=work,
        kinetic_energy=system.kinetic_energy(time, state),
        evaluations=tuple(evaluations[effect.degree] for effect in effects),
    )
