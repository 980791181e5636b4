"""Golden data change by an explicit command alone, which prints the changes and is not green."""

import pytest

from planar_pushing.evidence.golden import update
from planar_pushing.evidence.golden.build import pictures
from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.figures import images
from planar_pushing.study.store import read_dataset, write_dataset
from planar_pushing.study.study_file import load_study

SMOKE = "workflow/config/smoke.yaml"


@pytest.fixture(scope="module")
def few():
    """Golden data of two small files."""
    values = update.plain(load_study(SMOKE))
    files = {name: pictures.figure(name, values) for name in ("figure_01", "figure_07")}
    return {name: data.assign_attrs(checked_by_integrals=3) for name, data in files.items()}


@pytest.fixture
def command(few, monkeypatch, tmp_path, capsys):
    """Run the command on these files; its status and what it printed."""
    monkeypatch.setattr(
        update, "golden_files", lambda _: {name: data.copy() for name, data in few.items()}
    )

    def run(*arguments):
        code = update.main(["--study", SMOKE, "--golden", str(tmp_path), *arguments])
        return code, capsys.readouterr().out

    return run


def test_nothing_is_stored_unasked(command, tmp_path):
    code, said = command()
    assert code == 1
    assert "figure_01: new, with 3 variables" in said
    assert "nothing was stored" in said
    assert not list(tmp_path.iterdir())


def test_storing_is_not_green_and_checking_again_is(command):
    assert command("--write")[0] == 1
    code, said = command()
    assert code == 0
    assert (
        "figure_01: unchanged\nfigure_07: unchanged\n6 numbers lie in the enclosures of both routes"
        in said
    )
    assert "0 differences" in said


def test_differences_are_printed(command, tmp_path):
    command("--write")
    stored = read_dataset(tmp_path / "figure_07.nc")
    stored["motion_cone_left"][0] += 1e-9
    stored["gone"] = stored["motion_cone_right"]
    stored["motion_cone_right"].attrs["units"] = "radian"
    before = stored.copy()
    write_dataset(stored, tmp_path / "figure_07.nc")
    code, said = command()
    assert code == 1
    assert "figure_07: gone is no longer certified" in said
    assert "figure_07: motion_cone_left changes at 1 of 3 points" in said
    assert "figure_07: motion_cone_right has other units or flags" in said
    assert read_dataset(tmp_path / "figure_07.nc").identical(before)


def test_enclosures_are_narrow(few):
    for data in few.values():
        for name in golden_variables(data):
            if f"{name}_radius" in data:
                assert (data[f"{name}_radius"] <= 1e-25 * abs(data[name])).all()


def test_images_are_stored_by_command_alone(tmp_path, capsys):
    from PIL import Image

    for path in images.pictures(tmp_path / "results").values():
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.new("RGB", (900, 600), "white").save(path)
    arguments = ["--results", str(tmp_path / "results"), "--golden", str(tmp_path / "golden")]
    assert images.main(arguments) == 1
    assert not (tmp_path / "golden").exists()
    assert images.main([*arguments, "--write"]) == 1
    assert images.main(arguments) == 0
    Image.new("RGB", (900, 600), "black").save(tmp_path / "results/figures/figure_05.png")
    capsys.readouterr()
    assert images.main(arguments) == 1
    assert "figure_05: differs, 255.00 colour levels" in capsys.readouterr().out
