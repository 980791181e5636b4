"""Logs of the triangle, which the tests write in the published format."""

import numpy as np
import pytest
from pushes.written import STRENGTH, write_log

import planar_pushing as pp
from planar_pushing.pushes.logs.combine import of_object

NAME = "10_130_10_10_10_130"
SAME = ("contact", "normal", "finger_displacement", "displacement", "rotation")


@pytest.mark.parametrize("counted", [True, False])
def test_a_log_gives_the_pushes_that_were_written(pushes, tmp_path, counted):
    file = tmp_path / f"{NAME}.txt"
    write_log(file, pushes, np.random.default_rng(5), counted)
    found = pp.read_three_feet(file)
    for name in SAME:
        assert found[name].values == pytest.approx(pushes[name].values, abs=1e-6), name
    force = STRENGTH * pushes["force"].values
    assert found["force"].values == pytest.approx(force, abs=1e-9)
    assert found["finger_radius"].values.tolist() == [0.0] * 12
    assert found["feet"].values[0].tolist() == [[10, 10], [130, 10], [10, 130]]
    assert found["foot_weight"].values[0] == pytest.approx([1 / 3] * 3, abs=1e-15)
    assert found["center_of_mass"].values.tolist() == [[50, 50]]
    assert found["mass"].values.tolist() == [1.518]
    units = {name: found[name].attrs["units"] for name in ("contact", "force", "rotation", "mass")}
    assert units == {"contact": "mm", "force": "N", "rotation": "degree", "mass": "kg"}
    assert found.attrs == {
        "source": "Zhou, Paolini, Bagnell and Mason, ICRA 2016", "position_noise": 0.5,
        "angle_noise": 0.3, "force_noise": 0.05, "left_out": 0,
    }  # fmt: skip


def test_two_logs_one_of_them_of_the_face(pushes, tmp_path):
    files = [tmp_path / name for name in ("30_90_30_30_30_90.txt", "patch.txt")]
    random = np.random.default_rng(6)
    for file in files:
        write_log(file, pushes, random)
    found = pp.read_three_feet(*map(str, files))
    assert found["object"].values.tolist() == ["30_90_30_30_30_90", "patch"]
    assert found.sizes["push"] == 24
    assert "feet" not in of_object(found, "patch")
    assert of_object(found, "30_90_30_30_30_90")["feet"].values[0, 1].tolist() == [90, 30]


def test_weights_balance_about_the_center_of_mass(pushes, tmp_path):
    file = tmp_path / "30_63.33_43.33_30_43.33_63.33.txt"
    write_log(file, pushes, np.random.default_rng(7))
    found = pp.read_three_feet(file)
    weights, places = found["foot_weight"].values[0], found["feet"].values[0]
    assert places[1].tolist() == [63.33, 43.33]
    assert weights @ places == pytest.approx([50, 50], abs=1e-12)
    assert weights.sum() == pytest.approx(1.0, abs=1e-14)


def test_feet_on_a_line_have_no_known_weights(pushes, tmp_path):
    file = tmp_path / "20_50_80_50_50_50.txt"
    write_log(file, pushes, np.random.default_rng(7))
    found = pp.read_three_feet(file)
    assert found["feet"].values[0].tolist() == [[20, 50], [50, 50], [80, 50]]
    assert np.isnan(found["foot_weight"]).all()


def test_pushes_that_do_not_touch_are_counted(pushes, tmp_path):
    file = tmp_path / "patch.txt"
    lines = write_log(file, pushes, np.random.default_rng(8))
    lines[-1] = lines[-5]  # the tool of the last push ends where it begins
    file.write_text("\n".join(lines))
    found = pp.read_three_feet(file)
    assert (found.sizes["push"], found.attrs["left_out"]) == (11, 1)


def test_a_push_without_force_samples(pushes, tmp_path):
    file = tmp_path / "patch.txt"
    lines = write_log(file, pushes, np.random.default_rng(8))
    lines[3:104] = ["0"]
    file.write_text("\n".join(lines))
    found = pp.read_three_feet(file)
    assert np.isnan(found["force"].values[0]).all()
    assert np.isfinite(found["force"].values[1:]).all()


def cut(count):
    return lambda lines: lines[:count]


