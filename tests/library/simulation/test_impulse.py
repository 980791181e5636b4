"""Impulses of impacts: against closed forms, and the balances of momentum across each impact."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from simulation.runs import heading, run
from simulation.scenes import SCENES, Case, friction, scene

import planar_pushing as pp
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.simulation.early_end import quietly

pytestmark = pytest.mark.filterwarnings("ignore:(outline|pusher):planar_pushing.SceneWarning")

MASS, GYRATION = 2.0, 0.104
BOX = ((-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1))
HEAVY = pp.Inertia(mass=MASS, gyration_radius=GYRATION)
TABLE = friction(pp.Polygon(BOX), pp.weight(MASS, 0.3))
#: Part of the time of an impact by which the motion before is earlier.
EARLIER = 1e-9


def pushed(x=0.0, *effects, mu=0.5, **outline):
    """A box of 2 kg that is pushed on its lower side."""
    return pp.scene_at(
        (x, -0.1), (0, 1), effects=effects or (TABLE, HEAVY), contact=pp.Coulomb(mu), **outline
    )


def impacts(log):
    """Rows with an impulse."""
    return np.flatnonzero(log.impulse.any("xy"))


PUSHERS = {
    "fence": {"shape": "fence"}, "finger": {"shape": "finger"},
    "disc": {"shape": "finger", "radius": 0.03},
}  # fmt: skip


@pytest.mark.parametrize("pusher", PUSHERS.values(), ids=PUSHERS)
@pytest.mark.parametrize("outline", [{}, {"outline": BOX}], ids=["point", "side"])
@pytest.mark.parametrize("gap", [0.0, 0.01])
def test_the_blow_of_a_pusher_at_full_speed_is_mass_times_speed(pusher, outline, gap):
    """Through the center, with and without a gap; the force afterwards is that of friction alone."""
    log = run(pushed(**outline), pp.Pusher(velocity=(0, 2), **pusher), 0.1, gap=gap)
    (row,) = impacts(log)
    assert log.time[row] == pytest.approx(gap / 2, abs=1e-12)
    assert log.impulse[row].values == pytest.approx([0, 4], abs=1e-12)
    assert log.work[row] == pytest.approx(8, abs=1e-12)
    assert log.force[row].values == pytest.approx([0, 0.3 * 9.80665 * MASS], abs=1e-9)


@pytest.mark.parametrize("offset", [0.0, 0.03, -0.08, 0.15])
@pytest.mark.parametrize("shape", ["fence", "finger"])
def test_a_blow_off_the_center_gives_less(offset, shape):
    """The arm of the impulse makes the mass at the contact smaller: 1 / (1 / m + x^2 / J)."""
    pusher = pp.Pusher(velocity=(0, 2), shape=shape)
    log = run(pushed(offset, TABLE, HEAVY, mu=0.0), pusher, 0.001)
    size = 2 / (1 / MASS + offset**2 / (MASS * GYRATION**2))
    assert log.impulse[0].values == pytest.approx([0, size], abs=1e-12)
    assert not log.impulse[1:].any()


def test_each_piece_of_the_velocity_gives_its_own_blow():
    """No impulse from a pusher that slows down, or that only changes its speed along the side."""
    pieces = [(0, (0, 1)), (0.1, (0, 3)), (0.2, (0.5, 3)), (0.3, (0, 2))]
    log = run(pushed(), pp.Pusher(velocity=pieces, shape="finger"), 0.35)
    assert log.time.values[impacts(log)] == pytest.approx([0, 0.1], abs=1e-12)
    assert log.impulse.values[impacts(log)] == pytest.approx(np.array([[0, 2], [0, 4]]), abs=1e-12)


def test_a_side_that_arrives_has_the_impulse_of_both_of_its_ends():
    """A box without rotation, given off its center, flies onto a fence."""
    log = run(pushed(0.1, HEAVY, outline=BOX), (0, 0), 0.2, gap=0.1, twist=(0.0, -1.0, 0.0))
    (row,) = impacts(log)
    assert log.event[row] == pp.Event.TOUCHES
    assert log.impulse[row].values == pytest.approx([0, MASS], abs=1e-12)
    assert log.flush[row]


@pytest.mark.parametrize("velocity", [lambda t: (0, t), lambda t: (0.1 * t * t, t * t)])
def test_a_smooth_start_has_no_impulse(velocity):
    log = run(pushed(), pp.Pusher(velocity=velocity, shape="finger"), 0.5)
    assert not log.impulse.any()
    assert log.force[-1].any()


def test_only_logs_of_events_with_inertia_have_impulses(tmp_path):
    ahead = pp.Pusher(velocity=(0, 2), shape="finger")
    log = run(pushed(units=pp.Units()), ahead, 0.1)
    assert log.impulse.attrs["units"] == "N s"
    assert "impulse" not in run(pushed(0.0, TABLE), ahead, 0.1)
    stepped = run(pushed(), ahead, 0.1, method="time-stepping", path=tmp_path / "steps.nc")
    assert "impulse" not in stepped
    # The mean force of the first step has the blow in it.
    assert stepped.force[0, 1] * 0.1 / 1000 == pytest.approx(4, rel=1e-3)
    stepped.close()
    with run(pushed(units=pp.Units()), ahead, 0.1, path=tmp_path / "log.nc") as stream:
        xr.testing.assert_identical(stream.impulse.load(), log.impulse)
    stops = run(pushed(), ahead, 1.0, gap=0.01, until=lambda now: bool(now["impulse"].any()))
    assert stops.time[-1] == pytest.approx(0.005, abs=1e-12)


def test_impulses_have_the_unit_of_force_times_time():
    batch = pp.simulate_batch(
        pushed(0.0, TABLE, pp.Inertia(mass=np.array([1.0, 2.0]), gyration_radius=GYRATION)),
        pp.Pusher(velocity=(0, 2), shape="finger"), duration=0.1,
    )  # fmt: skip
    assert batch.impulse.attrs["quantity"] == "force time"
    assert batch.impulse.values == pytest.approx(np.array([[0, 2], [0, 4]]), abs=1e-12)


def test_impulses_are_those_of_the_certified_twists():
    """A mass from rest under friction, and in flight without it; their golden logs have no impulse."""
    for name, row in (("pulling_with_inertia", 0), ("impact", 14)):
        file = load_scene_file(f"workflow/scenes/{name}.yaml")
        twist = xr.open_dataset(f"tests/golden/simulations/{name}.nc").twist
        log = quietly(simulate_file)(file)
        given = file.simulate.initial_twist
        before = np.array([given.v_x, given.v_y] if given else [0.0, 0.0])
        (mass,) = (e.mass for e in file.build().effects if isinstance(e, pp.Inertia))
        wanted = mass * (twist.values[row, :2] - before)
        assert log.impulse.values[row] == pytest.approx(wanted, rel=1e-12)


# --- Balances ------------------------------------------------------------------------------------


def mass_of(case, log, row):
    """Mass, its moment of inertia, and its center relative to the slider's, along the axes of the log."""
    parts = [effect for effect in case.scene.effects if isinstance(effect, pp.Inertia)]
    mass = sum(part.mass for part in parts)
    x, y = sum(part.mass * np.array(part.center) for part in parts) / mass
    squares = (
        part.mass * (part.gyration_radius**2 + np.hypot(*(np.array(part.center) - (x, y))) ** 2)
        for part in parts
    )
    angle = np.deg2rad(log.rod_angle.values[row])
    c, s = np.cos(angle), np.sin(angle)
    return mass, sum(squares), (c * x - s * y, s * x + c * y)


