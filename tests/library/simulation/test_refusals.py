"""Values that a simulation cannot have are refused in one line that says what to do, before any work."""

from __future__ import annotations

import itertools
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import FRICTION, INERTIA, make_scene
from simulation.scenes import SQUARE, box, turned

import planar_pushing as pp

SCENE, AHEAD = make_scene(2.0, 0.5), pp.Pusher(velocity=(0.0, 1.0))
ONES, HUGE = np.ones(2), 10**400
TRUE, MASKED = np.True_, np.ma.masked


def refused(call, name, *words):
    """The error of a call is about an argument, has some words, and is one line."""
    with pytest.raises(pp.InvalidValue) as caught:
        call()
    message = str(caught.value)
    assert caught.value.name == name, message
    assert all(word in message for word in words), message
    assert "\n" not in message


def wrong(*words, about=None, **given):
    """An argument that is refused, the first that is given by default, and words of the message."""
    return about or next(iter(given)), words, given


def table(rows):
    return pytest.mark.parametrize(("name", "words", "given"), rows)


# --- Pushers -------------------------------------------------------------------------------------

SPEEDS = "allowed: a speed of 0, or a number in [1e-140, 1e140]"
STARTS = "start times that begin at 0 and increase"
TIMES = "times that begin at 0 and increase"
PLACES = "allowed: at least two (time, (x, y)) of finite numbers"
PATH = [(0, (2, 1)), (0.4, (2.1, 1.4))]
NO_VELOCITY = [
    3, None, "ab", (1,), (1, 2, 3), (1, np.nan), (HUGE, 1), ("0", "1"), (b"0", 1.0), (TRUE, 1.0),
    (Decimal(1), 0.0), (0.0, Decimal(1)), ([0.0], [1.0]), itertools.count(), iter((0.0, 1.0)),
    {0.0, 1.0, 2.0}, {0.0: 1, 1.0: 0}, MASKED, (MASKED, 1.0), np.array(1.0), (ONES, None),
    (ONES, Decimal(1)), (ONES, np.ones(3)), (np.array(["a"]), 0), (np.array([1, 0]), 0, 0),
    (np.ma.masked_array([1.0, 2.0], [0, 1]), 0.0), (np.array([True, False]), 0.0),
    (np.array([1.0, np.inf]), 0),
]  # fmt: skip
NO_SPEED = [
    (1e308, 1e308), (0.0, 1.1e140), (0.9e-140, 0.0), (5e-324, 0.0), (np.array([0.0, 1e-200]), 0.0),
    (np.array([1e308, 0.0]), 1e308), [(0, (0, 1)), (1, (0, 1e200))],
    [(0, (ONES, 1)), (1, (0, 1e200))],
]  # fmt: skip
NO_PIECES = [
    ([], "velocity: [] given"), ([(0, 1)], "velocity: "), ([(0, (0, HUGE))], "velocity: "),
    ([(0, (0, "1"))], "velocity: "), ([(0, (0, np.inf))], "velocity: "), ([(1, (0, 1))], STARTS),
    ([(0, (0, 1)), (0, (0, 2))], STARTS), ([(0, (0, 1)), (0, (ONES, 1))], STARTS),
    ([(0, (ONES, 1)), (1, 3)], "velocity: 3 given; allowed: (v_x, v_y), a sequence"),
    ([(0, (ONES, 1)), (1, (0, np.nan))], "velocity: nan given; allowed: finite numbers"),
    ([(0, (ONES, np.ones(3)))], "allowed: two arrays of one shape"),
    ([(0, (ONES, 1)), (1, (0, 1), 2)], "a sequence"),
]  # fmt: skip
PUSHERS = [
    *(wrong("allowed: ", velocity=each) for each in NO_VELOCITY),
    *(wrong(SPEEDS, velocity=each) for each in NO_SPEED),
    *(wrong(words, velocity=each) for each, words in NO_PIECES),
    *(
        wrong("allowed: increasing times >= 0", breakpoints=each, velocity=lambda _: (0, 1))
        for each in (5, "12", (1.0, 1.0), (2, 1), (-1.0,), (np.nan,), (HUGE,), (True,))
    ),
    wrong(TIMES, waypoints=[(0, (0, 0)), (1, (0, 1)), (0.5, (1, 1))]),
    wrong(TIMES, waypoints=[(0, (0, 0)), (0, (0, 1))]),
    wrong(TIMES, waypoints=[(1, (0, 0)), (2, (0, 1))]),
    wrong("waypoints: -1 given; allowed: times >= 0", waypoints=[(-1, (0, 0)), (2, (0, 1))]),
    wrong("waypoints: [] given; allowed: at least two", waypoints=[]),
    *(
        wrong(PLACES, waypoints=each)
        for each in (
            3, [(0, (0, 0))], [(0, (0, 0)), (1, 2)], [(0, 0, 0), (1, 2, 3)],
            [(0, (0, 0)), (1, (0, np.nan))],
        )
    ),
    wrong(SPEEDS, about="velocity", waypoints=[(0, (0, 0)), (1e-200, (0, 1))]),
    wrong("velocity: (0, 1) given; allowed: none with", velocity=(0, 1), waypoints=PATH),
    wrong("shape: 'fingre' given; allowed: fence, finger; did you mean finger?", shape="fingre"),
    wrong("shape: 'box' given; allowed: fence, finger; name one of these shapes", shape="box"),
    wrong("shape: 3 given; allowed: fence, finger; name one of these shapes", shape=3),
    *(
        wrong(f"radius: {said} given; allowed: a finite number >= 0; give the radius of the finger in the "
            "scene's unit of length, or leave it out for a point", radius=each, shape="finger")
        for each, said in ((-0.1, "-0.1"), (np.inf, "inf"), ("2", "'2'"), (np.array([0.1, -0.2]), "-0.2"))
    ),
    wrong("allowed: 0 for a fence, which is a line; leave the radius out, or set shape=", radius=0.2),
    wrong("frame: 'word' given; ", "; did you mean world?", frame="word"),
]  # fmt: skip


