"""Where a mode ends: guards followed along the dense output of each step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

from scipy.integrate import DenseOutput
from scipy.optimize import brentq, minimize_scalar

from planar_pushing.simulation.mode import SLACK, Cause, Mode

#: Parts of a step at which the guards are looked at; its end is one of them.
NODES = (0.25, 0.5, 0.75, 1.0)
#: Halvings that look for the moment in which a margin that starts at zero is positive.
HALVINGS = 20


class Misjudged(Exception):
    """The mode does not hold even for a moment."""


@dataclass(slots=True)
class Watcher:
    """The guards of one mode from its start on.

    Attributes
    ----------
    signs : list of float
        For a watch its sign when it was first away from zero; for a margin 1 once it was positive.
        Zero until then.
    """

    mode: Mode
    time: float
    values: list[float] = field(init=False)
    signs: list[float] = field(init=False)
    causes: list[Cause] = field(init=False)
    watches: list[bool] = field(init=False)

    def start(self, state: list[float]) -> None:
        """Look at the guards at the start of the mode."""
        guards = self.mode.guards(self.time, state)
        self.causes = [guard.cause for guard in guards]
        self.watches = [guard.watch for guard in guards]
        self.values = [guard.value for guard in guards]
        self.signs = [self._sign(i, value) for i, value in enumerate(self.values)]

    def _sign(self, i: int, value: float) -> float:
        if value > SLACK:
            return 1.0
        return -1.0 if self.watches[i] and value < -SLACK else 0.0

    def first_event(self, dense: DenseOutput) -> tuple[float, Cause] | None:
        """Time and cause of the first event in a step, or None.

        Raises
        ------
        Misjudged
            Where a margin is negative from the start of the mode.
        """
        start, span = self.time, dense.t_max - self.time
        times = [start, *(start + part * span for part in NODES[:-1]), dense.t_max]
        states = dense(times[1:]).T.tolist()
        later = [self.mode.guards(t, y) for t, y in zip(times[1:], states, strict=True)]
        found = []
        for i, cause in enumerate(self.causes):
            values = [self.values[i], *(guards[i].value for guards in later)]
            bracket = self._bracket(i, times, values, dense)
            if bracket is not None:
                found.append((self._root(i, bracket, dense), cause))
            self.values[i] = values[-1]
        self.time = dense.t_max
        return min(found, key=lambda each: each[0]) if found else None

    def _value(self, i: int, dense: DenseOutput) -> Callable[[float], float]:
        """Guard i as a function of time, positive before its event."""
        sign = self.signs[i] or 1.0

        def value(time: float) -> float:
            return float(sign) * float(self.mode.guards(time, dense(time).tolist())[i].value)

        return value

    def _root(self, i: int, bracket: tuple[float, float], dense: DenseOutput) -> float:
        value = self._value(i, dense)
        if value(bracket[0]) <= 0.0:
            return bracket[0]
        root: float = brentq(value, *bracket, xtol=1e-30, rtol=1e-15, maxiter=500)
        # Where the guard jumps, the event has to lie on the far side of the jump.
        step = 1e-15 * root
        while step and root < bracket[1] and value(root) > SLACK:
            root, step = min(root + step, bracket[1]), 2 * step
        return root

    def _bracket(
        self, i: int, times: list[float], values: list[float], dense: DenseOutput
    ) -> tuple[float, float] | None:
        for j, (time, value) in enumerate(zip(times[1:], values[1:], strict=True), start=1):
            if self.signs[i] == 0.0:
                self.signs[i] = self._sign(i, value)
                if value < -SLACK and not self.watches[i]:
                    return self._rise(i, times[j - 1], time, dense), time
            elif self.signs[i] * value < -SLACK:
                return times[j - 1], time
        return None if self.watches[i] else self._dip(i, times, values, dense)

    def _rise(self, i: int, start: float, end: float, dense: DenseOutput) -> float:
        """A moment after `start` in which a margin that began at zero is positive."""
        value = self._value(i, dense)
        for halving in range(1, HALVINGS):
            time = start + (end - start) / 2**halving
            if value(time) > SLACK:
                self.signs[i] = 1.0
                return float(time)
        raise Misjudged

    def _dip(
        self, i: int, times: list[float], values: list[float], dense: DenseOutput
    ) -> tuple[float, float] | None:
        """Bracket of a dip below zero between nodes at which the margin is positive."""
        triples = zip(values, values[1:], values[2:], pairwise(times[1:]), strict=False)
        for j, (a, b, c, _) in enumerate(triples):
            bend = a - 2 * b + c
            if (
                min(a, b, c) > 0
                and b <= min(a, c)
                and b - (c - a) ** 2 / (8 * bend or 1.0) < 0.2 * b
            ):
                bounds = times[j], times[j + 2]
                least = minimize_scalar(self._value(i, dense), bounds=bounds, method="bounded")
                if least.fun < -SLACK:
                    return times[j], float(least.x)
        return None
