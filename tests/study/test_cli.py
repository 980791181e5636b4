"""The command line, with right and with wrong input."""

import json
import subprocess
import sys

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.commands import main
from planar_pushing.study.builders import build_dataset
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

SCENE = "workflow/scenes/figure_03.yaml"


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    study = load_study("workflow/config/smoke.yaml")
    values = study_slice(study, "motion_cones")
    write_dataset(build_dataset("motion_cones", values), folder / "data/motion_cones.nc")
    return str(folder)


def run(capsys, *arguments):
    code = main(list(arguments))
    said = capsys.readouterr()
    return code, said.out, said.err


def test_solve(capsys):
    code, out, _ = run(capsys, "solve", SCENE, "--pusher-angle", "-20")
    assert code == 0
    assert out.startswith("outcome: AMBIGUOUS\n")
    assert [line.split()[1] for line in out.splitlines() if "mode:" in line] == [
        "SEPARATE",
        "STICK",
        "SLIP_LEFT",
    ]


def test_solve_json(capsys):
    code, out, _ = run(capsys, "solve", SCENE, "--pusher-angle", "-20", "--json")
    found = pp.solve(pp.load_scene(SCENE), np.deg2rad(-20))
    told = json.loads(out)
    assert (code, told["outcome"], len(told["solutions"])) == (0, "AMBIGUOUS", 3)
    assert told["solutions"][0]["center"][1] == "inf"
    for one, solution in zip(told["solutions"], found, strict=True):
        assert one["mode"] == solution.mode.name
        assert one["force"] == pytest.approx(solution.force, abs=0)


def test_cone_json(capsys):
    code, out, _ = run(capsys, "cone", SCENE, "--json")
    told = json.loads(out)
    assert code == 0
    assert told["motion_cone"] == pytest.approx([-28.910274893814538, 138.05152762089722], abs=1e-9)
    assert told["pulls"] is True


def test_query(capsys, results):
    words = [
        "--effects",
        "inertia",
        "--rod-length",
        "2",
        "--rod-angle",
        "45",
        "--friction-coefficient",
        "2",
    ]
    code, out, _ = run(capsys, "query", "motion_cones", "--results", results, *words)
    assert code == 0
    assert "effects=inertia, rod_length=2.0" in out
    assert "motion_cone_right [degree]    -14.036243467" in out


def test_query_with_equals_signs(capsys, results):
    words = ["--effects=inertia", "--rod-length=2", "--rod-angle=45", "--friction-coefficient=inf"]
    code, out, _ = run(capsys, "query", "motion_cones", "--results", results, *words)
    assert code == 0
    assert "motion_cone_right [degree]    -33.69006752597" in out


def test_query_of_several_axes_prints_a_table_each(capsys, results):
    code, out, _ = run(capsys, "query", "motion_cones", "--results", results, "--rod-length", "2")
    assert code == 0
    assert out.splitlines()[0] == "rod_length=2.0"
    assert out.count("motion_cone_right [degree]") == 1


def test_query_json(capsys, results):
    words = ["--rod-length", "2", "--friction-coefficient", "inf", "--json"]
    code, out, _ = run(capsys, "query", "motion_cones", "--results", results, *words)
    told = json.loads(out)
    assert code == 0
    assert told["dims"] == {"effects": 3, "rod_angle": 2}
    assert told["coords"]["friction_coefficient"]["data"] == "inf"


def test_draw(capsys, tmp_path):
    path = tmp_path / "scene.svg"
    code, out, _ = run(capsys, "draw", SCENE, "--pusher-angle", "-20", "-o", str(path))
    assert (code, out) == (0, f"written: {path}\n")
    assert path.read_text(encoding="utf-8").lstrip().startswith("<?xml")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["solve", "none.yaml", "--pusher-angle", "1"],
         "planar-pushing solve: none.yaml: no such file; give the path of a YAML file"),
        (["solve", SCENE, "--pusher-angle", "nan"],
         "planar-pushing solve: pusher_angle: nan given; allowed: a finite number of degrees"),
        (["solve", SCENE, "--pusher-angle", "1", "--pusher-magnitude", "-1"],
         "planar-pushing solve: pusher_magnitude: -1.0 given; allowed: a finite number > 0"),
        (["draw", SCENE, "--pusher-angle", "nan", "-o", "scene.svg"],
         "planar-pushing draw: pusher_angle: nan given; allowed: a finite number of degrees"),
        (["draw", SCENE, "--pusher-magnitude", "0", "-o", "scene.svg"],
         "planar-pushing draw: pusher_magnitude: 0.0 given; allowed: a finite number > 0"),
        (["draw", SCENE, "-o", "/dev/null/scene.svg"],
         "planar-pushing draw: /dev/null/scene.svg: cannot be written"),
        (["query", "motion_cones", "--rod-length=2", "--rod-length", "3"],
         "planar-pushing query: query: '--rod-length=2 --rod-length 3' given; allowed: pairs"),
        (["query", "cones"],
         "planar-pushing query: name: 'cones' given; allowed: limit_curves"),
        (["query", "motion_cones", "--rod-lenght", "2"],
         "planar-pushing query: rod_lenght: '2' given; allowed: the axes effects"),
        (["query", "motion_cones", "--rod-length", "7"],
         "planar-pushing query: rod_length: '7' given; allowed: 0, 1, 2, 5; choose a value"),
        (["query", "motion_cones", "--rod-length", "long"],
         "planar-pushing query: rod_length: 'long' given; allowed: a number, or inf"),
        (["query", "motion_cones", "--rod-length"],
         "planar-pushing query: query: '--rod-length' given; allowed: pairs"),
        (["draw", SCENE, "-o", "scene.doc"],
         "planar-pushing draw: output: 'scene.doc' given; allowed: a name ending in .svg"),
        (["draw", SCENE, "--pusher-angle", "1", "--force-angle", "2", "-o", "scene.svg"],
         "planar-pushing draw: pusher_angle, force_angle: (1.0, 2.0) given; allowed: one of them"),
    ],
)  # fmt: skip
def test_wrong_input(capsys, results, arguments, said):
    if arguments[0] == "query":
        arguments = [*arguments, "--results", results] if len(arguments) != 3 else [
            *arguments[:2], "--results", results, *arguments[2:]
        ]  # fmt: skip
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.startswith(said), err
    assert err.count("\n") == 1


def test_unknown_option(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["cone", SCENE, "--rod-length", "2"])
    assert caught.value.code == 2
    assert "unrecognized arguments: --rod-length 2" in capsys.readouterr().err


def test_installed_command():
    done = subprocess.run(
        [sys.executable, "-m", "planar_pushing.commands", "--help"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert "solve" in done.stdout
