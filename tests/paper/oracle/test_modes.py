"""Contact modes: published cases, ties, every law, and completeness against a dense scan of signs."""

import math
from itertools import pairwise

import pytest
from flint import arb, ctx, fmpq
from oracle.sliders import BOTH, EFFECTS, FRICTION, INERTIA, slider

from pulling_by_pushing.oracle.balls import PRECISION, Undecided, at_degrees, cone_edge, rational
from pulling_by_pushing.oracle.complete import path
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    Mode,
    contact_modes,
)
from pulling_by_pushing.oracle.shapes import support

SEPARATE, STICK, RIGHT, LEFT = Mode
#: Spin ratio and normal motion of the slowest slip for mu = 1.4, l = 2: n . u falls to -0.0400296
#: (PHYSICS: 5).
LEAST = -0.0400296066


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def solve(one, law, angle, magnitude=1):
    return contact_modes(one, law, at_degrees(angle), rational(magnitude))


def modes(*args, **parameters):
    return [solution.mode for solution in solve(*args, **parameters)]


@pytest.mark.parametrize("effects", EFFECTS)
def test_pulling_has_three_solutions(effects):
    assert modes(slider(2, effects=effects), Law(2.0), -10) == [SEPARATE, STICK, LEFT]


@pytest.mark.parametrize("effects", EFFECTS)
def test_infinite_friction_slips_by_its_first_definition_only(effects):
    one = slider(2, effects=effects)
    assert modes(one, INFINITE_FREE, 165) == [RIGHT]
    assert modes(one, INFINITE_NONE, 165) == []
    (rough,) = solve(one, PERFECTLY_ROUGH, 165)
    assert rough.mode is STICK
    state = rough.motion.numbers(one, lambda s: [s.to_fence(s.f_x, s.f_y)[1]])
    assert state[0].ball < 0


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("length", [0, 0.25, 1, 5, 10])
@pytest.mark.parametrize("law", [INFINITE_FREE, INFINITE_NONE])
def test_a_normal_push_never_slips(effects, length, law):
    assert modes(slider(length, effects=effects), law, 90) == [STICK]


def test_slow_pulling_without_fast_pulling():
    one = slider(2, effects=BOTH)
    assert modes(one, Law(1.4), -2, 0.1) == [SEPARATE, STICK, LEFT]
    assert modes(one, Law(1.4), -2, 10) == [SEPARATE]


def test_two_slips_past_the_minimum_of_the_normal_motion():
    """mu = 1.4, l = 2: n . u falls to -0.0400 at |f| = 1.40897 and is back at 0 at |f| = 2.22518."""
    one = slider(2, effects=BOTH)
    separate, slow, fast = solve(one, Law(1.4), -1, 1.42)
    assert (separate.mode, slow.mode, fast.mode) == (SEPARATE, LEFT, LEFT)
    sizes = [math.hypot(*map(float, s.motion.force)) for s in (slow, fast)]
    assert sizes[0] < 1.40897 < sizes[1] < 2.22518
    motions = path(one, cone_edge(1.4, 1))
    assert [part.slope_sign for part in motions.parts] == [-1, 0, 1]
    assert len(motions.spins(arb(LEAST * (1 - 1e-6)))) == 2
    assert motions.spins(arb(LEAST * (1 + 1e-6))) == []


@pytest.mark.parametrize("mu", [0.5, 1.2, 1.3, 1.4, 1.45, 1.5, 2.0, math.inf])
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("length", [0.5, 2, 5])
def test_slips_are_complete_against_a_dense_scan(mu, side, length):
    """The certified parts and a scan of signs at 400 speeds count the same motions."""
    motions = path(slider(length, effects=BOTH), cone_edge(mu, side))
    start, end = float(motions.friction), float(motions.inertia)
    grid = [
        start + (end - start) * (1 - math.cos(math.pi * (i + 0.5) / 400)) / 2 for i in range(400)
    ]
    values = [float(motions.normal_motion(arb(k))) for k in grid]
    for target in (-1.0, -0.3, -0.04, -0.01, 0.013, 0.5, 3.0):
        changes = sum((a > target) != (b > target) for a, b in pairwise(values))
        assert len(motions.spins(arb(target))) == changes


@pytest.mark.parametrize("gyration_radius", [0.25, 3.0])
def test_a_rim_inside_the_interval(gyration_radius):
    """Away from rho = R the spin ratio of the ring itself, where t' is infinite, can lie between."""
    one = slider(2, effects=BOTH, gyration_radius=gyration_radius)
    motions = path(one, cone_edge(3.0 if gyration_radius < 1 else 20.0, 1))
    assert (
        min(motions.friction, motions.inertia, key=float)
        < 1
        < max(motions.friction, motions.inertia, key=float)
    )
    assert any(part.slope_sign for part in motions.parts)


def test_the_normal_motion_stays_finite_where_the_edge_of_inertia_is_along_the_fence():
    motions = path(slider(2, effects=BOTH), cone_edge(1.5, 1))
    assert motions.stays
    assert len(motions.parts) == 1
    assert motions.spins(arb(-0.26)) == []
    assert len(motions.spins(arb(-0.24))) == 1


