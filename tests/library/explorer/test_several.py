"""Scenes with several contacts, or with a wall, on the page."""

from __future__ import annotations

from urllib.parse import parse_qsl
from xml.etree import ElementTree

import numpy as np
import panel as pn
import pytest

import planar_pushing as pp
from planar_pushing.drawing.canvas.marks import Hatch
from planar_pushing.explorer import page as module
from planar_pushing.explorer.address import query, state_in
from planar_pushing.explorer.downloads import download
from planar_pushing.explorer.pictures.following import follow
from planar_pushing.explorer.pictures.pictures import push_box, push_picture, solve_push
from planar_pushing.explorer.presets import SEVERAL, preset, titles
from planar_pushing.explorer.several import FIXED, lines, open_state
from planar_pushing.explorer.state import with_push, with_rod
from planar_pushing.explorer.view import EMPTY, Order, box_of, view
from planar_pushing.scenes.contacts_files import load_contacts_file
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_contacts_file
from planar_pushing.terms.errors import InvalidFile

SIZES = dict.fromkeys(("scene", "curve", "map", "time"), (700.0, 480.0))
WEDGED = """\
contacts:
  - {point: [-0.15, 0.02], normal: [1, 0], law: coulomb, friction_coefficient: 0.5, velocity: [0.1, 0]}
  - {point: [0.15, -0.05], normal: [-1, 0], law: coulomb, friction_coefficient: 0.5}
effects: [{type: support_friction, support: {shape: disc, radius: 0.2}}]
"""


def shown(state):
    markup = view(Order(state, SIZES, box_of(state))).markup
    return markup, {
        name: ElementTree.fromstring(f"<x>{text}</x>")
        for name, text in markup.items()
        if name != "words"
    }


@pytest.mark.parametrize("name", SEVERAL)
def test_a_preset_shows_every_contact_with_both_ends_of_its_force(name):
    file = load_contacts_file(f"workflow/scenes/{name}.yaml")
    state = preset(name)
    assert (state.several, titles()[name]) == (file, file.title)
    markup, trees = shown(state)
    (solution,) = pp.solve_contacts(**file.build())
    lines = list(trees["solutions"].iter("tr"))[2:]
    assert len(lines) == len(solution.modes) == 2
    for k, line in enumerate(lines):
        low, high = (cell.text for cell in list(line.iter("td"))[:2])
        for text, force in ((low, solution.forces[k]), (high, solution.forces_end[k])):
            numbers = [float(word) for word in text.strip("()").split(",")]
            assert numbers == pytest.approx(force, rel=1e-3, abs=1e-9)
    assert markup["words"] == "Contact 1 sticks, contact 2 sticks."
    assert [markup[name] for name in EMPTY] == [""] * len(EMPTY)
    assert len(markup["scene"]) > 2000


def test_no_solution_has_its_reason(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(WEDGED, encoding="utf-8")
    markup, _ = shown(open_state(load_contacts_file(path)))
    assert markup["words"] == "No motion: wedged."
    assert markup["solutions"] == "<p>No consistent solution.</p>"


@pytest.mark.parametrize("name", SEVERAL)
def test_the_address_and_the_saved_scene_are_the_same_scene(name, tmp_path):
    state = preset(name)
    assert state_in(dict(parse_qsl(query(state)))) == state
    (tmp_path / "scene.yaml").write_bytes(download(state, "scene.yaml"))
    assert open_state(load_contacts_file(tmp_path / "scene.yaml")) == state
    ElementTree.fromstring(download(state, "scene.svg"))
    assert len(download(state, "log.nc")) > 1000
    assert download(state, "scene.py").decode() == lines(state.several)


def test_an_address_with_wrong_contacts_is_refused_in_one_line():
    with pytest.raises(InvalidFile) as caught:
        state_in({"contacts": "[]", "effects": "[]"})
    assert str(caught.value).startswith(
        "address: contacts: [] given; allowed: a list with at least"
    )
    assert str(caught.value).endswith("the page shows its first preset instead")


@pytest.mark.parametrize("name", SEVERAL)
def test_the_lines_of_python_give_the_same_log(name, capsys):
    file = preset(name).several
    names = {}
    exec(lines(file), names)
    assert capsys.readouterr().out == f"{pp.solve_contacts(**file.build())}\n"
    own = simulate_contacts_file(file)
    assert names["log"].equals(own)


def test_the_fields_are_fixed_and_the_page_says_so(monkeypatch):
    class Loop:
        waiting: list = []  # noqa: RUF012

        def add_next_tick_callback(self, call):
            self.waiting.append(call)

    monkeypatch.setattr(pn.state, "add_periodic_callback", lambda *given: None)
    page = module.Page(Loop(), preset("figure_03"), "", lambda: None)
    try:
        told = {}
        monkeypatch.setattr(page.screen, "_send_msg", lambda sent: told.update(sent["markup"]))
        page.put(preset("two_fingers"))
        state = page.state
        page._look()
        assert told["note"] == FIXED
        page.change(lambda state: with_push(state, 10.0, 1.0))
        page.fields["friction"].widget.value = 0.9
        page._hear({"kind": "key", "way": [1, 0], "coarse": False, "number": 1})
        assert page.state is state
        page._rest()
        assert "pp.solve_contacts" in told["python"]
        page.put(preset("figure_03"))
        page.change(lambda state: with_push(state, 10.0, 1.0))
        assert page.state.angle == 10.0
        page._look()
        assert told["note"] == ""
    finally:
        page.end()


def test_the_picture_of_a_push_shows_its_walls():
    """The wall is below the box in the world; its hatch is on the side away from the box."""
    state = preset("box_along_a_wall")
    sketch = solve_push(state).sketch
    ((ends, normal),) = sketch.wall_segments
    turn = np.deg2rad(8.0)  # the fence frame has the object's left side, x = -1, along its x axis
    wanted = np.array([np.sin(-turn) * -1.0, np.cos(turn)]) @ np.array([[0, 1], [-1, 0]])
    assert np.abs(normal) == pytest.approx(np.abs(wanted))
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) @ [
        [np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)],
    ] + [0, 1.3]  # fmt: skip
    scene = load_scene_file("workflow/scenes/box_along_a_wall.yaml").build()
    for corner, world in zip([(-1, -1), (1, -1), (1, 1), (-1, 1)], corners, strict=True):
        assert (scene.to_fence(corner, "point") - ends[0]) @ normal == pytest.approx(world[1])
    (hatch,) = (
        mark for mark in push_picture(solve_push(state)).marks if _is_behind(mark, ends, normal)
    )
    assert len(hatch.strokes) > 5
    low, high = push_box(state)
    assert ((low <= ends) & (ends <= high)).all()


def _is_behind(mark, ends, normal):
    return isinstance(mark, Hatch) and ((np.array(mark.strokes)[:, 1] - ends[0]) @ normal < 0).all()


def test_the_walls_of_the_push_are_those_of_the_motion():
    state = preset("box_along_a_wall")
    (wall,), data = solve_push(state).sketch.walls, follow(state).data
    assert wall.point == pytest.approx(data["wall_point"].values[0])
    assert wall.normal == pytest.approx(data["wall_normal"].values[0])


def test_a_slider_that_has_lost_its_outline_has_no_walls():
    state = with_rod(preset("box_along_a_wall"), 1.2, 60.0)
    assert solve_push(state).sketch.walls == ()
    with pytest.raises(
        pp.InvalidValue, match="outline: None given; allowed: the outline of the object"
    ):
        follow(state)
