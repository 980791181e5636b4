"""Interval Newton proves a root from a rough guess, and refuses what is none."""

import math

import pytest
from flint import arb, ctx, fmpq
from oracle.cases import SUPPORTS
from oracle.sliders import BOTH, EFFECTS, INERTIA, slider

from pulling_by_pushing.oracle.balls import (
    PRECISION,
    ROUNDINGS,
    UNIT,
    Undecided,
    at_degrees,
    cone_edge,
)
from pulling_by_pushing.oracle.motions import limit_point, ray, stick, unit_motion
from pulling_by_pushing.oracle.prove import Row3, force_along, krawczyk, moves, torque
from pulling_by_pushing.oracle.shapes import support


@pytest.fixture(autouse=True)
def _precision():
    with ctx.workprec(PRECISION):
        yield


def system(one, force):
    e = force.about(one.rod_angle)
    return [torque, force_along(e.ball), moves((*e.ball, 0), 1)]


def overlap(one, other):
    return all(a.overlaps(b) for a, b in zip(one, other, strict=True))


@pytest.mark.parametrize("off", [1e-3, 0.05, 0.3])
@pytest.mark.parametrize("name", ["ring", "disc", "square", "map", "composite"])
def test_a_guess_that_is_off_reaches_the_same_ball(name, off):
    one, force = slider(2, name=name), cone_edge(2.0, 1)
    motion = ray(one, force)
    guess = [part.mid() + side * off for part, side in zip(motion.q, (1, -1, 1), strict=True)]
    q, _ = krawczyk(one.body, system(one, force), guess)
    assert overlap(q, motion.q)
    assert max(part.rad() for part in q) < 1e-35


@pytest.mark.parametrize("name", ["ring", "square"])
def test_an_error_of_the_torque_by_1e_12_is_seen(name):
    one, force = slider(2, name=name), cone_edge(2.0, 1)
    motion = ray(one, force)

    def wrong(q, wrench):
        change = wrench.value[0] * arb("1e-12")
        return Row3(wrench.value[2] + change, wrench.jacobian[2], wrench.size[2])

    q, _ = krawczyk(one.body, [wrong, *system(one, force)[1:]], motion.q)
    assert not overlap(q, motion.q)


def test_no_root_is_no_proof():
    """No motion has a power of one under a force across it."""
    one, force = slider(2), cone_edge(2.0, 1)
    x, y = force.about(one.rod_angle).ball
    equations = [torque, force_along((x, y)), moves((-y, x, 0), 100)]
    with pytest.raises(Undecided):
        krawczyk(one.body, equations, [x, y, arb("0.1")])


def test_equations_that_depend_on_each_other_are_refused():
    one, force = slider(2), cone_edge(2.0, 1)
    with pytest.raises(Undecided):
        krawczyk(one.body, [torque, torque, *system(one, force)[2:]], [1, 1, arb("0.2")])


def test_a_rim_is_refused():
    """A line of force tangent to the ring: the center is on the ring, where the slopes are infinite."""
    one, force = slider(1), at_degrees(135)
    motion = ray(one, force)
    with pytest.raises(Undecided):
        krawczyk(one.body, system(one, force), motion.q)
    assert motion.exact is not None


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("angle", [20, 45, 100, 135, 250])
def test_motions_satisfy_their_equations(effects, angle):
    force = at_degrees(angle)
    one = slider(2, effects=effects)
    e = force.about(one.rod_angle)
    motions = [unit_motion(one, force)]
    motions += [limit_point(one, force)] if effects != "friction" else [ray(one, force)]
    for motion in motions:
        wrench = one.body.wrench(motion.q)
        for equation in (torque, force_along(e.ball)):
            value = equation(motion.q, wrench).value
            assert value.contains(0)
            assert value.rad() < 1e-30
        assert motion.force[0] * e.ball[0] + motion.force[1] * e.ball[1] > 0


@pytest.mark.parametrize("name", ["ring", "disc", "square", "L", "map", "points", "segment"])
def test_roundings_bound_what_a_change_of_the_inputs_changes(name):
    """An ulp of the rod's length and angle, and of the force, moves a motion by less than allowed."""
    force = at_degrees(100.0)
    ulp = 2.0**-52
    one = slider(2.0, 40.0, name=name)

    def direction(state):
        return [arb.atan2(*state.to_fence(state.u_x, state.u_y)[::-1])]

    number = ray(one, force).numbers(one, direction)[0]
    allowed = number.rounding * UNIT * ROUNDINGS
    changed = (
        (slider(2.0 * (1 + ulp), 40.0, name=name), force),
        (slider(2.0, 40.0 * (1 + ulp), name=name), force),
        (one, at_degrees(100.0 * (1 + ulp))),
    )
    changes = [
        abs(ray(*case).numbers(case[0], direction)[0].ball - number.ball) for case in changed
    ]
    assert max(float(change) for change in changes) < float(allowed)
    assert max(float(change) for change in changes) > float(allowed) / (100 * ROUNDINGS)


def test_a_pivot_carries_its_foot():
    """Three feet on the unit circle: pushes across a radius pivot about the foot (PHYSICS: section 7)."""
    one = slider(2, name="points", rod_angle=90)
    motion = ray(one, at_degrees(0))
    low, high = stick(one, at_degrees(0), fmpq(1))
    assert motion.pivot == low.pivot == high.pivot == 0
    x, y = one.body.foot(0)
    for end in (
        low,
        high,
    ):  # both ends have the same torque about the foot, and all of its share is used
        moment = end.force[0] * y - end.force[1] * x
        assert moment.overlaps(low.force[0] * y - low.force[1] * x)
        rest = one.body.wrench(end.q, 0).value
        own = end.force[0] - rest[0], end.force[1] - rest[1]
        assert (own[0] ** 2 + own[1] ** 2).overlaps(arb(one.body.share(0)) ** 2)


@pytest.mark.parametrize("effects", [INERTIA, BOTH])
def test_sticking_without_friction_or_with_both(effects):
    one = slider(2, effects=effects)
    low, high = stick(one, at_degrees(100), fmpq(3))
    assert low is high
    assert one.body.wrench(low.q).value[2].contains(0)


@pytest.mark.parametrize("name", SUPPORTS)
def test_every_support_sticks_and_slips(name):
    one = slider(1.3, 40, name=name)
    for angle in (10, 50, 90, 170, -45):
        low, _ = stick(one, at_degrees(angle), fmpq(1))
        motion = ray(one, at_degrees(angle))
        assert max(part.rad() for part in (*low.force, *motion.q)) < 1e-30


@pytest.mark.parametrize("degrees", [10.0**-power for power in range(9)])
@pytest.mark.parametrize("side", [-1, 1])
def test_motions_next_to_a_pivot_are_proved(degrees, side):
    """The tripod of equal feet pivots about the first one under forces beyond this angle."""
    feet = {
        "shape": "points",
        "positions": [(1, 0), (-0.5, 0.75), (-0.5, -0.875)],
        "weights": [1, 1, 1],
    }
    tripod = slider(2, support=support(feet))
    limit = math.degrees(1.7872294552824546)
    motion = ray(tripod, at_degrees(limit + side * degrees))
    assert motion.pivot == (0 if side > 0 else -1)