@table(PUSHERS)
def test_pushers(name, words, given):
    motion = {} if {"velocity", "waypoints"} & {*given} else {"velocity": (0, 1)}
    refused(lambda: pp.Pusher(**given, **motion), name, *words)


def test_a_pusher_has_a_motion_and_a_fence_a_radius_of_zero():
    refused(pp.Pusher, "velocity", "velocity: None given; allowed: (v_x, v_y)")
    assert pp.Pusher(velocity=(0, 1), radius=0).radius == 0


SIDE = (
    "allowed: (start, end) with start <= 0 <= end, infinite for a side without an end; measure both ends "
    "along the side from the contact, which is between them, the one toward -x first"
)
SIDES = [
    wrong(f"side: {said} given; {SIDE}", side=side)
    for side, said in (
        ((1.0, -1.0), 1.0), ((0.5, 1.0), 0.5), ((-1.0, -0.5), -0.5), ((-1.0, np.nan), "nan"),
        ((-1.0, "far"), "'far'"), (3.0, 3.0), ((-1, 0, 1), "(-1, 0, 1)"), ((-1.0, [1.0, -2.0]), -2.0),
    )
]  # fmt: skip


@table(SIDES)
def test_sides_that_do_not_hold_the_contact(name, words, given):
    refused(lambda: pp.Slider(rod_length=1.0, rod_angle=1.0, **given), name, *words)


# --- A run ---------------------------------------------------------------------------------------

