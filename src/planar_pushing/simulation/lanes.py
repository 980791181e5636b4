"""Quasi-static motion of many scenes at once: one lane per scene, every formula elementwise.

Friction alone makes the motion homogeneous of degree 1 in the fence velocity, so while the contact lasts
a lane's rotation and slip depend on its rod angle only. Lengths are in units of the ring's radius.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import QUARTER_TURN, Array, direction, moment_arm
from planar_pushing.simulation.ring_lanes import ring_kernel

Index = npt.NDArray[np.intp]
#: After a Newton step this small, relative to the distance from the ends, the error is rounding.
SETTLED = 1e-7
ITERATIONS = 100
TINY = 1e-100


class Motion(NamedTuple):
    """Rotation and slip per unit time, and what is left before the mode ends; shape (lanes,) each.

    `margin` is dimensionless (radians of force angle in a stick, share of the fence speed in a slip)
    and negative where the mode is not consistent. `inner` is positive where the motion centre lies
    outside the ring (|k| < 1) and negative where it lies inside, between 1 and -1.
    """

    spin: Array
    slip: Array
    margin: Array
    inner: Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Lanes:
    """Parameters of the scenes, shape (lanes,) each.

    Attributes
    ----------
    length : ndarray
        Rod length.
    heading : ndarray
        Angle of the fence velocity, radians.
    pusher : ndarray, shape (lanes, 2)
        Fence velocity, radii per time.
    right, left : ndarray
        Edges of the friction cone, radians.
    """

    length: Array
    heading: Array
    pusher: Array
    right: Array
    left: Array

    @property
    def speed(self) -> Array:
        """Fence speed."""
        return np.hypot(self.pusher[:, 0], self.pusher[:, 1])

    def take(self, index: Index) -> Lanes:
        """These lanes alone."""
        names = ("length", "heading", "pusher", "right", "left")
        return replace(self, **{name: getattr(self, name)[index] for name in names})


def newton(function: Callable[[Array, Index], tuple[Array, Array]], guess: Array) -> Array:
    """Roots in [0, 1] of functions that increase there.

    Parameters
    ----------
    function : callable
        Of unknowns and of the lanes they belong to: values and slopes.
    guess : ndarray
        Near the roots.

    Notes
    -----
    Newton steps, with bisection where one leaves the bracket; a lane that has settled drops out.
    """
    x, todo = guess.copy(), np.arange(len(guess))
    low, high = np.zeros(len(guess)), np.ones(len(guess))
    for _ in range(ITERATIONS):
        old = x[todo]
        value, slope = function(old, todo)
        low[todo] = np.where(value <= 0, old, low[todo])
        high[todo] = np.where(value >= 0, old, high[todo])
        new = old - value / slope
        inside = (new >= low[todo]) & (new <= high[todo])
        x[todo] = np.where(inside, new, (low[todo] + high[todo]) / 2)
        todo = todo[np.abs(new - old) > SETTLED * np.minimum(old, 1 - old)]
        if not len(todo):
            break
    return x


def _torque(length: Array, along: Array, aside: Array, share: Array) -> tuple[Array, Array]:
    """Torque about the contact per unit weight and radius, and its slope over the share, > 0."""
    across = (1 - share) * aside
    speed = np.hypot(along, across)
    sine = across / speed
    ratio = share * aside / (length * speed)
    force, torque, bend = ring_kernel(ratio)
    lever = 1 + ratio * length * sine
    slope = (bend * lever**2 + force * (length * along / speed) ** 2) / speed
    return torque - length * force * sine, slope * aside / length


def rotation_share(length: Array, along: Array, aside: Array, guess: Array) -> Array:
    """Part of the contact's motion across the rod that the rotation takes, in [0, 1].

    Parameters
    ----------
    length : ndarray
        Rod length in radii.
    along, aside : ndarray
        Contact velocity along the rod, and the size of its part across it, which is not 0.
    guess : ndarray
        A share near the root.

    Notes
    -----
    The torque about the contact is the slope of a convex potential (Sec. 3), so there is one root.
    """
    return newton(lambda x, i: _torque(length[i], along[i], aside[i], x), guess)


def spin_ratio(arm: Array, guess: Array) -> tuple[Array, Array]:
    """Spin ratio under a force of this moment arm, in radii, and a guess for the next one.

    ``t(k) = h f(k)``, solved inside the ring; outside, h and k are the reciprocals (H is self-dual).
    """
    size = np.abs(arm)
    far = size > 1
    inner = np.divide(1.0, size, out=size.copy(), where=far)

    def excess(k: Array, index: Index) -> tuple[Array, Array]:
        force, torque, bend = ring_kernel(k)
        h = inner[index]
        return torque - h * force, bend * (1 + h * k)

    k = newton(excess, guess)
    with np.errstate(divide="ignore"):
        return np.copysign(np.where(far, 1 / k, k), arm), k


def first_share(length: Array) -> Array:
    """Share of a nearly translating ring, where ``t = k/2`` and ``f = 1``."""
    return np.asarray(2 * length**2 / (1 + 2 * length**2))


def sticking(lanes: Lanes, rod_angle: Array, guess: Array) -> tuple[Motion, Array]:
    """The contact moves with the fence: of all such twists the one of least potential.

    Returns the motion and the share of the rotation, which is a guess for the next one.
    """
    lean = rod_angle - lanes.heading
    along, aside = np.cos(lean), np.sin(lean)
    share = rotation_share(lanes.length, along, np.maximum(np.abs(aside), TINY), guess)
    force_angle = rod_angle - np.arctan2((1 - share) * aside, along)
    half = (lanes.left - lanes.right) / 2
    offset = np.remainder(force_angle - QUARTER_TURN + np.pi, 2 * np.pi) - np.pi
    spin = lanes.speed * share * aside / lanes.length
    across, turn = np.hypot(along, (1 - share) * aside), share * np.abs(aside) / lanes.length
    inner = (across - turn) / (across + turn)
    return Motion(spin, np.zeros_like(spin), half - np.abs(offset), inner), share


def slipping(
    lanes: Lanes, rod_angle: Array, mode: ContactMode, guess: Array
) -> tuple[Motion, Array]:
    """The force lies on the edge opposite to the slip; the normal motion is the fence's.

    Returns the motion and the spin ratio, or its reciprocal, as a guess for the next one.
    """
    side, edge = (1, lanes.left) if mode is ContactMode.SLIP_RIGHT else (-1, lanes.right)
    ratio, found = spin_ratio(moment_arm(lanes.length, rod_angle, edge), guess)
    toward, reach = direction(edge), lanes.length[:, None] * direction(rod_angle)
    advance = toward[:, 1] - ratio * reach[:, 0]
    speed = np.divide(lanes.pusher[:, 1], advance, out=np.zeros_like(advance), where=advance != 0)
    slip = speed * (toward[:, 0] + ratio * reach[:, 1]) - lanes.pusher[:, 0]
    margin = np.where(speed > 0, side * slip / lanes.speed, -1.0)
    inner = (1 - np.abs(ratio)) / (1 + np.abs(ratio))
    return Motion(ratio * speed, slip, margin, inner), found
