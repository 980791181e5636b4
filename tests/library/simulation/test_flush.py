"""Sides that come to lie on a fence, stay, slip and leave it, by both methods and other routes."""

import itertools
import threading
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from simulation.flush_runs import (
    HORSESHOE,
    KINDS,
    LEANING,
    SLAB,
    SQUARE,
    FlushRun,
    heights,
    polygon,
    random_flush_run,
    rotated,
    tilted,
)
from simulation.runs import check, final, imbalance, run

import planar_pushing as pp
from planar_pushing.simulation.runs import Run

#: The scenes are plain or random numbers, not real objects.
pytestmark = pytest.mark.filterwarnings(
    "ignore:(support|pusher|gyration_radius):planar_pushing.SceneWarning"
)

METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
PLATE = pp.SupportFriction(support=pp.Polygon(SQUARE))
MASS = pp.Inertia(mass=1.0, gyration_radius=1.0)
LAW = pp.Coulomb(0.5)
STICK, SLIP_RIGHT, SLIP_LEFT = (
    pp.ContactMode.STICK,
    pp.ContactMode.SLIP_RIGHT,
    pp.ContactMode.SLIP_LEFT,
)
EFFECTS = {"friction": (PLATE,), "both": (PLATE, MASS), "inertia": (MASS,)}
EVERY_EFFECT = pytest.mark.parametrize("effects", EFFECTS.values(), ids=EFFECTS)


def end_of(log):
    """Last pose of the object: x, y, degrees."""
    return np.append(final(log, "object_position"), final(log, "object_angle"))


def difference(log, other):
    """Largest difference of the last poses, angles in radians."""
    x, y, angle = end_of(log) - end_of(other)
    return max(abs(x), abs(y), abs(np.deg2rad(angle)))


def on_side(effects, law=LAW, side=0):
    return pp.scene_at(side=side, effects=effects, contact=law, outline=SQUARE)


def pushed(outline, degrees, law, velocity, duration, effects=None):
    """An object that friction of its whole outline resists, turned by an angle."""
    friction = (pp.SupportFriction(support=pp.Polygon(outline)),)
    return FlushRun(outline, np.deg2rad(degrees), effects or friction, law, velocity, duration)


