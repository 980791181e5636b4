"""A finger against a flat side: against `solve`, the fence, scipy, and its own symmetry and energy."""

import numpy as np
import pytest

import planar_pushing as pp
from simulation.runs import check, final, heading, run, run_slow_uncompiled
from simulation.straight import Pushed

POINTS, SHARES = [(1, 0), (-0.5, np.sqrt(0.75)), (-0.4, -np.sqrt(0.75))], [0.2, 0.5, 0.3]
TRIPOD = pp.SupportFriction(support=pp.Points(POINTS, SHARES))
#: The ring as points: the sum converges faster than any power while the motion center is off the ring.
RIM = [(np.cos(angle), np.sin(angle)) for angle in 2 * np.pi * np.arange(400) / 400]
HEAVY, ASIDE = (pp.Inertia(mass=0.7, gyration_radius=0.9, center=c) for c in ((0, 0), (0.2, 0.1)))
FRICTION = {"ring": (pp.RingFriction(),), "tripod": (TRIPOD,)}
EFFECTS = FRICTION | {
    "inertia": (HEAVY,), "both": (pp.RingFriction(), HEAVY), "tripod, aside": (TRIPOD, ASIDE),
}  # fmt: skip
SLIPPING = heading(68)


def of_each(*names):
    """Names of sets of effects; those but the ring's take long to compile."""
    return [pytest.param(name, marks=() if name == "ring" else pytest.mark.slow) for name in names]


every_effect = pytest.mark.parametrize(
    "effects",
    [pytest.param(EFFECTS[p.values[0]], marks=p.marks, id=p.values[0]) for p in of_each(*EFFECTS)],
)


SLICK = pp.Coulomb(0.1)


def scene(effects, contact=SLICK, side=(-np.inf, np.inf), psi=1.2):
    slider = pp.Slider(rod_length=2.0, rod_angle=psi, radius=1.0, side=side)
    return pp.Scene(slider=slider, contact=contact, effects=effects)


def pushed(pushed_scene, velocity, duration=0.7, *, shape="finger", samples=5, **options):
    pusher = pp.Pusher(velocity=velocity, shape=shape)
    return run(pushed_scene, pusher, duration, samples=samples, **options)


def test_every_effect_without_the_compiler():
    said = run_slow_uncompiled(__file__)
    assert all(f"[jerk-{name}] PASSED" in said for name in EFFECTS if name != "ring")


@pytest.mark.parametrize("name", of_each(*FRICTION))
@pytest.mark.parametrize("degrees", [68, 90, 165])
def test_the_first_instant_is_a_solution_from_rest(name, degrees):
    effects = FRICTION[name]
    found = pushed(scene(effects, pp.Coulomb(0.3)), heading(degrees), 1e-3).isel(time=0)
    (solution,) = pp.solve(scene(effects, pp.Coulomb(0.3)), np.deg2rad(degrees))
    assert int(found.mode) == solution.mode
    assert found.twist.values == pytest.approx(solution.twist, abs=1e-12)
    assert found.force.values == pytest.approx(solution.force, abs=1e-12)


@every_effect
@pytest.mark.parametrize("jerk", [True, False], ids=["jerk", "from rest"])
def test_the_first_instant_is_that_of_a_fence(effects, jerk):
    """The side turns after an impact: then the impulse is that of a fence, but not the force."""
    velocity = SLIPPING if jerk else lambda t: (0.4 * t, t)
    finger, fence = (pushed(scene(effects), velocity, 1e-3, shape=s) for s in ("finger", "fence"))
    for name in ("position", "twist", "kinetic_energy", *(() if jerk else ("force", "mode"))):
        assert finger[name].values[0] == pytest.approx(fence[name].values[0], abs=1e-12), name


