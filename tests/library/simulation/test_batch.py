"""Many scenes at once: arrays by position and by name, and calls that are ended or watched."""

from __future__ import annotations

import signal
import threading
import time
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import make_scene
from simulation.runs import REFERENCES
from simulation.scenes import BOX, NO_EDGE, RING, TILTED, box, scene

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction
from planar_pushing.simulation.early_end import quietly
from signals import interruptible

#: Variables that are not those of a log: what is given, and a number that a log has for each effect.
OTHERS = {"rod_length", "friction_coefficient", "duration", "velocity", "evaluations", "impulse"}
AHEAD, MASS = pp.Pusher(velocity=(0.2, 1.0)), pp.Inertia(mass=1.3, gyration_radius=0.8)
FINGER = pp.Pusher(velocity=(0.4, 1.0), shape="finger")
LAWS = np.array([pp.Coulomb(0.4), pp.InfiniteFriction(), NO_EDGE, pp.PerfectlyRough()])
PIECES = [(0, (0.5, 1)), (0.5, (0, 0)), (0.8, (0.3, -1)), (1.1, (0, 2))]
OVER_TIME = [(0, "slip-left"), (0.3, "stay-in-mode"), (0.9, "slip-right"), (1.2, "stick")]
GAPS = np.array([0.0, 0.0, 0.1, 0.2])
TURNS = np.deg2rad([[95.0, 60, 90], [80, 120, -60], [150, 20, 90]])


def same_run(row, log, parts=None):
    """Whether a row of a batch, at its last instant or at its parts, is a log, bit for bit."""
    instants = [row] if parts is None else [row.isel(part=part) for part in range(parts)]
    names = ({*row.data_vars} & {*log.variables}) - OTHERS
    assert names >= {"time", "rod_angle", "slip", "gap", "force", "mode", "pivot", "solutions"}
    for here in instants:
        there = log.isel(time=np.flatnonzero(log.time.values <= here.time.values)[-1])
        for name in names:
            assert np.array_equal(here[name], there[name]), (name, here.time)
    assert np.atleast_1d(row.stopped)[-1] == log.attrs["stopped"]
    assert row.evaluations == log.evaluations.values[-1].max()


def run(scene, pusher, **options):
    return quietly(pp.simulate)(scene, pusher=pusher, **{"duration": 0.5, "samples": 2} | options)


@pytest.mark.parametrize("function", [pp.simulate, pp.simulate_batch])
def test_the_pusher_is_the_second_argument_or_named(function):
    given, pusher = scene(BOX, mu=0.5), FINGER
    named = function(given, pusher=pusher, duration=0.5)
    assert function(given, pusher, duration=0.5).identical(named)
    assert function(pusher=pusher, scene=given, duration=0.5).identical(named)


# --- Arrays, one entry a scene -------------------------------------------------------------------


def random_scenes(seed, **options):
    """Scenes under friction with a law, a velocity and a duration of their own."""
    random, count = np.random.default_rng(seed), 12
    coefficients = random.uniform(0, 4, count)
    laws = [pp.InfiniteFriction() if mu < 1 else pp.Coulomb(mu) for mu in coefficients]
    lengths, angles = random.uniform(0, 6, count), np.deg2rad(random.uniform(20, 160, count))
    velocities = direction(np.deg2rad(random.uniform(-20, 200, count)))
    durations = random.uniform(0.5, 2, count)
    return [
        ({"scene": make_scene(lengths[at], np.array(laws, object)[at], psi=angles[at], radius=0.7),
          "pusher": pp.Pusher(velocity=tuple(velocities[at].T)), "duration": durations[at]} | options)
        for at in (slice(None), *range(count))
    ]  # fmt: skip


def table(values, case):
    """A case of an array of values, and of each of them."""
    return [case(values), *map(case, values)]


def turning(at):
    """Pushers whose pieces differ from scene to scene."""
    parts = [(np.cos(angles)[at], np.sin(angles)[at]) for angles in TURNS]
    return list(zip([0.0, 0.3, 0.7], parts, strict=True))


def in_turns(effects, shape):
    durations, policy = np.array([0.5, 1.0, 0.9]), [(0, "stick"), (0.4, "separate")]
    return [
        {"scene": make_scene(2.0, 0.5, effects, psi=1.0, radius=0.7), "duration": durations[at],
         "pusher": pp.Pusher(velocity=turning(at), shape=shape), "on_ambiguity": policy}
        for at in (slice(None), 0, 1, 2)
    ]  # fmt: skip


