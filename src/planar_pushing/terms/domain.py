"""The domain: the range of each parameter, and the error for a value outside it.

Each parameter is listed here once, with its range and a remedy. Parameters are numbers, numpy arrays or
`xarray.DataArray`, of which `planar_pushing.terms.numbers` makes doubles; the blocks of a lazy array are
checked when they are computed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Number as Number
from planar_pushing.terms.numbers import as_numbers, pair_of, remedy_for
from planar_pushing.terms.numbers import is_lazy as is_lazy
from planar_pushing.terms.options import SPEED

#: One number, and many without labels, for the types of functions whose result type follows the arguments.
Scalar = float | np.floating[Any] | np.integer[Any]
Numbers = npt.NDArray[Any] | list[Any]

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
SPEEDS = SPEED.least, SPEED.most


class Range(NamedTuple):
    """Range of a parameter, in code and in words, and the remedy for a value outside it."""

    allows: Callable[[Any], Any]
    allowed: str
    remedy: str


def _positive(remedy: str) -> Range:
    return Range(lambda x: (x > 0) & (x < math.inf), "a finite number > 0", remedy)


def _angle(remedy: str = TO_RADIANS) -> Range:
    return Range(lambda x: abs(x) <= TURNS, RADIANS, remedy)


RANGES = {
    "rod_length": Range(
        lambda x: (x >= 0) & (x < math.inf), "a finite number >= 0",
        "give the distance from the contact to the slider's center",
    ),
    "rod_angle": Range(
        lambda x: (x > 0) & (x < math.pi), "radians in the open interval (0, pi)",
        "keep the slider above the fence; convert degrees to radians with np.deg2rad",
    ),
    "radius": _positive("give it in the unit of the rod length"),
    "mass_center": Range(
        np.isfinite, "a finite number", "give x and y of the center of mass in the body frame",
    ),
    "friction_coefficient": Range(
        lambda x: (x >= 0) & (x <= ROUGHEST), f"a number in [0, {ROUGHEST:g}]",
        "use the law of infinite friction where no coefficient is large enough",
    ),
    "load_force": Range(np.isfinite, "a finite number", "give the components of the force"),
    "load_center": Range(np.isfinite, "a finite number", "give x and y in the body frame"),
    "coefficient": _positive("leave the effect out of the scene if nothing is viscous"),
    "weight": _positive("leave the effect out of the scene if the support is frictionless"),
    "mass": _positive("leave the effect out of the scene if the slider has no inertia"),
    "support_friction": _positive("leave the effect out of the scene if the support is frictionless"),
    "gravity": _positive("give the acceleration of gravity, 9.80665 on Earth"),
    "gyration_radius": _positive("leave the effect out of the scene if the slider has no inertia"),
    "force_angle": _angle(),
    "angle": _angle(),
    "pusher_angle": _angle(f"{TO_RADIANS}; the angle of a velocity is np.arctan2(v_y, v_x)"),
    "pusher_magnitude": Range(
        lambda x: (x >= 0) & (x < math.inf), "a finite number >= 0",
        "reverse the pusher by its angle, not by a sign",
    ),
    "inertia_share": Range(
        lambda x: (x >= 0) & (x <= 1), "numbers in [0, 1]", "give s / (1 + s) with s = m a / W",
    ),
    "force_ratio": _positive("give |f| / W"),
    "twist": Range(np.isfinite, "finite numbers", "give (v_x, v_y, omega) at the slider's center"),
    "velocity": Range(
        lambda speed: (speed == 0) | ((speed >= SPEEDS[0]) & (speed <= SPEEDS[1])),
        f"a speed of {SPEED.allowed}", "choose another unit of length or time",
    ),
    "duration": _positive("give the time to simulate"),
    "gap": Range(
        lambda x: (x >= 0) & (x < math.inf), "a finite number >= 0", "start on the fence or above it",
    ),
}  # fmt: skip
#: Angles of directions. Several are given as an array; a tuple is taken for the components of a vector.
ANGLES = ("force_angle", "angle", "pusher_angle")
#: Range of the ends of a side, and remedy.
SIDE = (
    "(start, end) with start < 0 < end, infinite for a side without an end",
    "measure both ends along the side from the contact, which is between them, the one toward -x first",
)
#: Range of the radius of a finger.
FINGER_RADIUS = Range(
    lambda x: (x >= 0) & (x < math.inf), "a finite number >= 0",
    "give the radius of the finger in the scene's unit of length, or leave it out for a point",
)  # fmt: skip
#: Ranges of combinations, most of them dimensionless: the parameter that the error names, and the range.
RATIOS = {
    "weight": ("weight", _positive("mass, support_friction and gravity multiply to it; check their units")),
    "length_ratio": ("rod_length", Range(
        lambda x: x <= LONGEST, f"at most {LONGEST:g} times the radius",
        "give the radius and the rod length in one unit",
    )),
    "gyration_ratio": ("gyration_radius", Range(
        lambda x: (x >= GYRATION[0]) & (x <= GYRATION[1]),
        f"{GYRATION[0]:g} to {GYRATION[1]:g} times the slider's radius",
        "no slider is so far from its support: model a point mass or a longer rod",
    )),
    "finger_ratio": ("radius", Range(
        lambda x: x <= WIDEST, f"at most {WIDEST:g} times the slider's radius",
        "give the radius of the finger in the unit of the rod length",
    )),
    "conservative_gyration": ("gyration_radius", Range(
        lambda x: abs(x - 1) <= 1e-12, "the radius of the ring",
        "use motion_cone, which is exact for every radius of gyration",
    )),
    "force_ratio": ("pusher_magnitude", Range(
        lambda x: (x >= SHARES[0]) & (x <= SHARES[1]),
        f"m a / W in [{SHARES[0]:g}, {SHARES[1]:g}] for a scene with friction and inertia",
        "leave out the effect that is negligible in the motion",
    )),
}  # fmt: skip


def required(name: str, given: Number) -> Number:
    """The given parameter in double precision; blocks of a lazy one are checked when computed.

    Raises
    ------
    InvalidValue
        If a number is outside the range, with the name, the first number outside, and the range.
    """
    if name in ANGLES and isinstance(given, tuple):
        raise InvalidValue(name, given, RANGES[name].allowed, RANGES[name].remedy)
    return _required(name, given, RANGES[name])


def required_ratio(ratio: str, values: Number) -> Number:
    """Refuse parameters out of proportion to one another; result and errors as in `required`."""
    name, allowed = RATIOS[ratio]
    return _required(name, values, allowed)


def required_side(given: Any) -> tuple[Number, Number]:
    """Ends of a side, measured from the contact, which lies between them; errors as in `required`."""
    pair = pair_of(given)
    if pair is None:
        raise InvalidValue("side", given, *SIDE)
    start, end = pair
    before, behind = Range(lambda x: x < 0, *SIDE), Range(lambda x: x > 0, *SIDE)
    ends = _required("side", start, before), _required("side", end, behind)
    if any(0 in np.shape(each) for each in ends):
        raise InvalidValue("side", given, *SIDE)
    return ends


def required_finger_radius(given: Number) -> Number:
    """The radius of a finger, or radii of many; errors as in `required`."""
    return _required("radius", given, FINGER_RADIUS)


def require_fields(value: object, *names: str) -> None:
    """Check the fields of a frozen value with `required`, and replace them with the results."""
    for name in names:
        object.__setattr__(value, name, required(name, getattr(value, name)))


def _required(name: str, given: Number, allowed: Range) -> Number:
    if type(given) is float and allowed.allows(given):  # most calls; the rest is for the others
        return given
    if is_lazy(given):
        blocks = given.data.map_blocks(lambda block: _block(name, block, allowed), dtype=float)
        return given.copy(data=blocks)
    numbers = as_numbers(given)
    if numbers is None:
        raise InvalidValue(name, given, allowed.allowed, remedy_for(given, allowed.remedy))
    array = np.asarray(numbers)
    wrong = array[~np.asarray(allowed.allows(array), dtype=bool)]
    if wrong.size:
        own = array.ndim == 0 and not isinstance(given, np.number)
        raise InvalidValue(
            name, given if own else float(wrong.flat[0]), allowed.allowed, allowed.remedy
        )
    return numbers


def _block(name: str, block: Any, allowed: Range) -> Any:
    """A block of a lazy array; a block of one number stays an array."""
    return np.asarray(_required(name, block, allowed))
