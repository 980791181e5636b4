"""The time-stepping integrator: order 1, stops, starts, and configurations in which no force will do."""

import math
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

from planar_pushing import (
    ContactMode,
    Coulomb,
    Inertia,
    InfiniteFriction,
    InvalidValue,
    PerfectlyRough,
    RingFriction,
    Scene,
    Slider,
)
from planar_pushing.core.system import NO_MODE
from planar_pushing.simulation.fields import Stop, arrays, logged_fields, sampled_fields
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.runs import REASONS, Run
from planar_pushing.terms.options import Method

FRICTION, INERTIA = RingFriction(weight=0.7), Inertia(mass=1.3, gyration_radius=0.8)
EFFECTS = {"friction": (FRICTION,), "inertia": (INERTIA,), "both": (FRICTION, INERTIA)}
#: l, law, fence angle, rod angle, duration; final rod angle in degrees and slip (R = W = 1).
REFERENCES = [
    (5, InfiniteFriction(), 165, 45, 3, 33.49164319965058, 2.1514157444528927),
    (2, Coulomb(2), 60, 45, 3, 6.511092064133266, -0.15251676648881093),
    (2, Coulomb(2), 170, 45, 3, 29.673182764562068, 2.437240035590965),
    (1, Coulomb(0.5), 20, 80, 2, 110.23885816124236, -1.0410568765402608),
]


def straight(degrees, speed=1.0):
    return speed * math.cos(math.radians(degrees)), speed * math.sin(math.radians(degrees))


def problem(effects, pusher, duration, length=2.0, law=None, degrees=45.0, **options):
    slider = Slider(rod_length=length, rod_angle=math.radians(degrees))
    scene = Scene(slider=slider, contact=law or Coulomb(2.0), effects=effects)
    return Problem(scene=scene, pusher=Pusher(velocity=pusher), duration=duration, **options)


def records(task, steps, samples=2):
    times = np.linspace(0, task.duration, samples)
    return recorded(Run(task, times, Method.TIME_STEPPING, task.duration / steps))


def recorded(run):
    """Every row of a run, its vectors as tuples, the angle in radians."""
    fields = {*logged_fields(run.problem), *sampled_fields(run.problem)}
    log = arrays(np.concatenate(list(run)), run.problem, fields)
    log["rod_angle"] = np.deg2rad(log["rod_angle"])
    log["dissipated"] = log["dissipated"].sum(axis=1)
    log["stopped"] = [REASONS[Stop(stop)] for stop in log["stopped"]]
    lists = {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in log.items()}
    return [
        SimpleNamespace(
            **{k: tuple(v) if isinstance(v, list) else v for k, v in zip(lists, row, strict=True)}
        )
        for row in zip(*lists.values(), strict=True)
    ]


def rates(errors):
    return np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))


@pytest.mark.parametrize("reference", REFERENCES, ids=["infinite", "left", "right", "turning"])
def test_order_one_to_the_quasi_static_references(reference):
    length, law, fence, degrees, duration, angle, slip = reference
    task = problem(EFFECTS["friction"], straight(fence), duration, length, law, degrees)
    ends = [records(task, steps)[-1] for steps in (100, 200, 400)]
    errors = np.array([(math.degrees(r.rod_angle) - angle, r.slip - slip) for r in ends])
    assert rates(errors) == pytest.approx(np.ones((2, 2)), abs=0.02)
    assert np.abs(errors[-1]) == pytest.approx(0, abs=0.1)


@cache
def reference(name):
    """Event-driven end of a run in which the fence accelerates and turns."""
    task = problem(EFFECTS[name], accelerating, 1.5, 1.2, Coulomb(0.8), 70)
    return task, recorded(Run(task, [0.0, 1.5]))[-1]


def accelerating(time):
    return 0.6 * time, 0.3 * time + 0.4 * time**2


@pytest.mark.parametrize("name", ["inertia", "both"])
def test_order_one_to_the_event_driven_motion(name):
    task, exact = reference(name)
    ends = [records(task, steps)[-1] for steps in (50, 100, 200)]
    assert exact.stopped == ""
    assert {r.mode for r in ends} == {exact.mode}
    errors = np.array([(*r.position, r.rod_angle, *r.twist) for r in ends])
    errors -= (*exact.position, exact.rod_angle, *exact.twist)
    assert rates(np.abs(errors).max(axis=1)) == pytest.approx([1, 1], abs=0.05)
    assert np.abs(errors[-1]).max() < 0.02


