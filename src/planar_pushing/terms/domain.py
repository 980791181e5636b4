"""The domain: ranges of the arguments of functions, ranges of ratios, and bounds that several places name.

The parameters of dataclasses are declared at their fields, with `planar_pushing.terms.declared`. Parameters
are numbers, numpy arrays or `xarray.DataArray`, of which `planar_pushing.terms.numbers` makes doubles; the
blocks of a lazy array are checked when they are computed.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from planar_pushing.terms.declared import (
    NUMBER,
    OneAngle,
    Single,
    Within,
    finite,
    nonnegative,
    positive,
)
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Number as Number
from planar_pushing.terms.numbers import is_lazy as is_lazy
from planar_pushing.terms.options import SAMPLES, SPEED, TOLERANCE

#: One number, and many without labels, for the types of functions whose result type follows the arguments.
Scalar = float | np.floating[Any] | np.integer[Any]
Numbers = npt.NDArray[Any] | list[Any]
if TYPE_CHECKING:
    import xarray as xr

    #: A parameter of a scene, which can be an array. Declarations are read without importing xarray.
    Parameter = Scalar | Numbers | xr.DataArray
else:
    Parameter = Any

#: Maximum rod length, and range of the radius of gyration, in radii of the slider.
LONGEST, GYRATION = 1e6, (1e-4, 1e4)
#: Maximum radius of a finger, in radii of the slider: with a larger one the contact travels so fast that a
#: simulation takes very small time steps.
WIDEST = 1e4
#: Maximum coefficient of friction of Coulomb's law; infinite friction is a separate law.
ROUGHEST = 1e9
#: Range of s = m |a| / W for a push from rest with friction and inertia.
SHARES = (1e-12, 1e12)
#: Maximum magnitude of an angle in radians: a larger one is most likely in degrees.
TURNS = 4 * math.pi
#: Angles that are allowed, and remedies for another one.
RADIANS = "radians in [-4 pi, 4 pi]"
TO_RADIANS = (
    "convert degrees with np.deg2rad, and wrap unwrapped radians with np.mod(angle, 2 * np.pi)"
)
#: Range of speeds over time.
SPEEDS = SPEED.minimum, SPEED.maximum


def _angle(remedy: str = TO_RADIANS) -> Within:
    return Within(lambda x: abs(x) <= TURNS, RADIANS, remedy)


RANGES = {
    "mass": positive("leave the effect out of the scene if the slider has no inertia"),
    "support_friction": positive("leave the effect out of the scene if the support is frictionless"),
    "gravity": positive("give the acceleration of gravity, 9.80665 on Earth"),
    "force_angle": _angle(),
    "angle": _angle(),
    "pusher_angle": _angle(f"{TO_RADIANS}; the angle of a velocity is np.arctan2(v_y, v_x)"),
    "pusher_magnitude": nonnegative("reverse the pusher by its angle, not by a sign"),
    "inertia_share": Within(
        lambda x: (x >= 0) & (x <= 1), "numbers in [0, 1]", "give s / (1 + s) with s = m a / W",
    ),
    "force_ratio": positive("give |f| / W"),
    "twist": finite("give (v_x, v_y, omega) at the slider's center", "finite numbers"),
    "velocity": Within(
        lambda speed: (speed == 0) | ((speed >= SPEEDS[0]) & (speed <= SPEEDS[1])),
        f"a speed of {SPEED.allowed}", "choose another unit of length or time",
    ),
}  # fmt: skip
#: Declarations of settings of a simulation.
DURATION = positive("give the time to simulate")
GAP = nonnegative("start on the fence or above it")
RTOL = Single(
    TOLERANCE.holds, TOLERANCE.allowed, "choose a tolerance that double precision can achieve",
    {"type": "number", "minimum": TOLERANCE.minimum, "maximum": TOLERANCE.maximum},
)  # fmt: skip
SAMPLE_COUNT = Single(
    lambda n: SAMPLES.holds(n) and n == int(n), SAMPLES.allowed,
    "request at least the first and the last instant",
    {"type": "integer", "minimum": SAMPLES.minimum, "maximum": int(SAMPLES.maximum)},
)  # fmt: skip
FINGER_RADIUS = nonnegative(
    "give the radius of the finger in the scene's unit of length, or leave it out for a point"
)
DISTANCE = Single(
    lambda x: 0 < x < math.inf, "a finite number > 0", "give a positive number, or leave it out",
    NUMBER | {"exclusiveMinimum": 0},
)  # fmt: skip
ROTATION = OneAngle(
    lambda x: 0 < x <= TURNS, "radians in (0, 4 pi]", "convert degrees with np.deg2rad",
    degrees=Within(
        lambda x: 0 < x <= 720, "degrees in (0, 720]", "give a rotation of at most two turns",
        NUMBER | {"exclusiveMinimum": 0, "maximum": 720},
    ),
)  # fmt: skip
#: Angles of directions. Several are given as an array; a tuple is taken for the components of a vector.
ANGLES = ("force_angle", "angle", "pusher_angle")
#: Ranges of combinations, most of them dimensionless: the parameter that the error names, and the range.
RATIOS = {
    "weight": ("weight", positive("mass, support_friction and gravity multiply to it; check their units")),
    "length_ratio": ("rod_length", Within(
        lambda x: x <= LONGEST, f"at most {LONGEST:g} times the radius",
        "give the radius and the rod length in one unit",
    )),
    "gyration_ratio": ("gyration_radius", Within(
        lambda x: (x >= GYRATION[0]) & (x <= GYRATION[1]),
        f"{GYRATION[0]:g} to {GYRATION[1]:g} times the slider's radius",
        "no slider is so far from its support: model a point mass or a longer rod",
    )),
    "finger_ratio": ("radius", Within(
        lambda x: x <= WIDEST, f"at most {WIDEST:g} times the slider's radius",
        "give the radius of the finger in the unit of the rod length",
    )),
    "conservative_gyration": ("gyration_radius", Within(
        lambda x: abs(x - 1) <= 1e-12, "the radius of the ring",
        "use motion_cone, which is exact for every radius of gyration",
    )),
    "force_ratio": ("pusher_magnitude", Within(
        lambda x: (x >= SHARES[0]) & (x <= SHARES[1]),
        f"m a / W in [{SHARES[0]:g}, {SHARES[1]:g}] for a scene with friction and inertia",
        "leave out the effect that is negligible in the motion",
    )),
}  # fmt: skip


def require_in_range(name: str, value: Number) -> Number:
    """The given parameter in double precision; blocks of a lazy one are checked when computed.

    Raises
    ------
    InvalidValue
        If a number is outside the range, with the name, the first number outside, and the range.
    """
    if name in ANGLES and isinstance(value, tuple):
        raise InvalidValue(name, value, RANGES[name].allowed, RANGES[name].remedy)
    return RANGES[name].require(name, value)


def require_ratio(ratio: str, values: Number) -> Number:
    """Refuse parameters out of proportion to one another; result and errors as in `require_in_range`."""
    name, allowed = RATIOS[ratio]
    return allowed.require(name, values)
