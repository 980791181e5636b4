"""Object files: what they mean in the body frame, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

BOX = """\
title: A box
units: {length: mm, force: N, time: s}
object:
  outline: [[0, 0], [300, 0], [300, 200], [0, 200]]
  contact: {point: [200, 0]}
contact: {law: coulomb, friction_coefficient: 0.5}
effects:
  - {type: support_friction, weight: 3.53}
simulate:
  pusher_shape: finger
  pusher_angle: 80
  pusher_speed: 20
  duration: 1
"""


def load(tmp_path, text):
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    return pp.load_scene(path)


def test_a_support_that_is_left_out_is_the_outline(tmp_path):
    box = pp.Polygon([(0, 0), (300, 0), (300, 200), (0, 200)])
    same = pp.scene_at(
        (200, 0), effects=[pp.SupportFriction(support=box, weight=3.53)], contact=pp.Coulomb(0.5),
        outline=box, units=pp.Units(length="mm"),
    )  # fmt: skip
    found = load(tmp_path, BOX)
    assert found == same
    assert found.push == pytest.approx((np.deg2rad(80), 20))


SHAPE = """\
object:
  outline: {outline}
  contact: {{point: {point}}}
contact: {{law: coulomb, friction_coefficient: 0.5}}
effects: [{{type: support_friction}}, {{type: viscous, coefficient: 0.1}}]
"""
CORNERS = "[[0, 0], [3, 0], [3, 2], [0, 2]]"
#: Outlines of files, a contact, and the area, centroid, and mean of x^2 + y^2 from it, in closed form.
SHAPES = {
    "corners": (CORNERS, (1, 0), 6, (1.5, 1), 13 / 12),
    "rounded by 0": (f"{{rounded: {{vertices: {CORNERS}, radius: 0}}}}", (1, 0), 6, (1.5, 1), 13 / 12),
    "bulges of 0": ("{bulges: [[0, 0, 0], [3, 0, 0], [3, 2, 0], [0, 2, 0]]}", (1, 0), 6, (1.5, 1), 13 / 12),
    "disc": ("{disc: {radius: 2, center: [1, 0]}}", (1, -2), 4 * np.pi, (1, 0), 2),
    "circle of bulges": ("{bulges: [[-1, 0, 1], [3, 0, 1]]}", (1, -2), 4 * np.pi, (1, 0), 2),
    "round ellipse": ("{ellipse: {a: 2, b: 2}}", (0, -2), 4 * np.pi, (0, 0), 2),
    "ellipse": ("{ellipse: {a: 2, b: 1}}", (0, -1), 2 * np.pi, (0, 0), 5 / 4),
    "half a disc": ("{bulges: [[-1, 0, 0], [1, 0, 1]]}", (0.2, 0), np.pi / 2, (0, 4 / (3 * np.pi)),
                    0.5 - (4 / (3 * np.pi)) ** 2),
    "rounded": (f"{{rounded: {{vertices: {CORNERS}, radius: 1}}}}", (1.2, 0), 2 + np.pi, (1.5, 1), (
        2 * 5 / 12 + np.pi * (0.5 + 0.25) + 2 * 0.5 * 4 / (3 * np.pi) * np.pi) / (2 + np.pi)),
}  # fmt: skip


@pytest.mark.parametrize("name", SHAPES)
def test_a_support_that_is_left_out_is_the_outline_of_any_shape(tmp_path, name):
    outline, point, area, center, square = SHAPES[name]
    scene = load(tmp_path, SHAPE.format(outline=outline, point=[*point]))
    friction, film = (effect.support for effect in scene.effects)
    assert friction == film
    assert scene.to_object(_center(scene), "point") == pytest.approx(center, abs=1e-4)
    assert scene.slider.outline.area == pytest.approx(area, rel=1e-4)
    assert _square(friction, friction.center_of_pressure) == pytest.approx(square, rel=1e-4)
    if np.pi * 4 == area:
        assert friction == pp.Disc(2.0)
    pp.save_scene(scene, tmp_path / "saved.yaml")
    assert pp.load_scene(tmp_path / "saved.yaml") == scene


def _center(scene):
    """The slider's center in the fence frame, which is the center of pressure."""
    slider = scene.slider
    return slider.rod_length * np.array([np.cos(slider.rod_angle), np.sin(slider.rod_angle)])


def _square(support, about):
    """Mean square of the distance from a place, by triangles of a polygon; half the square of a radius."""
    if isinstance(support, pp.Disc):
        return support.radius**2 / 2
    start = np.array(support.vertices) - about
    end = np.roll(start, -1, axis=0)
    turn = start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]
    return (turn * (start * start + start * end + end * end).sum(axis=1)).sum() / 6 / turn.sum()


def test_a_support_that_is_left_out_has_the_holes_of_the_outline(tmp_path):
    outline = pp.Outline([(0, 0), (3, 0), (3, 2), (0, 2)], holes=[pp.Disc(0.5, (1, 1))])
    rows = [["inf" if np.isinf(x) else x for x in row] for row in outline.pieces.tolist()]
    text = SHAPE.format(outline=f"{{pieces: {rows}}}", point=[1, 0])
    (hole,) = load(tmp_path, text.replace("'", "")).effects[0].support.holes
    assert len(hole) > 100


