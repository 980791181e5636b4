"""The command `convert`, with right and with wrong files."""

import json

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet, write_log, write_mat

import planar_pushing as pp


@pytest.fixture(scope="module")
def pushes():
    return pp.simulate_pushes(feet(), TRIANGLE, 3)


def test_logs_become_a_dataset(run, tmp_path, pushes):
    files = [str(tmp_path / name) for name in ("10_130_10_10_10_130.txt", "patch.txt")]
    for file in files:
        write_log(tmp_path / file, pushes, np.random.default_rng(1))
    path = tmp_path / "pushes.nc"
    code, out, err = run("convert", "three-feet", *files, "-o", str(path))
    assert (code, err) == (0, "")
    assert out.splitlines() == [
        f"written: {path}", "pushes: 6", "objects: 10_130_10_10_10_130 patch", "left_out: 0",
    ]  # fmt: skip
    assert pp.load_pushes(path).identical(pp.read_three_feet(*files))


def test_matlab_files_become_a_dataset(run, tmp_path):
    support = pp.SupportFriction(support=pp.Polygon([(-45, -45), (45, -45), (45, 45), (-45, 45)]))
    found = pp.simulate_pushes((support,), support.support.vertices, 3)
    found["finger_radius"][:] = 4.75
    write_mat(tmp_path / "abs_rect1.mat", found, np.random.default_rng(1))
    path = tmp_path / "pushes.nc"
    code, out, _ = run("convert", "mit", str(tmp_path / "abs_rect1.mat"), "-o", str(path), "--json")
    told = {"written": str(path), "pushes": 3, "objects": ["abs_rect1"], "left_out": 0}
    assert (code, json.loads(out)) == (0, told)
    assert pp.load_pushes(path).sizes["push"] == 3


def test_wrong_input_writes_nothing(refused, tmp_path, pushes):
    file, path = tmp_path / "patch.txt", tmp_path / "pushes.nc"
    lines = write_log(file, pushes, np.random.default_rng(1))
    file.write_text("\n".join(lines[:50]))
    for arguments, said in (
        (["three-feet", str(file), "-o", str(path)], f"{file}: cut short in push 1 of 3 after line 50"),
        (["three-foot", str(file), "-o", str(path)],
         "format: 'three-foot' given; allowed: three-feet, mit; did you mean three-feet?"),
        (["mit", str(file), "-o", str(path)], f"{file}: a name without a known shape; allowed: "),
        (["three-feet", str(file), "-o", "pushes.csv"],
         "output: 'pushes.csv' given; allowed: a name ending in .nc or .h5; rename the file"),
        (["three-feet", str(file), "-o", str(tmp_path / "none" / "pushes.nc")], "output: "),
    ):  # fmt: skip
        refused(["convert", *arguments], said)
    assert [each.name for each in tmp_path.iterdir()] == ["patch.txt"]
