"""The command `convert`, with right and with wrong files."""

import json
import shutil

import numpy as np
import pytest
from pushes.test_round import OUTLINES
from pushes.test_round import pushed as pushed_round
from pushes.written import TRIANGLE, feet, write_log, write_mat

import planar_pushing as pp
from planar_pushing.commands import main
from planar_pushing.pushes.logs.schema import outline_of


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


TABLE = "paper/manual/examples/own_pushes.csv"
CORNERS = "[[-60, -40], [60, -40], [60, 40], [-60, 40]]"


def test_a_table_becomes_a_dataset_that_identify_and_compare_take(run, tmp_path):
    outline, path = tmp_path / "box.yaml", str(tmp_path / "pushes.nc")
    outline.write_text(CORNERS, encoding="utf-8")
    options = ["--outline", str(outline), "--finger-radius", "5", "--noise", "0.3", "0.2", "0.03"]
    again = shutil.copy(TABLE, tmp_path / "again.csv")
    files = [TABLE, str(again)]
    code, out, err = run("convert", "csv", *files, "-o", path, *options, "--object", "box")
    assert (code, err) == (0, "")
    assert out.splitlines() == [f"written: {path}", "pushes: 10", "objects: box", "left_out: 0"]
    found = pp.load_pushes(path)
    assert (found.attrs["angle_noise"], found["finger_radius"].values.tolist()) == (0.2, [5.0] * 10)
    assert found["contact"].attrs["units"] == "mm"
    support = str(tmp_path / "support.yaml")
    code, out, _ = run("identify", path, "--family", "uniform_and_corners", "-o", support, "--json")
    assert (code, round(json.loads(out)["weight"], 1)) == (0, 4.0)  # the true weight is 4 N
    assert run("compare", path)[0] == 0


def test_a_wrong_table_writes_nothing(refused, tmp_path):
    outline, wrong = tmp_path / "box.yaml", tmp_path / "wrong.yaml"
    outline.write_text(CORNERS, encoding="utf-8")
    wrong.write_text("[[0, 0], [1, 1]]", encoding="utf-8")
    box, path = ["--outline", str(outline)], ["-o", str(tmp_path / "pushes.nc")]
    for arguments, said in (
        (["csv", TABLE, *path], "outline: missing; allowed: YAML file of the object's corners, "),
        (["csv", TABLE, *path, "--outline", "none.yaml"], "none.yaml: no such file; "),
        (["csv", TABLE, *path, "--outline", str(wrong)], f"{wrong}: outline: "),
        (["csv", TABLE, *path, "--outline", "workflow/scenes/figure_03.yaml"],
         "workflow/scenes/figure_03.yaml: holds no outline; allowed: a list of corners"),
        (["csv", "none.csv", *path, *box], "none.csv: cannot be read (No such file or directory); "),
        (["csv", str(tmp_path), *path, *box], f"{tmp_path}: cannot be read (Is a directory); name a table"),
        (["csv", str(outline), *path, *box], f"{outline}: unknown column "),
        (["csv", TABLE, TABLE, *path, *box], "files: 'two files named own_pushes' given; "),
        (["csv", TABLE, *path, *box, "--angles", "degree"],
         "angles: 'degree' given; allowed: degrees, radians; did you mean degrees?"),
        (["csv", TABLE, *path, *box, "--angles", "radians"],
         f"{TABLE}: line 5: angle_before: -154.1 given; allowed: radians of at most two turns; give "),
        (["csv", TABLE, *path, *box, "--finger-radius", "-5"],
         "finger_radius: -5.0 given; allowed: a number >= 0; give 0 for a point"),
        (["csv", TABLE, *path, *box, "--noise", "0.3", "nan", "0"],
         "noise: nan given; allowed: three finite numbers >= 0; give 0 for none"),
        (["csv", TABLE, *path, *box, "--units", "mm", ""], f"{TABLE}: units: ['mm', ''] given; "),
        (["csv", TABLE, *path, *box, "--finger-radius", "50"],
         f"{TABLE}: finger_start: 'a finger that begins 37.96 deep in the object, in pushes 0, 1, 2, 3, "),
        (["csv", TABLE, *path, *box, "--tolerance", "-1"], f"{TABLE}: tolerance: -1.0 given; "),
        (["mit", TABLE, *path, "--finger-radius", "5"],
         "finger_radius: 5.0 given; allowed: this option with the format csv only; leave it out"),
    ):  # fmt: skip
        refused(["convert", *arguments], said)
    refused(
        ["identify", TABLE, "-o", str(tmp_path / "support.yaml")],
        f"{TABLE}: is not a netCDF4 file of pushes; convert it with planar-pushing convert csv",
    )
    assert sorted(file.name for file in tmp_path.iterdir()) == ["box.yaml", "wrong.yaml"]


