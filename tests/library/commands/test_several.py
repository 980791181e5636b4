"""The commands with a scene file of several contacts, and what they refuse."""

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp

FINGERS = "workflow/scenes/two_fingers.yaml"
CORNER = "workflow/scenes/finger_in_a_corner.yaml"
WEDGED = """\
object: {outline: [[-0.15, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]]}
contacts:
  - {point: [-0.15, 0.02], law: coulomb, friction_coefficient: 0.5, velocity: [0.1, 0]}
  - {point: [0.15, -0.05], law: coulomb, friction_coefficient: 0.5}
effects: [{type: support_friction}]
"""


def test_solve(run):
    code, out, err = run("solve", FINGERS)
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[:4] == ["outcome: UNIQUE", "status: CONSISTENT", "solutions:", "  1:"]
    assert "    twist: 0.01 0.09 -0.1" in lines
    head, first, second = (line.split() for line in lines[-3:])
    columns = "contact mode f_x f_y f_end_x f_end_y u_x u_y gap_rate"
    assert head == columns.split()
    assert first[:2] == ["1", "STICK"]
    assert second[:2] == ["2", "STICK"]
    assert not [line for line in lines if line != line.rstrip()]


def test_solve_json(run):
    """The numbers are those of `solve_contacts` with the velocities of the pushers."""
    box = [(-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)]
    contacts = [
        pp.Contact((x, -0.1), law=pp.Coulomb(0.5), velocity=(0, speed))
        for x, speed in ((-0.1, 0.1), (0.1, 0.08))
    ]
    effects = [pp.SupportFriction(support=pp.Polygon(box), weight=3.53)]
    (solution,) = pp.solve_contacts(contacts, effects=effects, outline=box)
    (entry,) = json.loads(run("solve", FINGERS, "--json")[1])["solutions"]
    assert entry["twist"] == pytest.approx(solution.twist.tolist())
    for name, values in (("force", solution.forces), ("force_end", solution.forces_end)):
        assert [one[name] for one in entry["contacts"]] == pytest.approx(values.round(12))
    assert entry["center"] == pytest.approx([0.9, -0.1])


def test_a_wedged_object_has_a_reason_and_no_solution(run, tmp_path):
    path = tmp_path / "wedged.yaml"
    path.write_text(WEDGED, encoding="utf-8")
    code, out, _ = run("solve", str(path))
    assert code == 0
    assert "reason: WEDGED" in out
    assert json.loads(run("solve", str(path), "--json")[1])["solutions"] == []


def test_simulate_writes_a_log_over_contacts(run, tmp_path):
    path = tmp_path / "log.nc"
    code, out, err = run("simulate", FINGERS, "-o", str(path), "--samples", "5")
    assert (code, err) == (0, "")
    assert "object_angle [degree]: -11.3099" in out
    assert "contact: pusher_0 pusher_1" in out
    with xr.open_dataset(path, engine="h5netcdf") as log:
        assert log["force"].dims == ("time", "contact", "xy")
        assert list(log["contact"].values) == ["pusher_0", "pusher_1"]
        # The fingers keep their distance of 0.2, and one is 0.04 ahead: the side is along both.
        assert float(log.object_angle[-1]) == pytest.approx(-np.rad2deg(np.arctan2(0.04, 0.2)))
    summary = json.loads(run("simulate", FINGERS, "-o", str(path), "--json", "--step", "0.2")[1])
    assert summary["time"] == 2.0
    assert summary["modes"][0]["mode"] == ["STICK", "STICK"]
    assert summary["object_angle"] == pytest.approx(-11.31, abs=0.1)


@pytest.mark.filterwarnings("always::planar_pushing.EarlyEndWarning")
def test_a_run_that_wedges_says_so(run, tmp_path):
    text = WEDGED.replace(", velocity: [0.1, 0]", "")
    motion = (
        "simulate: {pushers: [{shape: finger, angle: 90}, {shape: finger, angle: 90, speed: 0}], "
    )
    (tmp_path / "a.yaml").write_text(f"{text}{motion}duration: 1}}\n", encoding="utf-8")
    code, out, err = run("simulate", str(tmp_path / "a.yaml"), "-o", str(tmp_path / "log.nc"))
    assert code == 0
    assert "wedged" in out
    assert err.startswith(
        "planar-pushing simulate: EarlyEndWarning: the run ended at time 0 of 1: "
    )
    assert err.count("\n") == 1


