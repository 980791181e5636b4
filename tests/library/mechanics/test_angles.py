"""Angle intervals."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp


def test_closed_interval_contains_its_edges_and_every_turn_of_them():
    interval = pp.AngleInterval(-0.5, 1.0)
    angles = np.array([-0.5, 0.0, 1.0])
    for turns in (-1, 0, 1):
        assert np.all(interval.contains(angles + 2 * np.pi * turns))
    for turns in (-2, 3):
        assert np.all(interval.contains(np.mod(angles + 2 * np.pi * turns, 2 * np.pi)))
    assert not np.any(interval.contains([-0.5 - 1e-9, 1 + 1e-9, np.pi, -3.0]))


def test_open_interval_does_not_contain_its_edges():
    interval = pp.AngleInterval(0.0, np.pi, closed=False)
    assert not np.any(interval.contains([0.0, np.pi, -np.pi, 2 * np.pi, -1e-17]))
    assert np.all(interval.contains([1e-9, 1.0, np.pi - 1e-9, 1 + 2 * np.pi]))


@pytest.mark.parametrize("edges", [
    (60, 120), (np.float64(60), 120.0), (0.0, np.int64(90)), (np.array([0.0, -60.0]), 1.0), ([0.0], [90.0]),
], ids=repr)  # fmt: skip
def test_edges_in_degrees_are_refused(edges):
    with pytest.raises(pp.InvalidValue, match=r"AngleInterval: .*radians in .*np\.deg2rad"):
        pp.AngleInterval(*edges)


def test_edges_are_doubles():
    interval = pp.AngleInterval(np.array([0, 1], "i1"), np.array([1, 2], "f2"))
    assert (interval.right.dtype, interval.left.dtype) == (np.float64, np.float64)
    with pytest.raises(pp.InvalidValue, match="give both edges"):
        pp.AngleInterval(np.ma.masked_array([0.0, 1.0], [0, 1]), 2.0)


def test_edges_are_reached_within_rounding_only():
    closed = pp.AngleInterval(0.0, 1.0)
    assert np.all(closed.contains([-1e-16, 1 + 2.3e-16]))
    assert not np.any(closed.contains([-1e-14, 1 + 1e-14]))


def test_degenerate_interval_is_one_direction():
    interval = pp.AngleInterval(1.2, 1.2)
    assert interval.span == 0
    assert interval.contains(1.2)
    assert not interval.contains(1.2 + 1e-9)
    assert not pp.AngleInterval(1.2, 1.2, closed=False).contains(1.2)


def test_full_turn_contains_everything():
    interval = pp.PerfectlyRough().force_angles
    assert interval.span == pytest.approx(2 * np.pi)
    assert np.all(interval.contains(np.linspace(-10, 10, 1001)))


def test_contains_keeps_the_shape():
    assert pp.AngleInterval(0.0, 1.0).contains(np.zeros((2, 3))).shape == (2, 3)
    assert pp.AngleInterval(0.0, 1.0).contains(0.5).shape == ()
    assert pp.AngleInterval(0.25, 1.0).span == 0.75


@pytest.mark.parametrize("edges", [(1.0, 0.0), (float("nan"), 1.0), (0.0, float("nan"))], ids=repr)
def test_angle_interval(edges):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.AngleInterval(*edges)
    assert caught.value.name == "AngleInterval"
    assert caught.value.allowed == "right <= left"
    assert caught.value.remedy == "unwrap the edges first"
    assert str(caught.value).startswith(f"AngleInterval: {edges!r} given; allowed: right <= left; ")


def test_interval_of_arrays_has_one_answer_each():
    interval = pp.AngleInterval(np.array([0.0, 0.0]), np.array([1.0, 2.0]), np.array([True, False]))
    assert np.array_equal(interval.contains([1.0, 2.0]), [True, False])
    assert np.array_equal(interval.contains(1.5), [False, True])
    assert np.array_equal(interval.span, [1.0, 2.0])
    with pytest.raises(pp.InvalidValue):
        pp.AngleInterval(np.array([0.0, 3.0]), np.array([1.0, 2.0]))


def test_in_tells_of_one_direction():
    interval = pp.AngleInterval(-0.5, 1.0)
    assert 0.5 in interval
    assert 1.0 + 2 * np.pi in interval
    assert 2.0 not in interval
    assert np.float32(0.5) in interval


@pytest.mark.parametrize(
    "given", ["east", None, np.nan, np.inf, True, [0.5], np.zeros(2)], ids=repr
)
def test_in_takes_one_angle(given):
    with pytest.raises(pp.InvalidValue) as caught:
        given in pp.AngleInterval(-0.5, 1.0)  # noqa: B015
    assert caught.value.name == "angle"


def test_of_many_intervals_none_has_one_answer():
    intervals = pp.AngleInterval(np.zeros(2), np.ones(2))
    with pytest.raises(pp.InvalidValue, match="call contains for more"):
        0.5 in intervals  # noqa: B015


def test_contains_refuses_what_is_no_angle():
    for given in ("east", [0.0, np.nan], None):
        with pytest.raises(pp.InvalidValue, match=r"angle: .* radians in"):
            pp.AngleInterval(-0.5, 1.0).contains(given)


def test_degrees():
    right, left = pp.AngleInterval(-np.pi / 4, np.pi).degrees
    assert (right, left, type(right)) == (-45.0, 180.0, float)
    right, left = pp.AngleInterval(np.zeros(2), np.array([np.pi, 2 * np.pi])).degrees
    assert np.array_equal(left, [180.0, 360.0])


def test_intervals_are_equal_where_their_edges_are():
    one, other = pp.AngleInterval(0.0, 1.0), pp.AngleInterval(0.0, 1.0, closed=False)
    assert one == pp.AngleInterval(0.0, 1.0)
    assert hash(one) == hash(pp.AngleInterval(0.0, 1.0))
    assert one != other
    many = pp.AngleInterval(np.zeros(2), np.ones(2))
    assert many == pp.AngleInterval(np.zeros(2), np.ones(2))
    assert many != one


@pytest.mark.parametrize("edges", [("a", "b"), (None, 1.0), (0.0, True)], ids=repr)
def test_edges_are_numbers(edges):
    with pytest.raises(pp.InvalidValue, match="allowed: numbers of radians; give both edges"):
        pp.AngleInterval(*edges)
