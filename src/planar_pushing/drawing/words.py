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
#: Behavior of a side that stays on the fence.
FLUSH = {
    ContactMode.STICK: "the side stays flush and sticks",
    ContactMode.SLIP_RIGHT: "slips to the right, flush",
    ContactMode.SLIP_LEFT: "slips to the left, flush",
}
#: Behavior of an end of a side that lifts off at the other end.
LIFTS = {
    ContactMode.STICK: "and sticks",
    ContactMode.SLIP_RIGHT: "and slips to the right",
    ContactMode.SLIP_LEFT: "and slips to the left",
}
DASH = "\N{EN DASH}"
#: Relative magnitudes below this are rounding error.
ROUNDING = 1e-9


def best(solutions: Sequence[Solution], wanted: str = "") -> int:
    """Index of the solution to draw in full: the wanted mode, otherwise sticking, otherwise moving."""
    ranks = [
        (
            solution.mode.name != wanted,
            solution.mode != ContactMode.STICK,
            solution.mode == ContactMode.SEPARATE,
        )
        for solution in solutions
    ]
    return min(range(len(ranks)), key=ranks.__getitem__, default=-1)


def best_row(modes: Any) -> Any:
    """Row of an array of modes to draw in full, as an index that keeps the axis; empty if there is none."""
    ranks = np.select([modes == ContactMode.STICK, modes != ContactMode.SEPARATE], [0, 1], 2)
    return np.argsort(ranks, kind="stable")[:1]


def does(solution: Solution, pusher: Any) -> str:
    """Behavior of the contact, such as "slips to the left while being pulled"."""
    text = _moves(solution)
    if solution.mode == ContactMode.SEPARATE:
        return text
    if solution.adhesive:
        text += ", held by adhesion"
    elif pusher[1] < -ROUNDING * float(np.hypot(*pusher)):
        text += " while being pulled"
    if solution.continuum:
        return f"{text} (one of a range of motions)"
    return f"{text}, turning about a support point" if solution.pivot >= 0 else text


def _moves(solution: Solution) -> str:
    """Behavior of the contact, or of a side on the fence."""
    end = end_of(solution)
    if solution.mode == ContactMode.SEPARATE or not (solution.flush or end):
        return NAMES[solution.mode]
    if solution.flush:
        return FLUSH[solution.mode]
    return f"the side lifts off, turns about its {end} end {LIFTS[solution.mode]}"


def end_of(solution: Solution) -> str:
    """The end of a side about which it turns as the other end lifts off; empty for another contact."""
    position = solution.force_position
    if solution.flush or position is None or np.isnan(position):
        return ""
    return "left" if position < 0 else "right"


def outcome(solutions: Sequence[Solution], pusher: Any, chosen: int) -> str:
    """One sentence on the solution that is drawn and on the others."""
    if not solutions:
        return "No motion of the slider is consistent with this push."
    sentence = _capitalize(_with_subject(does(solutions[chosen], pusher)))
    others = [does(other, pusher) for i, other in enumerate(solutions) if i != chosen]
    if not others:
        return f"{sentence}."
    count = f"{NUMBERS[len(others)]} other solution{'' if len(others) == 1 else 's'}"
    return f"{sentence}; {count}: {_alternatives(others)}."


def _capitalize(text: str) -> str:
    return text[0].upper() + text[1:]


def _alternatives(others: list[str]) -> str:
    """Alternatives as a list in words, with a subject where it is not that of the one before."""
    texts, previous = [], ""
    for behavior in others:
        subject = _subject(behavior)
        texts.append(behavior if subject == previous else _with_subject(behavior))
        previous = subject
    if len(texts) == 1:
        return texts[0]
    return f"{', '.join(texts[:-1])}, or {texts[-1]}"


def _with_subject(behavior: str) -> str:
    """Behavior with its subject."""
    return behavior if behavior.startswith("the ") else f"the {_subject(behavior)} {behavior}"


def _subject(behavior: str) -> str:
    """What moves: the contact, or a side on the fence."""
    return "side" if behavior.startswith("the side") or "flush" in behavior else "contact"


def row(solution: Solution, pusher: Any) -> dict[str, str]:
    """Force, motion, center and slip of a solution as short texts; of a side also the contact and x*."""
    slip = float(solution.contact_motion[0] - pusher[0])
    rests = solution.mode == ContactMode.SEPARATE
    sticks = solution.mode == ContactMode.STICK
    end = end_of(solution)
    contact = DASH if rests else f"{end} end" if end else "flush"
    position = solution.force_position
    position_entry = {} if position is None else {"at x*": number(position)}
    return {
        "mode": str(solution.mode.name).replace("_", " ").lower(),
        **({"contact": contact} if position_entry else {}),
        "force": "0" if rests else _polar(solution.force),
        **position_entry,
        "motion": "0" if rests else _polar(solution.contact_motion),
        "center": DASH if np.isnan(solution.center).any() else _position(solution.center),
        "slip": DASH if rests else "0" if sticks else number(slip),
    }


def _polar(vector: Any) -> str:
    """Magnitude and direction."""
    angle = float(np.rad2deg(np.arctan2(vector[1], vector[0])))
    return f"{number(float(np.hypot(*vector)))} at {number(angle, 1)}\N{DEGREE SIGN}"


def _position(center: Any) -> str:
    if not np.isfinite(center).all() or np.hypot(*center) > 1e6:
        return "at infinity"
    return f"({number(float(center[0]))}, {number(float(center[1]))})"


def number(value: float, digits: int = 3) -> str:
    """Short text of a number, with a true minus; rounding error becomes zero, a missing number a dash."""
    if np.isnan(value):
        return DASH
    if abs(value) < ROUNDING:
        return "0"
    text = f"{value:.{digits}f}" if 0.01 <= abs(value) < 1e4 or digits < 3 else f"{value:.3g}"
    plain = text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text
    return "0" if plain in ("-0", "0", "") else plain.replace("-", "\N{MINUS SIGN}")
