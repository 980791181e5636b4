"""What is cut away around a picture is white."""

import pytest
from PIL import Image, ImageDraw

from planar_pushing.report.margins import KEPT, margins
from planar_pushing.terms.errors import InvalidFile


def test_margins_are_those_of_what_is_drawn(tmp_path):
    image = Image.new("RGB", (100, 200), "white")
    ImageDraw.Draw(image).rectangle((20, 50, 40, 159), fill="blue")
    image.save(tmp_path / "picture.png", dpi=(144, 144))
    found = margins(tmp_path / "picture.png")
    assert found == pytest.approx({"top": 25 - KEPT, "bottom": 20 - KEPT}, abs=0.1)


def test_a_picture_up_to_its_edge_keeps_it(tmp_path):
    Image.new("RGB", (10, 10), "black").save(tmp_path / "picture.png")
    assert margins(tmp_path / "picture.png") == {"top": 0.0, "bottom": 0.0}


def test_an_empty_or_missing_picture_is_refused(tmp_path):
    Image.new("RGB", (10, 10), "white").save(tmp_path / "picture.png")
    with pytest.raises(
        InvalidFile, match=r"picture\.png: shows nothing; remove it and build it anew"
    ):
        margins(tmp_path / "picture.png")
    with pytest.raises(InvalidFile, match=r"none\.png: no such picture"):
        margins(tmp_path / "none.png")
