"""The outcome of a push in words, and its solutions as rows of a table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.solutions import Solution

NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight")
#: Behavior of the contact by its mode.
NAMES = {
    ContactMode.SEPARATE: "the contact breaks",
    ContactMode.STICK: "the contact sticks",
    ContactMode.SLIP_RIGHT: "slips to the right",
    ContactMode.SLIP_LEFT: "slips to the left",
}
#: Relative magnitudes below this are rounding error.
ROUNDING = 1e-9


def best(solutions: Sequence[Solution], wanted: str = "") -> int:
    """Index of the solution to draw in full: the wanted mode, otherwise sticking, otherwise moving."""
    ranks = [
        (
            each.mode.name != wanted,
            each.mode != ContactMode.STICK,
            each.mode == ContactMode.SEPARATE,
        )
        for each in solutions
    ]
    return min(range(len(ranks)), key=ranks.__getitem__, default=-1)


def best_row(modes: Any) -> Any:
    """Row of an array of modes to draw in full, as an index that keeps the axis; empty if there is none."""
    ranks = np.select([modes == ContactMode.STICK, modes != ContactMode.SEPARATE], [0, 1], 2)
    return np.argsort(ranks, kind="stable")[:1]


def does(solution: Solution, pusher: Any) -> str:
    """Behavior of the contact, such as "slips to the left while being pulled"."""
    found = NAMES[solution.mode]
    if solution.mode == ContactMode.SEPARATE:
        return found
    if solution.adhesive:
        found += ", held by adhesion"
    elif pusher[1] < -ROUNDING * float(np.hypot(*pusher)):
        found += " while being pulled"
    if solution.continuum:
        return f"{found} (one of a range of motions)"
    return f"{found}, turning about a support point" if solution.pivot >= 0 else found


def outcome(solutions: Sequence[Solution], pusher: Any, shown: int) -> str:
    """One sentence on the solution that is drawn and on the others."""
    if not solutions:
        return "No motion of the slider is consistent with this push."
    said = _capital(_with_subject(does(solutions[shown], pusher)))
    others = [does(each, pusher) for i, each in enumerate(solutions) if i != shown]
    if not others:
        return f"{said}."
    count = f"{NUMBERS[len(others)]} other solution{'' if len(others) == 1 else 's'}"
    return f"{said}; {count}: {_alternatives(others)}."


def _with_subject(said: str) -> str:
    """Behavior with its subject."""
    return said if said.startswith("the contact") else f"the contact {said}"


def _capital(said: str) -> str:
    return said[0].upper() + said[1:]


def _alternatives(others: list[str]) -> str:
    """Alternatives as a list in words, the first with its subject."""
    named = [_with_subject(others[0]), *others[1:]]
    if len(named) == 1:
        return named[0]
    return f"{', '.join(named[:-1])}, or {named[-1]}"


def row(solution: Solution, pusher: Any) -> dict[str, str]:
    """Force, motion, center and slip of a solution as short texts."""
    slip = float(solution.contact_motion[0] - pusher[0])
    rests = solution.mode == ContactMode.SEPARATE
    sticks = solution.mode == ContactMode.STICK
    return {
        "mode": str(solution.mode.name).replace("_", " ").lower(),
        "force": "0" if rests else _polar(solution.force),
        "motion": "0" if rests else _polar(solution.contact_motion),
        "center": "\N{EN DASH}" if np.isnan(solution.center).any() else _place(solution.center),
        "slip": "\N{EN DASH}" if rests else "0" if sticks else number(slip),
    }


def _polar(vector: Any) -> str:
    """Magnitude and direction."""
    angle = float(np.rad2deg(np.arctan2(vector[1], vector[0])))
    return f"{number(float(np.hypot(*vector)))} at {number(angle, 1)}\N{DEGREE SIGN}"


def _place(center: Any) -> str:
    if not np.isfinite(center).all() or np.hypot(*center) > 1e6:
        return "at infinity"
    return f"({number(float(center[0]))}, {number(float(center[1]))})"


def number(value: float, digits: int = 3) -> str:
    """Short text of a number, with a true minus; rounding error becomes zero, without a sign."""
    if abs(value) < ROUNDING:
        return "0"
    text = f"{value:.{digits}f}" if 0.01 <= abs(value) < 1e4 or digits < 3 else f"{value:.3g}"
    plain = text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text
    return "0" if plain in ("-0", "0", "") else plain.replace("-", "\N{MINUS SIGN}")
