"""The interface of an effect: a convex potential of the twist, whose gradient is the wrench."""

from __future__ import annotations

from typing import Protocol


class Effect(Protocol):
    """An effect that resists or drives the slider's motion, in the form in which users list it."""

    @property
    def degree(self) -> int:
        """Degree of homogeneity of the potential."""
        ...