def on_side(angle, end):
    pusher = pp.Pusher(velocity=tuple(direction(angle).T), shape="finger")
    return {"scene": scene(mu=pp.Coulomb(0.1), side=(-1.0, end)), "pusher": pusher}


SIDES = np.deg2rad([60.0, 68.0, 120.0]), np.array([0.1, 0.3, np.inf])
OUTLINED = {
    "fence": box(TILTED[0], RING, corners=TILTED, outlined=True),
    "finger": box((-0.9, -1), RING, outlined=True, side=(-0.1, 1.9)),
}  # fmt: skip


def under(shape, mu):
    pusher = pp.Pusher(velocity=direction(np.deg2rad(60.0)), shape=shape)
    return {
        "scene": replace(OUTLINED[shape], contact=pp.Coulomb(mu)),
        "pusher": pusher,
        "duration": 9.0,
    }


TEE = [(-0.6, 0), (-0.6, -0.3), (-0.15, -0.3), (-0.15, -1.2), (0.15, -1.2), (0.15, -0.3), (0.6, -0.3),
       (0.6, 0)]  # fmt: skip
WIDE = [(-1, -0.6), (1, -0.6), (1, 0.6), (-1, 0.6)]
#: Outline, contact, normal and support of objects, one of which has no outline.
OBJECTS = {
    "a disc": (pp.Disc(1.0), (0.6, -0.8), (-0.6, 0.8), pp.Disc(1.0)),
    "an ellipse": (pp.Outline.ellipse(1.0, 0.6), (0, -0.6), (0, 1), pp.Disc(0.5)),
    "a T": (TEE, (0.15, -1.2), (-0.28, 0.96), pp.Polygon(TEE)),
    "a rounded box": (pp.rounded(WIDE, 0.2), (0.92, -0.56), (-0.6, 0.8), pp.Polygon(WIDE)),
    "a rod": (None, (0.3, -1.0), (0, 1), pp.Ring(1.0)),
}
#: Poses of three objects, and velocities of pushers along the axes of the world.
POSES = np.array([0.3, -2.0, 0.0]), np.array([-1.0, 0.0, 1e3]), np.array([0.2, np.pi / 2, -2.5])
ALONG_WORLD = [(0, (np.array([0.1, -1.0, 0.6]), np.array([1.0, 0.2, -0.8]))), (0.3, (-0.2, 0.9))]
ALONG_FENCE = [(0, (0.3, 1.0)), (0.3, (-0.2, 0.5))]


@cache
def touched(name, massive):
    """An object at its contact."""
    outline, point, normal, support = OBJECTS[name]
    mass = (pp.Inertia(mass=1.0, gyration_radius=0.6),) if massive else ()
    return pp.scene_at(
        point, normal, effects=(pp.SupportFriction(support=support), *mass),
        contact=pp.Coulomb(0.3), outline=outline,
    )  # fmt: skip


def in_poses(name, shape, massive, motion):
    """Objects in poses of their own, or all in one, which a pusher pushes along their own axes."""
    frame, velocity = motion
    for i in (slice(None), 0, 1, 2):
        pieces = velocity
        if not callable(velocity):
            pieces = [(t, tuple(v[i] if np.ndim(v) else v for v in pair)) for t, pair in velocity]
        pusher = pp.Pusher(
            velocity=pieces, shape=shape, frame=frame, radius=0.1 * (shape == "finger")
        )
        yield {
            "scene": touched(name, massive),
            "pusher": pusher,
            "object_pose": tuple(x[i] for x in POSES),
        }


