"""Supports in scene files: each shape is read, built and written, and what makes none is one message."""

from __future__ import annotations

import pytest

import planar_pushing as pp

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


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{shape: polygn}", "allowed: 'shape' one of 'ring', 'points', "),
        ("{shape: polygon, vertices: [[0, 0], [1, 0]]}", "allowed: vertices: "),
        (
            "{shape: disc, radius: 0}",
            "effects[0].support.radius: 0 given; allowed: a finite number > 0",
        ),
        ("{shape: disc, radius: 1, center: [0, .nan]}", "two finite numbers, [x, y] in the body"),
        ("{shape: points, positions: [[0, 1]], weights: [-1]}", "allowed: weights"),
        ("{shape: annulus, inner: 2, outer: 1}", "effects[0].support: "),
        ("{shape: disc, radius: 1, centre: [0, 0]}", "did you mean center?"),
    ],
)
def test_what_makes_no_support_is_one_message(tmp_path, text, said):
    (tmp_path / "scene.yaml").write_text(HEAD + text + "\n", encoding="utf-8")
    with pytest.raises(pp.InvalidFile) as error:
        pp.load_scene(tmp_path / "scene.yaml")
    assert said in str(error.value)
    assert len(str(error.value).splitlines()) == 1
