"""A finger of finite radius: against scipy, the offset side of a point, its own motion and energy."""

import numpy as np
import pytest
import xarray as xr
from scipy.optimize import brentq

import planar_pushing as pp
from simulation.runs import check, final, heading, imbalance, run, run_slow_uncompiled
from simulation.straight import Pushed
from simulation.test_finger import (
    ASIDE,
    EFFECTS,
    HEAVY,
    POINTS,
    RIM,
    SHARES,
    TRIPOD,
    every_effect,
    of_each,
    scene,
)

RADIUS, SLIPPING = 0.4, heading(68)
BOX = pp.SupportFriction(support=pp.Polygon.rectangle(2, 2))
METHODS = pytest.mark.parametrize("method", ["event-driven", "time-stepping"])


def pushed(pushed_scene, velocity, duration=0.7, *, radius=RADIUS, samples=5, **options):
    pusher = pp.Pusher(velocity=velocity, shape="finger", radius=radius)
    return run(pushed_scene, pusher, duration, samples=samples, **options)


def box(point=(0.3, -1.0), contact=None, effects=(BOX,)):
    """A square of side 2 about the origin, pushed at its lower side."""
    law = pp.InfiniteFriction() if contact is None else contact
    return pp.scene_at(point, (0, 1), effects=effects, contact=law)


def turned(log):
    """Angle in degrees by which the slider has turned."""
    return log.rod_angle.values - log.rod_angle.values[0]


def test_every_effect_without_the_compiler():
    said = run_slow_uncompiled(__file__)
    assert all(f"[{name}] PASSED" in said for name in EFFECTS if name != "ring")


@pytest.mark.parametrize(
    ("radius", "turn", "along"), [(0, 7.158969350, 0.3), (0.2, 6.942543559, 0.275765951)]
)
def test_the_check_values(radius, turn, along):
    """An outside integration of the square under infinite friction."""
    log = check(pushed(box(), (0.0, 1.0), 0.5, radius=radius))
    assert (log.mode == pp.ContactMode.STICK).all()
    assert turned(log)[-1] == pytest.approx(turn, abs=2e-9)
    assert 0.3 + final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    assert log.attrs.get("pusher_radius", 0) == radius


def straight(effects, sense, velocity=(SLIPPING, (0.0, 0.0))):
    """The independent integration of a slip to the left on the side, or of a contact that sticks."""
    mass = next(((e.mass, e.gyration_radius, e.center) for e in effects if e.degree == 2), None)
    points, shares = (POINTS, SHARES) if effects[0] is TRIPOD else (RIM, [1 / len(RIM)] * len(RIM))
    return Pushed(2.0, 1.2, points, shares, 0.1, sense, velocity, mass, RADIUS)


@pytest.mark.parametrize("name", of_each("ring", "tripod"))
def test_a_contact_that_sticks_is_that_of_scipy(name):
    velocity = heading(100)
    log = check(pushed(scene(EFFECTS[name], pp.PerfectlyRough()), velocity))
    _, state, along = straight(EFFECTS[name], 0, (velocity, (0.0, 0.0))).follow(0.7)
    assert final(log, "position") == pytest.approx(state[:2], abs=1e-9)
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    assert abs(along) > 0.05


@pytest.mark.parametrize("name", of_each("ring", "tripod", "both", "tripod, aside"))
@pytest.mark.parametrize("rate", [(0.0, 0.0), (0.3, 0.5)], ids=["steady", "faster"])
def test_a_slip_along_the_side_is_that_of_scipy(name, rate):
    start, slope = np.array(SLIPPING), np.array(rate)
    log = check(pushed(scene(EFFECTS[name]), lambda t: start + slope * t))
    assert (log.mode == pp.ContactMode.SLIP_LEFT).all()
    reference = straight(EFFECTS[name], -1, (start, slope))
    _, state, along = reference.follow(0.7, log.twist.values[0])
    assert final(log, "position") == pytest.approx(reference.place(state), abs=1e-9)
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    rolled = -RADIUS * np.deg2rad(turned(log))
    assert log.contact_position.values == pytest.approx(rolled - log.slip.values, abs=1e-9)
    assert np.ptp(rolled) > 0.01


@every_effect
@METHODS
def test_a_contact_that_sticks_rolls(effects, method):
    """The contact travels by the radius times the turn, and the finger's center stays a radius away."""
    rough = scene(effects, pp.PerfectlyRough())
    log = check(pushed(rough, heading(80), method=method, object_pose=(0.0, 0.0, 0.0)))
    assert (log.mode == pp.ContactMode.STICK).all()
    assert not log.slip.any()
    assert log.contact_position.values == pytest.approx(-RADIUS * np.deg2rad(turned(log)), abs=1e-9)
    center = log.pusher.values - (0.0, RADIUS)
    away = [
        at(log, row, along) - center[row] for row, along in enumerate(log.contact_position.values)
    ]
    assert np.hypot(*np.transpose(away)) == pytest.approx(RADIUS, abs=1e-9)
    assert np.ptp(turned(log)) > 1