def test_slow_pushing_with_inertia_is_quasi_static():
    pushed = [
        records(problem(EFFECTS["both"], straight(60, speed), 3 / speed), 200)[-1]
        for speed in (0.1, 0.05)
    ]
    slow = records(problem(EFFECTS["friction"], straight(60), 3), 200)[-1]
    errors = np.array([(r.rod_angle - slow.rod_angle, r.slip - slow.slip) for r in pushed])
    assert rates(errors) == pytest.approx(np.full((1, 2), 2), abs=0.1)


@pytest.mark.parametrize(
    "twist", [(0.3, 0.2, 1.0), (0.0, 0.5, 0.0), (0.0, 0.0, 1.5), (1.0, 1.0, 1e-4)]
)
def test_a_released_slider_stops_and_stays(twist):
    task = problem(EFFECTS["both"], (0.0, -5.0), 6.0, twist=twist)
    run = records(task, 1200, samples=61)
    at_rest = [r.time for r in run if r.twist == (0.0, 0.0, 0.0)]
    assert at_rest
    assert all(r.twist == (0.0, 0.0, 0.0) for r in run if r.time >= at_rest[0])
    assert run[-1].dissipated == pytest.approx(run[0].kinetic_energy, rel=1e-12, abs=0)
    assert run[-1].kinetic_energy == 0


def test_a_pure_translation_stops_when_dry_friction_has_taken_its_momentum():
    task = problem(EFFECTS["both"], (0.0, -5.0), 2.0, twist=(0.6, 0.8, 0.0))
    run = records(task, 2000, samples=2001)
    stop = next(r for r in run if r.twist == (0.0, 0.0, 0.0))
    weight, mass = FRICTION.weight, INERTIA.mass
    assert stop.time == pytest.approx(mass / weight, abs=0.002)
    assert math.dist(stop.position, run[0].position) == pytest.approx(mass / weight / 2, abs=0.002)


def test_without_support_momentum_is_conserved_in_flight():
    task = problem(EFFECTS["inertia"], (0.0, -1.0), 1.0, twist=(0.4, 0.3, -0.8))
    run = records(task, 100, samples=11)
    assert {r.mode for r in run} == {ContactMode.SEPARATE}
    assert all(r.twist == pytest.approx((0.4, 0.3, -0.8), rel=1e-13) for r in run)
    assert run[-1].position[0] - run[0].position[0] == pytest.approx(0.4, rel=1e-12, abs=0)


@pytest.mark.parametrize("name", EFFECTS)
def test_the_fence_starts_stops_and_turns(name):
    pieces = [(0, (0.5, 1)), (0.5, (0, 0)), (1, (0, 1)), (1.5, (0.3, -1)), (1.7, (0, 2))]
    run = records(problem(EFFECTS[name], pieces, 2.0), 400, samples=81)
    assert run[-1].stopped == ""
    assert min(r.gap for r in run) >= -1e-13
    assert all(np.isfinite([*r.position, *r.twist, *r.force, r.slip, r.work]).all() for r in run)
    assert {ContactMode.STICK, ContactMode.SEPARATE} <= {r.mode for r in run}
    standing = [r for r in run if 0.5 < r.time < 1]
    if name == "friction":
        assert all(r.twist == (0.0, 0.0, 0.0) and r.gap == 0 for r in standing)


@pytest.mark.parametrize("name", EFFECTS)
def test_work_becomes_kinetic_energy_and_heat(name):
    run = records(problem(EFFECTS[name], accelerating, 1.0, law=Coulomb(0.4), degrees=100), 200, 21)
    energy = [r.kinetic_energy + r.dissipated + r.contact_dissipated for r in run]
    assert energy == pytest.approx([r.work for r in run], abs=1e-13)
    assert (np.diff([(r.dissipated, r.contact_dissipated) for r in run], axis=0) >= -1e-15).all()


def test_times_that_rounding_parts_are_one_time():
    task = problem(EFFECTS["both"], [(0, (0.5, 1)), (0.3, (0, 1)), (0.6, (0, 0))], 1.0)
    run = recorded(Run(task, np.arange(0, 1.01, 0.1), Method.TIME_STEPPING, 0.05))
    assert 0.3 not in np.arange(0, 1.01, 0.1)
    assert run[-1].stopped == ""
    assert np.diff([r.time for r in run]).min() > 0.01