@every_effect
def test_a_finger_that_sticks_is_a_pin_as_is_a_fence(effects):
    rough = scene(effects, pp.PerfectlyRough())
    finger, fence = (pushed(rough, SLIPPING, shape=s) for s in ("finger", "fence"))
    for name in ("position", "rod_angle", "twist", "force", "work"):
        assert np.allclose(finger[name], fence[name], atol=1e-9), name
    assert not finger.slip.any()
    assert not finger.contact_position.any()


@every_effect
def test_a_contact_that_sticks_moves_with_the_finger(effects):
    log = check(pushed(scene(effects, pp.PerfectlyRough()), heading(80)))
    assert (log.mode == pp.ContactMode.STICK).all()
    angle = np.deg2rad(log.rod_angle.values)
    contact = log.position.values - 2.0 * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    assert contact == pytest.approx(log.pusher.values, abs=1e-14)
    assert np.ptp(log.rod_angle.values) > 1.0


def straight(effects, velocity, rate=(0.0, 0.0)):
    """The independent integration of a slip to the left on the side."""
    mass = next(((e.mass, e.gyration_radius, e.center) for e in effects if e.degree == 2), None)
    points, shares = (POINTS, SHARES) if effects[0] is TRIPOD else (RIM, [1 / len(RIM)] * len(RIM))
    return Pushed(2.0, 1.2, points, shares, 0.1, -1, (velocity, rate), mass)


followed = pytest.mark.parametrize("name", of_each("ring", "tripod", "both", "tripod, aside"))


@followed
@pytest.mark.parametrize("rate", [(0.0, 0.0), (0.3, 0.5)], ids=["steady", "faster"])
def test_a_slip_along_the_side_is_that_of_scipy(name, rate):
    start, slope = np.array(SLIPPING), np.array(rate)
    log = check(pushed(scene(EFFECTS[name]), lambda t: start + slope * t))
    assert (log.mode == pp.ContactMode.SLIP_LEFT).all()
    reference = straight(EFFECTS[name], start, slope)
    _, state, along = reference.follow(0.7, log.twist.values[0])
    assert final(log, "position") == pytest.approx(reference.place(state), abs=1e-9)
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    assert log.contact_position.values == pytest.approx(-log.slip.values, abs=1e-14)
    assert along > 0.3


@followed
def test_the_finger_leaves_the_side_at_its_end(name):
    log = pushed(scene(EFFECTS[name], side=(-1.0, 0.2)), SLIPPING)
    time, state, _ = straight(EFFECTS[name], SLIPPING).follow(0.7, log.twist.values[0], until=0.2)
    (row,) = np.flatnonzero(np.diff(log.parted.values.astype(int))) + 1
    assert float(log.time[row]) == pytest.approx(time, abs=1e-9)
    assert float(log.rod_angle[row]) == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert float(log.contact_position[row]) == pytest.approx(0.2, abs=1e-10)
    assert (log.mode[row:] == pp.ContactMode.SEPARATE).all()
    assert not log.force.values[row:].any()
    assert log.attrs["stopped"] == ""
    assert log.time.values[-1] == 0.7


def test_a_slider_without_inertia_stays_where_the_finger_leaves_it():
    log = pushed(scene((pp.RingFriction(),), side=(-1.0, 0.2)), SLIPPING)
    after = log.isel(time=log.parted.values)
    assert np.ptp(after.rod_angle.values) == 0
    assert not after.twist.values.any()


@pytest.mark.slow
def test_a_slider_without_friction_flies_on_where_the_finger_leaves_it():
    slick = scene((HEAVY,), side=(-1.0, 0.2))
    after = pushed(slick, SLIPPING).pipe(lambda log: log.isel(time=log.parted.values))
    assert after.sizes["time"] > 2
    assert after.twist.values == pytest.approx(np.tile(after.twist.values[0], (len(after.time), 1)))