def at(log, row, along):
    """The point of the side at a distance along it from the contact at time 0."""
    angle = np.deg2rad(log.rod_angle.values[row])
    end = log.position.values[row] - 2.0 * np.array([np.cos(angle), np.sin(angle)])
    return end + along * np.array([np.cos(angle - 1.2), np.sin(angle - 1.2)])


SETS = {"box": (BOX,), "mass": (HEAVY,), "box, aside": (BOX, ASIDE)}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name == "box" else pytest.mark.slow) for name in SETS]
)
@pytest.mark.parametrize("gap", [0.0, 0.1523])
@METHODS
def test_without_friction_a_disc_is_a_point_against_the_side_moved_outwards(name, gap, method):
    """The center of the disc is then the point, and the line of force is the same."""
    velocity = [(0, (0.2, 1.0)), (0.5, (-0.4, 0.7))]
    twist = (0.0, 0.0, 0.0) if name == "box" else (0.1, -0.3, 0.5)
    options = {"gap": gap, "twist": twist, "object_pose": (1.0, 2.0, 0.3), "method": method}
    options |= {"step": 0.005} if method == "time-stepping" else {}
    logs = [
        pushed(box((0.3, -1.0 - out), pp.Coulomb(0.0), SETS[name]), velocity, radius=r, **options)
        for r, out in ((RADIUS, 0.0), (0.0, RADIUS))
    ]
    assert max(imbalance(log).max() for log in logs) < 1e-9
    # The contact may slip in another sense, so each has events of its own.
    rows = [np.searchsorted(log.time, np.linspace(0.0, 0.7, 5) - 1e-9) for log in logs]
    logs = [log.isel(time=each) for log, each in zip(logs, rows, strict=True)]
    for each in (
        "object_position",
        "object_angle",
        "pusher_position",
        "contact_position",
        "gap",
        "force",
        "work",
    ):
        assert np.allclose(logs[0][each], logs[1][each], atol=1e-8), each
    assert np.ptp(turned(logs[0])) > 1


@pytest.mark.slow
@METHODS
def test_a_slider_that_slides_freely_meets_the_disc(method):
    """Place of the contact and gap in the flight, and the instant of the impact, by geometry."""
    start, (v_x, v_y, omega) = np.array([0.0, 2.0]), (0.3, -0.6, 0.7)
    slick = scene((HEAVY,), psi=np.pi / 2)
    options = {"gap": 0.5, "twist": (v_x, v_y, omega), "samples": 41, "step": 0.002}
    if method == "event-driven":
        del options["step"]
    log = pushed(slick, (0.0, 0.0), 1.0, method=method, **options)
    finger = np.array([0.0, -0.5 - RADIUS])

    def seen(t):
        turn = omega * t
        tangent = np.array([np.cos(turn), np.sin(turn)])
        normal = np.array([-tangent[1], tangent[0]])
        end = start + t * np.array([v_x, v_y]) - 2.0 * normal
        return tangent @ (finger - end), normal @ (end - finger) - RADIUS

    touches = brentq(lambda t: seen(t)[1], 0.1, 1.0)
    flight = log.isel(time=log.time.values < touches - 0.01)
    assert flight.sizes["time"] > 10
    for row, time in enumerate(flight.time.values):
        along, gap = seen(time)
        assert float(flight.contact_position[row]) == pytest.approx(along, abs=1e-9)
        assert float(flight.gap[row]) == pytest.approx(gap, abs=1e-9)
    struck = log.time.values[np.hypot(*np.diff(log.twist.values[:, :2], axis=0).T).argmax() + 1]
    assert struck == pytest.approx(touches, abs=1e-9 if method == "event-driven" else 0.026)
    assert imbalance(log.isel(time=log.time.values < touches - 0.01)).max() < 1e-12


@METHODS
@pytest.mark.parametrize("radius", [0.3, 50.0])
def test_a_push_through_the_center_does_not_turn_the_slider(method, radius):
    log = check(pushed(box((0.0, -1.0)), (0.0, 1.0), radius=radius, method=method))
    assert np.abs(turned(log)).max() < 1e-9
    assert np.abs(log.contact_position.values).max() < 1e-9
    assert final(log, "position")[1] == pytest.approx(1.7, abs=1e-9)


