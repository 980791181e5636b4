"""References of the hard motions: print those that differ from the stored ones, or store them.

``python -m pulling_by_pushing.evidence.hard_cases.motion_references --only NAME --write`` stores those of a
motion; without ``--only``, all of them take some twenty minutes.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from flint import arb, ctx

from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.evidence.hard_cases import integrator, quadrature
from pulling_by_pushing.evidence.hard_cases.motions import (
    FILE,
    FLUSH,
    INTEGRATOR,
    MOTIONS,
    ORACLE,
    QUADRATURE,
    HardMotion,
    Reference,
    label,
    results,
    run,
    scene_file,
    stored_references,
)
from pulling_by_pushing.oracle.balls import in_degrees, rational
from pulling_by_pushing.oracle.logs.log import log_values
from pulling_by_pushing.study.running.jobs import run_command

Pair = tuple[arb, arb]
#: Numbers by quantity, each on the route's two finest steps.
Numbers = dict[str, Pair]
#: Levels of the quadrature, and tolerances and steps of the integrator, the finest first.
LEVELS, TOLERANCES, PARTS = (5, 4), (1e-12, 1e-11), (4, 2)
#: Largest number of digits of a reference.
DIGITS = 25
#: Inputs whose relative changes enter the condition number, and their change in difference quotients.
INPUTS = ("length", "angle", "mu", "pusher", "duration", "speed", "mass", "gap", "sinking", "spin")
CHANGE = 1e-5


def by_oracle(motion: HardMotion) -> Numbers:
    """Numbers of the oracle's integrator, with an end of their balls."""
    values = log_values(scene_file(motion).model_dump(), run(motion)["time"].values.tolist())
    angle, place = values["rod_angle"][1][-1], values["position"][1][-1][0]
    return {
        name: (ball.mid(), ball.upper())
        for name, ball in (("rod_angle", angle), ("position", place))
    }


def by_quadrature(motion: HardMotion) -> Numbers:
    """Numbers of the quadrature, with those of twice the step."""
    fine, coarse = (_by_level(motion, level) for level in LEVELS)
    return {name: (fine[name], coarse[name]) for name in fine}


def _by_level(motion: HardMotion, level: int) -> dict[str, arb]:
    angle = _radians(motion.pusher)
    speed = arb(rational(motion.speed))
    fence = (speed * angle.cos()).mid(), (speed * angle.sin()).mid()
    share = arb(1) / max(len(motion.feet), 1)
    feet = tuple(quadrature.Foot(arb(x), arb(y), share) for x, y in motion.feet)
    length = arb(2).sqrt() if motion.box else arb(motion.length)
    push = quadrature.Push(
        length.mid(), arb(motion.mu), fence, feet, _radians(FLUSH) if motion.box else None
    )
    duration = arb(motion.duration)
    last = quadrature.follow(push, _radians(motion.angle), duration, level)[-1]
    place = fence[0] * duration + last.slip + push.length * last.angle.cos()
    first = {"time": last.time} if motion.box else {"rod_angle": in_degrees(last.angle)}
    return first | {"position": place.mid()}


def _radians(degrees: float) -> arb:
    return (arb.pi() * arb(degrees) / 180).mid()


def by_integrator(motion: HardMotion) -> Numbers:
    """Numbers of the implicit integrator at two tolerances, or of alternating slips in two step sizes."""
    angle, direction = float(np.deg2rad(motion.angle)), np.deg2rad(motion.pusher)
    fence = (motion.speed * float(np.cos(direction)), motion.speed * float(np.sin(direction)))
    if motion.mass is None:
        step = motion.duration / motion.pieces
        ends = [
            integrator.alternate(motion.length, angle, motion.mu, fence, motion.pieces, step, parts)
            for parts in PARTS
        ]
    else:
        light = integrator.Light(motion.length, angle, motion.mu, motion.mass, fence)
        ends = [
            (last, fence[0] * motion.duration + slip)
            for _, last, slip in (
                integrator.follow(light, motion.duration, tol) for tol in TOLERANCES
            )
        ]
    numbers = [
        (arb(float(np.rad2deg(last))), arb(float(place + motion.length * np.cos(last))))
        for last, place in ends
    ]
    return dict(zip(("rod_angle", "position"), zip(*numbers, strict=True), strict=True))


ROUTES: dict[str, Callable[[HardMotion], Numbers]] = {
    ORACLE: by_oracle, QUADRATURE: by_quadrature, INTEGRATOR: by_integrator,
}  # fmt: skip


def agreeing_digits(pair: Pair) -> int:
    """Number of significant digits on which two numbers agree, at most those of a reference."""
    fine, coarse = pair
    difference = abs(fine - coarse)
    if difference == 0:
        return DIGITS
    return min(DIGITS, int(float((abs(fine) / difference).log() / arb(10).log())))


def conditions(motion: HardMotion) -> dict[str, float]:
    """Condition numbers by quantity, to two digits, from central differences of the library's runs."""
    exact = results(motion)
    total = dict.fromkeys(exact, 0.0)
    for name in INPUTS:
        value = getattr(motion, name)
        if not value or (motion.box and name in ("length", "duration")):
            continue
        above, below = (
            results(replace(motion, **{name: value * (1 + sign * CHANGE)})) for sign in (1, -1)
        )
        for key, number in exact.items():
            total[key] += abs((above[key] - below[key]) / (2 * CHANGE * number))
    return {key: float(f"{number:.1e}") for key, number in total.items()}


def references(motion: HardMotion) -> dict[str, Reference]:
    """References of a motion by label."""
    condition, by_label = conditions(motion), {}
    with ctx.workprec(quadrature.BITS):
        for quantity, pair in ROUTES[motion.route](motion).items():
            digits = agreeing_digits(pair)
            text = pair[0].mid().str(digits, radius=False)
            reference = Reference(text, digits, motion.route, condition[quantity])
            by_label[label(quantity, motion)] = reference
    return by_label


def main(arguments: Sequence[str] | None = None) -> int:
    """Compute references, print the changed ones, and return 1 if there are any; store them on request."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="+", help="names of motions, such as 'slip that dies'")
    parser.add_argument("--write", action="store_true", help="store the new references")
    args = parser.parse_args(arguments)
    path = Path(__file__).with_name(FILE)
    stored = stored_references() if path.is_file() else {}
    chosen = [motion for motion in MOTIONS if not args.only or motion.name in args.only]
    new = {name: entry for motion in chosen for name, entry in references(motion).items()}
    changed = {name: entry for name, entry in new.items() if stored.get(name) != entry}
    for name, entry in changed.items():
        print(f"{name}: {entry.value} with {entry.digits} digits, condition {entry.condition:g}")
    if changed and args.write:
        content = {name: entry._asdict() for name, entry in sorted((stored | new).items())}
        with replacing(path) as part:
            part.write_text(json.dumps(content, indent=1) + "\n")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
