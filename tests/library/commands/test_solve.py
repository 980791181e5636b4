"""The command `solve`, with right and with wrong input."""

import json

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.commands import main
from planar_pushing.commands.words import angles

SCENE = "workflow/scenes/figure_03.yaml"


def test_solve(run):
    code, out, _ = run("solve", SCENE, "--pusher-angle", "-20")
    assert code == 0
    assert out.startswith("outcome: AMBIGUOUS\n")
    assert [line.split()[1] for line in out.splitlines() if "mode:" in line] == [
        "SEPARATE",
        "STICK",
        "SLIP_LEFT",
    ]


def test_solve_json(run):
    code, out, _ = run("solve", SCENE, "--pusher-angle", "-20", "--json")
    found = pp.solve(pp.load_scene(SCENE), np.deg2rad(-20))
    told = json.loads(out)
    assert (code, told["outcome"], len(told["solutions"])) == (0, "AMBIGUOUS", 3)
    assert told["solutions"][0]["center"] is None
    assert told["solutions"][1]["pivot"] is None
    for one, solution in zip(told["solutions"], found, strict=True):
        assert one["mode"] == solution.mode.name
        assert one["force"] == pytest.approx(solution.force, abs=0)


SIDE = """
object:
  outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]
  contact: {side: 0}
contact: {law: coulomb, friction_coefficient: 0.5}
effects: [{type: support_friction}]
"""


def test_a_side_on_the_fence(run, tmp_path):
    file = tmp_path / "box.yaml"
    file.write_text(SIDE)
    code, out, _ = run("solve", str(file), "--pusher-angle", "90")
    (one,) = blocks(out)
    assert (code, one["flush"], one["force_position"]) == (0, "True", "0")
    assert (one["force_at_start"], one["force_at_start_high"]) == ("-0.25 0.5", "0.25 0.5")
    _, out, _ = run("solve", str(file), "--pusher-angle", "30:90:60")
    assert out.splitlines()[0].split()[-4:] == ["flush", "force_at", "n_start", "n_end"]
    assert out.splitlines()[1].split()[-4:] == ["flush", "-0.5", "0.67082", "0.223607"]
    _, out, _ = run("solve", str(file), "--pusher-angle=-90", "--json")
    assert json.loads(out)["solutions"][0]["force_position"] is None
    code, _, error = run("cone", str(file))
    assert code == 2
    assert (
        "a side that lies on the fence' given; allowed: a scene with a contact at one point"
        in error
    )


TRIPOD = "workflow/scenes/tripod.yaml"
FOUR = """
slider: {rod_length: 1, rod_angle: 90}
contact: {law: infinite_friction, at_zero_normal: free}
effects:
  - type: support_friction
    weight: 1
    support: {shape: points, positions: [[1, 1], [-1, 1], [-1, -1], [1, -1]], weights: [1, 1, 1, 1]}
  - {type: inertia, mass: 1, gyration_radius: 1}
"""


def blocks(out):
    """The solutions in the text, each by its keys."""
    found = []
    for line in out.splitlines():
        key, _, value = line.strip().partition(": ")
        if key == "mode":
            found.append({})
        if line.startswith("    "):
            found[-1][key] = value
    return found


def test_a_pivot_shows_both_ends_of_its_forces(run):
    """Pushed across the radius of a foot the tripod turns about that foot under an interval of forces."""
    scene = pp.load_scene(TRIPOD)
    (found,) = pp.solve(scene, np.deg2rad(135))
    assert found.pivot == 0
    code, out, _ = run("solve", TRIPOD, "--pusher-angle", "135")
    assert code == 0
    assert "status: PIVOTS" in out.splitlines()
    (block,) = blocks(out)
    assert block["pivot"] == "0"
    for name in ("force", "force_end"):
        numbers = [float(word) for word in block[name].split()]
        assert numbers == pytest.approx(getattr(found, name), rel=1e-11, abs=1e-12)
    assert block["force"] != block["force_end"]
    out = run("solve", TRIPOD, "--pusher-angle", "135", "--json")[1]
    assert json.loads(out)["solutions"][0]["force_end"] == pytest.approx(found.force_end)


def test_what_does_not_pivot_shows_one_force_and_at_rest_no_center(run):
    separate, stick, _ = blocks(run("solve", SCENE, "--pusher-angle", "-20")[1])
    assert "force_end" not in stick
    assert (stick["pivot"], stick["continuum"]) == ("none", "False")
    assert (separate["center"], separate["force"], separate["twist"]) == ("none", "0 0", "0 0 0")


def test_a_continuum_is_shown(run, tmp_path):
    path = tmp_path / "four.yaml"
    path.write_text(FOUR, encoding="utf-8")
    code, out, _ = run("solve", str(path), "--pusher-angle", "0")
    assert code == 0
    assert [(each["mode"], each["continuum"]) for each in blocks(out)] == [
        ("SEPARATE", "False"),
        ("STICK", "True"),
    ]
    assert "continuum" in run("solve", str(path), "--pusher-angle", "0:0:1")[1]


def test_rounding_errors_are_printed_as_zero(run):
    """Of a push along the normal the motion along the fence, and of one along it the center's place."""
    many = run("solve", SCENE, "--pusher-angle", "7290", "--json")[1]
    assert many == run("solve", SCENE, "--pusher-angle", "90", "--json")[1].replace(" 90", " 7290")
    out = run("solve", SCENE, "--pusher-angle", "0:180:15")[1]
    assert "e-1" not in out
    for angle in ("0", "90", "180"):
        for block in blocks(run("solve", SCENE, "--pusher-angle", angle)[1]):
            words = " ".join(block[name] for name in ("force", "contact_motion", "twist", "center"))
            assert "e-1" not in words
            assert "-0 " not in f"{words} "


