"""Every value of the log of a motion over time, on the certified route."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import (
    Undecided,
    in_degrees,
    precise,
    rational,
    sign,
)
from planar_pushing.certified.motion.dynamic import driven
from planar_pushing.certified.motion.extrapolation import COARSE, FINE
from planar_pushing.certified.motion.flights import flying
from planar_pushing.certified.motion.instants import Instant
from planar_pushing.certified.motion.pivoting import pivoting
from planar_pushing.certified.motion.trajectories import pulled, slipping

#: Largest difference between two runs, relative to a number.
RESOLUTION = 1e-25
#: Dimensions and nested lists of balls, or of flags.
Values = dict[str, tuple[tuple[str, ...], Any]]
#: Numbers of nodes of the two runs of a slider on feet; the result is from the first.
NODES = 72, 60
#: Relative error that both runs can share, from the widths of roots and from rounding.
SHARED = arb(2) ** -100
#: Variables of a log except `dissipated`: dimensions after time, and the value at an instant.
VARIABLES: dict[str, tuple[tuple[str, ...], Callable[[Instant], Any]]] = {
    "time": ((), lambda now: now.time),
    "position": (("xy",), lambda now: [*now.position]),
    "rod_angle": ((), lambda now: in_degrees(now.angle)),
    "twist": (("twist_component",), lambda now: [*now.twist]),
    "pusher": (("xy",), lambda now: [*now.fence]),
    "slip": ((), lambda now: now.slip),
    "gap": ((), lambda now: now.gap),
    "force": (("xy",), lambda now: [*now.force]),
    "mode": ((), lambda now: int(now.mode)),
    "pivot": ((), lambda now: now.pivot),
    "event": ((), lambda now: now.event),
    "outcome": ((), lambda now: min(now.solutions, 2)),
    "solutions": ((), lambda now: now.solutions),
    "adhesive": ((), lambda now: sign(now.force[1]) < 0),
    "spin_ratio": ((), lambda now: now.spin),
    "contact_dissipated": ((), lambda now: now.lost),
    "work": ((), lambda now: now.work),
    "kinetic_energy": ((), lambda now: now.kinetic),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class LogValues:
    """The values of a log.

    Attributes
    ----------
    values : dict
        For `time` and each variable of the log except `evaluations`: its dimensions, and its values as
        nested lists, with balls for numbers and int or bool for flags. Names, dimensions, frames and units
        are those of the log: angles in degrees, rotations in radians per time, x along the fence, y normal
        to it.
    validated : bool
        Whether the balls are proved to enclose the numbers. Otherwise their radius is the difference from a
        second run of the same equations by a method of different order and with different steps, and at
        least 2^-100 of the number, to cover the errors that both runs share.
    """

    values: Values
    validated: bool


@precise
def log_values(scene: Mapping[str, Any], times: Sequence[float]) -> LogValues:
    """Every value of the log of a scene at its stored instants, without the code that wrote the log.

    Parameters
    ----------
    scene : mapping
        A scene file's plain content (`SceneFile.model_dump()`), with its section `simulate`.
    times : sequence of float, shape (n,)
        The stored instants in order, taken as exact, in the scene's unit of time.

    Returns
    -------
    LogValues
        Numbers to a relative 1e-25 or better, each of shape (n, ...).

    Raises
    ------
    Undecided
        If the scene is not of a certified kind, a condition of its motion remains undecided, the two runs
        differ by more than 1e-25 relative to a number, or an event has no stored instant.

    Notes
    -----
    The following are certified, with R = 1 and a fence of piecewise constant velocity:

    - a ring that sticks, or slips under infinite friction (figures 14 and 15): integrals over the spin
      ratio, validated;
    - inertia alone, a flight with one impact: a closed form and one root, validated;
    - a ring with inertia from rest on the fence: extrapolation of order up to 32, not validated;
    - a support of points that slips and then pivots: Chebyshev series over the rod angle, not validated.

    A log contains each event of a motion at the time that the library found. The stored instant next to an
    event, within 1e-8 of the last time, is that of the event: its `time` encloses the exact time of the
    event, and its other values are those of the motion after the event, at the stored time, so that the
    error of that time does not count twice. At the start of a piece of the fence's motion the values are
    also those just after it.
    """
    exact = [rational(time) for time in times]
    if not exact or any(b <= a for a, b in pairwise(exact)):
        raise Undecided("certified instants must increase, and there must be at least one")
    if scene["simulate"] is None:
        raise Undecided("the scene file has no section simulate")
    effects, runs = [each["type"] for each in scene["effects"]], _runs(scene, exact)
    found = [_columns(run(), effects, len(exact)) for run in runs]
    if len(found) == 1:
        return LogValues(values=found[0], validated=True)
    fine, coarse = found
    joined = {name: (dims, _joined(rows, coarse[name][1])) for name, (dims, rows) in fine.items()}
    return LogValues(values=joined, validated=False)


def _runs(scene: Mapping[str, Any], times: list[fmpq]) -> list[Callable[[], list[Instant]]]:
    """One validated run of a scene, or two runs for comparison."""
    kinds = {each["type"] for each in scene["effects"]}
    if len(kinds) < len(scene["effects"]):
        raise Undecided("certified motion requires at most one effect of each kind")
    if kinds == {"inertia"}:
        return [lambda: flying(scene, times)]
    if kinds == {"ring_friction", "inertia"}:
        return [lambda: driven(scene, times, FINE), lambda: driven(scene, times, COARSE)]
    if kinds == {"support_friction"}:
        return [lambda: pivoting(scene, times, NODES[0]), lambda: pivoting(scene, times, NODES[1])]
    if kinds != {"ring_friction"}:
        raise Undecided(f"certified motion is not available with {', '.join(sorted(kinds))}")
    rough = scene["contact"]["law"] == "infinite_friction"
    return [lambda: slipping(scene, times) if rough else pulled(scene, times)]


def _columns(instants: Sequence[Instant], effects: Sequence[str], count: int) -> Values:
    if len(instants) != count:
        raise Undecided("certified instants must be within the duration")
    found: Values = {
        name: (("time", *dims), [of(now) for now in instants])
        for name, (dims, of) in VARIABLES.items()
    }
    rows = [[arb(0) if each == "inertia" else now.rubbed for each in effects] for now in instants]
    return found | {"dissipated": (("time", "effect"), rows)}


def _joined(fine: Any, coarse: Any) -> Any:
    """Values of one run as balls with the difference from another run as the radius."""
    if isinstance(fine, list):
        return [_joined(a, b) for a, b in zip(fine, coarse, strict=True)]
    if not isinstance(fine, arb):
        if fine != coarse:
            raise Undecided(f"two runs differ in a flag: {fine}, {coarse}")
        return fine
    apart = (fine - coarse).abs_upper()
    if apart > RESOLUTION * abs(fine):
        raise Undecided(f"two runs differ by too much: {fine}, {coarse}")
    if apart == 0 and fine == float(fine):  # a given number, or zero
        return fine
    return arb(fine.mid(), arb.max(apart, (SHARED * abs(fine)).abs_upper()))
