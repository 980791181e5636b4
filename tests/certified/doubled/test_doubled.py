"""Numbers of 32 digits against balls: arithmetic, directions and the friction of the ring."""

import numpy as np
import pytest
from flint import arb, ctx

from planar_pushing.certified import ring as certified
from planar_pushing.certified.balls import PRECISION
from planar_pushing.certified.doubled import angles, ring
from planar_pushing.certified.doubled.numbers import Doubled, doubled

#: Relative error of one operation, and of a function.
OPERATION, FUNCTION = 2.0**-102, 1e-28
RANDOM = np.random.default_rng(13)


def ball(number, at):
    return arb(float(number.high[at])) + arb(float(number.low[at]))


def errors(numbers, exact):
    """Relative errors against balls; absolute ones of zeros."""
    with ctx.workprec(PRECISION):
        apart = [ball(numbers, i) - each for i, each in enumerate(exact)]
        sizes = [1 if each.contains(0) else abs(each) for each in exact]
        return np.array([float(abs(a / s).mid()) for a, s in zip(apart, sizes, strict=True)])


def wide(count=300):
    """Numbers with random low parts, over many sizes."""
    high = RANDOM.standard_normal(count) * 10.0 ** RANDOM.integers(-12, 12, count)
    return Doubled(high, high * RANDOM.uniform(-1, 1, count) * 2.0**-54)


@pytest.mark.parametrize("name", ["__add__", "__sub__", "__mul__", "__truediv__"])
def test_arithmetic(name):
    one, other = wide(), wide()
    with ctx.workprec(PRECISION):
        exact = [getattr(ball(one, i), name)(ball(other, i)) for i in range(300)]
    assert errors(getattr(one, name)(other), exact).max() < OPERATION


def test_square_root():
    numbers = abs(wide())
    with ctx.workprec(PRECISION):
        exact = [ball(numbers, i).sqrt() for i in range(300)]
    assert errors(numbers.sqrt(), exact).max() < OPERATION
    assert doubled(0.0).sqrt().value() == 0


def test_doubles_mix_with_arrays():
    total = 1.0 - np.array([0.25, 0.5]) * doubled([2.0, 4.0]) / 2.0
    np.testing.assert_array_equal(total.value(), [0.75, 0.0])
    np.testing.assert_array_equal((1.0 / doubled([2.0, 4.0])).value(), [0.5, 0.25])


def test_directions():
    turns = np.deg2rad(np.arange(-721.0, 722.0, 7.3))
    with ctx.workprec(PRECISION):
        exact = [arb(float(angle)) for angle in turns]
        cosine, sine = angles.cosine_sine(doubled(turns))
        assert errors(cosine, [each.cos() for each in exact]).max() < FUNCTION
        assert errors(sine, [each.sin() for each in exact]).max() < FUNCTION


def test_quarter_turns_are_exact():
    cosine, sine = angles.cosine_sine(angles.radians(np.arange(-360.0, 361.0, 90.0)))
    np.testing.assert_array_equal(cosine.value(), [1, 0, -1, 0, 1, 0, -1, 0, 1])
    np.testing.assert_array_equal(sine.value(), [0, 1, 0, -1, 0, 1, 0, -1, 0])


def test_turn_from_an_angle_to_a_vector():
    angle = angles.radians([30.0, 30.0, 200.0])
    x, y = np.cos(np.deg2rad([30.0, 31.0, 20.0])), np.sin(np.deg2rad([30.0, 31.0, 20.0]))
    apart = angles.off_direction(angle, x, y).value()
    np.testing.assert_allclose(apart, [0.0, np.sin(np.deg2rad(1.0)), 2.0], atol=1e-15)


def test_ring():
    near = 1.0 + np.array([-1e-3, -1e-9, -1.1e-16, 2.2e-16, 1e-12, 1e-2])
    k = np.concatenate([[0.0, 1.0], near, 10.0 ** np.linspace(-20, 9, 60)])
    force, torque = ring.wrench(k)
    with ctx.workprec(PRECISION):
        exact = [certified.profile(arb(float(each))) for each in k]
        assert errors(force, [each[0] for each in exact]).max() < FUNCTION
        assert errors(torque, [each[1] for each in exact]).max() < FUNCTION


def test_the_ring_keeps_the_shape():
    force, torque = ring.wrench(np.array([[0.5, 2.0], [2.0, 0.5]]))
    np.testing.assert_array_equal(force.value(), torque.value()[::-1])
