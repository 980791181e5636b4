"""A run that ends early says so once, with time, reason and remedy; callers that ask themselves do not."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from simulation.scenes import BOX, FINGER_MEETS, HEAVY, NO_EDGE, NOTCHED, STOPS, box, scene

import planar_pushing as pp
from command_line import run as run
from planar_pushing.simulation.early_end import REASONS, quietly
from planar_pushing.simulation.fields import Stop

LAID_DOWN = (scene(mu=2.0, psi=0.35), pp.Pusher(velocity=(0.2, 1.0)))
MEETS_TWO = (
    box((0.3, -1.0), BOX, HEAVY, mu=0.1, corners=NOTCHED, outlined=True, side=(-1.3, 0.3)),
    pp.Pusher(velocity=(0.9, 0.2), shape="finger", radius=0.2),
)
NO_MOTION = (scene(mu=NO_EDGE), pp.Pusher(velocity=(-1.0, 0.2)))
#: Scene, pusher, reason, and a word of the remedy.
ENDS = {
    "no outline": (*LAID_DOWN, STOPS, "outline"),
    "two contacts": (*MEETS_TWO, FINGER_MEETS, "Inertia"),
    "no mode": (*NO_MOTION, "no contact mode is consistent", "time-stepping"),
}
SCENE_FILE = """
slider: {rod_length: 2, rod_angle: 20, radius: 1}
contact: {law: coulomb, friction_coefficient: 2}
effects: [{type: ring_friction, weight: 1}]
units: {length: mm, force: N, time: s}
simulate: {pusher_angle: 80, duration: 8}
"""


@pytest.mark.parametrize("name", ENDS)
@pytest.mark.parametrize("method", ["event-driven", "time-stepping"])
@pytest.mark.parametrize("streams", [False, True], ids=["memory", "file"])
def test_simulate_says_when_and_why_a_run_ended(name, method, streams, tmp_path):
    given, pusher, reason, remedy = ENDS[name]
    options = {"path": tmp_path / "log.nc"} if streams else {}
    with pytest.warns(pp.EarlyEndWarning) as said:
        log = pp.simulate(given, pusher, duration=9, method=method, **options)
    (warning,) = said
    text = str(warning.message)
    time = log.attrs["stopped_time"]
    assert text.startswith(f"the run ended at time {time:.6g} of 9: {reason}; ")
    assert remedy in text
    assert warning.filename == __file__
    assert log.attrs["stopped"] == reason
    log.close()


@pytest.mark.parametrize("samples", [None, 3])
def test_a_batch_says_once_how_many_runs_ended_and_why(samples):
    """Two end early for one reason, one for another, and one does not."""
    side = np.array([0.7, 0.2, 5.0, 0.7])
    given = scene(
        pp.SupportFriction(support=pp.Disc(1.0)), mu=0.1, psi=np.array([1.2, 0.35, 1.3, 0.5])
    )
    duration = np.array([1e-3, 9, 9, 9]) * np.ones_like(side)
    pusher = pp.Pusher(velocity=(0.2, 1.0))
    with pytest.warns(pp.EarlyEndWarning) as said:
        batch = pp.simulate_batch(given, pusher, duration=duration, samples=samples)
    (warning,) = said
    last = batch.stopped if samples is None else batch.stopped.isel(part=-1)
    assert last.values.tolist() == ["", STOPS, STOPS, STOPS]
    assert str(warning.message).startswith(
        f"3 of 4 runs ended early, see stopped and time: {STOPS}; "
    )
    assert warning.filename == __file__


def test_the_most_frequent_reason_of_a_batch_comes_first():
    laws = np.array([NO_EDGE, pp.Coulomb(2.0), pp.Coulomb(3.0)])
    given = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=np.array([0.8, 0.35, 0.35])), contact=laws,
        effects=(pp.RingFriction(),),
    )  # fmt: skip
    with pytest.warns(pp.EarlyEndWarning, match=f"3 of 3 runs .* in 2 of them, {STOPS}; "):
        pp.simulate_batch(given, pp.Pusher(velocity=(-1.0, 0.5)), duration=30)


QUIET = {
    "until": lambda: pp.simulate(*LAID_DOWN, duration=9, until=pp.Until(distance=0.01)),
    "duration": lambda: pp.simulate(*LAID_DOWN, duration=0.01),
    "batch": lambda: pp.simulate_batch(*LAID_DOWN, duration=0.01),
    "quiet run": lambda: quietly(pp.simulate)(*LAID_DOWN, duration=9),
    "quiet batch": lambda: quietly(pp.simulate_batch)(*LAID_DOWN, duration=9),
}


@pytest.mark.parametrize("call", QUIET.values(), ids=QUIET)
def test_what_ends_as_planned_or_is_asked_quietly_says_nothing(call):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        call()


def test_an_unmet_condition_does_not_hide_an_early_end():
    with pytest.warns(pp.EarlyEndWarning, match=STOPS):
        pp.simulate(*LAID_DOWN, duration=9, until=pp.Until(distance=99))


def test_every_reason_has_a_remedy_of_its_text():
    assert {*REASONS} == {*Stop} - {Stop.NO}
    assert len({reason.text for reason in REASONS.values()}) == len(REASONS)


@pytest.mark.filterwarnings("default::planar_pushing.EarlyEndWarning")
def test_the_command_writes_one_line_and_succeeds(run, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE_FILE)
    words = ["simulate", str(path), "-o", str(tmp_path / "log.nc"), "--no-progress"]
    code, out, err = run(*words)
    assert code == 0
    assert err.count("\n") == 1
    assert err.startswith(
        "planar-pushing simulate: EarlyEndWarning: the run ended at time 0.928833 s of 8 s: "
    )
    assert "stopped at t = 0.928833 s" in out
