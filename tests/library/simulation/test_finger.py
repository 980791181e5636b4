"""A finger, a point or a disc, against a flat side: against `solve`, a fence, scipy and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from simulation.runs import check, final, heading, imbalance, run
from simulation.scenes import METHODS, SQUARE
from simulation.straight import Pushed

import planar_pushing as pp

#: The scenes are plain or random numbers, not real objects.
pytestmark = pytest.mark.filterwarnings("ignore:(outline|radius):planar_pushing.SceneWarning")

by_both = pytest.mark.parametrize("method", METHODS)
POINTS, SHARES = [(1, 0), (-0.5, np.sqrt(0.75)), (-0.4, -np.sqrt(0.75))], [0.2, 0.5, 0.3]
TRIPOD = pp.SupportFriction(support=pp.Points(POINTS, SHARES))
#: The ring as points: the sum converges faster than any power while the motion center is off the ring.
RIM = [(np.cos(angle), np.sin(angle)) for angle in 2 * np.pi * np.arange(400) / 400]
HEAVY, ASIDE = (pp.Inertia(mass=0.7, gyration_radius=0.9, center=c) for c in ((0, 0), (0.2, 0.1)))
BOX = pp.SupportFriction(support=pp.Polygon.rectangle(2, 2))
FRICTION = {"ring": (pp.RingFriction(),), "tripod": (TRIPOD,)}
EFFECTS = FRICTION | {
    "inertia": (HEAVY,), "both": (pp.RingFriction(), HEAVY), "tripod, aside": (TRIPOD, ASIDE),
}  # fmt: skip
every_effect = pytest.mark.parametrize("effects", EFFECTS.values(), ids=EFFECTS)
either = pytest.mark.parametrize("radius", [0.0, 0.4], ids=["point", "disc"])
SLIPPING, SLICK = heading(68), pp.Coulomb(0.1)


def scene(effects, contact=SLICK, side=(-np.inf, np.inf), psi=1.2):
    slider = pp.Slider(rod_length=2.0, rod_angle=psi, radius=1.0, side=side)
    return pp.Scene(slider=slider, contact=contact, effects=effects)


def box(point=(0.3, -1.0), contact=None, effects=(BOX,), outline=None):
    """A square of side 2 about the origin, pushed at its lower side."""
    law = pp.InfiniteFriction() if contact is None else contact
    return pp.scene_at(point, (0, 1), effects=effects, contact=law, outline=outline)


def pushed(
    pushed_scene, velocity, duration=0.7, *, shape="finger", radius=0.0, samples=5, **options
):
    pusher = pp.Pusher(velocity=velocity, shape=shape, radius=radius)
    return run(pushed_scene, pusher, duration, samples=samples, **options)


def turned(log):
    """Angle in degrees by which the slider has turned."""
    return log.rod_angle.values - log.rod_angle.values[0]


# --- The first instant, and a contact that sticks ------------------------------------------------


@every_effect
@pytest.mark.parametrize("jerk", [True, False], ids=["jerk", "from rest"])
def test_the_first_instant_is_that_of_a_fence(effects, jerk):
    """The side turns after an impact: then the impulse is that of a fence, but not the force."""
    velocity = SLIPPING if jerk else lambda t: (0.4 * t, t)
    finger, fence = (pushed(scene(effects), velocity, 1e-3, shape=s) for s in ("finger", "fence"))
    for name in ("position", "twist", "kinetic_energy", *(() if jerk else ("force", "mode"))):
        assert finger[name].values[0] == pytest.approx(fence[name].values[0], abs=1e-12), name


@every_effect
def test_a_point_that_sticks_is_a_pin_as_is_a_fence(effects):
    rough = scene(effects, pp.PerfectlyRough())
    finger, fence = (pushed(rough, SLIPPING, shape=s) for s in ("finger", "fence"))
    for name in ("position", "rod_angle", "twist", "force", "work"):
        assert np.allclose(finger[name], fence[name], atol=1e-9), name
    assert not finger.slip.any()
    assert not finger.contact_position.any()


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


# --- Against an integration of Newton's law by scipy ---------------------------------------------


def straight(effects, sense, velocity, radius):
    """The independent integration of a slip to the left on the side, or of a contact that sticks."""
    mass = next(((e.mass, e.gyration_radius, e.center) for e in effects if e.degree == 2), None)
    points, shares = (POINTS, SHARES) if effects[0] is TRIPOD else (RIM, [1 / len(RIM)] * len(RIM))
    return Pushed(2.0, 1.2, points, shares, 0.1, sense, velocity, mass, radius)


@pytest.mark.parametrize("name", FRICTION)
def test_a_disc_that_sticks_is_that_of_scipy(name):
    velocity = heading(100)
    log = check(pushed(scene(EFFECTS[name], pp.PerfectlyRough()), velocity, radius=0.4))
    _, state, along = straight(EFFECTS[name], 0, (velocity, (0.0, 0.0)), 0.4).follow(0.7)
    assert final(log, "position") == pytest.approx(state[:2], abs=1e-9)
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    assert abs(along) > 0.05


followed = pytest.mark.parametrize("name", ["ring", "tripod", "both", "tripod, aside"])


@either
@followed
@pytest.mark.parametrize("rate", [(0.0, 0.0), (0.3, 0.5)], ids=["steady", "faster"])
def test_a_slip_along_the_side_is_that_of_scipy(name, rate, radius):
    start, slope = np.array(SLIPPING), np.array(rate)
    log = check(pushed(scene(EFFECTS[name]), lambda t: start + slope * t, radius=radius))
    assert (log.mode == pp.ContactMode.SLIP_LEFT).all()
    reference = straight(EFFECTS[name], -1, (start, slope), radius)
    _, state, along = reference.follow(0.7, log.twist.values[0])
    assert final(log, "position") == pytest.approx(reference.place(state), abs=1e-9)
    assert final(log, "rod_angle") == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert final(log, "contact_position") == pytest.approx(along, abs=1e-9)
    assert along > 0.3


@either
@followed
def test_the_finger_leaves_the_side_where_the_contact_is_at_its_end(name, radius):
    log = pushed(scene(EFFECTS[name], side=(-1.0, 0.2)), SLIPPING, radius=radius)
    reference = straight(EFFECTS[name], -1, (SLIPPING, (0.0, 0.0)), radius)
    time, state, _ = reference.follow(0.7, log.twist.values[0], until=0.2)
    (row,) = np.flatnonzero(np.diff(log.parted.values.astype(int))) + 1
    assert float(log.time[row]) == pytest.approx(time, abs=1e-9)
    assert float(log.rod_angle[row]) == pytest.approx(np.rad2deg(state[2]), abs=1e-8)
    assert float(log.contact_position[row]) == pytest.approx(0.2, abs=1e-10)
    assert (log.mode[row:] == pp.ContactMode.SEPARATE).all()
    assert not log.force.values[row:].any()
    assert log.attrs["stopped"] == ""
    assert final(log, "time") == 0.7


@either
@by_both
def test_a_slider_rests_or_flies_on_where_the_finger_leaves_it(radius, method):
    for effects, moves in (((pp.RingFriction(),), False), ((HEAVY,), True)):
        log = pushed(scene(effects, side=(-1.0, 0.2)), SLIPPING, radius=radius, method=method)
        after = log.isel(time=log.parted.values)
        assert after.sizes["time"] > 2
        assert after.twist.values == pytest.approx(
            np.tile(after.twist.values[0], (len(after.time), 1))
        )
        assert after.twist.values.any() == moves


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


def test_a_fence_takes_no_notice_of_the_side_and_the_log_of_a_finger_has_it():
    short = scene((pp.RingFriction(),), side=(-1.0, 0.2))
    log, wide = (pushed(x, SLIPPING, shape="fence") for x in (short, scene((pp.RingFriction(),))))
    assert log.drop_attrs().equals(wide.drop_attrs())
    assert "contact_position" not in log
    assert "pusher_shape" not in log.attrs
    log = pushed(short, SLIPPING)
    assert log.attrs["pusher_shape"] == "finger"
    assert '"side": [-1.0, 0.2]' in log.attrs["scene"]
    assert log.parted.dtype == bool
    assert "finger" in log.contact_position.attrs["long_name"]


# --- A disc, by geometry and limits --------------------------------------------------------------


@pytest.mark.parametrize("effects", [(BOX,), (HEAVY,), (BOX, ASIDE)], ids=["box", "mass", "both"])
@pytest.mark.parametrize("gap", [0.0, 0.1523])
@by_both
def test_without_friction_a_disc_is_a_point_against_the_side_moved_outwards(effects, gap, method):
    """The center of the disc is then the point, and the line of force is the same."""
    velocity = [(0, (0.2, 1.0)), (0.5, (-0.4, 0.7))]
    twist = (0.1, -0.3, 0.5) if len(effects) > 1 or effects[0] is HEAVY else (0.0, 0.0, 0.0)
    options = {"gap": gap, "twist": twist, "object_pose": (1.0, 2.0, 0.3), "method": method}
    options |= {"step": 0.005} if method == "time-stepping" else {}
    logs = [
        pushed(box((0.3, -1.0 - out), pp.Coulomb(0.0), effects), velocity, radius=r, **options)
        for r, out in ((0.4, 0.0), (0.0, 0.4))
    ]
    assert max(imbalance(log).max() for log in logs) < 1e-9
    # The contact may slip in another sense, so each has events of its own.
    rows = [np.searchsorted(log.time, np.linspace(0.0, 0.7, 5) - 1e-9) for log in logs]
    one, other = (log.isel(time=each) for log, each in zip(logs, rows, strict=True))
    for each in ("object_position", "object_angle", "pusher_position", "contact_position", "gap",
                 "force", "work"):  # fmt: skip
        assert np.allclose(one[each], other[each], atol=1e-8), each
    assert np.ptp(turned(one)) > 1


@by_both
def test_a_slider_that_slides_freely_meets_the_disc(method):
    """Place of the contact and gap in the flight, and the instant of the impact, by geometry."""
    v_x, v_y, omega = twist = (0.3, -0.6, 0.7)
    options = {"gap": 0.5, "twist": twist, "samples": 41, "radius": 0.4, "method": method}
    step = {"step": 0.002} if method == "time-stepping" else {}
    log = pushed(scene((HEAVY,), psi=np.pi / 2), (0.0, 0.0), 1.0, **options, **step)
    finger = np.array([0.0, -0.9])

    def seen(t):
        tangent = np.array([np.cos(omega * t), np.sin(omega * t)])
        normal = np.array([-tangent[1], tangent[0]])
        end = np.array([0.0, 2.0]) + t * np.array([v_x, v_y]) - 2.0 * normal
        return tangent @ (finger - end), normal @ (end - finger) - 0.4

    touches = brentq(lambda t: seen(t)[1], 0.1, 1.0)
    flight = log.isel(time=log.time.values < touches - 0.01)
    assert flight.sizes["time"] > 10
    for row, time in enumerate(flight.time.values):
        along, gap = seen(time)
        assert float(flight.contact_position[row]) == pytest.approx(along, abs=1e-9)
        assert float(flight.gap[row]) == pytest.approx(gap, abs=1e-9)
    struck = log.time.values[np.hypot(*np.diff(log.twist.values[:, :2], axis=0).T).argmax() + 1]
    assert struck == pytest.approx(touches, abs=1e-9 if method == "event-driven" else 0.026)
    assert imbalance(flight).max() < 1e-12


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


def test_the_contact_can_roll_off_the_side():
    """It sticks, travels by the turn alone, and goes on round the corner."""
    rough = box((-0.9, -1), pp.PerfectlyRough(), outline=SQUARE)
    log = pushed(rough, (1.5, 0.5), 2.0, radius=0.5)
    assert log.attrs["stopped"] == ""
    assert (log.mode == pp.ContactMode.STICK).all()
    end = int(np.flatnonzero(log.event.values == pp.Event.END_OF_SIDE)[0])
    assert log.contact_position.values[end] == pytest.approx(-0.1, abs=1e-10)
    assert np.deg2rad(turned(log)[end]) == pytest.approx(0.2, abs=1e-9)
    assert np.deg2rad(turned(log)[-1]) > 0.5


def test_a_world_frame_keeps_the_radius_and_holds_the_center():
    pose = (0.1, 0.2, np.pi / 2)
    worlds = [
        pp.Pusher(velocity=velocity, frame="world", shape="finger", radius=0.2)
        for velocity in ((-1.0, 0.0), lambda _: (-1.0, 0.0))
    ]
    own = pp.Pusher(velocity=(0.0, 1.0), shape="finger", radius=0.2)
    for log in (run(box(), each, 0.5, object_pose=pose) for each in (*worlds, own)):
        assert final(log, "contact_position") == pytest.approx(0.275765951 - 0.3, abs=1e-9)
        assert log.attrs["pusher_radius"] == 0.2
        assert log.pusher_position.values[0] == pytest.approx([0.1 + 1.2, 0.2 + 0.3])
