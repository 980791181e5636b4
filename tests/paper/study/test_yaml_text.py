"""Text that is no YAML of ours ends in one line; a file is bounded before it is read."""

import pytest

from planar_pushing import InvalidFile
from planar_pushing.scenes import yaml_text
from planar_pushing.scenes.files import load_scene_file
from pulling_by_pushing.study.study_file import load_study

LAUGHS = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 10)
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("title: 2026-13-45", "not YAML: month must be in 1..12; correct the value"),
        ("title: !!int foo", "not YAML: invalid literal for int() with base 10: 'foo'; correct the value"),
        ("title: !scene {a: 3}", "not YAML: line 1, column 8: could not determine a constructor"),
        ("title: !!python/name:os.system", "not YAML: line 1, column 8: could not determine a con"),
        (r'title: "\UFFFFFFFF"', "not YAML: "),  # Python's own words, which differ by version
        *((f"title: {start}{'7' * 5000}", f"line 1, column 8: an integer of {5000 + len(start)} char")
          for start in ("", "-", "0x", "0o")),
        (f"grid: {{samples: [1, 0b{'1' * 5000}]}}", "line 1, column 21: an integer of 5002 characters"),
        (f"0x{'f' * 5000}: 1", "line 1, column 1: an integer of 5002 characters given; allowed: at mo"),
        ("? [a, b]\n: 3", "('a', 'b'): 3 given; allowed: the keys title, slider"),
        ("? {a: b}\n: 3", "not YAML: line 1, column 3: found unhashable key"),
        (f"title: {'[' * 1000}{']' * 1000}", "not YAML: nested too deeply; reduce the nesting"),
        (LAUGHS, "not YAML: line 2, column 10: aliases are not allowed; correct the line"),
        ("title: &a [*a]", "not YAML: line 1, column 12: aliases are not allowed; correct the line"),
        ("title: [*b]", "not YAML: line 1, column 9: aliases are not allowed; correct the line"),
        ("<<: 3", "not YAML: line 1, column 5: expected a mapping"),
        ("\0", "not YAML: unacceptable character #x0000"),
        ('? "' + "k" * 900 + '"\n: 3', "kkkk"),
        ("a: 1\n---\nb: 2", "not YAML: line 2, column 1: found another document; correct the line"),
        ("#" + "x" * yaml_text.BYTES, "is too large; allowed: files of at most 262144 bytes; "),
    ],
)  # fmt: skip
def test_text_that_is_refused(tmp_path, text, said):
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_scene_file(path)
    told = str(caught.value).removeprefix(f"{path}: ")
    assert told.startswith(said)
    assert "\n" not in told
    assert len(told) < 300


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        ("contact: {law: coulomb, friction_coefficient: 0,5}", 47, "friction_coefficient: '0,5'"),
        (
            "{contact: {friction_coefficient: -0,05, law: coulomb}}",
            34,
            "friction_coefficient: '-0,05'",
        ),
        ("slider: {rod_angle: 1,5, rod_length: 2,5}", 21, "rod_angle: '1,5'"),
        ("a: [{share: 2,0e-1}]", 13, "share: '2,0e-1'"),
        ("a: {b: {start: 0, stop: 1, step: 0, 1}}", 34, "step: '0,1'"),
        ("a: {mass: 1,000.5}", 11, "mass: '1,000.5'"),
        ("a: {mass: 1,5,5}", 11, "mass: '1,5'"),
    ],
)
@pytest.mark.parametrize("load", [load_scene_file, load_study])
def test_a_decimal_comma_is_named(tmp_path, load, text, place, said):
    path = tmp_path / "file.yaml"
    path.write_text(text + "\n", encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load(path)
    assert str(caught.value) == (
        f"{path}: line 1, column {place}: {said} given; allowed: a number with a decimal point, since a "
        "comma ends a value; write the point"
    )


@pytest.mark.parametrize(
    ("text", "value"),
    [("a: {b: 0, 5: 3}", {"b": 0, 5: 3}), ("a: {b: x, 5}", {"b": "x", 5: None}),
     ('a: {b: "0", 5}', {"b": "0", 5: None}), ("a: {b: [0,5]}", {"b": [0, 5]}),
     ("a:\n  b: 0\n  5:\n", {"b": 0, 5: None}), ("a: {b: 2,}", {"b": 2})],
)  # fmt: skip
def test_other_commas_end_values(tmp_path, text, value):
    path = tmp_path / "file.yaml"
    path.write_text(text, encoding="utf-8")
    assert yaml_text.read_yaml(path) == {"a": value}


@pytest.mark.parametrize("load", [load_scene_file, load_study])
def test_a_log_is_no_scene_and_no_study(tmp_path, load):
    path = tmp_path / "log.nc"
    path.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
    said = "is a netCDF4 file, such as a log or a dataset; allowed: a YAML file; give a scene or a study"
    with pytest.raises(InvalidFile, match=f"^{path}: {said}$"):
        load(path)


@pytest.mark.slow  # a thousand brackets are refused above
def test_many_nested_brackets_are_one_line_too(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text("[" * (yaml_text.BYTES // 2), encoding="utf-8")
    with pytest.raises(InvalidFile, match="nested too deep"):
        load_scene_file(path)


def test_a_file_of_the_largest_size_is_read(tmp_path):
    path, line = tmp_path / "scene.yaml", "a: 3\n"
    path.write_text(line + "#" + "x" * (yaml_text.BYTES - len(line) - 1), encoding="utf-8")
    assert yaml_text.read_yaml(path) == {"a": 3}


@pytest.mark.parametrize(
    "given",
    ["{start: 0, stop: 360, step: 3.6e-8}", "{start: 0, stop: 1e308, step: 1e-300}",
     "{start: -1e308, stop: 1e308, step: 1e-300}"],
)  # fmt: skip
def test_a_range_is_counted_before_it_is_built(tmp_path, study_text, given):
    path = tmp_path / "config/file.yaml"
    asked = "force_angle: {start: 0, stop: 360, step: 15}"
    assert asked in study_text
    path.write_text(study_text.replace(asked, f"force_angle: {given}"), encoding="utf-8")
    with pytest.raises(InvalidFile, match="into at most 100000 steps; change the value"):
        load_study(path)


def test_a_grid_of_more_than_a_terabyte_is_refused(tmp_path, study_text):
    path = tmp_path / "config/file.yaml"
    long = study_text.replace(
        "{start: 0, stop: 360, step: 15}", "{start: 0, stop: 360, step: 0.005}"
    )
    long = long.replace(
        "rod_length: [0, 1, 2, 5]", "rod_length: {start: 0, stop: 5, step: 0.0001}", 1
    )
    path.write_text(long, encoding="utf-8")
    with pytest.raises(
        InvalidFile, match=r"grid: 21600732006 points of limit_curves given; allowed: 10000000000; "
    ):
        load_study(path)


@pytest.mark.parametrize("given", ['"a{b}"', r'"a\0b"', "5", '"a\\nb"'])
def test_a_path_that_the_workflow_cannot_hold_is_refused(tmp_path, study_text, given):
    path = tmp_path / "config/file.yaml"
    path.write_text(f"golden: {given}\n{study_text}", encoding="utf-8")
    with pytest.raises(InvalidFile, match=r"golden: .* given; allowed: a path without") as told:
        load_study(path)
    assert "\n" not in str(told.value)