def test_without_an_angle_the_push_is_that_of_the_file(run):
    code, out, _ = run("solve", TRIPOD)
    assert code == 0
    assert "pusher_angle: 90" in out.splitlines()
    assert out == run("solve", TRIPOD, "--pusher-angle", "90")[1]
    told = json.loads(run("solve", TRIPOD, "--pusher-magnitude", "2", "--json")[1])
    assert (told["pusher_angle"], told["pusher_magnitude"]) == (90, 2)


def test_an_angle_beyond_two_turns_is_one_of_degrees(run):
    far, near = (
        json.loads(run("solve", SCENE, "--pusher-angle", a, "--json")[1]) for a in ("1050", "330")
    )
    assert [each["mode"] for each in far["solutions"]] == [
        each["mode"] for each in near["solutions"]
    ]


def test_a_range_is_a_table(run):
    code, out, _ = run("solve", SCENE, "--pusher-angle", "-20:100:60")
    assert code == 0
    head, *rows = (line.split() for line in out.splitlines())
    assert head == [
        "angle", "mode", "f_x", "f_y", "u_x", "u_y", "v_x", "v_y", "omega", "center_x", "center_y",
    ]  # fmt: skip
    expected = []
    scene = pp.load_scene(SCENE)
    for degrees in (-20, 40, 100):
        expected += [(degrees, each) for each in pp.solve(scene, np.deg2rad(degrees))]
    assert len(rows) == len(expected) > 3
    for row, (degrees, solution) in zip(rows, expected, strict=True):
        assert row[:2] == [str(degrees), solution.mode.name]
        numbers = [float(word) for word in row[2:9]]
        own = [*solution.force, *solution.contact_motion, *solution.twist]
        assert numbers == pytest.approx(own, rel=1e-5, abs=1e-11)
        assert (row[9] == "none") == np.isnan(solution.center[0])


def test_a_range_in_json_has_every_push(run):
    told = json.loads(run("solve", SCENE, "--pusher-angle=-20:100:60", "--json")[1])["pushes"]
    assert [each["pusher_angle"] for each in told] == [-20, 40, 100]
    assert told[0] == json.loads(run("solve", SCENE, "--pusher-angle", "-20", "--json")[1])


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ("0:1:0.1", np.arange(11) * 0.1), ("90:-90:-45", [90, 45, 0, -45, -90]),
        ("0:100:30", [0, 30, 60, 90]), ("5:5:1", [5]), ("-.5:.5:1", [-0.5, 0.5]),
    ],
)  # fmt: skip
def test_angles_of_a_range(given, found):
    assert angles(given) == pytest.approx(found, abs=0, rel=1e-15)


def test_a_push_without_a_solution_has_a_row(run, tmp_path):
    path = tmp_path / "none.yaml"
    text = FOUR.replace("free", "none").split("  - type: support_friction")[0]
    slider = text.replace("rod_length: 1, rod_angle: 90", "rod_length: 2, rod_angle: 45")
    path.write_text(f"{slider}  - {{type: ring_friction, weight: 1}}\n", encoding="utf-8")
    rows = run("solve", str(path), "--pusher-angle", "165:166:1")[1].splitlines()
    assert [row.split()[:2] for row in rows[1:]] == [
        ["165", "INCONSISTENT"],
        ["166", "INCONSISTENT"],
    ]


@pytest.mark.parametrize("given", ["0:10", "0:10:-1", "0:10:0", "0:1e9:1e-9", "east"])
def test_no_range(capsys, given):
    with pytest.raises(SystemExit, match="2"):
        main(["solve", SCENE, "--pusher-angle", given])
    said = capsys.readouterr().err
    assert said.startswith(
        f"planar-pushing solve: argument --pusher-angle: '{given}' given; allowed:"
    )
    assert "START:STOP:STEP" in said
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["solve", "none.yaml", "--pusher-angle", "1"],
         "none.yaml: no such file; give the path of a YAML file"),
        (["solve", SCENE],
         "pusher_angle: missing; allowed: the option --pusher-angle, or a section simulate in the scene "
         "file; type --pusher-angle 90"),
        (["solve", SCENE, "--pusher-angle", "nan"],
         "pusher_angle: nan given; allowed: a finite number of degrees"),
        (["solve", SCENE, "--pusher-angle", "1", "--pusher-magnitude", "-1"],
         "pusher_magnitude: -1.0 given; allowed: a finite number > 0"),
    ],
)  # fmt: skip
def test_wrong_input(refused, arguments, said):
    refused(arguments, said)


def test_a_pivot_has_the_name_of_its_foot(run, tmp_path):
    """The stool of the examples, pushed at its first foot."""
    content = """\
object:
  feet:
    - {position: [-1, 0], name: near}
    - {position: [0.5, 0.8660254037844386], name: left}
    - {position: [0.5, -0.8660254037844386], name: right}
  contact: {point: [-1, 0], normal: [0.8660254037844386, 0.5]}
contact: {law: coulomb, friction_coefficient: 0.5}
effects: [{type: support_friction}]
"""
    path = tmp_path / "stool.yaml"
    path.write_text(content, encoding="utf-8")
    (found,) = json.loads(run("solve", str(path), "--pusher-angle", "120", "--json")[1])[
        "solutions"
    ]
    assert (found["pivot"], found["foot"]) == (2, "right")
    assert "right" in run("solve", str(path), "--pusher-angle", "110:120:10")[1]
    assert "foot" not in run("solve", "workflow/scenes/stool.yaml", "--pusher-angle", "120")[1]
