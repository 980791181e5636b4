"""Contact modes of points with inertia, enclosed, against the published answers for symmetric scenes."""

from __future__ import annotations

import math

import pytest
from flint import fmpq

from planar_pushing.certified.contact.modes import Law, Mode
from planar_pushing.certified.effects import direction
from planar_pushing.certified.effects.modes import modes
from planar_pushing.certified.effects.resistance import Friction, Inertia, Scene
from planar_pushing.certified.supports.pressure.pieces import pieces


def scene(places, weights, length, rod_angle):
    support = pieces({"shape": "points", "positions": places, "weights": weights})
    effects = Friction(support, fmpq(1)), Inertia(fmpq(1), fmpq(1))
    return Scene(fmpq(length), direction.degrees(fmpq(rod_angle)), effects)


def test_a_pivot_about_the_foot_at_the_center_ends_a_continuum():
    """f_y = 2 f_x and f_x = (0.5 + u_x / 3) / 3, up to what the foot holds."""
    feet = scene([(0, 0), (0, 1), (0, -1)], [2, 1, 1], 3, 90)
    separate, slip = modes(feet, Law(0.5), direction.degrees(fmpq(0)), fmpq(1))
    assert (separate.mode, slip.mode) == (Mode.SEPARATE, Mode.SLIP_LEFT)
    assert float(slip.motion[0]) == pytest.approx(0.512461, abs=1e-6)
    assert list(map(float, slip.force)) == pytest.approx([0.223607, 0.447214], abs=1e-6)
    assert slip.pivot == 0
    assert slip.continuum


def test_four_equal_feet_pushed_along_the_fence_stick():
    feet = scene([(1, 1), (-1, 1), (-1, -1), (1, -1)], [1, 1, 1, 1], 1, 90)
    found = modes(feet, Law(math.inf), direction.degrees(fmpq(0)), fmpq(1))
    assert [each.mode for each in found] == [Mode.SEPARATE, Mode.STICK]
