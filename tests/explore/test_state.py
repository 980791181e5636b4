"""States: changes of them, and the ways out and back."""

from dataclasses import replace
from urllib.parse import parse_qsl

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.explore.address import query, state_in
from planar_pushing.explore.downloads import written
from planar_pushing.explore.following import chosen, followed, forgotten, row_at, taken, ways_at
from planar_pushing.explore.handles import Handle, dragged, nudged, places
from planar_pushing.explore.presets import STORED, gallery, preset, presets, text
from planar_pushing.explore.python_lines import lines
from planar_pushing.explore.state import (
    Start,
    effect,
    pushed,
    simulated,
    state_of,
    with_effect,
    with_law,
    with_rod,
    with_size,
    with_support,
)
from planar_pushing.explore.supports import name_in
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EffectKind

PRESETS = list(presets())
MODES = {
    "stick": pp.ContactMode.STICK,
    "slip-right": pp.ContactMode.SLIP_RIGHT,
    "slip-left": pp.ContactMode.SLIP_LEFT,
    "separate": pp.ContactMode.SEPARATE,
}


def back(state):
    return state_in(dict(parse_qsl(query(state))))


def solved(state):
    return pp.solve(state.scene, np.deg2rad(state.angle), state.magnitude)


@pytest.mark.parametrize("name", PRESETS)
def test_an_address_holds_the_whole_state(name):
    state = preset(name)
    assert back(state) == state
    other = replace(
        pushed(with_rod(state, 1.25, 70.5), -12.3, 0.7),
        shown="STICK",
        across="rod angle",
        time=0.25,
    )
    assert back(other) == other


@pytest.mark.parametrize("name", PRESETS)
def test_a_saved_scene_is_the_same_scene(name, tmp_path):
    state = preset(name)
    (tmp_path / "scene.yaml").write_bytes(written(state, "scene.yaml"))
    file = load_scene_file(tmp_path / "scene.yaml")
    assert file.build() == state.scene
    if state.start == Start.VELOCITY:
        assert state_of(file) == state


@pytest.mark.parametrize("name", ["figure_03", "figure_19", "figure_08"])
def test_the_lines_of_python_give_the_same_result(name, capsys):
    state = taken(replace(preset(name), time=0.1), "separate")
    found = {}
    exec(lines(state), found)
    capsys.readouterr()
    assert found["scene"] == state.scene
    assert found["solutions"] == solved(state)
    own = followed(state).log
    assert found["log"].identical(own)


def test_the_lines_accelerate_a_pusher_from_rest(capsys):
    state = pushed(preset("figure_13"), 170.0, 2.0)
    assert state.start == Start.ACCELERATION
    found = {}
    exec(lines(state), found)
    capsys.readouterr()
    own = followed(state).log
    np.testing.assert_array_equal(found["log"].rod_angle, own.rod_angle)
    turn, way = np.deg2rad(170.0), own.time[-1].item() ** 2  # half of the acceleration, 2
    np.testing.assert_allclose(own.fence[-1], [way * np.cos(turn), way * np.sin(turn)])


def test_the_presets_are_those_of_the_studies():
    assert STORED.read_text(encoding="utf-8") == text()


def test_every_figure_has_a_preset():
    figures = {name.removeprefix("figure_")[:2] for name in PRESETS if name.startswith("figure")}
    assert figures == {f"{number:02}" for number in range(1, 21)}


@pytest.mark.parametrize("name", list(gallery()))
def test_a_support_of_the_gallery_keeps_its_name_at_any_size(name):
    state = with_support(preset("figure_13"), None if name == "ring" else gallery()[name])
    for size in (0.3, 1.0, 2.7):
        large = with_size(state, size)
        assert large.size == pytest.approx(size)
        support = effect(large, EffectKind.SUPPORT_FRICTION).get("support")
        assert name_in(gallery(), support, large.size) == name


def test_an_own_support_has_no_name():
    state = preset("plate")
    assert (
        name_in(gallery(), effect(state, EffectKind.SUPPORT_FRICTION)["support"], state.size) == ""
    )


def test_one_effect_at_least_stays():
    state = preset("figure_03")
    assert with_effect(state, EffectKind.SUPPORT_FRICTION, None) == state


def test_inertia_starts_the_pusher_from_rest():
    state = with_effect(preset("figure_03"), EffectKind.INERTIA, {"type": "inertia"})
    assert state.start == Start.ACCELERATION
    assert with_effect(state, EffectKind.INERTIA, None).start == Start.VELOCITY


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "figure_19", "figure_09a"])
def test_a_handle_is_dragged_to_where_it_is_dropped(name):
    state = preset(name)
    force = solved(state)[-1].force
    for handle in (Handle.PUSHER, Handle.ROD):
        place = np.array([0.4, 0.9])
        moved = places(dragged(state, handle, place), force)[handle]
        angle = [np.arctan2(*each[::-1]) for each in (moved, place)]
        assert angle[0] == pytest.approx(angle[1])
    assert places(dragged(state, Handle.ROD, place), force)[Handle.ROD] == pytest.approx(place)


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "figure_19", "figure_09a", "figure_16"])
@pytest.mark.parametrize("degrees", [70.0, 95.0])
def test_a_line_of_force_is_that_of_the_push_that_sticks(name, degrees):
    state = with_law(preset(name), {"law": "coulomb", "friction_coefficient": 2})
    angle = np.deg2rad(degrees)
    moved = dragged(state, Handle.LINE, np.array([np.cos(angle), np.sin(angle)]))
    stick = next(each for each in solved(moved) if each.mode == pp.ContactMode.STICK)
    assert np.arctan2(*stick.force[::-1]) == pytest.approx(angle, abs=2e-3)


