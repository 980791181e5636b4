"""What a figure is made from: datasets, and values that the study chooses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import xarray as xr

#: Datasets by the names in the figure's entry.
Sources = Mapping[str, xr.Dataset]


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
