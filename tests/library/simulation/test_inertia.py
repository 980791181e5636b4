"""Motion with inertia: starts, impacts, flight, stops, energy, and the limits of other scenes."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanics.builders import BOTH, DEFINITION_2, FRICTION, INERTIA, make_scene
from mechanics.strategies import coefficients, scenes
from simulation.runs import check, final, heading, run

import planar_pushing as pp

STILL = (0.0, 0.0)
#: Methods, and the error of a stop; steps of 0.01 stop at the end of one.
METHODS = pytest.mark.parametrize(
    ("method", "tolerance"), [("event-driven", 1e-9), ("time-stepping", 0.01)]
)


def flight(twist, duration, effects=BOTH, **options):
    """A slider released far from a fence at rest."""
    return check(run(make_scene(2, 0.5, effects), STILL, duration, twist=twist, gap=50, **options))


@pytest.mark.parametrize("effects", [INERTIA, BOTH], ids=["inertia", "both"])
@pytest.mark.parametrize("angle", [20, 60, 100, 150])
@pytest.mark.parametrize("length", [0.0, 1e-6, 2.0])
def test_first_acceleration_from_rest_is_that_of_solve(effects, angle, length):
    """A fence that starts with a steady acceleration; the log's second instant is 1e-4 later."""
    scene, (a_x, a_y) = make_scene(length, 0.5, effects), heading(angle, 2.0)
    pusher = pp.Pusher(velocity=lambda t: (a_x * t, a_y * t))
    log = check(run(scene, pusher, 1e-4, samples=3))
    (solution,) = pp.solve(scene, np.deg2rad(angle), 2.0)
    assert log.mode[0] == solution.mode
    assert log.force[0].values == pytest.approx(solution.force, abs=1e-10)
    assert final(log, "twist") / 1e-4 == pytest.approx(solution.twist, abs=1e-7)


@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
def test_slow_pushing_tends_to_the_quasi_static_motion_like_the_square_of_the_speed(method):
    def turned(effects, speed):
        step = {"step": 1 / 400 / speed} if method == "time-stepping" else {}
        log = run(
            make_scene(2, 2.0, effects), heading(30, speed), 0.5 / speed, method=method, **step
        )
        return final(check(log), "rod_angle")

    quasi_static = turned(FRICTION, 1.0)
    gaps = [turned(BOTH, speed) - quasi_static for speed in (0.1, 0.05, 0.025)]
    assert np.log2(np.abs(np.divide(gaps[:-1], gaps[1:]))) == pytest.approx([2, 2], abs=0.05)


@METHODS
def test_translation_stops_after_the_path_of_constant_friction(method, tolerance):
    """Without rotation friction is W: the slider stops after m v / W on a path of m v^2 / (2 W)."""
    effects = (pp.RingFriction(weight=0.5), pp.Inertia(mass=2.0))
    log = flight((0.6, 0.8, 0), 10, effects, samples=1001, method=method)
    path = final(log, "position") - log.position[0].values
    assert path == pytest.approx([2 * 0.6, 2 * 0.8], abs=tolerance)
    stopped = log.time[log.kinetic_energy == 0][0]
    assert stopped == pytest.approx(4, abs=2 * tolerance)
    assert final(log, "dissipated") == pytest.approx([1, 0], abs=1e-9)


@METHODS
def test_spin_stops_after_the_angle_of_constant_torque(method, tolerance):
    effects = (pp.RingFriction(weight=0.5), pp.Inertia(mass=2.0, gyration_radius=0.5))
    log = flight((0, 0, 2), 10, effects, samples=1001, method=method)
    turned = np.deg2rad(final(log, "rod_angle") - log.rod_angle[0])
    assert turned == pytest.approx(2, abs=2 * tolerance)
    assert log.time[log.kinetic_energy == 0][0] == pytest.approx(2, abs=2 * tolerance)


def moment_arm(k):
    """H(k) for 0 < k < 1, from the elliptic integrals."""
    m = mpmath.mpf(k) ** 2
    e = mpmath.ellipe(m)
    return (e - (1 - m) * mpmath.ellipk(m)) / (k * e)