FINGER = pp.Pusher(velocity=(0, 1), shape="finger", radius=3e4)
WIDE = (
    "radius: 30000.0 given; allowed: at most 10000 times the slider's radius; give the radius of the "
    "finger in the unit of the rod length"
)
RADII = pp.Pusher(velocity=(0, 1), shape="finger", radius=np.array([0.1, 0.2]))
UNEVEN_PIECES = pp.Pusher(velocity=[(0, (ONES, 1)), (1, (np.ones(3), 1))])
STEPPED = {"method": "time-stepping"}
STEPS = [
    (5e-324, "steps"), (0.9e-9, "allowed: at most 1e+09 steps"), (0.0, "a finite number > 0"),
    (-1.0, ""), (np.inf, ""), (np.nan, ""), ("fine", ""), (Decimal("0.1"), ""), (TRUE, ""),
]  # fmt: skip
POLICIES = [
    ("guess", "allowed: keep-contact, separate, stay-in-mode"),
    ("stik", "stick, slip-right, slip-left, or a sequence of (start_time, policy)"),
    (["stick", "separate"], "on_ambiguity: ['stick', 'separate'] given"), (b"separate", ""), (1, ""),
    ([(0, "guess")], "on_ambiguity: 'guess' given; allowed: keep-contact, "), ([(0.1, "stick")], STARTS),
    ([], STARTS), ([(0, "stick"), (0, "separate")], "put the pieces in order"),
    ([(-1, "stick")], "on_ambiguity: -1 given; allowed: times >= 0"),
]  # fmt: skip
TWIST = "allowed: three finite numbers of at most 1e+140"
CONDITIONS = [
    ("SLIP_END", "allowed: an Event or a ContactMode or its name, an Until, or a function of an instant "
     "of the log; did you mean SLIP_ENDS?"),
    ("NONE", "until: 'NONE' given"), (pp.Event.NONE, "use a name from the log, such as SLIP_ENDS"),
    (3, "until: 3 given"), (0.5, "until: 0.5 given"), ([], "until: [] given"),
]  # fmt: skip
POSES = [3, (1, 2), (1, 2, np.nan), (1, 2, "x"), (1, np.inf, 0), (1, 2, 3, 4)]
DEGREES = [90, -90.0, np.float64(90), np.int64(90), np.array(90)]
WORLD = pp.Pusher(velocity=(0, 1), frame="world")
RUNS = [
    wrong("scene: 3 given", scene=3), wrong(scene=make_scene(np.array([1.0, 2.0]), 0.5)),
    wrong("pusher: (1, 0) given", pusher=(1, 0)),
    wrong("duration: 0 given; allowed: a finite number > 0", duration=0),
    *(wrong(duration=each) for each in (np.nan, ONES, Decimal(1), TRUE)),
    wrong("method: 'euler' given; allowed: event-driven, time-stepping", method="euler"),
    wrong(method=["event-driven"]), wrong(method=None),
    wrong("rtol: 1e-20 given; allowed: a number in [1e-13, 1e-2]", rtol=1e-20),
    *(wrong(rtol=each) for each in (Decimal("1e-8"), b"1e-8", TRUE, "1e-8")),
    *(wrong(words, on_ambiguity=each) for each, words in POLICIES),
    wrong("samples: 1 given; allowed: a whole number >= 2", samples=1),
    *(wrong(samples=each) for each in (2.5, TRUE, 10**12, HUGE, Decimal(3))),
    *(
        wrong(TWIST, twist=each, scene=make_scene(2.0, 0.5, INERTIA))
        for each in (("0", 0, 0), (0, 0), 5, None, (1e200, 0, 0), (np.nan, 0, 0), (True, 0, 0), "abc")
    ),
    wrong("allowed: (0, 0, 0) for a scene without inertia", twist=(1, 0, 0)),
    wrong("gap: -1 given; allowed: a finite number >= 0", gap=-1),
    wrong(gap=np.zeros(2)), wrong(gap=b"1"), wrong(path=5), wrong(path=b"log.nc"),
    wrong("step: 0.1 given; allowed: a number for the time-stepping method only", step=0.1),
    *(wrong(words, step=each, **STEPPED) for each, words in STEPS),
    wrong(WIDE, about="radius", pusher=FINGER),
    wrong("radius: 'arrays' given; allowed: one radius; ", "_batch", about="radius", pusher=RADII),
    wrong("velocity: 'arrays' given; allowed: one velocity", about="velocity", pusher=UNEVEN_PIECES),
    wrong("or call simulate_batch", about="velocity", pusher=pp.Pusher(velocity=(ONES, 1.0))),
    *(wrong(words, until=each) for each, words in CONDITIONS),
    wrong("until: 'KINK' given; allowed: a mode, an Until or a", until="KINK", **STEPPED),
    *(wrong("allowed: (x, y, angle) of", object_pose=each) for each in POSES),
    *(wrong("an angle in radians in [-4 pi, 4 pi]", object_pose=(1, 2, each)) for each in DEGREES),
    wrong("allowed: fence, if no object_pose is given; give simulate", about="frame", pusher=WORLD),
    wrong("one object_pose; simulate them one by one, or call simulate_batch", object_pose=(0, 0, ONES)),
]  # fmt: skip


@table(RUNS)
def test_runs(tmp_path, name, words, given):
    """No file is made."""
    values = {"scene": SCENE, "pusher": AHEAD, "duration": 1.0, "path": tmp_path / "log.nc"} | given
    refused(lambda: pp.simulate(values.pop("scene"), **values), name, *words)
    assert not list(tmp_path.iterdir())


#: What functions return.
ANSWERS = [
    wrong(SPEEDS, about="velocity", pusher=pp.Pusher(velocity=lambda _: (0.0, 1e200))),
    wrong(about="velocity", pusher=pp.Pusher(velocity=lambda _: (0, HUGE))),
    wrong("velocity: 1.0 given", about="velocity", pusher=pp.Pusher(velocity=lambda _: 1.0)),
    wrong("until: np.float64(0.0) given; allowed: a function that", until=lambda now: now["gap"]),
    wrong("until: None given; allowed: a function that returns True or False", until=lambda _: None),
]  # fmt: skip


