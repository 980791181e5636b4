"""Checks that the ledger states in full: a number against the claimed one, and the modes of a push."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from planar_pushing.certified.balls import rational
from planar_pushing.certified.contact.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    Mode,
    contact_modes,
    coulomb,
)
from planar_pushing.certified.setting import Effects, Slider
from planar_pushing.evidence.claims.registry import Quantity
from planar_pushing.evidence.claims.verdicts import Evidence, equal, facts, inequality, near

#: Contact laws by name; a number is a coefficient of friction.
LAWS = {
    "definition-1": INFINITE_FREE,
    "definition-2": INFINITE_NONE,
    "perfectly-rough": PERFECTLY_ROUGH,
}
#: Contact modes by name.
MODES = {mode.name.lower().replace("_", "-"): mode for mode in Mode}
MODES_HOW = (
    "The conditions of each mode are decided by the signs of quantities that are enclosed in ball "
    "arithmetic, and by exact arithmetic where an enclosure contains zero."
)


def number(
    quantity: Quantity, at: dict[str, float | str], relation: str, claimed: float, within: float
) -> Evidence:
    """Evidence for a number that is near, equal to, below or above the claimed one."""
    value = quantity.value(**at)
    match relation:
        case "near":
            return near(value, claimed, within, quantity.unit)
        case "equals":
            return equal(value, claimed, unit=quantity.unit)
    margin = (value - rational(claimed)) * (1 if relation == "above" else -1)
    return inequality(margin, value=value, unit=quantity.unit, claimed=claimed)


def modes(
    expected: Sequence[str],
    rod_length: float,
    law: float | str,
    pusher_angle: float,
    effects: str = str(Effects.FRICTION),
    magnitude: float = 1.0,
) -> Evidence:
    """Evidence that these modes, each as often as it is listed, are exactly the consistent ones."""
    slider, contact = Slider.of(rod_length), _law(law)
    found = contact_modes(slider, Effects(effects), contact, magnitude, pusher_angle)
    count = {mode: len(motions) for mode, motions in found.items() if motions}
    names = {mode: name for name, mode in MODES.items()}
    text = ", ".join(names[mode] for mode in count for _ in range(count[mode]))
    wanted = Counter(MODES[name] for name in expected)
    return facts({f"{', '.join(expected) or 'none'} (found: {text or 'none'})": count == wanted})


def _law(given: float | str) -> Law:
    return LAWS[given] if isinstance(given, str) else coulomb(given)