@pytest.mark.parametrize(("words", "remedy"), [
    (["own_pushes.csv"], "type planar-pushing convert csv own_pushes.csv"),
    (["own_pushes.csv", "b.csv"], "type planar-pushing convert csv own_pushes.csv"),
    (["own pushes.MAT"], "type planar-pushing convert mit 'own pushes.MAT'"),
    (["10_130.txt"], "type planar-pushing convert three-feet 10_130.txt"),
    (["three-foot", "10_130.txt"], "did you mean three-feet?"),
    (["own_pushes"], "name one of these formats"),
], ids=str)  # fmt: skip
def test_a_file_in_place_of_the_format(capsys, words, remedy):
    with pytest.raises(SystemExit, match="2"):
        main(["convert", *words, "-o", "b.nc", "--outline", "box.yaml"])
    assert capsys.readouterr().err == (
        f"planar-pushing convert: argument FORMAT: {words[0]!r} given; allowed: csv, three-feet, mit; "
        f"{remedy}; see planar-pushing convert --help\n"
    )


@pytest.mark.parametrize("radius", ["1e308", "1e200"])
def test_a_finger_as_large_as_numbers_go_is_refused_without_a_warning(refused, tmp_path, radius):
    outline, path = tmp_path / "box.yaml", tmp_path / "pushes.nc"
    outline.write_text(CORNERS, encoding="utf-8")
    words = ["csv", TABLE, "--outline", str(outline), "--finger-radius", radius, "-o", str(path)]
    refused(["convert", *words], f"{TABLE}: finger_start: 'a finger that begins 1e+")
    assert not path.exists()


def test_wrong_input_writes_nothing(refused, tmp_path, pushes):
    file, path = tmp_path / "patch.txt", tmp_path / "pushes.nc"
    lines = write_log(file, pushes, np.random.default_rng(1))
    file.write_text("\n".join(lines[:50]))
    for arguments, said in (
        (["three-feet", str(file), "-o", str(path)], f"{file}: cut short in push 1 of 3 after line 50"),
        (["mit", str(file), "-o", str(path)], f"{file}: a name without a known shape; allowed: "),
        (["three-feet", str(file), "-o", "pushes.csv"],
         "output: 'pushes.csv' given; allowed: a name ending in .nc or .h5; rename the file"),
        (["three-feet", str(file), "-o", str(tmp_path / "none" / "pushes.nc")], "output: "),
    ):  # fmt: skip
        refused(["convert", *arguments], said)
    assert [each.name for each in tmp_path.iterdir()] == ["patch.txt"]


@pytest.mark.parametrize("kind", [kind for kind in OUTLINES if OUTLINES[kind][1]])
def test_tables_with_an_outline_of_a_file(kind, run, tmp_path):
    """From the command line: the dataset is that of the pushes, and the support becomes a scene."""
    pushes = pushed_round(kind, 16, finger_radius=4.0)
    file, table, output = (tmp_path / name for name in ("outline.yaml", "one.csv", "pushes.nc"))
    file.write_text(json.dumps(OUTLINES[kind][1]), encoding="utf-8")
    center = (pushes["contact"] - pushes["finger_radius"] * pushes["normal"]).values
    columns = {
        **dict.fromkeys(("x_before", "y_before", "angle_before"), np.zeros(16)),
        "x_after": pushes["displacement"].values[:, 0], "y_after": pushes["displacement"].values[:, 1],
        "angle_after": pushes["rotation"].values, "x_start": center[:, 0], "y_start": center[:, 1],
        "x_end": (center + pushes["finger_displacement"].values)[:, 0],
        "y_end": (center + pushes["finger_displacement"].values)[:, 1],
    }  # fmt: skip
    rows = [
        ",".join(columns),
        *(",".join(map(repr, map(float, row))) for row in zip(*columns.values(), strict=True)),
    ]
    table.write_text("\n".join(rows), encoding="utf-8")
    code, _, err = run(
        "convert",
        "csv",
        str(table),
        "--outline",
        str(file),
        "--finger-radius",
        "4",
        "-o",
        str(output),
    )
    assert (code, err) == (0, "")
    read = pp.load_pushes(output)
    assert outline_of(read, "one") == OUTLINES[kind][0]
    assert read["contact"].values == pytest.approx(pushes["contact"].values, abs=1e-6)