#: Runs, final poses (x, y, degrees), the time at which the side arrives, and the last mode.
KNOWN = {
    "straight": (
        pushed(SQUARE, 20, LAW, (0, 1), 6.0), (0.3042988, 5.7182872, 0), 0.9193869, STICK,
    ),
    "aside": (
        pushed(SQUARE, 20, LAW, (0.4, 1), 6.0), (2.4250406, 5.7182872, 0), 1.8054820, STICK,
    ),
    "the other way": (
        pushed(SQUARE, 20, LAW, (1, 1), 6.0), (2.4478320, 5.7182872, 90), 2.1655623, SLIP_LEFT,
    ),
    "slippery": (
        pushed(SQUARE, 20, pp.Coulomb(0.2), (-1, 1), 6.0), (-1.1423236, 5.7182872, 0), 0.5130504,
        SLIP_RIGHT,
    ),
    "does not stay": (
        pushed(LEANING, 15, LAW, (0, 1), 1.0), (-0.2150969, 1.1234808, -7.0930322), 0.5797851, STICK,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", KNOWN)
def test_known_motions(name):
    case, pose, arrives, mode = KNOWN[name]
    log = check(case.log())
    assert log.attrs["stopped"] == ""
    assert end_of(log)[:2] == pytest.approx(pose[:2], abs=6e-8)
    assert end_of(log)[2] == pytest.approx(pose[2], abs=1.2e-7)  # degrees
    (meets,) = np.flatnonzero(log.event.values == pp.Event.PENETRATES)
    assert log.time.values[meets] == pytest.approx(arrives, abs=6e-8)
    assert final(log, "mode") == mode
    assert final(log, "flush") == (name != "does not stay")
    assert heights(log, case.outline).min() > -1e-13
    errors = [difference(case.log("time-stepping", steps=n), log) for n in (1000, 16000)]
    assert errors[0] < 2e-3
    assert errors[1] < errors[0] / 6


# --- A route of its own: a square under friction alone -------------------------------------------


gauss = cache(np.polynomial.legendre.leggauss)


def grid_force(u_x, u_y, omega, turn, number=60):
    """Force and torque about the contact of a square of side 2 whose corner is the contact."""
    nodes, weights = gauss(number)
    x, y = np.meshgrid(nodes + 1, nodes + 1)
    w = np.outer(weights, weights) / 4
    c, s = np.cos(turn), np.sin(turn)
    p_x, p_y = c * x - s * y, s * x + c * y
    v_x, v_y = u_x - omega * p_y, u_y + omega * p_x
    size = np.hypot(v_x, v_y)
    f_x, f_y = w * v_x / size, w * v_y / size
    return f_x.sum(), f_y.sum(), (p_x * f_y - p_y * f_x).sum()


def spin_of(u_x, u_y, turn):
    """The rotation without a torque about the contact."""
    return brentq(lambda omega: grid_force(u_x, u_y, omega, turn)[2], -5, 5, xtol=1e-13)


def rates_of_square(turn, w_x, w_y, mu):
    """Slip and rotation by the modes in turn: stick, else the slip whose force is on an edge."""
    omega = spin_of(w_x, w_y, turn)
    f_x, f_y, _ = grid_force(w_x, w_y, omega, turn)
    if abs(f_x) <= mu * f_y:
        return 0.0, omega
    edge = np.copysign(mu, f_x)

    def across(u_x):
        f_x, f_y, _ = grid_force(u_x, w_y, spin_of(u_x, w_y, turn), turn)
        return f_x - edge * f_y

    u_x = brentq(across, min(w_x, -5 * w_y), max(w_x, 5 * w_y), xtol=1e-12)
    return u_x - w_x, spin_of(u_x, w_y, turn)


@pytest.mark.parametrize(
    ("mu", "velocity"),
    [
        (0.15, (-0.6, 1.0)),
        pytest.param(0.5, (0.0, 1.0), marks=pytest.mark.slow),
        pytest.param(0.5, (0.4, 1.0), marks=pytest.mark.slow),
    ],
)
def test_a_square_turns_flush_as_an_integration_by_quadrature_says(mu, velocity):
    """Until it is flush, and then by the motion along the force."""
    turn, (w_x, w_y) = np.deg2rad(12.0), velocity

    def rates(t, state):
        slip, omega = rates_of_square(state[1], w_x, w_y, mu)
        return [w_x + slip, omega]

    def lies(t, state):
        return state[1]

    lies.terminal = True
    path = solve_ivp(rates, (0, 5), [0.0, turn], events=lies, rtol=1e-6, atol=1e-8)
    arrives, (x, _) = path.t_events[0][0], path.y_events[0][0]
    duration = arrives + 0.5
    log = pushed(SQUARE, 12, pp.Coulomb(mu), velocity, float(duration)).log()
    assert log.time.values[log.flush.values.argmax()] == pytest.approx(arrives, abs=2e-4)
    along = np.clip(w_x, -mu * w_y, mu * w_y)
    # The corner is the contact at the start, one unit to the left of the center at the end.
    start = rotated([(-1.0, -1.0)], turn)[0]
    wanted = start[0] + x + 0.5 * along + 1, start[1] + duration * w_y + 1
    assert final(log, "object_position") == pytest.approx(wanted, abs=3e-4)


# --- Both methods agree --------------------------------------------------------------------------


def is_smooth(case):
    """Whether steps have first order: no flight at first, and a motion for every push.

    The paper's second definition of infinite friction has pushes without a motion, and an impact of a step
    that closes only a part of a gap is not that of the event.
    """
    law = case.law
    unique = not isinstance(law, pp.InfiniteFriction) or law.at_zero_normal == "free"
    return unique and case.gap == 0 and not any(case.twist)


@pytest.mark.parametrize(
    "part", [*range(2), *(pytest.param(part, marks=pytest.mark.slow) for part in range(2, 7))]
)
def test_both_methods_agree_on_random_runs(part):
    counts = {"flush": 0, "slip": 0, "leave": 0}
    for seed in range(part, 385, 7):
        case = random_flush_run(seed)
        try:
            log = case.log()
        except pp.InvalidValue:
            continue  # a load that friction alone does not hold
        assert imbalance(log).max() < 1e-8, seed
        assert heights(log, case.outline).min() > -4e-9, seed
        assert log.gap.min() > -1e-9, seed
        flush = log.flush.values
        counts["flush"] += flush.any()
        counts["slip"] += (flush & (log["mode"].values >= SLIP_RIGHT)).any()
        counts["leave"] += (flush[:-1] & ~flush[1:]).any()
        if not is_smooth(case):
            continue
        assert log.attrs["stopped"] == "", seed
        steps = [case.log("time-stepping", steps=n) for n in (500, 4000)]
        errors = [difference(each, log) for each in steps]
        assert errors[1] < max(errors[0] / 3, 1e-5) or errors[1] < 1e-3, (seed, errors)
        assert imbalance(steps[0]).max() < 1e-9, seed
        assert heights(steps[1], case.outline).min() > -1e-5, seed
    assert counts["flush"] >= 15
    assert counts["slip"] >= 3
    assert part or counts["leave"] >= 1


@pytest.mark.parametrize("seed", range(40))
def test_impacts_and_flights_of_random_runs_keep_the_energy(seed):
    case = random_flush_run(seed, KINDS[(1, 2, 5, 7)[seed % 4]])
    for log in (case.log(), case.log("time-stepping")):
        assert imbalance(log).max() < 1e-8
        assert log.gap.min() > -1e-9
        lost = log.contact_dissipated.values
        assert np.diff(lost).min(initial=0) > -1e-9
    assert heights(case.log(), case.outline).min() > -4e-9


@pytest.mark.parametrize(
    "part", [*range(2), *(pytest.param(part, marks=pytest.mark.slow) for part in range(2, 4))]
)
def test_an_instant_of_a_side_is_a_push_of_a_side_from_rest(part):
    """Number of modes, force and its place are those of `solve`."""
    compared = 0
    for seed in range(part, 240, 4):
        case = random_flush_run(seed, ("friction", "viscous", "film")[seed % 3])
        if case.outline is HORSESHOE:
            continue  # its mouth is not one side
        log = case.log(samples=11)
        for i in range(1, log.sizes["time"] - 1):
            now, corners = log.isel(time=i), np.abs(heights(log, case.outline)[i])
            (lying,) = (np.flatnonzero((corners < 1e-9) & (np.roll(corners, -1) < 1e-9)),)
            smooth = (log.event.values[i - 1 : i + 2] < 0).all() and not isinstance(
                case.velocity, list
            )
            if not (now.flush and smooth and len(lying) == 1):
                continue
            turns = callable(case.velocity)
            x, y = case.velocity(float(now.time)) if turns else case.velocity
            scene = pp.scene_at(
                side=int(lying[0]), effects=case.effects, contact=case.law, outline=case.outline
            )
            solutions = pp.solve(scene, float(np.arctan2(y, x)), float(np.hypot(x, y)))
            assert now.solutions == len(solutions), seed
            same = [each for each in solutions.of(pp.ContactMode(now["mode"].item())) if each.flush]
            if pp.ContactMode(now["mode"].item()) == pp.ContactMode.SEPARATE:
                continue
            (solution,) = same
            assert now.force.values == pytest.approx(solution.force, rel=1e-6, abs=1e-9), seed
            middle = middle_of_side(case, lying[0], log, i)
            assert now.contact_position + now.pusher[0] == pytest.approx(
                middle + solution.force_position, abs=1e-7
            ), seed
            compared += 1
    assert compared > 10


def middle_of_side(case, side, log, i):
    """Place of the middle of a side along the fence, from the contact at time 0."""
    spin = np.exp(1j * np.deg2rad(log.object_angle.values[i]))
    corners = np.asarray(case.outline) @ (1, 1j)
    middle = (corners[side] + corners[(side + 1) % len(corners)]) / 2
    center = log.object_position.values @ (1, 1j)
    start = np.asarray(case.scene.placement.point) @ (1, 1j) * np.exp(1j * case.tilt)
    return (center[i] + spin * middle - start).real


# --- Hard cases ----------------------------------------------------------------------------------


@METHODS
@EVERY_EFFECT
@pytest.mark.parametrize("law", [pp.Coulomb(0.0), LAW, pp.InfiniteFriction(), pp.PerfectlyRough()])
def test_a_square_pushed_straight_is_not_turned(method, effects, law):
    log = check(run(on_side(effects, law), (0, 1), 3.0, method=method))
    assert log.attrs["stopped"] == ""
    assert np.all(log.rod_angle == 90)
    assert np.abs(log.position.values[:, 0]).max() < 1e-15
    if effects is not EFFECTS["inertia"]:
        assert log.flush.all()
        assert np.abs(log.contact_position).max() < 1e-12


@METHODS
def test_a_slip_of_a_side_is_along_its_force(method):
    log = check(run(on_side((PLATE,)), (1.0, 1.0), 2.0, method=method))
    assert log.flush.all()
    assert set(log["mode"].values) == {SLIP_LEFT}
    assert log.slip.values == pytest.approx(-0.5 * log.time.values, abs=1e-12)
    # The line of force through the center is inclined by the angle of friction.
    wanted = 0.5 * log.time.values - 0.5 - log.pusher.values[:, 0]
    assert log.contact_position.values + 0 == pytest.approx(wanted, abs=1e-12)


@METHODS
@pytest.mark.parametrize(
    "mass", [(), (pp.Inertia(mass=1.0, center=(1.0, 0.2)),)], ids=["friction", "both"]
)
def test_a_force_exactly_at_an_end_counts_once_and_is_flush(method, mass):
    feet = pp.SupportFriction(support=pp.Points(((1.0, 0.0), (1.0, 0.5)), (1.0, 1.0)))
    log = check(run(on_side((feet, *mass)), (0, 1), 1.0, method=method))
    assert log.flush.all()
    assert set(log.solutions.values) == {1}
    assert log.contact_position.values == pytest.approx(1.0, abs=1e-12)


def test_waypoints_turn_an_object_about_the_end_where_the_force_leaves_the_side():
    """A slab on its short side: it stays under a push straight up, and tips under one aside."""
    scene = pp.scene_at(
        side=1, effects=(pp.SupportFriction(support=pp.Polygon(SLAB)),), contact=pp.Coulomb(2.0),
        outline=SLAB,
    )  # fmt: skip
    log = check(run(scene, [(0, (0, 1)), (1, (0.5, 1))], 1.5))
    before, after = log.time.values < 1, log.time.values > 1
    assert log.flush.values[before].all()
    assert not log.flush.values[after].any()
    turned = np.deg2rad(log.rod_angle.values[-1] - log.rod_angle.values[0])
    assert (
        turned > 0.1
    )  # the force is to the left of the side, about whose left end the object turns
    assert log.contact_position.values[after] == pytest.approx(-0.2, abs=1e-12)
    assert log["mode"].values[after].tolist() == [STICK] * after.sum()


@METHODS
def test_a_turning_fence_pushes_until_the_force_is_at_an_end(method):
    """The force crosses the side at x* = -1.5 f_x / f_y; as w_x / w_y = -tan(t), it reaches the end 0.2."""
    scene = pp.scene_at(
        side=1, effects=(pp.SupportFriction(support=pp.Polygon(SLAB)),), contact=pp.Coulomb(2.0),
        outline=SLAB,
    )  # fmt: skip
    log = check(run(scene, lambda t: (-np.sin(t), np.cos(t)), 0.5, method=method, samples=501))
    leaves = log.time.values[np.argmin(log.flush.values)]
    assert leaves == pytest.approx(
        np.arctan(0.2 / 1.5), abs=1e-10 if method == "event-driven" else 2e-3
    )
    assert log.flush.values[log.time.values < leaves].all()
    assert not log.flush.values[log.time.values > leaves].any()
    assert final(log, "rod_angle") < log.rod_angle.values[0]


@METHODS
@EVERY_EFFECT
def test_a_fence_that_retreats_and_returns_meets_the_whole_side(method, effects):
    log = check(
        run(on_side(effects), [(0, (0, 1)), (1, (0.4, -1)), (2, (0, 2))], 4.0, method=method), 1e-9
    )
    assert log.attrs["stopped"] == ""
    assert log.rod_angle.values == pytest.approx(90, abs=1e-11)
    if effects is not EFFECTS["inertia"]:
        assert log.flush.values[log.time.values < 1].all()
        assert not log.flush.values[(log.time.values > 1.01) & (log.time.values < 2)].any()
        assert final(log, "flush")
    assert final(log, "position")[1] == pytest.approx(5.0, abs=1e-9)


@METHODS
@pytest.mark.parametrize("effects", [(pp.SupportFriction(support=pp.Disc(1.0)),),
                                     (pp.SupportFriction(support=pp.Disc(1.0)), MASS)],
                         ids=["friction", "both"])  # fmt: skip
def test_a_polygon_of_many_corners_rolls_along_the_fence(method, effects):
    """As a disc that sticks to it rolls: a turn takes its circumference."""
    corners = polygon(128)
    scene = pp.scene_at(side=0, effects=effects, contact=pp.Coulomb(0.8), outline=corners)
    log = check(
        run(
            scene,
            (1.0, 0.2),
            12.0,
            method=method,
            samples=2,
            step=None if method[0] == "e" else 3e-3,
        ),
        1e-9,
    )
    assert log.attrs["stopped"] == ""
    turned = np.deg2rad(final(log, "rod_angle") - log.rod_angle.values[0])
    assert turned > np.pi
    assert (log.event.values == pp.Event.PENETRATES).sum() > 80 or method == "time-stepping"


def test_a_horseshoe_lies_on_the_ends_of_its_mouth():
    case = FlushRun(
        HORSESHOE, 0.2, (pp.SupportFriction(support=pp.Polygon(HORSESHOE)),), LAW, (0.0, 1.0), 3.0
    )
    log = check(case.log())
    assert final(log, "flush")
    lowest = np.abs(heights(log, HORSESHOE)[-1])
    assert lowest[[0, 1, 4, 5]].max() < 1e-14
    assert lowest[[2, 3]] == pytest.approx(1.4, abs=1e-13)
    # The force may act in the mouth: between both feet.


@METHODS
def test_a_side_that_lands_stops_at_both_ends(method):
    scene = pp.scene_at((0.0, -1.0), (0.0, 1.0), effects=(MASS,), contact=LAW, outline=SQUARE)
    log = check(run(scene, (0, 0), 1.0, gap=0.3, twist=(0, -1, 0), method=method))
    assert log.attrs["stopped"] == ""
    assert final(log, "twist") == pytest.approx([0, 0, 0], abs=1e-12)
    assert final(log, "contact_dissipated") == pytest.approx(0.5, abs=1e-12)
    assert log.flush.values[-1]


@pytest.mark.parametrize("gyration", [0.3, 2.0])
def test_a_mass_lands_on_one_corner_after_the_other(gyration):
    """An impact at a corner without friction, against the momentum about the corner."""
    mass = pp.Inertia(mass=1.0, gyration_radius=gyration)
    scene = tilted(SQUARE, 0.3, (mass,), pp.Coulomb(0.0))
    log = check(run(scene, (0, 0), 3.0, gap=0.2, twist=(0, -1, 0)))
    i = int(np.argmax(log.event.values == pp.Event.TOUCHES))
    (c_x, _), omega, v_y = (
        rotated([(1.0, 1.0)], 0.3)[0],
        log.twist.values[i, 2],
        log.twist.values[i, 1],
    )
    square = gyration**2
    assert v_y == pytest.approx(omega * c_x, abs=1e-12)
    assert omega == pytest.approx(-c_x / (c_x**2 + square), rel=1e-12)
    assert log.gap.min() > -1e-12


def test_a_side_rattles_from_end_to_end_until_it_lies_on_the_fence():
    """Impacts in ever shorter times: the run goes on after them."""
    for velocity in ((0, 1), (0, 4), (0.3, 3)):
        case = pushed(SQUARE, 20, LAW, velocity, 6.0, (PLATE, MASS))
        log = check(case.log())
        assert (log.event.values == pp.Event.PENETRATES).sum() > 5
        assert final(log, "flush")
        assert final(log, "twist")[2] == 0
        assert difference(case.log("time-stepping", steps=6000), log) < 1e-3


#: Loads of a square at rest on a fence at rest: does it stay, slip, or tip?
LOADS = {
    "pressed": ((MASS,), (0.0, -0.3), None, "stays"),
    "friction and the fence": ((PLATE, MASS), (1.2, -1.2), None, "stays"),
    "slips": ((MASS,), (0.3, -0.3), None, "slips"),
    "held by friction alone": ((PLATE, MASS), (0.3, -0.3), None, "stays"),
    "tips": ((PLATE, MASS), (1.5, -0.5), (0.0, 1.0), "tips"),
}


@METHODS
@pytest.mark.parametrize("name", LOADS)
def test_a_square_at_rest_under_a_load(method, name):
    effects, force, center, motion = LOADS[name]
    scene = on_side((*effects, pp.Load(force=force, center=center)))
    log = check(run(scene, (0, 0), 1.0, method=method))
    assert log.attrs["stopped"] == ""
    x, y = final(log, "position")
    if motion == "stays":
        assert (x, y) == pytest.approx((0, 1), abs=1e-12)
        assert log.flush.all()
    elif motion == "slips":
        assert x == pytest.approx(0.075, abs=1e-12 if method == "event-driven" else 1e-4)
        assert y == pytest.approx(1, abs=1e-12)
        assert final(log, "contact_position") == pytest.approx(x + 0.5, abs=1e-9)
    else:
        assert final(log, "rod_angle") < 89


@METHODS
def test_a_flush_side_without_an_outline_has_two_points(method):
    slider = pp.Slider(
        rod_length=1.0, rod_angle=np.pi / 2, radius=1.0, side=(-1.0, 1.0), flush=True
    )
    for effects in ((PLATE,), (PLATE, MASS)):
        scene = pp.Scene(slider=slider, contact=LAW, effects=effects)
        for velocity in ((0.2, 1.0), [(0, (0.1, 1.0)), (1, (3.0, 1.0)), (2, (0.1, 0.5))]):
            log = check(run(scene, velocity, 3.0, method=method), 1e-9)
            whole = run(on_side(effects), velocity, 3.0, method=method)
            for each in ("position", "rod_angle", "slip", "force", "contact_position", "flush"):
                assert log[each].values == pytest.approx(whole[each].values, abs=1e-11), each


@pytest.mark.parametrize("support", [pp.Polygon(SQUARE), pp.Disc(0.6, (0.3, 0.2))])
@pytest.mark.parametrize("law", [pp.PerfectlyRough(), pp.InfiniteFriction(), LAW], ids=repr)
def test_a_flush_side_without_an_outline_has_as_many_modes(law, support):
    """Where a rough side can roll to the end of it or slip, without inertia."""
    slider = pp.Slider(
        rod_length=1.0, rod_angle=np.pi / 2, radius=1.0, side=(-1.0, 1.0), flush=True
    )
    effects = (pp.SupportFriction(support=support),)
    scene, numbers = pp.Scene(slider=slider, contact=law, effects=effects), set()
    for velocity in ((-0.6, 0.4), (0.6, 0.4), (0.1, 1.0)):
        log, whole = (run(each, velocity, 2.0) for each in (scene, on_side(effects, law)))
        for each in ("solutions", "outcome", "mode", "flush"):
            assert log[each].values.tolist() == whole[each].values.tolist(), each
        numbers |= set(log.solutions.values.tolist())
    assert numbers == ({1, 2} if law == pp.PerfectlyRough() else {1})


@METHODS
@pytest.mark.parametrize("velocity", [(1.0, 0.3), (0.0, 1.0)])
def test_the_ring_and_the_rod_of_the_paper_lie_on_the_fence(method, velocity):
    """A ring as 64 corners: it turns until one of them is on the fence, as the end of its rod is."""
    turns = 2 * np.pi * np.arange(64) / 64
    ring = np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0, outline=ring)
    scene = pp.Scene(slider=slider, contact=LAW, effects=(pp.RingFriction(),))
    log = check(run(scene, velocity, 8.0, method=method), 1e-9)
    tangent = np.arctan2(ring[:, 1], ring[:, 0] + 2.0).max()
    assert log.flush[-1]
    assert not log.flush[0]
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(tangent), abs=1e-9)
    assert final(log, "gap") == pytest.approx(0.0, abs=1e-12)
    # Flush it sticks, or slips by the motion along the force.
    assert log.mode[-1] == (STICK if velocity[0] == 0.0 else SLIP_LEFT)
    x, y = final(log, "twist")[:2]
    assert (x, y) == pytest.approx((0.0, 1.0) if velocity[0] == 0.0 else (0.15, 0.3), abs=1e-9)


