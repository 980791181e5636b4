"""Many scenes at once, against the simulation of each."""

from __future__ import annotations

import signal
import threading
import time

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import make_scene
from simulation.runs import REFERENCES

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction
from signals import interruptible

AHEAD = pp.Pusher(velocity=(0.2, 1.0))
FRICTION, INERTIA = pp.RingFriction(weight=0.7), pp.Inertia(mass=1.3, gyration_radius=0.8)
BOX = pp.Polygon([(1, 1), (-1, 1), (-1, -1), (1, -1)])
#: Effects under each shape of pusher.
UNDER = {"fence": (FRICTION,), "finger": (pp.SupportFriction(support=BOX),)}


def random_scenes(count, seed):
    rng = np.random.default_rng(seed)
    mu = np.where(rng.random(count) < 0.3, np.inf, rng.uniform(0, 4, count))
    return {
        "rod_length": rng.uniform(0, 6, count),
        "rod_angle": np.deg2rad(rng.uniform(20, 160, count)),
        "friction_coefficient": mu,
        "velocity": direction(np.deg2rad(rng.uniform(-20, 200, count))),
        "duration": rng.uniform(0.5, 2, count),
    }


def law(mu):
    return pp.InfiniteFriction() if np.isinf(mu) else pp.Coulomb(mu)


def batch(scenes, radius=1.0, **options):
    """Scenes under friction, each with a velocity of its own, all at once."""
    length, angle, mu, velocity, duration = scenes.values()
    scene = make_scene(length, np.array(list(map(law, mu))), psi=angle, radius=radius)
    return pp.simulate_batch(
        scene, pp.Pusher(velocity=tuple(velocity.T)), duration=duration, **options
    )


def single(scenes, index, radius, policy):
    length, angle, mu, velocity, duration = (values[index] for values in scenes.values())
    run = pp.simulate(
        make_scene(length, law(mu), psi=angle, radius=radius), duration=duration, samples=2,
        pusher=pp.Pusher(velocity=tuple(velocity)), on_ambiguity=policy,
    )  # fmt: skip
    return run.isel(time=-1)


def test_the_references():
    length, mu, fence, psi, duration, angles, slips = np.transpose(REFERENCES)
    scenes = {
        "rod_length": length, "rod_angle": np.deg2rad(psi), "friction_coefficient": mu,
        "velocity": direction(np.deg2rad(fence)), "duration": duration,
    }  # fmt: skip
    found = batch(scenes)
    assert found.rod_angle.values == pytest.approx(angles, abs=1e-8)
    assert found.slip.values == pytest.approx(slips, abs=1e-9)
    assert found["mode"].values.tolist() == [2, 3, 2, 3]
    assert (found.stopped == 0).all()
    assert found.initial_rod_angle.values == pytest.approx(psi)
    sampled = batch(scenes, samples=2)
    assert all({"units", "long_name"} <= set(v.attrs) for v in sampled.variables.values())


@pytest.mark.parametrize(
    ("seed", "policy"),
    [
        (1, "keep-contact"), (2, "separate"), (3, "stay-in-mode"),
        (4, [(0, "slip-left"), (0.6, "separate"), (1.1, "stick")]),
    ],
)  # fmt: skip
def test_random_scenes_move_as_one_by_one(seed, policy):
    scenes = random_scenes(12, seed)
    found = batch(scenes, radius=0.7, on_ambiguity=policy)
    for index in range(12):
        one, here = single(scenes, index, 0.7, policy), found.isel(scene=index)
        for name in ("rod_angle", "slip", "gap", "time", "mode", "solutions"):
            assert here[name].item() == one[name].item()
        assert (here.position == one.position).all()
        assert (here.stopped.item() > 0) == (one.stopped != "")


def test_a_tighter_tolerance_agrees_to_1e_8():
    scenes = random_scenes(30, 4)
    rough, fine = (batch(scenes, rtol=rtol) for rtol in (1e-10, 1e-12))
    assert np.abs(np.deg2rad(rough.rod_angle - fine.rod_angle)).max() < 1e-8
    assert np.abs(rough.slip - fine.slip).max() < 1e-8
    assert (rough["mode"] == fine["mode"]).all()
    assert (rough.mode_changes == fine.mode_changes).all()


