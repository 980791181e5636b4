"""Many quasi-static scenes at once, against the event-driven simulation of each."""

import numpy as np
import pytest
import xarray as xr

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
from planar_pushing.mechanics.plane import direction
from planar_pushing.simulation.batch import simulate_batch
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate

REFERENCES = {
    "rod_length": [5, 2, 2, 1],
    "rod_angle": np.deg2rad([45, 45, 45, 80]),
    "friction_coefficient": [np.inf, 2, 2, 0.5],
    "velocity": direction(np.deg2rad([165, 60, 170, 20])),
    "duration": [3, 3, 3, 2],
}
ANGLES = [33.49164319965058, 6.511092064133266, 29.673182764562068, 110.23885816124236]
SLIPS = [2.1514157444528927, -0.15251676648881093, 2.437240035590965, -1.0410568765402608]


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


def single(scenes, index, radius, policy):
    length, angle, mu, velocity, duration = (values[index] for values in scenes.values())
    law = InfiniteFriction() if np.isinf(mu) else Coulomb(mu)
    slider = Slider(rod_length=length, rod_angle=angle, radius=radius)
    scene = Scene(slider=slider, contact=law, effects=(RingFriction(),))
    pusher = Pusher(velocity=tuple(velocity))
    run = simulate(scene, pusher=pusher, duration=duration, on_ambiguity=policy, samples=2)
    return run.isel(time=-1)


SLIDER = {"rod_length": 2.0, "rod_angle": 1.0, "radius": 0.7}


def test_the_references():
    found = simulate_batch(**REFERENCES)
    assert found.rod_angle.values == pytest.approx(ANGLES, abs=1e-8)
    assert found.slip.values == pytest.approx(SLIPS, abs=1e-9)
    assert found["mode"].values.tolist() == [2, 3, 2, 3]
    assert (found.stopped == 0).all()
    assert found.initial_rod_angle.values == pytest.approx([45, 45, 45, 80])


@pytest.mark.parametrize(
    ("seed", "policy"),
    [
        (1, "keep-contact"), (2, "separate"), (3, "stay-in-mode"),
        (4, [(0, "slip-left"), (0.6, "separate"), (1.1, "stick")]),
    ],
)  # fmt: skip
def test_random_scenes_move_as_one_by_one(seed, policy):
    scenes = random_scenes(12, seed)
    batch = simulate_batch(**scenes, radius=0.7, on_ambiguity=policy)
    for index in range(12):
        one, here = single(scenes, index, 0.7, policy), batch.isel(scene=index)
        for name in ("rod_angle", "slip", "gap", "time", "mode", "solutions"):
            assert here[name].item() == one[name].item()
        assert (here.position == one.position).all()
        assert (here.stopped.item() > 0) == (one.stopped != "")


def test_a_tighter_tolerance_agrees_to_1e_8():
    scenes = random_scenes(30, 4)
    rough, fine = (simulate_batch(**scenes, rtol=rtol) for rtol in (1e-10, 1e-12))
    assert np.abs(np.deg2rad(rough.rod_angle - fine.rod_angle)).max() < 1e-8
    assert np.abs(rough.slip - fine.slip).max() < 1e-8
    assert (rough["mode"] == fine["mode"]).all()
    assert (rough.mode_changes == fine.mode_changes).all()


def test_samples_lie_on_one_course():
    scenes = random_scenes(20, 5)
    last, path = simulate_batch(**scenes), simulate_batch(**scenes, samples=7)
    assert path.sizes == {"scene": 20, "part": 7, "xy": 2}
    assert path.rod_angle.isel(part=0).values == pytest.approx(np.rad2deg(scenes["rod_angle"]))
    assert np.abs(path.rod_angle.isel(part=-1) - last.rod_angle).max() < 1e-6
    goes_on = path.isel(scene=np.nonzero((path.stopped == 0).all("part").values)[0])
    assert goes_on.time.values == pytest.approx(
        (goes_on.part * goes_on.duration).T.values, rel=1e-12, abs=0
    )
    turns = np.diff(path.rod_angle, axis=1)
    assert (np.sign(turns).min(axis=1) * np.sign(turns).max(axis=1) >= 0).all()