@pytest.mark.slow
def test_a_finger_may_pass_beside_the_side():
    """From below it goes past the end, and then up."""
    beside = [(0, (1.0, 0.0)), (0.5, (0.0, 1.0))]
    log = pushed(scene((HEAVY,), side=(-1.0, 0.4)), beside, 1.0, gap=0.2)
    assert not log.twist.values.any()
    parted = log.isel(time=log.parted.values)
    assert float(parted.time[0]) == pytest.approx(0.7, abs=1e-9)
    met = pushed(scene((HEAVY,), side=(-1.0, 0.6)), beside, 1.0, gap=0.2)
    assert met.twist.values[-1].any()
    assert not met.parted.any()


@every_effect
def test_mirrored_scenes_have_mirrored_motions(effects):
    """The finger's velocity jumps on the way; some leave the side."""
    mirror = {TRIPOD: pp.SupportFriction(support=pp.Points([(x, -y) for x, y in POINTS], SHARES)),
              ASIDE: pp.Inertia(mass=0.7, gyration_radius=0.9, center=(0.2, -0.1))}  # fmt: skip
    others = tuple(mirror.get(each, each) for each in effects)
    one = pushed(scene(effects, pp.Coulomb(0.3), (-1.0, 0.35)), [(0, (0.1, 1)), (0.3, (0.9, 0.5))])
    other = pushed(
        scene(others, pp.Coulomb(0.3), (-0.35, 1.0), np.pi - 1.2),
        [(0, (-0.1, 1)), (0.3, (-0.9, 0.5))],
    )
    assert np.allclose(one.time, other.time, atol=1e-8)
    assert one.rod_angle.values == pytest.approx(180 - other.rod_angle.values, abs=1e-6)
    assert one.contact_position.values == pytest.approx(-other.contact_position.values, abs=1e-8)
    assert one.position.values == pytest.approx(other.position.values * (-1, 1), abs=1e-8)
    assert np.array_equal(one.parted, other.parted)
    assert np.ptp(one.contact_position.values) > 0.01


@pytest.mark.slow
def test_a_ring_of_any_support_is_a_ring():
    general = pp.SupportFriction(support=pp.Composite([(1.0, pp.Ring(1.0))]))
    for masses in ((), (HEAVY,)):
        one = pushed(scene((pp.RingFriction(), *masses)), SLIPPING)
        other = pushed(scene((general, *masses)), SLIPPING)
        for name in ("position", "rod_angle", "contact_position", "force", "work"):
            assert np.allclose(other[name], one[name], atol=1e-8), name


@every_effect
def test_steps_converge_to_the_event_driven_motion(effects):
    exact = pushed(scene(effects, pp.Coulomb(0.3)), [(0, (0.1, 1)), (0.3, (0.9, 0.5))])
    errors = [
        abs(final(pushed(scene(effects, pp.Coulomb(0.3)), [(0, (0.1, 1)), (0.3, (0.9, 0.5))],
                         method="time-stepping", step=step), "rod_angle") - final(exact, "rod_angle"))
        for step in (0.01, 0.005, 0.0025)
    ]  # fmt: skip
    assert errors[0] / errors[2] == pytest.approx(4.0, rel=0.35)
    assert errors[2] < 0.2


@every_effect
def test_steps_leave_the_side_where_the_event_driven_motion_does(effects):
    exact = pushed(scene(effects, side=(-1.0, 0.2)), SLIPPING)
    steps = pushed(scene(effects, side=(-1.0, 0.2)), SLIPPING, method="time-stepping", step=0.001)
    check_energy(steps)
    ends = [float(log.time[log.parted.values][0]) for log in (exact, steps)]
    assert ends[1] == pytest.approx(ends[0], abs=0.005)
    assert final(steps, "rod_angle") == pytest.approx(final(exact, "rod_angle"), abs=0.2)


def check_energy(log):
    """What `check` says, of a finger that has left the side and is anywhere."""
    check(log.assign(gap=log.gap.where(~log.parted, 0.0)))