def test_samples_lie_on_one_course():
    scenes = random_scenes(20, 5)
    last, path = batch(scenes), batch(scenes, samples=7)
    assert path.sizes == {"scene": 20, "part": 7, "xy": 2}
    assert path.rod_angle.isel(part=0).values == pytest.approx(np.rad2deg(scenes["rod_angle"]))
    assert np.abs(path.rod_angle.isel(part=-1) - last.rod_angle).max() < 1e-6
    goes_on = path.isel(scene=np.nonzero((path.stopped == 0).all("part").values)[0])
    assert goes_on.time.values == pytest.approx(
        (goes_on.part * goes_on.duration).T.values, rel=1e-12, abs=0
    )
    turns = np.diff(path.rod_angle, axis=1)
    assert (np.sign(turns).min(axis=1) * np.sign(turns).max(axis=1) >= 0).all()


def test_hard_scenes_give_numbers_without_warnings():
    names = ("rod_length", "rod_angle", "friction_coefficient", "angle", "speed")
    grid = np.meshgrid(
        [0, 1e-8, 1, 100], [1e-3, np.pi / 4, 3], [0, 1, np.inf],
        np.deg2rad([-90, -10, 0, 45, 90, 180]), [0, 1e-6, 10], indexing="ij",
    )  # fmt: skip
    flat = dict(zip(names, (part.ravel() for part in grid), strict=True))
    velocity = flat.pop("speed")[:, None] * direction(flat.pop("angle"))
    found = batch(flat | {"velocity": velocity, "duration": 1.0})
    for name, variable in found.data_vars.items():
        assert np.isfinite(variable).all(), name
    still = np.hypot(*velocity.T) == 0
    assert (found.slip.values[still] == 0).all()
    assert (found["mode"].values[still] == pp.ContactMode.SEPARATE).all()


def values(rod_length=1.0, rod_angle=1.0, friction_coefficient=1.0, **given):
    """Arguments of `simulate_batch`."""
    slider = {"rod_length": rod_length, "rod_angle": rod_angle, "radius": given.pop("radius", 1.0)}
    effects, velocity = given.pop("effects", (FRICTION,)), given.pop("velocity", (0.0, 1.0))
    return {
        "scene": pp.Scene(
            slider=pp.Slider(**slider), contact=pp.Coulomb(friction_coefficient), effects=effects
        ),
        "pusher": pp.Pusher(velocity=velocity), "duration": 1.0,
    } | given  # fmt: skip


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"rod_length": np.array([1, -1])}, "rod_length: -1.0 given"),
        ({"rod_angle": np.array([1.0, np.pi])}, r"rod_angle: 3\.14159.* given"),
        ({"friction_coefficient": np.nan}, "friction_coefficient: nan given"),
        ({"friction_coefficient": np.array([1.0, np.inf])}, "friction_coefficient: inf given"),
        ({"friction_coefficient": "rough"}, "friction_coefficient: 'rough' given"),
        ({"duration": 0}, "duration: 0 given"),
        ({"duration": np.array([1, 0])}, "duration: 0.0 given"),
        (
            {"velocity": (np.array([1.0, np.inf]), 0)},
            "velocity: inf given; allowed: finite numbers",
        ),
        ({"velocity": (np.array(["a"]), 0)}, "velocity: .*'a'.* given; allowed: finite numbers"),
        ({"velocity": (np.array([1, 0]), 0, 0)}, "velocity: .* given"),
        ({"rod_length": np.ones(2), "rod_angle": np.ones(3)}, "shapes: .* given"),
        ({"rod_length": np.ones(2), "velocity": (np.ones(3), 0)}, "shapes: .* given"),
        ({"rod_length": np.ones((2, 2))}, "shapes: .* given"),
        (
            {
                "radius": np.ones(3),
                "pusher": pp.Pusher(velocity=(0, 1), shape="finger", radius=np.ones(2)),
            },
            r"shapes: \(\(2,\), \(3,\)\) given; allowed: \(\) or \(scenes,\); give one number",
        ),
        ({"rod_length": np.ones(0)}, "shapes: .* given"),
        ({"radius": 0}, "radius: 0 given"),
        ({"rtol": 1}, "rtol: 1 given"),
        ({"samples": 1}, "samples: 1 given"),
        ({"on_ambiguity": "hold"}, "on_ambiguity: 'hold' given"),
        ({"effects": ()}, "effects: .* given"),
        ({"twist": (1, 0, 0)}, r"twist: .* given; allowed: \(0, 0, 0\)"),
        ({"gap": -1}, "gap: -1 given"),
        ({"scene": 3}, "scene: 3 given"),
        ({"pusher": (0, 1)}, r"pusher: \(0, 1\) given; allowed: a Pusher"),
    ],
)
def test_what_is_not_allowed_is_refused(wrong, message):
    with pytest.raises(pp.InvalidValue, match=message):
        pp.simulate_batch(**values(**wrong))


