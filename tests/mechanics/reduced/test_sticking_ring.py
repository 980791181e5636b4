"""A ring that sticks, against the root of its equation in 40 digits."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf

import reference
from planar_pushing.mechanics.reduced import sticking_ring
from planar_pushing.mechanics.reduced.sticking_ring import held
from planar_pushing.mechanics.supports import ring


def cases(count):
    """Rod length and direction: anywhere, next to the ring, with short and long rods, along and aside."""
    random = np.random.default_rng(4)
    anywhere = 10 ** random.uniform(-6, 6, count), random.uniform(0, np.pi / 2, count)
    usual = random.uniform(0.5, 3, count), random.uniform(0, np.pi / 2, count)
    length = 10 ** random.uniform(0, 6, count)
    on_ring = np.arctan2(length**2 + 1, np.sqrt(length**2 - 1))  # k = 1 with H / k = 1
    off = 10 ** random.uniform(-16, -1, count) * random.choice([-1, 1], count)
    beside = length, np.clip(on_ring + off, 0, np.pi / 2)
    one = 1 + off, np.pi / 2 - 10 ** random.uniform(-16, 0, count)
    thin = 10 ** random.uniform(-6, 6, count), 10 ** random.uniform(-300, -3, count)
    found = [anywhere, usual, beside, one, thin]
    return [
        (float(a), float(np.cos(b)), float(np.sin(b)))
        for pair in found
        for a, b in zip(*pair, strict=True)
    ]


def motion(length, along, aside, leverage):
    """Centre's motion across the rod and R omega, over the contact's motion aside, and the spin ratio."""
    total = length**2 + leverage
    carried, swing = leverage / total, length / total
    return carried, swing, swing * aside / mp.sqrt(along**2 + (carried * aside) ** 2)


def exact(length, along, aside):
    """`motion` at the root of ``H(k) - k H / k`` by H / k, which decreases with it; by bisection."""
    length, along, aside = mpf(length), mpf(along), mpf(aside)
    low, high = mpf("0.5"), mpf(2)
    for _ in range(130):
        middle = (low + high) / 2
        k = motion(length, along, aside, middle)[2]
        more = reference.ring_torque(k) > k * middle * reference.ring_force(k)
        low, high = (middle, high) if more else (low, middle)
    return motion(length, along, aside, low)


@pytest.mark.parametrize("case", cases(20))
def test_the_motion_to_some_ulp_however_near_the_ring(case):
    """Eq. (7) in 40 digits; beside the ring H / k is as steep as log(x), and m is rounded."""
    with mp.workdps(40):
        carried, swing, force = held(*case)
        right_carried, right_swing, k = exact(*case)
        assert float(abs(carried - right_carried)) <= 4e-15 * carried
        assert float(abs(swing - right_swing)) <= 4e-15 * swing
        speed = mp.sqrt(mpf(case[1]) ** 2 + (right_carried * mpf(case[2])) ** 2)
        assert force * speed == pytest.approx(float(reference.ring_force(k)), rel=3e-15, abs=0)


def test_the_force_is_that_of_the_motion():
    """Eq. (2) at the motion that is found, which lies a step beyond the one whose curves were evaluated."""
    rounded = 1 - 2.0**-52, float(np.cos(1.5707963266264238)), 1.0  # 1 - m is all rounding
    for length, along, aside in [rounded, *cases(4000)]:
        carried, swing, force = held(length, along, aside)
        speed = float(np.hypot(along, carried * aside))
        right = ring.ring_wrench(speed, swing * aside)[0]
        assert force * speed == pytest.approx(right, rel=1e-14, abs=0), (length, along, aside)


@pytest.mark.parametrize("length", [0.0, 1e-6, 0.7, 1.0, 2.0, 1e6])
def test_the_ends(length):
    """Along the rod nothing turns; aside the force acts across it, with the rod as its moment arm."""
    assert held(length, -1.0, 0.0)[2] == 1.0
    carried, swing, force = held(length, 0.0, 1.0)
    assert ring.ring_spin_ratio(length) == pytest.approx(swing / carried, rel=1e-15, abs=0)
    right = ring.ring_wrench(carried, swing)[0]
    assert force * carried == pytest.approx(right, rel=4e-15, abs=0)


def test_on_the_ring_itself():
    """A rod of one radius, pushed across: the motion's centre is on the ring, to the last place."""
    for along in (0.0, 6e-17):
        assert held(1.0, along, 1.0) == (0.5, 0.5, pytest.approx(4 / np.pi, rel=1e-15, abs=0))


def test_the_curves_are_evaluated_once(monkeypatch):
    calls, curves = [], ring.curves
    monkeypatch.setattr(ring, "curves", lambda *at: calls.append(at) or curves(*at))
    for case in cases(2):
        held(*case)
    assert len(calls) == 10


def test_the_rough_slope():
    """``g = -t' / f`` to 7e-7, from the ring to a translation."""
    for x in [10.0**-i for i in range(16)] + np.random.default_rng(4).uniform(0, 1, 40).tolist():
        m = 1 - mpf(x)
        exact = -0.5 if x == 1 else (1 - mp.ellipk(m) / mp.ellipe(m)) / m
        assert abs(sticking_ring._rough(x) - exact) <= 7e-7, x
