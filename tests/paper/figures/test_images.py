"""The comparison with stored images."""

import numpy as np
import pytest
from PIL import Image

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures import images


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """Results with one picture, and a folder of golden data."""
    picture = tmp_path / "figure.png"
    Image.fromarray(np.full((60, 90, 3), 200, np.uint8)).save(picture)
    monkeypatch.setattr(images, "every_picture", lambda results: {"figure": picture})
    return picture, tmp_path / "golden"


def test_a_picture_is_stored_and_then_unchanged_until_it_differs(folders, capsys):
    picture, golden = folders
    arguments = ["--golden", str(golden)]
    for more, code, said in (
        ([], 1, "differs, inf"),
        (["--write"], 1, "differs, inf"),
        ([], 0, "unchanged, 0.00"),
    ):
        assert images.main([*arguments, *more]) == code
        assert capsys.readouterr().out == f"figure: {said} color levels\n"
    stored = golden / "images/figure.png"
    with Image.open(stored) as image:
        assert image.size == (round(90 * images.STORED_SCALE), round(60 * images.STORED_SCALE))
    Image.fromarray(np.full((60, 90, 3), 190, np.uint8)).save(picture)
    assert images.difference(picture, stored) == pytest.approx(10)
    Image.fromarray(np.full((90, 90, 3), 200, np.uint8)).save(picture)
    assert images.difference(picture, stored) == np.inf


def test_a_missing_picture_is_one_line(tmp_path):
    with pytest.raises(InvalidFile, match=r"no such picture; build it with make or snakemake$"):
        images.thumbnail(tmp_path / "none.png")


def test_the_pictures_are_those_of_both_default_studies_and_of_measured_pushes(tmp_path):
    found = images.every_picture(tmp_path)
    assert found["figure_01"] == tmp_path / "figures/figure_01.png"
    assert (
        found["friction_for_pulling"]
        == tmp_path / "studies/sliders/figures/friction_for_pulling.png"
    )
    assert found["measured_pressures"] == tmp_path / "figures/measured_pressures.png"
