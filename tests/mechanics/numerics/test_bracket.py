"""Roots of functions without slopes, against ones that are known."""

from __future__ import annotations

from math import copysign, exp
from typing import NamedTuple

import pytest
from scipy.optimize import brentq

from planar_pushing.mechanics.compiled import compiled, kernel
from planar_pushing.mechanics.numerics.bracket import bracketed, dip
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess


class Decay(NamedTuple):
    """``r - exp(-x)``: it increases."""

    level: float


class Leap(NamedTuple):
    """-1 below a place, and above it 1."""

    place: float


class Valley(NamedTuple):
    """``(x - 0.3)^2 - depth``."""

    depth: float


class Cube(NamedTuple):
    """``(x - r)^3``, flat at its root."""

    place: float


@compiled
def _decay(of, x):
    return of.level - exp(-x), 0.0


@compiled
def _leap(of, x):
    return copysign(1.0, x - of.place), 0.0


@compiled
def _cube(of, x):
    return (x - of.place) ** 3, 0.0


@compiled
def _valley(of, x):
    return (x - 0.3) ** 2 - of.depth, 0.0


EQUATIONS.update({Decay: _decay, Leap: _leap, Cube: _cube, Valley: _valley})


@kernel
@compiled
def between(equation, low, high):
    return bracketed(equation, low, high, excess(equation, low)[0], excess(equation, high)[0])


@pytest.mark.parametrize("level", [1e-3, 0.2, 0.9])
def test_smooth_roots_are_scipys(level):
    theirs = brentq(lambda x: level - exp(-x), 0.0, 20.0, xtol=1e-15, rtol=1e-15)
    assert between(Decay(level), 0.0, 20.0) == pytest.approx(theirs, rel=1e-14, abs=0)


@pytest.mark.parametrize("place", [1e-12, 0.3, 17.0])
def test_the_place_of_a_leap_is_found(place):
    assert between(Leap(place), -5.0, 20.0) == pytest.approx(place, rel=1e-14, abs=0)


def test_a_flat_root_is_found_to_what_its_values_tell():
    assert between(Cube(0.7), -1.0, 2.0) == pytest.approx(0.7, abs=1e-12)


@pytest.mark.parametrize(
    ("low", "middle", "high"), [(-1.0, 0.0, 1.0), (0.0, 0.5, 1.0), (0.2, 0.31, 5.0)]
)
def test_a_dip_is_followed_to_where_it_is_negative(low, middle, high):
    for depth in (1e-2, 1e-6, 1e-10):
        of = Valley(depth)
        place, value = dip(of, low, middle, high, excess(of, middle)[0])
        assert value < 0
        assert abs(place - 0.3) < depth**0.5
        assert value == excess(of, place)[0]
    of = Valley(-1e-6)
    assert dip(of, low, middle, high, excess(of, middle)[0])[1] == pytest.approx(1e-6, rel=1e-4)
