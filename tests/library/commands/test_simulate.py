"""The command `simulate`, with right and with wrong input."""

import json

import h5py
import numpy as np
import pytest

from pulling_by_pushing.study.store import read_dataset

PULLING = "workflow/scenes/pulling.yaml"

PLAIN = "workflow/scenes/figure_08.yaml"


def test_simulate_follows_the_section_of_the_scene(log):
    found = read_dataset(log)
    assert found.attrs["finished"] == 1
    assert found.attrs["on_ambiguity"] == "keep-contact"
    assert found.sizes["time"] == 103
    assert float(found.rod_angle[-1]) == pytest.approx(57.8963844332054, abs=1e-9)


def test_an_option_takes_the_place_of_the_section(run, tmp_path):
    path = tmp_path / "log.nc"
    options = ("--on-ambiguity", "separate", "--json")
    code, out, _ = run("simulate", PULLING, "-o", str(path), *options)
    told = json.loads(out)
    assert (code, told["time"], told["stopped"]) == (0, 2.5, "")
    assert [(each["time"], each["mode"]) for each in told["modes"]] == [
        (0.0, "STICK"),
        (0.4, "SEPARATE"),
        (pytest.approx(0.425, abs=1e-15), "SEPARATE"),  # the contact has opened
    ]
    assert told["modes"][2]["consistent"] == 1
    assert told["modes"][1]["consistent"] > 1
    assert told["gap"] == pytest.approx(2.1 * np.sin(np.deg2rad(20)), abs=1e-12)


def test_a_side_is_flush_and_turns_off(run, tmp_path):
    scene, path = "workflow/scenes/box_side.yaml", tmp_path / "log.nc"
    code, out, _ = run("simulate", scene, "-o", str(path), "--json")
    told = json.loads(out)
    assert (code, told["stopped"], told["flush"]) == (0, "", False)
    assert [(each["mode"], each["flush"]) for each in told["modes"]] == [
        ("STICK", True),
        ("SLIP_LEFT", True),
        ("SLIP_RIGHT", False),
        ("STICK", False),
    ]


def test_the_options_alone_make_a_simulation(run, tmp_path):
    path = tmp_path / "log.nc"
    options = ("--pusher-angle", "165", "--duration", "3", "--samples", "5", "--rtol", "1e-9")
    code, out, err = run("simulate", PLAIN, "-o", str(path), *options, "--no-progress")
    assert (code, err) == (0, "")
    assert "slip [length]: 2.151415744" in out
    assert "mode: SLIP_RIGHT" in out


def test_twice_the_speed_takes_half_the_time(run, tmp_path):
    slips = []
    for speed, duration in (("1", "2"), ("2", "1")):
        path = tmp_path / f"{speed}.nc"
        options = ("--pusher-angle", "165", "--pusher-speed", speed, "--duration", duration)
        run("simulate", PLAIN, "-o", str(path), *options)
        with h5py.File(path) as found:
            slips.append(found["slip"][-1])
    assert slips[0] == pytest.approx(slips[1], abs=1e-9)


WORLD = """\
slider: {rod_length: 2, rod_angle: 70}
contact: {law: coulomb, friction_coefficient: 0.5}
effects: [{type: ring_friction}]
simulate:
  waypoints: [{time: 0, x: 5, y: 5}, {time: 2, x: 3, y: 5}]
  pusher_frame: world
  object_pose: {x: 0, y: 0, angle: 160}
  until: {pusher_distance: 0.5, rotation: 80}
  duration: 9
"""


def test_waypoints_in_the_world_until_a_distance(run, tmp_path):
    """Without a placement the pose is that of the body frame: the fence is along y, the pusher along -x."""
    scene, path = tmp_path / "world.yaml", tmp_path / "log.nc"
    scene.write_text(WORLD, encoding="utf-8")
    code, out, _ = run("simulate", str(scene), "-o", str(path), "--json")
    told = json.loads(out)
    assert (code, told["stopped"]) == (0, "until: rotation 1.3962634016 or pusher_distance 0.5")
    assert told["time"] == pytest.approx(0.5, abs=1e-12)
    with h5py.File(path) as found:
        moved = found["pusher_position"][-1] - found["pusher_position"][0]
        assert moved == pytest.approx([-0.5, 0], abs=1e-12)
        assert found["pusher"][-1] == pytest.approx([0, 0.5], abs=1e-12)
    code, out, _ = run("simulate", str(scene), "-o", str(path), "--json", "--pusher-angle", "180")
    assert json.loads(out)["position"] == pytest.approx(told["position"], abs=1e-9)


#: The rod falls onto the fence, where the slider's center arrives before the end.
FALLING = "slider: {rod_length: 2, rod_angle: 15}", "--pusher-angle", "90", "--duration", "9"


@pytest.mark.filterwarnings("always::planar_pushing.EarlyEndWarning")
def test_an_early_stop_is_called_a_stop(run, tmp_path, caplog):
    scene, path = tmp_path / "falling.yaml", tmp_path / "log.nc"
    slider, *options = FALLING
    contact = "contact: {law: coulomb, friction_coefficient: 0.5}"
    effects = "effects: [{type: ring_friction}]"
    scene.write_text("\n".join([slider, contact, effects]), encoding="utf-8")
    code, out, err = run("simulate", str(scene), "-o", str(path), *options)
    assert err.count("EarlyEndWarning: the run ended at time") == 1
    time = read_dataset(path).attrs["stopped_time"]
    assert f"stopped at t = {time:.6g}: the slider's center comes down to the fence\n" in out
    assert (code, out.count("stopped")) == (0, 1)
    assert run("animate", str(path), "-o", str(tmp_path / "log.gif"), "--frames", "2")[0] == 0
    words = f"stopped at t = {time:.6g}: the slider's center comes down to the fence"
    assert caplog.messages == [words]


