"""Examples of pushing problems, and which contact modes are consistent in them."""

from __future__ import annotations

from planar_pushing.certified.contact.modes import Law, Mode, contact_modes
from planar_pushing.certified.setting import Effects, Slider
from planar_pushing.evidence.claims.proofs.verdicts import Evidence, facts

METHOD = "every contact mode decided by signs of balls, ties by exact arithmetic"


def found_modes(
    rod_length: float, effects: Effects, law: Law, pusher_angle: float, magnitude: float = 1.0
) -> dict[Mode, int]:
    """Number of consistent motions of each mode that has any, at psi = 45 degrees."""
    found = contact_modes(Slider.of(rod_length), effects, law, magnitude, pusher_angle)
    return {mode: len(motions) for mode, motions in found.items() if motions}


def modes_are(
    expected: tuple[Mode, ...],
    rod_length: float,
    effects: Effects,
    law: Law,
    pusher_angle: float,
    magnitude: float = 1.0,
) -> Evidence:
    """Evidence that these modes, with one motion each, are all that is consistent."""
    found = found_modes(rod_length, effects, law, pusher_angle, magnitude)
    text = ", ".join(f"{count} x {mode.name}" for mode, count in found.items()) or "none"
    named = f"{'+'.join(mode.name for mode in expected) or 'none'} (found: {text})"
    return facts({named: found == dict.fromkeys(expected, 1)}, METHOD)