def replaced(number, text):
    return lambda lines: [*lines[: number - 1], text, *lines[number:]]


@pytest.mark.parametrize(("name", "change", "said"), [
    ("patch", cut(40), "cut short in push 1 of 12 after line 40, where a force sample is missing; copy it"),
    ("patch", lambda lines: [*lines[:40], "0.3 0.1"],
     "line 41 (push 1 of 12) ends after 2 of the 3 numbers of a force sample: it is cut short"),
    ("patch", replaced(1, "11"),
     "line 1200 (push 11 of 11) is followed by more lines, but the first line announces 11 pushes; copy"),
    ("patch", replaced(1, "13"), "cut short in push 13 of 13 after line 1309, where the pose before"),
    ("patch", replaced(4, "99"), "line 104 (push 1 of 12) holds 3 numbers, where the number of tool poses "
     "is expected: the counts do not match"),
    ("patch", replaced(4, "101"), "line 105 (push 1 of 12) holds 1 number, where a force sample has 3: "
     "the counts do not match"),
    ("patch", replaced(4, "2.5"),
     "line 4 (push 1 of 12) holds 2.5, where the number of force samples is expected, at least 0"),
    ("patch", replaced(9, "0.1 a 0.2"),
     "line 9 (push 1 of 12) holds no numbers, where a force sample is expected; copy the log again"),
    ("patch", cut(0), "cut short after line 0, where a number is missing"),
    ("patch", lambda lines: ["0"], "holds no push; allowed: at least one"),
    ("triangle", cut(None), "a name without feet; allowed: x1_x2_x3_y1_y2_y3 of the feet in mm, such as "),
    ("10_20_30_10_20", cut(None), "a name without feet; allowed: "),
    *((name, cut(None), "feet that do not carry the center of mass (50, 50); allowed: ")
      for name in ("10_20_10_10_10_20", "1_1_1_1_1_1", "0_10_20_0_0_0", "10_20_30_50_50_50")),
])  # fmt: skip
def test_what_is_wrong_is_said_in_a_line(pushes, tmp_path, name, change, said):
    file = tmp_path / f"{name}.txt"
    file.write_text("\n".join(change(write_log(file, pushes, np.random.default_rng(9)))))
    with pytest.raises(pp.InvalidFile) as error:
        pp.read_three_feet(file)
    assert str(error.value).startswith(f"{file}: {said}"), str(error.value)
    assert "\n" not in str(error.value)


def test_poses_that_jump_and_meters(pushes, tmp_path):
    file = tmp_path / "patch.txt"
    lines = write_log(file, pushes, np.random.default_rng(9))
    jumped = [*lines]
    jumped[2] = " ".join(["5000", *lines[2].split()[1:]])
    file.write_text("\n".join(jumped))
    with pytest.raises(
        pp.InvalidFile, match=r"patch.txt: poses_after: 'an object that moves by .*, in pushes 0'"
    ):
        pp.read_three_feet(file)
    rows = [line.split() for line in lines]
    for row in rows:
        start = {7: 0, 8: 1}.get(len(row), 9)
        row[start : start + 3] = [str(float(each) / 1e3) for each in row[start : start + 3]]
    file.write_text("\n".join(map(" ".join, rows)))
    with pytest.raises(pp.InvalidFile, match=r"patch.txt: contact: .* check the units"):
        pp.read_three_feet(file)


def test_files_that_cannot_be_read(tmp_path):
    (tmp_path / "patch.txt").write_bytes(b"\x89HDF\r\n")
    for name, said in (
        ("missing.txt", "cannot be read (No such file or directory); name another file"),
        ("patch.txt", "is not a text file of numbers; name another file"),
    ):
        with pytest.raises(pp.InvalidFile) as error:
            pp.read_three_feet(tmp_path / name)
        assert str(error.value) == f"{tmp_path / name}: {said}"
    with pytest.raises(pp.InvalidValue, match="files: 'none' given; allowed: at least one file"):
        pp.read_three_feet()
    with pytest.raises(pp.InvalidValue, match="files: 'two files named patch' given"):
        pp.read_three_feet(tmp_path / "patch.txt", tmp_path / "other" / "patch.txt")