@pytest.mark.parametrize("gyration_radius", [0.6, 0.75, 0.9])
@pytest.mark.parametrize("twist", [(0.8, 0, 0.7), (1, 0, 0.1)])
def test_spin_ratio_follows_the_limit_surface_while_the_slider_stops(gyration_radius, twist):
    """From m v' = -W f and m rho^2 (k v)' = -W t: d ln v = dk / (H(k) / rho^2 - k)."""
    effects = (pp.RingFriction(), pp.Inertia(gyration_radius=gyration_radius))
    log = flight(twist, 6, effects, samples=601)
    moving = np.flatnonzero(log.kinetic_energy.values > 1e-6)
    k = log.spin_ratio.values[moving]
    speed = np.hypot(*log.twist.values[moving, :2].T)
    for end in (len(k) // 2, len(k) - 1):
        fallen = mpmath.quad(
            lambda x: 1 / (moment_arm(x) / gyration_radius**2 - x), np.linspace(k[0], k[end], 5)
        )
        assert np.log(speed[end] / speed[0]) == pytest.approx(float(fallen), abs=1e-6)


def test_spin_ratio_tends_to_where_friction_and_inertia_agree():
    effects = (pp.RingFriction(), pp.Inertia(gyration_radius=0.8))
    limit = float(
        mpmath.findroot(lambda k: moment_arm(k) - 0.64 * k, (0.5, 0.99), solver="anderson")
    )
    log = flight((0.8, 0, 0.65), 6, effects, samples=4001)
    assert final(log, "kinetic_energy") == 0
    distance = np.abs(log.spin_ratio.values[log.kinetic_energy.values > 1e-14] - limit)
    assert np.all(np.diff(distance) <= 1e-9)
    assert distance[-1] < 1e-2


def test_ring_whose_mass_lies_on_it_ends_with_its_motion_center_on_it():
    log = flight((0.3, 0, 2), 6, samples=4001)
    ratio = log.spin_ratio.values[log.kinetic_energy.values > 1e-10]
    assert ratio[-1] == pytest.approx(1, abs=1e-5)


@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
def test_momentum_is_conserved_where_nothing_acts(method):
    twist = (0.3, 0.2, -0.7)
    log = flight(twist, 5, INERTIA, method=method)
    assert log.twist.values == pytest.approx(np.tile(twist, (log.sizes["time"], 1)), abs=1e-11)
    moved = final(log, "position") - log.position[0].values
    assert moved == pytest.approx([1.5, 1.0], abs=1e-10)


def test_impact_of_a_translating_slider_is_that_of_a_rigid_body():
    """Sticking impulse on a free body: angular momentum about the contact is conserved."""
    scene = make_scene(2, pp.PerfectlyRough(), INERTIA)
    log = check(run(scene, STILL, 1.0, twist=(0, -1, 0), gap=0.5))
    lever = 2 * math.cos(math.pi / 4)
    spin = -lever / (1 + 2**2)
    assert final(log, "twist")[2] == pytest.approx(spin, abs=1e-12)
    assert final(log, "kinetic_energy") == pytest.approx((1 + 2**2) * spin**2 / 2, abs=1e-12)
    assert final(log, "contact_dissipated") == pytest.approx(0.5 - 2.5 * spin**2, abs=1e-12)


def test_friction_impulse_lies_on_the_edge_of_the_cone():
    log = check(run(make_scene(2, 0.2, INERTIA), STILL, 0.51, twist=(2, -1, 0), gap=0.5))
    impulse = final(log, "twist")[:2] - log.twist[0].values[:2]
    assert impulse[0] / impulse[1] == pytest.approx(-0.2, abs=1e-12)


def test_frictionless_impact_of_a_ring_keeps_its_tangential_velocity():
    log = check(run(make_scene(0, 0.0, INERTIA), STILL, 1, twist=(0.4, -1, 0.3), gap=0.5))
    assert final(log, "twist") == pytest.approx([0.4, 0, 0.3], abs=1e-12)
    assert final(log, "gap") == 0


def test_fence_that_starts_and_stops_leaves_the_slider_at_rest():
    log = check(run(make_scene(2, 0.5, BOTH), [(0, heading(60)), (1, STILL)], 6))
    assert log.attrs["stopped"] == ""
    assert final(log, "kinetic_energy") == 0
    rests = log.sel(time=slice(5, None))
    assert np.ptp(rests.rod_angle.values) == 0


def test_smooth_start_and_reversal():
    pusher = pp.Pusher(velocity=lambda t: (0.3 * math.sin(3 * t), math.sin(2 * t)))
    log = check(run(make_scene(2, 0.5, BOTH), pusher, 3))
    assert log.mode[0] == pp.ContactMode.SLIP_LEFT
    assert set(log.mode.values) == {0, 2, 3}
    assert final(log, "kinetic_energy") < 1e-20


def test_painleve_configuration_without_a_solution_stops_the_run():
    """Sliding to the left on a steep rod: any force on the edge drives the contact into the fence."""
    pusher = pp.Pusher(velocity=lambda t: (0, max(0.0, t - 0.5)), breakpoints=(0.5,))
    scene = make_scene(2, 3.0, INERTIA, psi=np.deg2rad(60))
    log = run(scene, pusher, 2, twist=(-1, 0, 0))
    assert log.attrs["stopped"] == "no contact mode is consistent"
    assert log.attrs["stopped_time"] == 0.5
    assert log.outcome[-1] == pp.Outcome.INCONSISTENT
    assert final(log, "slip") == pytest.approx(-0.5, abs=1e-12)


def test_painleve_configuration_with_two_solutions_is_recorded_as_a_choice():
    """Where the fence retreats from the same slider, parting and slipping on are both consistent."""
    modes = {}
    for policy in ("keep-contact", "separate"):
        pusher = pp.Pusher(velocity=lambda t: (0, min(0.0, 0.5 - t)), breakpoints=(0.5,))
        scene = make_scene(2, 3.0, INERTIA, psi=np.deg2rad(60))
        log = check(run(scene, pusher, 0.6, twist=(-1, 0, 0), on_ambiguity=policy))
        here = np.flatnonzero(log.time == 0.5)[-1]
        assert log.outcome[here] == pp.Outcome.AMBIGUOUS
        modes[policy] = pp.ContactMode(int(log.mode[here]))
    assert modes["keep-contact"] is pp.ContactMode.SLIP_LEFT
    assert modes["separate"] is pp.ContactMode.SEPARATE


def test_no_impulse_under_the_second_definition_stops_the_run():
    log = run(make_scene(5, DEFINITION_2, BOTH), heading(165), 1)
    assert log.attrs["stopped"] == "no impulse at the contact is consistent"


def test_grazing_contact():
    """The fence rises by 0.5 and falls back: just below the slider, and just into it."""
    pusher = pp.Pusher(velocity=lambda t: (0, 1 - t))
    scene = make_scene(2, 0.3, INERTIA)
    clear, hit = (check(run(scene, pusher, 2, gap=gap)) for gap in (0.5 + 1e-7, 0.5 - 1e-7))
    assert final(clear, "kinetic_energy") < 1e-20
    assert final(hit, "kinetic_energy") > 0
    assert clear.gap.min() > 0


def test_infinite_friction_with_inertia_keeps_the_closed_form_of_the_rod_angle():
    """A force along the fence lifts nothing, so the center's height stays what the impact left."""
    log = check(run(make_scene(5, np.inf, BOTH), heading(165), 3))
    sine = math.sin(math.pi / 4) - 3 * math.sin(math.radians(165)) / 5
    assert final(log, "rod_angle") == pytest.approx(math.degrees(math.asin(sine)), abs=1e-9)


def test_friction_that_settles_fast_is_followed():
    """Slow pushing with inertia: the twist settles a thousand times faster than the slider moves."""
    scene = make_scene(2, 2.0, BOTH)
    log = run(scene, heading(60, 0.02), 0.5 / 0.02)
    slow = run(make_scene(2, 2.0), heading(60), 0.5)
    assert final(log, "evaluations")[0] < 40_000
    assert final(log, "rod_angle") == pytest.approx(final(slow, "rod_angle"), abs=0.02)
    finer = run(scene, heading(60, 0.02), 0.5 / 0.02, rtol=1e-12)
    assert final(log, "rod_angle") == pytest.approx(final(finer, "rod_angle"), abs=1e-8)


@settings(max_examples=45)
@given(
    scenes(contact=coefficients), st.floats(-180, 180), st.floats(-180, 180),
    st.tuples(st.floats(-1, 1), st.floats(0, 0.3)),
    st.sampled_from(["keep-contact", "separate", "stay-in-mode"]),
)  # fmt: skip
def test_random_scenes_run_to_an_end_that_is_explained(scene, first, second, start, policy):
    fence, (omega, gap) = [(0, heading(first)), (0.4, heading(second))], start
    options = {"twist": (0.2, -0.3, omega), "gap": gap} if scene.stores_energy else {}
    log = check(run(scene, fence, 1, samples=11, rtol=1e-8, on_ambiguity=policy, **options), 1e-7)
    assert not log.attrs["stopped"] or log.attrs["stopped"].startswith(("the", "no "))


def test_initial_twist_into_the_fence_is_an_impact():
    log = check(run(make_scene(2, pp.PerfectlyRough(), INERTIA), STILL, 0.1, twist=(0, -1, 0)))
    assert log.contact_dissipated[0] > 0.1
    assert log.attrs["stopped"] == ""


def test_fence_that_slides_along_before_it_pushes():
    pusher = pp.Pusher(velocity=lambda t: (0.6 * t, 0.3 * t * t))
    log = check(run(make_scene(2, 0.5, BOTH), pusher, 1.5))
    assert log.attrs["stopped"] == ""
    assert log.mode[0] == pp.ContactMode.SEPARATE
    assert final(log, "mode") == pp.ContactMode.SLIP_LEFT
