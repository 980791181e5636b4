"""Proofs that an affine function of the place bounds what a unit of pressure adds to a load.

At the rotation eta, the force e of a unit of pressure at r adds ``h(r) = w . e`` with ``w = d + k J r`` to
the component d of the force plus k times the torque about the contact. If ``a + b . r >= h(r)`` on the
base, then ``a + b . c >= sum p h`` for every pressure with the center c. Along each ray from the center of
rotation, h is affine: the inequality holds in an area if it holds on its rim, and at the center of
rotation, where e is any unit vector and h is ``|w|``.

A multiplier is a row (a, b_x, b_y, k). Over an interval of rotations it is interpolated linearly between
those at the ends. The excess of h over the bound is itself bounded by its second derivative on boxes of arc
length and rotation, with a margin for rounding, and boxes are halved until the bound is sharp.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.stability.base_region import Base, Flags, Ints

#: Rounding errors of the terms of h and of its bound, relative to the terms.
ROUNDING = 1e-14
#: Accuracy of an excess that is larger than the tolerance, relative to it.
ROUGH = 0.1
#: Maximum number of halvings, and of boxes after each.
HALVINGS, BOXES = 45, 20000


@dataclass(frozen=True, eq=False)
class Bound:
    """An affine bound at each rotation of an interval, between multipliers at its ends.

    Attributes
    ----------
    low, high : float
        Ends of the interval of eta; equal for one rotation.
    first, last : ndarray, shape (4,)
        Multipliers at the ends.
    direction : ndarray, shape (2,)
        The component d of the force.
    """

    low: float
    high: float
    first: Array
    last: Array
    direction: Array

    @property
    def slope(self) -> Array:
        """Change of the multiplier with eta."""
        width = self.high - self.low
        return (self.last - self.first) / width if width > 0.0 else np.zeros(4)

    def multipliers(self, eta: Array) -> Array:
        """Multipliers, shape S + (4,)."""
        return np.asarray(self.first + (eta - self.low)[..., None] * self.slope)

    def value(self, center: Array) -> float:
        """Largest value of the affine functions at a center of pressure."""
        return max(float(row[0] + row[1:3] @ center) for row in (self.first, self.last))

    @property
    def margin(self) -> float:
        """Rounding error of `value`."""
        return ROUNDING * float(np.abs([self.first, self.last])[:, :3].sum(axis=1).max())


def proved_maximum(base: Base, bound: Bound, tolerance: float) -> float:
    """Upper bound of the component d of the force plus k times the torque, for every pressure.

    Parameters
    ----------
    base : Base
    bound : Bound
        Any multipliers are valid; good ones give a sharp bound.
    tolerance : float
        Accuracy with which the excess of h over the affine function is bounded.
    """
    excess = max(_excess_on_curves(base, bound, tolerance), _excess_at_centers(base, bound))
    return bound.value(base.center) + bound.margin + max(excess, 0.0)


def _excess_on_curves(base: Base, bound: Bound, tolerance: float) -> float:
    """Upper bound of ``h - a - b . r`` on all curves."""
    count = len(base.curves.length)
    half_length, half_turn = base.curves.length / 2.0, (bound.high - bound.low) / 2.0
    parts = np.where(base.curves.length > 0.0, 4, 1)
    number = np.repeat(np.arange(count), parts)
    rank = np.arange(len(number)) - np.repeat(np.cumsum(parts) - parts, parts)
    half = half_length[number] / parts[number]
    boxes = _Boxes(
        number, (2 * rank + 1) * half, half,
        np.full(len(number), bound.low + half_turn), np.full(len(number), half_turn),
    )  # fmt: skip
    settled = -np.inf
    for _ in range(HALVINGS):
        sampled, upper = _bounds(base, bound, boxes)
        most = max(settled, float(sampled.max()), 0.0)
        goal = most + max(tolerance, ROUGH * most)
        open_ = upper > goal
        settled = max(settled, float(upper[~open_].max(initial=-np.inf)))
        if not open_.any():
            return settled
        if open_.sum() > BOXES:
            break
        rest, boxes = float(upper[open_].max()), boxes.halve(open_)
    else:
        return max(settled, rest)
    return max(settled, float(upper.max()))


@dataclass(frozen=True, eq=False)
class _Boxes:
    """Boxes of arc length and rotation: the curve, middles and half widths."""

    number: Ints
    along: Array
    half: Array
    eta: Array
    half_turn: Array

    def halve(self, which: Flags) -> _Boxes:
        """The halves of some boxes, across their longer side."""
        number, along, half, eta, turn = (
            part[which] for part in (self.number, self.along, self.half, self.eta, self.half_turn)
        )
        by_length = half >= turn
        half, turn = np.where(by_length, half / 2.0, half), np.where(by_length, turn, turn / 2.0)
        shift, rotation = np.where(by_length, half, 0.0), np.where(by_length, 0.0, turn)
        return _Boxes(
            np.tile(number, 2), np.concatenate([along - shift, along + shift]), np.tile(half, 2),
            np.concatenate([eta - rotation, eta + rotation]), np.tile(turn, 2),
        )  # fmt: skip


def _bounds(base: Base, bound: Bound, boxes: _Boxes) -> tuple[Array, Array]:
    """The excess in the middle of boxes, and an upper bound of it on each box.

    Along a segment from the middle, derivatives by the way are marked by one or two: of v, w and the affine
    function they are bounded by polynomials in the half widths, and those of e follow.
    """
    curve, a, b = boxes.number, boxes.half, boxes.half_turn
    r, tangent = base.curves.points(curve, boxes.along)
    curvature, on_path = base.curves.curvature[curve], base.on_path[curve]
    cosine, sine = np.cos(boxes.eta), np.sin(boxes.eta)
    q, turned, u = _turn_quarter(r), _turn_quarter(tangent), base.motion
    m, slope = bound.multipliers(boxes.eta), bound.slope
    k, k_slope = m[:, 3], slope[3]

    v = cosine[:, None] * u + sine[:, None] * q
    v_along, v_turn = sine[:, None] * turned, cosine[:, None] * q - sine[:, None] * u
    w = bound.direction + k[:, None] * q
    speed, size_w = _norm(v), _norm(w)
    with np.errstate(divide="ignore", invalid="ignore"):
        e = v / speed[:, None]
        h = _dot(w, e)
        affine = m[:, 0] + _dot(m[:, 1:3], r)
        rise_along = k * _dot(turned, e) - _dot(m[:, 1:3], tangent)
        rise_along += _dot(w, v_along - _dot(v_along, e)[:, None] * e) / speed
        rise_turn = k_slope * _dot(q, e) - slope[0] - r @ slope[1:3]
        rise_turn += _dot(w, v_turn - _dot(v_turn, e)[:, None] * e) / speed

        reach = _norm(r) + a
        sines, ks = np.minimum(np.abs(sine) + b, 1.0), np.abs(k) + abs(k_slope) * b
        b_size = _norm(m[:, 1:3]) + np.hypot(*slope[1:3]) * b
        v_one = sines * a + np.sqrt(1.0 + reach**2) * b
        max_speed, min_speed = speed + v_one, speed - v_one
        v_two = sines * curvature * a**2 + 2.0 * a * b + max_speed * b**2
        # Across v only: e does not change along a line through the center of rotation.
        across = np.abs(_cross(v, v_along)) * a + np.abs(_cross(v, v_turn)) * b + max_speed * v_two
        v_across = np.minimum(v_one, across / min_speed)
        v_across[on_path], v_two[on_path] = 0.0, 0.0
        w_one = ks * a + abs(k_slope) * reach * b
        w_most, turns = size_w + w_one, v_across / min_speed
        # On a circle, what bends w and what bends the affine function may cancel.
        bent = (
            _norm(-k[:, None] * _turn_quarter(e) - m[:, 1:3])
            + ks * turns
            + (b_size - _norm(m[:, 1:3]))
        )
        bend = (bent + abs(k_slope) * b) * curvature * a**2 + 2.0 * w_one * turns
        bend += w_most * (v_two / min_speed + 2.0 * v_one * turns / min_speed)
        bend += 2.0 * (abs(k_slope) + np.hypot(*slope[1:3])) * a * b

        terms = w_most + np.abs(m[:, 0]) + b_size * reach
        smooth = h - affine + np.abs(rise_along) * a + np.abs(rise_turn) * b + bend / 2.0
        smooth += ROUNDING * (terms + w_most / speed)
        crude = w_most - affine + b_size * a + (abs(slope[0]) + np.hypot(*slope[1:3]) * reach) * b
        crude += ROUNDING * terms
        upper = np.where((min_speed > 0.0) & (smooth < crude), smooth, crude)
        sampled = np.where(speed > 0.0, h, size_w) - affine
    return sampled, upper


def _excess_at_centers(base: Base, bound: Bound) -> float:
    """Upper bound of ``|w| - a - b . r`` at the centers of rotation inside an area.

    Times |sin(eta)|, w is ``y = sin(eta) d - cos(eta) k u``, up to its sign, and the affine function ``z =
    sin(eta) a + cos(eta) b . J u``. Between the ends of an interval of the width D they differ from linear
    functions by at most D^2 / 8 times their second derivatives, and a norm of a linear function is convex.
    """
    worst, slope = -np.inf, bound.slope
    for low, high in base.inner_spans:
        ends = np.array([max(low, bound.low), min(high, bound.high)])
        if ends[0] > ends[1]:
            continue
        sine, cosine, m = np.sin(ends), np.cos(ends), bound.multipliers(ends)
        sign = 1.0 if low + high > 0.0 else -1.0
        y = sine[:, None] * bound.direction - (cosine * m[:, 3])[:, None] * base.motion
        z = sign * (sine * m[:, 0] + cosine * (m[:, 1:3] @ base.path))
        most = np.abs(m).max(axis=0)
        bend = np.hypot(*bound.direction) + most[3] + 2.0 * abs(slope[3])
        bend += most[:3].sum() + 2.0 * np.abs(slope[:3]).sum()
        excess = (_norm(y) - z).max() + bend * (ends[1] - ends[0]) ** 2 / 8.0
        excess += ROUNDING * (1.0 + most.sum())
        # The factor |sin| is smallest where the center is farthest, which is an end of the interval.
        worst = max(worst, float(excess / np.abs(sine).min() if excess > 0.0 else excess))
    return worst


def _turn_quarter(vectors: Array) -> Array:
    """Vectors rotated by +90 degrees."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def _dot(a: Array, b: Array) -> Array:
    return np.asarray((a * b).sum(axis=-1))


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def _norm(a: Array) -> Array:
    return np.sqrt(a[..., 0] ** 2 + a[..., 1] ** 2)