def contact_of(case, log, row):
    """Where a point of the slider touches the pusher; None if several can."""
    slider, angle = case.scene.slider, np.deg2rad(log.rod_angle.values[row])
    if case.shape == "finger":
        turn = angle - slider.rod_angle
        normal = np.array([-np.sin(turn), np.cos(turn)])
        return log.pusher.values[row] - (0.0, case.radius) + case.radius * normal
    if slider.flush or slider.outline is not None:
        return None
    return log.position.values[row] - slider.rod_length * np.array([np.cos(angle), np.sin(angle)])


def points_on_fence(case, log, row):
    """Places along the fence of the points that are on it."""
    slider, angle = case.scene.slider, np.deg2rad(log.rod_angle.values[row])
    rod = slider.rod_length * np.array([np.cos(angle), np.sin(angle)])
    points = [log.position.values[row] - rod]
    along = slider.side if slider.flush else ()
    points += [points[0] + (x, 0.0) for x in along]
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    outline = () if slider.outline is None else slider.outline_in_body().corners
    points += [log.position.values[row] + turn @ corner for corner in np.asarray(outline)]
    height = log.pusher.values[row][1]
    return [x for x, y in points if abs(y - height) < 1e-6]


def balance(case, log, row):
    """Compare an impulse with the changes of momentum and of angular momentum at its instant."""
    time, twist = float(log.time[row]), np.asarray(case.twist, float)
    if time > 0:
        before = replace(case, duration=time * (1 - EARLIER))
        twist = quietly(pp.simulate)(
            before.scene, before.pusher, duration=before.duration, gap=case.gap, twist=case.twist,
            on_ambiguity=case.policy, samples=2,
        ).twist.values[-1]  # fmt: skip
    mass, moment, (x, y) = mass_of(case, log, row)
    change = log.twist.values[row] - twist
    momentum = mass * (change[:2] + change[2] * np.array([-y, x]))
    spin = moment * change[2]
    impulse, slack = log.impulse.values[row], 1e-6 * (1 + np.abs(log.twist.values).max())
    assert momentum == pytest.approx(impulse, abs=slack)
    arm = log.position.values[row] + (x, y)
    contact = contact_of(case, log, row)
    if contact is not None:
        r_x, r_y = contact - arm
        assert spin == pytest.approx(r_x * impulse[1] - r_y * impulse[0], abs=slack)
        return
    height = log.pusher.values[row][1] - arm[1]
    crosses = arm[0] + (spin + height * impulse[0]) / impulse[1]
    ends = points_on_fence(case, log, row)
    assert min(ends) - slack <= crosses <= max(ends) + slack