@pytest.mark.parametrize("scene", [FINGERS, CORNER])
def test_draw(run, tmp_path, scene):
    path = tmp_path / "scene.svg"
    assert run("draw", scene, "-o", str(path)) == (0, f"written: {path}\n", "")
    assert path.stat().st_size > 5000


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["solve", FINGERS, "--pusher-angle", "90"], "pusher_angle: 90.0 given; allowed: none with contac"),
        (["solve", FINGERS, "--pusher-angle", "0:90:30"], "pusher_angle: (0.0, 30.0, 60.0, 90.0) given"),
        (["solve", FINGERS, "--pusher-magnitude", "2"], "pusher_magnitude: 2.0 given; allowed: none"),
        (["draw", FINGERS, "--limit-curve", "-o", "NEW.svg"], "limit_curve: True given; allowed: none"),
        (["draw", FINGERS, "--force-angle", "3", "-o", "NEW.svg"], "force_angle: 3.0 given; allowed: none"),
        (["simulate", FINGERS, "--method", "time-stepping", "-o", "NEW.nc"],
         "method: 'time-stepping' given; allowed: none with contacts in the scene file; leave it out; --s"),
        (["simulate", FINGERS, "--pusher-shape", "fence", "-o", "NEW.nc"], "pusher_shape: 'fence' given"),
        (["simulate", FINGERS, "--step", "0", "-o", "NEW.nc"], "step: 0.0 given; allowed: a finite number"),
        (["simulate", FINGERS, "--duration", "-1", "-o", "NEW.nc"], "duration: -1.0 given; allowed: a"),
        (["simulate", FINGERS, "--on-ambiguity", "any", "-o", "NEW.nc"], "on_ambiguity: 'any' given"),
        (["simulate", FINGERS, "-o", "NEW.txt"], "output: "),
        (["cone", FINGERS], f"{FINGERS}: contacts: "),
    ],
)  # fmt: skip
def test_what_is_of_one_pusher_is_refused(refused, tmp_path, arguments, said):
    words = [str(tmp_path / word) if word.startswith("NEW") else word for word in arguments]
    refused(words, said)
    assert not list(tmp_path.iterdir())


SQUEEZE = WEDGED.replace("0.15, -0.05]", "0.15, 0.02], velocity: [0.1, 0]")
OVERLAP = (
    WEDGED.replace(", velocity: [0.1, 0]", "")
    + """\
simulate:
  pushers: [{shape: finger, angle: 90}, {shape: finger, angle: 90}]
  walls: [{point: [0, 0], normal: [0, 1], contact: {law: perfectly_rough}}]
  duration: 1
"""
)


@pytest.mark.parametrize(
    ("command", "text", "said"),
    [
        ("simulate", WEDGED, "simulate: None given; allowed: a section of the scene file"),
        ("solve", SQUEEZE, "contacts: 'a squeeze between "),
        ("draw", SQUEEZE, "contacts: 'a squeeze between "),
        ("simulate", OVERLAP, "walls: 'an overlap of 0.1 of wall 0 with the object' given"),
    ],
)
def test_what_only_a_solver_can_refuse_names_the_file(refused, tmp_path, command, text, said):
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    output = {"solve": (), "draw": ("-o", str(tmp_path / "a.svg"))}
    words = output.get(command, ("-o", str(tmp_path / "log.nc")))
    refused([command, str(path), *words], f"{path}: {said}")
    assert [found.name for found in tmp_path.iterdir()] == ["scene.yaml"]


def test_a_log_of_several_contacts_is_no_animation(run, refused, tmp_path):
    path = tmp_path / "log.nc"
    assert run("simulate", CORNER, "-o", str(path), "--samples", "3")[0] == 0
    said = f"{path}: a log of several contacts; allowed: a log of one contact; plot its variables"
    refused(["animate", str(path), "-o", str(tmp_path / "a.gif")], said)


def words_of(text):
    """The numbers of a scene file, as they are written."""
    words = text.replace(",", " ").replace("}", " ").split()
    return [word for word in words if word[-1].isdigit()]


GARBAGE = ("{}", "1e999", "null")
WORDS = words_of(Path(FINGERS).read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    "every",
    [False, pytest.param(True, marks=pytest.mark.slow)],
    ids=["one of three for each value", "all for each value"],
)
def test_garbage_is_refused_in_one_line(run, tmp_path, every):
    """Each value of the file in turn is replaced by what it cannot be; the line names the file."""
    text, path = Path(FINGERS).read_text(encoding="utf-8"), tmp_path / "scene.yaml"
    for number, word in enumerate(WORDS):
        for instead in GARBAGE if every else (GARBAGE[number % len(GARBAGE)],):
            parts = text.split(word)
            path.write_text(f"{parts[0]}{instead}{word.join(parts[1:])}", encoding="utf-8")
            code, out, err = run("solve", str(path))
            lines = err.splitlines()
            assert code in (0, 2), (number, word, instead)
            assert all(line.startswith(("planar-pushing solve: ", str(path))) for line in lines), (
                err
            )
            assert (code == 0) == bool(out)