def test_a_finger_does_not_push_a_flush_side():
    scene = pp.Scene(
        slider=pp.Slider(rod_length=1.0, rod_angle=1.0, side=(-1.0, 1.0), flush=True), contact=LAW,
        effects=(pp.RingFriction(),),
    )  # fmt: skip
    with pytest.raises(pp.InvalidValue, match="pusher"):
        run(scene, pp.Pusher(velocity=(0, 1), shape="finger"), 1.0)


# --- Images, batches, and ways to run ------------------------------------------------------------


@pytest.mark.parametrize("seed", range(0, 64, 3))
def test_the_mirror_image_of_a_run_has_the_image_of_its_motion(seed):
    """In another order of the corners as well."""
    case = random_flush_run(seed, "friction" if seed % 2 else "both")
    if callable(case.velocity) or case.law == pp.InfiniteFriction(at_zero_normal="none"):
        return
    log = case.log()
    flipped = tuple((-x, y) for x, y in reversed(case.outline))
    pieces = case.velocity if isinstance(case.velocity, list) else [(0.0, case.velocity)]

    def image(effect):
        if isinstance(effect, pp.Inertia):
            return replace(effect, center=(-effect.center[0], effect.center[1]))
        support = effect.support
        if isinstance(support, pp.Polygon):
            return replace(effect, support=pp.Polygon(flipped))
        if isinstance(support, pp.Points):
            return replace(
                effect, support=pp.Points([(-x, y) for x, y in support.positions], support.weights)
            )
        if isinstance(support, pp.Segment):
            ends = ((-support.start[0], support.start[1]), (-support.end[0], support.end[1]))
            return replace(effect, support=pp.Segment(*ends))
        x, y = support.center or (0.0, 0.0)
        return replace(effect, support=replace(support, center=(-x, y)))

    other = FlushRun(
        flipped, -case.tilt, tuple(map(image, case.effects)), case.law,
        [(t, (-x, y)) for t, (x, y) in pieces], case.duration,
        (-case.twist[0], case.twist[1], -case.twist[2]), case.gap,
    ).log()  # fmt: skip
    (x, y, angle), (far, up, turn) = end_of(log), end_of(other)
    assert (-far, up) == pytest.approx((x, y), abs=1e-6)
    assert -turn + angle * 0 == pytest.approx(angle, abs=1e-4)
    assert other.flush.any() == log.flush.any()


