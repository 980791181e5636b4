"""The pusher's motion as polynomials: values, derivatives and displacements of a given function."""

import math

import numpy as np
import pytest
from mechanics.builders import make_scene

import planar_pushing as pp
from planar_pushing.core.motion.kinematics import fence as core
from planar_pushing.core.motion.kinematics.run import PIECE, SERIES_OF_PIECE, PusherPiece
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.simulation.inputs import Scenes, numbers_of
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.options import Policy


def pieces_of(pusher, duration, radius, **options):
    """Pieces of the motion of a pusher, shape (pieces, numbers)."""
    scene = make_scene(2, 0.5, radius=radius)
    problem = Problem(scene=scene, pusher=pusher, duration=duration, **options)
    data, numbers = numbers_of(problem)
    scenes = Scenes.of(problem, data, np.array([numbers], float))
    pieces, counts = scenes.pieces(slice(None))
    assert counts.tolist() == [pieces.shape[1]]
    return pieces[0]


def motion_of(pusher, duration, radius, **options):
    """The same, as the core reads them."""
    pieces = pieces_of(pusher, duration, radius, **options)
    coefficients = (pieces.shape[1] - PIECE) // SERIES_OF_PIECE
    return core.Fence(memoryview(pieces.reshape(-1)), len(pieces), coefficients)


def test_constant_pieces_are_spans_of_their_own():
    pusher = pp.Pusher(velocity=[(0, (1, 2)), (0.5, (0, 0)), (2.0, (3, -1))])
    fence = motion_of(pusher, 1.5, 0.5)
    spans = [core.span_at(fence, i) for i in range(fence.number)]
    assert [(s.start, s.end, s.constant) for s in spans] == [(0, 0.5, True), (0.5, 1.5, True)]
    assert core.fence_velocity(fence, spans[0], 0.2) == (2.0, 4.0)
    assert core.fence_acceleration(fence, spans[0], 0.2) == (0.0, 0.0)
    assert core.fence_displacement(fence, spans[1], 1.0) == (1.0, 2.0)
    assert core.typical_speed(fence) == math.hypot(2, 4)


def test_a_smooth_function_is_a_polynomial_to_rounding():
    pusher = pp.Pusher(velocity=lambda t: (0.2 * t, math.sin(5 * t)))
    fence = motion_of(pusher, 3.0, 2.0)
    during = core.span_at(fence, 0)
    assert fence.number < 10
    assert not during.constant
    for time in np.linspace(0, 3, 101):
        assert core.fence_velocity(fence, during, time) == pytest.approx(
            (0.1 * time, math.sin(5 * time) / 2), abs=4e-15
        )
        assert core.fence_acceleration(fence, during, time) == pytest.approx(
            (0.1, 2.5 * math.cos(5 * time)), abs=1e-12
        )
        assert core.fence_displacement(fence, during, time) == pytest.approx(
            (0.05 * time**2, (1 - math.cos(5 * time)) / 10), abs=4e-15
        )


@pytest.mark.parametrize(
    "velocity",
    [(0.0, 1.0), [(0, (0.0, 1.0)), (0.8, (1.0, 0.0))], lambda t: (0.0, 1.0 + t)],
    ids=["constant", "pieces", "function"],
)
def test_each_piece_holds_its_policy(velocity):
    policies = [(0, "stick"), (0.5, "separate"), (0.8, "slip-left"), (3.0, "stick")]
    pusher = pp.Pusher(velocity=velocity)
    pieces = pieces_of(pusher, 1.0, 2.0, on_ambiguity=policies)
    starts, held = np.array([0, 0.5, 0.8]), [list(Policy).index(name) for _, name in policies]
    assert set(starts) <= set(Columns(PusherPiece, pieces).start)
    for piece in pieces:
        columns = Columns(PusherPiece, piece)
        assert columns.policy == held[np.flatnonzero(starts <= columns.start)[-1]]
    ways = [
        core.fence_displacement(fence, core.span_at(fence, fence.number - 1), 1.0)
        for fence in (
            motion_of(pusher, 1.0, 2.0, on_ambiguity=policies),
            motion_of(pusher, 1.0, 2.0),
        )
    ]
    assert ways[0] == pytest.approx(ways[1], abs=1e-14)


def test_a_function_with_a_jump_ends_in_a_bounded_number_of_pieces():
    fence = motion_of(pp.Pusher(velocity=lambda t: (0.0, 1.0 if t < 1 / 3 else 2.0)), 1.0, 1.0)
    assert 1 < fence.number < 200
    x, y = core.fence_displacement(fence, core.span_at(fence, 0), 1.0)
    assert (x, y) == pytest.approx((0, 5 / 3), abs=1e-8)
