"""The pushes and the laws of a dataset of contact modes, in numbers."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.certified.doubled.angles import cosine_sine, radians
from planar_pushing.certified.doubled.numbers import Doubled, Floats
from planar_pushing.evidence.golden.residual.finding import EPSILON
from planar_pushing.evidence.golden.residual.grids import slider_of
from planar_pushing.evidence.golden.residual.motion import Slider
from planar_pushing.study.files.study_model import StudyFile

Flags = npt.NDArray[np.bool_]
MODES = ("SEPARATE", "STICK", "SLIP_RIGHT", "SLIP_LEFT")
#: Edge of the friction cone under which the contact slips, 1 the right and -1 the left one.
SLIPS = {"SLIP_RIGHT": -1, "SLIP_LEFT": 1}
#: Dimensions of a push, behind the contact law.
DIMS = ("rod_length", "pusher_magnitude", "pusher_angle")


class Pushes(NamedTuple):
    """A grid of pushes: arrays that broadcast over contact, rod length, magnitude and pusher angle.

    Attributes
    ----------
    slider : Slider
    rod_angle : float
        Degrees.
    length : ndarray
        In units of R.
    magnitude, angle : ndarray
        Of the pusher's motion; degrees.
    x, y : Doubled
        Direction of the pusher's motion.
    friction : ndarray
        Coefficients of friction, infinite for laws without one.
    slips, closed, rough : ndarray of bool
        Whether the law allows slip, a force on the cone's edge, and any force.
    """

    slider: Slider
    rod_angle: float
    length: Floats
    magnitude: Floats
    angle: Floats
    x: Doubled
    y: Doubled
    friction: Floats
    slips: Flags
    closed: Flags
    rough: Flags

    @property
    def near(self) -> Floats:
        """Directions closer than this, as sines, are one: what rounding the angles explains."""
        return 64 * EPSILON * (1 + self.length**2)


def pushes(dataset: xr.Dataset, study: StudyFile) -> Pushes:
    """The pushes of a dataset."""
    length, magnitude, angle = (_along(dataset[name].values, i + 1) for i, name in enumerate(DIMS))
    labels, kinds = (_along(dataset[name].values.astype(str), 0) for name in ("contact", "law"))
    rough, coulomb = kinds == "perfectly_rough", kinds == "coulomb"
    free = coulomb | (labels == "infinite_friction_free")
    friction = np.where(coulomb, _along(dataset["friction_coefficient"].values, 0), np.inf)
    x, y = cosine_sine(radians(angle))
    return Pushes(
        slider_of(study), study.slider.rod_angle, length / study.slider.radius, magnitude, angle,
        x, y, friction, free, free, rough,
    )  # fmt: skip


def _along(values: Any, axis: int) -> Any:
    """Values along one of the four dimensions."""
    return values.reshape([-1 if i == axis else 1 for i in range(4)])


class Decision(NamedTuple):
    """Whether a mode is consistent, and where rounding leaves it open."""

    consistent: Flags
    open: Flags


def decided(margin: Any, near: Any) -> Decision:
    """Consistent where the margin is above zero."""
    return Decision(margin > 0, np.abs(margin) <= near)
