"""Supports in scene files: each shape is read, built and written, and what makes none is one message."""

from __future__ import annotations

import pytest

import planar_pushing as pp
from planar_pushing.commands import main

HEAD = """\
slider: {rod_length: 2, rod_angle: 80}
contact: {law: coulomb, friction_coefficient: 0.4}
effects:
  - type: support_friction
    support: """
SHAPES = {
    "{shape: ring, radius: 0.5}": pp.Ring(0.5),
    "{shape: points, positions: [[0, 1], [1, 0]], weights: [1, 3]}": pp.Points(
        [(0, 1), (1, 0)], [1, 3]
    ),
    "{shape: segment, start: [0, -1], end: [0, 1]}": pp.Segment((0, -1), (0, 1)),
    "{shape: disc, radius: 2, center: [1, 0]}": pp.Disc(2.0, center=(1, 0)),
    "{shape: annulus, inner: 1, outer: 2}": pp.Annulus(1.0, 2.0),
    "{shape: polygon, vertices: [[0, 0], [2, 0], [0, 1]]}": pp.Polygon([(0, 0), (2, 0), (0, 1)]),
    "{shape: polygon, vertices: [[0, 0], [4, 0], [0, 4]], holes: [[[1, 1], [2, 1], [1, 2]]]}": (
        pp.Polygon([(0, 0), (4, 0), (0, 4)], [[(1, 1), (2, 1), (1, 2)]])
    ),
    "{shape: pressure_map, x: [0, 1, 2], y: [0, 1], pressure: [[1, 2]]}": pp.PressureMap(
        [0, 1, 2], [0, 1], [[1, 2]]
    ),
    "{shape: composite, members: [{share: 1, support: {shape: disc, radius: 1}}, "
    "{share: 2, support: {shape: segment, start: [0, 0], end: [1, 1]}}]}": pp.Composite(
        [(1, pp.Disc(1.0)), (2, pp.Segment((0, 0), (1, 1)))]
    ),
}


@pytest.mark.parametrize(("text", "support"), SHAPES.items(), ids=lambda each: str(each)[:16])
def test_each_shape_is_read_and_written(tmp_path, text, support):
    (tmp_path / "scene.yaml").write_text(HEAD + text + "\n", encoding="utf-8")
    scene = pp.load_scene(tmp_path / "scene.yaml")
    assert scene.effects == (pp.SupportFriction(support=support),)
    assert scene.slider.radius == support.extent
    pp.save_scene(scene, tmp_path / "again.yaml")
    assert pp.load_scene(tmp_path / "again.yaml") == scene


BOW_TIE = "{shape: polygon, vertices: [[0, 0], [2, 2], [2, 0], [0, 3]]}"
#: Of what makes no support the key in the support, and what the line says of it, for each kind of mistake.
REFUSED = {
    "{shape: polygn}": (
        ".shape", "'polygn' given; allowed: 'ring', 'points', 'segment', 'disc', 'annulus', 'polygon',",
    ),
    "{shape: disc, radius: 1, centre: [0, 0]}": (".centre", "did you mean center?"),
    "{shape: rectangle, width: 1}": (".height", "missing"),
    "{shape: disc, radius: 0}": (
        ".radius", "0 given; allowed: a finite number > 0; use Points for a support on one point",
    ),
    "{shape: polygon, vertices: [[0, 0], [1, 0], [1, .nan]]}": (
        ".vertices[2][1]", "nan given; allowed: finite numbers",
    ),
    BOW_TIE: (
        ".vertices",
        "'edges 0 and 2, from (0, 0) to (2, 2) and from (2, 0) to (0, 3)' given; allowed: a simple polygon",
    ),
    f"{{shape: composite, members: [{{share: 1, support: {BOW_TIE}}}]}}": (
        ".members[0].support.vertices", "'edges 0 and 2",
    ),
    "{shape: polygon, vertices: [[0, 0], [4, 0], [0, 4]], holes: [[[1, 1], [2, 1], [1, 4]]]}": (
        ".holes[0]",
        "'from (2, 1) to (1, 4), which meets from (4, 0) to (0, 4)' given; allowed: a hole inside of",
    ),
    "{shape: points, positions: [[0, 1], [1, 1]], weights: [2]}": (
        ".weights", "(2.0,) given; allowed: 2 weights; give one weight for each point",
    ),
    "{shape: points, positions: [[0.1, 0.2], [0.1, 0.2], [0.1, 0.2]], weights: [0.3, 0.3, 0.1]}": (
        "", "allowed: a support with more than one point, since a single point resists no rotation",
    ),
    "{shape: pressure_map, x: [0, 1, 2], y: [0, 1], pressure: [[1, 2, 3]]}": (
        ".pressure", "((1.0, 2.0, 3.0),) given; allowed: 1 row of 2 numbers, to fit y and x",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "said"), REFUSED.items())
def test_what_makes_no_support_is_one_message(tmp_path, text, said):
    (tmp_path / "scene.yaml").write_text(HEAD + text + "\n", encoding="utf-8")
    with pytest.raises(pp.InvalidFile) as error:
        pp.load_scene(tmp_path / "scene.yaml")
    key, words = said
    assert f"scene.yaml: effects[0].support{key}: " in str(error.value)
    assert words in str(error.value)
    assert len(str(error.value).splitlines()) == 1


def test_the_command_line_says_it_in_one_line(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(f"{HEAD}{BOW_TIE}\n", encoding="utf-8")
    assert main(["cone", str(tmp_path / "scene.yaml")]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "effects[0].support.vertices: 'edges 0 and 2" in said
