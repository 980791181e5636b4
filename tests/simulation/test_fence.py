"""The fence's motion as polynomials: values, derivatives and displacements of a given function."""

import math

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import make_scene
from planar_pushing.simulation.fence import (
    acceleration,
    displacement,
    span,
    typical_speed,
    velocity,
)
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.options import Policy


def test_constant_pieces_are_spans_of_their_own():
    pusher = pp.Pusher(velocity=[(0, (1, 2)), (0.5, (0, 0)), (2.0, (3, -1))])
    fence = pusher.fence(1.5, 0.5)
    spans = [span(fence, i) for i in range(len(fence))]
    assert [(s.start, s.end, s.constant) for s in spans] == [(0, 0.5, True), (0.5, 1.5, True)]
    assert velocity(fence, spans[0], 0.2) == (2.0, 4.0)
    assert acceleration(fence, spans[0], 0.2) == (0.0, 0.0)
    assert displacement(fence, spans[1], 1.0) == (1.0, 2.0)
    assert typical_speed(fence) == math.hypot(2, 4)


def test_a_smooth_function_is_a_polynomial_to_rounding():
    pusher = pp.Pusher(velocity=lambda t: (0.2 * t, math.sin(5 * t)))
    fence = pusher.fence(3.0, 2.0)
    during = span(fence, 0)
    assert len(fence) < 10
    assert not during.constant
    for time in np.linspace(0, 3, 101):
        assert velocity(fence, during, time) == pytest.approx(
            (0.1 * time, math.sin(5 * time) / 2), abs=4e-15
        )
        assert acceleration(fence, during, time) == pytest.approx(
            (0.1, 2.5 * math.cos(5 * time)), abs=1e-12
        )
        assert displacement(fence, during, time) == pytest.approx(
            (0.05 * time**2, (1 - math.cos(5 * time)) / 10), abs=4e-15
        )


@pytest.mark.parametrize(
    "velocity",
    [(0.0, 1.0), [(0, (0.0, 1.0)), (0.8, (1.0, 0.0))], lambda t: (0.0, 1.0 + t)],
    ids=["constant", "pieces", "function"],
)
def test_each_piece_holds_its_policy(velocity):
    policies = [(0, "stick"), (0.5, "separate"), (0.8, "slip-left"), (3.0, "stick")]
    problem = Problem(
        scene=make_scene(2, 0.5), pusher=pp.Pusher(velocity=velocity), duration=1.0,
        on_ambiguity=policies,
    )  # fmt: skip
    fence = problem.fence(1.0, 2.0)
    starts, held = np.array([0, 0.5, 0.8]), [list(Policy).index(name) for _, name in policies]
    assert set(starts) <= set(fence["start"])
    for piece in fence:
        assert piece.policy == held[np.flatnonzero(starts <= piece.start)[-1]]
    alone = pp.Pusher(velocity=velocity).fence(1.0, 2.0)
    ways = [displacement(each, span(each, len(each) - 1), 1.0) for each in (fence, alone)]
    assert ways[0] == pytest.approx(ways[1], abs=1e-14)


def test_what_rounding_leaves_of_a_velocity_is_zero():
    fence = pp.Pusher(velocity=lambda t: (0.0, t * t)).fence(1.0, 1.0)
    assert velocity(fence, span(fence, 0), 0.0) == (0.0, 0.0)


def test_each_side_of_a_breakpoint_has_its_own_polynomials():
    pusher = pp.Pusher(velocity=lambda t: (0.0, 1.0 if t < 1 else t), breakpoints=(1.0,))
    fence = pusher.fence(2.0, 1.0)
    before, after = span(fence, 0), span(fence, 1)
    assert len(fence) == 2
    assert velocity(fence, before, 1.0)[1] == 1.0
    assert velocity(fence, after, 1.0)[1] == pytest.approx(1.0, abs=1e-15)
    assert acceleration(fence, after, 1.5)[1] == pytest.approx(1.0, abs=1e-13)


def test_a_function_with_a_jump_ends_in_a_bounded_number_of_pieces():
    fence = pp.Pusher(velocity=lambda t: (0.0, 1.0 if t < 1 / 3 else 2.0)).fence(1.0, 1.0)
    assert 1 < len(fence) < 200
    x, y = displacement(fence, span(fence, 0), 1.0)
    assert (x, y) == pytest.approx((0, 5 / 3), abs=1e-8)