LAWS = (
    pp.Coulomb(0.4), pp.InfiniteFriction(), pp.InfiniteFriction(at_zero_normal="none"),
    pp.PerfectlyRough(),
)  # fmt: skip
PIECES = [(0, (0.5, 1)), (0.5, (0, 0)), (0.8, (0.3, -1)), (1.1, (0, 2))]
OVER_TIME = [(0, "slip-left"), (0.3, "stay-in-mode"), (0.9, "slip-right"), (1.2, "stick")]
#: Variables that the log of a scene shares with its part of a batch.
SHARED = ("time", "rod_angle", "slip", "gap", "force", "mode", "pivot", "solutions", "position")


@pytest.mark.parametrize("policy", ["separate", OVER_TIME], ids=str)
def test_laws_and_gaps_may_be_arrays(policy):
    """Under a fence that starts, stops and turns; bit for bit, samples included."""
    effects, twist = (FRICTION, INERTIA), (0.2, -0.3, 0.4)
    pusher, gaps = pp.Pusher(velocity=PIECES), np.array([0.0, 0.0, 0.1, 0.2])
    options = {"duration": 1.5, "twist": twist, "on_ambiguity": policy, "samples": 9}
    scenes = make_scene(2.0, np.array(LAWS), effects, psi=1.0, radius=0.7)
    found = pp.simulate_batch(scenes, pusher, gap=gaps, **options)
    assert found.friction_coefficient.values.tolist() == [0.4, np.inf, np.inf, np.inf]
    for index, each in enumerate(LAWS):
        scene = make_scene(2.0, each, effects, psi=1.0, radius=0.7)
        log, here = (
            pp.simulate(scene, pusher=pusher, gap=gaps[index], **options),
            found.isel(scene=index),
        )
        assert (here.stopped != 0).any() == bool(log.attrs["stopped"])
        for part in range(9):
            until = log.isel(time=np.flatnonzero(log.time <= here.time[part])[-1])
            for name in SHARED:
                assert (here[name][part] == until[name]).all(), (each, part, name)


def last(scene, pusher, **options):
    return pp.simulate(scene, pusher=pusher, samples=2, **options).isel(time=-1)


def same(one, other):
    """Whether two ends of a motion are the same numbers, bit for bit."""
    return all(np.array_equal(one[name], other[name]) for name in SHARED)


@pytest.mark.parametrize("shape", UNDER)
def test_one_scene_is_a_batch_of_one(shape):
    scene = make_scene(2.0, 0.5, UNDER[shape])
    pusher = pp.Pusher(velocity=(0.2, 1.0), shape=shape)
    found = pp.simulate_batch(scene, pusher, duration=0.5)
    assert found.sizes == {"scene": 1, "xy": 2}
    assert same(found.isel(scene=0), last(scene, pusher, duration=0.5))


