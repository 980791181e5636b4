"""Roots of functions without slopes, against ones that are known."""

from __future__ import annotations

from math import copysign, exp
from typing import NamedTuple

import pytest
from scipy.optimize import brentq

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess


class Decay(NamedTuple):
    """``r - exp(-x)``: it increases."""

    level: float


class Leap(NamedTuple):
    """-1 below a place, and above it 1."""

    place: float


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


EQUATIONS.update({Decay: _decay, Leap: _leap, Cube: _cube})


def between(equation, low, high):
    return bracketed(equation, low, high, excess(equation, low)[0], excess(equation, high)[0])


@pytest.mark.parametrize("level", [1e-3, 0.2, 0.9])
def test_smooth_roots_are_scipys(level):
    theirs = brentq(lambda x: level - exp(-x), 0.0, 20.0, xtol=1e-15, rtol=1e-15)
    assert between(Decay(level), 0.0, 20.0) == pytest.approx(theirs, rel=1e-14)


@pytest.mark.parametrize("place", [1e-12, 0.3, 17.0])
def test_the_place_of_a_leap_is_found(place):
    assert between(Leap(place), -5.0, 20.0) == pytest.approx(place, rel=1e-14)


def test_a_flat_root_is_found_to_what_its_values_tell():
    assert between(Cube(0.7), -1.0, 2.0) == pytest.approx(0.7, abs=1e-12)
