"""Motion of a contact that sticks, of an even ring alone, by one evaluation of the ring's curves.

The unknown is ``z = H(k) / k`` inside the ring, and outside, where the ring is self-dual, ``z = k / H(k)``.
It lies between 1/2 and 1. With ``q = l^2``, and A and S the squares of the contact's motion along the rod
and aside, the motion has::

    m = k^2   = q S / (A (q + z)^2 + S z^2)           inside
    m = 1/k^2 = (A (1 + q z)^2 + S) / (q S z^2)       outside

and z is the root of ``y(m) - z``, where ``y = 1 + x g`` with ``x = 1 - m`` and ``g = -t' / f``. The
derivatives of K and E (DLMF 19.4) give ``2 m x dy/dm = 1 - 2 x y - m y^2``, so a step of Halley's method
needs g alone. One or two steps take a rough g, and the last one the exact g.
"""

from __future__ import annotations

from math import log, sqrt
from typing import NamedTuple

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.numerics.root import EPSILON
from planar_pushing.mechanics.supports import ring

#: g to 7e-7: ``(L (a x - 1) + 1 - log(4) + b x) / (1 + x (L (c + d x) + e + f x))``, ``L = -log(x) / 2``.
ROUGH = 0.383173071, 0.382015338, 0.498739679, -0.349969874, -0.68175646, -0.309685503
LIMIT = 1.0 - log(4.0)
#: The first z is ``1 - x / (LARGE + SMALL m)`` with the x and m of z = 1, about a Newton step from there.
#: It lies between the ring and the root, where Halley's method converges.
LARGE, SMALL = 2.0, 0.5
#: After a step below this part of x the error is below 1e-5 of it, of which the last step leaves the cube.
CLOSE = 0.02


class Place(NamedTuple):
    """The motion that a value of z gives: m, ``1 - m``, and two derivatives of ``log m`` by z."""

    m: float
    x: float
    rate: float
    bend: float


@compiled
def _inside(q, ahead, beside, z):
    reach = q + z
    move = ahead * reach * reach
    part = 1.0 / (move + beside * z * z)
    x, rate = (move + beside * (z * z - q)) * part, -2.0 * (ahead * reach + beside * z) * part
    bend = rate * rate - 2.0 * (ahead + beside) * part
    return Place(q * beside * part, max(x, ring.LEAST), rate, bend)


@compiled
def _outside(q, ahead, beside, z):
    reach, one, part = 1.0 + q * z, 1.0 / z, 1.0 / (q * beside * z * z)
    move = ahead * reach * reach
    size, x = move + beside, (beside * (q * z * z - 1.0) - move) * part
    rise = 2.0 * ahead * q * reach / size
    bend = 2.0 * ahead * q * q / size - rise * rise + 2.0 * one * one
    return Place(size * part, max(x, ring.LEAST), rise - 2.0 * one, bend)


@compiled
def _rough(x):
    """``g`` at x to 7e-7."""
    a, b, c, d, e, f = ROUGH
    half_log = -log(x) / 2
    value = half_log * (a * x - 1.0) + LIMIT + b * x
    return value / (1.0 + x * (half_log * (c + d * x) + e + f * x))


@compiled
def _halley(place, z, g):
    """The next z."""
    m, x, rate, bend = place
    square = m * g * g
    first = -0.5 - g - x * square / 2  # m dy/dm, and below x times the derivative of that by log m
    second = (0.5 + x * (g + square / 2)) * (1.0 + x * m * g) - x * square * (x - m) / 2
    excess, slope = 1.0 + x * g - z, first * rate - 1.0
    curve = second * rate * rate + x * first * bend
    step = x * excess * slope / (x * slope * slope - excess * curve / 2)
    return min(max(z - step, 0.5), 1.0)


@compiled
def held(length, along, aside):
    """What sticks of the ring: its contact moves by `along` the rod and by `aside` >= 0 of it.

    Returns
    -------
    carried, swing, part : float
        The centre's motion aside and the rotation, over `aside`; and the force over the centre's speed, per
        unit weight.
    """
    q, ahead, beside = length * length, along * along, aside * aside
    moving, turning = ahead * (q + 1.0) * (q + 1.0) + beside, q * beside
    inside, large, small = moving > turning, max(moving, turning), min(moving, turning)
    z = 1.0 - (large - small) / (LARGE * large + SMALL * small)
    for _ in range(2):
        place = _inside(q, ahead, beside, z) if inside else _outside(q, ahead, beside, z)
        z, before = _halley(place, z, _rough(place.x)), z
        if abs(z - before) < CLOSE * place.x:
            break
    place = _inside(q, ahead, beside, z) if inside else _outside(q, ahead, beside, z)
    force, _, slope = ring.curves(place.m, place.x)
    z, before = _halley(place, z, -slope / force), z
    # From there to the root by derivatives: of log m by z, and of the force by m. An x below EPSILON is
    # rounding of z.
    step, (m, x, rate, bend) = z - before, place
    change = step * (rate + step * (rate * rate + bend) / 2)
    force -= m * change * (slope / 2 + (force / max(x, EPSILON) - 2.0 * slope) * change / 8)
    if not inside:  # the torque at 1 / k, which is z f there over k
        whole = 1.0 + q * z
        return 1.0 / whole, length * z / whole, force * whole / (length * aside)
    carried = z / (q + z)
    across = carried * aside
    return carried, length / (q + z), force / sqrt(ahead + across * across)
