"""Tables of pushes in CSV files: what they become, and how a wrong one is refused."""

import numpy as np
import pytest
from pushes.written import finger_places, turn, world_poses

import planar_pushing as pp
from planar_pushing.pushes.formats.table import ANGLES, REQUIRED, read_table

BOX = [(-60, -40), (60, -40), (60, 40), (-60, 40)]
RADIUS = 5.0
HEADER = (*REQUIRED, "x_force", "y_force")
OPTIONS = {"outline": BOX, "finger_radius": RADIUS}


@pytest.fixture(scope="module")
def measured():
    """Simulated pushes of the box, and the rows of their table in degrees and in radians."""
    support = pp.SupportFriction(support=pp.Points([(-50, -30), (50, -30), (0, 30)]), weight=4.0)
    pushes = pp.simulate_pushes((support,), BOX, 8, seed=3, finger_radius=RADIUS, distance=20.0)
    before, after = world_poses(pushes, np.random.default_rng(3))
    start, end = finger_places(pushes, before, lead=10.0)
    midway = (before[:, 2] + after[:, 2]) / 2
    force = [turn(a) @ f for a, f in zip(midway, pushes["force"].values, strict=True)]
    rows = {
        unit: np.column_stack([
            before / (1, 1, size), after / (1, 1, size), start, end, force
        ]) for unit, size in ANGLES.items()
    }  # fmt: skip
    return pushes, rows