def test_an_edge_along_the_fence_has_no_slip_of_its_own():
    one = slider(2, effects=INERTIA)
    for angle in (0, 180, 90, -90):
        assert LEFT not in modes(one, Law(1.5), angle)
    separate, stick = solve(one, Law(1.5), 0)
    assert (separate.mode, stick.mode, stick.continuum) == (SEPARATE, STICK, True)


def test_no_motion_leaves_the_fence_across_a_normal_rod_under_an_edge_along_it():
    assert modes(slider(4, 90, BOTH), INFINITE_FREE, 150, 0.5) == [STICK]


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("magnitude", [0.1, 10])
def test_a_slip_that_coincides_with_sticking_counts_once(effects, magnitude):
    """mu = 1: the right edge is along the rod, the left one across it, whatever the effects."""
    for angle in (45, 135):
        assert modes(slider(2, effects=effects), Law(1.0), angle, magnitude) == [STICK]
    short = slider(0, effects=effects)
    assert modes(short, INFINITE_FREE, 0, magnitude) == [SEPARATE, STICK]
    assert modes(short, INFINITE_NONE, 0, magnitude) == [SEPARATE]
    assert modes(short, Law(0.0), 90, magnitude) == [STICK]
    assert modes(short, Law(0.0), -90, magnitude) == [SEPARATE]


@pytest.mark.parametrize("gyration", [0.3, 1.0, 2.0])
@pytest.mark.parametrize("magnitude", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("angle", [0, 180])
def test_a_symmetric_slider_pushed_along_the_fence_separates_or_sticks(gyration, magnitude, angle):
    """The force is along the fence at every speed: slips from rest to the stick are a continuum."""
    one = slider(1, 90, BOTH, gyration_radius=gyration)
    separate, stick = solve(one, INFINITE_FREE, angle, magnitude)
    assert (separate.mode, stick.mode, stick.continuum) == (SEPARATE, STICK, True)


def test_one_effect_has_no_scale_and_two_have_one():
    def spin(effects, magnitude):
        stick = solve(slider(2, effects=effects), Law(2.0), -10, magnitude)[1]
        return stick.motion.q[2] / rational(magnitude)

    for effects in (FRICTION, INERTIA):
        assert spin(effects, 0.1).overlaps(spin(effects, 10))
    assert abs(spin(BOTH, 1e-9) - spin(FRICTION, 1)) < 1e-8
    assert abs(spin(BOTH, 1e9) - spin(INERTIA, 1)) < 1e-8


@pytest.mark.parametrize("law", [Law(0.5), INFINITE_FREE, PERFECTLY_ROUGH])
@pytest.mark.parametrize("name", ["points", "square", "segment", "map"])
def test_only_a_ring_has_a_certified_list_with_friction_and_inertia(name, law):
    one = slider(2, 40, BOTH, name=name)
    if law is PERFECTLY_ROUGH:  # sticking is unique
        assert modes(one, law, 60) == [STICK]
        return
    with pytest.raises(Undecided, match="only a ring"):
        solve(one, law, 60)
    with pytest.raises(Undecided, match="only a ring"):  # also under a force along the rod
        solve(slider(2, 90, BOTH, name=name), Law(0.0), 60)


def test_a_force_at_the_edge_of_the_cone_by_rounding_is_undecided():
    """l = 0: the force is along the pusher's motion, and the pusher next to the edge by an ulp."""
    angle = math.degrees(math.atan2(1.0, 2.0))
    with pytest.raises(Undecided, match="rounding decides"):
        solve(slider(0), Law(2.0), angle)


def test_a_corner_is_undecided():
    """mu = 0 along a rod with a segment across it: one force for an interval of motions."""
    across = support({"shape": "segment", "start": (0, -1), "end": (0, 1)})
    one = slider(1, 90, support=across)
    with pytest.raises(Undecided):
        solve(one, Law(0.0), 60)


def test_the_size_of_a_pusher_is_exact():
    stick = solve(slider(2), Law(2.0), 60, fmpq(1, 3))[0]
    assert float(stick.motion.q[0] ** 2 + stick.motion.q[1] ** 2) == pytest.approx(1 / 9)


@pytest.mark.parametrize("law", [Law(0.0), INFINITE_FREE, INFINITE_NONE, Law(0.4)])
@pytest.mark.parametrize("side", [1, -1])
def test_a_sticking_pivot_has_forces_in_the_cone(law, side):
    """A cone without width, and one that is half of the plane, have one side each."""
    one = slider(2, 50, name="points")
    for solution in solve(one, law, 50 + 90 * side):
        if solution.mode is not STICK:
            continue
        assert solution.motion.pivot == solution.end.pivot == 0
        for end in (solution.motion, solution.end):
            x, y = (number.ball for number in end.numbers(one, lambda s: s.to_fence(s.f_x, s.f_y)))
            width = (
                law.friction_coefficient * y if math.isfinite(law.friction_coefficient) else arb(10)
            )
            assert y > -1e-30
            assert abs(x) < width + 1e-30