def test_the_side_lies_down_on_a_huge_disc():
    """The contact rolls to below the center, and then the slider no longer turns."""
    log = check(pushed(box(), (0.0, 1.0), 1.0, radius=1000.0))
    assert final(log, "contact_position") == pytest.approx(-0.3, abs=1e-3)
    assert np.deg2rad(turned(log)[-1]) == pytest.approx(0.3e-3, abs=1e-6)
    assert abs(final(log, "twist")[2]) < 1e-6


def test_a_huge_disc_in_the_limit():
    """What is left of the turn falls like the inverse of the radius."""
    turns = [turned(pushed(box(), (0.0, 1.0), 0.5, radius=r))[-1] for r in (100.0, 200.0, 400.0)]
    assert turns[0] / turns[1] == pytest.approx(2.0, rel=0.02)
    assert turns[1] / turns[2] == pytest.approx(2.0, rel=0.01)


@every_effect
def test_steps_converge_to_the_event_driven_motion(effects):
    """The steps know of velocities alone, so they test the accelerations of the other method."""
    jerky = [(0, (0.1, 1)), (0.3, (0.9, 0.5))]
    for law in (pp.Coulomb(0.3), pp.PerfectlyRough()):
        exact = check(pushed(scene(effects, law), jerky))
        errors = [
            abs(final(pushed(scene(effects, law), jerky, method="time-stepping", step=step), name)
                - final(exact, name))
            for step in (0.02, 0.01, 0.005) for name in ("rod_angle", "contact_position")
        ]  # fmt: skip
        for rough, fine in zip(errors[:2], errors[4:], strict=True):
            assert rough / fine == pytest.approx(4.0, rel=0.35)
        assert errors[4] < 0.4


@every_effect
def test_mirrored_scenes_have_mirrored_motions(effects):
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


def test_the_disc_leaves_the_side_where_the_contact_is_at_its_end():
    log = pushed(scene(EFFECTS["ring"], side=(-1.0, 0.2)), SLIPPING)
    reference = straight(EFFECTS["ring"], -1)
    time, state, _ = reference.follow(0.7, log.twist.values[0], until=0.2)
    (row,) = np.flatnonzero(np.diff(log.parted.values.astype(int))) + 1
    assert float(log.time[row]) == pytest.approx(time, abs=1e-9)
    assert float(log.rod_angle[row]) == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert float(log.contact_position[row]) == pytest.approx(0.2, abs=1e-10)
    assert not log.force.values[row:].any()