def test_or_its_feet_with_their_names(tmp_path):
    feet = (
        "  feet: [{position: [0, 0], name: a}, {position: [300, 0], weight: 2, name: b}, "
        "{position: [0, 200], name: c}]\n"
    )
    found = load(tmp_path, BOX.replace("  contact: {p", feet + "  contact: {p"))
    support = found.effects[0].support
    assert (support.weights, support.names) == ((1.0, 2.0, 1.0), ("a", "b", "c"))
    assert found.slider.outline is not None


def test_a_scene_of_an_object_comes_back(tmp_path):
    scene = load(tmp_path, BOX)
    pp.save_scene(scene, tmp_path / "saved.yaml", "A box")
    assert pp.load_scene(tmp_path / "saved.yaml") == scene


@pytest.mark.parametrize("angle", np.linspace(0, 2 * np.pi, 23))
def test_at_any_angle(tmp_path, angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    corners = np.array([(0, 0), (3, 0), (3, 2), (0, 2)]) @ turn.T
    scene = pp.scene_at(
        turn @ [1, 0], effects=[pp.SupportFriction(support=pp.Polygon(corners))],
        contact=pp.Coulomb(0.5), outline=corners,
    )  # fmt: skip
    pp.save_scene(scene, tmp_path / "saved.yaml")
    assert pp.load_scene(tmp_path / "saved.yaml") == scene


REFUSED = {
    ("[200, 0]}", "[200, 10]}"): "object.contact.point: (200.0, 10.0) given",
    ("[200, 0]}", "[200, 0], normal: [0, -1]}"): "object.contact.normal: (0.0, -1.0) given; allowed",
    ("[200, 0]}", "[200, 0], normal: [0, 0]}"): "object.contact.normal: (0.0, 0.0) given; allowed",
    ("[200, 0]}", "[0, 0]}"): "object.contact.normal: None given; allowed",
    ("{point: [200, 0]}", "{pint: [200, 0]}"): "did you mean point?",
    ("[300, 200], [0, 200]", "[0, 200], [300, 200]"): "yaml: object.outline: 'edges 1 and 3, from (300, ",
    (", [300, 200], [0, 200]]", "]"): "yaml: object.outline: [[0, 0], [300, 0]] given; allowed: at least",
    ("[300, 200]", "[300, .nan]"): "yaml: object.outline[2][1]: nan given",
    ("[[0, 0], [300, 0], [300, 200], [0, 200]]", "box"): "yaml: object.outline: 'box' given",
    ("  outline: [[0, 0], [300, 0], [300, 200], [0, 200]]\n", ""): "effects[0].support: missing",
    ("  contact: {point: [200, 0]}\n", ""): "object.contact: missing",
    ("support_friction", "ring_friction"): "yaml: effects: [RingFriction(weight=3.53)] given",
    ("length: mm", "length: 3"): "units.length: 3 given; allowed: the name of a unit",
    ("title: A box", "slider: {rod_length: 1}"): "given; allowed: the keys title, object",
}  # fmt: skip


#: Wrong feet of an object, on which an effect rests, and the beginning of each line of the message.
WRONG_FEET = {
    "[{position: [0, 0]}]": ["object.feet.position: [[0, 0]] given; allowed: at least two points"],
    "[{position: [0, 0]}, {position: [1, .nan]}]": ["object.feet[1].position[1]: nan given; allowed"],
    "[{position: [0, 0]}, {position: [1e-200, 0]}]": ["object.feet.position: 1e-200 given; allowed"],
    "[{position: [0, 0]}, {weight: 2}]": ["object.feet[1].position: missing; allowed: a value"],
    "[{position: [1, 0], weight: -1}]": ["object.feet[0].weight: -1 given; allowed: a finite number > 0"],
    "[{position: [0, 0], weight: 1e308}, {position: [1, 0], weight: 1e308}]":
        ["object.feet.weight: 1e+308 given; allowed: numbers with a finite sum"],
    "[{position: [0, 0], name: a}, {position: [1, 0], name: a}]":
        ["object.feet.name: ['a', 'a'] given; allowed: distinct names"],
    "[{position: [0, 0], mass: 1}]": ["object.feet[0].mass: 1 given; allowed: the keys position, weight"],
    "[[0, 0], [1, 0]]": ["object.feet[0]: [0, 0] given", "object.feet[1]: [1, 0] given"],
    "[{position: [0, 0]}, {position: [1e22, 0]}]": ["slider.outline: [["],
}  # fmt: skip


@pytest.mark.parametrize(("feet", "said"), WRONG_FEET.items())
def test_wrong_feet_are_named_by_the_key_in_the_file(tmp_path, feet, said):
    with pytest.raises(pp.InvalidFile) as caught:
        load(tmp_path, BOX.replace("  contact: {p", f"  feet: {feet}\n  contact: {{p"))
    lines = str(caught.value).splitlines()
    assert len(lines) == len(said)
    for line, words in zip(lines, said, strict=True):
        assert line.partition("scene.yaml: ")[2].startswith(words), line


@pytest.mark.parametrize(("change", "said"), REFUSED.items())
def test_bad_input_is_one_line(tmp_path, change, said):
    assert change[0] in BOX
    with pytest.raises(pp.InvalidFile) as caught:
        load(tmp_path, BOX.replace(*change))
    assert said in str(caught.value)
    assert "scene.yaml: " in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1