@pytest.mark.parametrize("name", of_each("ring", "both"))
def test_a_batch_has_the_numbers_of_simulate(name):
    effects = EFFECTS[name]
    angles, ends = np.array([60.0, 68.0, 120.0]), np.array([0.1, 0.3, np.inf])
    finger = pp.Pusher(velocity=heading(angles), shape="finger")
    scenes = scene(effects, side=(-1.0, ends))
    batch = pp.simulate_batch(scenes, finger, duration=0.5, samples=3)
    for row, (angle, end) in enumerate(zip(angles, ends, strict=True)):
        log = pushed(scene(effects, side=(-1.0, end)), heading(angle), 0.5, samples=3)
        log = log.sel(time=[0.0, 0.25, 0.5])
        for name in ("rod_angle", "slip", "contact_position", "position", "parted", "mode"):
            assert np.array_equal(batch[name][row], log[name]), (angle, name)
    assert batch.parted[:, -1].values.tolist() == [True, True, False]
    fence = pp.Pusher(velocity=(0.0, 1.0))
    assert "contact_position" not in pp.simulate_batch(scene(effects), fence, duration=0.1)


def test_a_log_on_disk_is_that_in_memory(tmp_path):
    options = {"side": (-1.0, 0.2)}
    plain = pushed(scene((pp.RingFriction(),), **options), SLIPPING)
    with pushed(scene((pp.RingFriction(),), **options), SLIPPING, path=tmp_path / "log.nc") as log:
        assert log.load().identical(plain)
        assert log.attrs["pusher_shape"] == "finger"
    assert '"side": [-1.0, 0.2]' in plain.attrs["scene"]
    assert plain.parted.dtype == bool
    assert "finger" in plain.contact_position.attrs["long_name"]


def test_a_fence_takes_no_notice_of_the_side():
    log, wide = (
        pushed(scene((pp.RingFriction(),), side=side), SLIPPING, shape="fence")
        for side in ((-1, 0.01), (-np.inf, np.inf))
    )
    assert log.drop_attrs().equals(wide.drop_attrs())
    assert "contact_position" not in log
    assert "pusher_shape" not in log.attrs


def test_an_adhesive_finger_pulls_along_its_own_normal():
    log = pushed(scene((pp.RingFriction(),), pp.PerfectlyRough()), heading(-20), 0.5)
    turn = np.deg2rad(log.rod_angle.values) - 1.2
    normal = log.force.values[:, 1] * np.cos(turn) - log.force.values[:, 0] * np.sin(turn)
    assert np.array_equal(log.adhesive, normal < 0)


@pytest.mark.parametrize(
    ("side", "said"),
    [
        ((1.0, -1.0), "side: 1.0 given"),
        ((0.5, 1.0), "side: 0.5 given"),
        ((-1.0, -0.5), "side: -0.5 given"),
        ((-1.0, np.nan), "side: nan given"),
        ((-1.0, "far"), "side: 'far' given"),
        (3.0, "side: 3.0 given"),
        ((-1, 0, 1), "side: (-1, 0, 1) given"),
        ((-1.0, [1.0, -2.0]), "side: -2.0 given"),
    ],
)
def test_a_side_that_does_not_hold_the_contact_is_refused(side, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.Slider(rod_length=1.0, rod_angle=1.0, side=side)
    assert str(caught.value) == (
        f"{said}; allowed: (start, end) with start < 0 < end, infinite for a side without an end; measure "
        "both ends along the side from the contact, which is between them, the one toward -x first"
    )


@pytest.mark.parametrize(
    ("given", "remedy"),
    [("fingre", "did you mean finger?"), ("box", "name one of these shapes"),
     (3, "name one of these shapes")],
)  # fmt: skip
def test_an_unknown_shape_is_refused(given, remedy):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.Pusher(velocity=(0, 1), shape=given)
    assert str(caught.value) == f"shape: {given!r} given; allowed: fence, finger; {remedy}"