def test_the_contact_can_roll_off_the_side():
    """It sticks, and travels by the turn alone."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    rough = pp.scene_at(
        (-0.9, -1), (0, 1), effects=(BOX,), contact=pp.PerfectlyRough(), outline=corners
    )
    log = pushed(rough, (1.5, 0.5), 2.0, radius=0.5)
    assert log.attrs["stopped"] == "the finger comes to the end of the side"
    assert (log.mode == pp.ContactMode.STICK).all()
    assert final(log, "contact_position") == pytest.approx(-0.1, abs=1e-10)
    assert np.deg2rad(turned(log)[-1]) == pytest.approx(0.2, abs=1e-9)


# -- batches, files and refusals ---------------------------------------------------------------------


@pytest.mark.parametrize("name", of_each("ring", "both"))
def test_a_batch_has_the_numbers_of_simulate(name):
    effects, radii = EFFECTS[name], np.array([0.0, 0.1, 0.8])
    finger = pp.Pusher(velocity=SLIPPING, shape="finger", radius=radii)
    batch = pp.simulate_batch(scene(effects), finger, duration=0.5, samples=3)
    assert batch.pusher_radius.values.tolist() == radii.tolist()
    for row, radius in enumerate(radii):
        log = pushed(scene(effects), SLIPPING, 0.5, samples=3, radius=float(radius))
        log = log.sel(time=[0.0, 0.25, 0.5])
        for each in ("rod_angle", "slip", "contact_position", "position", "force", "mode"):
            assert np.array_equal(batch[each][row], log[each]), (radius, each)
    assert len(np.unique(batch.contact_position[:, -1])) == 3


def test_the_radius_is_relative_to_no_unit_of_length():
    """The same scene in another unit of length."""
    one = pushed(scene(EFFECTS["ring"]), SLIPPING)
    slider = pp.Slider(rod_length=50.0, rod_angle=1.2, radius=25.0)
    large = pp.Scene(slider=slider, contact=pp.Coulomb(0.1), effects=EFFECTS["ring"])
    other = pushed(large, [25 * each for each in SLIPPING], radius=25 * RADIUS)
    assert other.rod_angle.values == pytest.approx(one.rod_angle.values, abs=1e-9)
    assert other.contact_position.values == pytest.approx(
        25 * one.contact_position.values, abs=1e-8
    )


def test_a_world_frame_keeps_the_radius_and_holds_the_center():
    pose = (0.1, 0.2, np.pi / 2)
    worlds = [
        pp.Pusher(velocity=velocity, frame="world", shape="finger", radius=0.2)
        for velocity in ((-1.0, 0.0), lambda _: (-1.0, 0.0))
    ]
    own = pp.Pusher(velocity=(0.0, 1.0), shape="finger", radius=0.2)
    logs = [run(box(), each, 0.5, object_pose=pose) for each in (*worlds, own)]
    for log in logs:
        assert final(log, "contact_position") == pytest.approx(0.275765951 - 0.3, abs=1e-9)
        assert log.attrs["pusher_radius"] == 0.2
        assert log.pusher_position.values[0] == pytest.approx([0.1 + 1.2, 0.2 + 0.3])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (-0.1, "-0.1 given; allowed: a finite number >= 0; give the radius of the finger in the scene's "
               "unit of length, or leave it out for a point"),
        (np.inf, "inf given; allowed: a finite number >= 0; give the radius of the finger in the scene's "
                 "unit of length, or leave it out for a point"),
        ("2", "'2' given; allowed: a finite number >= 0; give the radius of the finger in the scene's "
              "unit of length, or leave it out for a point"),
        (np.array([0.1, -0.2]), "-0.2 given; allowed: a finite number >= 0; give the radius of the finger "
                                "in the scene's unit of length, or leave it out for a point"),
    ],
    ids=str,
)  # fmt: skip
def test_a_radius_is_a_length(given, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.Pusher(velocity=(0, 1), shape="finger", radius=given)
    assert str(caught.value) == f"radius: {said}"


def test_a_fence_has_no_radius():
    with pytest.raises(pp.InvalidValue) as caught:
        pp.Pusher(velocity=(0, 1), radius=0.2)
    assert str(caught.value) == (
        "radius: 0.2 given; allowed: 0 for a fence, which is a line; leave the radius out, or set "
        'shape="finger"'
    )
    assert pp.Pusher(velocity=(0, 1), radius=0).radius == 0


def test_a_radius_in_another_unit_is_refused():
    finger = pp.Pusher(velocity=(0, 1), shape="finger", radius=3e4)
    for call in (pp.simulate, pp.simulate_batch):
        with pytest.raises(pp.InvalidValue) as caught:
            call(scene(EFFECTS["ring"]), pusher=finger, duration=1.0)
        assert str(caught.value) == (
            "radius: 30000.0 given; allowed: at most 10000 times the slider's radius; give the radius of "
            "the finger in the unit of the rod length"
        )


def test_radii_of_another_shape_are_refused():
    finger = pp.Pusher(velocity=(0, 1), shape="finger", radius=np.array([0.1, 0.2]))
    slider = pp.Slider(rod_length=2.0, rod_angle=1.2, radius=np.ones(3))
    scenes = pp.Scene(slider=slider, contact=pp.Coulomb(0.1), effects=EFFECTS["ring"])
    with pytest.raises(pp.InvalidValue) as caught:
        pp.simulate_batch(scenes, finger, duration=1.0)
    assert str(caught.value) == (
        "shapes: ((2,), (3,)) given; allowed: () or (scenes,); give one number for each scene"
    )


def test_labeled_radii_are_broadcast_by_name():
    radius = xr.DataArray([0.0, 0.2], dims="disc", coords={"disc": ["point", "disc"]})
    scenes = pp.Scene(
        slider=pp.Slider(rod_length=xr.DataArray([1.0, 2.0, 3.0], dims="rod"), rod_angle=1.2),
        contact=pp.Coulomb(0.1), effects=EFFECTS["ring"],
    )  # fmt: skip
    finger = pp.Pusher(velocity=SLIPPING, shape="finger", radius=radius)
    found = pp.simulate_batch(scenes, finger, duration=0.5)
    assert found.sizes == {"rod": 3, "disc": 2, "xy": 2}
    assert (found.pusher_radius == radius).all()
    one = pushed(scene(EFFECTS["ring"]), SLIPPING, 0.5, radius=0.2)
    here = found.sel(disc="disc").isel(rod=1)
    assert here.contact_position.item() == final(one, "contact_position")


def test_simulate_refuses_an_array_of_radii():
    finger = pp.Pusher(velocity=(0, 1), shape="finger", radius=np.array([0.1, 0.2]))
    with pytest.raises(
        pp.InvalidValue, match=r"radius: 'arrays' given; allowed: one radius; .*_batch"
    ):
        pp.simulate(scene(EFFECTS["ring"]), pusher=finger, duration=1.0)