MOTIONS = {
    "pieces along the fence": ("fence", ALONG_FENCE), "arrays along the world": ("world", ALONG_WORLD),
    "a function along the world": ("world", lambda t: (0.3 * t, 1.0 - 0.5 * t)),
}  # fmt: skip
#: A batch, and each of its runs.
BATCHES = {
    **{policy: random_scenes(i, on_ambiguity=policy)
       for i, policy in enumerate(("keep-contact", "separate", "stay-in-mode"))},
    "policies in turn": random_scenes(4, on_ambiguity=OVER_TIME),
    **{f"laws and gaps, {policy}": [
        {"scene": make_scene(2.0, LAWS[at], (RING, MASS), psi=1.0, radius=0.7), "gap": gap, "duration": 1.5,
         "pusher": pp.Pusher(velocity=PIECES), "twist": (0.2, -0.3, 0.4), "on_ambiguity": policy}
        for at, gap in ((slice(None), GAPS), *enumerate(GAPS))
    ] for policy in ("separate", OVER_TIME)},
    "masses": table(np.array([0.5, 1.0, 2.0]), lambda mass: {
        "scene": make_scene(2.0, 0.5, (RING, pp.Inertia(mass=mass)), psi=1.0, radius=0.7)}),
    "one scene": [{"scene": make_scene(2.0, 0.5)}] * 2,
    "one scene under a finger": [{"scene": scene(BOX, mu=0.5), "pusher": FINGER}] * 2,
    "pieces of a fence": in_turns((RING,), "fence"), "pieces of a finger": in_turns((BOX,), "finger"),
    "ends of the side": [on_side(*SIDES), *map(on_side, *SIDES)],
    **{f"radii of {name}": table(np.array([0.0, 0.1, 0.8]), lambda radius, effects=effects: {
        "scene": scene(*effects, mu=0.1), "pusher": replace(FINGER, radius=radius)})
       for name, effects in {"friction": (RING,), "both": (RING, MASS)}.items()},
    **{f"laws on an outline, {shape}": table(np.array([0.05, 0.2, 0.4, 2.0]), lambda mu, shape=shape: under(
        shape, mu)) for shape in OUTLINED},
    "radii of an outline": table(np.array([0.7, 1.0, 1.4]), lambda radius: {
        "scene": replace(OUTLINED["fence"], contact=pp.Coulomb(0.1),
                         slider=replace(OUTLINED["fence"].slider, radius=radius)),
        "duration": 9.0}),
    **{f"{name} in poses, {shape}, {'both' if massive else 'friction'}, {motion}": [
        *in_poses(name, shape, massive, MOTIONS[motion])
    ] for name in OBJECTS for shape in ("fence", "finger") for massive in (False, True)
        for motion in MOTIONS},
}  # fmt: skip


#: The other batches in poses have each motion with each object, each shape, and with and without mass.
POSED = {
    f"{name} in poses, {shape}, {'both' if massive else 'friction'}, {motion}"
    for i, name in enumerate(OBJECTS) for j, shape in enumerate(("fence", "finger"))
    for massive in (False, True) for k, motion in enumerate(MOTIONS) if (i + j + massive + k) % 3
}  # fmt: skip


@pytest.mark.filterwarnings("ignore:outline:planar_pushing.SceneWarning")
@pytest.mark.parametrize("name", [
    pytest.param(name, marks=pytest.mark.slow) if name in POSED else name for name in BATCHES
])  # fmt: skip
def test_a_batch_is_its_runs(name):
    whole, *runs = ({"pusher": AHEAD, "duration": 0.5} | case for case in BATCHES[name])
    last, path = (quietly(pp.simulate_batch)(**whole, **more) for more in ({}, {"samples": 5}))
    assert last.sizes["scene"] == len(runs)
    for i, case in enumerate(runs):
        same_run(last.isel(scene=i), run(**case))
        same_run(path.isel(scene=i), run(**case | {"samples": 5}), 5)
    ends = [last.rod_angle, last.slip, last.time]
    if "object_pose" in whole:
        assert {"object_position", "object_angle", "pusher_position"} <= {*last}
        assert ("contact_normal" in last) == (whole["scene"].slider.outline is not None)
        ends.append(last.object_angle)
    assert np.unique(np.stack(ends), axis=1).shape[1] == len(runs)


def test_what_is_given_is_in_the_dataset():
    found = quietly(pp.simulate_batch)(**BATCHES["pieces of a fence"][0])
    assert found.piece.values.tolist() == [0.0, 0.3, 0.7]
    assert found.velocity.dims == ("scene", "piece", "xy")
    assert found.velocity[1, 2].values.tolist() == [np.cos(TURNS[2, 1]), np.sin(TURNS[2, 1])]
    found = quietly(pp.simulate_batch)(**BATCHES["laws and gaps, separate"][0], samples=2)
    assert found.friction_coefficient.values.tolist() == [0.4, np.inf, np.inf, np.inf]
    assert all({"units", "long_name"} <= set(v.attrs) for v in found.variables.values())
    assert "contact_position" not in found
    found = quietly(pp.simulate_batch)(**BATCHES["radii of both"][0], duration=0.1)
    assert found.pusher_radius.values.tolist() == [0.0, 0.1, 0.8]