def test_labeled_arrays_are_broadcast_by_name():
    length = xr.DataArray([1.0, 2.0], dims="length", coords={"length": [1.0, 2.0]})
    mu = xr.DataArray([0.2, 0.5, 1.0], dims="law", coords={"law": list("abc")})
    along, duration = length.copy(data=[0.3, -0.1]), mu.copy(data=[0.2, 0.4, 0.3])
    scenes, pusher = make_scene(length, pp.Coulomb(mu)), pp.Pusher(velocity=(along, 1.0))
    found = pp.simulate_batch(scenes, pusher, duration=duration, samples=3)
    assert found.rod_angle.dims == ("length", "law", "part")
    assert found.velocity.dims == ("length", "law", "xy")
    assert found.sizes == {"length": 2, "law": 3, "part": 3, "xy": 2}
    assert found.length.equals(length.length)
    assert found.law.values.tolist() == list("abc")
    for i, j in np.ndindex(2, 3):
        one = last(
            make_scene(float(length[i]), float(mu[j])),
            pp.Pusher(velocity=(float(along[i]), 1.0)), duration=float(duration[j]),
        )  # fmt: skip
        here = found.isel(length=i, law=j)
        assert same(here.isel(part=-1), one)
        assert here.friction_coefficient == mu[j]
        assert here.rod_length == length[i]
        assert here.duration == duration[j]
        assert here.velocity.values.tolist() == [along[i], 1.0]


def test_labeled_laws_and_gaps():
    laws = xr.DataArray(np.array(LAWS), dims="law")
    gap = xr.DataArray([0.0, 0.1], dims="height")
    found = pp.simulate_batch(make_scene(2.0, laws), AHEAD, duration=0.4, gap=gap)
    assert found.rod_angle.dims == ("law", "height")
    for i, j in np.ndindex(4, 2):
        one = last(make_scene(2.0, LAWS[i]), AHEAD, duration=0.4, gap=float(gap[j]))
        assert same(found.isel(law=i, height=j), one)


def test_loose_arrays_beside_labeled_ones_are_refused():
    length = xr.DataArray([1.0, 2.0], dims="length")
    with pytest.raises(
        pp.InvalidValue, match=r"shapes: .*also give this array as an xarray\.DataArray"
    ):
        pp.simulate_batch(make_scene(length, 0.5), AHEAD, duration=np.array([1.0, 2.0]))


def test_a_dimension_named_like_a_result_is_refused():
    gap = xr.DataArray([0.0, 0.1], dims="gap", coords={"gap": [0.0, 0.1]})
    with pytest.raises(pp.InvalidValue, match=r"dimensions: 'gap' given; allowed: names .* rename"):
        pp.simulate_batch(make_scene(2.0, 0.5), AHEAD, duration=0.4, gap=gap)


def test_simulate_refuses_arrays_of_velocities():
    pusher = pp.Pusher(velocity=(np.array([0.1, 0.2]), 1.0))
    with pytest.raises(pp.InvalidValue, match=r"velocity: .* or call simulate_batch"):
        pp.simulate(make_scene(2.0, 0.5), pusher=pusher, duration=1.0)


def test_parameters_of_the_effects_may_be_arrays():
    masses = np.array([0.5, 1.0, 2.0])
    scenes = make_scene(2.0, 0.5, (FRICTION, pp.Inertia(mass=masses)), psi=1.0, radius=0.7)
    found = pp.simulate_batch(scenes, AHEAD, duration=1.0)
    for index, mass in enumerate(masses):
        scene = make_scene(2.0, 0.5, (FRICTION, pp.Inertia(mass=mass)), psi=1.0, radius=0.7)
        assert same(found.isel(scene=index), last(scene, AHEAD, duration=1.0))
    assert len(set(found.rod_angle.values)) == 3


def test_results_do_not_depend_on_the_other_scenes():
    """Several threads run parts of a batch."""
    scenes, order = random_scenes(400, 7), np.random.default_rng(7).permutation(400)
    whole = batch(scenes)
    other = batch({name: values[order] for name, values in scenes.items()})
    xr.testing.assert_identical(whole.isel(scene=order), other)
    part = batch({name: values[7:10] for name, values in scenes.items()})
    xr.testing.assert_identical(whole.isel(scene=slice(7, 10)), part)


