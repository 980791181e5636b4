"""Scene files with several contacts: what they mean, that they come back, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.scenes.contacts_files import (
    load_contacts_file,
    save_contacts_file,
)
from planar_pushing.scenes.simulate import simulate_contacts_file

FILES = ("two_fingers", "finger_in_a_corner")
#: Check value 5 of two contacts on four feet.
FEET = """\
contacts:
  - {point: [-0.5, -1], normal: [0, 1], law: coulomb, friction_coefficient: 0.5, velocity: [0, 1]}
  - {point: [0.5, -1], normal: [0, 1], law: coulomb, friction_coefficient: 0.5, velocity: [0, 0.8]}
object: {feet: [{position: [1, 1]}, {position: [-1, 1]}, {position: [-1, -1]}, {position: [1, -1]}]}
effects: [{type: support_friction}]
"""
#: Check value 3: a finger and a floor under a uniform square.
SQUARE = """\
object: {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
contacts:
  - {point: [-1, 0.5], law: coulomb, friction_coefficient: 0.2, velocity: [1, -0.5]}
  - {point: [1, -1], normal: [0, 1], law: coulomb, friction_coefficient: 0.2}
effects: [{type: support_friction}]
"""
#: A tilted square that a finger pushes along a wall, as two lists: pushers and walls.
WALL = """\
object: {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
contacts: [{point: [-1, 0.7], law: coulomb, friction_coefficient: 0.3}]
effects:
  - {type: support_friction, support: {shape: points, positions: [[1, 1], [-1, 1], [-1, -1], [1, -1]]}}
simulate:
  pushers:
    - shape: finger
      frame: world
      waypoints: [{time: 0, x: 0, y: 0}, {time: 2.6, x: 2.6, y: -0.52}, {time: 4, x: 4, y: -0.52}]
  walls: [{point: [0, 0], normal: [0, 1], contact: {law: coulomb, friction_coefficient: 0.2}}]
  object_pose: {x: 0, y: 1.3, angle: 8}
  duration: 4
"""


def write(tmp_path, text):
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "twist", "first", "last"),
    [
        (FEET, (0.2, 0.9, -0.2), (0.1898825005, 0.9128331418), (0.2290585002, 0.9128331418)),
        (SQUARE, (0.938198785, 0.12360243, -0.12360243), (1.056914134, -0.2113828269), None),
    ],
)
def test_check_values(tmp_path, text, twist, first, last):
    (solution,) = pp.solve_contacts(**pp.load_contacts(write(tmp_path, text)))
    assert solution.twist == pytest.approx(twist, rel=1e-8)
    assert solution.forces[0] == pytest.approx(first, rel=1e-8)
    assert solution.forces_end[0] == pytest.approx(last or first, rel=1e-8)


def test_contacts_of_every_kind(tmp_path):
    """A side with a palm that turns, a point with each law, and an inner corner."""
    text = SQUARE.replace(SQUARE[SQUARE.index("  - {point") : SQUARE.index("effects")], """\
  - {side: 0, law: perfectly_rough, twist: {v_y: 3, omega: 57.29577951308232}}
  - {point: [1, 0.5], law: infinite_friction, at_zero_normal: none}
""")  # fmt: skip
    content = pp.load_contacts(write(tmp_path, text))
    assert content["contacts"] == [
        pp.Contact(side=0, law=pp.PerfectlyRough(), twist=(0, 3, 1)),
        pp.Contact((1, 0.5), law=pp.InfiniteFriction(at_zero_normal="none")),
    ]
    assert content["effects"] == [pp.SupportFriction(support=pp.Polygon(content["outline"]))]


PUSHED = (
    SQUARE.replace(", velocity: [1, -0.5]", "")
    + """\
simulate:
  pushers: [{shape: finger, angle: 90, speed: 2}, {shape: finger, angle: 90, speed: 3, frame: world}]
  walls: [{point: [0, 7], normal: [0, -2], contact: {law: coulomb, friction_coefficient: 0.1}}]
  object_pose: {x: 5, y: 6, angle: 90}
  duration: 1
"""
)


def test_pushers_give_the_velocities_at_the_start_and_walls_that_touch_are_contacts(tmp_path):
    """The object's x axis is the world's y axis, so that its right side lies on the wall."""
    finger, other, *wall = pp.load_contacts(write(tmp_path, PUSHED))["contacts"]
    assert finger.velocity == pytest.approx((2, 0))
    assert other.velocity == pytest.approx((3, 0))
    assert sorted(contact.point for contact in wall) == [
        pytest.approx((1, -1)), pytest.approx((1, 1)),
    ]  # fmt: skip
    for contact in wall:
        assert contact.normal == pytest.approx((-1, 0))
        assert (contact.law, contact.velocity) == (pp.Coulomb(0.1), None)


@pytest.mark.parametrize("text", [FEET, SQUARE, WALL, PUSHED])
def test_a_file_comes_back(tmp_path, text):
    file = load_contacts_file(write(tmp_path, text))
    save_contacts_file(file, tmp_path / "saved.yaml")
    assert load_contacts_file(tmp_path / "saved.yaml") == file


@pytest.mark.parametrize(
    "outline",
    [
        [(-1, -1), (0, -1), (1, -1), (1, 1), (-1, 1)],
        [(-1, 1), (1, 1), (1, -1), (-1, -1)],
        pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]),
        pp.Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], holes=[pp.Disc(0.2)]),
        pp.rounded([(-1, -1), (1, -1), (1, 1), (-1, 1)], 0.1),
    ],
)
def test_arguments_come_back_with_the_numbers_of_the_sides(tmp_path, outline):
    """Also of a side that a drawing divides, or that is drawn clockwise."""
    effects = [pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]))]
    contacts = [
        pp.Contact(side=2, law=pp.Coulomb(0.5), twist=(0.1, 0.2, 0.3)),
        pp.Contact((0.3, 1.0), law=pp.InfiniteFriction(), velocity=(0.1, -0.3)),
    ]
    asked = {"contacts": contacts, "effects": effects, "outline": outline}
    pp.save_contacts(**asked, path=tmp_path / "saved.yaml", title="Both")
    loaded = pp.load_contacts(tmp_path / "saved.yaml")
    assert loaded["contacts"] == contacts
    assert loaded["effects"] == effects
    first, second = (pp.solve_contacts(**arguments) for arguments in (asked, loaded))
    assert first.to_json() == second.to_json()
    assert load_contacts_file(tmp_path / "saved.yaml").title == "Both"


def test_without_an_outline(tmp_path):
    effects = [pp.SupportFriction(support=pp.Disc(1.0)), pp.Viscous(support=pp.Disc(1.0))]
    contacts = [pp.Contact((-1, 0), (1, 0), law=pp.Coulomb(0.5), velocity=(1, 0))]
    units = pp.Units(length="mm")
    pp.save_contacts(contacts, tmp_path / "a.yaml", effects=effects, units=units)
    assert pp.load_contacts(tmp_path / "a.yaml") == {
        "contacts": contacts, "effects": effects, "outline": None,
    }  # fmt: skip
    assert load_contacts_file(tmp_path / "a.yaml").units.build() == units


class Own(pp.Disc):
    """A support that files do not know."""


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"title": 3}, "title: 3 given; allowed: text"),
        ({"units": "mm"}, "units: 'mm' given; allowed: a Units"),
        ({"contacts": []}, "contacts: .* a list of one to four Contact"),
        (
            {"contacts": [pp.Contact((0, 0), (1, 0), law=[pp.Coulomb(0.1), pp.Coulomb(0.2)])]},
            "law: ",
        ),
        (
            {"contacts": [pp.Contact((0, 0), (1, 0), law=pp.Coulomb(0), velocity=([1, 2], 0))]},
            "velocity: .* single numbers; save one problem at a time",
        ),
        (
            {"effects": [pp.SupportFriction(support=Own(1.0))]},
            "support: .* the shapes of scene files",
        ),
        ({"path": 3}, "path: 3 given"),
    ],
)
def test_what_cannot_be_saved(tmp_path, changes, said):
    asked = {
        "contacts": [pp.Contact((-1, 0), (1, 0), law=pp.Coulomb(0.5))],
        "effects": [pp.SupportFriction(support=pp.Disc(1.0))],
        "path": tmp_path / "saved.yaml",
    }
    with pytest.raises(pp.InvalidValue, match=said):
        pp.save_contacts(**asked | changes)
    assert not list(tmp_path.iterdir())


def test_a_box_along_a_wall_ends_where_a_linkage_puts_it(tmp_path):
    log = simulate_contacts_file(load_contacts_file(write(tmp_path, WALL)), tmp_path / "log.nc")
    assert log.sizes["contact"] == 2
    when = np.abs(log.time.values - 2.6).argmin()
    assert log.object_position.values[when] == pytest.approx((2.5123106, 1), abs=1e-6)
    assert log.object_position.values[-1] == pytest.approx((3.9123106, 1), abs=1e-6)
    import xarray as xr

    with xr.open_dataset(tmp_path / "log.nc", engine="h5netcdf") as written:
        assert written.equals(log)
        assert written.attrs["scene"] == log.attrs["scene"]


def test_a_finger_in_a_corner_turns_the_tee():
    log = simulate_contacts_file(load_contacts_file("workflow/scenes/finger_in_a_corner.yaml"))
    last = log.isel(time=-1)
    assert last.object_position.values == pytest.approx((-1.3688358, -1.6624202), abs=1e-5)
    assert float(last.object_angle) == pytest.approx(-42.466552, abs=1e-4)


@pytest.mark.parametrize("name", FILES)
def test_examples(name):
    assert len(pp.solve_contacts(**pp.load_contacts(f"workflow/scenes/{name}.yaml"))) == 1


SIX = "contacts: [" + ", ".join(
    f"{{point: [{x}, -1], law: perfectly_rough}}" for x in (-0.5, -0.3, 0, 0.3, 0.5)
) + "]\n"  # fmt: skip
CONTACTS = SQUARE[SQUARE.index("contacts") : SQUARE.index("effects")]
REFUSED = [
    (CONTACTS, "contacts: []\n", "contacts: [] given; allowed: a list with at least one entry"),
    (CONTACTS, "contacts: 3\n", "contacts: 3 given; allowed: a list with at least one entry"),
    (CONTACTS, "contacts: [3]\n", "contacts[0]: 3 given; allowed: a mapping"),
    (CONTACTS, SIX, "contacts: '5 points of contact' given; allowed: at most 4; a side is two"),
    ("law: coulomb, friction_coefficient: 0.2, velocity", "velocity",
     "contacts[0]: {'point': [-1, 0.5], 'velocity': [1, -0.5]} given; allowed: a mapping with the key '"),
    ("law: coulomb", "law: culomb",
     "contacts[0].law: 'culomb' given; allowed: 'coulomb', 'infinite_friction', 'perf"),
    ("friction_coefficient: 0.2", "friction_coefficient: -1",
     "contacts[0].friction_coefficient: -1 given; allowed: a number in [0, 1e+09]"),
    ("friction_coefficient: 0.2, ", "", "contacts[0].friction_coefficient: missing"),
    ("effects", "contact: {law: perfectly_rough}\neffects",
     "contact: {'law': 'perfectly_rough'} given; allowed: either contact or contacts; leave out one"),
    ("[-1, 0.5]", "[-0.5, 0.5]", "contacts[0].point: (-0.5, 0.5) given; allowed: a point on the outline"),
    ("[-1, 0.5]", "[-1, 0.5], normal: [-1, 0]",
     "contacts[0].normal: (-1.0, 0.0) given; allowed: the inward normal"),
    ("[-1, 0.5]", "[-1, .nan]", "contacts[0].point[1]: nan given"),
    ("[-1, 0.5]", "[-1, 0.5, 0]", "contacts[0].point: [-1, 0.5, 0] given; allowed: "),
    ("[1, -1], normal: [0, 1]", "[1, -1]", "contacts[1].normal: None given"),
    ("point: [-1, 0.5]", "side: 7", "contacts[0].side: 7 given; allowed: a whole number from 0 to 3"),
    ("point: [-1, 0.5]", "side: 0, point: [-1, 0.5]",
     "contacts[0].point: (-1.0, 0.5) given; allowed: either a point or a side"),
    ("velocity: [1, -0.5]", "velocity: [1]", "contacts[0].velocity: [1] given; allowed: [v_x, v_y] of"),
    ("velocity: [1, -0.5]", "velocity: [1, x]", "contacts[0].velocity: [1, 'x'] given; allowed: [v_x, v_"),
    ("velocity: [1, -0.5]", "velocity: [1, 0], twist: {omega: 1}",
     "contacts[0].twist: (0.0, 0.0, 0.017453292519943295) given; allowed: either a velocity or a twist"),
    ("velocity: [1, -0.5]", "twist: [1, 0, 0]", "contacts[0].twist: [1, 0, 0] given; allowed: a mapping"),
    ("velocity: [1, -0.5]", "velocty: [1, 0]",
     "contacts[0].velocty: [1, 0] given; allowed: the keys law, friction_coefficient, point, normal, side, "
     "velocity, twist, grip_force; did you mean velocity?"),
    ("point: [1, -1], normal: [0, 1]", "point: [-1, 0.5]", "contacts: 'two contacts at"),
    ("object: {", "object: {contact: {point: [-1, 0]}, ",
     "object.contact: {'point': [-1, 0]} given; allowed: the keys outline, feet"),
    ("object: {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}\n", "",
     "contacts[0].normal: None given; allowed: (n_x, n_y) without an outline"),
    ("[{type: support_friction}]", "[{type: ring_friction}]", "effects: [RingFriction("),
    ("effects", "simulate: {duration: 1}\neffects", "simulate.pushers: missing"),
    ("effects", "simulate: {pusher_angle: 90, duration: 1}\neffects",
     "simulate.pusher_angle: 90 given; allowed: the keys pushers, duration, object_pose, walls, "
     "on_ambiguity, rtol, samples, step; remove the key"),
    ("effects", "simulate: {pushers: [{angle: 90}, {angle: 90}], duration: 1}\neffects",
     "contacts[0].velocity: (1.0, -0.5) given; allowed: none with the section simulate"),
]  # fmt: skip


@pytest.mark.parametrize(("written", "instead", "said"), REFUSED)
def test_bad_input_is_one_line(tmp_path, written, instead, said):
    assert written in SQUARE
    refuse(tmp_path, SQUARE.replace(written, instead, 1), said)


REFUSED_OVER_TIME = [
    ("shape: finger, angle: 90, speed: 2", "shape: finger, radius: 0.1",
     "simulate.pushers[0].angle: None given; allowed: exactly one of angle, velocities and waypoints"),
    ("shape: finger, angle: 90, speed: 2", "radius: 0.1, angle: 9",
     "simulate.pushers[0].radius: 0.1 given; allowed: this key with shape finger only"),
    ("speed: 2}, ", "speed: 2}, {angle: 3}, ",
     "simulate.pushers: '3 pushers' given; allowed: one for each of the 2 contacts"),
    ("angle: 90, speed: 2", "velocities: [{time: 1, angle: 3}]",
     "simulate.pushers[0].velocities: [1.0] given; allowed: times that begin at 0"),
    ("[0, -2]", "[0, 0]", "simulate.walls[0].normal: [0.0, 0.0] given; allowed: a nonzero vector"),
    ("0.1}", "x}", "simulate.walls[0].contact.friction_coefficient: 'x' given; allowed: a number in"),
    ("duration: 1", "duration: 1\n  step: -1", "simulate.step: -1 given; allowed: a finite number > 0"),
    ("duration: 1", "duration: 1\n  until: {mode: STICK}", "simulate.until: {'mode': 'STICK'} given; "),
    ("duration: 1", "duration: 1\n  on_ambiguity: stck", "simulate.on_ambiguity: 'stck' given; "),
    ("[{type: support_friction}]", "[{type: support_friction}, {type: inertia}]",
     "effects[1].type: 'inertia' given; allowed: effects without inertia with the section simulate"),
    ("duration: 1", "duration: 1\nunits: {length: 3}", "units.length: 3 given"),
]  # fmt: skip


@pytest.mark.parametrize(("written", "instead", "said"), REFUSED_OVER_TIME)
def test_bad_motions_are_one_line(tmp_path, written, instead, said):
    assert written in PUSHED
    refuse(tmp_path, PUSHED.replace(written, instead, 1), said)


def test_a_motion_needs_an_outline(tmp_path):
    text = FEET.replace(", velocity: [0, 1]", "").replace(", velocity: [0, 0.8]", "")
    text += "simulate: {pushers: [{angle: 90}, {angle: 90}], duration: 1}\n"
    refuse(
        tmp_path, text, "object.outline: None given; allowed: an outline with the section simulate"
    )


def refuse(tmp_path, text, said):
    path = write(tmp_path, text)
    with pytest.raises(pp.InvalidFile) as caught:
        pp.load_contacts(path)
    line = str(caught.value)
    assert line.startswith(f"{path}: {said}"), line
    assert line.count("\n") == 0


def test_files_of_the_other_kind(tmp_path):
    path = write(tmp_path, SQUARE)
    with pytest.raises(
        pp.InvalidFile, match=r"contacts: .* given; allowed: contact, of one pusher; for"
    ):
        pp.load_scene(path)
    with pytest.raises(pp.InvalidFile, match=r"contacts: missing; .* load_scene"):
        pp.load_contacts("workflow/scenes/box.yaml")
    with pytest.raises(pp.InvalidFile, match="no such file"):
        pp.load_contacts(tmp_path / "none.yaml")
    with pytest.raises(pp.InvalidValue, match="path: 3 given"):
        pp.load_contacts(3)