@pytest.mark.parametrize("seed", range(0, 32, 5))
def test_a_batch_is_its_runs(seed):
    case = random_flush_run(seed, "both" if seed % 2 else "friction")
    velocity = (0.3, 1.0)
    laws = np.array([pp.Coulomb(mu) for mu in (0.1, 0.5, 1.0)])
    scene = replace(case.scene, contact=laws)
    batch = pp.simulate_batch(scene, pp.Pusher(velocity=velocity), duration=2.0, samples=5)
    for i, law in enumerate(laws):
        log = run(replace(case.scene, contact=law), velocity, 2.0, samples=5)
        for k in range(5):
            here = batch.isel(scene=i, part=k)
            there = log.isel(time=np.flatnonzero(log.time.values <= here.time.values)[-1])
            for each in (
                "position",
                "rod_angle",
                "slip",
                "gap",
                "force",
                "mode",
                "flush",
                "contact_position",
            ):
                assert np.array_equal(here[each], there[each]), each


def test_a_batch_of_flush_sides():
    slider = pp.Slider(
        rod_length=np.array([1.0, 0.5]), rod_angle=np.pi / 2, radius=1.0,
        side=(np.array([-1.0, -0.1]), np.array([1.0, 0.1])), flush=True,
    )  # fmt: skip
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),))
    batch = pp.simulate_batch(scene, pp.Pusher(velocity=(-0.3, 1.0)), duration=0.2)
    assert batch.flush.values.tolist() == [True, False]
    assert batch.contact_position.values[1] == pytest.approx(0.1, abs=1e-12)
    for i, (length, end) in enumerate(((1.0, 1.0), (0.5, 0.1))):
        one = pp.Slider(
            rod_length=length, rod_angle=np.pi / 2, radius=1.0, side=(-end, end), flush=True
        )
        log = run(replace(scene, slider=one), (-0.3, 1.0), 0.2, samples=2)
        assert np.array_equal(batch.position.values[i], final(log, "position"))


