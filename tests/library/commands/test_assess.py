"""The command `assess`: its table, its file, its candidates, and wrong input."""

import json

import pytest

from planar_pushing.terms.netcdf import group_names

SCENE = """\
title: A box
object:
  outline: [[-0.15, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]]
  contact: {point: [0.04, -0.1]}
contact: {law: coulomb, friction_coefficient: 0.5}
effects:
  - {type: support_friction, weight: 3.5303940000000003}
simulate:
  pusher_shape: finger
  pusher_angle: 90
  pusher_speed: 0.05
  duration: 1.6
  candidates:
    - {type: inertia, mass: 1.2}
    - {type: viscous, coefficient: 0.5}
units: {length: m, force: N, time: s}
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE)
    return path


def test_the_table_and_the_file(run, scene, tmp_path):
    output = tmp_path / "assessment.nc"
    options = ("--tolerance", "0.001", "--candidate", "inertia", "-o", str(output))
    code, out, err = run("assess", str(scene), *options)
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == f"written: {output}"
    assert lines[1].startswith("effect")
    # The check value of this push, in millimeters.
    (inertia,) = [line.split() for line in lines if line.startswith("inertia  ")]
    assert inertia[3:6] == ["0.5", "0.898", "0.756"]
    assert "viscous" not in out
    assert group_names(output) == ["effects", "inputs", "methods"]


def test_one_candidate_as_json(run, scene):
    code, out, err = run("assess", str(scene), "--candidate", "inertia", "--json")
    assert (code, err) == (0, "")
    answer = json.loads(out)
    assert [row["effect"] for row in answer["effects"]] == ["support_friction", "inertia"]
    assert answer["needed"] == ["support_friction"]
    assert answer["tolerance"] == pytest.approx(0.01 * 0.13**0.5)
    assert len(answer["inputs"]) == 5
    assert answer["settings"]
    assert answer["effects"][1]["pose_change"] == pytest.approx(0.756355e-3, rel=1e-5)


@pytest.mark.parametrize(
    ("written", "instead", "arguments", "said"),
    [
        ("", "", ("--candidate", "inerta"),
         "candidate: 'inerta' given; allowed: inertia, viscous; did you mean inertia?"),
        ("", "", ("--tolerance", "-1"),
         "tolerance: -1.0 given; allowed: a finite number > 0; give a length"),
        ("", "", ("-o", "assessment.txt"),
         "output: 'assessment.txt' given; allowed: a name ending in .nc or .h5; rename the file"),
        ("  duration: 1.6\n", "  duration: 1.6\n  initial_gap: 0.1\n", (),
         "{scene}: simulate.initial_gap: 0.1 given; allowed: a push from rest and in contact, without "
         "this key; take it out: the push itself is assessed"),
        ("  duration: 1.6\n", "  duration: 1.6\n  on_ambiguity: separate\n", (),
         "{scene}: simulate.on_ambiguity: 'separate' given; allowed: a push from rest and in contact, "
         "without this key; take it out: the push itself is assessed"),
        (SCENE[SCENE.index("simulate") : SCENE.index("units")], "", (),
         "{scene}: simulate: None given; allowed: a section of the scene file; add it to the file"),
    ],
)  # fmt: skip
def test_wrong_input(run, scene, written, instead, arguments, said):
    scene.write_text(SCENE.replace(written, instead, 1) if written else SCENE)
    code, out, err = run("assess", str(scene), *arguments)
    assert (code, out) == (2, "")
    assert err == f"planar-pushing assess: {said.format(scene=scene)}\n"


def test_a_pusher_in_the_world(run, scene):
    """The box lies turned by 90 degrees, and so is the push: the assessment is the same."""
    code, plain, _ = run("assess", str(scene), "--json")
    turned = "pusher_angle: 180\n  pusher_frame: world\n  object_pose: {x: 3, y: 1, angle: 90}"
    scene.write_text(SCENE.replace("pusher_angle: 90", turned))
    again, moved, _ = run("assess", str(scene), "--json")
    assert code == again == 0
    one, other = (json.loads(text)["effects"] for text in (plain, moved))
    for row, twin in zip(one, other, strict=True):
        assert row["pose_change"] == pytest.approx(twin["pose_change"], rel=1e-6)
