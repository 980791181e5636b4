"""`simulate` and `animate` on the command line, with right and with wrong input."""

import json

import numpy as np
import pytest
from PIL import Image

from planar_pushing.commands import main
from planar_pushing.study.store import read_dataset

PULLING = "workflow/scenes/figure_14a.yaml"
PLAIN = "workflow/scenes/figure_08.yaml"


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    path = tmp_path_factory.mktemp("log") / "log.nc"
    assert main(["simulate", PULLING, "-o", str(path)]) == 0
    return path


def run(capsys, *arguments):
    code = main(list(arguments))
    said = capsys.readouterr()
    return code, said.out, said.err


def test_simulate_follows_the_section_of_the_scene(log):
    found = read_dataset(log)
    assert found.attrs["finished"] == 1
    assert found.attrs["on_ambiguity"] == "keep-contact"
    assert found.sizes["time"] == 97
    assert float(found.rod_angle[-1]) == pytest.approx(55.0117131650713, abs=1e-9)


def test_an_option_takes_the_place_of_the_section(capsys, tmp_path):
    path = tmp_path / "log.nc"
    options = ("--on-ambiguity", "separate", "--json")
    code, out, _ = run(capsys, "simulate", PULLING, "-o", str(path), *options)
    told = json.loads(out)
    assert (code, told["time"], told["stopped"]) == (0, 1.5, "")
    assert [(each["time"], each["mode"]) for each in told["modes"]] == [
        (0.0, "STICK"),
        (0.5, "SEPARATE"),
    ]
    assert told["modes"][1]["consistent"] > 1
    assert told["gap"] == pytest.approx(np.sin(np.deg2rad(10)), abs=1e-12)


def test_the_options_alone_make_a_simulation(capsys, tmp_path):
    path = tmp_path / "log.nc"
    options = ("--pusher-angle", "165", "--duration", "3", "--samples", "5", "--rtol", "1e-9")
    code, out, err = run(capsys, "simulate", PLAIN, "-o", str(path), *options, "--no-progress")
    assert (code, err) == (0, "")
    assert "slip: 2.151415744" in out
    assert "mode: SLIP_RIGHT" in out


def test_twice_the_speed_takes_half_the_time(capsys, tmp_path):
    slips = []
    for speed, duration in (("1", "2"), ("2", "1")):
        path = tmp_path / f"{speed}.nc"
        options = ("--pusher-angle", "165", "--pusher-speed", speed, "--duration", duration)
        run(capsys, "simulate", PLAIN, "-o", str(path), *options)
        slips.append(float(read_dataset(path).slip[-1]))
    assert slips[0] == pytest.approx(slips[1], abs=1e-9)


def test_progress_is_shown_when_asked_for(capsys, tmp_path):
    path = tmp_path / "log.nc"
    _, out, err = run(capsys, "simulate", PULLING, "-o", str(path), "--progress")
    assert "1.5" in err
    assert out.startswith(f"written: {path}\n")


def test_animate(capsys, log, tmp_path):
    path = tmp_path / "motion.gif"
    code, out, _ = run(capsys, "animate", str(log), "-o", str(path), "--frames", "6", "--json")
    told = json.loads(out)
    assert (code, told["frames"], told["bytes"]) == (0, 6, path.stat().st_size)
    frames = []
    with Image.open(path) as image:
        assert (image.format, image.n_frames, image.info["duration"]) == ("GIF", 6, 40)
        for number in range(image.n_frames):
            image.seek(number)
            frames.append(np.asarray(image.convert("RGB")).tobytes())
    assert len(set(frames)) == 6
    first = path.read_bytes()
    run(capsys, "animate", str(log), "-o", str(path), "--frames", "6")
    assert path.read_bytes() == first


WRONG = [
    (["simulate", "none.yaml", "-o", "log.nc"], "none.yaml: no such file; give the path of a YAML"),
    (["simulate", PULLING, "-o", "log.txt"],
     "output: 'log.txt' given; allowed: a name ending in .nc or .h5; rename the file"),
    (["simulate", PULLING, "-o", "/dev/null/log.nc"], "/dev/null/log.nc: cannot be written"),
    (["simulate", PLAIN, "--pusher-angle", "1", "-o", "log.nc"],
     "duration: None given; allowed: the option --duration, or a section simulate in"),
    (["simulate", PLAIN, "--duration", "1", "-o", "log.nc"],
     "pusher_angle: None given; allowed: the option --pusher-angle, or a section simulate in"),
    (["simulate", PULLING, "--duration", "-1", "-o", "log.nc"],
     "duration: -1.0 given; allowed: a finite number > 0"),
    (["simulate", PULLING, "--rtol", "0", "-o", "log.nc"],
     "rtol: 0.0 given; allowed: a number in [1e-13, 1e-2]"),
    (["simulate", PULLING, "--samples", "1", "-o", "log.nc"],
     "samples: 1 given; allowed: a whole number >= 2"),
    (["simulate", PULLING, "--method", "euler", "-o", "log.nc"],
     "method: 'euler' given; allowed: 'event-driven' or 'time-stepping'"),
    (["simulate", PULLING, "--on-ambiguity", "both", "-o", "log.nc"],
     "on_ambiguity: 'both' given; allowed: 'keep-contact', 'separate' or 'stay-in-mode'"),
    (["simulate", PULLING, "--pusher-angle", "nan", "-o", "log.nc"],
     "pusher_angle: nan given; allowed: a finite number of degrees"),
    (["animate", "none.nc", "-o", "motion.gif"], "none.nc: no such dataset"),
    (["animate", "LOG", "-o", "motion.mp4"],
     "output: 'motion.mp4' given; allowed: a name ending in .gif; rename the file"),
    (["animate", "LOG", "--frames", "1", "-o", "motion.gif"],
     "frames: 1 given; allowed: a whole number from 2 to 1000"),
    (["animate", "LOG", "--frames-per-second", "0", "-o", "motion.gif"],
     "frames_per_second: 0.0 given; allowed: a number in (0, 50]"),
    (["animate", "tests/golden/figure_01.nc", "-o", "motion.gif"],
     "tests/golden/figure_01.nc: the dataset lacks position"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "said"), WRONG)
def test_wrong_input(capsys, log, tmp_path, arguments, said):
    given = [str(log) if each == "LOG" else each for each in arguments]
    code, out, err = run(capsys, *given)
    assert (code, out) == (2, "")
    assert err.startswith(f"planar-pushing {given[0]}: {said}"), err
    assert err.count("\n") == 1