@pytest.mark.parametrize("name", EFFECTS)
def test_a_gap_closes_and_no_step_goes_through_the_fence(name):
    run = records(problem(EFFECTS[name], (0.1, 0.7), 1.0, gap=0.25), 130, samples=131)
    gaps = np.array([r.gap for r in run])
    assert gaps[0] == 0.25
    assert (gaps >= 0).all()
    assert gaps.min() == pytest.approx(0, abs=1e-15)
    first = next(r.time for r in run if r.mode != ContactMode.SEPARATE)
    assert first == pytest.approx(0.25 / 0.7, abs=2 / 130)


@pytest.mark.parametrize("name", ["inertia", "both"])
def test_a_sliding_painleve_configuration_is_survived(name):
    # The contact slides left over a fence that comes up: no finite force keeps it sliding, and the step
    # finds the impulse that makes it stick.
    task = problem(EFFECTS[name], lambda t: (0.0, t), 0.5, law=Coulomb(3), twist=(-1.0, 0.0, 0.0))
    stopped = recorded(Run(task, [0.0, 0.5]))[-1].stopped
    ends = [records(task, steps)[-1] for steps in (50, 100, 200)]
    assert stopped == "no contact mode is consistent"
    assert all(r.stopped == "" and r.mode == ContactMode.STICK and r.gap == 0 for r in ends)
    assert rates(np.diff([r.rod_angle for r in ends])) == pytest.approx([1], abs=0.1)


def test_without_a_consistent_mode_the_run_stops_and_says_so():
    law = InfiniteFriction(at_zero_normal="none")
    run = records(problem(EFFECTS["friction"], straight(165), 1.0, 5.0, law), 100)
    assert run[-1].stopped == "no contact mode is consistent"
    assert (run[-1].mode, run[-1].solutions, run[-1].time) == (NO_MODE, 0, 0.0)


@pytest.mark.parametrize(
    ("policy", "last", "choices"),
    [
        ("keep-contact", ContactMode.STICK, 3),
        ("separate", ContactMode.SEPARATE, 1),
        ("stay-in-mode", 1, 3),
        ("slip-left", ContactMode.SLIP_LEFT, 3),
        ([(0, "separate"), (0.1, "slip-left")], ContactMode.SLIP_LEFT, 3),
    ],
    ids=str,
)
def test_pulling_follows_the_policy(policy, last, choices):
    pieces = [(0, straight(10)), (0.1, straight(-10))]
    run = records(problem(EFFECTS["friction"], pieces, 0.3, on_ambiguity=policy), 300)
    turned = next(r for r in run if r.solutions > 1)
    assert turned.time == pytest.approx(0.1)
    assert turned.mode == last
    assert (run[-1].mode, run[-1].solutions) == (last, choices)


def test_a_rough_contact_holds_on_to_the_slider_that_it_pulls():
    run = records(problem(EFFECTS["both"], straight(-90), 1.0, law=PerfectlyRough()), 100)
    assert run[-1].mode == ContactMode.STICK
    assert run[-1].force[1] < 0
    assert run[-1].gap == 0


def test_large_friction_converges_to_infinite_friction():
    laws = Coulomb(1e4), Coulomb(1e5), InfiniteFriction()
    ends = [
        records(problem(EFFECTS["both"], straight(165), 1.0, 5.0, law), 100)[-1] for law in laws
    ]
    errors = [abs(r.rod_angle - ends[-1].rod_angle) for r in ends[:-1]]
    assert errors[0] < 1e-4
    assert errors[1] < 0.11 * errors[0]


def test_a_slider_that_lies_down_stops_the_run():
    run = records(problem(EFFECTS["friction"], straight(90), 10.0, 1.0, Coulomb(0.5), 30), 1000)
    assert run[-1].stopped == "the slider's center comes down to the fence"
    assert 0 < run[-1].time < 10


@pytest.mark.parametrize("step", [0.0, -1.0, math.nan, "fine"])
def test_a_step_that_is_no_length_is_refused(step):
    with pytest.raises(InvalidValue, match=r"step: .* given; allowed: a finite number > 0"):
        Run(problem(EFFECTS["friction"], (0, 1), 1.0), [0, 1], Method.TIME_STEPPING, step)
