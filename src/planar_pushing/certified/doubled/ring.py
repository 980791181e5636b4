"""Friction of the ring (Eqs. 2-3) with 32 digits, with W = R = 1, by the arithmetic-geometric mean.

For 0 < k < 1 the mean of a = 1 and b = sqrt(1 - k^2) gives K = pi / (2 a) at its end, and the halved
differences c on the way give E. Written with their sum S over ``2^(n-1) c_n^2``, n >= 1, nothing cancels
towards k = 0::

    f = (2/pi) E                  = (1 - k^2/2 - S) / a
    t = (2/pi) (E - (1 - m) K)/k  = (k/2 - S/k) / a
"""

from __future__ import annotations

from typing import Any

import numpy as np

from planar_pushing.certified.doubled.numbers import Doubled, choose, doubled

#: 2 / pi, which force and torque have on the ring.
ON_RING = Doubled(np.float64(0.6366197723675814), np.float64(-3.935735335036497e-17))
#: Means after which a and b agree to 32 digits, from the smallest b that is not zero.
_MEANS = 14
#: Half the difference of a and b that no longer changes their mean.
_SETTLED = 1e-34

Wrench = tuple[Doubled, Doubled]


def wrench(k: Any) -> Wrench:
    """Force f and torque t of the ring at finite spin ratios k >= 0; equal ones are evaluated once."""
    if isinstance(k, Doubled):
        return _wrench(k)
    each, place = np.unique(np.asarray(k, dtype=float), return_inverse=True)
    force, torque = _wrench(doubled(each))
    return force[place.reshape(np.shape(k))], torque[place.reshape(np.shape(k))]


def _wrench(k: Doubled) -> Wrench:
    apart, still = (k - 1.0).high, k.high == 0
    beyond, on_ring = apart > 0, apart == 0
    inner = choose(beyond, 1.0 / choose(still, 1.0, k), k)
    first, second = _inside(choose(on_ring | still, 0.5, inner))
    force, torque = choose(beyond, second, first), choose(beyond, first, second)
    force = choose(on_ring, ON_RING, choose(still, 1.0, force))
    return force, choose(on_ring, ON_RING, choose(still, 0.0, torque))


def _inside(k: Doubled) -> Wrench:
    """Force and torque for 0 < k < 1."""
    square = k * k
    a, b = doubled(np.ones_like(k.high)), ((1.0 - k) * (1.0 + k)).sqrt()
    total, part = doubled(np.zeros_like(k.high)), 1.0
    # c = (a - b) / 2 of the step before, without its cancellation.
    c = square / ((a + b) * 2.0)
    for _ in range(_MEANS):
        a, b = (a + b) * 0.5, (a * b).sqrt()
        total = total + c * c * part
        c, part = c * c / ((a + b) * 2.0), 2.0 * part
        if np.all(c.high < _SETTLED):
            break
    force = (1.0 - square * 0.5 - total) / a
    return force, (k * 0.5 - total / k) / a