@table(ANSWERS)
def test_answers_of_functions(name, words, given):
    values = {"pusher": AHEAD} | given
    refused(lambda: pp.simulate(SCENE, duration=1.0, **values), name, *words)


GOALS = [
    wrong("Until: None given; allowed: rotation, distance, pusher_distance; give", about="Until"),
    wrong("rotation: 0 given; allowed: radians in (0, 4 pi]", rotation=0),
    wrong(distance=-1.0), wrong(pusher_distance=np.inf), wrong(rotation="1"),
    *(
        wrong("given; allowed: radians in (0, 4 pi]; convert degrees", rotation=each)
        for each in (90, 90.0, np.float32(90), np.int64(90))
    ),
]  # fmt: skip


@table(GOALS)
def test_goals(name, words, given):
    refused(lambda: pp.Until(**given), name, *words)


# --- A batch -------------------------------------------------------------------------------------


def arrays(friction_coefficient=1.0, effects=FRICTION, **given):
    """A scene of arrays."""
    slider = pp.Slider(**{"rod_length": 1.0, "rod_angle": 1.0} | given)
    return pp.Scene(slider=slider, contact=pp.Coulomb(friction_coefficient), effects=effects)


VALUES = [
    wrong("rod_length: -1.0 given", rod_length=np.array([1, -1])), wrong(rod_length=["1", "2"]),
    wrong(rod_length=[Decimal(1)]), wrong(rod_angle=None),
    wrong("rod_angle: 3.14159", rod_angle=np.array([1.0, np.pi])), wrong("radius: 0 given", radius=0),
    wrong("friction_coefficient: nan given", friction_coefficient=np.nan),
    wrong("friction_coefficient: inf given", friction_coefficient=np.array([1.0, np.inf])),
    wrong("friction_coefficient: 'rough' given", friction_coefficient="rough"),
    wrong(friction_coefficient=Decimal(1)), wrong(friction_coefficient=[[1], [1, 2]]),
    wrong(effects=()),
]  # fmt: skip
GAPS = xr.DataArray([0.0, 0.1], dims="gap", coords={"gap": [0.0, 0.1]})
LATER = xr.DataArray([0.0, 0.1], dims="gap", coords={"gap": [0.1, 0.2]})
OUTLINED = pp.Scene(
    slider=pp.Slider(rod_length=np.ones(3), rod_angle=np.pi / 2, radius=1.0, outline=SQUARE),
    contact=pp.Coulomb(1.0), effects=FRICTION,
)  # fmt: skip
FINGERS = pp.Pusher(velocity=(0, 1), shape="finger", radius=ONES)
ONE_SHAPE = "shapes: [(2,), (3,)] given; allowed: () or (scenes,); give one number"
#: Arguments whose shapes do not match.
SHAPES = [
    ("", {"scene": arrays(rod_length=ONES, rod_angle=np.ones(3))}),
    ("", {"scene": arrays(rod_length=ONES), "pusher": pp.Pusher(velocity=(np.ones(3), 0))}),
    ("", {"scene": arrays(rod_length=np.ones((2, 2)))}), ("", {"scene": arrays(rod_length=np.ones(0))}),
    (ONE_SHAPE, {"scene": arrays(radius=np.ones(3)), "pusher": FINGERS}),
    ("", {"scene": OUTLINED, "gap": np.zeros(2)}), ("", {"pusher": UNEVEN_PIECES}),
    ("", {"pusher": FINGERS, "gap": np.array([0.0, 0.1, 0.2])}),
    ("also give this array as an xarray.DataArray",
     {"scene": arrays(rod_length=xr.DataArray(ONES, dims="length")), "duration": ONES}),
    ("shapes: [(), (2,), (3,)] given; allowed: () or (scenes,); give one number",
     {"object_pose": (ONES, np.ones(3), 0)}),
    ("", {"scene": arrays(rod_length=ONES), "object_pose": (0, np.ones(3), 0)}),
    ("", {"object_pose": (ONES, ONES, ONES), "gap": np.zeros(3)}),
    ("", {"pusher": replace(WORLD, velocity=(np.zeros(3), 1)), "object_pose": (0, 0, ONES)}),
    ("", {"object_pose": (np.ones((2, 2)), 0, 0)}),
    ("also give this array as an xarray.DataArray",
     {"object_pose": (xr.DataArray(ONES, dims="place"), ONES, 0)}),
    ("also give this array as an xarray.DataArray",
     {"pusher": replace(WORLD, velocity=(np.zeros(2), 1)),
      "object_pose": (0, 0, xr.DataArray(ONES, dims="angle"))}),
    *(("different labels of gap' given; allowed: the same labels of each dimension",
       {"gap": GAPS} | given) for given in ({"duration": LATER + 1.0}, {"object_pose": (0, 0, LATER)})),
    ("place: 2, place: 3", {"object_pose": (
        *(xr.DataArray(np.ones(size), dims="place") for size in (2, 3)), 0)}),
]  # fmt: skip
BATCHES = [
    wrong(scene=3), wrong(scene=pp.Scene), wrong(pusher=None),
    wrong("pusher: (0.0, 1.0) given; allowed: a Pusher", pusher=(0.0, 1.0)),
    *(wrong(duration=each) for each in (0, "1", [True], None)),
    wrong("duration: 0.0 given", duration=np.array([1, 0])),
    *(wrong(gap=each) for each in (-1, np.array(["0"]))),
    *(wrong(twist=each) for each in ("abc", (0.0, 1.0), 5)),
    wrong("allowed: (0, 0, 0)", twist=(1, 0, 0)), *(wrong(samples=each) for each in (1, 10**12)),
    *(wrong(rtol=each) for each in (1, "1e-8")),
    wrong("on_ambiguity: 'hold' given", on_ambiguity="hold"),
    wrong(WIDE, about="radius", pusher=FINGER), wrong("give simulate", about="frame", pusher=WORLD),
    wrong("dimensions: 'gap' given; allowed: names ", "rename", about="dimensions", gap=GAPS),
    wrong("dimensions: 'object_angle' given", about="dimensions", object_pose=(
        0, 0, xr.DataArray(ONES, dims="object_angle"))),
    *(wrong("allowed: (x, y, angle) of", object_pose=each) for each in (
        *POSES, (ONES, 1, np.array([0, np.nan])), (1, np.array(["a"]), 0))),
    *(wrong("an angle in radians in [-4 pi, 4 pi]", object_pose=(1, ONES, each)) for each in (
        *DEGREES, np.array([0, 90]))),
    *(wrong(words, about="shapes", **given) for words, given in SHAPES),
]  # fmt: skip