def test_ends_of_the_side_may_be_arrays():
    ends, angles = np.array([0.1, 0.3, np.inf]), np.deg2rad([60.0, 68.0, 120.0])

    def scene(end):
        slider = pp.Slider(rod_length=2.0, rod_angle=1.2, radius=1.0, side=(-1.0, end))
        return pp.Scene(slider=slider, contact=pp.Coulomb(0.1), effects=(FRICTION,))

    pusher = pp.Pusher(velocity=tuple(direction(angles).T), shape="finger")
    found = pp.simulate_batch(scene(ends), pusher, duration=0.5, samples=3)
    assert found.parted[:, -1].values.tolist() == [True, True, False]
    for index, end in enumerate(ends):
        one = pp.Pusher(velocity=tuple(direction(angles[index])), shape="finger")
        log = last(scene(end), one, duration=0.5)
        for name in (*SHARED, "contact_position", "parted"):
            assert np.array_equal(found[name][index, -1], log[name]), name
    assert "contact_position" not in pp.simulate_batch(make_scene(2.0, 0.5), AHEAD, duration=0.1)


@pytest.mark.parametrize("effects", [(FRICTION,), (FRICTION, INERTIA)], ids=["friction", "both"])
def test_radii_may_be_arrays(effects):
    radii, scene = np.array([0.0, 0.1, 0.8]), make_scene(2.0, 0.1, effects, psi=1.2)
    pusher = pp.Pusher(velocity=(0.4, 1.0), shape="finger", radius=radii)
    found = pp.simulate_batch(scene, pusher, duration=0.5)
    assert found.pusher_radius.values.tolist() == radii.tolist()
    for index, radius in enumerate(radii):
        one = pp.Pusher(velocity=(0.4, 1.0), shape="finger", radius=float(radius))
        log, here = last(scene, one, duration=0.5), found.isel(scene=index)
        assert same(here, log)
        assert here.contact_position == log.contact_position
    assert len(np.unique(found.contact_position)) == 3


def test_labeled_radii_are_broadcast_by_name():
    radius = xr.DataArray([0.0, 0.2], dims="disc", coords={"disc": ["point", "disc"]})
    lengths = xr.DataArray([1.0, 2.0, 3.0], dims="rod")
    finger = pp.Pusher(velocity=(0.4, 1.0), shape="finger", radius=radius)
    found = pp.simulate_batch(make_scene(lengths, 0.1, psi=1.2), finger, duration=0.5)
    assert found.sizes == {"rod": 3, "disc": 2, "xy": 2}
    assert (found.pusher_radius == radius).all()
    one = pp.Pusher(velocity=(0.4, 1.0), shape="finger", radius=0.2)
    here = found.sel(disc="disc").isel(rod=1)
    assert same(here, last(make_scene(2.0, 0.1, psi=1.2), one, duration=0.5))


def test_ctrl_c_ends_a_batch():
    """Within a part of a second of the minutes that this batch would take."""
    scenes = make_scene(np.linspace(0.5, 4.0, 300_000), 0.5)
    pp.simulate_batch(make_scene(2.0, 0.5), AHEAD, duration=0.1)
    before = signal.getsignal(signal.SIGINT)
    interruptible()
    timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
    timer.start()
    start = time.perf_counter()
    try:
        with pytest.raises(KeyboardInterrupt):
            pp.simulate_batch(scenes, AHEAD, duration=2.0)
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - start < 10.0


def test_a_batch_shows_progress_on_demand(capsys):
    scenes = make_scene(np.array([2.0, 3.0]), 1.0)
    pp.simulate_batch(scenes, AHEAD, duration=0.1, progress=True)
    assert "scene" in capsys.readouterr().err
    pp.simulate_batch(scenes, AHEAD, duration=0.1)
    assert capsys.readouterr().err == ""


# -- velocities in pieces ------------------------------------------------------------------------------


STARTS, ANGLES_OF_PIECES = (
    [0.0, 0.3, 0.7],
    np.deg2rad([[95.0, 60, 90], [80, 120, -60], [150, 20, 90]]),
)


def velocities(index=None):
    """Pieces of the velocity of three pushers, or those of one."""
    parts = [(np.cos(angles), np.sin(angles)) for angles in ANGLES_OF_PIECES]
    chosen = slice(None) if index is None else index
    return [(t, (x[chosen], y[chosen])) for t, (x, y) in zip(STARTS, parts, strict=True)]