@METHODS
@pytest.mark.parametrize("seed", range(0, 56, 7))
def test_the_compiled_core_has_the_bits_of_the_plain_one(both, method, seed):
    random_flush_run(seed).log(method, steps=24, samples=5)
    assert {"event-driven": "run_events", "time-stepping": "run_steps"}[method] in both.results


@METHODS
def test_until_a_side_is_flush_and_a_streamed_log(method, tmp_path):
    case = KNOWN["straight"][0]
    whole = case.log(method)
    log = case.log(method, until=lambda instant: bool(instant["flush"]))
    assert log.attrs["stopped"].startswith("until")
    assert final(log, "flush")
    assert not log.flush.values[:-1].any()
    assert final(log, "time") == whole.time.values[whole.flush.values.argmax()]
    with case.log(method, path=tmp_path / "log.nc") as streamed:
        assert streamed.flush.dtype == bool
        for each in whole.data_vars:
            assert np.array_equal(streamed[each].values, whole[each].values), each


def test_a_run_that_is_continued_is_the_whole_run():
    """Few rows at once, so that it is continued many times, also while a side lies on the fence."""
    from planar_pushing.simulation.problem import Problem

    case = KNOWN["the other way"][0]
    problem = Problem(
        scene=case.scene, pusher=pp.Pusher(velocity=case.velocity), duration=case.duration
    )
    times = np.linspace(0, case.duration, 41)
    rows = [np.concatenate(list(Run(problem, times, room=room))) for room in (3, 256)]
    assert np.array_equal(*rows)


