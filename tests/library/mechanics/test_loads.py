"""Contact modes under loads that friction does not hold, against the transcription and a scan.

The motion without a pusher takes the place of rest: the slider separates if it leaves the fence, and the
force at the contact is zero there. Under a pusher at rest, the slider can stay at rest under any force of a
convex set.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from mechanics.checked import TABLE, UPRIGHT
from mechanics.degenerate import LAWS, SQUARE, random_support, regular
from mechanics.problems import problem_of, turned
from mechanics.slip_scan import force_at, slips_by_scan
from mechanics.transcription import SEPARATE, SLIP_LEFT, SLIP_RIGHT, STICK, faults, imbalance
from scipy.optimize import linprog

import planar_pushing as pp

COUNT = 60
SUPPORTS = {
    "none": None,
    "table": TABLE,
    "tripod": pp.Points(regular(3), [1, 1, 1]),
    "feet on a line": pp.Points([(0, 0), (1, 0), (-1, 0)], [2, 1, 1]),
    "scattered": random_support(np.random.default_rng(3), "points"),
    "ring": pp.Ring(1.0),
    "square": pp.Polygon(SQUARE),
}
EVERY_SUPPORT = pytest.mark.parametrize("name", SUPPORTS)
#: Motion of the contact, relative to that without a pusher, at which inertia counts for nothing.
SLOW = 1e-9
DIRECTIONS = regular(72, 0.01)


@cache
def pushes(name, moves, count=COUNT):
    """Scenes under loads with pushes, their problems, and the motion of the contact without a pusher."""
    random = np.random.default_rng([list(SUPPORTS).index(name), moves])
    length = np.where(random.random(count) < 0.1, 0.0, 10 ** random.uniform(-1, 1, count))
    mass = 10 ** random.uniform(-1, 1, count)
    size = 10 ** random.uniform(-0.5, 1.5, count)
    angle = random.uniform(-np.pi, np.pi, count)
    angle[::3] = random.choice([0.0, np.pi / 2, -np.pi / 2, np.pi], len(angle[::3]))
    effects = [
        pp.Inertia(
            mass=mass, gyration_radius=10 ** random.uniform(-0.5, 0.5, count),
            center=tuple(0.3 * random.normal(size=(2, count))),
        ),
        pp.Load(
            force=tuple(np.round([size * np.cos(angle), size * np.sin(angle)], 12)),
            center=tuple(random.normal(size=(2, count))) if moves else None,
        ),
    ]  # fmt: skip
    if SUPPORTS[name] is not None:
        effects.insert(0, pp.SupportFriction(support=SUPPORTS[name]))
    scene = pp.Scene(
        slider=pp.Slider(rod_length=length, rod_angle=random.uniform(0.1, 3.0, count), radius=1.0),
        contact=np.array([LAWS[i] for i in random.integers(len(LAWS), size=count)], dtype=object),
        effects=tuple(effects),
    )  # fmt: skip
    push = random.uniform(-np.pi, np.pi, count), moves * 10 ** random.uniform(-3, 2, count)
    away = pp.solve(scene, -np.pi / 2, 1e5 / mass)
    assert np.all(away.mode[:, 0] == SEPARATE)
    assert faults(scene, -np.pi / 2, 1e5 / mass, away) == []
    return scene, *push, problem_of(scene, *push), away.contact_motion[:, 0]


def speeds(problem, free):
    """The larger of the motions of the pusher and of the contact without one."""
    return np.maximum(np.hypot(*problem.pusher.T), np.hypot(*free.T))


# A moving pusher


@EVERY_SUPPORT
def test_solutions_meet_the_conditions_of_their_modes(name):
    scene, angle, magnitude, problem, free = pushes(name, True)
    found = pp.solve(scene, angle, magnitude)
    assert faults(scene, angle, magnitude, found) == []
    apart = free[:, 1] - problem.pusher[:, 1]
    clear = np.abs(apart) > 1e-9 * speeds(problem, free)
    assert np.array_equal((found.mode == SEPARATE).any(axis=1)[clear], (apart > 0)[clear])
    assert {*np.unique(found.mode)} >= {SEPARATE, STICK, SLIP_RIGHT, SLIP_LEFT}


@pytest.mark.parametrize("half", [0, pytest.param(1, marks=pytest.mark.slow)])
@pytest.mark.parametrize("moves", [False, True], ids=["rests", "moves"])
@EVERY_SUPPORT
def test_slips_are_as_many_as_a_scan_along_the_fence_finds(name, moves, half):
    """A slip that the scan steps over has a partner within the same step."""
    scene, angle, magnitude, problem, free = pushes(name, moves)
    found, driven = pp.solve(scene, angle, magnitude), speeds(problem, free) > 0
    # The closed form of a polygon is slow.
    driven[6 if name == "square" else COUNT :] = False
    slips = (found.mode == SLIP_RIGHT) | (found.mode == SLIP_LEFT)
    assert slips[driven].sum() > 4 or name == "square"
    driven[1 - half :: 2] = False
    for mode, sense in ((SLIP_RIGHT, 1), (SLIP_LEFT, -1)):
        number = np.sum(found.mode == mode, axis=1)[driven]
        more = number - slips_by_scan(problem[driven], sense, free[driven])
        assert np.all((more >= 0) & (more % 2 == 0)), np.flatnonzero(driven)[more != 0]


@pytest.mark.parametrize(
    ("name", "moves", "row"),
    [
        ("tripod", False, 1506),
        ("feet on a line", False, 723),
        ("scattered", True, 2478),
        ("ring", True, 610),
    ],
)
def test_two_slips_where_friction_turns_beside_a_rotation(name, moves, row):
    """Of three thousand scenes these have both in one cell, unless the cells are fine there."""
    scene, angle, magnitude, problem, free = pushes(name, moves, 3000)
    mode = pp.solve(scene, angle, magnitude).mode[row]
    counts = [np.sum(mode == each) for each in (SLIP_RIGHT, SLIP_LEFT)]
    assert sorted(counts) == [0, 2]
    assert counts == [slips_by_scan(problem[[row]], side, free[[row]]).item() for side in (1, -1)]


# A pusher at rest


def holding_forces(problem):
    """The largest force along each direction under which the contact rests, shape (n, directions)."""
    count, size = len(DIRECTIONS), np.hypot(*problem.load[:, :2].T) / problem.mass
    motion = np.tile(DIRECTIONS, (len(problem), 1)) * SLOW * np.repeat(size, count)[:, None]
    force = force_at(problem[np.repeat(np.arange(len(problem)), count)], motion)
    return np.sum(force.reshape(-1, count, 2) * DIRECTIONS, axis=-1)


def depth_in_cone(problem, limits):
    """How deep in the friction cone a force can be that holds the contact, by a linear program."""
    right, left = problem.right[0], problem.left[0]
    cone = np.array([[right[1], -right[0], 1.0], [-left[1], left[0], 1.0], [0.0, -1.0, 1.0]])
    inside = np.column_stack([DIRECTIONS, np.zeros(len(DIRECTIONS))])
    limits = limits + 1e-5 * np.abs(limits).max()
    most = 10 * np.abs(limits).max()
    found = linprog(
        [0.0, 0.0, -1.0], A_ub=np.concatenate([cone, inside]),
        b_ub=np.concatenate([np.zeros(3), limits]), bounds=[(None, None)] * 2 + [(-most, most)],
    )  # fmt: skip
    return -found.fun


@EVERY_SUPPORT
def test_a_pusher_at_rest_holds_the_slider_or_lets_it_go(name):
    scene, angle, magnitude, problem, free = pushes(name, False)
    found, driven = pp.solve(scene, angle, magnitude), free.any(axis=1)
    wrong = [each for each in faults(scene, angle, magnitude, found) if "STICK" not in each]
    assert wrong == []
    separates = (found.mode == SEPARATE).any(axis=1)
    # If friction holds the loads, there is no other solution.
    assert separates[~driven].all()
    assert np.all(found.solutions[~driven] == 1)
    clear = np.abs(free[:, 1]) > 1e-9 * np.hypot(*free.T)
    assert np.array_equal(separates[clear], (free[:, 1] > 0)[clear])
    limits, counts = holding_forces(problem), {True: 0, False: 0}
    for i in np.flatnonzero(driven):
        place = np.flatnonzero(found.mode[i] == STICK)
        if len(place):
            assert np.abs(found.contact_motion[i, place]).max() <= 1e-20 * np.hypot(*free[i])
            for force in (found.force[i, place[0]], found.force_end[i, place[0]]):
                assert np.all(DIRECTIONS @ force <= limits[i] + 1e-5 * np.abs(limits[i]).max())
        if problem.rough[i]:
            assert len(place) == 1
            continue
        depth = depth_in_cone(problem[[i]], limits[i]) / np.abs(limits[i]).max()
        if abs(depth) > 1e-3:
            assert len(place) == (depth > 0), i
            counts[depth > 0] += 1
    assert min(counts.values()) > 5


@EVERY_SUPPORT
def test_a_load_does_not_care_for_the_units_of_a_pusher_at_rest(name):
    """Loads, weights and masses by 2^-400: the solutions of the same scene, to the last bit."""
    scene, angle, magnitude, *_ = pushes(name, False)
    scale, effects = 2.0**-400, []
    for each in scene.effects:
        match each:
            case pp.SupportFriction():
                effects.append(pp.SupportFriction(support=each.support, weight=scale))
            case pp.Inertia():
                mass = scale * each.mass
                effects.append(
                    pp.Inertia(mass=mass, gyration_radius=each.gyration_radius, center=each.center)
                )
            case _:
                force = tuple(scale * part for part in each.force)
                effects.append(pp.Load(force=force, center=each.center))
    one = pp.solve(scene, angle, magnitude)
    other = pp.solve(
        pp.Scene(slider=scene.slider, contact=scene.contact, effects=effects), angle, magnitude
    )
    assert np.array_equal(one.mode, other.mode)
    assert np.array_equal(one.twist, other.twist, equal_nan=True)
    assert np.array_equal(scale * one.force, other.force, equal_nan=True)


# A force of a given magnitude


@pytest.mark.parametrize("name", [name for name in SUPPORTS if name != "none"])
def test_a_given_force_and_the_loads_balance_the_motion(name):
    """The contact can also move against the force, and the force can hold the slider."""
    scene, angle, *_, free = pushes(name, True)
    problem, ratio = problem_of(scene, angle), 10 ** np.linspace(-1, 1.5, COUNT)
    ratio[:2] = np.hypot(*problem.load[:2, :2].T) / problem.weight[:2]
    angle = np.array(angle)
    angle[:2] = np.arctan2(*-turned(problem.load[:2, :2], problem.psi[:2]).T[::-1])
    found = pp.motion_of_force(scene, angle, ratio)
    force = (ratio * problem.weight)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    moves = found.status != pp.Status.NONE
    assert found.force[moves] == pytest.approx(force[moves], rel=1e-14, abs=1e-14)
    assert imbalance(problem[moves], found.twist[moves], force[moves]).max() <= 1
    turn = found.twist[:, 2:] * np.column_stack([
        problem.length * np.sin(problem.psi), -problem.length * np.cos(problem.psi)
    ])  # fmt: skip
    assert np.allclose((found.twist[:, :2] + turn)[moves], found.contact_motion[moves], atol=1e-12)
    power = np.sum(force * found.contact_motion, axis=1)[moves]
    assert np.sum(power < 0) > 5 < np.sum(power > 0)
    assert np.all(free[~moves].any(axis=1) | (ratio[~moves] < 1.0))


# By hand: a ring, W = m = rho = 1, or a mass alone, whose contact is straight below its center


def ring(force, law, length=1.0, *others):
    effects = others or (pp.RingFriction(), pp.Inertia())
    slider = pp.Slider(rod_length=length, rod_angle=UPRIGHT, radius=1.0)
    return pp.Scene(slider=slider, contact=law, effects=(*effects, pp.Load(force=force)))


@pytest.mark.parametrize(
    "law", [pp.Coulomb(0.5), pp.InfiniteFriction(), pp.InfiniteFriction("none")]
)
def test_a_load_off_the_fence_moves_the_slider_in_full(law):
    for force, motion in (((0.0, 3.0), (0.0, 2.0)), ((3.0, 4.0), (2.4, 3.2))):
        (free,) = pp.solve(ring(force, law), 0.3, 0.0)
        assert free.mode is pp.ContactMode.SEPARATE
        assert free.contact_motion == pytest.approx(motion, abs=1e-12)
        assert free.twist == pytest.approx([*motion, 0.0], abs=1e-12)
        assert not free.force.any()


@pytest.mark.parametrize("law", LAWS)
def test_a_load_on_the_fence_sticks(law):
    (stick,) = pp.solve(ring((0.0, -3.0), law), 0.3, 0.0)
    assert stick.mode is pp.ContactMode.STICK
    assert stick.force == pytest.approx([0.0, 3.0], abs=1e-12)
    assert not stick.twist.any()


def test_a_load_that_friction_holds_leaves_a_slider_at_rest():
    for law in LAWS:
        (rest,) = pp.solve(ring((0.6, -0.7), law), 0.3, 0.0)
        assert rest.mode is pp.ContactMode.SEPARATE
        assert not rest.twist.any()


def test_a_load_at_the_limit_of_friction_is_held():
    """A load of W through the center of pressure, in any direction; a little more moves the slider."""
    angle = np.linspace(-3, 3, 50)
    for support in (pp.Ring(1.0), TABLE, pp.Disc(0.7), pp.Polygon(SQUARE)):
        friction = pp.SupportFriction(support=support)
        for more in (0.0, 1e-12):
            force = (1.0 + more) * np.cos(angle), (1.0 + more) * np.sin(angle)
            scene = ring(force, pp.Coulomb(0.5), 0.6, friction, pp.Inertia())
            free = pp.solve(scene, -np.pi / 2, 1.0).twist[:, 0]
            assert np.hypot(free[:, 0], free[:, 1]) == pytest.approx(more, rel=1e-2, abs=0)


def test_a_mass_on_a_frictionless_fence_slides_and_on_a_rough_one_turns():
    """The load (g, -g) at the center: it slides by g, or turns about the contact, 2 omega = -g."""
    mass = pp.Inertia()
    (slides,) = pp.solve(ring((4.0, -4.0), pp.Coulomb(0.0), 1.0, mass), 0.0, 0.0)
    assert slides.mode is pp.ContactMode.SLIP_RIGHT
    assert slides.twist == pytest.approx([4.0, 0.0, 0.0], abs=1e-12)
    assert slides.force == pytest.approx([0.0, 4.0], abs=1e-12)
    (turns,) = pp.solve(ring((4.0, -4.0), pp.InfiniteFriction(), 1.0, mass), 0.0, 0.0)
    assert turns.mode is pp.ContactMode.STICK
    assert turns.twist == pytest.approx([2.0, 0.0, -2.0], abs=1e-12)
    assert turns.force == pytest.approx([-2.0, 4.0], abs=1e-12)


@pytest.mark.parametrize("push", [(0.0, 0.0), (0.0, 0.1), (np.pi, 0.1), (0.0, 0.9), (0.0, 7.0)])
def test_a_load_along_the_fence_is_opposed_by_friction_without_a_normal_force(push):
    """Where it is free at zero normal force: a continuum from the motion without a pusher to the stick."""
    scene = ring((4.0, 0.0), pp.InfiniteFriction(), 1.0, pp.Inertia())
    found = pp.solve(scene, *push)
    assert found.modes == (pp.ContactMode.SEPARATE, pp.ContactMode.STICK)
    assert found[0].twist == pytest.approx([4.0, 0.0, 0.0], abs=1e-12)
    # A contact that moves by u: the mass turns by (u - 4) / 2, the force is half of the difference.
    u = push[1] * np.cos(push[0])
    assert found[1].force == pytest.approx([(u - 4.0) / 2.0, 0.0], abs=1e-12)
    assert found[1].twist == pytest.approx([2.0 + u / 2.0, 0.0, u / 2.0 - 2.0], abs=1e-12)
    assert found[1].continuum
    assert found.status is pp.Status.CONTINUUM
    definition_2 = ring((4.0, 0.0), pp.InfiniteFriction("none"), 1.0, pp.Inertia())
    assert pp.solve(definition_2, *push).modes == (pp.ContactMode.SEPARATE,)


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.4])
def test_a_fence_that_slides_along_a_slider_held_by_friction_leaves_it_at_rest(mu):
    """A contact at the center of the ring, pressed by 1.5 W: |mu N, N - 1.5| <= 1 holds."""
    for angle, mode, sign in ((0.0, "SLIP_LEFT", 1.0), (np.pi, "SLIP_RIGHT", -1.0)):
        (slip,) = pp.solve(ring((0.0, -1.5), pp.Coulomb(mu), 0.0), angle, 1.0)
        assert slip.mode.name == mode
        assert not slip.twist.any()
        # The largest force along the edge.
        normal = (1.5 + np.sqrt(1.0 - 1.25 * mu**2)) / (1.0 + mu**2)
        assert slip.force == pytest.approx([sign * mu * normal, normal], abs=1e-12)
    (slip,) = pp.solve(ring((0.0, -1.5), pp.Coulomb(1.0), 0.0), 0.0, 1.0)
    assert slip.contact_motion == pytest.approx([0.5, 0.0], abs=1e-12)
    assert slip.force == pytest.approx([1.5, 1.5], abs=1e-12)


def test_a_stick_at_rest_needs_friction_for_the_couple_as_well():
    """Without friction at the contact: feet on its normal hold no force along the fence and this couple."""
    slider = pp.Slider(rod_length=2.0194316226473177, rod_angle=UPRIGHT, radius=1.0)
    scene = pp.Scene(
        slider=slider, contact=pp.Coulomb(0.0),
        effects=(
            pp.SupportFriction(support=SUPPORTS["feet on a line"]),
            pp.Inertia(
                mass=0.6372123703969986, gyration_radius=0.7412466440113604,
                center=(0.2872271900316248, 0.3585611166957677),
            ),
            pp.Load(force=(-0.443826602987, -1.157874829269)),
        ),
    )  # fmt: skip
    (slip,) = pp.solve(scene, 0.0, 0.0)
    assert slip.mode is pp.ContactMode.SLIP_RIGHT
    assert faults(scene, 0.0, 0.0, pp.solve(scene, 0.0, 0.0)) == []


@pytest.mark.parametrize("length", [2.0, 1e3, 1e5])
@pytest.mark.parametrize("law", [pp.InfiniteFriction(), pp.PerfectlyRough()])
def test_a_load_along_the_fence_at_the_contact_of_a_long_rod_is_held(length, law):
    """The force is the opposite of the load to its last digits, on the edge of the cone."""
    mass = pp.Inertia(mass=15000.0, gyration_radius=12.0, center=(1.0, 0.5))
    load = pp.Load(force=(0.3, 0.0), center=(-length, 0.0))
    slider = pp.Slider(rod_length=length, rod_angle=1.0, radius=0.7)
    found = pp.solve(pp.Scene(slider=slider, contact=law, effects=[mass, load]), 0.0, 0.0)
    (stick,) = found
    assert stick.mode == STICK
    assert stick.force == pytest.approx((-0.3, 0.0), rel=1e-15, abs=1e-15)


@pytest.mark.parametrize(("law", "mass_center", "load"), [
    (pp.InfiniteFriction(), (1.0, 0.5), pp.Load(force=(-20.0, 0.0), center=(-2.0, 0.0))),
    (pp.Coulomb(0.5), (0.5, 0.0), pp.Load(force=(-2.0, -2.0), center=(0.0, 0.0))),
    (pp.Coulomb(0.0), (0.0, 0.0), pp.Load(force=(1.0, -3.0), center=(0.3, 0.0))),
])  # fmt: skip
@pytest.mark.parametrize("normal", [1e-300, -1e-300, 5e-324, -5e-324])
def test_a_normal_motion_that_underflows_is_none_beside_that_of_the_load(
    law, mass_center, load, normal
):
    mass = pp.Inertia(mass=1.0, gyration_radius=0.5, center=mass_center)
    slider = pp.Slider(rod_length=2.0, rod_angle=2.9)
    scene = pp.Scene(slider=slider, contact=law, effects=[pp.RingFriction(), mass, load])
    one, other = (pp.solve(scene, angle, 0.02) for angle in (normal, 0.0))
    assert [each.mode for each in one] == [each.mode for each in other] != []
    for left, right in zip(one, other, strict=True):
        assert left.force == pytest.approx(right.force)
        assert left.twist == pytest.approx(right.twist)