def test_the_references():
    length, mu, fence, psi, duration, angles, slips = np.transpose(REFERENCES)
    laws = np.array(
        [pp.InfiniteFriction() if np.isinf(x) else pp.Coulomb(x) for x in mu], dtype=object
    )
    pusher = pp.Pusher(velocity=tuple(direction(np.deg2rad(fence)).T))
    found = quietly(pp.simulate_batch)(
        make_scene(length, laws, psi=np.deg2rad(psi)), pusher, duration=duration
    )
    assert found.rod_angle.values == pytest.approx(angles, abs=1e-8)
    assert found.slip.values == pytest.approx(slips, abs=1e-9)
    assert found["mode"].values.tolist() == [2, 3, 2, 3]
    assert (found.stopped == "").all()
    assert found.initial_rod_angle.values == pytest.approx(psi)


def test_a_tighter_tolerance_agrees_to_1e_8():
    rough, fine = (
        quietly(pp.simulate_batch)(**random_scenes(4)[0], rtol=rtol, samples=3)
        for rtol in (1e-10, 1e-12)
    )
    assert np.abs(np.deg2rad(rough.rod_angle - fine.rod_angle)).max() < 1e-8
    assert np.abs(rough.slip - fine.slip).max() < 1e-8
    assert (rough["mode"] == fine["mode"]).all()
    assert (rough.mode_changes == fine.mode_changes).all()


