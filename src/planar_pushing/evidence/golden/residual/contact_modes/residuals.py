"""Findings of every variable of the contact modes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.certified.doubled.numbers import Doubled, Floats
from planar_pushing.evidence.golden.residual.contact_modes.push import (
    MODES,
    SLIPS,
    Decision,
    Flags,
    Pushes,
    pushes,
)
from planar_pushing.evidence.golden.residual.contact_modes.slipping import (
    Edge,
    edge_of,
    slips,
    steady_slips,
    steady_spin,
)
from planar_pushing.evidence.golden.residual.contact_modes.sticking import sticking, sticks
from planar_pushing.evidence.golden.residual.finding import DEGREE, EPSILON, Finding, same
from planar_pushing.evidence.golden.residual.grids import over_effects
from planar_pushing.evidence.golden.residual.motion import Slider
from planar_pushing.study.files.study_model import StudyFile
from planar_pushing.terms.options import EffectSet

#: Roundings of a spin ratio or a balance of torques, and of an angle in radians.
SPIN, ANGLE = 64, 32
#: Slowest and fastest motion of each mode.
ENDS = ("", "_fast")


class Table(NamedTuple):
    """Values of a variable over contact, push and mode, their errors, and what is allowed."""

    values: Floats
    error: Floats
    allowed: Floats

    def put(self, mode: str, here: Flags, error: Any, allowed: Any) -> None:
        """Set the errors of a mode where it is consistent."""
        place = MODES.index(mode)
        for part, given in ((self.error, error), (self.allowed, allowed)):
            part[..., place] = np.where(here, given, part[..., place])


def residuals(dataset: xr.Dataset, study: StudyFile) -> Iterable[Finding]:
    """Findings of every variable."""
    return over_effects(_part, dataset, study)


def _part(dataset: xr.Dataset, effects: str, slider: Slider, study: StudyFile) -> Iterable[Finding]:
    given, counts = pushes(dataset, study), dataset["consistent"].values
    tables = {
        f"{name}{end}": _without_solution(dataset[f"{name}{end}"].values, counts)
        for name in ("spin_ratio", "force_angle")
        for end in ENDS
    }
    wrong = [_separates(given, counts), _sticks(effects, given, counts, tables)]
    wrong += [_slips(effects, given, counts, tables, mode) for mode in SLIPS]
    every = np.stack([np.broadcast_to(each, counts.shape[:-1]) for each in wrong], axis=-1)
    yield Finding("consistent", np.where(every, np.inf, 0.0), 0.0)
    yield same("outcome", dataset["outcome"].values, np.minimum(counts.sum(axis=-1), 2))
    for name, table in tables.items():
        yield Finding(name, table.error, table.allowed)


def _without_solution(values: Floats, counts: Any) -> Table:
    """A mode without a solution holds NaN, and separation zero: it has neither force nor motion."""
    table = Table(values, np.zeros(values.shape), np.zeros(values.shape))
    rests = np.arange(len(MODES)) == MODES.index("SEPARATE")
    table.error[np.isnan(values) != (counts == 0)] = np.inf
    table.error[(counts > 0) & rests & (values != 0)] = np.inf
    return table


def _contradicts(counts: Any, decision: Decision) -> Flags:
    """Where a mode is and should not be, or the other way about, or is there twice."""
    differs = ((counts == 1) != decision.consistent) & ~decision.open
    return np.asarray(differs | (counts > 1) | (counts < 0))


def _separates(given: Pushes, counts: Any) -> Flags:
    """The slider stays behind where the fence does not move into it."""
    away = given.y.high <= 0
    return _contradicts(counts[..., 0], Decision(away, np.zeros_like(away)))


def _sticks(effects: str, given: Pushes, counts: Any, tables: dict[str, Table]) -> Flags:
    """Sticking motions: that of the perfectly rough contact, and those of the others equal to it."""
    row, place = int(np.argmax(given.rough)), MODES.index("STICK")
    here = counts[..., place] > 0
    for end in ENDS:
        spin, angle = (tables[f"{name}{end}"] for name in ("spin_ratio", "force_angle"))
        k, phi = (table.values[row, ..., place] for table in (spin, angle))
        found = sticking(effects, given, k, phi)
        size = np.where(k == 0, 1.0, np.abs(k))
        apart = np.abs(spin.values[..., place] - k) / size
        spin.put("STICK", here, np.maximum(apart, found.spin_error), SPIN * EPSILON)
        error = np.maximum(np.abs(angle.values[..., place] - phi), found.angle_error * DEGREE)
        angle.put("STICK", here, error, ANGLE * EPSILON * DEGREE)
    return _contradicts(counts[..., place], sticks(given, found.x, found.y))


def _slips(effects: str, given: Pushes, counts: Any, tables: dict[str, Table], mode: str) -> Flags:
    lines, here = edge_of(given, SLIPS[mode]), counts[..., MODES.index(mode)] > 0
    _edge_angles(lines, here, tables, mode)
    if effects == EffectSet.BOTH:
        return _slips_of_both(given, lines, counts[..., MODES.index(mode)], tables, mode)
    k = steady_spin(effects, given, lines)
    for end in ENDS:
        table, wanted = tables[f"spin_ratio{end}"], k.value()
        error = np.abs(table.values[..., MODES.index(mode)] - wanted)
        table.put(
            mode, here, error, SPIN * EPSILON * (np.abs(wanted) + given.length * (wanted != 0))
        )
    decision = steady_slips(given, lines, k, SLIPS[mode])
    return _contradicts(counts[..., MODES.index(mode)], decision)


def _edge_angles(lines: Edge, here: Flags, tables: dict[str, Table], mode: str) -> None:
    """The force is on the edge."""
    wanted = np.rad2deg(np.arctan2(lines.y.high, lines.x.high))
    for end in ENDS:
        table = tables[f"force_angle{end}"]
        error = np.abs(table.values[..., MODES.index(mode)] - wanted)
        table.put(mode, here, error, ANGLE * EPSILON * DEGREE)


def _slips_of_both(
    given: Pushes, lines: Edge, counts: Any, tables: dict[str, Table], mode: str
) -> Flags:
    """Every slip solves its equation; where there are several, the slowest and the fastest differ."""
    here, wrong = counts > 0, (counts < 0) | ((counts > 0) & ~given.slips)
    at = lines.over(here.shape, here)
    push = [_spread(part * given.magnitude, here) for part in (given.x, given.y)]
    for end in ENDS:
        table = tables[f"spin_ratio{end}"]
        k = table.values[..., MODES.index(mode)][here]
        found = slips(given, at, k, (push[0], push[1]), SLIPS[mode])
        errors = np.zeros(here.shape)
        errors[here] = np.where(found.goes, found.error, np.inf)
        table.put(mode, here, errors, SPIN * EPSILON)
    slow, fast = (tables[f"spin_ratio{end}"].values[..., MODES.index(mode)] for end in ENDS)
    return np.asarray(wrong | (here & ((counts == 1) != (slow == fast))))


def _spread(number: Doubled, here: Flags) -> Doubled:
    return Doubled(*(np.broadcast_to(part, here.shape)[here] for part in (number.high, number.low)))
