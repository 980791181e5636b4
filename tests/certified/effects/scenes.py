"""Public scenes and their solutions before the certified route."""

from __future__ import annotations

from certified.effects.check import check
from planar_pushing.certified.balls import rational
from planar_pushing.certified.effects import given
from planar_pushing.mechanics.entries import scene_entry


def push_of(scene, angle, magnitude):
    """A public scene and a push, in radians, as exact numbers."""
    entry = scene_entry(scene)
    return given.scene(entry), given.law(entry), given.heading(angle), rational(magnitude)


def faults(scene, angle, magnitude, solutions):
    """Which solutions do not hold, and why."""
    push = push_of(scene, angle, magnitude)
    verdicts = [(each, check(*push, each)) for each in solutions]
    return [
        f"{each.mode.name}: {', '.join(verdict.fails or verdict.undecided)}\n"
        f"    {scene!r}, {angle!r}, {magnitude!r}\n    {each!r}"
        for each, verdict in verdicts if not verdict.holds
    ]  # fmt: skip
