"""The section `simulate` of scene files: what it allows, in one message each."""

import numpy as np
import pytest

from planar_pushing import InvalidFile
from planar_pushing.explorer.state import state_of
from planar_pushing.scenes.files import load_scene_file

SCENE = """\
slider: {rod_length: 2, rod_angle: 30}
contact: {law: coulomb, friction_coefficient: 2}
effects:
  - {type: ring_friction}
simulate:
  pusher: [{time: 0, angle: 10}, {time: 0.5, angle: -10, speed: 2}]
  duration: 1.5
"""


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("duration: 1.5", "duration: 0",
         "simulate.duration: 0 given; allowed: a finite number > 0; give the time to simulate"),
        ("duration: 1.5", "durations: 1.5",
         "simulate.durations: 1.5 given; allowed: the keys pusher_angle, pusher_speed, pusher_shape, "
         "pusher_radius, pusher_frame, pusher, waypoints, duration, method, on_ambiguity, rtol, "
         "initial_twist, initial_gap, object_pose, walls, until, samples, step, candidates; "
         "did you mean duration?"),
        ("  duration: 1.5\n", "",
         "simulate.duration: missing; allowed: a value for this key; add it"),
        ("angle: -10", "angle: down",
         "simulate.pusher[1].angle: 'down' given; allowed: a finite number of degrees; change the value"),
        ("pusher: [{time: 0, angle: 10}, {time: 0.5, angle: -10, speed: 2}]", "pusher: []",
         "simulate.pusher: [] given; allowed: a list with at least one entry; change the value"),
        ("duration: 1.5", "duration: 1.5\n  method: euler",
         "simulate.method: 'euler' given; allowed: 'event-driven' or 'time-stepping'; change the value"),
        ("duration: 1.5", "duration: 1.5\n  pusher_shape: fingr",
         "simulate.pusher_shape: 'fingr' given; allowed: 'fence' or 'finger'; did you mean finger?"),
        ("duration: 1.5", "duration: 1.5\n  pusher_shape: 3",
         "simulate.pusher_shape: 3 given; allowed: 'fence' or 'finger'; change the value"),
        ("duration: 1.5", "duration: 1.5\n  on_ambiguity: any",
         "simulate.on_ambiguity: 'any' given; allowed: 'keep-contact', 'separate', 'stay-in-mode', "
         "'stick', 'slip-right' or 'slip-left'; change the value"),
        ("duration: 1.5", "duration: 1.5\n  on_ambiguity: []",
         "simulate.on_ambiguity: [] given; allowed: a list with at least one entry; change the value"),
        ("duration: 1.5", "duration: 1.5\n  on_ambiguity: [{time: 0, policy: slip}]",
         "simulate.on_ambiguity[0].policy: 'slip' given; allowed: 'keep-contact', 'separate', "
         "'stay-in-mode', 'stick', 'slip-right' or 'slip-left'; did you mean slip-right or slip-left?"),
        ("duration: 1.5", "duration: 1.5\n  on_ambiguity: [{time: 0, mode: stick}]",
         "simulate.on_ambiguity[0].mode: 'stick' given; allowed: the keys time, policy; remove the key"),
        ("duration: 1.5", "duration: 1.5\n  pusher_frame: word",
         "simulate.pusher_frame: 'word' given; allowed: 'fence' or 'world'; did you mean world?"),
        ("duration: 1.5", "duration: 1.5\n  until: {rotation: 721}",
         "simulate.until.rotation: 721 given; allowed: degrees in (0, 720]; give a rotation of at most two "
         "turns"),
        ("duration: 1.5", "duration: 1.5\n  object_pose: {x: 1, y: 2}",
         "simulate.object_pose.angle: missing; allowed: a value for this key; add it"),
    ],
)  # fmt: skip
def test_error(tmp_path, written, instead, said):
    assert written in SCENE
    assert message(tmp_path, SCENE.replace(written, instead, 1)) == said