MASSIVE = [name for name, case in SCENES.items() if case.scene.stores_energy]


@pytest.mark.parametrize("name", MASSIVE)
def test_an_impulse_is_the_change_of_momentum(name):
    """Where the time between two impacts can be resolved."""
    case = SCENES[name]
    log = case.log()
    rows = impacts(log)
    times = log.time.values[rows]
    for row, wait in zip(rows, np.diff(times, prepend=-1.0), strict=True):
        if wait > 1e-6 and (row + 1 == len(log.time) or log.time[row + 1] > log.time[row]):
            balance(case, log, row)


def random_case(seed):
    """A scene with inertia, under a pusher of any shape with two pieces, from contact or from flight."""
    random = np.random.default_rng(seed)
    inertia = pp.Inertia(
        mass=random.uniform(0.3, 3), gyration_radius=random.uniform(0.4, 1.2),
        center=tuple(random.uniform(-0.3, 0.3, 2)),
    )  # fmt: skip
    effects = (inertia,) if seed % 3 else (pp.RingFriction(), inertia)
    finger, flies = bool(seed % 2), bool(seed % 5 < 2)
    return Case(
        scene=scene(*effects, mu=float(random.uniform(0.1, 2)), psi=random.uniform(0.7, 2.4)),
        velocity=[
            (start, heading(random.uniform(30, 150), random.uniform(0.3, 2)))
            for start in (0.0, 0.25)
        ],
        duration=0.5,
        shape="finger" if finger else "fence",
        radius=0.3 if finger and seed % 4 == 1 else 0.0,
        gap=random.uniform(0.05, 0.2) if flies else 0.0,
        twist=tuple(random.uniform(-0.3, 0.3, 3)),
    )


@pytest.mark.parametrize("seed", range(60))
def test_an_impulse_is_the_change_of_momentum_in_random_scenes(seed):
    case = random_case(seed)
    log = quietly(pp.simulate)(
        case.scene, case.pusher, duration=case.duration, gap=case.gap, twist=case.twist, samples=5
    )
    rows = impacts(log)
    assert len(rows) or case.gap
    for row in rows:
        balance(case, log, row)
