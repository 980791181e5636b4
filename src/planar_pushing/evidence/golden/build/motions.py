"""Golden values of the figures of motion over time, at some instants of their simulations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from flint import arb, fmpq

from planar_pushing.certified.balls import in_degrees, rational
from planar_pushing.certified.motion.instants import File, Instant, Vector
from planar_pushing.certified.motion.trajectories import pulled, rod_length, slipping
from planar_pushing.evidence.golden.build.packing import Values

Study = Mapping[str, Any]
Golden = tuple[Values, dict[str, Any]]
#: Parts of the duration, exact in binary, at which the motion is certified.
INSTANTS = tuple(i / 8 for i in range(9))
NUMBERS: dict[str, Callable[[Instant], Any]] = {
    "path_rod_angle": lambda each: in_degrees(each.angle),
    "path_slip": lambda each: each.slip,
    "path_gap": lambda each: each.gap,
    "path_spin_ratio": lambda each: each.spin,
    "path_mode": lambda each: each.mode,
}


def figure_14(study: Study) -> Golden:
    """Pulling, with the contact kept and lost."""
    files = [study["simulations"][f"figure_14{letter}"] for letter in "ab"]
    times = _times(study, files[0])
    tables = [_columns(file, pulled(file, times)) for file in files]
    values: Values = {
        name: (("policy", *dims), [table[name][1] for table in tables])
        for name, (dims, _) in tables[0].items()
    }
    policies = [file["simulate"]["on_ambiguity"] for file in files]
    return values, {"policy": policies, "time": list(map(_double, times)), "xy": ["x", "y"]}


def figure_15(study: Study) -> Golden:
    """Slip with infinite friction; the motion center is above the ring's center, by 1 / |k|."""
    file = study["simulations"]["figure_15"]
    times = _times(study, file)
    instants = slipping(file, times)
    values = _columns(file, instants)
    length = rod_length(file)
    values["path_center"] = (
        ("time", "xy"),
        [_raised(_position(length, each), -1 / each.spin) for each in instants],
    )
    return values, {"time": list(map(_double, times)), "xy": ["x", "y"]}


def _times(study: Study, file: File) -> list[fmpq]:
    duration = rational(file["simulate"]["duration"])
    return [duration * rational(part) for part in study["instants"]]


def _double(time: fmpq) -> float:
    return int(time.p) / int(time.q)


def _position(length: fmpq, instant: Instant) -> Vector:
    x, y = instant.contact
    return x + length * instant.angle.cos(), y + length * instant.angle.sin()


def _raised(position: Vector, height: arb) -> list[arb]:
    return [position[0], position[1] + height]


def _columns(file: File, instants: Sequence[Instant]) -> Values:
    """Values of the variables that both figures plot, over time."""
    length = rod_length(file)
    values: Values = {
        name: (("time",), [of(one) for one in instants]) for name, of in NUMBERS.items()
    }
    vectors = {
        "path_position": [_position(length, each) for each in instants],
        "path_fence": [each.fence for each in instants],
        "path_force": [each.force for each in instants],
    }
    return values | {name: (("time", "xy"), [*map(list, rows)]) for name, rows in vectors.items()}