def written(file, rows, names=HEADER, before=""):
    lines = [",".join(f"{number:.12g}" for number in row) for row in rows]
    file.write_text("\n".join([before + ",".join(names), *lines]) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize("unit", ANGLES)
def test_a_table_becomes_the_pushes_that_it_was_written_from(tmp_path, measured, unit):
    pushes, rows = measured
    found = read_table(written(tmp_path / "box.csv", rows[unit]), angles=unit, **OPTIONS)
    assert found.attrs["source"] == "box.csv"
    assert found["object"].values.tolist() == ["box"]
    for name in ("contact", "finger_displacement", "displacement", "rotation", "force"):
        np.testing.assert_allclose(found[name], pushes[name], atol=1e-8, err_msg=name)


def test_order_comments_quotes_blank_lines_and_a_byte_order_mark_do_not_matter(tmp_path, measured):
    rows = measured[1]["degrees"]
    wanted = read_table(written(tmp_path / "box.csv", rows), **OPTIONS)
    order = np.random.default_rng(1).permutation(len(HEADER))
    names = [f'"{HEADER[k]}"' for k in order]
    file = written(tmp_path / "other.csv", rows[:, order], names, "\ufeff# mm, degrees, N\n\n")
    file.write_text(file.read_text(encoding="utf-8") + "\n,,,\n# the end\n", encoding="utf-8")
    found = read_table(file, name="box", **OPTIONS)
    assert found.drop_attrs(deep=False).identical(wanted.drop_attrs(deep=False))


def test_forces_can_be_missing_in_some_rows_or_in_all(tmp_path, measured):
    rows = measured[1]["degrees"].copy()
    rows[2, -2:] = np.nan
    file = written(tmp_path / "box.csv", rows)
    assert np.isnan(read_table(file, **OPTIONS)["force"].values).any(axis=1).tolist() == [
        row == 2 for row in range(len(rows))
    ]
    file.write_text(file.read_text(encoding="utf-8").replace("nan", ""), encoding="utf-8")
    assert np.isnan(read_table(file, **OPTIONS)["force"].values[2]).all()
    assert "force" not in read_table(written(file, rows[:, :-2], REQUIRED), **OPTIONS)


def test_several_tables_are_of_one_object_or_of_several(tmp_path, measured):
    rows = measured[1]["degrees"]
    files = [written(tmp_path / name, rows) for name in ("one.csv", "two.csv")]
    assert read_table(*files, **OPTIONS)["object"].values.tolist() == ["one", "two"]
    assert read_table(*files, name="box", **OPTIONS)["object"].values.tolist() == ["box"]


def nearly_upright(rows):
    """Rows with angles in degrees, each in a world frame in which the push turns the object through 0."""
    found = []
    for row in rows:
        back = -(row[2] + row[5]) / 2
        matrix, angles = turn(np.deg2rad(back)), row[[2, 5]] + back
        before, after, *others = (matrix @ row[k : k + 2] for k in (0, 3, 6, 8, 10))
        found.append(np.concatenate([before, angles[:1], after, angles[1:], *others]))
    return np.array(found)


def test_angles_beyond_two_turns_are_in_the_other_unit(tmp_path, measured):
    file = written(tmp_path / "box.csv", measured[1]["degrees"])
    with pytest.raises(
        pp.InvalidFile, match=r"radians of at most two turns; give --angles degrees$"
    ):
        read_table(file, angles="radians", **OPTIONS)


@pytest.mark.parametrize("unit", ANGLES)
def test_angles_within_two_turns_are_told_by_the_place_of_the_finger(tmp_path, measured, unit):
    (other,) = set(ANGLES) - {unit}
    rows = measured[1][other] if other == "radians" else nearly_upright(measured[1][other])
    file = written(tmp_path / "box.csv", rows)
    assert read_table(file, angles=other, **OPTIONS).sizes["push"] == len(rows)
    with pytest.raises(
        pp.InvalidFile,
        match=f"the angles seem to be in {other}: .* after a push is .* in {unit}; give --angles {other}$",
    ):
        read_table(file, angles=unit, **OPTIONS)


@pytest.mark.parametrize(("unit", "before", "after", "said"), [
    ("degrees", 350.0, -8.0, "angle_after: -8 given, which differs from angle_before by -358 degrees; "
     "allowed: at most half a turn; write 352, or wrap all angles to the range "
     "from -180 to 180 or from 0 to 360; "),
    ("degrees", -200.0, 155.0, "angle_after: 155 given, which differs from angle_before by 355 degrees; "
     "allowed: at most half a turn; write -205, "),
    ("radians", 6.25, -0.125, "angle_after: -0.125 given, which differs from angle_before by -6.375 "
     "radians; allowed: at most half a turn; write 6.15819, or wrap all angles "
     "to the range from -3.14159 to 3.14159 or from "),
])  # fmt: skip
def test_angles_that_are_not_wrapped_alike_are_named(tmp_path, measured, unit, before, after, said):
    rows = measured[1][unit].copy()
    rows[:, [2, 5]] = np.array([0.1, 0.12])
    rows[3, [2, 5]] = before, after
    (other,) = set(ANGLES) - {unit}
    with pytest.raises(pp.InvalidFile) as error:
        read_table(written(tmp_path / "box.csv", rows), angles=unit, **OPTIONS)
    assert str(error.value).startswith(f"{tmp_path / 'box.csv'}: line 5: {said}"), str(error.value)
    assert str(error.value).endswith(f"if they are in the other unit, give --angles {other}")
    assert "np.deg2rad" not in str(error.value)


ROW = "0,0,0,0,12,0,0,-60,0,-33,0,1"
BAD = {
    "": "is empty; allowed: the columns x_before, ",
    "# only a comment\n": "is empty; ",
    ",".join(HEADER): "holds no push below the names of its columns; add rows",
    ROW: "unknown column '0'; allowed: the columns ",
    f"{','.join(REQUIRED)}\n0,0,0\n": "line 2 holds 3 values; allowed: 10, one for each column; correct",
    f"# mm\n{','.join(HEADER)}\n{ROW}\n{ROW},1": "line 4 holds 13 values; allowed: 12, ",
    f"{','.join(REQUIRED[:-1])}\n": "no column y_end; allowed: ",
    f"{','.join(HEADER[:-1])}\n": "no column y_force; allowed: ",
    f"{','.join(HEADER)},note\n{ROW},a": "unknown column 'note'; ",
    f"{','.join(HEADER)}\n{ROW}".replace("x_start", "x_strat"): "did you mean x_start?",
    f"{','.join(HEADER)},x_end\n": "two columns x_end; allowed: one; remove the other",
    f"{','.join(HEADER)}\n{ROW}".replace(",", ";"): "columns separated by semicolons or tabs; allowed: ",
    f"{','.join(HEADER)}\n{ROW}".replace(",", "\t"): "columns separated by semicolons or tabs; ",
    f"{','.join(HEADER)}\n{ROW}".replace("12", "about 12"): "line 2: y_after: 'about 12' given; allowed: ",
    f"{','.join(HEADER)}\n{ROW}".replace("12", ""): "line 2: y_after: '' given; allowed: a finite number; ",
    f"{','.join(HEADER)}\n{ROW}".replace("12", "nan"): "line 2: y_after: 'nan' given; ",
    f"{','.join(HEADER)}\n{ROW}".replace("12", "1e999"): "line 2: y_after: '1e999' given; ",
    f"{','.join(HEADER)}\n{ROW[:-1]}inf": "line 2: y_force: 'inf' given; allowed: a finite number, or noth",
    f"{','.join(HEADER)}\n{ROW[:-1]}a\n": "line 2: y_force: 'a' given; ",
    f"{','.join(HEADER)}\n{'1' * 200_000}": "line 2 is no row of a table; correct it",
    f"{','.join(HEADER)}\n{ROW}".replace("12", "12000"): "poses_after: 'an object that moves by 1.2e+04, ",
    f"{','.join(HEADER)}\n{ROW}".replace("-33", "-58"): "1 of 1 that do not touch the object: 0' given; ",
}  # fmt: skip


@pytest.mark.parametrize(("text", "said"), BAD.items(), ids=range(len(BAD)))
def test_a_wrong_table_is_refused_in_one_line(tmp_path, text, said):
    file = tmp_path / "box.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(pp.InvalidFile) as caught:
        read_table(file, **OPTIONS)
    assert str(caught.value).startswith(f"{file}: ")
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_table_of_the_wrong_ones_is_right_otherwise(tmp_path):
    file = tmp_path / "box.csv"
    file.write_text(f"{','.join(HEADER)}\n{ROW}\n", encoding="utf-8")
    assert read_table(file, **OPTIONS).sizes["push"] == 1


@pytest.mark.parametrize(("content", "said"), [
    (b"\x89HDF\r\n", "is not text; allowed: a CSV file in UTF-8; save the table as one"),
    (b"PK\x03\x04", "is not text; "), ("x_before".encode("utf-16"), "is not text; "),
    (b"x_before\0", "is not text; "), (b"x_before\n\xfcber", "is not text in UTF-8; "),
])  # fmt: skip
def test_what_is_no_text_is_refused(tmp_path, content, said):
    file = tmp_path / "box.csv"
    file.write_bytes(content)
    with pytest.raises(pp.InvalidFile, match=f"box.csv: {said}"):
        read_table(file, **OPTIONS)


def test_a_file_that_is_missing_or_a_folder_is_refused(tmp_path):
    for path, reason in ((tmp_path, "Is a directory"), (tmp_path / "none.csv", "No such file")):
        with pytest.raises(pp.InvalidFile, match=rf"cannot be read \({reason}.*name a table"):
            read_table(path, **OPTIONS)
