"""Roots: brackets that shrink to the last digit, iterations that settle, and small steps by chance."""

from __future__ import annotations

import math

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.core.supports import roots
from planar_pushing.core.supports.tolerances import RESOLVED

ROOT = 0.7310585786300049
#: Functions with a root at ROOT, from the smooth to the step; the second number is the largest number of
#: evaluations. Bisection takes some 55.
FUNCTIONS = {
    "line": (lambda x: x - ROOT, 4),
    "cube": (lambda x: x**3 - ROOT**3, 10),
    "wall": (lambda x: math.expm1(40.0 * (x - ROOT)), 14),
    "plateau": (lambda x: math.tanh(1e6 * (x - ROOT)), 30),
    "step": (lambda x: 1.0 if x >= ROOT else -1.0, 55),
    "fifth power": (lambda x: (x - ROOT) ** 5, 60),
    "pole": (lambda x: 1.0 / (x - 5.0) - 1.0 / (ROOT - 5.0), 8),
}


def root_of(function, low, high):
    """The root in a bracket, and the number of evaluations."""
    bracket, count = roots.open_bracket(low, high, function(low), function(high), RESOLVED), 0
    while not roots.is_narrow(bracket) and count < roots.ITERATIONS:
        count += 1
        x = roots.next_number(bracket)
        assert min(bracket.a, bracket.b) <= x <= max(bracket.a, bracket.b)
        bracket = roots.narrow_bracket(bracket, x, function(x))
        assert bracket.at_a * bracket.at_b <= 0.0
    return roots.best_number(bracket), count


@pytest.mark.parametrize("falls", [False, True], ids=["rises", "falls"])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_bracket_shrinks_to_the_last_digits(name, falls):
    function, most = FUNCTIONS[name]
    sign = -1.0 if falls else 1.0
    for low, high in ((0.0, 1.0), (1.0, 0.0), (-3.0, 1.7), (0.73, 4.0)):
        found, count = root_of(lambda x: sign * function(x), low, high)
        assert abs(found - ROOT) <= 1.5e-15 or abs(function(found)) <= 1e-75
        assert count <= most


@pytest.mark.parametrize("root", [1e-300, 1e-9, -1e12, 0.0])
def test_a_root_is_relative_to_itself(root):
    """Down through all exponents to zero."""
    found, count = root_of(lambda x: x - root, -2e12, 1e13)
    assert found == pytest.approx(root, rel=1e-15, abs=0)
    assert count < 1100
    found, _ = root_of(lambda x: 1.0 if x > root else -1.0, -2e12, 1e13)
    assert found == pytest.approx(root, rel=4e-15, abs=1e-307)


def test_an_end_that_is_the_root_ends_the_search():
    for low, high, at_low, at_high in ((1.0, 2.0, 0.0, 3.0), (1.0, 2.0, -3.0, 0.0)):
        bracket = roots.open_bracket(low, high, at_low, at_high, RESOLVED)
        assert roots.is_narrow(bracket)
        assert roots.best_number(bracket) == (low if at_low == 0.0 else high)


@pytest.mark.parametrize("bottom", [0.05, 0.4, 0.93])
@pytest.mark.parametrize("kind", ["parabola", "corner"])
def test_a_dip_narrows_around_its_bottom(bottom, kind):
    def function(x):
        return (x - bottom) ** 2 if kind == "parabola" else abs(x - bottom)

    dip = roots.Dip(0.0, 0.5, 1.0, function(0.5))
    for _ in range(roots.SECTIONS):
        x = roots.section_of(dip)
        assert dip.low < x < dip.high
        dip = roots.narrow_dip(dip, x, function(x))
        assert dip.low <= bottom <= dip.high
        assert dip.value == function(dip.middle)
    assert dip.high - dip.low < 2e-7
    assert abs(dip.middle - bottom) < 2e-7


@pytest.mark.parametrize(
    ("size", "before", "last"),
    [
        (1e-9, 1e-4, True),  # converges quadratically: the next one is 1e-19
        (1e-9, 1e-6, False),  # the next one is 1e-15
        (5.2e-7, 0.084, False),  # by chance: the next one was 1e-12
        (1e-14, 1e-14, True),
        (1e-3, 0.9, False),
        (1e-9, 0.9, False),  # from too far away: the one before was no step of Newton's
        (3e-13, 1.2e-11, False),  # hardly smaller than the one before
    ],
)
def test_an_iteration_settles(size, before, last):
    assert roots.is_last(size, before) == last


def test_a_slip_after_a_step_that_is_small_by_chance():
    """Friction and inertia, l = 10: the ratio of the force's parts is that of the speeds to rounding."""
    scene = pp.Scene(
        slider=pp.Slider(rod_length=10.0, rod_angle=np.pi / 4), contact=pp.Coulomb(0.1),
        effects=(pp.RingFriction(), pp.Inertia()),
    )  # fmt: skip
    (slip,) = pp.solve(scene, np.deg2rad(29.0), 1.0)
    force = sum(pp.wrench(each, slip.twist, scene.slider) for each in scene.effects)
    assert force[0] / force[1] == pytest.approx(0.1, rel=1e-14)
    assert slip.twist[0] / slip.twist[1] == pytest.approx(0.1, rel=1e-14)
