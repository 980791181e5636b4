"""The command `solve`, with right and with wrong input."""

import json

import numpy as np
import pytest

import planar_pushing as pp

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
    assert told["solutions"][0]["center"][1] == "inf"
    for one, solution in zip(told["solutions"], found, strict=True):
        assert one["mode"] == solution.mode.name
        assert one["force"] == pytest.approx(solution.force, abs=0)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["solve", "none.yaml", "--pusher-angle", "1"],
         "none.yaml: no such file; give the path of a YAML file"),
        (["solve", SCENE, "--pusher-angle", "nan"],
         "pusher_angle: nan given; allowed: a finite number of degrees"),
        (["solve", SCENE, "--pusher-angle", "1", "--pusher-magnitude", "-1"],
         "pusher_magnitude: -1.0 given; allowed: a finite number > 0"),
    ],
)  # fmt: skip
def test_wrong_input(refused, arguments, said):
    refused(arguments, said)
