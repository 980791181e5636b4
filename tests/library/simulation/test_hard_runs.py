"""Runs that are hard on purpose: limits, coincidences, numbers of every size; with the known defects."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from simulation.runs import check, final
from simulation.scenes import (
    ASIDE,
    BOX,
    FILM,
    HEAVY,
    METHODS,
    PULL,
    RIGHT_ANGLE,
    RING,
    ROUGH,
    SCENES,
    TRIPOD,
    UNEVEN,
    Case,
    Image,
    box,
    feet,
    scene,
)
from simulation.test_invariants import distance

import planar_pushing as pp
from planar_pushing.simulation.early_end import quietly

pytestmark = pytest.mark.filterwarnings("ignore:radius:planar_pushing.SceneWarning")

EVENTS, TIME_STEPS = METHODS
by_both = pytest.mark.parametrize("method", METHODS)
#: No run of the length of these needs more evaluations.
EVALUATIONS = 120_000
ONE = pp.Inertia()
PUSH, AWAY, REST = (0.3, 1.0), (0.0, -5.0), (0.0, 0.0)
#: Effects by name: friction, both, and inertia alone.
EFFECTS = {"ring": (RING,), "both": (RING, HEAVY), "mass": (HEAVY,), "feet": (TRIPOD, ASIDE)}


def known(said):
    """The mark of a known defect; once it is mended, its test fails and the mark has to go."""
    return pytest.mark.xfail(strict=True, reason=f"known defect: {said}")


def marked(cases, defects):
    """Parameters by name, some of which have a known defect."""
    return pytest.mark.parametrize(
        "case",
        [pytest.param(x, id=name, marks=known(defects[name]) if name in defects else ())
         for name, x in cases.items()],
    )  # fmt: skip


def sound(case, near=0.03, **options):
    """The log of a run that both methods take to its end, near to each other, in few evaluations."""
    log, stepped = case.log(**options), case.log(TIME_STEPS)
    for each in (log, stepped):
        assert each.attrs["stopped"] == case.stopped
        check(each, max(1e-9, options.get("rtol", 0.0)))
    assert log.evaluations.max() <= EVALUATIONS
    assert distance(case, stepped, log) <= near * (1 + np.abs(log.position.values).max())
    return log


def of(effects, *more, **given):
    """A case of named effects; what a slider takes is given to it."""
    rod = {name: given.pop(name) for name in ("mu", "length", "psi", "side") if name in given}
    return Case(scene=scene(*EFFECTS.get(effects, effects), *more, **rod), **given)


# --- Coincidences --------------------------------------------------------------------------------


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize(
    ("velocity", "gap"),
    [([(0, (0.0, 0.5)), (0.5, PUSH)], 0.25), ((0.0, 1.0), 0.5), ([(0, REST), (0.5, PUSH)], 0.0)],
    ids=["a breakpoint", "a sample", "a start"],
)
@by_both
def test_a_contact_at_an_instant_that_is_logged_anyway(effects, velocity, gap, method):
    """Nothing moves before it, and everything from then on."""
    case = of(effects, velocity=velocity, gap=gap)
    log = sound(case) if method == EVENTS else case.log(method)
    before = log.time.values < 0.5 - 1e-9
    assert not log.twist.values[before].any()
    assert np.ptp(log.rod_angle.values[log.time.values <= 0.5]) < 1e-12
    assert abs(final(log, "rod_angle") - log.rod_angle.values[0]) > 0.5
    assert (log.time.values == 0.5).any()


@pytest.mark.parametrize("effects", EFFECTS)
@by_both
def test_a_contact_at_the_last_instant(effects, method):
    log = check(of(effects, velocity=(0.0, 1.0), gap=1.0).log(method))
    assert log.attrs["stopped"] == ""
    assert np.ptp(log.rod_angle.values) == 0
    assert final(log, "gap") == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("velocity", [AWAY, [(0, AWAY), (1.0, (0.0, 5.0))]], ids=["end", "break"])
def test_a_slider_stops_at_the_end_or_where_the_pusher_turns(velocity):
    case = of((RING, ONE), velocity=velocity, twist=(0.6, 0.8, 0.0))
    log = sound(case)
    assert final(log, "kinetic_energy") < 1e-12
    assert final(log, "position") - log.position.values[0] == pytest.approx([0.3, 0.4], abs=1e-9)


COINCIDENCES = {
    "two feet that stop at once": of(
        (feet((0.0, 1.0), (0.0, -1.0)), ONE), velocity=AWAY, twist=(0.0, 0.5, 0.0), psi=RIGHT_ANGLE
    ),
    "pivot at the start": of((TRIPOD, ONE), velocity=AWAY, psi=RIGHT_ANGLE, twist=(1.0, 0.0, 1.0)),
    "pivot of two feet at the start": of(
        (feet((1.0, 0.0), (-1.0, 0.0)), ONE), velocity=AWAY, psi=RIGHT_ANGLE, twist=(1.0, 0.0, 1.0)
    ),
    "contact that sticks at a foot": of((feet((-2.0, 0.0), (0.5, 0.5), (0.5, -0.5)),), mu=ROUGH),
    "contact of a mass that sticks at a foot": of(
        (feet((-2.0, 0.0), (0.5, 0.5), (0.5, -0.5)), ONE), mu=ROUGH, velocity=PUSH
    ),
    "slider as fast as the fence": of("mass", velocity=PUSH, twist=(0.3, 1.0, 0.0)),
    "slider as fast as the fence, upright": of(
        "both", velocity=(0.0, 1.0), twist=(0.0, 1.0, 0.0), psi=RIGHT_ANGLE
    ),
    "fence that grazes a mass": of("mass", velocity=lambda t: (0.0, 1 - 2 * t), gap=0.25),
    "fence that grazes": of("ring", velocity=lambda t: (0.0, 1 - 2 * t), gap=0.25),
    "fence that turns back exactly": of(
        "both", velocity=[(0, PUSH), (0.5, (-0.3, -1.0)), (0.75, PUSH)]
    ),
    "stops where the fence is": of((RING, ONE), velocity=REST, twist=(0.6, -0.8, 0.0), gap=0.4),
    "lands flush": Case(
        scene=box((0.0, -1.0), BOX, HEAVY, outlined=True), velocity=REST, gap=0.3,
        twist=(0.0, -1.0, 0.0),
    ),
}  # fmt: skip


@marked(COINCIDENCES, {})
def test_coincidences(case):
    sound(case)


# --- Pieces --------------------------------------------------------------------------------------


@pytest.mark.parametrize("effects", EFFECTS)
@by_both
def test_pieces_that_change_nothing(effects, method):
    """They begin at the end or later, or have the velocity of the piece before."""
    plain = of(effects, velocity=[(0, PUSH)]).log(method)
    for time in (1.0, 2.0, 1e300):
        other = of(effects, velocity=[(0, PUSH), (time, (-0.3, 1.0))]).log(method)
        xr.testing.assert_equal(other, plain)
    other = of(effects, velocity=[(0, PUSH), (0.5, PUSH)]).log(method, samples=3)
    for name in ("rod_angle", "position", "slip"):
        assert final(other, name) == pytest.approx(final(plain, name), abs=1e-8)


@pytest.mark.parametrize("effects", EFFECTS)
@by_both
@pytest.mark.parametrize(
    "pieces",
    [
        [(0, PUSH), (0.5, (-0.3, 1.0)), (math.nextafter(0.5, 1), PUSH)],
        [(0, PUSH), (math.nextafter(1.0, 0), (-0.3, 1.0))],
        [(0, REST), (1e-300, PUSH)],
        [(0, REST), (5e-324, PUSH)],
    ],
    ids=["in the middle", "at the end", "at the start", "of the least length"],
)
def test_pieces_of_next_to_no_length(effects, method, pieces):
    log, plain = (of(effects, velocity=v).log(method) for v in (pieces, [(0, PUSH)]))
    assert log.attrs["stopped"] == ""
    assert final(log, "time") == 1
    if effects == "ring" or pieces[0][1] == REST:
        assert final(log, "rod_angle") == pytest.approx(final(plain, "rod_angle"), abs=1e-7)
        assert final(log, "position") == pytest.approx(final(plain, "position"), abs=1e-8)


@pytest.mark.parametrize("effects", EFFECTS)
def test_hundreds_of_pieces(effects):
    """A fence that shakes along itself."""
    pieces = [(i / 200, (0.5 * (-1) ** i, 1.0)) for i in range(200)]
    sound(of(effects, velocity=pieces))


# --- Starts from rest ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("power", "rtol"), [(1, 1e-10), (2, 1e-10), (2, 1e-6), (3, 1e-10), (3, 1e-6)]
)
@pytest.mark.parametrize("effects", EFFECTS)
def test_a_pusher_starts_like_a_power_of_the_time(effects, power, rtol):
    """Normal and tangential velocity are zero at first, and at the same rate."""
    sound(of(effects, velocity=lambda t: (0.1 * t**power, t**power)), rtol=rtol)


@pytest.mark.parametrize("effects", EFFECTS)
def test_starts_in_all_directions_last(effects):
    """Also those in which the contact is about to slip, and whose first motion is lost in rounding."""
    for aside, power in itertools.product(
        [*np.linspace(-0.7, 0.7, 8), 0.42, 0.48, 0.51], (2, 3, 4, 5)
    ):
        case = of(effects, velocity=lambda t, a=aside, p=power: (a * t**p, t**p))
        assert case.log(rtol=1e-6).attrs["stopped"] == "", (aside, power)


def test_a_pusher_starts_slower_than_any_power():
    log = check(of("mass", velocity=lambda t: (0.0, math.exp(-1 / t) if t > 0 else 0.0)).log())
    assert log.attrs["stopped"] == ""
    assert final(log, "pusher")[1] == pytest.approx(0.14849550677592, abs=1e-10)
    assert log.evaluations.max() <= EVALUATIONS


OFFSETS = [
    sign * size for size in (0.0, 2e-15, 6e-15, 1e-14, 1e-13, 1e-12, 1e-9) for sign in (1, -1)
]


@pytest.mark.parametrize(
    "offset",
    [*OFFSETS, pytest.param(-1e-11, marks=known("a force of 1e11 units makes steps too short"))],
)
def test_an_edge_whose_force_has_no_normal_acceleration(offset):
    """Friction beyond it stops a slip at once, by an impulse; a little less, by an unbounded force."""
    case = of("mass", mu=2.0 * (1.0 + offset), length=math.sqrt(2.0), psi=math.pi / 4,
              velocity=lambda t: (1.0, t))  # fmt: skip
    case = replace(case, scene=replace(case.scene, effects=(pp.Inertia(gyration_radius=1.0),)))
    log = case.log()
    assert log.attrs["stopped"] == ""
    stuck = of("mass", mu=3.0, length=math.sqrt(2.0), psi=math.pi / 4, velocity=lambda t: (1.0, t))
    stuck = replace(stuck, scene=replace(stuck.scene, effects=case.scene.effects))
    assert log.twist.values[-1] == pytest.approx(stuck.log().twist.values[-1], abs=1e-6)


# --- Loads ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("force", [1.0, math.nextafter(1.0, 0), 0.5])
@by_both
def test_friction_holds_a_load_up_to_its_limit(force, method):
    log = check(of((RING, ONE, pp.Load(force=(force, 0.0))), velocity=AWAY).log(method))
    assert not log.twist.values.any()


@pytest.mark.parametrize("rest", [1e-3, 1e-4, 1e-5, 1e-6])
@by_both
def test_friction_does_not_hold_a_load_just_beyond_its_limit(method, rest):
    """The rest of the load accelerates the slider evenly."""
    case = of((RING, ONE, pp.Load(force=(1 + rest, 0.0))), velocity=AWAY)
    log = check(case.log(method, samples=17))
    wanted = rest * np.multiply.outer(log.time.values, [1, 0, 0])
    assert log.twist.values == pytest.approx(wanted, abs=1e-7)


@pytest.mark.parametrize("force", [0.999999, 1 - 1e-12])
def test_a_load_that_next_to_nothing_holds_without_inertia(force):
    log = sound(of((RING, pp.Load(force=(0.0, force))), velocity=(0.0, 1.0)))
    assert final(log, "position") - log.position.values[0] == pytest.approx([0, 1], abs=1e-5)
    with pytest.raises(pp.InvalidValue, match="1 times what friction can hold"):
        of((RING, pp.Load(force=(0.0, 1.0)))).log()


PRESSED = {
    "fence at rest": REST,
    "fence along itself": (1.0, 0.0),
    "fence along itself, later": [(0, REST), (0.5, (1.0, 0.0))],
    "fence that starts along itself": lambda t: (t, 0.0),
    "fence up and along": (1.0, 0.001),
}


@pytest.mark.parametrize("psi", [1.2, RIGHT_ANGLE], ids=["aside", "above"])
@pytest.mark.parametrize("load", [0.5, 1.5], ids=["held", "not held"])
@pytest.mark.parametrize("name", PRESSED)
def test_a_load_presses_the_slider_against_the_fence(name, load, psi):
    """The fence holds what friction does not, slips below a slider at rest, or takes it along."""
    log = sound(of((RING, ONE, pp.Load(force=(0.0, -load))), velocity=PRESSED[name], psi=psi))
    slips = np.abs(np.diff(log.slip.values)) > 1e-9
    assert not (slips & (log["mode"].values[1:] == pp.ContactMode.STICK)).any()


@pytest.mark.parametrize("force", [1.001, 1.5])
def test_a_load_at_a_foot_pulls_away(force):
    """Equal feet, each the center of percussion of the other."""
    support = feet((0.0, 1.0), (0.0, -1.0))
    sound(of((support, ONE, pp.Load(force=(0.0, force), center=(0.0, 1.0))), velocity=AWAY), 0.1)


# --- Stops ---------------------------------------------------------------------------------------

HEAVY_FOOT = feet((1.0, 0.0), (-1.0, 0.0), loads=(0.9, 0.1))


def test_a_velocity_falls_linearly_to_its_stop():
    """Under constant friction, and about a heavy foot, where the light one slows the rotation."""
    for friction, twist in (
        (RING, (1.0, 0.0, 0.0)), (RING, (0.0, 1.0, 0.0)), (RING, (0.0, 0.0, 1.0)),
        (HEAVY_FOOT, (0.1, 0.0, 0.1)), (BOX, (0.6, 0.8, 0.0)),
    ):  # fmt: skip
        for velocity, gap in (((0.0, -1.0), 0.0), (AWAY, 0.0), (REST, 5.0), (AWAY, 0.5 + 1e-9)):
            case = of((friction, ONE), velocity=velocity, gap=gap, twist=twist, psi=RIGHT_ANGLE)
            for samples in (9, 17, 33):
                log = check(case.log(samples=samples), 1e-9)
                left, (v_x, v_y, omega) = np.maximum(1 - log.time.values, 0), twist
                speed = np.hypot(*log.twist.values[:, :2].T)  # the pivot turns the velocity
                assert speed == pytest.approx(math.hypot(v_x, v_y) * left, abs=1e-8)
                assert log.twist.values[:, 2] == pytest.approx(omega * left, abs=1e-8)
                assert pp.Event.SLIDER_STOPS in log.event.values


@pytest.mark.parametrize("rtol", [1e-13, 1e-7, 1e-5, 1e-3])
def test_a_stop_is_found_at_every_tolerance(rtol):
    case = SCENES["translation stops"]
    log = case.log(rtol=rtol)
    assert log.evaluations.max() <= EVALUATIONS
    assert pp.Event.SLIDER_STOPS in log.event.values
    assert final(log, "kinetic_energy") == 0


# --- Sizes ---------------------------------------------------------------------------------------

FAR = {
    f"{name}, rod of {length:g} at {psi:.1f}": of(name, length=length, psi=psi, velocity=PUSH)
    for name in EFFECTS for length in (1e3, 1e6) for psi in (1.2, RIGHT_ANGLE)
}  # fmt: skip
SIZES = FAR | {
    "finger at a rod of 1e6": of("ring", length=1e6, mu=0.1, velocity=PUSH, shape="finger", radius=0.3),
    "rod that nearly lies down, finger": of("both", psi=1e-9, velocity=PUSH, shape="finger", radius=0.2),
    "gap that is nothing": of("both", gap=5e-324, velocity=PUSH),
    "gap of rounding": of("both", gap=1e-17, velocity=PUSH),
    "gap of 1e150": of("ring", gap=1e150, velocity=PUSH),
    "gap of 1e160": of("ring", gap=1e160, velocity=PUSH),
    "heavy": of((RING, pp.Inertia(mass=1e12)), velocity=PUSH),
    "light": of((RING, pp.Inertia(mass=1e-4)), velocity=PUSH),
    "very light": of((RING, pp.Inertia(mass=1e-6)), velocity=PUSH),
    "all mass far out": of((RING, pp.Inertia(gyration_radius=1e4)), velocity=PUSH),
    "all mass at the center": of((pp.Inertia(gyration_radius=1e-4),), velocity=PUSH),
    "slick": of("both", mu=1e-300, velocity=PUSH),
    "sticky": of("both", mu=1e9, velocity=PUSH),
    "thin film": of((pp.Viscous(support=pp.Ring(1.0), coefficient=1e-9), ONE), velocity=PUSH),
    "thick film": of((RING, pp.Viscous(support=pp.Ring(1.0), coefficient=1e6)), velocity=PUSH),
    "stiff film": of((pp.Viscous(support=pp.Ring(1.0), coefficient=1e3), ONE), velocity=PUSH),
    "disc that is a point": of("ring", mu=0.1, velocity=PUSH, shape="finger", radius=1e-300),
}  # fmt: skip


@marked(SIZES, {
    "gap of 1e160": "squares of lengths in steps",
})  # fmt: skip
def test_numbers_of_every_size(case):
    sound(case)


def test_the_side_lies_down_on_the_widest_disc():
    log = check(Case(scene=box(), shape="finger", radius=1e4).log())
    assert log.evaluations.max() <= EVALUATIONS
    assert final(log, "contact_position") == pytest.approx(-0.3, abs=1e-4)


@pytest.mark.parametrize("end", [1e-6, 1e-9, 1e-12, 0.0])
def test_a_finger_leaves_a_side_that_ends_at_once(end):
    case = of("ring", mu=0.1, velocity=(0.4, 1.0), shape="finger", side=(-1.0, end))
    log = case.log()
    assert final(log, "parted")
    assert final(log, "slip") == pytest.approx(-end, abs=1e-10)


UNITS = [Image(length=1e-120), Image(length=1e120), Image(force=1e-120), Image(force=1e120),
         Image(time=1e-120), Image(time=1e120), Image(length=1e-100, time=1e30, force=1e60)]  # fmt: skip
UNIT_SCENES = ("sticks, then slips", "feet with a pivot", "viscous and dry", "load that friction holds",
               "impact with friction", "start from rest", "everything", "everything under a disc",
               "corner comes down", "disc in a notch")  # fmt: skip


@by_both
@pytest.mark.parametrize("name", UNIT_SCENES)
@pytest.mark.parametrize("image", UNITS, ids=lambda x: f"{x.length:g}, {x.force:g}, {x.time:g}")
def test_units_of_every_size(name, image, method, request):
    if name == "start from rest" and image.time in (1e-120, 1e120) and method == EVENTS:
        request.applymarker(known("squares of accelerations"))
    log, other = SCENES[name].log(method), image.of(SCENES[name]).log(method)
    assert other.attrs["stopped"] == log.attrs["stopped"]
    np.testing.assert_array_equal(other["mode"], log["mode"])
    wanted = image.log(log)
    for each in ("time", "rod_angle", "position", "slip", "force", "work", "kinetic_energy"):
        size = np.abs(wanted[each]).max()
        assert np.abs(other[each].values - wanted[each]).max() <= 1e-7 * size, each


# --- Types ---------------------------------------------------------------------------------------


def of_type(number, method=None):
    """A log, or without a method a batch, of a scene whose numbers are all of a type."""
    n = number
    slider = pp.Slider(rod_length=n(2), rod_angle=n(1.25), radius=n(1), side=(n(-2), n(1)))
    support = pp.Points([(n(1), n(0)), (n(-0.5), n(0.75)), (n(-0.5), n(-1))], [n(1), n(2), n(1)])
    effects = (
        pp.RingFriction(weight=n(0.5)), pp.SupportFriction(support=support, weight=n(0.5)),
        pp.Inertia(mass=n(0.75), gyration_radius=n(0.5), center=(n(0.25), n(0.125))),
        pp.Viscous(support=pp.Disc(n(0.5), (n(0.25), n(0))), coefficient=n(0.5)),
        pp.Load(force=(n(0.25), n(-0.125)), center=(n(0.5), n(0.25))),
    )  # fmt: skip
    given = {
        "pusher": pp.Pusher(
            velocity=[(n(0), (n(0.25), n(1))), (n(0.5), (n(0.5), n(0.5)))], shape="finger", radius=n(0.25)
        ),
        "duration": n(1), "gap": n(0.125), "twist": (n(0.125), n(-0.25), n(0.5)), "samples": 5,
    }  # fmt: skip
    whole = pp.Scene(slider=slider, contact=pp.Coulomb(n(0.25)), effects=effects)
    if method is None:
        return quietly(pp.simulate_batch)(whole, **given)
    step = {"step": n(0.0625)} if method == TIME_STEPS else {}
    more = {
        "object_pose": (n(1), n(2), n(0.5)),
        "until": pp.Until(rotation=n(3)),
        "rtol": np.float64(1e-9),
    }
    return quietly(pp.simulate)(whole, method=method, **given, **more, **step)


@pytest.mark.parametrize("method", [*METHODS, None], ids=str)
@pytest.mark.parametrize(
    "number",
    [
        np.float64,
        np.float32,
        np.float16,
        np.longdouble,
        np.asarray,
        lambda x: np.array(x, np.float32),
    ],
    ids=["float64", "float32", "float16", "longdouble", "0-d", "0-d float32"],
)
def test_numbers_of_every_type(number, method):
    """They are short binary fractions, which every type has."""
    found, plain = of_type(number, method), of_type(float, method)
    xr.testing.assert_equal(found, plain)
    assert found.attrs.get("scene") == plain.attrs.get("scene")


@by_both
def test_zeros_of_either_sign(method):
    plain = of("both", velocity=(0.0, 1.0), gap=0.0).log(method)
    other = of("both", velocity=(-0.0, 1.0), gap=-0.0, twist=(-0.0, -0.0, -0.0)).log(method)
    xr.testing.assert_equal(other, plain)


def test_a_batch_of_one_labeled_number():
    found = quietly(pp.simulate_batch)(
        scene(RING, length=xr.DataArray(2.0)), pp.Pusher(velocity=PUSH), duration=0.1
    )
    assert found.rod_angle.dims == ()


def test_effects_are_listed_in_any_order():
    """The log has the order of the list, and the motion none."""
    effects = (UNEVEN, FILM, ASIDE, PULL, RING)
    case = SCENES["everything"]
    log, other = (
        replace(case, scene=replace(case.scene, effects=each)).log()
        for each in (effects, effects[::-1])
    )
    assert final(log, "rod_angle") == pytest.approx(final(other, "rod_angle"), abs=1e-8)
    assert log.dissipated.values[-1] == pytest.approx(other.dissipated.values[-1, ::-1], abs=1e-9)
