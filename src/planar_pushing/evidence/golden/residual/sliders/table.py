"""Errors of the values of contact modes, and what is allowed, by variable."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.evidence.golden.residual.contact_modes.push import MODES, Decision

#: What every motion has; NaN where a mode is not consistent, and zero at rest.
VALUES = ("force_angle", "force_angle_end", "motion_angle", "spin")


class Tables:
    """Errors and allowances of every variable of a dataset of contact modes.

    Parameters
    ----------
    dataset : xarray.Dataset
    """

    def __init__(self, dataset: xr.Dataset) -> None:
        self.counts = dataset["consistent"].values.astype(bool)
        self.values = {name: dataset[name].values for name in VALUES}
        self.pivot = dataset["pivot"].values
        self.wrong = np.zeros(self.counts.shape, dtype=bool)
        self.error = {name: self._absent(each) for name, each in self.values.items()}
        self.allowed = {name: np.zeros(self.counts.shape) for name in (*VALUES, "pivot")}
        rests = np.arange(len(MODES)) == MODES.index("SEPARATE")
        self.error["pivot"] = np.where((~self.counts | rests) & (self.pivot != -1), np.inf, 0.0)

    def _absent(self, values: Any) -> Any:
        """Errors of what is not there (NaN), and of rest, which has neither force nor motion."""
        rests = np.arange(len(MODES)) == MODES.index("SEPARATE")
        wrong = (np.isnan(values) == self.counts) | (self.counts & rests & (values != 0))
        return np.where(wrong, np.inf, 0.0)

    def decide(self, at: tuple[int, ...], mode: str, decision: Decision) -> None:
        """Mark where a mode is consistent and should not be, or the other way about."""
        place = MODES.index(mode)
        differs = self.counts[at][:, place] != decision.consistent
        self.wrong[at][:, place] = differs & ~decision.open

    def put(self, name: str, place: tuple[int, ...], error: float, allowed: float) -> None:
        """Set the error of one value."""
        self.error[name][place] = error
        self.allowed[name][place] = allowed


def turned(stored: float, wanted: float) -> float:
    """Difference of two angles in degrees, of which the stored one is in (-180, 180]."""
    if not -180 < stored <= 180:
        return np.inf
    return abs((stored - wanted + 180) % 360 - 180)
