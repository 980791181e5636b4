"""What a figure takes from the study."""

from __future__ import annotations

from typing import Protocol


class Settings(Protocol):
    """Values of the grid that a figure shows; None where the figure's own hold."""

    @property
    def rod_length(self) -> float | tuple[float, ...] | None: ...

    @property
    def mapped_rod_length(self) -> float | None: ...

    @property
    def friction_coefficient(self) -> float | None: ...

    @property
    def pusher_magnitude(self) -> float | None: ...