@table(VALUES)
def test_scenes_of_arrays(name, words, given):
    refused(lambda: arrays(**given), name, *words)


@table(BATCHES)
def test_batches(name, words, given):
    values = {"scene": SCENE, "pusher": AHEAD, "duration": 1.0} | given
    refused(lambda: pp.simulate_batch(**values), name, *words)


# --- What is allowed -----------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [0.0, 1e-140, 1.0, 1e140])
def test_other_speeds_are_simulated(speed):
    duration, pusher = 0.01 / speed if speed else 1.0, pp.Pusher(velocity=(0.0, speed))
    log = pp.simulate(SCENE, pusher=pusher, duration=duration, samples=2, rtol=1e-6)
    assert np.isfinite(log.rod_angle).all()
    assert log.pusher[-1, 1] == pytest.approx(speed * duration, rel=1e-12, abs=0)


def test_a_batch_of_whole_numbers():
    whole, real = (
        pp.simulate_batch(
            make_scene(np.array([1, 2], dtype), pp.Coulomb(one), psi=one),
            pp.Pusher(velocity=(0 * one, one)), duration=one, rtol=1e-6,
        )
        for dtype, one in ((int, 1), (float, 1.0))
    )  # fmt: skip
    assert whole.identical(real)


def test_an_outline_that_begins_through_the_fence():
    (point,), corners = turned([(0.0, -1.0)], 0.2), turned(SQUARE, 0.2)
    scene = box(point, corners=corners, outlined=True)
    words = f"outline: 'a point {np.sin(0.2):.6g} below the fence' given; allowed: an outline on"
    refused(lambda: pp.simulate(scene, pusher=AHEAD, duration=1.0), "outline", words)
    gaps = {"pusher": AHEAD, "duration": 1.0, "gap": np.array([0.5, 0.1])}
    refused(lambda: pp.simulate_batch(scene, **gaps), "outline", "below the fence")
    finger = pp.Pusher(velocity=(0, 1), shape="finger")
    for allowed in ({"pusher": AHEAD, "gap": 0.3}, {"pusher": finger}):
        assert pp.simulate(scene, duration=0.1, **allowed).attrs["stopped"] == ""
