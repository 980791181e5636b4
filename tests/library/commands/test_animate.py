"""The command `animate`, with right and with wrong input."""

import json

import numpy as np
import pytest
from PIL import Image


def test_animate(run, log, tmp_path):
    path = tmp_path / "motion.gif"
    code, out, _ = run("animate", str(log), "-o", str(path), "--frames", "6", "--json")
    told = json.loads(out)
    assert (code, told["frames"], told["bytes"]) == (0, 6, path.stat().st_size)
    frames = []
    with Image.open(path) as image:
        assert (image.format, image.n_frames, image.info["duration"]) == ("GIF", 6, 40)
        for number in range(image.n_frames):
            image.seek(number)
            frames.append(np.asarray(image.convert("RGB")).tobytes())
    assert len(set(frames)) == 6


WRONG = [
    (["animate", "none.nc", "-o", "motion.gif"],
     "none.nc: no such file; give a log that planar-pushing simulate has written"),
    (["animate", "workflow/scenes/pulling.yaml", "-o", "motion.gif"],
     "workflow/scenes/pulling.yaml: is not a netCDF4 file; give a log that planar-pushing simulate has "),
    (["animate", "LOG", "--frames", "1", "-o", "motion.gif"],
     "frames: 1 given; allowed: a whole number from 2 to 1000"),
    (["animate", "tests/golden/motion_cones.nc", "-o", "motion.gif"],
     "tests/golden/motion_cones.nc: the dataset lacks position"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "said"), WRONG)
def test_wrong_input(refused, log, arguments, said):
    refused([str(log) if each == "LOG" else each for each in arguments], said)