@pytest.mark.parametrize("shape", UNDER)
def test_velocities_in_pieces_may_be_arrays(shape):
    """Each piece differs from scene to scene, and one scene ends before the last piece."""
    durations, options = (
        np.array([0.5, 1.0, 0.9]),
        {"on_ambiguity": [(0, "stick"), (0.4, "separate")]},
    )
    scene = make_scene(2.0, 0.5, UNDER[shape], psi=1.0, radius=0.7)
    pusher = pp.Pusher(velocity=velocities(), shape=shape)
    found = pp.simulate_batch(scene, pusher, duration=durations, **options)
    assert found.piece.values.tolist() == STARTS
    assert found.velocity.dims == ("scene", "piece", "xy")
    for index, duration in enumerate(durations):
        one = pp.Pusher(velocity=velocities(index), shape=shape)
        log = last(scene, one, duration=float(duration), **options)
        here = found.isel(scene=index)
        assert same(here, log)
        for piece, (_, own) in enumerate(velocities(index)):
            assert here.velocity[piece].values.tolist() == list(own)
    assert len(set(found.rod_angle.values)) == 3


def test_a_piece_may_be_one_velocity_for_all():
    """Beside pieces of labeled arrays; a piece at rest, say."""
    speed = xr.DataArray([0.5, 1.0], dims="speed")
    along = xr.DataArray([-0.1, 0.0, 0.1], dims="along", coords={"along": [-0.1, 0.0, 0.1]})
    pusher = pp.Pusher(velocity=[(0, (0.0, speed)), (0.2, (along, speed)), (0.5, (0.0, 0.0))])
    found = pp.simulate_batch(make_scene(2.0, 0.5), pusher, duration=0.8, samples=3)
    assert found.sizes == {"along": 3, "speed": 2, "part": 3, "piece": 3, "xy": 2}
    for i, j in np.ndindex(3, 2):
        x, y = float(along[i]), float(speed[j])
        one = pp.Pusher(velocity=[(0, (0.0, y)), (0.2, (x, y)), (0.5, (0.0, 0.0))])
        here = found.isel(along=i, speed=j)
        assert same(here.isel(part=-1), last(make_scene(2.0, 0.5), one, duration=0.8))
        assert here.velocity.values.tolist() == [[0.0, y], [x, y], [0.0, 0.0]]


@pytest.mark.parametrize(
    ("velocity", "said"),
    [
        ([(0, (0, 1)), (0, (np.ones(2), 1))], "velocity: .* start times that begin at 0 and increase"),
        ([(0, (np.ones(2), 1)), (1, 3)], r"velocity: 3 given; allowed: \(v_x, v_y\), a sequence"),
        ([(0, (np.ones(2), 1)), (1, (0, np.nan))], "velocity: nan given; allowed: finite numbers"),
        ([(0, (np.ones(2), np.ones(3)))], "velocity: .* allowed: two arrays of one shape"),
        ([(0, (np.ones(2), 1)), (1, (0, 1e200))], "velocity: 1e[+]200 given; allowed: a speed"),
        ([(0, (np.ones(2), 1)), (1, (0, 1), 2)], "velocity: .* given; allowed: .* a sequence"),
    ],
)  # fmt: skip
def test_pieces_that_are_not_allowed(velocity, said):
    with pytest.raises(pp.InvalidValue, match=said) as caught:
        pp.Pusher(velocity=velocity)
    assert "\n" not in str(caught.value)


def test_pieces_of_several_shapes_are_refused():
    pusher = pp.Pusher(velocity=[(0, (np.ones(2), 1)), (1, (np.ones(3), 1))])
    with pytest.raises(pp.InvalidValue, match=r"shapes: .* given"):
        pp.simulate_batch(make_scene(2.0, 0.5), pusher, duration=1.0)
    with pytest.raises(pp.InvalidValue, match=r"velocity: 'arrays' given; allowed: one velocity"):
        pp.simulate(make_scene(2.0, 0.5), pusher=pusher, duration=1.0)