def test_the_contact_stays_on_the_fence_or_above():
    path = simulate_batch(**random_scenes(20, 6), samples=6)
    assert (path.gap >= 0).all()
    fence = path.velocity.sel(xy="y") * path.time
    contact = path.position.sel(xy="y") - path.rod_length * np.sin(np.deg2rad(path.rod_angle))
    assert np.abs(contact - fence - path.gap).max() < 1e-12


def test_hard_scenes_give_numbers_without_warnings():
    names = ("rod_length", "rod_angle", "friction_coefficient", "fence", "speed")
    grid = np.meshgrid(
        [0, 1e-8, 1, 100], [1e-3, np.pi / 4, 3], [0, 1, np.inf],
        np.deg2rad([-90, -10, 0, 45, 90, 180]), [0, 1e-6, 10], indexing="ij",
    )  # fmt: skip
    flat = dict(zip(names, (part.ravel() for part in grid), strict=True))
    velocity = flat.pop("speed")[:, None] * direction(flat.pop("fence"))
    found = simulate_batch(**flat, velocity=velocity, duration=1.0)
    for name, variable in found.data_vars.items():
        assert np.isfinite(variable).all(), name
    still = np.hypot(*velocity.T) == 0
    assert (found.slip.values[still] == 0).all()
    assert (found["mode"].values[still] == ContactMode.SEPARATE).all()


def test_large_friction_converges_to_infinite_friction():
    found = simulate_batch(
        rod_length=5, rod_angle=np.pi / 4, friction_coefficient=[1e5, 1e6, np.inf],
        velocity=direction(np.deg2rad(165)), duration=3,
    )  # fmt: skip
    large, larger = np.abs(found.rod_angle.values[:2] - found.rod_angle.values[2])
    assert larger < 0.11 * large
    assert large < 1e-2


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"rod_length": [1, -1]}, "rod_length: -1.0 given"),
        ({"rod_angle": [1.0, np.pi]}, r"rod_angle: 3\.14159.* given"),
        ({"friction_coefficient": np.nan}, "friction_coefficient: nan given"),
        ({"friction_coefficient": "rough"}, "friction_coefficient: 'rough' given"),
        ({"duration": 0}, "duration: 0.0 given"),
        ({"velocity": [np.inf, 0]}, "velocity: inf given"),
        ({"velocity": [1, 0, 0]}, r"velocity: \(3,\) given"),
        ({"rod_length": [1, 2], "rod_angle": [1, 1, 1]}, "shapes: .* given"),
        ({"rod_length": []}, "shapes: .* given"),
        ({"radius": 0}, "radius: 0 given"),
        ({"rtol": 1}, "rtol: 1 given"),
        ({"samples": 1}, "samples: 1 given"),
        ({"on_ambiguity": "hold"}, "on_ambiguity: 'hold' given"),
        ({"effects": ()}, "effects: .* given"),
        ({"twist": (1, 0, 0)}, r"twist: .* given; allowed: \(0, 0, 0\)"),
        ({"gap": -1}, "gap: -1 given"),
        ({"contact": Coulomb(1)}, "friction_coefficient: 1 given; allowed: .* law as contact"),
    ],
)
def test_what_is_not_allowed_is_refused(wrong, message):
    given = {
        "rod_length": 1, "rod_angle": 1, "friction_coefficient": 1, "velocity": (0, 1), "duration": 1,
    }  # fmt: skip
    with pytest.raises(InvalidValue, match=message):
        simulate_batch(**(given | wrong))


FRICTION, INERTIA = RingFriction(weight=0.7), Inertia(mass=1.3, gyration_radius=0.8)
LAWS = (
    Coulomb(0.4), InfiniteFriction(), InfiniteFriction(at_zero_normal="none"), PerfectlyRough(),
)  # fmt: skip
PIECES = [(0, (0.5, 1)), (0.5, (0, 0)), (0.8, (0.3, -1)), (1.1, (0, 2))]