def test_threads_do_not_share_a_run():
    case, logs = KNOWN["aside"][0], []
    threads = [threading.Thread(target=lambda: logs.append(case.log())) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one, other in itertools.combinations(logs, 2):
        assert np.array_equal(one.position.values, other.position.values)


@pytest.mark.parametrize("policy", ["separate", "stick", "slip-left", "stay-in-mode"])
def test_policies_choose_among_the_modes_of_a_side(policy):
    """Perfectly rough sides that a fence pulls: they stick, or the fence leaves them."""
    scene = on_side((PLATE,), pp.PerfectlyRough())
    log = check(run(scene, (0.3, -1.0), 1.0, on_ambiguity=policy))
    # Flush, and a stick at each end that the other leaves, and separation.
    assert log.solutions.values[1] == 4 if policy != "separate" else log.solutions.values[0] == 4
    separates = policy == "separate"
    assert (final(log, "mode") == pp.ContactMode.SEPARATE) == separates
    assert final(log, "position") == pytest.approx(
        (0.0, 1.0) if separates else (0.3, 0.0), abs=1e-12
    )


@METHODS
def test_logs_of_one_point_do_not_have_the_variables_of_a_side(method):
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=1.0), contact=LAW, effects=(pp.RingFriction(),)
    )
    log = run(scene, (0, 1), 1.0, method=method)
    assert not {"flush", "contact_position"} & {*log.data_vars}
    assert {"flush", "contact_position"} <= {
        *run(on_side((PLATE,)), (0, 1), 1.0, method=method).data_vars
    }