def test_a_line_of_force_where_a_share_of_inertia_does_not_determine_the_motion():
    inertia = {"type": "inertia", "center": [0.1, 0.2]}
    state = with_effect(preset("figure_19"), EffectKind.INERTIA, inertia)
    state = with_law(state, {"law": "coulomb", "friction_coefficient": 2})
    moved = dragged(state, Handle.LINE, np.array([0.3, 1.0]))
    stick = next(each for each in solved(moved) if each.mode == pp.ContactMode.STICK)
    assert np.arctan2(*stick.force[::-1]) == pytest.approx(np.arctan2(1.0, 0.3), abs=2e-3)


def test_a_line_of_force_stays_in_the_cone():
    state = with_law(preset("figure_02"), {"law": "coulomb", "friction_coefficient": 0.5})
    moved = dragged(state, Handle.LINE, np.array([1.0, -0.2]))
    edge = pp.friction_cone(state.scene).right
    assert np.deg2rad(moved.angle) == pytest.approx(pp.motion_angle(state.scene, edge))


def test_keys_turn_the_push_by_degrees():
    state = pushed(preset("figure_03"), 30.0, 1.0)
    assert nudged(state, Handle.PUSHER, None, 1, 0, False).angle == pytest.approx(29.0)
    assert nudged(state, Handle.PUSHER, None, -1, 0, True).angle == pytest.approx(40.0)
    longer = nudged(state, Handle.ROD, None, 0, 1, False)
    assert longer.file.slider.rod_length == pytest.approx(3.06)


def test_a_way_taken_by_hand_is_taken_from_its_time_on():
    state = replace(preset("figure_03"), time=0.3)
    before, hand = followed(state), taken(state, "slip-left")
    after = followed(hand)
    assert chosen(hand)
    early = before.log.sel(time=slice(0, 0.29)).rod_angle
    np.testing.assert_allclose(after.log.sel(time=slice(0, 0.29)).rod_angle, early, atol=1e-9)
    row = int(np.searchsorted(after.times, 0.31))
    assert after.log["mode"][row] == pp.ContactMode.SLIP_LEFT
    assert forgotten(hand) == state
    earlier = taken(replace(hand, time=0.2), "separate")
    assert [piece.time for piece in earlier.file.simulate.policies] == [0.0, 0.2]


def turned_finger():
    """A pull by a finger whose side has turned by the time."""
    return replace(simulated(preset("figure_03"), pusher_shape="finger"), time=0.3)


def in_motion():
    """A pull of a slider with inertia, which moves by the time."""
    return replace(preset("pulling_with_inertia"), time=0.25)


@pytest.mark.parametrize("state", [
    pytest.param(replace(preset("figure_03"), time=0.3), id="fence"),
    pytest.param(turned_finger(), id="finger"), pytest.param(in_motion(), id="inertia"),
])  # fmt: skip
def test_the_ways_on_are_those_that_are_consistent(state):
    motion = followed(state)
    row = row_at(motion, state.time)
    ways = ways_at(state, motion, state.time)
    assert len(ways) == motion.log["solutions"][row] == 3
    for way in ways:
        after = followed(taken(state, way))
        later = int(np.searchsorted(after.times, state.time + 1e-6))
        assert MODES[way] == after.log["mode"][later]


def test_the_ways_on_from_rest_are_the_solutions():
    state = replace(preset("pulling_with_inertia"), start=Start.ACCELERATION, time=0.0)
    modes = {each.mode for each in solved(state)}
    assert {MODES[way] for way in ways_at(state, followed(state), 0.0)} == modes


def test_one_way_on_is_no_choice():
    state = replace(preset("figure_08"), time=0.1)
    assert ways_at(state, followed(state), 0.1) == ()


def test_another_push_forgets_the_choices():
    hand = taken(replace(preset("figure_03"), time=0.3), "slip-left")
    assert not chosen(pushed(hand, 10.0, 1.0))
    assert not chosen(with_rod(hand, 2.0, 45.0))


@pytest.mark.parametrize("given", [
    {"angle": "up"},
    {"slider.rod_length": "2"},
    {"slider.rod_length": "-1", "slider.rod_angle": "45", "contact.law": "perfectly_rough",
     "effects": '[{"type":"ring_friction"}]'},
    {"nothing": "1"},
])  # fmt: skip
def test_a_wrong_address_is_refused_in_one_line(given):
    with pytest.raises(InvalidValue, match=r"^address: ") as refused:
        state_in(given)
    assert "\n" not in str(refused.value)