@pytest.mark.parametrize(("scene", "units"), [
    (PULLING, ("time", "length")), ("workflow/scenes/box_side.yaml", ("s", "m")),
], ids=["scaled", "own units"])  # fmt: skip
def test_numbers_have_the_units_of_the_log(run, tmp_path, scene, units):
    out = run("simulate", scene, "-o", str(tmp_path / "log.nc"))[1]
    names = [line.strip().partition(": ")[0] for line in out.splitlines()]
    time, length = units
    quantities = [f"{name} [{length}]" for name in ("position", "slip", "gap")]
    assert names[:6] == ["written", f"time [{time}]", "rod_angle [degree]", *quantities]
    assert names.count(f"time [{time}]") == 1 + names.count("mode")
    assert {"consistent", "modes:"} < set(names)


def test_a_run_to_its_end_has_no_such_line(run, tmp_path):
    assert "stopped" not in run("simulate", PULLING, "-o", str(tmp_path / "log.nc"))[1]


FINGER = """\
slider: {rod_length: 2, rod_angle: 70, side: [-1, 0.2]}
contact: {law: coulomb, friction_coefficient: 0.1}
effects:
  - type: support_friction
    support: {shape: polygon, vertices: [[1, 1], [-1, 1], [-1, -1], [1, -1]]}
simulate: {pusher_angle: 68, pusher_shape: finger, duration: 0.7}
"""


def test_a_finger_leaves_the_side_of_the_scene(run, tmp_path):
    scene, path = tmp_path / "finger.yaml", tmp_path / "log.nc"
    scene.write_text(FINGER, encoding="utf-8")
    code, out, _ = run("simulate", str(scene), "-o", str(path), "--json")
    told = json.loads(out)
    assert (code, told["time"], told["parted"]) == (0, 0.7, True)
    assert [each["mode"] for each in told["modes"]] == ["SLIP_LEFT", "SEPARATE"]
    assert told["contact_position"] > 0.2
    with h5py.File(path) as found:
        assert found.attrs["pusher_shape"] == "finger"
        assert json.loads(found.attrs["scene"])["slider"]["side"] == [-1.0, 0.2]
        assert "contact_position" in found
    run("simulate", str(scene), "-o", str(path), "--pusher-shape", "fence")
    with h5py.File(path) as found:
        assert "contact_position" not in found


def test_the_radius_of_a_finger(run, tmp_path):
    scene, path = tmp_path / "finger.yaml", tmp_path / "log.nc"
    text = FINGER.replace("finger,", "finger, pusher_radius: 0.4,").replace("0.2]", "2]")
    scene.write_text(text, encoding="utf-8")
    told = []
    for given, radius in (((), 0.4), (("--pusher-radius", "0"), 0)):
        code, out, _ = run("simulate", str(scene), "-o", str(path), "--json", *given)
        with h5py.File(path) as found:
            assert (code, found.attrs.get("pusher_radius", 0)) == (0, radius)
        told.append(json.loads(out)["contact_position"])
    assert len(set(told)) == 2
    assert run("simulate", str(scene), "-o", str(path), "--pusher-shape", "fence")[0] == 0
    code, _, said = run("simulate", str(scene), "-o", str(path), "--pusher-radius", "-1")
    assert code != 0
    assert "pusher_radius: -1.0 given; allowed: a finite number >= 0; give the radius" in said


def test_progress_is_shown_when_asked_for(run, tmp_path):
    path = tmp_path / "log.nc"
    _, out, err = run("simulate", PULLING, "-o", str(path), "--progress")
    assert "2.5" in err
    assert out.startswith(f"written: {path}\n")


WRONG = [
    (["simulate", "none.yaml", "-o", "log.nc"],
     "none.yaml: no such file; give the path of a YAML"),
    (["simulate", PULLING, "-o", "log.txt"],
     "output: 'log.txt' given; allowed: a name ending in .nc or .h5; rename the file"),
    (["simulate", PLAIN, "--pusher-angle", "1", "-o", "log.nc"],
     f"duration: missing; allowed: as options, or in a section simulate of {PLAIN}; type for example "
     "--duration 3, or write simulate: {duration: 3} into the file"),
    (["simulate", PLAIN, "--duration", "1", "-o", "log.nc"],
     f"pusher_angle: missing; allowed: as options, or in a section simulate of {PLAIN}; type "),
    (["simulate", PLAIN, "-o", "log.nc"], "pusher_angle, duration: missing; "),
    (["simulate", PULLING, "--on-ambiguity", "both", "-o", "log.nc"],
     "on_ambiguity: 'both' given; allowed: 'keep-contact', 'separate', 'stay-in-mode', 'stick', "
     "'slip-right' or 'slip-left'; "),
    (["simulate", PULLING, "--pusher-angle", "nan", "-o", "log.nc"],
     "pusher_angle: nan given; allowed: a finite number of degrees"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "said"), WRONG)
def test_wrong_input(refused, arguments, said):
    refused(arguments, said)