PIECES = "pusher: [{time: 0, angle: 10}, {time: 0.5, angle: -10, speed: 2}]"
ORDER = "times that begin at 0 and increase; put them in order"


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("duration", "pusher_angle: 3\n  duration",
         "pusher: 'pusher_angle and pusher' given; allowed: exactly one of pusher_angle, pusher and "
         "waypoints; remove the others"),
        (f"{PIECES}\n  ", "", "pusher_angle: None given; allowed: exactly one of pusher_angle, pusher and "
         "waypoints; give one of them"),
        (PIECES, "waypoints: [{time: 0, x: 0, y: 0}]",
         "waypoints: 1 given; allowed: at least two waypoints; add one"),
        (PIECES, "waypoints: [{time: 0, x: 0, y: 0}, {time: 0, x: 0, y: 1}]",
         f"waypoints: [0.0, 0.0] given; allowed: {ORDER}"),
        ("duration", "pusher_frame: world\n  duration", "pusher_frame: 'world' given; allowed: this key "
         "with an object_pose only; give the pose of the object at time 0"),
        ("duration", "pusher_radius: 0.1\n  duration", "pusher_radius: 0.1 given; allowed: this key with "
         "pusher_shape finger only; leave it out: a fence is a line"),
        ("duration", "pusher_speed: 3\n  duration", "pusher_speed: 3.0 given; allowed: this key with "
         "pusher_angle only; give each piece of pusher its own speed"),
        ("{time: 0, ", "{time: 0.1, ", f"pusher: [0.1, 0.5] given; allowed: {ORDER}"),
        ("duration", "on_ambiguity: [{time: 1, policy: stick}]\n  duration",
         f"on_ambiguity: [1.0] given; allowed: {ORDER}"),
        ("duration", "step: 0.1\n  duration", "step: 0.1 given; allowed: this key with the method "
         "time-stepping only; leave it out: rtol controls the steps"),
        ("duration", "initial_twist: {omega: 3}\n  duration", "initial_twist: {'v_x': 0.0, 'v_y': 0.0, "
         "'omega': 3.0} given; allowed: this key with inertia among the effects only; leave it out, or add "
         "inertia"),
    ],
)  # fmt: skip
def test_contradiction(tmp_path, written, instead, said):
    assert message(tmp_path, SCENE.replace(written, instead, 1)) == f"simulate.{said}"


def test_unknown_events_and_several_conditions(tmp_path):
    until = SCENE + "  until: {event: SLIP_END}\n"
    said = message(tmp_path, until)
    assert said.startswith("simulate.until.event: 'SLIP_END' given; allowed: 'LEAVES_CONE', ")
    assert said.endswith("did you mean SLIP_ENDS?")
    allowed = "allowed: an event, a mode, or some of rotation, distance and pusher_distance"
    for given in ("{}", "{event: KINK, mode: STICK}", "{mode: STICK, distance: 1}"):
        assert allowed in message(tmp_path, SCENE + f"  until: {given}\n")


def message(tmp_path, text):
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_scene_file(path)
    return str(caught.value).removeprefix(f"{path}: ")


WORLD = """\
slider: {rod_length: 2, rod_angle: 30}
placement: {point: [1, 0], normal: [-1, 0]}
contact: {law: coulomb, friction_coefficient: 2}
effects:
  - {type: ring_friction}
simulate:
  waypoints: [{time: 0, x: 0, y: 0}, {time: 2, x: 0, y: 4}, {time: 3, x: -3, y: 8}]
  object_pose: {x: 5, y: 6, angle: 90}
  pusher_frame: world
  duration: 4
"""


def test_pieces_are_the_legs_between_waypoints_along_the_fence(tmp_path):
    """The normal, the object's -x, is along the world's -y, and so the fence along the world's -x."""
    path = tmp_path / "scene.yaml"
    path.write_text(WORLD, encoding="utf-8")
    file = load_scene_file(path)
    own = [(piece.time, piece.angle, piece.speed) for piece in file.simulate.pieces]
    assert own[0] == (0, 90, 2)
    assert own[1] == (2, pytest.approx(126.86989764584402), 5)
    assert own[2] == (3, 0, 0)
    assert [piece.angle for piece in file.pieces[:2]] == pytest.approx([-90, -53.13010235415598])
    assert file.build().push == (pytest.approx(-np.pi / 2), 2)
    (along,) = {each.simulate.pusher_frame for each in (file, state_of(file).file)} - {"world"}
    assert along == "fence"
    assert state_of(file).file.simulate.pusher == file.pieces
    path.write_text(WORLD.replace("world", "fence"), encoding="utf-8")
    assert load_scene_file(path).build().push == (pytest.approx(np.pi / 2), 2)