OVER_TIME = [(0, "slip-left"), (0.3, "stay-in-mode"), (0.9, "slip-right"), (1.2, "stick")]


@pytest.mark.parametrize("policy", ["keep-contact", "separate", "stay-in-mode", OVER_TIME], ids=str)
@pytest.mark.parametrize(
    "effects", [(FRICTION,), (INERTIA,), (FRICTION, INERTIA)], ids=["friction", "inertia", "both"]
)
def test_a_batch_gives_the_numbers_of_simulate(effects, policy):
    """Every law, under a fence that starts, stops and turns, over a gap; bit for bit, samples included."""
    twist = (0.2, -0.3, 0.4) if INERTIA in effects else (0.0, 0.0, 0.0)
    pusher, gaps = Pusher(velocity=PIECES), np.array([0.0, 0.0, 0.1, 0.2])
    options = {"twist": twist, "on_ambiguity": policy, "samples": 9}
    batch = simulate_batch(
        **SLIDER, contact=np.array(LAWS), effects=effects, velocity=pusher, duration=1.5, gap=gaps,
        **options,
    )  # fmt: skip
    for index, law in enumerate(LAWS):
        scene = Scene(slider=Slider(**SLIDER), contact=law, effects=effects)
        log = simulate(scene, pusher=pusher, duration=1.5, gap=gaps[index], **options)
        here = batch.isel(scene=index)
        assert (here.stopped != 0).any() == bool(log.attrs["stopped"])
        for part in range(9):
            until = log.isel(time=np.flatnonzero(log.time <= here.time[part])[-1])
            for name in ("time", "rod_angle", "slip", "gap", "mode", "solutions", "position"):
                assert (here[name][part] == until[name]).all(), (law, part, name)


def test_fences_that_are_functions_of_time_run_one_by_one():
    pusher = Pusher(velocity=lambda t: (0.3 * np.sin(3 * t), np.sin(2 * t)))
    durations = [0.5, 1.0]
    batch = simulate_batch(**SLIDER, contact=Coulomb(0.5), velocity=pusher, duration=durations)
    for index, duration in enumerate(durations):
        scene = Scene(slider=Slider(**SLIDER), contact=Coulomb(0.5), effects=(RingFriction(),))
        log = simulate(scene, pusher=pusher, duration=duration, samples=2)
        assert batch.rod_angle[index] == log.rod_angle[-1]
        assert batch.slip[index] == log.slip[-1]


def test_parameters_of_the_effects_may_be_arrays():
    masses = np.array([0.5, 1.0, 2.0])
    given = SLIDER | {"contact": Coulomb(0.5), "velocity": (0.2, 1.0), "duration": 1.0}
    batch = simulate_batch(**given, effects=(FRICTION, Inertia(mass=masses)))
    single = [
        simulate_batch(**given, effects=(FRICTION, Inertia(mass=m))).rod_angle[0] for m in masses
    ]
    assert (batch.rod_angle == np.array(single)).all()
    assert len(set(batch.rod_angle.values)) == 3


def test_results_do_not_depend_on_the_threads(monkeypatch):
    scenes = random_scenes(400, 7)
    found = []
    for threads in (1, 2):
        monkeypatch.setattr("numba.config.NUMBA_NUM_THREADS", threads)
        found.append(simulate_batch(**scenes))
    xr.testing.assert_identical(*found)


def test_every_variable_has_a_unit_and_a_name():
    found = simulate_batch(**REFERENCES, samples=2)
    assert all({"units", "long_name"} <= set(v.attrs) for v in found.variables.values())


def test_a_batch_shows_progress_on_demand(capsys):
    given = {"rod_length": [2.0, 3.0], "rod_angle": 1.0, "friction_coefficient": 1.0}
    simulate_batch(**given, velocity=(0.0, 1.0), duration=0.1, progress=True)
    assert "scene" in capsys.readouterr().err
    simulate_batch(**given, velocity=(0.0, 1.0), duration=0.1)
    assert capsys.readouterr().err == ""
