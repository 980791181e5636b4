"""The command line as a whole: help, version, completion, and one line for whatever goes wrong."""

import argparse
import re
import shlex
import subprocess
import sys

import pytest

import planar_pushing as pp
from planar_pushing.commands import main, parser

SCENE = "workflow/scenes/figure_03.yaml"
HEAVY = ("numpy", "xarray", "scipy", "pandas", "pydantic", "h5py", "matplotlib")
LIGHT = """
import sys
from planar_pushing.commands import main
try:
    main(sys.argv[1:])
finally:
    print([name for name in {heavy} if name in sys.modules], file=sys.stderr)
"""


def subcommands():
    (action,) = (each for each in parser()._actions if hasattr(each, "choices") and each.choices)
    return action.choices


COMMANDS = subcommands()
OPTIONS = [
    pytest.param(name, action, id=f"{name} {'/'.join(action.option_strings) or action.dest}")
    for name, command in COMMANDS.items() for action in command._actions
]  # fmt: skip


@pytest.mark.parametrize("arguments", [
    ["--help"], ["--version"], ["solve", "--help"], ["query", "--help"], ["completion", "bash"],
    ["solve", "--pusher-angle"], ["solf"],
], ids=" ".join)  # fmt: skip
def test_help_version_and_completion_import_nothing_heavy(arguments):
    ended = subprocess.run(
        [sys.executable, "-c", LIGHT.format(heavy=HEAVY), *arguments],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ended.stderr.endswith("[]\n")


def test_version(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["--version"])
    assert caught.value.code == 0
    assert capsys.readouterr().out == f"planar-pushing {pp.__version__}\n"


@pytest.mark.parametrize(("name", "action"), OPTIONS)
def test_every_option_says_what_it_does_its_range_and_its_default(name, action):
    said = action.help
    assert len(said) >= len("bash or zsh")
    if action.type in (int, float):
        assert re.search(
            r"degrees|units|unit |per time|frames|instants|tolerance|points|cores|splits|\bport\b|\bseed\b",
            said,
        )
        assert re.search(
            r"> 0|\[|\(0, 50\]|finite number|whole number|within the friction cone", said
        )
        assert action.required or "default" in said or "instead of" in said
    if action.default and action.default != argparse.SUPPRESS:
        assert "default" in said


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_an_example_that_it_takes(name):
    example = COMMANDS[name].epilog.splitlines()[-1]
    assert example.startswith(f"example: planar-pushing {name}")
    words = shlex.split(example.partition("planar-pushing ")[2].partition(" > ")[0])
    args, rest = parser().parse_known_args(words)
    assert args.command == name
    assert not rest or name == "query"


@pytest.mark.parametrize(("arguments", "said"), [
    (["cone", SCENE, "--rod-length", "2"], "cone: --rod-length given; allowed: --help, --json; "),
    (["cone", SCENE, "more"], "cone: 'more' given; allowed: nothing more; remove it; see planar-pushing "),
    (["solve", SCENE, "-10"], "solve: '-10' given; allowed: nothing more; type --pusher-angle -10; see "),
    (["solve", SCENE, "-10:10:5"], "nothing more; type --pusher-angle -10:10:5; see "),
    (["simulate", SCENE, "165", "-o", "log.nc"], "nothing more; type --pusher-angle 165; see "),
    (["cone", SCENE, "10"], "cone: '10' given; allowed: nothing more; remove it; see "),
    (["solve", SCENE, "--pusher=9"], "did you mean --pusher-angle or --pusher-magnitude?; see "),
    (["solve", SCENE, "--pusher-angel=9"], "--pusher-magnitude; did you mean --pusher-angle?; see "),
    (["identify", "--otput", "support.yaml"], "did you mean --output?; "),
    (["--verson"], "--verson given; allowed: --help, --version; did you mean --version?; "),
    (["cone"], "cone: the following arguments are required: SCENE.yaml; see planar-pushing cone --help"),
    (["solve", SCENE, "--pusher-angle", "east"],
     "--pusher-angle: 'east' given; allowed: a number, or START:STOP:STEP "),
    (["animate", "log.nc", "-o", "a.gif", "--frames", "1.5"], "'1.5' given; allowed: a whole number; "),
    (["solve", SCENE, "--pusher-angle"],
     "solve: --pusher-angle: value missing; allowed: --pusher-angle DEGREES|START:STOP:STEP; add "),
    (["simulate", SCENE, "--duration", "1", "-o"], "--output: value missing; allowed: --output LOG.nc; "),
    (["convert", "csv", "a.csv", "-o", "a.nc", "--units", "mm"],
     "--units: value missing; allowed: --units LENGTH FORCE; add what is missing; see "),
    (["solve", SCENE, "--pusher-angle", "1", "--pusher-angle=2"],
     "solve: --pusher-angle given twice; allowed: once; remove one of them; see "),
    (["draw", SCENE, "-o", "a.svg", "--output", "b.svg"], "draw: --output given twice; allowed: once"),
    (["draw", SCENE, "-oa.svg", "-o", "b.svg"], "draw: -o given twice; allowed: once; remove"),
    (["cone", ""], "cone: argument SCENE.yaml: '' given; allowed: a path; name a file or a folder; see "),
    (["draw", SCENE, "-o", ""], "argument -o/--output: '' given; allowed: a path; name a file "),
    (["init", ""], "init: argument FOLDER: '' given; allowed: a path; name a file or a folder; see "),
    (["solf"], "planar-pushing: 'solf' given; allowed: solve, cone, "),
    (["Solv"], ", run; did you mean solve?; see planar-pushing --help"),
    ([], "the following arguments are required: command; see planar-pushing --help"),
], ids=str)  # fmt: skip
def test_arguments_that_are_none_are_refused_in_one_line(capsys, arguments, said):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    err = capsys.readouterr().err
    assert caught.value.code == 2
    assert said in err
    assert err.count("\n") == 1


def test_the_package_runs_as_the_command():
    done = subprocess.run(
        [sys.executable, "-m", "planar_pushing", "--help"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert all(name in done.stdout for name in COMMANDS)


@pytest.mark.parametrize("command", [
    ["draw", SCENE], ["simulate", SCENE], ["animate", "log.nc"],
], ids=str)  # fmt: skip
def test_a_folder_that_is_not_there_is_named_and_not_made(refused, tmp_path, command):
    place = tmp_path / "none" / "below"
    said = (
        f"output: '{place}/file.svg' given; allowed: a file in an existing folder; create the folder "
        f"{place}, or choose another file"
    )
    refused([*command, "-o", f"{place}/file.svg"], said)
    assert not place.parent.exists()


@pytest.mark.parametrize("command", [
    ["draw", SCENE], ["simulate", SCENE], ["animate", "log.nc"], ["compare", "pushes.nc"],
], ids=str)  # fmt: skip
def test_a_file_in_place_of_a_folder_is_named(refused, tmp_path, command):
    file = tmp_path / "text"
    file.write_text("kept", encoding="utf-8")
    said = (
        f"output: '{file}/log.nc' given; allowed: a file in an existing folder; choose another file"
    )
    refused([*command, "-o", f"{file}/log.nc"], said)
    assert file.read_text(encoding="utf-8") == "kept"


@pytest.mark.parametrize("option", ["--pusher-angle", "--pusher-magnitude"])
def test_values_that_are_no_finite_numbers_are_values(refused, option):
    for value in ("-inf", "inf", "nan", "-NaN"):
        name = option[2:].replace("-", "_")
        refused(["solve", SCENE, option, value], f"{name}: ")