@pytest.mark.parametrize("many_steps", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_hard_scenes_give_numbers_without_warnings(many_steps):
    """Two short rods that stick and are pulled slowly by many times their length take most of the time."""
    length, psi, mu, angle, speed = (part.ravel() for part in np.meshgrid(
        [0, 1e-8, 1, 100], [1e-3, np.pi / 4, 3], [0, 1, np.inf],
        np.deg2rad([-90, -10, 0, 45, 90, 180]), [0, 1e-6, 10], indexing="ij",
    ))  # fmt: skip
    pulled = (length == 1e-8) & (psi == 1e-3) & np.isinf(mu) & (angle < 0) & (speed == 1e-6)
    chosen = pulled == many_steps
    length, psi, mu, angle, speed = (part[chosen] for part in (length, psi, mu, angle, speed))
    laws = np.array(
        [pp.InfiniteFriction() if np.isinf(x) else pp.Coulomb(x) for x in mu], dtype=object
    )
    velocity = speed[:, None] * direction(angle)
    scenes, pusher = make_scene(length, laws, psi=psi), pp.Pusher(velocity=tuple(velocity.T))
    found = quietly(pp.simulate_batch)(scenes, pusher, duration=1.0)
    for name, variable in found.data_vars.items():
        assert name == "stopped" or np.isfinite(variable).all(), name
    assert (found.slip.values[speed == 0] == 0).all()
    assert (found["mode"].values[speed == 0] == pp.ContactMode.SEPARATE).all()


def test_results_do_not_depend_on_the_other_scenes():
    """Several threads run parts of a batch."""
    random, count = np.random.default_rng(7), 400
    lengths, mu = random.uniform(0, 6, count), random.uniform(0, 4, count)
    velocities = direction(np.deg2rad(random.uniform(-20, 200, count))).T

    def batch(rows):
        pusher = pp.Pusher(velocity=tuple(velocities[:, rows]))
        return quietly(pp.simulate_batch)(
            make_scene(lengths[rows], pp.Coulomb(mu[rows])), pusher, duration=1.0
        )

    whole, order = batch(slice(None)), random.permutation(count)
    xr.testing.assert_identical(whole.isel(scene=order), batch(order))
    xr.testing.assert_identical(whole.isel(scene=slice(7, 10)), batch(slice(7, 10)))


# --- Labeled arrays ------------------------------------------------------------------------------


def labeled(values, dim, **coordinates):
    return xr.DataArray(values, dims=dim, coords=coordinates or None)


LENGTH = labeled([1.0, 2.0], "length", length=[1.0, 2.0])
MU = labeled([0.2, 0.5, 1.0], "law", law=list("abc"))
ALONG, DURATION = LENGTH.copy(data=[0.3, -0.1]), MU.copy(data=[0.2, 0.4, 0.3])
HEIGHT, DISC = labeled([0.0, 0.1], "height"), labeled([0.0, 0.2], "disc", disc=["point", "disc"])
SPEED = labeled([0.5, 1.0], "speed")
#: Of two dimensions, the arrays of each, and the arguments of a batch that has them.
LABELED = {
    ("length", "law"): ([LENGTH, ALONG], [MU, DURATION], lambda length, along, mu, duration: {
        "scene": make_scene(length, pp.Coulomb(mu)), "duration": duration,
        "pusher": pp.Pusher(velocity=(along, 1.0)),
    }),
    ("law", "height"): ([labeled(LAWS, "law")], [HEIGHT], lambda law, gap: {
        "scene": make_scene(2.0, law), "gap": gap, "duration": 0.4,
    }),
    ("length", "disc"): ([LENGTH], [DISC], lambda length, radius: {
        "scene": make_scene(length, 0.1, psi=1.2), "pusher": replace(FINGER, radius=radius),
    }),
    ("law", "pose"): ([MU], [labeled(part, "pose") for part in POSES], lambda mu, x, y, angle: {
        "scene": make_scene(2.0, pp.Coulomb(mu)), "object_pose": (x, y, angle),
        "pusher": pp.Pusher(velocity=(0.2, 1.0), frame="world"), "duration": 0.4,
    }),
    ("speed", "turn"): ([SPEED], [labeled(POSES[2], "turn")], lambda speed, angle: {
        "scene": box((-0.9, -1), RING, outlined=True), "object_pose": (1.0, 2.0, angle),
        "pusher": pp.Pusher(velocity=[(0, (speed, 0.1)), (0.2, (0.0, 1.0))], frame="world"),
    }),
    ("length", "speed"): ([LENGTH, ALONG], [SPEED], lambda length, along, speed: {
        "scene": make_scene(length, 0.5), "duration": 0.8,
        "pusher": pp.Pusher(velocity=[(0, (0.0, speed)), (0.2, (along, speed)), (0.5, (0.0, 0.0))]),
    }),
}  # fmt: skip


@pytest.mark.parametrize("dims", LABELED, ids=" ".join)
def test_labeled_arrays_are_broadcast_by_name(dims):
    """Also where some pieces of a velocity are arrays, and others one velocity for all."""
    first, second, case = LABELED[dims]
    options = {"pusher": AHEAD, "duration": 0.5, "samples": 3}
    found = quietly(pp.simulate_batch)(**options | case(*first, *second))
    assert found.rod_angle.dims == (*dims, "part")
    for i, j in np.ndindex(len(first[0]), len(second[0])):
        numbers = [*(each[i].item() for each in first), *(each[j].item() for each in second)]
        same_run(found.isel({dims[0]: i, dims[1]: j}), run(**options | case(*numbers)), 3)


def test_labels_are_kept():
    found = quietly(pp.simulate_batch)(**LABELED["length", "law"][2](LENGTH, ALONG, MU, DURATION))
    assert found.velocity.dims == ("length", "law", "xy")
    assert found.length.equals(LENGTH.length)
    assert found.law.values.tolist() == list("abc")
    for name, given in (
        ("friction_coefficient", MU),
        ("rod_length", LENGTH),
        ("duration", DURATION),
    ):
        assert (found[name] == given).all()


# --- A call --------------------------------------------------------------------------------------


def test_ctrl_c_ends_a_batch():
    """Within a part of a second of the minutes that this batch would take."""
    scenes = make_scene(np.linspace(0.5, 4.0, 300_000), 0.5)
    before = signal.getsignal(signal.SIGINT)
    interruptible()
    timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
    timer.start()
    start = time.perf_counter()
    try:
        with pytest.raises(KeyboardInterrupt):
            quietly(pp.simulate_batch)(scenes, AHEAD, duration=2.0)
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - start < 10.0


def test_a_batch_shows_progress_on_demand(capsys):
    scenes = make_scene(np.array([2.0, 3.0]), 1.0)
    quietly(pp.simulate_batch)(scenes, AHEAD, duration=0.1, progress=True)
    assert "scene" in capsys.readouterr().err
    quietly(pp.simulate_batch)(scenes, AHEAD, duration=0.1)
    assert capsys.readouterr().err == ""
